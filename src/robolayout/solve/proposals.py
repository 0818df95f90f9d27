"""Where a thing might stand: places drawn from the rows of its own statements.

A row says where its thing belongs in the frame of another (along a wall, on a ring, on a side, in a slot); proposals are drawn
from exactly that set, wherever the other thing stands now. Things without such a row may stand anywhere.
"""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
import shapely
from shapely import Polygon

from robolayout._geometry import compose
from robolayout.constraints import FAR, AssetRef, FrameTerm, MirrorTerm, Ref, WallRef
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.stage import relative


def frame_of(problem: Problem, ref: Ref, world: Floats) -> Floats:
    """Return the frame (4,) of what a row refers to: an asset, a wall's middle, or a point."""
    if isinstance(ref, AssetRef):
        return world[problem.slot[ref.name]]
    if isinstance(ref, WallRef):
        wall = problem.scene.room.walls[ref.index]
        return np.array([*wall.midpoint, *wall.direction])
    return np.array([ref.x, ref.y, math.cos(ref.yaw), math.sin(ref.yaw)])


def carry(problem: Problem, world: Floats, slot: int, pose: Floats, followers: frozenset[int] = frozenset()) -> None:
    """Put a slot at a pose, in place, with everything that stands on it and with `followers`."""
    before = world[slot].copy()
    for other in range(len(world)):
        carrier = problem.parent[other]
        while carrier >= 0 and carrier != slot:
            carrier = problem.parent[carrier]
        if other != slot and (carrier == slot or other in followers):
            world[other] = compose(pose, relative(before, world[other]))
    world[slot] = pose


