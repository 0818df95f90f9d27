"""Reads the rows in which a record says what of a thing moves, finds the parts that do, and what they sweep.

    door+handle: hinge z away front 90
    drawer+knob: slide x .6d
    seat+back: hinge z -180:180 together

The first part leads, the others go with the leader that they lie on; `together` makes all of them one. The words between
say on which edges of the leader a hinge lies (in the middle where none is named; `away` is the side away from its handle, or
from the thing's middle), the last how far it opens: degrees, metres (`.4m`), or a share of the thing's depth, width or height (`.6d`).
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from robolayout._errors import AssetError
from robolayout.assets.lexicon import category_of
from robolayout.assets.part import Joint, Part
from robolayout.scene import Asset

EDGES = {"back": (0, 0), "front": (0, 1), "right": (1, 0), "left": (1, 1), "bottom": (2, 0), "top": (2, 1)}
"""Axis of an edge, and whether it is the low (0) or the high (1) one."""
AWAY = "away"
USUAL = "door+handle: hinge z away front 90\ndrawer+handle+knob: slide x .6d"
"""How what is called door or drawer moves where a record says nothing of joints: side hung, and pulled out by the
three fifths of the depth that plain runners allow (judgement)."""
NOTHING = "-"  # what a record says whose parts look like doors but do not move


@dataclass(frozen=True)
class JointConfig:
    """How leaves hang, and what they sweep."""

    near: float = 0.05  # metres within which a part lies on the leader that it goes with
    play: float = 0.004  # metres that an open leaf's handle stays short of its thing's side: hinges give
    steps: int = 12
    """Places of a leaf between shut and open, whose hulls make its sweep: a sector of 90 degrees misses 0.1 % of
    its area."""
    slight: float = 0.02  # metres by which a sweep must reach beyond the front to need room there: a button does not


JOINTS = JointConfig()

HANDLES = ("handle", "knob", "grip", "lock")
"""Parts that a hand takes hold of; without one, the edge away from the hinge is held."""

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class JointRule:
    """One row: what moves how."""

    names: tuple[str, ...]  # names of parts; the first leads
    kind: str  # "hinge" or "slide"
    axis: int  # number of the axis
    sign: float  # -1 for a slide against the axis
    edges: tuple[str, ...]  # where a hinge lies
    span: tuple[float, float]  # how far it goes
    unit: str  # of both ends: "", "m", "d", "w" or "h"
    together: bool  # whether all parts of these names move as one


@lru_cache(maxsize=512)
def read_joints(text: str) -> tuple[JointRule, ...]:
    """Read a record's `joints` (empty: what is usual)."""
    if text.strip() == NOTHING:
        return ()
    return tuple(_rule(line) for line in (text.strip() or USUAL).splitlines())


def _rule(line: str) -> JointRule:
    """Read one row; only the package's own records have any, so nothing wrong is explained."""
    names, rest = line.split(": ")
    words = rest.split()
    kind, axis, *edges, far = (word for word in words if word != "together")
    low, high = f"0:{far}".split(":")[-2:]
    span, unit = (float(low.rstrip("mdwh")), float(high.rstrip("mdwh"))), high.lstrip("-.0123456789")
    sign = -1.0 if axis.startswith("-") else 1.0
    return JointRule(
        tuple(names.split("+")), kind, "xyz".index(axis[-1]), sign, tuple(edges), span, unit, "together" in words
    )


def jointed(
    built: tuple[Part, ...], rules: tuple[JointRule, ...], size: tuple[float, float, float]
) -> tuple[Part, ...]:
    """Return parts that know with what joint they move."""
    out = list(built)
    for rule, group in _groups(built, rules):
        joint = _joint(rule, [built[i] for i in group], size)
        for i in group:
            out[i] = replace(out[i], joint=joint)
    number, names = Counter[str](), dict[int, Joint]()
    for joint in (part.joint for part in out):
        if joint is not None and id(joint) not in names:
            names[id(joint)] = replace(joint, name=f"{joint.name} {number[joint.name]}")
            number[joint.name] += 1
    return tuple(replace(part, joint=names.get(id(part.joint))) for part in out)


