"""The paper's algorithm, for comparison: Adam in a trust region, hard corrections in between, then the refinement.

Every constant of `PaperConfig` says where in the paper it stands; docs/derivations.md works the whole through by hand for two
assets. Nothing of the default search is used, and nothing here helps the paper along, with one exception: where the refinement
made the layout worse, the layout before it is returned.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import KW_ONLY, dataclass, replace
from itertools import combinations
from typing import Any, ClassVar, NamedTuple

import numpy as np
from shapely import Polygon

from robolayout.assets import place_of
from robolayout.constraints import share_height
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.scene import Room, Snapshot, Trace
from robolayout.solve import programs
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.paper.project import footprint, into_room, outside, projected
from robolayout.solve.solution import Judge, Progress, Solution, silent, snapshot
from robolayout.solve.stage import Bodies, padded

Array = Any

TERMS = ("overlap", "statements", "reachability")
"""The terms of L_total: no overlap, existing and new constraints (solved together), pairwise reach."""


@dataclass(frozen=True)
class PaperConfig:
    """The paper's constants."""

    steps: int = 400  # T. Not in the paper; the published code's default
    rate: float = 0.03  # alpha_0, section "Learning Rate Scaling"
    position_factor: float = 3.0  # alpha_pos = 3 alpha_0 / R_room, section "Learning Rate Scaling"
    beta: float = 0.9  # beta_1 and beta_2, section "Adam Update"
    epsilon: float = 1.0e-8  # epsilon, section "Adam Update"
    clip: float = 10.0  # longest gradient of one position or one heading, section "Adam Update"
    decay: float = 0.95  # gamma, section "Adam Update"
    decay_every: int = 100  # steps between two decays, section "Adam Update"
    project_every: int = (
        80  # steps between two boundary projections, section "Feasibility Enforcement" (its listing says 100)
    )
    radius: float = 1.0  # Delta_0, section "Rotation Constraint"; the paper gives no figure. Metres and units of (cos, sin) together
    most_radius: float = 1.0  # Delta_max, ibid.; the paper gives no figure
    # eta_1, ibid.; the paper gives no figure. This and the next three are the textbook's (Nocedal and Wright, chapter 4)
    accept: float = 0.1
    trust: float = 0.75  # eta_2, ibid.
    shrink: float = 0.5  # gamma_1, ibid.
    grow: float = 2.0  # gamma_2, ibid.
    refine_steps: int = 40  # T_cleanup, section "Refinement"
    refine_rate: float = 0.01  # eta_cleanup, ibid.
    refine_clip: float = 1.0  # gradient clipping, ibid.
    refine_project_every: int = 10  # K, ibid.


PAPER = PaperConfig()


class Table(NamedTuple):
    """The loss of one scene, rows padded with weight 0. A slots, F fixed bodies, P pairs, S stacks, R frame and M mirror rows."""

    half: Array  # (A, 2) half depth and half width in metres
    fixed: Array  # (F, 7) walls and points as bodies (x, y, cos, sin, half x, half y, core)
    pairs: Array  # (P, 2) slots that must not overlap
    pair_weight: Array  # (P,) 1 for real pairs
    required: Array  # (P,) metres between the centres of each pair that let the agent pass; 0 where it need not
    stacks: Array  # (S, 2) upper and lower slot of each stack
    stack_weight: Array  # (S,) 1 for real stacks
    frame_index: Array  # (R, 2) bodies a and b of each frame row (slots first, then fixed bodies)
    frame_row: Array  # (R, 20) numbers of each frame row
    mirror_index: Array  # (M, 3) bodies a, b and axis
    mirror_weight: Array  # (M,) weight of each mirror row
    mirror_normal: Array  # (M,) 1 where the axis is a wall
    held: Array  # 1 if statements only move what they are about, 0 if also what they refer to


