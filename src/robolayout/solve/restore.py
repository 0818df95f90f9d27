"""Restore: what the search moved without need goes back to where the program had it, or the room was built."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import product

import numpy as np

from robolayout._geometry import compose
from robolayout.scene import Room
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.proposals import carry
from robolayout.solve.stage import relative

SAME = 1e-9
"""Metres, or parts of a unit heading vector, below which a thing has not moved."""

STRAIGHT, ASKEW = math.radians(0.5), math.radians(45.0)
"""Angles off a wall's between which a thing counts as having come to stand askew."""

PULL = 0.05
"""Metres by which a rug comes along with what is squared on it."""

GAIN, AGAIN = 0.01, 3
"""Metres (`Problem.away`) that putting a thing back must be worth, and times that single things are tried once more at the most."""


Way = tuple[float, float, bool]
"""How a thing goes back: how much of the way along its front and across it, and whether it also turns back."""

WAYS: tuple[Way, ...] = (
    (1.0, 1.0, True),
    (1.0, 1.0, False),
    (1.0, 0.0, False),
    (0.0, 1.0, False),
    (0.7, 0.7, False),
    (0.4, 0.4, False),
    (0.0, 0.0, True),
)
"""The ways in which single things go back, the first that is no worse counts."""


def restored(
    problem: Problem, world: Floats, no_worse: Callable[[Floats], bool], trials: int, groups: Sequence[set[int]] = ()
) -> Floats:
    """Return poses (n, 4) with as much as possible where the program's guess has it, or where the room was built.

    Everything that moved is put back at once, else half of it, and so on down to single things with what stands on them
    and what goes by them (a desk with its chair), so that a row that had to give way in one place stays a row elsewhere. Then
    single things go back, the farthest first: whole, else along one of their axes, else a part of the way; where they may not go
    alone, what goes by them (`groups`) comes along.

    At most `trials` layouts are asked about while groups are put back, and three in each of seven ways for each thing. `no_worse` says of
    poses whether they are no worse than those kept so far.
    """
    target = problem.start
    moved = np.abs(world - target).max(axis=1) > SAME
    units = [unit for unit in _units(problem) if moved[unit].any()]
    waiting = [units] if units else []
    for _ in range(trials):
        if not waiting:
            break
        chunk = waiting.pop()
        slots = [slot for unit in chunk for slot in unit]
        trial = world.copy()
        trial[slots] = target[slots]
        if no_worse(trial):
            world = trial
        elif len(chunk) > 1:
            half = len(chunk) // 2
            waiting += [chunk[half:], chunk[:half]]
    return _each_back(problem, world, WAYS, no_worse, groups)


def once_more(problem: Problem, world: Floats, no_worse: Callable[[Floats], bool]) -> Floats:
    """Return poses (n, 4) with single things whole back where they were, as long as some can go: others may have made room since."""
    for _ in range(AGAIN):
        before, world = world, _each_back(problem, world, WAYS[:1], no_worse)
        if world is before:
            break
    return world


def _each_back(
    problem: Problem,
    world: Floats,
    ways: Sequence[Way],
    no_worse: Callable[[Floats], bool],
    groups: Sequence[set[int]] = (),
) -> Floats:
    """Return poses (n, 4) with single things nearer to where they were, the farthest first."""
    off = np.hypot(*(world - problem.start)[:, :2].T)
    moved = (np.abs(world - problem.start).max(axis=1) > SAME).tolist()
    free = [slot for slot, name in enumerate(problem.names) if moved[slot] and name not in problem.pinned]
    for slot in sorted(free, key=lambda slot: (-float(off[slot]), slot)):
        world = _nearer(problem, world, slot, ways, no_worse, frozenset(groups[slot] if groups else ()))
    return world


def askew(room: Room, yaw: float) -> float:
    """Return the radians by which a heading is a little off the nearest wall's or across it; 0 where it is straight or far off."""
    walls = (math.atan2(*wall.direction[::-1]) for wall in room.walls)
    off = min((math.remainder(yaw - wall, math.pi / 2) for wall in walls), key=abs)
    return off if STRAIGHT < abs(off) < ASKEW else 0.0


def _came_askew(problem: Problem, world: Floats, slot: int) -> float:
    """Return the radians by which a thing came to stand askew; 0 of what is meant to stand so."""
    off = askew(problem.scene.room, math.atan2(world[slot, 3], world[slot, 2]))
    name = problem.names[slot]
    meant = name in problem.guessed and math.dist(problem.start[slot, 2:], world[slot, 2:]) < SAME
    return 0.0 if meant or name in problem.pinned else off


