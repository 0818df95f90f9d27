"""Named rules of accessibility, measured in a layout: each met or not, with its source.

They stand beside the general judgement and do not change it. The figures of the ADA were checked against the text of the 2010
Standards for Accessible Design; those of ISO 21542 could not be, and say so. Rules speak of a finished building: what a
layout of boxes does not tell (handles, thresholds, how a door swings) is left out.
"""

from __future__ import annotations

from robolayout.verify.agent_report import AgentReport
from robolayout.verify.rules._places import bed_transfer, floor_space, knee_room, reach_over, reach_range
from robolayout.verify.rules._rule import MOBILITY_AID, WHEELCHAIR, Measured, Rule, RuleResult
from robolayout.verify.rules._ways import (
    door_width,
    door_width_iso,
    passing_space,
    route_width,
    turning_space,
    turning_space_iso,
)

__all__ = ["RULES", "Measured", "Rule", "RuleResult", "rule_results"]

_ADA = "ADA 2010"
_ISO = "ISO 21542:2011"

RULES: tuple[Rule, ...] = (
    Rule(
        "route_width",
        f"{_ADA}, 403.5.1",
        "routes are 0.915 m wide, or 0.815 m for at most 0.61 m, 1.22 m apart",
        0.915,
        "m",
        MOBILITY_AID,
        route_width,
    ),
    Rule("door_width", f"{_ADA}, 404.2.3", "doors are 0.815 m wide", 0.815, "m", MOBILITY_AID, door_width),
    Rule(
        "door_width_iso",
        f"{_ISO}, doors",
        "doors are 0.80 m wide",
        0.8,
        "m",
        MOBILITY_AID,
        door_width_iso,
        verified=False,
    ),
    Rule(
        "turning_space",
        f"{_ADA}, 304.3",
        "there is a circle of 1.525 m to turn in, or a T in a square of that size",
        1.525,
        "m",
        MOBILITY_AID,
        turning_space,
    ),
    Rule(
        "turning_space_iso",
        f"{_ISO}, turning",
        "there is a circle of 1.50 m to turn in",
        1.5,
        "m",
        MOBILITY_AID,
        turning_space_iso,
        verified=False,
    ),
    Rule(
        "passing_space",
        f"{_ADA}, 403.5.3",
        "routes narrower than 1.525 m have a passing space every 61 m",
        61.0,
        "m",
        MOBILITY_AID,
        passing_space,
    ),
    Rule(
        "floor_space",
        f"{_ADA}, 305.3 and 305.5",
        "a clear floor of 0.76 x 1.22 m adjoins a side of what is used, along it or straight towards it",
        0.0,
        "things without",
        WHEELCHAIR,
        floor_space,
    ),
    Rule(
        "bed_transfer",
        f"{_ADA}, 806.2.3",
        "a clear floor of 0.76 x 1.22 m lies along both sides of a bed, or one between two beds",
        2.0,
        "sides",
        WHEELCHAIR,
        bed_transfer,
    ),
    Rule(
        "reach_range",
        f"{_ADA}, 308.2.1 and 308.3.1",
        "what is used is within 0.38 to 1.22 m of height",
        0.0,
        "m beyond",
        WHEELCHAIR,
        reach_range,
    ),
    Rule(
        "reach_over",
        f"{_ADA}, 308.3.2",
        "one reaches over at most 0.61 m at 0.865 m of height, up to 1.22 m high (1.17 m beyond 0.255 m)",
        0.61,
        "m",
        WHEELCHAIR,
        reach_over,
    ),
    Rule(
        "knee_room",
        f"{_ADA}, 306.3",
        "under a table one sits at is room for knees: 0.685 m high, 0.28 m deep, 0.76 m wide",
        0.76,
        "m",
        WHEELCHAIR,
        knee_room,
    ),
)
"""All named rules, in the order of the report."""


def rule_results(body: AgentReport) -> tuple[RuleResult, ...]:
    """Return what came of every rule that concerns a body and speaks of something in the room."""
    found = ((rule, rule.measure(body)) for rule in RULES if rule.is_for(body.agent))
    return tuple(RuleResult(rule, body.agent.name, measured) for rule, measured in found if measured is not None)
