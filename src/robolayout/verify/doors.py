"""Doors: who fits through them, and which of them a body does not get to from the first one.

Every door counts. A body that comes in by the first door must get to the landing of every other door that it fits through
and that it gets to in the empty room: what furniture cuts off there is a violation, however little floor lies behind it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import shapely
from shapely import Polygon

from robolayout.scene import ROUNDING, Agent, Room
from robolayout.verify._space import Space, further_doors, met
from robolayout.verify.limits import JUDGE


@dataclass(frozen=True, eq=False)
class ShutDoor:
    """A door that a body does not get to from the first one."""

    number: int  # index of the door
    zone: Polygon  # its landing
    beyond: Polygon  # where the body's centre can be behind it; empty where it cannot even stand in the landing


def shut_doors(room: Room, agent: Agent, space: Space) -> tuple[ShutDoor, ...]:
    """Return the doors that a body fits through and gets to in the empty room, but not in this one."""
    if len(room.doors) < 2:
        return ()
    return tuple(
        ShutDoor(number, zone, met(shapely.get_parts(space.free), zone))
        for number, zone in further_doors(room, agent.radius).items()
        if not any(misfits(room, number, agent)) and space.main.intersection(zone).area <= JUDGE.sliver
    )


def misfits(room: Room, number: int, agent: Agent) -> Iterator[str]:
    """Yield why a body does not fit through a door."""
    door, across = room.doors[number], agent.width or 2 * agent.radius
    if door.width < across - ROUNDING:
        yield f"Door {number} is {door.width:.2f} m wide, {agent.name} needs {across:.2f} m: it cannot come in."
    if door.height < agent.height - ROUNDING:
        yield f"Door {number} is {door.height:.2f} m high, {agent.name} is {agent.height:.2f} m: it cannot come in."
