"""The independent judge: physics, navigation, use and semantics of a finished layout, measured exactly with Shapely."""

from robolayout.verify.navigation import Navigation, navigation
from robolayout.verify.passages import Passage
from robolayout.verify.physics import Collision, Obstruction, Physics, PhysicsLimits, physics
from robolayout.verify.report import AgentReport, Demands, Report, StatementResult
from robolayout.verify.routes import Route
from robolayout.verify.use import Usage, Use, usage
from robolayout.verify.verify import judge_agent, verify

__all__ = [
    "AgentReport",
    "Collision",
    "Demands",
    "Navigation",
    "Obstruction",
    "Passage",
    "Physics",
    "PhysicsLimits",
    "Report",
    "Route",
    "StatementResult",
    "Usage",
    "Use",
    "judge_agent",
    "navigation",
    "physics",
    "usage",
    "verify",
]
