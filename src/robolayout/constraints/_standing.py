"""What things stand on where they are, and which hang on walls or from the ceiling."""

from __future__ import annotations

from robolayout.constraints._exact import TOLERANCE
from robolayout.scene import Asset, Layout, Pose, Scene, vertical_span


def hangs(asset: Asset, scene: Scene, layout: Layout) -> bool:
    """Return whether an asset is fixed to a wall or the ceiling: it may be, and stands on nothing where it is."""
    if not (asset.on_wall or asset.on_ceiling):
        return False
    bottom, _ = vertical_span(asset, layout[asset.name])
    return bottom > TOLERANCE.support and supporter(asset, scene, layout) is None


def supporter(asset: Asset, scene: Scene, layout: Layout) -> str | None:
    """Return the name of the asset that another one rests on, or None.

    Its bottom is as high as the other's top, and its centre over the other's footprint (DESIGN section 4); of several, it
    is the one whose top is nearest.
    """
    pose = layout[asset.name]
    bottom, _ = vertical_span(asset, pose)
    found: list[tuple[float, str]] = []
    for other in (one for one in scene.assets if one.name in layout):
        place = layout[other.name]
        gap = abs(bottom - vertical_span(other, place)[1])
        if other.name != asset.name and gap <= TOLERANCE.support and covers(place, other, pose):
            found.append((gap, other.name))
    return min(found)[1] if found and asset.on_object else None


def covers(place: Pose, other: Asset, pose: Pose) -> bool:
    """Return whether the centre of `pose` is over the footprint of `other` at `place`."""
    ahead, left = place.seen(pose.at)
    return abs(ahead) <= other.size[0] / 2 and abs(left) <= other.size[1] / 2
