"""The judge's limits: every number that decides whether something counts as met, in one frozen place.

What the nouns themselves define stands with them: the depth of a landing with the room, the height of a rug with the asset,
touching distance with the agent.
"""

from __future__ import annotations

from dataclasses import dataclass

AREA_TOLERANCE = 1e-4  # square metres of intersection in plan that still count as touching (DESIGN section 4)
AT = 0.30  # metres within which a movable thing (a chair) stands at another (a table)
CARRIED = 0.02  # metres between an asset and the surface that carries it (DESIGN section 4)
LOWER = 1e-3  # metres by which what carries something begins below it, so that no two things carry each other
STEADY = (0.005, 0.05)
"""Metres, or the share of its shorter side where that is less, by which the centre of mass of a thing lies within what
carries it."""

LOOP = ((0.01, -0.02), (0.01, 0.02), (-0.01, 0.02), (-0.01, -0.02))
"""Corners in metres, about its middle, of the loop by which a thing hangs from a hook."""

WITHIN = 0.005  # metres by which a thing may reach over the edge of a surface and still lie in it
REACH_SLACK = 1e-6  # metres of rounding that a distance may be above the reach
SLIVER = 1e-8  # square metres below which a piece of free space is numerical dust


@dataclass(frozen=True)
class Demands:
    """What a layout must achieve for `Report.ok`; every other share must be 1."""

    walkable_ratio: float = 0.95  # smallest walkable ratio
    statements_met_share: float = 0.95  # smallest share of statements met


@dataclass(frozen=True)
class PhysicsLimits:
    """Tolerances of the physical checks; the defaults are the definitions of DESIGN section 4."""

    # shared footprint in m2 above which two assets collide, or an asset stands in a landing
    area: float = AREA_TOLERANCE
    height: float = 0.01  # shared height in metres above which two assets collide
    boundary: float = 0.01  # metres that a box may stick out of the room, in plan and in height
    support: float = CARRIED  # metres between an asset and what holds it
    door_height: float = 2.0  # metres below which nothing may stand in a landing