def squared(problem: Problem, world: Floats, no_worse: Callable[[Floats], bool]) -> Floats:
    """Return poses (n, 4) in which what came to stand a little askew is square to a wall again.

    Where it has to look at something, it also slides sideways until it looks straight at it; where it would leave its rug, the
    rug comes along a little. What cannot turn alone turns with all that is askew by the same angle: two sofas that face each
    other. What the program has askew stays so.
    """
    for slot in range(len(problem.names)):
        if not (off := _came_askew(problem, world, slot)):
            continue
        turned = compose(world[slot], np.array([0.0, 0.0, math.cos(off), -math.sin(off)]))
        mine = [(other, row) for one, other, row in problem.pairs if one == slot]
        rugs = [other for other, row in mine if row.moves == "b"]
        looked_at = [other for other, row in mine if row.look is not None]
        aims = world[looked_at] * (1.0, 1.0, 0.0, 0.0) + (0.0, 0.0, 1.0, 0.0)
        slides = (0.0, *relative(turned, aims)[:, 1].tolist())
        for slide, pull in product(slides, (0.0, PULL) if rugs else (0.0,)):
            trial = world.copy()
            carry(problem, trial, slot, compose(turned, np.array([0.0, slide, 1.0, 0.0])))
            for rug in rugs:
                away = trial[slot, :2] - world[rug, :2]
                trial[rug, :2] += away * min(1.0, pull / max(float(np.hypot(*away)), SAME))
            if no_worse(trial):
                world = trial
                break
    offs = {slot: _came_askew(problem, world, slot) for slot, parent in enumerate(problem.parent) if parent < 0}
    for angle in dict.fromkeys(round(math.degrees(off)) for off in offs.values() if off):
        slots = [slot for slot, off in offs.items() if round(math.degrees(off)) == angle]
        if len(slots) < 2:
            continue
        off, middle = offs[slots[0]], np.array([*world[slots, :2].mean(axis=0), 1.0, 0.0])
        trial, turned = world.copy(), compose(middle, np.array([0.0, 0.0, math.cos(off), -math.sin(off)]))
        for slot in slots:
            carry(problem, trial, slot, compose(turned, relative(middle, world[slot])))
        world = trial if no_worse(trial) else world
    return world


def _nearer(
    problem: Problem,
    world: Floats,
    slot: int,
    ways: Sequence[Way],
    no_worse: Callable[[Floats], bool],
    followers: frozenset[int],
) -> Floats:
    """Return poses (n, 4) with one thing as far back as it may go in one go, in the first of some ways.

    What stands on it goes along, or stays where it is if the thing is under it there, too; else what goes by it comes along.
    """
    here, there = world[slot], problem.start[slot]
    off = relative(here, there)
    away = problem.away(world)
    for along, across, turned in ways:
        least = away - (GAIN if (along, across, turned) != WAYS[0] else SAME)
        trial, alone, heading = world.copy(), world.copy(), there if turned else here
        pose = compose(here, np.array([along * off[0], across * off[1], 1.0, 0.0]))
        alone[slot] = np.concatenate([pose[:2], heading[2:]])
        carry(problem, trial, slot, alone[slot])
        tries = [trial, *[alone] * (slot in problem.parent), *[world.copy()] * bool(followers)]
        if followers:
            carry(problem, tries[-1], slot, alone[slot], followers)
        for one in tries:
            if problem.away(one) < least and no_worse(one):
                return one
    return world


def _units(problem: Problem) -> list[list[int]]:
    """Return the slots that may move, each with what stands on it and what goes by it and leads nothing."""
    leaders: dict[int, list[int]] = {}
    for a, b, _ in problem.pairs:
        leaders.setdefault(a, []).append(b)
    leading = {slot for found in leaders.values() for slot in found}

    def root(slot: int) -> int:
        while problem.parent[slot] >= 0:
            slot = int(problem.parent[slot])
        if slot in leading or slot not in leaders:
            return slot
        here = problem.start[slot, :2]
        return min(leaders[slot], key=lambda other: (math.dist(here, problem.start[other, :2]), other))

    units: dict[int, list[int]] = {}
    for slot, name in enumerate(problem.names):
        if name not in problem.pinned:
            units.setdefault(root(slot), []).append(slot)
    return [units[key] for key in sorted(units)]
