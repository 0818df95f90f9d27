"""One stage of a problem as padded arrays.

Sizes are rounded up to a few buckets, so that one compiled search serves every room of its bucket.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.assets import Prism
from robolayout.assets.prisms import PRISMS
from robolayout.constraints import (
    AssetRef,
    ClearTerm,
    FrameTerm,
    InsideTerm,
    Interval,
    MirrorTerm,
    OverlapTerm,
    PointRef,
    Ref,
    Term,
    WallRef,
)
from robolayout.constraints.corner import convex_corners
from robolayout.scene import Layout, Pose, Scene, vertical_span
from robolayout.solve.arrays import Arrays, Routes
from robolayout.solve.compile import Floats, Problem, compile_problem

SLOT_BUCKETS = (8, 16, 32, 64, 128, 256, 512)
EDGE_BUCKETS = (8, 32, 128)
STAY = 0.03
"""Weight of staying where the program first put a thing, so that what no statement holds does not drift."""

SOFT_CLEAR = 0.2
"""Weight of a strip that should stay free against one that must."""

CLEAR_BUCKET = 16
"""Clear boxes that every problem has room for; no room of the examples has more."""

MIRROR_BUCKET = 8
"""Mirror rows that every problem has room for."""

FAR_AWAY = 1.0e4
"""Metres at which padded things lie."""


@dataclass(frozen=True)
class Stage:
    """One stage: its arrays and which slots it moves."""

    problem: Problem
    number: int  # 0 for what stands in the room, 1 for what stands on that, and so on
    arrays: Arrays  # padded arrays
    world: Floats  # (n, 4) poses in the room that everything outside the stage has
    moving: tuple[int, ...]  # slots that move

    @property
    def slots(self) -> int:
        """Number of slots, padding included."""
        return self.arrays.half.shape[0]

    def at(self, world: Floats) -> Stage:
        """Return the same stage where everything outside it has other poses (n, 4)."""
        anchor, carrier, limit = (_typed(field) for field in _frames(self.problem, self.number, world, self.slots))
        return replace(self, arrays=self.arrays._replace(anchor=anchor, carrier=carrier, limit=limit), world=world)

    def local(self, world: Floats) -> Floats:
        """Return world poses (..., n, 4) as padded variables (..., A, 4)."""
        count = len(self.problem.names)
        batch = world.shape[:-2]
        padded = np.zeros((*batch, self.slots, 4))
        padded[..., 2] = 1.0
        padded[..., :count, :] = world
        carriers = np.maximum(self.arrays.carrier, 0)
        outer = np.where((self.arrays.carrier >= 0)[:, None], padded[..., carriers, :], self.arrays.anchor)
        return relative(outer, padded)


def relative(outer: Floats, pose: Floats) -> Floats:
    """Return poses (..., 4) as seen from `outer`."""
    dx, dy = pose[..., 0] - outer[..., 0], pose[..., 1] - outer[..., 1]
    c, s = outer[..., 2], outer[..., 3]
    turned = (c * pose[..., 2] + s * pose[..., 3], c * pose[..., 3] - s * pose[..., 2])
    return np.stack([c * dx + s * dy, c * dy - s * dx, *turned], axis=-1)


def bucket(count: int, sizes: Sequence[int]) -> int:
    """Return the smallest size that holds `count`, doubling past the last one."""
    for size in sizes:
        if count <= size:
            return size
    return 2 ** math.ceil(math.log2(count))


def stages(problem: Problem) -> range:
    """Return the numbers of all stages."""
    return range(max(problem.stage, default=0) + 1)


def make_stage(problem: Problem, number: int, world: Floats) -> Stage:
    """Return one stage of a problem; what is outside it keeps its world poses (n, 4)."""
    count = len(problem.names)
    moving = problem.movable(number)
    rows = _Rows(problem, set(moving))
    size = rows.size
    anchor, carrier, limit = _frames(problem, number, world, size)
    free = np.zeros((size, 3))
    free[list(moving)] = 1.0
    free[list(set(moving) - _turning(problem)), 2] = 0.0
    half = np.zeros((size, 2))
    half[:count] = problem.half
    inside = np.zeros(size)
    inside[[i for i in rows.inside if not _held(problem, i)]] = 1.0
    every = size * (size - 1) // 2
    tables = {
        **rows.prisms(),
        **rows.frames(rows.framed, bucket(len(rows.framed), (3 * size, 16 * size))),
        **rows.mirrors(rows.mirrored, bucket(len(rows.mirrored), (MIRROR_BUCKET, 4 * size))),
        **rows.clears(),
    }
    arrays = Arrays(
        half=half,
        anchor=anchor,
        carrier=carrier,
        limit=limit,
        free=free,
        fixed=rows.fixed_bodies(),  # now that all rows have named their points
        pairs=padded(rows.pairs, bucket(len(rows.pairs), (4 * every, 16 * every)), [0, 0], np.int32),
        edges=_edges(problem),
        inner=_inner_corners(problem),
        inside=inside,
        **tables,
    )
    return Stage(problem, number, Arrays(*(_typed(field) for field in arrays)), world, moving)


def sizes_of(scene: Scene) -> Stage:
    """Return the first stage of a scene with everything in its middle, for the sizes of its arrays: nothing is built."""
    x0, y0, x1, y1 = scene.room.bounds
    middle = Pose((x0 + x1) / 2, (y0 + y1) / 2, 0.0, 0.0)
    problem = compile_problem(scene, built=Layout(dict.fromkeys((asset.name for asset in scene.assets), middle)))
    return make_stage(problem, 0, problem.start)


def _held(problem: Problem, slot: int) -> bool:
    """Return whether the rectangle around the room keeps a slot in it, whichever way it faces."""
    room = problem.scene.room
    x0, y0, x1, y1 = room.bounds
    return room.fills_bounds and 2 * float(np.hypot(*problem.half[slot])) <= min(x1 - x0, y1 - y0)


def _typed(value: NDArray[np.generic]) -> NDArray[np.generic]:
    return value.astype(np.int32 if value.dtype.kind in "iu" else np.float32)


def no_routes(starts: int, size: int) -> Routes:
    """Return routes that ask for nothing."""
    return Routes(
        np.full((starts, size, 2), FAR_AWAY, np.float32),
        np.zeros((starts, size), np.int32),
        np.full((starts, size), -FAR_AWAY, np.float32),
    )


def padded(rows: Sequence[Any], size: int, filler: Any, kind: type = np.float64) -> NDArray[Any]:
    """Return rows as an array of `size` rows."""
    table = np.full((size, *np.shape(filler)), filler, dtype=kind)
    if rows:
        table[: len(rows)] = rows
    return table


def _turning(problem: Problem) -> set[int]:
    """Return the slots that gradients turn: of a room without guesses, which is built square, only what has to look at something."""
    if problem.guessed:
        return set(range(len(problem.names)))
    rows = (row for row in problem.statement_terms if isinstance(row, FrameTerm) and row.look is not None)
    return {problem.slot[row.a.name] for row in rows if isinstance(row.a, AssetRef)}


def _frames(problem: Problem, number: int, world: Floats, size: int) -> tuple[Floats, NDArray[np.int32], Floats]:
    """Return anchors, carriers and limits of all slots."""
    x0, y0, x1, y1 = problem.scene.room.bounds
    anchor = np.tile(np.array([(x0 + x1) / 2, (y0 + y1) / 2, 1.0, 0.0]), (size, 1))
    limit = np.tile(np.array([(x1 - x0) / 2, (y1 - y0) / 2]), (size, 1))
    carrier = np.full(size, -1, dtype=np.int32)
    for i, parent in enumerate(problem.parent):
        if parent < 0:
            continue
        if problem.stage[i] > number:
            while problem.stage[parent] > number:
                parent = problem.parent[parent]
            carrier[i] = parent
        else:
            anchor[i], limit[i] = _on_top(problem, i, world[parent])
    return anchor, carrier, limit


def _on_top(problem: Problem, slot: int, carrier: Floats) -> tuple[Floats, Floats]:
    """Return the middle (x, y, cos, sin) and the half sizes of what a slot may take of the surface on which it stands."""
    place, whole = problem.resting[slot], problem.half[problem.parent[slot]]
    x0, y0, x1, y1 = place.rectangle if place else (*-whole, *whole)
    c, s = carrier[2:]
    u, v = (x0 + x1) / 2, (y0 + y1) / 2
    half = np.array([x1 - x0, y1 - y0]) / 2
    return carrier + np.array([c * u - s * v, s * u + c * v, 0.0, 0.0]), np.maximum(half, problem.half[slot].min())


def _edges(problem: Problem) -> Floats:
    ring = [(*wall.start, *wall.end) for wall in problem.scene.room.walls]
    return padded(ring, bucket(len(ring), EDGE_BUCKETS), [*ring[0][:2], *ring[0][:2]])


def _inner_corners(problem: Problem) -> Floats:
    room = problem.scene.room
    inner = sorted(set(range(len(room.vertices))) - set(convex_corners(room)))
    return padded([room.vertices[i] for i in inner], bucket(len(inner), EDGE_BUCKETS), [FAR_AWAY, FAR_AWAY])


def _stay_terms(problem: Problem) -> Iterable[Term]:
    """Yield weak rows that hold things where the program first put them, in the room or on their carrier."""
    for name in problem.guessed:
        slot = problem.slot[name]
        me, carrier = AssetRef(name), problem.parent[slot]
        if carrier < 0:
            pose = problem.guess[name]
            yield FrameTerm(me, PointRef(pose.x, pose.y), distance=(0.0, 0.0), heading=pose.yaw, weight=STAY)
        else:
            u, v = (float(value) for value in relative(problem.start[carrier], problem.start[slot])[:2])
            top = AssetRef(problem.names[carrier])
            yield FrameTerm(me, top, along=Interval(u, u), across=Interval(v, v), weight=STAY)


class Bodies:
    """Numbers everything that a row may be about: slots, then walls, then fixed points; lists rows by these numbers."""

    def __init__(self, problem: Problem) -> None:
        self.problem, self.size = problem, bucket(len(problem.names), SLOT_BUCKETS)
        walls = problem.scene.room.walls
        self._fixed: list[list[float]] = [[*w.midpoint, *w.direction, w.length / 2, 0.0, w.length / 2] for w in walls]

    def index(self, ref: Ref) -> int:
        """Return the number of what a row is about."""
        if isinstance(ref, AssetRef):
            return self.problem.slot[ref.name]
        if isinstance(ref, WallRef):
            return self.size + ref.index
        self._fixed.append([ref.x, ref.y, math.cos(ref.yaw), math.sin(ref.yaw), 0.0, 0.0, 0.0])
        return self.size + len(self._fixed) - 1

    def frames(self, terms: Sequence[FrameTerm], count: int) -> dict[str, NDArray[Any]]:
        """Return frame rows as arrays of `count` rows."""
        index = [[self.index(term.a), self.index(term.b)] for term in terms]
        idle = FrameTerm(WallRef(0), WallRef(0), weight=0.0).row()
        return {
            "frame_index": padded(index, count, [self.size] * 2, np.int32),
            "frame_row": padded([term.row() for term in terms], count, idle),
        }

    def mirrors(self, terms: Sequence[MirrorTerm], count: int) -> dict[str, NDArray[Any]]:
        """Return mirror rows as arrays of `count` rows."""
        index = [[self.index(ref) for ref in (term.a, term.b, term.ref)] for term in terms]
        return {
            "mirror_index": padded(index, count, [self.size] * 3, np.int32),
            "mirror_weight": padded([term.weight for term in terms], count, 0.0),
            "mirror_normal": padded([float(isinstance(term.ref, WallRef)) for term in terms], count, 0.0),
        }

    def fixed_bodies(self) -> Floats:
        """Return walls and the points of all rows so far."""
        count = bucket(len(self._fixed), (2 * self.size, 4 * self.size))
        return padded(self._fixed, count, [FAR_AWAY, FAR_AWAY, 1, 0, 0, 0, 0])


class _Rows(Bodies):
    """Collects the rows of a stage's kernels."""

    def __init__(self, problem: Problem, moving: set[int]) -> None:
        super().__init__(problem)
        self.moving = moving
        self.number = max((problem.stage[i] for i in moving), default=0)
        self.pairs: list[list[int]] = []
        self.prism: dict[tuple[int, Prism], int] = {}
        self.inside: set[int] = set()
        self.framed: list[FrameTerm] = []
        self.mirrored: list[MirrorTerm] = []
        self.clear: list[ClearTerm] = []
        implied, said = problem.implicit_terms, problem.statement_terms
        for term in (*implied, *said, *problem.wall_terms, *_stay_terms(problem)):
            self._collect(term)

    def _collect(self, term: Term) -> None:
        """Sort a row that concerns a moving slot to its kernel."""
        slot = self.problem.slot
        if isinstance(term, OverlapTerm):
            pair = [slot[term.a.name], slot[term.b.name]]
            if self._at_hand(pair) and self.moving & set(pair) and not self._carried(*pair):
                prisms = zip(pair, (term.first, term.second), strict=True)
                self.pairs.append([self.prism.setdefault(key, len(self.prism)) for key in prisms])
        elif isinstance(term, InsideTerm):
            self.inside |= {slot[term.a.name]} & self.moving
        elif isinstance(term, ClearTerm):
            self.clear.append(term)
        elif isinstance(term, FrameTerm):
            if self._moves({"a": [term.a], "b": [term.b], "both": [term.a, term.b]}[term.moves]):
                self.framed.append(term)
        elif isinstance(term, MirrorTerm) and self._moves([term.a, term.b]):
            self.mirrored.append(term)

    def _at_hand(self, slots: list[int]) -> bool:
        """Return whether all slots have their own place already: they move now or were placed before."""
        return all(self.problem.stage[i] <= self.number for i in slots)

    def _moves(self, refs: Iterable[Ref]) -> bool:
        return any(isinstance(ref, AssetRef) and self.problem.slot[ref.name] in self.moving for ref in refs)

    def _carried(self, a: int, b: int) -> bool:
        """Return whether one of two slots lies wholly on a surface of the other, which keeps it off whatever rises there."""
        parent, resting = self.problem.parent, self.problem.resting
        for lower, upper in ((a, b), (b, a)):
            place = resting[upper]
            if parent[upper] == lower and place is not None:
                return place.holds(self.problem.scene.assets[upper].size)
        return False

    def prisms(self) -> dict[str, NDArray[Any]]:
        """Return the prisms that pairs are made of; one that fills the table lies far away."""
        rows, count = [[p.x, p.y, p.hx, p.hy, p.cut] for _, p in self.prism], PRISMS.most * self.size
        return {
            "prism_slot": padded([slot for slot, _ in self.prism], count, 0, np.int32),
            "prism": padded(rows, count, [FAR_AWAY, FAR_AWAY, 0.0, 0.0, 0.0]),
        }

    def clears(self) -> dict[str, NDArray[Any]]:
        """Return the clear boxes with the slots that each concerns."""
        count = bucket(len(self.clear), (CLEAR_BUCKET, max(self.size, 2 * CLEAR_BUCKET), 4 * self.size))
        weight = np.zeros((count, self.size))
        for g, term in enumerate(self.clear):
            for i, asset in enumerate(self.problem.scene.assets):
                low, high = vertical_span(asset, self.problem.guess[asset.name])
                concerned = not asset.is_flat and low < term.span[1] and high > term.span[0]
                own = isinstance(term.owner, AssetRef) and term.owner.name == asset.name
                if concerned and not own and asset.name not in term.exempt and self._at_hand([i]):
                    weight[g, i] = term.weight * (1.0 if term.hard else SOFT_CLEAR)
        boxes = [[*term.center, *term.half] for term in self.clear]
        return {
            "clear_owner": padded([self.index(term.owner) for term in self.clear], count, self.size, np.int32),
            "clear_box": padded(boxes, count, [FAR_AWAY, FAR_AWAY, 0.0, 0.0]),
            "clear_weight": weight,
        }
