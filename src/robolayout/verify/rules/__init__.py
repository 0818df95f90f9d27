"""Named rules of accessibility, measured in a layout: each met or not, with its source.

They stand beside the general judgement and do not change it. The figures of the ADA were checked against the text of the 2010
Standards for Accessible Design; those of ISO 21542 could not be, and say so. Rules speak of a finished building: what a
layout of boxes does not tell (handles, thresholds, how a door swings) is left out.
"""

from __future__ import annotations

import tomllib
from importlib.resources import files

from robolayout.verify.agent_report import AgentReport
from robolayout.verify.rules import _measures
from robolayout.verify.rules._rule import Rule
from robolayout.verify.rules._rule import RuleResult as RuleResult

_DATA = tomllib.loads((files(__name__) / "rules.toml").read_text(encoding="utf-8"))

RULES = tuple(Rule(name, vars(_measures)[name], **entry) for name, entry in _DATA.items())
"""All named rules, in the order of the report; each is measured by the function of its name."""


def rule_results(body: AgentReport) -> tuple[RuleResult, ...]:
    """Return what came of every rule that concerns a body and speaks of something in the room."""
    found = ((rule, rule.measure(body)) for rule in RULES if rule.is_for(body.agent))
    return tuple(RuleResult(rule, body.agent.name, measured) for rule, measured in found if measured is not None)
