"""Named rules of accessibility, measured in a layout: each met or not, with its source.

They stand beside the general judgement and do not change it. The figures of the ADA were checked against the text of the 2010
Standards for Accessible Design; those of ISO 21542 could not be, and say so. Rules speak of a finished building: what a
layout of boxes does not tell (handles, thresholds, how a door swings) is left out.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

from robolayout.scene import Agent
from robolayout.verify.agent_report import AgentReport
from robolayout.verify.rules import _measures
from robolayout.verify.rules._measures import Measured


@dataclass(frozen=True)
class Rule:
    """One named rule of a standard; it stands beside the general judgement and does not change it."""

    name: str  # its name ("turning_space")
    measure: Callable[[AgentReport], Measured | None]  # measures it; None where there is nothing that it speaks of
    source: str  # the standard and the section
    asks: str  # what it asks, in words
    limit: float  # what the figure is compared with
    unit: str  # unit of the figure
    concerns: list[str]  # words, one of which is in the name or title of the bodies that it is for
    verified: bool = True  # whether the number was checked against the text of the standard

    @property
    def origin(self) -> str:
        """Its source in words, with whether that was checked."""
        return self.source + ("" if self.verified else " (not checked at its source)")

    def is_for(self, agent: Agent) -> bool:
        """Whether it concerns a body."""
        return any(word in f"{agent.name} {agent.title}".lower() for word in self.concerns)


@dataclass(frozen=True)
class RuleResult:
    """What came of a rule for one body."""

    rule: Rule
    agent: str  # name of the body
    measured: Measured  # what was measured

    @property
    def met(self) -> bool:
        """The verdict."""
        return self.measured.met

    def to_dict(self) -> dict[str, Any]:
        """Return plain data."""
        rule, found = self.rule, self.measured
        return {
            "name": rule.name, "agent": self.agent, "source": rule.source, "verified": rule.verified,
            "asks": rule.asks, "met": found.met, "value": found.value, "limit": rule.limit, "unit": rule.unit,
            "text": found.text,
        }  # fmt: skip


_DATA = tomllib.loads((files(__name__) / "rules.toml").read_text(encoding="utf-8"))

RULES = tuple(Rule(name, vars(_measures)[name], **entry) for name, entry in _DATA.items())
"""All named rules, in the order of the report; each is measured by the function of its name."""


def rule_results(body: AgentReport) -> tuple[RuleResult, ...]:
    """Return what came of every rule that concerns a body and speaks of something in the room."""
    found = ((rule, rule.measure(body)) for rule in RULES if rule.is_for(body.agent))
    return tuple(RuleResult(rule, body.agent.name, measured) for rule, measured in found if measured is not None)
