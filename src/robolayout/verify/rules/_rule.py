"""What a named rule is, and what came of it for one body."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from robolayout.scene import Agent
from robolayout.verify.agent_report import AgentReport

WHEELCHAIR = ("wheelchair",)
"""Words in the name or title of a body that sits in a wheelchair."""

MOBILITY_AID = (*WHEELCHAIR, "walker", "rollator", "scooter")
"""The same for all who move with an aid: what is asked of ways and doors concerns them too."""


@dataclass(frozen=True)
class Measured:
    """What was measured for a rule.

    Attributes:
        met: The verdict.
        value: The figure that decides, in the rule's unit.
        text: The measurement in words.
    """

    met: bool
    value: float
    text: str


@dataclass(frozen=True)
class Rule:
    """One named rule of a standard; it stands beside the general judgement and does not change it.

    Attributes:
        name: Its name ("turning_space").
        source: The standard and the section.
        asks: What it asks, in words.
        limit: What the figure is compared with.
        unit: Unit of the figure.
        concerns: Words, one of which is in the name or title of the bodies that it is for.
        measure: Measures it; None where there is nothing that it speaks of.
        verified: Whether the number was checked against the text of the standard.
    """

    name: str
    source: str
    asks: str
    limit: float
    unit: str
    concerns: tuple[str, ...]
    measure: Callable[[AgentReport], Measured | None]
    verified: bool = True

    def is_for(self, agent: Agent) -> bool:
        """Whether it concerns a body."""
        return any(word in f"{agent.name} {agent.title}".lower() for word in self.concerns)


@dataclass(frozen=True)
class RuleResult:
    """What came of a rule for one body.

    Attributes:
        rule: The rule.
        agent: Name of the body.
        measured: What was measured.
    """

    rule: Rule
    agent: str
    measured: Measured

    @property
    def met(self) -> bool:
        """The verdict."""
        return self.measured.met

    def to_dict(self) -> dict[str, Any]:
        """Return plain data."""
        rule, found = self.rule, self.measured
        return {
            "name": rule.name,
            "agent": self.agent,
            "source": rule.source,
            "verified": rule.verified,
            "asks": rule.asks,
            "met": found.met,
            "value": found.value,
            "limit": rule.limit,
            "unit": rule.unit,
            "text": found.text,
        }
