"""`in_shape`: things stand in a circle, a half circle or a U."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np

from robolayout.constraints._exact import TOLERANCE, angle_between
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Pose, Scene


@dataclass(frozen=True)
class Shapes:
    """How things stand in a circle, a half circle or a U, and how far from that they may be."""

    gap: tuple[float, float] = (0.12, 1.0)  # metres between neighbours, least and most
    inner: float = 0.7  # metres from the middle to the nearest edge of a thing, at least: for feet
    off: float = 0.15  # metres by which a thing may be off the line of the others
    uneven: float = 1.45  # how many times as far from the next as on average a thing may be
    span: float = 35.0  # degrees by which a half circle may be more or less than half of one


SHAPES = Shapes()


@dataclass(frozen=True)
class InShape(Relation):
    """The `items` stand in a `shape` ("circle", "half circle" or "u"), fronts `toward` its middle ("in") or away from it ("out")."""

    name = "in_shape"
    moves = ("items",)
    surrogate = True  # each keeps its place in the order, where the check takes any order
    example = 'solver.in_shape([chair[0], chair[1], chair[2], chair[3]], "half circle")'

    items: tuple[AssetRef, ...] = argument("asset", many=True)
    shape: str = argument("text", choices=("circle", "half circle", "u"), default="circle")
    toward: str = argument("text", choices=("in", "out"), default="in")

    def fault(self, scene: Scene) -> str:
        """Refuse fewer than three things, which stand in no circle."""
        return "" if len(self.items) > 2 else f"a {self.shape} is of at least 3 things, not of {len(self.items)}"

    @property
    def head(self) -> AssetRef:
        """The item in the middle of an open shape, opposite to where it is open."""
        return self.items[len(self.items) // 2]

    def slots(self, scene: Scene, gap: float = SHAPES.gap[0]) -> dict[str, Pose]:
        """Return the place of each item, by name, in the shape's frame: x looks from its head to where it is open."""
        sizes = [scene.by_name[item.name].size for item in self.items]
        depth, width = (max(size[k] for size in sizes) for k in (0, 1))
        turned = math.pi if self.toward == "out" else 0.0
        found = shape_slots(self.shape, len(sizes), depth, width, gap)
        return {i.name: Pose(x, y, 0.0, yaw + turned) for i, (x, y, yaw) in zip(self.items, found, strict=True)}

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row for each item but the head: its place as seen from there, as far from the next as the guess has it."""
        apart = [math.dist(near[one.name].at, near[two.name].at) for one, two in pairwise(self.items)]
        width = max(scene.by_name[item.name].size[1] for item in self.items)
        slots = self.slots(scene, min(max(float(np.median(apart)) - width, SHAPES.gap[0]), SHAPES.gap[1]))
        at = slots[self.head.name]
        rows = list[Term]()
        for item in self.items:
            slot = slots[item.name]
            (x, y), heading = at.seen(slot.at), slot.yaw - at.yaw
            along, across = Interval(x, x), Interval(y, y)
            rows += [FrameTerm(item, self.head, along, across, heading=heading, moves="both")] * (item != self.head)
        return tuple(rows)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """In line within 15 cm, each turned within 10 degrees, evenly apart; a half circle spans 180 degrees within 35."""
        turned = math.pi if self.toward == "out" else 0.0
        poses = [(layout[item.name].x, layout[item.name].y, layout[item.name].yaw - turned) for item in self.items]
        off, askew, uneven, even = _as_u(poses) if self.shape == "u" else _as_arc(poses, self.shape == "circle")
        met = even and off <= SHAPES.off and askew <= TOLERANCE.angle and uneven <= SHAPES.uneven
        text = f"up to {off:.2f} m off a {self.shape}, {askew:.0f} deg off, up to {uneven:.1f} times as far apart"
        return Outcome(met, off, SHAPES.off, "m", text if even else f"no {self.shape}")


def shape_slots(
    shape: str, count: int, depth: float, width: float, gap: float = SHAPES.gap[0]
) -> list[tuple[float, float, float]]:
    """Return places of so many things of one size that look inward (metres and radians); x looks to where the shape is open."""
    if shape != "u":
        step = math.tau / count if shape == "circle" else math.pi / (count - 1)
        radius = depth / 2 + max(SHAPES.inner, (width + gap) / 2 / math.tan(step / 2))
        first = -(count // 2) if shape == "circle" else -(count - 1) / 2
        turns = [(first + k) * step for k in range(count)]
        return [(radius * (1.0 - math.cos(turn)), -radius * math.sin(turn), turn) for turn in turns]
    arm = count // 3
    base, step = count - 2 * arm, width + gap
    aside = max(base * step / 2 - depth / 2, SHAPES.inner + depth / 2)
    ahead = [(depth + width) / 2 + gap + k * step for k in range(arm)]
    right = [(x, -aside, math.pi / 2) for x in reversed(ahead)]
    left = [(x, aside, -math.pi / 2) for x in ahead]
    return [*right, *((0.0, (k - (base - 1) / 2) * step, 0.0) for k in range(base)), *left]


def circle_across(count: int, depth: float, width: float) -> float:
    """Return the metres between the middles of those two in the closest circle of so many things that are farthest apart."""
    slots = shape_slots("circle", count, depth, width)
    return max(math.dist(one[:2], two[:2]) for one, two in combinations(slots, 2))


Fit = tuple[float, float, float, bool]
"""Metres off the line, degrees off, how uneven, and whether it is such a shape at all."""


def _as_arc(poses: Sequence[tuple[float, float, float]], closed: bool) -> Fit:
    """Return how well things that look inward stand on the circle that fits them best (least squares)."""
    points = np.array([pose[:2] for pose in poses])
    middle = points.mean(axis=0)
    u, v = (points - middle).T
    a, b, _ = np.linalg.lstsq(np.column_stack([2 * u, 2 * v, np.ones(len(u))]), u * u + v * v, rcond=None)[0].tolist()
    out = points - middle - (a, b)
    radii = np.hypot(*out.T)
    inward = np.arctan2(-out[:, 1], -out[:, 0]).tolist()
    askew = max(angle_between(yaw, turn) for (_, _, yaw), turn in zip(poses, inward, strict=True))
    turns = sorted(turn % math.tau for turn in inward)
    gaps = sorted(math.degrees(right - left) for left, right in pairwise([*turns, turns[0] + math.tau]))
    span = 360.0 if closed else 360.0 - gaps.pop()
    even = closed or abs(span - 180.0) <= SHAPES.span
    uneven = gaps[-1] * len(gaps) / span if span else math.inf
    return float(np.abs(radii - radii.mean()).max()), askew, uneven, even


def _as_u(poses: Sequence[tuple[float, float, float]]) -> Fit:
    """Return how well things that look inward stand at three sides of a rectangle: the best side for the middle one."""
    return min((_about(poses, yaw) for *_, yaw in poses), key=lambda fit: (not fit[3], *fit))


def _about(poses: Sequence[tuple[float, float, float]], yaw: float) -> Fit:
    """Return the same where the middle side is of those that are turned so."""
    here = Pose(0.0, 0.0, 0.0, yaw)
    sides = tuple(list[tuple[float, float]]() for _ in range(4))  # metres off its line and along it, of what looks so
    askew = 0.0
    for x, y, turned in poses:
        quarter = round((turned - yaw) / (math.pi / 2)) % 4
        (u, v), across = here.seen((x, y)), quarter % 2
        sides[quarter].append((v, u) if across else (u, v))
        askew = max(askew, angle_between(turned, yaw + quarter * math.pi / 2))
    base, right, opposite, left = sides  # whoever stands at the right looks to the left
    if opposite or not (base and right and left):
        apart = max(math.dist(poses[0][:2], (x, y)) for x, y, _ in poses)
        return SHAPES.off + apart, askew, math.inf, False
    off = max(max(line) - min(line) for line in ([one for one, _ in side] for side in (base, right, left))) / 2
    places = [sorted(along for _, along in side) for side in (base, right, left)]
    steps = [after - before for side in places for before, after in pairwise(side)]
    apart = max(v for v, _ in right) < min(v for v, _ in left)
    ahead = max(u for u, _ in base) < min(u for _, u in (*left, *right))
    return off, askew, max(steps) * len(steps) / sum(steps) if any(steps) else 1.0, apart and ahead
