"""The judge's limits: every number that decides whether something counts as met, in one frozen place.

What the nouns themselves define stands with them: the depth of a landing with the room, the height of a rug with the asset,
touching distance with the agent.
"""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class JudgeConfig:
    """When something counts as touching, carried, steady, near or moved."""

    area: float = 1e-4  # square metres of intersection in plan that still count as touching (DESIGN section 4)
    height: float = 0.01  # shared height in metres above which two assets collide (DESIGN section 4)
    boundary: float = 0.01  # metres that a box may stick out of the room, in plan and in height (DESIGN section 4)
    at: float = 0.30  # metres within which a movable thing (a chair) stands at another (a table)
    carried: float = 0.02  # metres between an asset and the surface that carries it (DESIGN section 4)
    # metres by which what carries something begins below it, so that no two things carry each other
    lower: float = 1e-3
    # metres, or the share of its shorter side where that is less, by which the centre of mass of a thing lies within what
    # carries it
    steady: tuple[float, float] = (0.005, 0.05)
    loop: tuple[float, float] = (0.01, 0.02)  # half depth and half width of the loop by which a thing hangs from a hook
    within: float = 0.005  # metres by which a thing may reach over the edge of a surface and still lie in it
    sliver: float = 1e-8  # square metres below which a piece of free space is numerical dust
    # metres by which a body's centre may be further from an asset than its radius, and yet be said to touch it
    touch: float = 0.02
    along: float = math.radians(30.0)  # angle between a body's heading and an edge up to which it is beside that
    far: float = 3.0  # metres from a side beyond which no place to stand is looked for
    wide: float = 1.5  # metres of clear width beyond which a passage is not called narrow any more
    still: float = 0.01  # metres up to which a thing counts as where the program put it: its numbers are rounded
    straight: float = 1.0  # degrees up to which it does


@dataclass(frozen=True)
class FinenessConfig:
    """How finely, and how often, the judge looks."""

    quad_segs: int = 16  # chords per quarter turn in every round corner
    step: float = 0.005  # metres between the radii of passages that are tried; a width is known to twice that
    # metres of clear width beyond what the agent needs from which the place of a passage is not looked for
    located: float = 0.5
    headings: int = 8  # headings in half a turn, after which a rectangle looks the same: a lattice of 22.5 degrees
    turn: float = 0.5  # metres of detour that a turn by one heading is worth
    inside: float = 1e-4  # metres that a spot to turn on lies inside the place for it, against rounding
    aims: int = 3  # how often the end of a route is moved to the place nearest to its last corner
    # metres to which corners of the free space are rounded: of two that differ by rounding nobody tells left from right
    grain: float = 1e-7
    neighbours: int = 12  # obstacles nearest to an unreached asset that are tried in pairs (66 pairs of 12)
    trials: int = 400  # sets of assets that are tried in all, some 4 ms each with 40 assets
    spare: float = 1.0  # metres that an empty room is wider than a thing with the body at full reach on both sides


JUDGE, FINE = JudgeConfig(), FinenessConfig()


@dataclass(frozen=True)
class Demands:
    """What a layout must achieve for `Report.ok`; every other share must be 1."""

    walkable_ratio: float = 0.95  # smallest walkable ratio
    statements_met_share: float = 0.95  # smallest share of statements met


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
