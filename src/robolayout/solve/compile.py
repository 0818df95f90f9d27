"""Scene and program to a problem: who stands on what, at which height, and which rows apply.

Things on tops are solved after what carries them, in their carrier's frame: a first stage places everything that stands on
the floor, hangs at walls or from the ceiling; each further stage places what stands on things of the stage before.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from shapely import Point

from robolayout._reading import whole
from robolayout.assets import Surface, place_of, resting_place, surfaces_of
from robolayout.constraints import AssetRef, FrameTerm, MirrorTerm, Relation, Term, WallRef, implicit_terms
from robolayout.constraints.above import Above
from robolayout.constraints.against_wall import wall_term
from robolayout.constraints.behind import Behind
from robolayout.constraints.in_front_of import InFrontOf
from robolayout.constraints.mounted_on import EYE_HEIGHT, MountedOn
from robolayout.constraints.next_to import NextTo
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.symmetric_pair import SymmetricPair
from robolayout.floor import RoomContents
from robolayout.program import Guess, Program
from robolayout.scene import ROUNDING, Asset, Layout, Pose, Scene
from robolayout.solve.build import furnished

Floats = NDArray[np.float64]

DEEPEST = 8
"""Things that may stand on one another."""

LEVEL = 0.02
"""Metres between the bottom of a guess and the top of another one on which it then stands."""

TURN = 0.3
"""Metres that a thing could be moved for what it means to turn it by a radian."""


TOGETHER = NextTo | InFrontOf | Behind | SymmetricPair
"""Relations that keep two things together."""

WISHED = 0.2
"""Weight in the search of a wish against that of a statement."""


@dataclass(frozen=True)
class Problem:
    """A scene with a program, ready to be solved."""

    scene: Scene
    relations: tuple[Relation, ...]  # the statements to satisfy, in program order
    guess: Layout  # A first pose for every asset
    parent: tuple[int, ...]  # index of what carries each asset; -1 where it is the room
    stage: tuple[int, ...]  # stage in which each asset is placed
    pinned: frozenset[str] = frozenset()  # names of assets that keep the pose of the guess
    guessed: tuple[str, ...] = ()  # names of assets to which the program itself gave a place
    # the surface of its carrier on which each asset stands; None where it is the room
    resting: tuple[Surface | None, ...] = ()
    wishes: tuple[Relation, ...] = ()  # what keeps things together though nothing demands it: a lamp at its armchair

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Asset names in slot order."""
        return tuple(asset.name for asset in self.scene.assets)

    @cached_property
    def slot(self) -> dict[str, int]:
        """Slot of each asset."""
        return {name: i for i, name in enumerate(self.names)}

    @cached_property
    def half(self) -> Floats:
        """(n, 2) half depth and half width in metres."""
        return np.array([asset.size[:2] for asset in self.scene.assets]).reshape(-1, 2) / 2

    @cached_property
    def heights(self) -> Floats:
        """(n,) height of each box's centre in metres."""
        return np.array([self.guess[name].z for name in self.names])

    @cached_property
    def contents(self) -> RoomContents:
        """What the room holds, for the floor that it leaves to bodies."""
        return RoomContents(self.scene, self.parent, self.heights, self.half)

    @cached_property
    def statement_terms(self) -> tuple[Term, ...]:
        """Rows of all statements, and at less weight of the wishes that keep things together."""
        said = (row for one in self.relations for row in one.terms(self.scene, self.guess))
        wished = (row for one in self.wishes for row in one.terms(self.scene, self.guess))
        weighed = (row for row in wished if isinstance(row, FrameTerm | MirrorTerm))
        return (*said, *(replace(row, weight=WISHED * row.weight) for row in weighed))

    @cached_property
    def pairs(self) -> tuple[tuple[int, int, FrameTerm], ...]:
        """Rows of statements about two things, after the slots of these."""
        return tuple(
            (self.slot[row.a.name], self.slot[row.b.name], row)
            for row in self.statement_terms
            if isinstance(row, FrameTerm) and isinstance(row.a, AssetRef) and isinstance(row.b, AssetRef)
        )

    @cached_property
    def implicit_terms(self) -> tuple[Term, ...]:
        """Rows of what belongs to every program."""
        return implicit_terms(self.scene, self.guess)

    @cached_property
    def wall_terms(self) -> tuple[FrameTerm, ...]:
        """Rows that hold wall things, which no statement puts on a wall, at the wall of what they hang above, or nearest to their guess."""
        rows = [row for row in self.statement_terms if isinstance(row, FrameTerm) and isinstance(row.b, WallRef)]
        held = {row.a for row in rows}
        backed = {row.a: row.b for row in rows if isinstance(row.b, WallRef) and row.heading is not None}
        over = {one.a: backed[one.b] for one in self.relations if isinstance(one, Above) and one.b in backed}
        found: list[FrameTerm] = []
        for asset, carrier in zip(self.scene.assets, self.parent, strict=True):
            ref, at = AssetRef(asset.name), self.guess[asset.name].at
            if asset.on_wall and not asset.on_floor and carrier < 0 and ref not in held:
                wide = [wall for wall in self.scene.room.walls if wall.length >= asset.size[1]] or self.scene.room.walls
                nearest = min(wide, key=lambda wall: wall.distance(at))
                found.append(wall_term(ref, over.get(ref, WallRef(nearest.index)), self.scene, 2.0))
        return tuple(found)

    def movable(self, number: int) -> tuple[int, ...]:
        """Return the slots that a stage places."""
        return tuple(i for i, name in enumerate(self.names) if self.stage[i] == number and name not in self.pinned)

    @cached_property
    def start(self) -> Floats:
        """(n, 4) the guess as (x, y, cos, sin)."""
        poses = (self.guess[name] for name in self.names)
        return np.array([(p.x, p.y, math.cos(p.yaw), math.sin(p.yaw)) for p in poses]).reshape(-1, 4)

    def moved(self, world: Floats) -> float:
        """Return how far the things that the program places are from there: metres, and `TURN` for each radian."""
        return self._off(world, [self.slot[name] for name in self.guessed])

    def away(self, world: Floats) -> float:
        """Return the same of all things: how far they are from their guesses, or from where the room was built."""
        return self._off(world, [*self.slot.values()])

    def _off(self, world: Floats, slots: Sequence[int]) -> float:
        off = world[slots] - self.start[slots]
        turned = 2.0 * np.arcsin(np.minimum(np.hypot(*off[:, 2:].T) / 2.0, 1.0))
        return float(np.hypot(*off[:, :2].T).sum() + TURN * turned.sum())

    def layout(self, world: Floats) -> Layout:
        """Return world poses (n, 4) as a layout; what is pinned keeps its pose to the last bit."""
        poses = {
            name: Pose(float(x), float(y), float(z), math.atan2(s, c))
            for name, (x, y, c, s), z in zip(self.names, world.tolist(), self.heights, strict=True)
        }
        return Layout(poses | {name: self.guess[name] for name in self.pinned})


