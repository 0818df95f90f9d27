"""What an exporter is: one file format, one entry, pure functions from a scene and a layout to bytes and back."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from robolayout._errors import LayoutError
from robolayout.assets import category_of
from robolayout.scene import Agent, Asset, Layout, Point, Pose, Scene

Routes = Mapping[str, Sequence[Point]]
"""The polyline in metres that the agent's centre follows to each asset, by asset name."""

ANGLE_DIGITS = 12
"""Decimals kept where a yaw goes through degrees; far below the 1e-6 that every file must keep."""


@dataclass(frozen=True)
class Options:
    """What may go into a file beside the scene and the layout.

    Attributes:
        agent: The body whose base is added where the format can hold one (MJCF); None leaves it out.
        routes: Routes of that agent, kept as metadata or lines where the format has a place.
        seed: Seed of the parametric meshes.
    """

    agent: Agent | None = None
    routes: Routes = field(default_factory=dict[str, Sequence[Point]])
    seed: int = 0


@dataclass(frozen=True)
class Contents:
    """What a written file says about the assets.

    Attributes:
        layout: Poses by asset name.
        sizes: Box sizes (depth, width, height) in metres by asset name; empty where the format has no place for them.
    """

    layout: Layout
    sizes: Mapping[str, tuple[float, float, float]] = field(default_factory=dict[str, tuple[float, float, float]])


@dataclass(frozen=True)
class Exporter:
    """One file format.

    Attributes:
        name: What people ask for ("glb").
        suffix: End of the file's name, by which the format is recognised (".glb").
        summary: One line for the table of formats.
        extra: The optional dependency it needs; None for none.
        write: The file's content for a scene, a layout and options.
        read: Reads such content back; None where the format cannot say where things are.
    """

    name: str
    suffix: str
    summary: str
    extra: str | None
    write: Callable[[Scene, Layout, Options], bytes]
    read: Callable[[bytes], Contents] | None = None


def placed(scene: Scene, layout: Layout) -> tuple[tuple[Asset, Pose], ...]:
    """Return every asset that has a pose, with it, in the order of the scene."""
    return tuple((asset, layout[asset.name]) for asset in scene.assets if asset.name in layout)


def check_layout(scene: Scene, layout: Layout, *, partial: bool = False) -> None:
    """Check that a layout fits its scene before anything is written.

    Raises:
        LayoutError: It names an asset that the scene does not have, lacks one (unless `partial`), or holds a pose
            that is no finite number.
    """
    unknown = sorted(set(layout) - set(scene.by_name))
    if unknown:
        known = ", ".join(sorted(scene.by_name)) or "none"
        raise LayoutError(
            f"the layout places {unknown[0]!r}, which scene {scene.name!r} does not have. Known: {known}."
        )
    missing = [asset.name for asset in scene.assets if asset.name not in layout]
    if missing and not partial:
        raise LayoutError(
            f"the layout has no pose for {', '.join(map(repr, missing[:5]))} ({len(missing)} of {len(scene.assets)} "
            "assets); place them first, or export with partial=True to leave them out."
        )
    for name, pose in layout.items():
        if not all(map(math.isfinite, (pose.x, pose.y, pose.z, pose.yaw))):
            raise LayoutError(
                f"the pose of {name!r} is not finite: {pose}; every coordinate must be a number in metres."
            )


def is_movable(asset: Asset) -> bool:
    """Return whether an asset may be pushed around: a movable category that stands on the floor or on another asset."""
    hangs = (asset.on_wall or asset.on_ceiling) and not (asset.on_floor or asset.on_object)
    return not hangs and not asset.is_flat and category_of(asset).movable


def facts(asset: Asset) -> dict[str, object]:
    """Return what a file says about an asset beside its pose and shape."""
    return {
        "name": asset.name,
        "category": asset.category,
        "description": asset.description,
        "size": list(asset.size),
        "movable": is_movable(asset),
    }
