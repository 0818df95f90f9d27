"""Where a thing might stand: places drawn from the rows of its own statements.

A row says where its thing belongs in the frame of another (along a wall, on a ring, on a side, in a slot); proposals are drawn
from exactly that set, wherever the other thing stands now. Things without such a row may stand anywhere.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import Point, Polygon

from robolayout.constraints import FAR, AssetRef, FrameTerm, MirrorTerm, Ref, WallRef
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.stage import relative


def compose(outer: Floats, inner: Floats) -> Floats:
    """Return poses (..., 4) given in the frame of `outer` in the frame that `outer` is given in."""
    c, s = outer[..., 2], outer[..., 3]
    x, y, ic, is_ = (inner[..., i] for i in range(4))
    return np.stack(
        [outer[..., 0] + c * x - s * y, outer[..., 1] + s * x + c * y, c * ic - s * is_, s * ic + c * is_], axis=-1
    )


@dataclass(frozen=True)
class Proposals:
    """Draws places for the slots of a problem.

    Attributes:
        problem: The problem.
        frames: Rows that place each slot.
        mirrors: Mirror rows of each slot.
    """

    problem: Problem
    frames: dict[int, list[FrameTerm]]
    mirrors: dict[int, list[MirrorTerm]]

    @classmethod
    def of(cls, problem: Problem) -> Proposals:
        """Return the proposals of a problem."""
        frames: dict[int, list[FrameTerm]] = {}
        mirrors: dict[int, list[MirrorTerm]] = {}
        for terms in problem.statement_terms:
            for term in terms:
                if isinstance(term, FrameTerm) and isinstance(term.a, AssetRef) and term.moves != "b":
                    frames.setdefault(problem.slot[term.a.name], []).append(term)
                elif isinstance(term, MirrorTerm):
                    for ref in (term.a, term.b):
                        if isinstance(ref, AssetRef):
                            mirrors.setdefault(problem.slot[ref.name], []).append(term)
        return cls(problem, frames, mirrors)

    def draw(self, slot: int, world: Floats, count: int, rng: np.random.Generator) -> Floats:
        """Return `count` poses (count, 4) for a slot, the other poses being `world` (n, 4)."""
        placing = [t for t in self.frames.get(slot, []) if _places(t)]
        turning = [t for t in self.frames.get(slot, []) if t.heading is not None or t.look is not None]
        found = np.empty((count, 4))
        for i in range(count):
            chance = rng.random()
            if chance < 0.15 and self.mirrors.get(slot):
                pose = self._mirrored(slot, world, rng)
            elif chance < 0.75 and placing:
                pose = self._placed(slot, placing[int(rng.integers(len(placing)))], world, rng)
            elif chance < 0.85:
                pose = self._nearby(world[slot], rng)
            else:
                pose = self._anywhere(slot, world, rng)
            found[i] = self._turned(turning, pose, world, rng)
        return found

    def _frame(self, ref: Ref, world: Floats) -> Floats:
        if isinstance(ref, AssetRef):
            return world[self.problem.slot[ref.name]]
        if isinstance(ref, WallRef):
            wall = self.problem.scene.room.walls[ref.index]
            return np.array([*wall.midpoint, *wall.direction])
        return np.array([ref.x, ref.y, math.cos(ref.yaw), math.sin(ref.yaw)])

    def _placed(self, slot: int, term: FrameTerm, world: Floats, rng: np.random.Generator) -> Floats:
        """Draw from the set that a row allows."""
        frame = self._frame(term.b, world)
        yaw = term.heading if term.heading is not None else float(rng.integers(4)) * math.pi / 2
        hx, hy = self.problem.half[slot]
        c, s = abs(math.cos(yaw)), abs(math.sin(yaw))
        spread = self._spread()
        u = _draw(
            term.along.low + term.along.low_extent * (c * hx + s * hy),
            term.along.high - term.along.high_extent * (c * hx + s * hy),
            spread,
            rng,
        )
        v = _draw(
            term.across.low + term.across.low_extent * (s * hx + c * hy),
            term.across.high - term.across.high_extent * (s * hx + c * hy),
            spread,
            rng,
        )
        if term.fold and rng.random() < 0.5:
            v = -v
        low, high = term.distance
        if (low > 0.0 or high < FAR) and not isinstance(term.b, WallRef):
            away, around = rng.uniform(low, min(high, low + spread)), rng.uniform(0.0, math.tau)
            u, v = away * math.cos(around), away * math.sin(around)
        elif isinstance(term.b, WallRef) and (low > 0.0 or high < FAR):
            end = self.problem.scene.room.walls[term.b.index].length / 2
            u = rng.uniform(-end, end)
            v = rng.uniform(low, min(high, low + spread))
        return compose(frame, np.array([u, v, math.cos(yaw), math.sin(yaw)]))

    def _spread(self) -> float:
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        return max(x1 - x0, y1 - y0) / 2

    def _mirrored(self, slot: int, world: Floats, rng: np.random.Generator) -> Floats:
        """Return the mirror image of a twin."""
        terms = self.mirrors[slot]
        term = terms[int(rng.integers(len(terms)))]
        mine = AssetRef(self.problem.names[slot])
        twin = term.b if term.a == mine else term.a
        frame = self._frame(term.ref, world)
        if isinstance(term.ref, WallRef):
            frame = np.array([frame[0], frame[1], -frame[3], frame[2]])
        image = relative(frame, self._frame(twin, world)) * np.array([1.0, -1.0, 1.0, -1.0])
        return compose(frame, image)

    def _nearby(self, pose: Floats, rng: np.random.Generator) -> Floats:
        """Draw close to where it is, turned by a multiple of 90 degrees."""
        turn = float(rng.integers(4)) * math.pi / 2
        shift = rng.normal(0.0, 0.3, 2)
        return compose(
            np.array([pose[0] + shift[0], pose[1] + shift[1], pose[2], pose[3]]),
            np.array([0.0, 0.0, math.cos(turn), math.sin(turn)]),
        )

    def _anywhere(self, slot: int, world: Floats, rng: np.random.Generator) -> Floats:
        """Draw anywhere in the room, or on the top of its carrier."""
        yaw = float(rng.integers(4)) * math.pi / 2
        turned = np.array([0.0, 0.0, math.cos(yaw), math.sin(yaw)])
        parent = self.problem.parent[slot]
        if parent >= 0:
            slack = np.maximum(self.problem.half[parent] - self.problem.half[slot].min(), 0.0)
            turned[:2] = rng.uniform(-slack, slack)
            return compose(world[parent], turned)
        room = Polygon(self.problem.scene.room.vertices)
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        for _ in range(20):
            turned[:2] = rng.uniform((x0, y0), (x1, y1))
            if room.contains(Point(turned[0], turned[1])):
                break
        return turned

    def _turned(self, terms: list[FrameTerm], pose: Floats, world: Floats, rng: np.random.Generator) -> Floats:
        """Return the pose with the heading that one of its rows asks for, most of the time."""
        if not terms or rng.random() < 0.1:
            return pose
        term = terms[int(rng.integers(len(terms)))]
        frame = self._frame(term.b, world)
        if term.heading is not None:
            yaw = math.atan2(frame[3], frame[2]) + term.heading
        else:
            yaw = math.atan2(frame[1] - pose[1], frame[0] - pose[0]) - (term.look or 0.0)
            if rng.random() < 0.5:
                yaw = round(yaw / (math.pi / 2)) * (math.pi / 2)
        return np.array([pose[0], pose[1], math.cos(yaw), math.sin(yaw)])


def _places(term: FrameTerm) -> bool:
    """Return whether a row says more than a heading."""
    bounds = (term.along.low, term.along.high, term.across.low, term.across.high)
    return any(abs(bound) < FAR for bound in bounds) or term.distance != (0.0, FAR)


def _draw(low: float, high: float, spread: float, rng: np.random.Generator) -> float:
    """Draw from an interval; open ends reach `spread` metres."""
    low, high = max(low, -spread), min(high, spread)
    return float(rng.uniform(low, high)) if high > low else (low + high) / 2


def make_starts(
    problem: Problem, world: Floats, moving: tuple[int, ...], count: int, rng: np.random.Generator
) -> Floats:
    """Return `count` starts (count, n, 4): the guess, wider and wider jitter of it, then draws from the rows."""
    proposals = Proposals.of(problem)
    starts = np.repeat(world[None], count, axis=0)
    for k in range(1, count):
        if 2 * k < count:
            _jitter(starts[k], moving, (0.1 + 1.2 * k / count) * (0.1 if problem.parent[moving[0]] >= 0 else 1.0), rng)
        else:
            for slot in moving:
                if rng.random() < 0.7:
                    starts[k, slot] = proposals.draw(slot, starts[k], 1, rng)[0]
    _bring_in(problem, starts, moving)
    return starts


def _bring_in(problem: Problem, starts: Floats, moving: tuple[int, ...]) -> None:
    """Put things whose centre lies outside the room onto the nearest point of its floor."""
    room = Polygon(problem.scene.room.vertices)
    shapely.prepare(room)
    for slot in moving:
        if problem.parent[slot] < 0:
            points = np.asarray(shapely.points(starts[:, slot, :2]))
            outside = ~shapely.covers(room, points)
            ways = shapely.shortest_line(points[outside], room)
            starts[outside, slot, :2] = shapely.get_coordinates(ways)[1::2]


def _jitter(world: Floats, moving: tuple[int, ...], sigma: float, rng: np.random.Generator) -> None:
    for slot in moving:
        world[slot, :2] += rng.normal(0.0, sigma, 2)
        if rng.random() < sigma / 2:
            world[slot, 2:] = [-world[slot, 3], world[slot, 2]]
