"""A robot's links and joints: where everything is at given joint values, how it folds smallest, where its hand gets to.

Links are convex hulls of their collision geometry. What stands on the ground (wheels, legs) stays as it is; all other joints
are arms, heads and lifts, which may be folded and stretched.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError
from scipy.spatial.transform import Rotation

from robolayout.scene._model import spread

Array = NDArray[np.float64]
Kind = Literal["fixed", "revolute", "prismatic"]


@dataclass(frozen=True)
class FoldConfig:
    """How a robot is folded, and how its reach is found out."""

    ground: float = 0.03  # metres above the lowest point up to which a link stands on the ground
    values: int = 7  # values of a joint that are tried
    rounds: int = 3  # passes over all joints
    starts: int = 3  # poses from which folding begins
    depth: float = 0.01  # metres that two links may be inside each other: hulls are larger than links
    level: float = 0.9  # cosine to the vertical above which an axis is upright; one minus it is level
    askew: float = 0.25  # share of its radius by which the middle of a wheel may lie beside its axis
    sides: int = 60  # directions in which the farthest corners of a hull stand for it while folding
    height: float = 0.05  # square metres of floor that a metre of height is worth when folding
    poses: int = 4000  # random poses of an arm for which it is found out where the hand is
    band: float = 0.1  # metres of height of the bands of a reach map


FOLDING = FoldConfig()

HANDS = ("gripper", "grasp", "finger", "hand", "tool", "tcp", "effector", "palm", "suction")
"""Words in the names of links that say where an arm ends."""


@dataclass(frozen=True, eq=False)
class RobotJoint:
    """What moves one link against another."""

    name: str
    parent: str  # the link that it is on
    child: str  # the link that it moves
    origin: Array  # (4, 4) pose of the child in the parent's frame at 0
    kind: Kind  # how it moves; continuous joints are revolute ones with a whole turn
    axis: Array  # (3,) unit vector in the child's frame
    low: float  # least value, radians or metres
    high: float  # greatest value
    # the joint that it follows, by what factor and from what offset; None where it moves by itself
    mimics: tuple[str, float, float] | None = None

    def motion(self, values: Array) -> Array:
        """Return the child's poses (n, 4, 4) in the parent's frame for values (n,)."""
        moved = np.tile(np.eye(4), (len(values), 1, 1))
        if self.kind == "prismatic":
            moved[:, :3, 3] = values[:, None] * self.axis
        elif self.kind == "revolute":
            moved[:, :3, :3] = Rotation.from_rotvec(values[:, None] * self.axis).as_matrix()
        return self.origin @ moved


@dataclass(frozen=True, eq=False)
class Robot:
    """Links in a tree of joints."""

    name: str
    root: str  # the link that all others hang on; its frame has x ahead and z up
    joints: tuple[RobotJoint, ...]  # all joints, each after the one that moves its parent
    # (n, 3) corners of the convex hull of a link's collision geometry, in its frame, by link
    hulls: Mapping[str, Array]
    # values of the joints in the pose that its file names; None where it names none
    home: Mapping[str, float] | None = None

    def poses(self, values: Mapping[str, Array], count: int = 1) -> dict[str, Array]:
        """Return the poses (count, 4, 4) of all links in the root's frame; joints without values (count,) are at 0."""
        found = {self.root: np.tile(np.eye(4), (count, 1, 1))}
        for joint in self.joints:
            leader, factor, offset = joint.mimics or (joint.name, 1.0, 0.0)
            value = factor * values.get(leader, np.zeros(count)) + offset
            found[joint.child] = found[joint.parent] @ joint.motion(value)
        return found

    def points(self, values: Mapping[str, Array], count: int = 1, *, coarse: bool = False) -> Array:
        """Return the corners (count, m, 3) of all hulls in the root's frame, or only of their coarse forms."""
        poses, clouds = self.poses(values, count), list[Array]()
        for link, hull in (self._coarse if coarse else self.hulls).items():
            clouds.append(hull @ poses[link][:, :3, :3].swapaxes(1, 2) + poses[link][:, None, :3, 3])
        return np.concatenate(clouds, axis=1)

    @cached_property
    def _coarse(self) -> dict[str, Array]:
        ways = spread(FOLDING.sides)
        return {link: hull[np.unique((hull @ ways.T).argmax(axis=0))] for link, hull in self.hulls.items()}

    def beyond(self, joint: RobotJoint) -> set[str]:
        """Return the links that a joint moves."""
        moved = {joint.child}
        for other in self.joints:
            if other.parent in moved:
                moved.add(other.child)
        return moved

    @cached_property
    def _wheels(self) -> tuple[RobotJoint, ...]:
        """The joints that turn for ever, with something round about their axes."""
        found: list[RobotJoint] = []
        for joint in self.joints:
            if joint.kind == "revolute" and joint.high - joint.low >= math.tau - 1e-6 and joint.child in self.hulls:
                hull = self.hulls[joint.child]
                across = hull - (hull @ joint.axis)[:, None] * joint.axis
                middle = (across.min(axis=0) + across.max(axis=0)) / 2
                if np.linalg.norm(middle) < FOLDING.askew * np.linalg.norm(across, axis=1).max():
                    found.append(joint)
        return tuple(found)

    @cached_property
    def arms(self) -> tuple[RobotJoint, ...]:
        """The joints that move nothing that stands on the ground: its wheels, and where none stands there, all that is lowest."""
        poses = self.poses({})
        ups = {link: poses[link][0, 2] for link in self.hulls}
        lowest = {link: float((hull @ ups[link][:3] + ups[link][3]).min()) for link, hull in self.hulls.items()}
        floor = min(lowest.values(), default=0.0)
        low = {link for link, height in lowest.items() if height < floor + FOLDING.ground}
        rolling = {link for joint in self._wheels for link in self.beyond(joint)}
        standing = low & rolling or low
        free = (j for j in self.joints if j.kind != "fixed" and j.mimics is None and j.low < j.high)
        return tuple(joint for joint in free if not self.beyond(joint) & standing)

    @cached_property
    def rest(self) -> dict[str, float]:
        """All arms at 0, or as near to it as they come."""
        return {joint.name: min(max(0.0, joint.low), joint.high) for joint in self.arms}

    def folded(self) -> dict[str, float]:
        """Return the values of the arms' joints at which the robot takes least floor, then least height."""
        if not self.arms:
            return {}
        rng = np.random.default_rng(0)
        drawn = [{j.name: float(rng.uniform(j.low, j.high)) for j in self.arms} for _ in range(FOLDING.starts - 1)]
        starts = [self.rest, *(start for start in drawn if not self.meets(start))]
        found = [self._descended(start) for start in starts]
        return min(found, key=lambda values: round(float(self._size(_column(values))[0]), 4))

    def _descended(self, start: Mapping[str, float]) -> dict[str, float]:
        best, worth = dict(start), float(self._size(_column(start))[0])
        for _ in range(FOLDING.rounds):
            before = worth
            for joint in self.arms:
                tried = np.linspace(joint.low, joint.high, FOLDING.values)
                batch = {name: np.full(FOLDING.values, value) for name, value in best.items()} | {joint.name: tried}
                sizes = self._size(batch, FOLDING.values)
                for k in np.argsort(sizes, kind="stable"):
                    if sizes[k] >= worth - 1e-6:
                        break
                    if not self.meets({**best, joint.name: float(tried[k])}):
                        best[joint.name], worth = float(tried[k]), float(sizes[k])
                        break
            if worth >= before - 1e-6:
                break
        return best

    def _size(self, values: Mapping[str, Array], count: int = 1) -> Array:
        """Return the floor (count,) in square metres that the robot takes turning on the spot, and a little for its height."""
        points = self.points(values, count, coarse=True)
        reach = np.hypot(points[..., 0], points[..., 1]).max(axis=1)
        return math.pi * reach**2 + FOLDING.height * np.ptp(points[..., 2], axis=1)

    @cached_property
    def _solids(self) -> dict[str, ConvexHull]:
        found: dict[str, ConvexHull] = {}
        for link, hull in self._coarse.items():
            with suppress(QhullError, ValueError):
                found[link] = ConvexHull(hull)
        return found

    @cached_property
    def _apart(self) -> frozenset[tuple[str, str]]:
        """Pairs of links that do not meet at rest."""
        links = sorted(self._solids)
        pairs = {(a, b) for i, a in enumerate(links) for b in links[i + 1 :]}
        return frozenset(pairs - set(self._meetings(self.rest, pairs)))

    def meets(self, values: Mapping[str, float]) -> bool:
        """Return whether two links are inside each other that are not at rest."""
        return next(self._meetings(values, self._apart), None) is not None

    def _meetings(
        self, values: Mapping[str, float], pairs: frozenset[tuple[str, str]] | set[tuple[str, str]]
    ) -> Iterator[tuple[str, str]]:
        """Yield the pairs of links of which one has a corner inside the other."""
        poses = {link: pose[0] for link, pose in self.poses(_column(values)).items()}
        world = {link: self._coarse[link] @ poses[link][:3, :3].T + poses[link][:3, 3] for link in self._solids}
        links = list(world)
        low, high = (np.array([bound(points, axis=0) for points in world.values()]) for bound in (np.min, np.max))
        near = (low[:, None] < high[None] - FOLDING.depth).all(axis=2)
        for i, j in np.argwhere(near & near.T):
            a, b = links[i], links[j]
            if (a, b) in pairs and any(self._inside(world[p], poses[q], q) for p, q in ((a, b), (b, a))):
                yield a, b

    def _inside(self, points: Array, pose: Array, link: str) -> bool:
        """Return whether one of some points (n, 3) is deeper than `FOLDING.depth` in a link's hull."""
        local = (points - pose[:3, 3]) @ pose[:3, :3]
        planes = self._solids[link].equations
        return bool((local @ planes[:, :3].T + planes[:, 3] < -FOLDING.depth).all(axis=1).any())

    def turning(self) -> float | None:
        """Return the radius in metres of the tightest arc that it drives on: 0 on the spot, None where wheels do not say or slide.

        Wheels stand on the ground and turn for ever about level axes; those that an upright joint of less than half a turn
        swings are steered, those that one swings right round are casters. For a wheelbase L and an angle a, the radius is
        L / tan a (bicycle model). Wheels whose axes are not parallel, or with rollers on them, go sideways.
        """
        poses = {link: pose[0] for link, pose in self.poses({}).items()}
        ways = {j.name: poses[j.child][:3, :3] @ j.axis for j in self.joints if j.kind == "revolute"}
        arms = {joint.name for joint in self.arms}
        turning = [j for j in self.joints if j.kind == "revolute" and j.low < j.high and j.name not in arms]
        swung = {link: j for j in turning if abs(ways[j.name][2]) > FOLDING.level for link in self.beyond(j)}
        level = [j for j in self._wheels if j in turning and abs(ways[j.name][2]) < 1 - FOLDING.level]
        steered = [j for j in level if j.child in swung and swung[j.child].high - swung[j.child].low < math.pi]
        fixed = [j for j in level if j.child not in swung]
        if not fixed or any(abs(ways[j.name] @ ways[fixed[0].name]) < FOLDING.level for j in fixed):
            return None
        if not steered:
            return 0.0 if len(fixed) > 1 else None
        rear = float(np.mean([poses[j.child][0, 3] for j in fixed]))
        base = abs(float(np.mean([poses[j.child][0, 3] for j in steered])) - rear)
        return base / math.tan(min(swung[j.child].high for j in steered))

    @cached_property
    def hand(self) -> str | None:
        """The link at which an arm ends: of those moved by most joints, one whose name says so; None without an arm."""
        if not self.arms:
            return None
        moved = {joint.name: self.beyond(joint) for joint in self.arms}
        links = {link: sum(link in others for others in moved.values()) for link in set[str]().union(*moved.values())}
        named = {link: count for link, count in links.items() if any(word in link.lower() for word in HANDS)}
        candidates = named or links
        most = max(candidates.values())
        return min(link for link, count in candidates.items() if count == most) if most >= 2 else None

    def _tip(self, hand: str) -> Array:
        """Return the point of a hand in its frame: the origin where its name says what it is, else its far end."""
        hull = self.hulls.get(hand, np.zeros((1, 3)))
        middle = (hull.min(axis=0) + hull.max(axis=0)) / 2
        length = float(np.linalg.norm(middle))
        if length < 1e-6 or any(word in hand.lower() for word in HANDS):
            return np.zeros(3)
        return middle / length * float((hull @ middle).max()) / length

    def reach(self, floor: float) -> list[tuple[float, float, float]]:
        """Return how far from the root's axis the hand gets, by height above the `floor` of its frame: (from, to, metres), lowest first."""
        if self.hand is None:
            return []
        rng = np.random.default_rng(0)
        values = {joint.name: rng.uniform(joint.low, joint.high, FOLDING.poses) for joint in self.arms}
        hands = self.poses(values, FOLDING.poses)[self.hand]
        at = hands[:, :3, :3] @ self._tip(self.hand) + hands[:, :3, 3]
        band = np.floor((at[:, 2] - floor) / FOLDING.band).astype(int)
        away = np.hypot(at[:, 0], at[:, 1])
        ends = ((int(k), float(away[band == k].max())) for k in np.unique(band) if k >= 0)
        return [(round(k * FOLDING.band, 2), round((k + 1) * FOLDING.band, 2), far) for k, far in ends]


def hulls(clouds: Mapping[str, Sequence[Array]]) -> dict[str, Array]:
    """Return the corners of the convex hulls of links, by the points (n, 3) on their shapes; flat ones stay as they are."""
    found = {link: np.concatenate(shapes) for link, shapes in clouds.items() if shapes}
    for link, points in found.items():
        try:
            found[link] = points[ConvexHull(points).vertices]
        except (QhullError, ValueError):
            found[link] = np.unique(points, axis=0)
    return found


def _column(values: Mapping[str, float]) -> dict[str, Array]:
    return {name: np.array([value]) for name, value in values.items()}
