"""Every number of the floor that is a choice."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FloorConfig:
    """How finely the floor is looked at, and what it costs to take it from those who walk."""

    planned_cell: float = 0.04  # metres per cell of the floor on which a plan is made
    planned_cells: int = 40_000  # most cells of it; larger rooms get coarser ones, here and below
    door_depth: float = 0.9  # metres before a door that a plan keeps free, in rooms below `small_room`
    wide_door_depth: float = 1.1  # the same in larger ones
    small_room: float = 12.0  # square metres from which on a room is no longer small
    # how much the floor before a door should stay free, against 1 for what stands in front of things
    door_want: float = 2.0
    route_cells: int = 12_000  # most cells of the grid on which routes are planned: 30 m2 at 5 cm, 120 m2 at 10 cm
    walked_cell: float = 0.1  # metres per cell of the floor that is left to walk on while a room is built
    walked_cells: int = 60_000  # most cells of it
    coarse: int = 3  # every how many cells are looked at first: most things are seen to be within reach from these
    spare: float = 0.15  # metres of clearance beyond what the body needs that are still told apart
    chair_at: float = 0.30  # metres within which a chair stands at a thing, as the verifier has it
    short_of: float = 0.03  # metres that a body is asked to get nearer to a thing than its reach
    nearest: float = 2.5  # cells beyond a body's radius from a thing at which the first may be on which it can stand
    use_spacing: float = 0.08  # metres between the cells of a plan from which a use is looked for
    onward: float = 0.6  # metres about the places of a use in which a body may go on to it where chairs were
    # cost of a metre walked per metre of clearance that is missing, against 1 for a free metre
    push_price: float = 25.0
    route_margin: float = 0.03  # metres of clearance asked of routes beyond the radius: half a cell, and what a step of the search may lose
    route_spacing: float = 0.10  # metres between the points of a route that become demands
    nearby: float = 0.30  # metres beyond what is asked within which things are told to keep it
    pocket: float = 0.05  # square metres of free space cut off from the door that get a route of their own
    cut: float = 40.0  # cost of cutting off all the floor, or of shutting a door
    lost: float = 4.0  # cost of each thing that is out of reach from then on


FLOOR = FloorConfig()
"""The one set of these numbers in use."""
