"""Figures of the ADA Standards of 2010 in metres, each with its section, and what is ours where they say nothing."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Ada:
    """Figures of the ADA Standards of 2010 in metres, each with its section, and what is ours where they say nothing."""

    knee_height: float = 0.685  # height of room for knees (306.3.3)
    knee_width: float = 0.76  # its width (306.3.5)
    toe_height: float = 0.23  # height up to which room is for toes (306.2.1)
    toe_depth: float = 0.43  # how deep it is (306.2.3)
    deep: float = 0.28  # depth of room for knees at `toe_height` (306.3.3)
    shallow: float = 0.205  # its depth at `knee_height`; between them it shrinks evenly (306.3.4)
    contact: float = 1e-3  # by which room is measured more kindly: rounding decides nothing
    floor: tuple[float, float] = (0.76, 1.22)  # width and length of a clear floor space (305.3)
    low: float = 0.38  # height from which on an unobstructed reach goes, forwards and sideways (308.2.1)
    high: float = 1.22  # height where it ends (308.3.1)
    over_height: float = 0.865  # height of what one may have to reach over sideways (308.3.2)
    over_depth: float = 0.61  # depth of that (308.3.2)
    full_depth: float = 0.255  # depth up to which the reach ends at full height (308.3.2)
    high_over: float = 1.17  # height where it ends beyond that (308.3.2)
    between: float = 2.0  # from a bed's side within which another bed makes the floor between them serve both; ours
    named: int = 5  # things that a measurement names
    route: float = 0.915  # clear width of a route (403.5.1)
    pinch: float = 0.815  # down to which it may narrow for a short way (403.5.1)
    pinch_length: float = 0.61  # length of such a way (403.5.1)
    pinch_apart: float = 1.22  # between two of them (403.5.1)
    circle: float = 1.525  # diameter of a turning circle, and side of the square around a T-shaped space (304.3)
    arm: float = 0.915  # width of arms and base of that (304.3.2)
    base: float = 0.61  # length of its base (304.3.2)
    interval: float = 61.0  # length of route after which a passing space is asked for (403.5.3)
    turns: int = 16  # headings at which a T-shaped turning space is looked for
    close: float = 1e-3  # length of a way that is nothing
    fine: float = 0.005  # to which the largest turning circle is measured


ADA = Ada()