def make_table(problem: Problem, *, held: bool) -> Table:
    """Return the paper's loss of a problem: its statements, overlaps and the pairwise reach, but no term of our own.

    `held` lets the gradient of a statement leave alone what it refers to, as in the paper's algorithm.
    """
    bodies = Bodies(problem)
    size = bodies.size
    stacks = [[i, parent] for i, parent in enumerate(problem.parent) if parent >= 0]
    overlaps, required = overlap_pairs(problem), reach_pairs(problem)
    pairs, every = sorted({*overlaps, *required}), (size * (size - 1) // 2,)
    said = [t for r in problem.relations if not isinstance(r, OnTopOf) for t in r.terms(problem.scene, problem.guess)]
    return Table(
        half=padded(problem.half, (size,), [1.0, 1.0]),
        pairs=padded(pairs, every, [0, 0], np.int32),
        pair_weight=padded([float(pair in overlaps) for pair in pairs], every, 0.0),
        required=padded([required.get(pair, 0.0) for pair in pairs], every, 0.0),
        stacks=padded(stacks, (size,), [0, 0], np.int32),
        stack_weight=padded([1.0] * len(stacks), (size,), 0.0),
        held=np.float64(held),
        **bodies.rows(said, (4 * size, 16 * size), (size, 4 * size)),
    )


def overlap_pairs(problem: Problem) -> set[tuple[int, int]]:
    """Return the pairs of slots whose boxes must not overlap: those at one height, stacks aside."""
    assets = problem.scene.assets
    pairs = combinations(range(len(assets)), 2)
    return {(a, b) for a, b in pairs if _apart(problem, a, b) and share_height(assets[a], assets[b], problem.guess)}


def reach_pairs(problem: Problem) -> dict[tuple[int, int], float]:
    """Return the pairs of floor things that must let the agent's disc pass, rugs aside, with the metres between their centres.

    These are e_i + e_j + 2 r, e half the smaller side and r the radius (the paper's section "Reachability Constraint").
    """
    assets, radius = problem.scene.assets, problem.scene.agent.radius
    floor = [i for i, asset in enumerate(assets) if place_of(asset) == "floor" and not asset.is_flat]
    pairs = [(a, b) for a, b in combinations(floor, 2) if radius > 0 and _apart(problem, a, b)]
    return {(a, b): min(assets[a].size[:2]) / 2 + min(assets[b].size[:2]) / 2 + 2 * radius for a, b in pairs}


def _apart(problem: Problem, a: int, b: int) -> bool:
    """Return whether neither of two slots stands on the other."""
    return problem.parent[a] != b and problem.parent[b] != a


class LossAt(NamedTuple):
    """The loss at one layout."""

    value: float  # L = 0.1 L_total
    gradient: Floats  # (n, 4) along (x, y, cos, sin)
    terms: Floats  # terms of L_total, as in `TERMS`


def paper_loss(problem: Problem, *, held: bool = False) -> Callable[[Floats], LossAt]:
    """Return the paper's loss of world poses (n, 4); `held` as in `make_table`."""
    table = make_table(problem, held=held)

    def loss(world: Floats) -> LossAt:
        poses = padded(world, (len(table.half),), [0.0, 0.0, 1.0, 0.0])
        value, gradient, terms = programs.call("paper.loss:value_and_gradient", poses, table)
        return LossAt(float(value), gradient[: len(world)], terms)

    return loss


class Moments(NamedTuple):
    """Adam's memory: number of steps and the two moments (n, 4)."""

    steps: int
    first: Floats
    second: Floats

    @classmethod
    def zero(cls, world: Floats) -> Moments:
        """Return the memory before the first step."""
        return cls(0, np.zeros_like(world), np.zeros_like(world))


def rates(room: Room, config: PaperConfig = PAPER) -> Floats:
    """Return the learning rates (4,) of (x, y, cos, sin)."""
    x0, y0, x1, y1 = room.bounds
    position = config.position_factor * config.rate / max(x1 - x0, y1 - y0, 1.0)
    return np.array([position, position, config.rate, config.rate])


def decayed(rate: Floats, count: int, config: PaperConfig = PAPER) -> Floats:
    """Return alpha gamma^floor(t / 100)."""
    return rate * config.decay ** (count // config.decay_every)


def clipped(gradient: Floats, longest: float) -> Floats:
    """Return gradients (n, 4) with every position's and every heading's part at most `longest`."""
    parts = gradient.reshape(len(gradient), 2, 2)
    length = np.linalg.norm(parts, axis=-1, keepdims=True)
    return (parts * np.minimum(1.0, longest / np.maximum(length, 1e-300))).reshape(gradient.shape)


def adam(moments: Moments, gradient: Floats, rate: Floats, config: PaperConfig = PAPER) -> tuple[Moments, Floats]:
    """Return Adam's memory after a gradient, and the step that it proposes."""
    count, beta = moments.steps + 1, config.beta
    first = beta * moments.first + (1 - beta) * gradient
    second = beta * moments.second + (1 - beta) * gradient**2
    unbiased = 1 - beta**count
    step = -rate * (first / unbiased) / (np.sqrt(second / unbiased) + config.epsilon)
    return Moments(count, first, second), step


def admissible(room: Room, world: Floats, step: Floats, radius: float) -> Floats:
    """Return a step made admissible: at most `radius` long, positions in the room's box, headings on the unit circle."""
    x0, y0, x1, y1 = room.bounds
    length = float(np.linalg.norm(step))
    if length > radius:
        step = step * (radius / length)
    target = world + step
    target[:, :2] = np.clip(target[:, :2], (x0, y0), (x1, y1))
    target[:, 2:] = _on_circle(world[:, 2:], target[:, 2:])
    return target - world


def _on_circle(here: Floats, target: Floats) -> Floats:
    """Return headings (n, 2) in the direction of `target`, no further from `here` than that was."""
    turn = np.arctan2(here[:, 0] * target[:, 1] - here[:, 1] * target[:, 0], np.sum(here * target, axis=1))
    most = 2 * np.arcsin(np.minimum(np.linalg.norm(target - here, axis=1) / 2, 1.0))
    turn = np.clip(turn, -most, most)
    c, s = np.cos(turn), np.sin(turn)
    return np.stack([c * here[:, 0] - s * here[:, 1], s * here[:, 0] + c * here[:, 1]], axis=1)


def judged_step(
    before: LossAt, after: LossAt, step: Floats, radius: float, config: PaperConfig = PAPER
) -> tuple[bool, float]:
    """Return whether a step is accepted, and the next trust radius.

    The predicted decrease is that of the tangent plane, -gradient . step; a step that Adam's memory takes uphill is predicted
    to gain nothing and refused.
    """
    predicted = -float(np.sum(before.gradient * step))
    ratio = (before.value - after.value) / predicted if predicted > 0 else -math.inf
    if ratio <= config.accept:
        return False, radius * config.shrink
    return True, min(radius * config.grow, config.most_radius) if ratio > config.trust else radius


def random_start(problem: Problem, rng: np.random.Generator) -> Floats:
    """Return world poses (n, 4): the program's own where it says so, else random ones with the footprint in the room."""
    world, room = problem.start.copy(), problem.scene.room
    x0, y0, x1, y1 = room.bounds
    for slot, name in enumerate(problem.names):
        if name in problem.pinned or name in problem.guessed:
            continue
        for _ in range(100):
            yaw = rng.uniform(0.0, math.tau)
            world[slot] = [rng.uniform(x0, x1), rng.uniform(y0, y1), math.cos(yaw), math.sin(yaw)]
            if not outside(room, footprint(world[slot], problem.half[slot])).any():
                break
        world[slot] = into_room(room, world[slot], problem.half[slot])
    return world


def problematic(problem: Problem, world: Floats) -> tuple[int, ...]:
    """Return the free slots whose footprint meets that of another one at the same height, stacks aside."""
    shapes = [Polygon(footprint(pose, half)) for pose, half in zip(world, problem.half, strict=True)]
    meeting = {i for pair in overlap_pairs(problem) if shapes[pair[0]].intersects(shapes[pair[1]]) for i in pair}
    return tuple(i for i in sorted(meeting) if problem.names[i] not in problem.pinned)


@dataclass
class Compared:
    """A solver that is kept to compare, with its losses and poses on the way."""

    problem: Problem
    judge: Judge
    _: KW_ONLY
    seed: int = 0  # of the random start, and of whatever else is drawn
    progress: Progress = silent  # called with the name of each phase
    held: ClassVar[bool] = False  # see `make_table`

    def __post_init__(self) -> None:
        self.losses: list[dict[str, float]] = []
        self.shots: list[Snapshot] = []
        self.free = [slot for slot, name in enumerate(self.problem.names) if name not in self.problem.pinned]
        self.loss = paper_loss(self.problem, held=self.held)
        self.start = random_start(self.problem, np.random.default_rng(self.seed))

    @property
    def trace(self) -> Trace:
        """The record so far."""
        return Trace(tuple(self.losses), tuple(self.shots))

    def record(self, label: str, here: LossAt, world: Floats) -> None:
        """Keep the terms of a loss, and every tenth time the poses."""
        terms = dict(zip(TERMS, map(float, here.terms), strict=True))
        if len(self.losses) % 10 == 0:
            self.shots.append(snapshot(len(self.losses), label, self.problem.layout(world)))
        self.losses.append({**terms, "total": sum(terms.values())})

    def best_of(self, *worlds: Floats) -> Solution:
        """Return the best of some world poses (n, 4) by the judge, of equals the first."""
        layouts = (self.problem.layout(world) for world in worlds)
        verdict, layout = min(((self.judge(one), one) for one in layouts), key=lambda found: found[0].merit)
        return Solution(layout, verdict, trace=self.trace)


@dataclass
class PaperSolver(Compared):
    """Solves one problem as the paper does."""

    config: PaperConfig = PAPER
    held = True

    def solve(self) -> Solution:
        """Return the layout that the paper's algorithm ends with."""
        self.progress("search")
        world = self.search(self.start)
        slots = problematic(self.problem, world)
        if not slots:
            return self.best_of(world)
        self.progress("refine")
        return self.best_of(world, self.refine(world, slots))

    def search(self, world: Floats) -> Floats:
        """Return world poses (n, 4) after the main optimisation."""
        return self._descended("search", world, self.free, rates(self.problem.scene.room, self.config), self.config)

    def refine(self, world: Floats, slots: Sequence[int]) -> Floats:
        """Return world poses (n, 4) after the refinement, which moves these slots only and accepts every step."""
        steps, clip, every = self.config.refine_steps, self.config.refine_clip, self.config.refine_project_every
        config = replace(self.config, steps=steps, clip=clip, project_every=every, radius=math.inf)
        return self._descended("refine", world, slots, np.full(4, config.refine_rate), config)

    def _descended(self, label: str, world: Floats, slots: Sequence[int], rate: Floats, config: PaperConfig) -> Floats:
        """Return world poses (n, 4) after Adam's steps with slots alone, projected now and then."""
        free = np.zeros((len(world), 1))
        free[list(slots)] = 1.0
        names, room, radius = self.problem.names, self.problem.scene.room, config.radius
        problem = replace(self.problem, pinned=frozenset(names[i] for i in np.flatnonzero(free == 0.0)))
        here, moments = self.loss(world), Moments.zero(world)
        for count in range(1, config.steps + 1):
            self.record(label, here, world)
            moments, step = adam(
                moments, clipped(here.gradient, config.clip) * free, decayed(rate, count, config), config
            )
            step = admissible(room, world, step, radius) * free
            there = self.loss(world + step)
            accepted = radius == math.inf
            if not accepted:
                accepted, radius = judged_step(here, there, step, radius, config)
            if accepted:
                world, here = world + step, there
            if count % config.project_every == 0:
                world = projected(problem, world)
                here = self.loss(world)
        self.record(label, here, world)
        return world