def compile_problem(
    scene: Scene,
    program: Program | None = None,
    *,
    seed: int = 0,
    pinned: Mapping[str, Pose] | None = None,
    built: Layout | None = None,
    attempts: int | None = None,
) -> Problem:
    """Return the problem of placing a scene's assets by a program.

    Args:
        scene: The scene.
        program: Guesses and statements, already filtered; None has neither.
        seed: Settles where things are built that the program does not place.
        pinned: Poses that must stay.
        built: Poses of such things, where they are known.
        attempts: How many times a room is built at the most; as many as it takes if None.
    """
    whole(seed, "seed")
    program, pinned = program or Program(), dict(pinned or {})
    relations = tuple(statement.relation for statement in program.statements)
    wishes = tuple(one.relation for one in program.wishes if isinstance(one.relation, TOGETHER))
    guesses = ((asset.name, program.guesses.get(asset.name, Guess())) for asset in scene.assets)
    said = {name: Pose(*guess.position, guess.yaw or 0.0) for name, guess in guesses if guess.position is not None}
    if built is None:
        x0, y0, x1, y1 = scene.room.bounds
        built = Layout({name: p for name, p in said.items() if x0 < p.x < x1 and y0 < p.y < y1} | pinned)
        if len(said.keys() | pinned.keys()) < len(scene.assets):
            built = furnished(scene, program, built, seed, attempts)
    poses = {**built, **said}
    parents = _parents(scene, relations, poses, said)
    held = (r for r in relations if isinstance(r, OnTopOf) and parents.get(r.a.name) == r.b.name)
    on = {r.a.name: r.place(scene, Layout(poses)) for r in held}
    usual = {a: resting_place(scene.by_name[b], scene.by_name[a]) for a, b in parents.items() if a not in on}
    resting = on | usual
    heights = _heights(scene, relations, poses, parents, resting)
    index = {asset.name: i for i, asset in enumerate(scene.assets)}
    return Problem(
        scene,
        relations,
        Layout({name: replace(poses[name], z=heights[name]) for name in index} | pinned),
        tuple(index.get(parents.get(name, ""), -1) for name in index),
        tuple(_depth(name, parents) for name in index),
        frozenset(pinned),
        tuple(said),
        tuple(map(resting.get, index)),
        wishes,
    )


