"""One stage of a problem as padded arrays.

Sizes are rounded up to a few buckets, so that one compiled search serves every room of its bucket.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout._geometry import compose
from robolayout.assets import Prism
from robolayout.assets.prisms import PRISMS
from robolayout.constraints import (
    AssetRef,
    ClearTerm,
    FrameTerm,
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
from robolayout.solve.arrays import Arrays
from robolayout.solve.compile import Floats, Problem, compile_problem

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
        every = np.tile([0.0, 0.0, 1.0, 0.0], (*world.shape[:-2], self.slots, 1))
        every[..., : world.shape[-2], :] = world
        carriers = np.maximum(self.arrays.carrier, 0)
        return relative(
            np.where((self.arrays.carrier >= 0)[:, None], every[..., carriers, :], self.arrays.anchor), every
        )


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
    moving, bodies = problem.movable(number), Bodies(problem)
    terms = (*problem.implicit_terms, *problem.statement_terms, *problem.wall_terms, *_stay_terms(problem))
    size = bodies.size
    anchor, carrier, limit = _frames(problem, number, world, size)
    free, inside = np.zeros((size, 3)), np.zeros(size)
    free[list(moving)] = 1.0
    free[list(set(moving) - _turning(problem)), 2] = 0.0
    inside[[slot for slot in moving if not _held(problem, slot)]] = 1.0
    room = problem.scene.room
    ring = [(*wall.start, *wall.end) for wall in room.walls]
    inner = [vertex for i, vertex in enumerate(room.vertices) if i not in convex_corners(room)]
    arrays = Arrays(
        half=padded(problem.half, (size,), [0.0, 0.0]),
        anchor=anchor,
        carrier=carrier,
        limit=limit,
        free=free,
        edges=padded(ring, EDGE_BUCKETS, [*ring[0][:2], *ring[0][:2]]),
        inner=padded(inner, EDGE_BUCKETS, [FAR_AWAY, FAR_AWAY]),
        inside=inside,
        **_prisms(problem, terms, number, size),
        **_clears(bodies, [term for term in terms if isinstance(term, ClearTerm)], number),
        **bodies.rows(
            (t for t in terms if _moves(problem, t, moving)), (3 * size, 16 * size), (MIRROR_BUCKET, 4 * size)
        ),
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


def no_routes(starts: int, size: int) -> NDArray[np.float32]:
    """Return demands of routes (starts, size, 4) that ask for nothing; see `Plan.demands`."""
    return np.tile(np.array([FAR_AWAY, FAR_AWAY, 0.0, -FAR_AWAY], np.float32), (starts, size, 1))


def padded(rows: Sequence[Any] | Floats, sizes: Sequence[int], filler: Any, kind: type = np.float64) -> NDArray[Any]:
    """Return rows as an array of one of the sizes (see `bucket`), filled up."""
    table = np.full((bucket(len(rows), sizes), *np.shape(filler)), filler, dtype=kind)
    if len(rows):
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
            anchor[i], limit[i] = on_top(problem, i, world[parent])
    return anchor, carrier, limit


def on_top(problem: Problem, slot: int, carrier: Floats) -> tuple[Floats, Floats]:
    """Return the middle (x, y, cos, sin) and the half sizes of what a slot may take of the surface on which it stands."""
    place, whole = problem.resting[slot], problem.half[problem.parent[slot]]
    x0, y0, x1, y1 = place.box if place else (*-whole, *whole)
    half = np.array([x1 - x0, y1 - y0]) / 2
    middle = compose(carrier, np.array([(x0 + x1) / 2, (y0 + y1) / 2, 1.0, 0.0]))
    return middle, np.maximum(half, problem.half[slot].min())


def _stay_terms(problem: Problem) -> Iterable[Term]:
    """Yield weak rows that hold things where the program first put them, in the room or on their carrier."""
    for name in problem.guessed:
        slot = problem.slot[name]
        me, carrier = AssetRef(name), problem.parent[slot]
        if carrier < 0:
            pose = problem.guess[name]
            yield FrameTerm(me, PointRef(pose.x, pose.y), distance=(0.0, 0.0), heading=pose.yaw, weight=STAY)
        else:
            u, v = relative(problem.start[carrier], problem.start[slot])[:2].tolist()
            top = AssetRef(problem.names[carrier])
            yield FrameTerm(me, top, along=Interval(u, u), across=Interval(v, v), weight=STAY)


def _moves(problem: Problem, term: Term, moving: Collection[int]) -> bool:
    """Return whether a row pulls at a slot that moves: at what it says yields, or at both things that it mirrors."""
    if not isinstance(term, FrameTerm | MirrorTerm):
        return False
    sides = {"a": [term.a], "b": [term.b]}.get(getattr(term, "moves", "both"), [term.a, term.b])
    return any(isinstance(ref, AssetRef) and problem.slot[ref.name] in moving for ref in sides)


def _prisms(problem: Problem, terms: Iterable[Term], number: int, size: int) -> dict[str, NDArray[Any]]:
    """Return the pairs that must not overlap, one of each moving, and their prisms; one that fills the table lies far away."""
    numbers: dict[tuple[int, Prism], int] = {}
    pairs: list[list[int]] = []
    moving = set(problem.movable(number))
    for term in terms:
        if isinstance(term, OverlapTerm):
            a, b = problem.slot[term.a.name], problem.slot[term.b.name]
            placed = max(problem.stage[a], problem.stage[b]) <= number
            if placed and moving & {a, b} and not (_lies_on(problem, a, b) or _lies_on(problem, b, a)):
                prisms = (a, term.first), (b, term.second)
                pairs.append([numbers.setdefault(key, len(numbers)) for key in prisms])
    every, most = size * (size - 1) // 2, (PRISMS.most * size,)
    rows = [[p.x, p.y, p.hx, p.hy, p.cut] for _, p in numbers]
    return {
        "prism_slot": padded([slot for slot, _ in numbers], most, 0, np.int32),
        "prism": padded(rows, most, [FAR_AWAY, FAR_AWAY, 0.0, 0.0, 0.0]),
        "pairs": padded(pairs, (4 * every, 16 * every), [0, 0], np.int32),
    }


def _lies_on(problem: Problem, upper: int, lower: int) -> bool:
    """Return whether a slot lies wholly on a surface of another, which keeps it off whatever rises there."""
    place = problem.resting[upper]
    return problem.parent[upper] == lower and place is not None and place.holds(problem.scene.assets[upper].size)


def _clears(bodies: Bodies, terms: Sequence[ClearTerm], number: int) -> dict[str, NDArray[Any]]:
    """Return the clear boxes with the slots that each concerns: what is placed by then at its heights."""
    problem, size = bodies.problem, bodies.size
    sizes = (CLEAR_BUCKET, max(size, 2 * CLEAR_BUCKET), 4 * size)
    weight = padded([[0.0] * size for _ in terms], sizes, [0.0] * size)
    for i, asset in enumerate(problem.scene.assets):
        low, high = vertical_span(asset, problem.guess[asset.name])
        for g, term in enumerate(terms):
            exempt = asset.is_flat or asset.name in term.exempt or term.owner == AssetRef(asset.name)
            if not exempt and low < term.span[1] and high > term.span[0] and problem.stage[i] <= number:
                weight[g, i] = term.weight * (1.0 if term.hard else SOFT_CLEAR)
    boxes = [[*term.center, *term.half] for term in terms]
    return {
        "clear_owner": padded([bodies.index(term.owner) for term in terms], sizes, size, np.int32),
        "clear_box": padded(boxes, sizes, [FAR_AWAY, FAR_AWAY, 0.0, 0.0]),
        "clear_weight": weight,
    }


class Bodies:
    """Numbers everything that a row may be about: slots, then walls, then fixed points; lists rows by these numbers."""

    def __init__(self, problem: Problem) -> None:
        self.problem, self.size = problem, bucket(len(problem.names), (8,))
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

    def rows(self, terms: Iterable[Term], frames: Sequence[int], mirrors: Sequence[int]) -> dict[str, NDArray[Any]]:
        """Return what terms say of frames and mirrors as arrays of sizes from buckets, beside walls and the points they are about."""
        terms = list(terms)
        framed = [term for term in terms if isinstance(term, FrameTerm)]
        mirrored = [term for term in terms if isinstance(term, MirrorTerm)]
        pairs = [[self.index(term.a), self.index(term.b)] for term in framed]
        triples = [[self.index(ref) for ref in (term.a, term.b, term.ref)] for term in mirrored]
        return {
            "frame_index": padded(pairs, frames, [self.size] * 2, np.int32),
            "frame_row": padded([t.row() for t in framed], frames, FrameTerm(WallRef(0), WallRef(0), weight=0.0).row()),
            "mirror_index": padded(triples, mirrors, [self.size] * 3, np.int32),
            "mirror_weight": padded([term.weight for term in mirrored], mirrors, 0.0),
            "mirror_normal": padded([float(isinstance(term.ref, WallRef)) for term in mirrored], mirrors, 0.0),
            "fixed": padded(self._fixed, (2 * self.size, 4 * self.size), [FAR_AWAY, FAR_AWAY, 1, 0, 0, 0, 0]),
        }
