"""Who writes the constraint program: rules without a model, a model, or a file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._lazy import loader
from robolayout.planners._types import (
    USELESS,
    Critic,
    Group,
    GroupPlanner,
    Judgement,
    Pictures,
    Planner,
    PlanRequest,
    RoomPlanner,
)

if TYPE_CHECKING:
    from robolayout.planners.file import FilePlanner
    from robolayout.planners.model.feedback import Feedback
    from robolayout.planners.model.judge import ModelJudge
    from robolayout.planners.model.planner import ModelPlanner
    from robolayout.planners.model.prompt import poses_text
    from robolayout.planners.model.ranking import SampleScore, score_samples
    from robolayout.planners.offline import OfflinePlanner
    from robolayout.planners.sentence import Understanding, scene_from_sentence

__getattr__ = loader(__name__, __file__)

__all__ = [
    "USELESS",
    "Critic",
    "Feedback",
    "FilePlanner",
    "Group",
    "GroupPlanner",
    "Judgement",
    "ModelJudge",
    "ModelPlanner",
    "OfflinePlanner",
    "Pictures",
    "PlanRequest",
    "Planner",
    "RoomPlanner",
    "SampleScore",
    "Understanding",
    "poses_text",
    "scene_from_sentence",
    "score_samples",
]
