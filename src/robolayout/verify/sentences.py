"""Sentences about what an agent cannot do: names, numbers, and what would be needed."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import shapely

from robolayout._text import TOLD
from robolayout.verify.limits import Demands
from robolayout.verify.navigation import Navigation, ShutDoor
from robolayout.verify.proofs import exempt_from_reach, impossible, kept_out
from robolayout.verify.use import Usage


def agent_violations(nav: Navigation, usage: Usage, exempt: Mapping[str, str], demands: Demands) -> tuple[str, ...]:
    """Return what keeps an agent from entering, moving, reaching and using; nothing that is not asked of it."""
    agent = nav.agent.name
    found = list(impossible(nav.scene, nav.agent))
    aside = exempt_from_reach(nav.scene, nav.agent)
    wanted = [name for name in nav.unreached if name not in aside]
    if nav.main.is_empty:
        found += [_blocked_sentence(nav)] if not kept_out(nav.scene, nav.agent) else []
        found += [f"{agent} reaches none of {', '.join(wanted)}."] if wanted else []
    else:
        if nav.walkable_ratio < demands.walkable_ratio:
            parts = len(nav.free.geoms) - 1
            found.append(
                f"{agent} can walk only {nav.walkable_ratio:.0%} of the free floor: {parts} further "
                f"{'part is' if parts == 1 else 'parts are'} cut off."
            )
        found += [_shut_sentence(nav, door) for door in nav.shut_doors]
        found += [unreached_sentence(nav, name) for name in wanted]
    found += [
        f"{name} cannot be used by {agent}: {use.reason}."
        for name, use in usage.uses.items()
        if not use.usable and nav.reached[name] and name not in exempt
    ]
    return tuple(found)


def _blocked_sentence(nav: Navigation) -> str:
    """Return what keeps a body out of a room that it could enter if it were empty."""
    zone, wide = nav.space.door, 2 * nav.agent.radius
    if zone is None:
        return f"{nav.agent.name} (a disc of {wide:.2f} m) has no place to stand: the furniture leaves none."
    near = nav.blocking.rows[shapely.distance(nav.blocking.shapes, zone) < nav.agent.radius]
    names = " and ".join(nav.boxes.names[row] for row in np.unique(near)[: TOLD.named])
    return f"{nav.agent.name} (a disc of {wide:.2f} m) cannot come in: the landing of door 0 is blocked by {names}."


def _shut_sentence(nav: Navigation, door: ShutDoor) -> str:
    """Return which door is cut off, by what, and what lies beyond it."""
    agent, passage, needed = nav.agent.name, nav.door_passages[door.number], 2 * nav.agent.radius
    wall = nav.scene.room.doors[door.number].wall
    none = "no way to it, not even for a disc of 1 cm"
    width = none if passage.cut_off else f"narrowest passage {passage.width:.2f} m"
    between = passage.sides or " and ".join(nav.shutting(door)[: TOLD.named])
    found = f"Door {door.number} in wall {wall} cannot be reached by {agent}: {width}, needs {needed:.2f} m"
    found += f", between {between}." if between else "."
    if door.beyond.is_empty:
        return f"{found} Its landing leaves {agent} no place to stand."
    area = door.beyond.buffer(nav.agent.radius).area
    only = ", ".join(nav.only_behind(door))
    return f"{found} {area:.1f} m2 of floor{f' and {only}' if only else ''} can then be reached only from there."


def unreached_sentence(nav: Navigation, name: str) -> str:
    """Return why an asset is not reached: a passage that is too narrow, or an arm that is too short."""
    agent, passage = nav.agent, nav.passages[name]
    needed = 2 * agent.radius
    if passage.cut_off:
        return f"{name} cannot be reached by {agent.name}: there is no way to it, not even for a disc of 1 cm."
    if passage.between and passage.width < needed:
        return (
            f"{name} cannot be reached by {agent.name}: narrowest passage {passage.width:.2f} m, "
            f"needs {needed:.2f} m, between {passage.sides}."
        )
    return (
        f"{name} is out of reach of {agent.name}: {nav.distances[name]:.2f} m from the nearest place to stand, "
        f"reach is {agent.reach:.2f} m."
    )
