"""What a named rule is, and what came of it for one body."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from robolayout.scene import Agent
from robolayout.verify.agent_report import AgentReport


@dataclass(frozen=True)
class Measured:
    """What was measured for a rule."""

    met: bool  # the verdict
    value: float  # the figure that decides, in the rule's unit
    text: str  # the measurement in words


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
