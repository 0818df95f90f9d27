"""The room that a thing needs in front of it to be opened: what its doors, drawers and flaps sweep."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from robolayout._errors import AssetError
from robolayout.assets.joints import JOINTS, turned
from robolayout.assets.lexicon import category_of
from robolayout.assets.part import Joint, Part
from robolayout.scene import Asset


@dataclass(frozen=True, eq=False)
class Sweep:
    """What one joint needs, or what a record says that a thing needs where nothing of it moves."""

    # what is swept beyond the thing's front, in its frame (origin in the middle of its box, front along +x); metres
    region: BaseGeometry
    heights: tuple[float, float]  # between which heights, from the middle of its box; metres
    joint: Joint | None = None  # the joint; None where the room is that of a person at work
    # where the open leaf stands beyond the front; empty for drawers, which are pushed back to
    leaf: BaseGeometry = Polygon()  # noqa: RUF009 - polygons do not change


@lru_cache(maxsize=2048)
def sweeps_of(asset: Asset) -> tuple[Sweep, ...]:
    """Return what must be free before a thing that is to be opened or used from the front; nothing of others."""
    from robolayout.assets.meshes import parts

    deep = category_of(asset).open_depth
    if deep <= 0:
        return ()
    try:
        made = parts(asset)
    except AssetError:
        made = ()
    joints = dict.fromkeys(part.joint for part in made if part.joint is not None and part.joint.span[0] >= 0)
    found = [_sweep(joint, [part for part in made if part.joint == joint], asset) for joint in joints]
    slight = asset.size[0] / 2 + JOINTS.slight
    ahead = [sweep for sweep in found if not sweep.region.is_empty and sweep.region.bounds[2] > slight]
    depth, width, height = asset.size
    strip = shapely.box(depth / 2, -width / 2, depth / 2 + deep, width / 2)
    return tuple(ahead) or (Sweep(strip, (-height / 2, height / 2)),)


def _sweep(joint: Joint, moving: list[Part], asset: Asset) -> Sweep:
    """Return what some parts sweep beyond the front of their thing."""
    far = np.linspace(0.0, joint.span[1], JOINTS.steps + 1 if joint.kind == "hinge" else 2)
    places = [[turned(joint, part.vertices, step) for step in far.tolist()] for part in moving]
    hulls = [
        shapely.MultiPoint(np.concatenate(pair)[:, :2]).convex_hull for steps in places for pair in pairwise(steps)
    ]
    leaf = shapely.union_all([shapely.MultiPoint(steps[-1][:, :2]).convex_hull for steps in places])
    heights = np.concatenate([points[:, 2] for steps in places for points in steps])
    reach = 2 * sum(asset.size)
    front = shapely.box(asset.size[0] / 2, -reach, reach, reach)
    return Sweep(
        shapely.union_all(hulls).intersection(front),
        (heights.min().item(), heights.max().item()),
        joint,
        leaf.intersection(front) if joint.kind == "hinge" else Polygon(),
    )