class Proposals:
    """Draws places for the slots of a problem."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.frames: dict[int, list[FrameTerm]] = {}  # rows that place each slot
        self.mirrors: dict[int, list[MirrorTerm]] = {}  # mirror rows of each slot
        for term in problem.statement_terms:
            if isinstance(term, FrameTerm) and isinstance(term.a, AssetRef) and term.moves != "b":
                self.frames.setdefault(problem.slot[term.a.name], []).append(term)
            elif isinstance(term, MirrorTerm):
                for ref in (term.a, term.b):
                    if isinstance(ref, AssetRef):
                        self.mirrors.setdefault(problem.slot[ref.name], []).append(term)

    def rows(self, slot: int) -> list[FrameTerm]:
        """Return the rows of a slot, and of the wall that it hangs at; what puts its back to a wall comes last."""
        hung = [term for term in self.problem.wall_terms if term.a == AssetRef(self.problem.names[slot])]
        return sorted([*self.frames.get(slot, []), *hung], key=at_wall)

    @cached_property
    def leaders(self) -> list[set[int]]:
        """What each slot is placed by."""
        ahead: list[set[int]] = [set() for _ in self.problem.names]
        for slot, terms in self.frames.items():
            ahead[slot] |= {self.problem.slot[t.b.name] for t in terms if isinstance(t.b, AssetRef)} - {slot}
        for slot, terms in self.mirrors.items():
            ahead[slot] |= {self.problem.slot[t.ref.name] for t in terms if isinstance(t.ref, AssetRef)} - {slot}
            if slot not in self.frames:
                ahead[slot] |= {self.twin(term, slot) for term in terms} & self.frames.keys()
        return ahead

    @cached_property
    def followers(self) -> list[set[int]]:
        """What is placed by each slot (a chair by its table), and what is placed by that in turn."""
        behind: list[set[int]] = [set() for _ in self.leaders]
        for slot, before in enumerate(self.leaders):
            for leader in before:
                behind[leader].add(slot)
        for slot, direct in enumerate(behind):
            for other in sorted(direct):
                direct |= behind[other]
            direct.discard(slot)
        return behind

    @cached_property
    def ranks(self) -> list[int]:
        """How many things stand between a slot and what it is placed by: what others refer to comes first."""
        ranks = [0] * len(self.leaders)
        for _ in range(4):
            ranks = [max((ranks[b] + 1 for b in before), default=0) for before in self.leaders]
        return ranks

    @cached_property
    def _floor(self) -> Polygon:
        floor = Polygon(self.problem.scene.room.vertices)
        shapely.prepare(floor)
        return floor

    def draw(self, slot: int, world: Floats, count: int, rng: np.random.Generator) -> Floats:
        """Return `count` poses (count, 4) for a slot, the other poses being `world` (n, 4)."""
        rows = [t for t in self.frames.get(slot, []) if placing(t)]
        turning = [t for t in self.frames.get(slot, []) if t.heading is not None or t.look is not None]
        chance = rng.random(count)
        mirrored = (chance < 0.15) & bool(self.mirrors.get(slot))
        placed = (chance < 0.75) & bool(rows) & ~mirrored
        nearby = (chance < 0.85) & ~mirrored & ~placed
        found = np.empty((count, 4))
        found[nearby] = self._nearby(world[slot], int(nearby.sum()), rng)
        anywhere = ~(mirrored | placed | nearby)
        found[anywhere] = self._anywhere(slot, world, int(anywhere.sum()), rng)
        for i in np.flatnonzero(mirrored):
            found[i] = self.image(self.mirrors[slot][int(rng.integers(len(self.mirrors[slot])))], slot, world)
        if rows:
            which = np.where(placed, rng.integers(len(rows), size=count), -1)
            for k, term in enumerate(rows):
                found[which == k] = self.placed(slot, term, world, int((which == k).sum()), rng)
        return self._turned(turning, found, world, rng)

    def placed(self, slot: int, term: FrameTerm, world: Floats, count: int, rng: np.random.Generator) -> Floats:
        """Draw from the set that a row allows."""
        frame = frame_of(self.problem, term.b, world)
        yaw = _quarters(count, rng) if term.heading is None else np.full(count, term.heading)
        hx, hy = self.problem.half[slot]
        c, s = np.abs(np.cos(yaw)), np.abs(np.sin(yaw))
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        spread = max(x1 - x0, y1 - y0) / 2
        u, v = (
            _draw(side.low + side.low_extent * extent, side.high - side.high_extent * extent, spread, rng)
            for side, extent in ((term.along, c * hx + s * hy), (term.across, s * hx + c * hy))
        )
        if term.fold:
            v = np.where(rng.random(count) < 0.5, -v, v)
        low, high = term.distance
        far, ringed = min(high, low + spread), low > 0.0 or high < FAR
        if ringed and isinstance(term.b, WallRef):
            end = self.problem.scene.room.walls[term.b.index].length / 2
            u, v = rng.uniform(-end, end, count), rng.uniform(low, far, count)
        elif ringed:
            away, around = rng.uniform(low, far, count), rng.uniform(0.0, math.tau, count)
            u, v = away * np.cos(around), away * np.sin(around)
        return compose(frame, np.stack([u, v, np.cos(yaw), np.sin(yaw)], axis=-1))

    def twin(self, term: MirrorTerm, slot: int) -> int:
        """Return the slot that a row makes the mirror image of another one."""
        one, other = (self.problem.slot[ref.name] for ref in (term.a, term.b) if isinstance(ref, AssetRef))
        return other if one == slot else one

    def image(self, term: MirrorTerm, slot: int, world: Floats) -> Floats:
        """Return the pose (4,) at which a row wants a slot: the mirror image of its twin."""
        frame = frame_of(self.problem, term.ref, world)
        if isinstance(term.ref, WallRef):
            frame = np.array([frame[0], frame[1], -frame[3], frame[2]])
        image = relative(frame, world[self.twin(term, slot)]) * np.array([1.0, -1.0, 1.0, -1.0])
        return compose(frame, image)

    def _nearby(self, pose: Floats, count: int, rng: np.random.Generator) -> Floats:
        """Draw close to where it is, turned by a multiple of 90 degrees."""
        yaw = math.atan2(pose[3], pose[2]) + _quarters(count, rng)
        return np.column_stack([pose[:2] + rng.normal(0.0, 0.3, (count, 2)), np.cos(yaw), np.sin(yaw)])

    def _anywhere(self, slot: int, world: Floats, count: int, rng: np.random.Generator) -> Floats:
        """Draw anywhere in the room, or on the top of its carrier."""
        yaw = _quarters(count, rng)
        heading = np.column_stack([np.cos(yaw), np.sin(yaw)])
        parent = self.problem.parent[slot]
        if parent >= 0:
            slack = np.maximum(self.problem.half[parent] - self.problem.half[slot].min(), 0.0)
            return compose(world[parent], np.column_stack([rng.uniform(-slack, slack, (count, 2)), heading]))
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        spots = rng.uniform((x0, y0), (x1, y1), (count, 2))
        for _ in range(20):
            outside = ~shapely.contains_xy(self._floor, *spots.T)
            if not outside.any():
                break
            spots[outside] = rng.uniform((x0, y0), (x1, y1), (int(outside.sum()), 2))
        return np.column_stack([spots, heading])

    def near(self, world: Floats, moving: tuple[int, ...], count: int, rng: np.random.Generator) -> Floats:
        """Return poses (n, 4) and slight jitter of what moves in them: (count, n, 4)."""
        scale = 0.1 if self.problem.parent[moving[0]] >= 0 else 1.0
        starts = np.repeat(world[None], count, axis=0)
        for k, start in enumerate(starts[1:], 1):
            sigma = (0.05 + 0.3 * k / count) * scale
            for slot in moving:
                start[slot, :2] += rng.normal(0.0, sigma, 2)
                if rng.random() < sigma / 2 and self.problem.guessed:
                    start[slot, 2:] = [-start[slot, 3], start[slot, 2]]
        self.bring_in(starts, moving)
        return starts

    def bring_in(self, starts: Floats, moving: tuple[int, ...]) -> None:
        """Put things whose centre lies outside the room onto the nearest point of its floor."""
        for slot in moving:
            if self.problem.parent[slot] < 0:
                points = np.asarray(shapely.points(starts[:, slot, :2]))
                outside = ~shapely.covers(self._floor, points)
                ways = shapely.shortest_line(points[outside], self._floor)
                starts[outside, slot, :2] = shapely.get_coordinates(ways)[1::2]

    def _turned(self, terms: list[FrameTerm], poses: Floats, world: Floats, rng: np.random.Generator) -> Floats:
        """Return the poses (m, 4), most of them with the heading that one of its rows asks for."""
        if not terms:
            return poses
        count = len(poses)
        which = np.where(rng.random(count) < 0.1, -1, rng.integers(len(terms), size=count))
        square = rng.random(count) < 0.5
        for k, term in enumerate(terms):
            mine = which == k
            frame = frame_of(self.problem, term.b, world)
            if term.heading is not None:
                yaw = np.full(int(mine.sum()), math.atan2(frame[3], frame[2]) + term.heading)
            else:
                yaw = np.arctan2(frame[1] - poses[mine, 1], frame[0] - poses[mine, 0]) - (term.look or 0.0)
                yaw = np.where(square[mine], np.round(yaw / (math.pi / 2)) * (math.pi / 2), yaw)
            poses[mine, 2:] = np.column_stack([np.cos(yaw), np.sin(yaw)])
        return poses


def _quarters(count: int, rng: np.random.Generator) -> Floats:
    """Draw multiples of 90 degrees, in radians."""
    return rng.integers(4, size=count).astype(np.float64) * (math.pi / 2)


def at_wall(term: FrameTerm) -> bool:
    """Return whether a row puts the back of a thing to a wall."""
    return isinstance(term.b, WallRef) and term.heading is not None


def placing(term: FrameTerm) -> bool:
    """Return whether a row says more than a heading."""
    bounds = (term.along.low, term.along.high, term.across.low, term.across.high)
    return any(abs(bound) < FAR for bound in bounds) or term.distance != (0.0, FAR)


def _draw(low: Floats, high: Floats, spread: float, rng: np.random.Generator) -> Floats:
    """Draw from intervals; open ends reach `spread` metres."""
    low, high = np.maximum(low, -spread), np.minimum(high, spread)
    drawn = low + rng.random(len(low)) * (high - low)
    return np.asarray(np.where(high > low, drawn, (low + high) / 2), np.float64)
