"""Who writes the constraint program: rules without a model, or a model."""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._lazy import loader
from robolayout.planners._types import USELESS as USELESS
from robolayout.planners._types import Critic as Critic
from robolayout.planners._types import Group as Group
from robolayout.planners._types import GroupPlanner as GroupPlanner
from robolayout.planners._types import Judgement as Judgement
from robolayout.planners._types import Pictures as Pictures
from robolayout.planners._types import Planner as Planner
from robolayout.planners._types import PlanRequest as PlanRequest
from robolayout.planners._types import RoomPlanner as RoomPlanner

if TYPE_CHECKING:
    from robolayout.planners.model.feedback import Feedback as Feedback
    from robolayout.planners.model.judge import ModelJudge as ModelJudge
    from robolayout.planners.model.planner import ModelPlanner as ModelPlanner
    from robolayout.planners.model.prompt import poses_text as poses_text
    from robolayout.planners.model.ranking import SampleScore as SampleScore
    from robolayout.planners.model.ranking import score_samples as score_samples
    from robolayout.planners.offline import OfflinePlanner as OfflinePlanner
    from robolayout.planners.sentence import Understanding as Understanding
    from robolayout.planners.sentence import scene_from_sentence as scene_from_sentence

__getattr__ = loader(__name__, __file__)
