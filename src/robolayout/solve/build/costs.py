"""What a furnished room may cost, and how long it is tried."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Costs:
    """What a furnished room may cost, and how long it is tried."""

    unreached: float = 8.0  # cost of an asset that the agent cannot get to
    cut_off: float = 40.0  # cost of all of the free floor being out of the agent's way
    inexact: float = 30.0  # cost of a place where something touches, by the exact check
    shut: float = 18.0  # cost of a place where a door or drawer does not open
    spread: int = 12  # places tried all over the room: of a circle, of a block with no good one among the best
    checked: int = 300  # best places that are checked exactly before one is taken
    trials: int = 8  # places for which it is found out what they cut off
    close: float = 0.3
    widen: float = 0.04
    """Metres between places of which both are tried, and how much more for each one that did harm."""
    harmless: float = 0.8  # cost of what a place cuts off below which it is taken at once
    hopeless: float = 6.0  # cost for each thing of a grid above which they are rather placed one by one
    moves: int = 3  # most times in one attempt that things are moved once more
    singles: int = 3
    """Most single things that are tried in another place, and most unreached things that are given room."""
    around: tuple[int, int] = (3, 6)  # how many things around one that is not reached are placed anew together
    nowhere: float = 50.0  # cost of a cluster for which there is no place at all
    bad: float = 2.5  # cost above which a place counts as bad enough to try something else
    shares: tuple[float, float, float, float] = (1.0, 0.85, 0.7, 0.5)
    """Shares of a set of equal things for which a grid is tried; the rest stands where it can."""
    block: int = 3  # things of which walls are the first place that stand free in a grid, at least
    tight: float = 1.2
    ragged: float = 1.0
    """Cost of a grid whose neighbours touch, and of each place that its last row leaves empty."""
    much: float = 10.0  # cost of a place above which a cluster rather comes apart
    stray: float = 2.0
    """Cost of each thing that is left over from its grid; rows are worth more than each thing's own best place."""
    shuffle: float = 0.35  # standard deviation of the turns of kinds from one attempt to the next, in places
    noise: float = 0.1  # cost by which places vary from one attempt to the next
    mood: float = 0.5  # standard deviation of the logarithm by which wishes vary from one attempt to the next
    otherwise: float = 0.6  # cost of standing in a way that nothing says
    # cost of what belongs at a thing and stands at another side of it, or by itself; and of rows that could have their backs at walls
    elsewhere: float = 2.5


COSTS = Costs()
