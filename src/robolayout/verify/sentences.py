"""Sentences about what an agent cannot do: names, numbers, and what would be needed."""

from __future__ import annotations

from robolayout.verify.navigation import Navigation
from robolayout.verify.use import Usage


def agent_violations(nav: Navigation, usage: Usage) -> tuple[str, ...]:
    """Return what keeps an agent from entering, moving, reaching and using."""
    found = [*body_violations(nav)]
    agent = nav.agent.name
    if nav.walkable_ratio < 0.95 and not nav.main.is_empty:
        parts = len(nav.free.geoms) - 1
        found.append(
            f"{agent} can walk only {nav.walkable_ratio:.0%} of the free floor: {parts} further "
            f"{'part is' if parts == 1 else 'parts are'} cut off."
        )
    found += [unreached_sentence(nav, name) for name in nav.unreached]
    found += [
        f"{name} cannot be used by {agent}: {use.reason}."
        for name, use in usage.uses.items()
        if not use.usable and nav.reached[name]
    ]
    return tuple(found)


def body_violations(nav: Navigation) -> tuple[str, ...]:
    """Return what keeps a body out of the room, whatever the furniture."""
    agent, room = nav.agent, nav.scene.room
    found: list[str] = []
    across = agent.width or 2 * agent.radius
    if room.doors and room.doors[0].width < across - 1e-9:
        found.append(
            f"Door 0 is {room.doors[0].width:.2f} m wide, {agent.name} needs {across:.2f} m: it cannot come in."
        )
    if room.doors and room.doors[0].height < agent.height - 1e-9:
        found.append(
            f"Door 0 is {room.doors[0].height:.2f} m high, {agent.name} is {agent.height:.2f} m: it cannot come in."
        )
    if room.wall_height < agent.height - 1e-9:
        found.append(
            f"The room is {room.wall_height:.2f} m high, {agent.name} is {agent.height:.2f} m: it cannot stand in it."
        )
    if nav.main.is_empty:
        found.append(
            f"{agent.name} (a disc of {2 * agent.radius:.2f} m) cannot stand inside the door: nothing can be reached."
        )
    return tuple(found)


def unreached_sentence(nav: Navigation, name: str) -> str:
    """Return why an asset is not reached: a passage that is too narrow, or an arm that is too short."""
    agent, passage = nav.agent, nav.passages[name]
    needed = 2 * agent.radius
    if passage.width == 0:
        return f"{name} cannot be reached by {agent.name}: there is no way to it, not even for a disc of 1 cm."
    if passage.between and passage.width < needed:
        return (
            f"{name} cannot be reached by {agent.name}: narrowest passage {passage.width:.2f} m, "
            f"needs {needed:.2f} m, between {' and '.join(passage.between)}."
        )
    return (
        f"{name} is out of reach of {agent.name}: {nav.distances[name]:.2f} m from the nearest place to stand, "
        f"reach is {agent.reach:.2f} m."
    )
