"""The independent judge: physics, navigation, use and semantics of a finished layout, measured exactly with Shapely."""

from robolayout.verify.agent_report import AgentReport as AgentReport
from robolayout.verify.agent_report import judge_agent as judge_agent
from robolayout.verify.heading import Drive as Drive
from robolayout.verify.heading import heading_space as heading_space
from robolayout.verify.limits import Demands as Demands
from robolayout.verify.navigation import Navigation as Navigation
from robolayout.verify.navigation import navigation as navigation
from robolayout.verify.passages import Passage as Passage
from robolayout.verify.physics import physics as physics
from robolayout.verify.proofs import exempt_from_reach as exempt_from_reach
from robolayout.verify.proofs import kept_out as kept_out
from robolayout.verify.proofs import overfull as overfull
from robolayout.verify.report import AgentSpec as AgentSpec
from robolayout.verify.report import Report as Report
from robolayout.verify.report import verify as verify
from robolayout.verify.rules import RULES as RULES
from robolayout.verify.use import horizontal_reach as horizontal_reach
from robolayout.verify.use import usage as usage