def _depth(name: str, parents: Mapping[str, str]) -> int:
    depth = 0
    while name in parents:
        name, depth = parents[name], depth + 1
    return depth


def _parents(
    scene: Scene, relations: Iterable[Relation], poses: Mapping[str, Pose], said: Mapping[str, Pose]
) -> dict[str, str]:
    """Return what each asset stands on: as the program says, else what its guess lies on, else the nearest top that holds it."""
    parents: dict[str, str] = {}
    for on in relations:
        if isinstance(on, OnTopOf) and _depth(on.b.name, parents) < DEEPEST:
            parents.setdefault(on.a.name, on.b.name)
    for name, pose in said.items():
        asset = scene.by_name[name]
        bottom = pose.z - asset.size[2] / 2
        if name not in parents and bottom > LEVEL and (asset.on_floor or asset.on_object):
            free = ((other, under) for other, under in said.items() if other not in parents and other != name)
            lower = [other for other, under in free if _lies_on(pose, bottom, scene.by_name[other], under)]
            if lower:
                parents[name] = lower[0]
    for asset in scene.assets:
        if place_of(asset) == "object" and asset.name not in parents:
            carriers = [other for other in scene.assets if carries(other, asset) and other.name not in parents]
            best = min(carriers, key=lambda o: carrier_rank(poses[asset.name], o, poses[o.name]), default=None)
            if best:
                parents[asset.name] = best.name
    return parents


def _lies_on(pose: Pose, bottom: float, lower: Asset, under: Pose) -> bool:
    """Return whether a thing's centre is over a surface of another, its bottom at that height."""
    size, at = lower.size, Point(under.seen(pose.at))
    if abs(at.x) > size[0] / 2 or abs(at.y) > size[1] / 2 or bottom > under.z + size[2] / 2 + LEVEL:
        return False
    heights = [size[2], *(top.height for top in surfaces_of(lower) if top.region.intersects(at))]
    return min(abs(under.z - size[2] / 2 + height - bottom) for height in heights) <= LEVEL


def carrier_rank(pose: Pose, carrier: Asset, under: Pose) -> tuple[bool, float, float, str]:
    """Return by what of several carriers the least is best: whether people sit on it, metres to its rectangle, to its middle; its name."""
    (u, v), (hx, hy) = under.seen(pose.at), (carrier.size[0] / 2, carrier.size[1] / 2)
    beside = math.hypot(max(abs(u) - hx, 0.0), max(abs(v) - hy, 0.0))
    return any(top.is_seat for top in surfaces_of(carrier)), beside, math.hypot(u, v), carrier.name


def carries(carrier: Asset, asset: Asset) -> bool:
    """Return whether an asset's footprint fits on another's top, at a height where things are put."""
    small, large = sorted(asset.size[:2]), sorted(carrier.size[:2])
    fits = small[0] <= large[0] and small[1] <= large[1]
    return fits and carrier.on_floor and 0.25 <= carrier.size[2] <= 1.3 and carrier.name != asset.name


def _heights(
    scene: Scene,
    relations: Iterable[Relation],
    poses: Mapping[str, Pose],
    parents: Mapping[str, str],
    resting: Mapping[str, Surface],
) -> dict[str, float]:
    """Return the height of every box centre: on the floor, on its carrier, on the wall or at the ceiling."""
    mounted = {r.a.name: r.height for r in relations if isinstance(r, MountedOn) and r.height is not None}
    found: dict[str, float] = {}
    for asset in sorted(scene.assets, key=lambda asset: _depth(asset.name, parents)):
        name, half, ceiling = asset.name, asset.size[2] / 2, scene.room.wall_height
        if name in parents:
            carrier = scene.by_name[parents[name]]
            found[name] = found[carrier.name] - carrier.size[2] / 2 + resting[name].height + half
        elif asset.on_floor or not (asset.on_ceiling or asset.on_wall):
            found[name] = half
        elif asset.on_ceiling:
            found[name] = ceiling - half
        else:
            wanted = mounted.get(name, poses[name].z if poses[name].z >= half - ROUNDING else EYE_HEIGHT)
            found[name] = min(max(wanted, half), ceiling - half)
    return found
