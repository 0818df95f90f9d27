"""Proofs: what no layout can achieve, what is not asked of a body, and the smallest change that would help.

Two kinds of claim are kept apart. `impossible` holds for every layout of the scene and follows from sizes alone. `remedies`
is about this layout: the smallest sets of assets whose removal lets the agent reach what it does not reach, found by
trying them with the very check that failed.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._text import TOLD, listed
from robolayout.assets import place_of
from robolayout.scene import ROUNDING, Agent, Asset, Layout, Opening, Pose, Room, Scene
from robolayout.verify._boxes import landings, prism_table, room_polygon
from robolayout.verify._obstacles import NOTHING
from robolayout.verify._space import disc_space, reached_by
from robolayout.verify.limits import FINE, JUDGE
from robolayout.verify.navigation import Navigation, beyond_height, misfits
from robolayout.verify.passages import largest
from robolayout.verify.use import usage

HEIGHTS = np.arange(0.02, 1.5, 0.01)  # metres above the floor at which it is counted what all things fill


@dataclass(frozen=True)
class Remedies:
    """What would let an agent reach everything in this layout."""

    # for each unreached asset the smallest sets of assets whose removal, with all that stands on them, lets the agent
    # reach it; none where not even a pair would do
    removals: Mapping[str, tuple[tuple[str, ...], ...]]
    # pairs of things (assets, or "wall 2") that stand too close together, and how many metres are missing
    gaps: Mapping[tuple[str, ...], float]
    largest_disc: float  # diameter in metres of the largest disc that reaches every asset it is asked to reach
    # metres by which the agent's own diameter exceeds that; 0 or less where it is not the width that fails
    margin: float

    def sentences(self, agent: Agent) -> tuple[str, ...]:
        """Return the smallest changes in words, one sentence per set of remedies."""
        groups: dict[tuple[tuple[str, ...], ...], list[str]] = {}
        for name, sets in self.removals.items():
            groups.setdefault(sets, []).append(name)
        found: list[str] = []
        for sets, names in groups.items():
            ways = ", or without ".join(" and ".join(group) for group in sets)
            elsewhere = (
                f"if {'it' if len(names) == 1 else 'they'} stood elsewhere, by more than two removals or a longer reach"
            )
            change = f"without {ways}" if sets else f"only {elsewhere}"
            found.append(f"{agent.name} would reach {' and '.join(names)} {change}.")
        for (left, right), missing in self.gaps.items():
            found.append(f"{left} and {right} stand {missing:.2f} m too close together for {agent.name}.")
        if self.removals and self.margin > 0:
            found.append(
                f"As it stands a disc of {self.largest_disc:.2f} m reaches everything; {agent.name} is "
                f"{self.margin:.2f} m wider."
            )
        return tuple(found)


def exempt_from_reach(scene: Scene, agent: Agent) -> dict[str, str]:
    """Return which assets a body is not asked to reach, in any layout, and why.

    What lies about is counted, never asked for. A body without an arm is asked to get to what stands on the floor only.
    """
    lying = {a.name: f"{a.name} is one of the things that lie about" for a in scene.assets if a.lies_about}
    if agent.reach_distance is not None:
        return lying
    return lying | {
        asset.name: f"{agent.name} has no arm and {asset.name} does not stand on the floor"
        for asset in scene.assets
        if not (asset.on_floor or asset.on_ceiling)
    }


def exempt_from_use(scene: Scene, agent: Agent, used: Container[str] = ()) -> dict[str, str]:
    """Return which assets a body is not asked to use, in any layout, and why.

    Those it is not asked to reach, and what can only stand on the floor and ends below the heights that its arm gets to, or
    cannot be used even in an empty room.

    Args:
        scene: The scene.
        agent: The body.
        used: Names of what it uses in some layout, so that it can in an empty room.
    """
    lying = exempt_from_reach(scene, agent)
    asked = [asset for asset in scene.assets if asset.name not in lying]
    return lying | {asset.name: why for asset in asked if (why := why_unused(asset, agent, used=asset.name in used))}


def why_unused(asset: Asset, agent: Agent, *, used: bool = False) -> str:
    """Return why a body that is asked to reach an asset is not asked to use it; empty where it is. See `exempt_from_use`."""
    hung = not asset.on_floor or asset.on_wall or asset.on_object or asset.is_flat
    if agent.reach_distance is None or hung:
        return ""
    down_to = agent.reach_low
    if agent.shoulder_height is not None:
        down_to = max(down_to, agent.shoulder_height - agent.reach)
    if asset.size[2] < down_to - ROUNDING:
        return f"{asset.name} ends {asset.size[2]:.2f} m high and {agent.name} reaches down to {down_to:.2f} m"
    if used:
        return ""
    why = _reason_alone(replace(asset, name="it", description=""), replace(agent, turning_radius=None))
    return f"{asset.name} cannot be used by {agent.name} in an empty room: {why}" if why else ""


def kept_out(scene: Scene, agent: Agent) -> tuple[str, ...]:
    """Return what keeps a body out of the room even if that is empty, each with its proof in numbers."""
    room, floor, radius = scene.room, room_polygon(scene.room), agent.radius
    found = list(misfits(room, 0, agent)) if room.doors else []
    if room.wall_height < agent.height - ROUNDING:
        high = f"The room is {room.wall_height:.2f} m high, {agent.name} is {agent.height:.2f} m"
        found.append(f"{high}: it cannot stand in it.")
    if floor.buffer(-radius).is_empty:
        wide = 2 * float(shapely.maximum_inscribed_circle(floor, 1e-3).length)
        fits = f"the largest disc that fits into the empty room is {wide:.2f} m wide"
        found.append(f"{agent.name} needs {2 * radius:.2f} m; {fits}.")
    elif not found and not _enters(room, radius):
        widest = 2e-3 * largest(lambda step: _enters(room, step * 1e-3), int(radius * 1e3))
        found.append(
            f"Even in the empty room {agent.name} cannot come in by door 0: the room leaves a disc of {widest:.2f} m the way "
            f"in, {agent.name} needs {2 * radius:.2f} m."
        )
    return tuple(found)


def _enters(room: Room, radius: float) -> bool:
    """Tell whether a disc comes in if the room is empty."""
    return not disc_space(room, NOTHING, radius).main.is_empty


def impossible(scene: Scene, agent: Agent) -> tuple[str, ...]:
    """Return what no layout of this scene can achieve for an agent, each with its proof in numbers."""
    return (*kept_out(scene, agent), *overfull(scene))


@lru_cache(maxsize=1024)
def _reason_alone(asset: Asset, agent: Agent) -> str:
    """Return why a body cannot use a thing that stands on the floor, with nothing around it; empty where it can."""
    half = max(asset.size[:2]) / 2 + 2 * agent.circumradius + agent.reach + FINE.spare
    door = Opening(0, half - agent.radius - 0.1, 2 * agent.radius + 0.2, agent.height + 0.1)
    room = Room(((0.0, 0.0), (2 * half, 0.0), (2 * half, 2 * half), (0.0, 2 * half)), agent.height + 1.0, (door,))
    layout = Layout({asset.name: Pose(half, half, asset.size[2] / 2, 0.0)})
    found = usage(Scene(room, (asset,)).with_agents(agent), layout, agent)
    return "" if found.usable[asset.name] else found.uses[asset.name].reason


def overfull(scene: Scene) -> tuple[str, ...]:
    """Return why the floor is too small for what must stand on it, whatever the layout, and what would help; else nothing.

    Counted is what can only stand on the floor, rugs and what may also stand on other things or hang aside, with what it fills at
    that height at which all together fill most: no two can be there in one place.
    """
    floor = room_polygon(scene.room)
    standing = [a for a in scene.assets if place_of(a) == "floor" and not a.is_flat]
    filled = np.array([_filled(asset) for asset in standing]).reshape(len(standing), len(HEIGHTS))
    fills = dict(zip(standing, filled[:, int(filled.sum(axis=0).argmax())].tolist(), strict=True))
    standing.sort(key=lambda asset: -fills[asset])
    needed = sum(fills.values())
    clear = float(shapely.union_all(landings(scene.room)).intersection(floor).area) if scene.room.doors else 0.0
    room = floor.buffer(JUDGE.boundary).area - clear + JUDGE.area * len(standing)  # what the judge tolerates
    if needed <= max(room, floor.area - clear):
        return ()
    left = needed - np.cumsum([fills[asset] for asset in standing])
    many = int(np.argmax(left <= floor.area - clear)) + 1
    out = [asset.name for asset in standing[:many]]
    areas: dict[str, list[float]] = {}
    for asset in standing:
        areas.setdefault(asset.category, []).append(fills[asset])
    most = sorted(areas.items(), key=lambda item: -sum(item[1]))[: TOLD.named]
    taken = ", ".join(f"{len(each)} x {kind} ({sum(each):.2f} m2)" for kind, each in most)
    return (
        f"The {len(standing)} assets that stand on the floor cover {needed:.2f} m2, the floor outside door landings has "
        f"{floor.area - clear:.2f} m2: they cannot all stand apart. Most is taken by {taken}. Leave out "
        f"{listed(out)}, or give the room {math.ceil(10 * (needed + clear)) / 10:.1f} m2 or more.",
    )


@lru_cache(maxsize=1024)
def _filled(asset: Asset) -> NDArray[np.float64]:
    """Return how many square metres an asset that stands on the floor fills at each of `HEIGHTS`."""
    rings, low, high = prism_table(asset)
    slack = JUDGE.height - 1e-9
    there = (low[:, None] + slack <= HEIGHTS) & (high[:, None] - slack >= HEIGHTS)
    sets, which = np.unique(there, axis=1, return_inverse=True)
    areas = [shapely.union_all(shapely.polygons(rings[some])).area if some.any() else 0.0 for some in sets.T]
    return np.array(areas)[which.reshape(-1)]


def remedies(nav: Navigation) -> Remedies:
    """Return the smallest changes to this layout that would let an agent reach what it does not reach."""
    aside = exempt_from_reach(nav.scene, nav.agent)
    largest = min((p.width for name, p in nav.passages.items() if name not in aside), default=0.0)
    wanted = [] if kept_out(nav.scene, nav.agent) else [name for name in nav.unreached if name not in aside]
    wanted = [name for name in wanted if not beyond_height(nav, name)]  # what is too high is helped by no removal
    narrow = [nav.passages[name] for name in wanted if len(set(nav.passages[name].between)) == 2]
    return Remedies(
        removals=_removals(nav, wanted),
        gaps={(a, b): 2 * nav.agent.radius - p.width for p in narrow for a, b in [sorted(p.between)]},
        largest_disc=largest,
        margin=2 * nav.agent.radius - largest,
    )


def _removals(nav: Navigation, wanted: Sequence[str]) -> dict[str, tuple[tuple[str, ...], ...]]:
    """Return the smallest sets, of one or else of two, without which each of these is reached; each set is tried once."""
    found, feet = nav.boxes, nav.boxes.footprints
    every = sorted(set(nav.blocking.rows.tolist()))
    below = [found.chain(row) for row in range(len(found.names))]
    tried: dict[tuple[int, ...], NDArray[np.bool_]] = {}

    def reached(removed: tuple[int, ...], row: int) -> bool:
        """Tell whether an asset is reached without some others; no once all trials are used up."""
        if removed not in tried and len(tried) < FINE.trials:
            kept = {other for other in every if not below[other].intersection(removed)}
            space = disc_space(nav.scene.room, nav.blocking.of(kept), nav.agent.radius)
            tried[removed] = reached_by(found, space, nav.agent.reach)
        return removed in tried and bool(tried[removed][row])

    def helpful(row: int) -> list[tuple[int, ...]]:
        rows = np.array([other for other in every if other not in below[row]], dtype=np.intp)
        near = np.sort(rows[np.argsort(shapely.distance(feet[rows], feet[row]), kind="stable")][: FINE.neighbours])
        single = [group for group in itertools.combinations(rows.tolist(), 1) if reached(group, row)]
        return single or [group for group in itertools.combinations(near.tolist(), 2) if reached(group, row)]

    sets = {name: helpful(found.names.index(name)) for name in wanted}
    return {name: tuple(tuple(found.names[row] for row in group) for group in groups) for name, groups in sets.items()}