def _groups(built: Sequence[Part], rules: Sequence[JointRule]) -> Iterator[tuple[JointRule, list[int]]]:
    """Yield which parts move together, the leader first."""
    leaders = [(r, [i]) for r in rules if not r.together for i, p in enumerate(built) if p.name == r.names[0]]
    taken = {group[0] for _, group in leaders}
    for i, part in enumerate(built):
        if i in taken:
            continue
        near: list[tuple[float, int]] = []  # metres from the part's middle to the box of a leader
        for n, (rule, group) in enumerate(leaders):
            if part.name in rule.names:
                middle, (low, high) = part.ends.mean(axis=0), built[group[0]].ends
                apart = np.linalg.norm(np.maximum(low - middle, 0.0) + np.maximum(middle - high, 0.0))
                near.append((float(apart), n))
        if near and min(near)[0] < JOINTS.near:
            leaders[min(near)[1]][1].append(i)
    yield from leaders
    for rule in rules:
        found = [i for i, part in enumerate(built) if part.name in rule.names]
        if rule.together and found:
            yield rule, found


def _joint(rule: JointRule, group: Sequence[Part], size: tuple[float, float, float]) -> Joint:
    """Return how some parts move; a hinge opens towards the front or upwards."""
    points = np.concatenate([part.vertices for part in (group if rule.together else group[:1])])
    ends = np.stack([points.min(axis=0), points.max(axis=0)])
    at = np.zeros(3) if rule.together else ends.mean(axis=0)
    handle = next((part for part in group if part.name in HANDLES), None)
    grip = None if handle is None else handle.vertices.mean(axis=0)
    heights = points[:, 2] if handle is None else handle.vertices[:, 2]
    for edge in rule.edges:
        axis, high = EDGES[edge] if edge != AWAY else (1, int(at[1] > (0.0 if grip is None else grip[1])))
        at[axis] = ends[high, axis]
    along = np.eye(3)[rule.axis] * rule.sign
    if rule.kind == "hinge" and np.cross(along, ends.mean(axis=0) - at) @ [1.0, 0.0, 1.0] < 0:
        along = -along
    if grip is None:
        middle = ends.mean(axis=0)
        grip = middle + np.abs(along) * (ends[1] - middle) if rule.kind == "slide" else 2 * middle - at
        grip[rule.axis] = middle[rule.axis] if rule.kind == "hinge" else grip[rule.axis]
    units = {"": math.pi / 180 if rule.kind == "hinge" else 1.0, "m": 1.0, **dict(zip("dwh", size, strict=True))}
    low, high = (value * units[rule.unit] for value in rule.span)
    if rule.axis == 2 and {"left", "right", AWAY} & {*rule.edges}:
        high = min(high, _stop(np.concatenate([part.vertices for part in group]), at, size[1] / 2))
    x, y, z = at.tolist()
    u, v, w = (along + 0.0).tolist()
    a, b, c = grip.tolist()
    hold = (heights.min().item(), heights.max().item())
    return Joint(rule.names[0], rule.kind, (u, v, w), (x, y, z), (low, high), (a, b, c), hold)


def _stop(points: Vector, at: Vector, side: float) -> float:
    """Return by how much a side-hung leaf turns until its handle is as far out as its thing's side, where a wall may be (rad)."""
    ahead, inward = points[:, 0] - at[0], np.abs(at[1] - points[:, 1])
    beside = max(0.0, side - abs(at[1]) - JOINTS.play) / np.maximum(np.hypot(ahead, inward), 1e-9)
    return float((math.pi / 2 + np.arcsin(np.minimum(beside, 1.0)) - np.arctan2(ahead, inward)).min())


def turned(joint: Joint, points: Vector, far: float) -> Vector:
    """Return points (n, 3) of what moves where its joint is turned or drawn `far` from where it is now (rad or m)."""
    axis = np.array(joint.axis)
    if joint.kind == "slide":
        return points + far * axis
    c, s = math.cos(far), math.sin(far)
    r = points - joint.at
    return c * r + s * np.cross(axis, r) + (1 - c) * (r @ axis)[:, None] * axis + joint.at


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
