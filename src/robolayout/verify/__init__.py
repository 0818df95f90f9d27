"""The independent judge: physics, navigation, use and semantics of a finished layout, measured exactly with Shapely."""

from robolayout.verify.drives import Drive, find_drives
from robolayout.verify.heading import HeadingSpace, heading_space
from robolayout.verify.moves import Move
from robolayout.verify.navigation import Navigation, navigation
from robolayout.verify.passages import Passage
from robolayout.verify.physics import Collision, Obstruction, Physics, PhysicsLimits, physics
from robolayout.verify.proofs import Remedies, exempt_from_reach, exempt_from_use, impossible, kept_out, remedies
from robolayout.verify.report import AgentReport, Demands, Report, StatementResult
from robolayout.verify.routes import Route
from robolayout.verify.use import Usage, Use, horizontal_reach, usage
from robolayout.verify.verify import judge_agent, verify

__all__ = [
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
    "physics",
    "remedies",
    "usage",
    "verify",
]
