"""The independent judge: physics, navigation, use and semantics of a finished layout, measured exactly with Shapely."""

from robolayout.verify.agent_report import AgentReport
from robolayout.verify.drives import Drive, find_drives
from robolayout.verify.heading import HeadingSpace, heading_space
from robolayout.verify.limits import Demands, PhysicsLimits
from robolayout.verify.moves import Move
from robolayout.verify.navigation import Navigation, navigation
from robolayout.verify.passages import Passage
from robolayout.verify.physics import Collision, Obstruction, Physics, physics
from robolayout.verify.proofs import (
    Remedies,
    exempt_from_reach,
    exempt_from_use,
    impossible,
    kept_out,
    overfull,
    remedies,
)
from robolayout.verify.report import Report, StatementResult
from robolayout.verify.routes import Route
from robolayout.verify.rules import RULES, RuleResult
from robolayout.verify.use import Usage, Use, horizontal_reach, usage
from robolayout.verify.verify import judge_agent, verify

__all__ = [
    "RULES",
    "AgentReport",
    "Collision",
    "Demands",
    "Drive",
    "HeadingSpace",
    "Move",
    "Navigation",
    "Obstruction",
    "Passage",
    "Physics",
    "PhysicsLimits",
    "Remedies",
    "Report",
    "Route",
    "RuleResult",
    "StatementResult",
    "Usage",
    "Use",
    "exempt_from_reach",
    "exempt_from_use",
    "find_drives",
    "heading_space",
    "horizontal_reach",
    "impossible",
    "judge_agent",
    "kept_out",
    "navigation",
    "overfull",
    "physics",
    "remedies",
    "usage",
    "verify",
]
