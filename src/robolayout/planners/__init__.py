"""Who writes the constraint program: rules without a model, a model, or a file."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from robolayout.planners._types import USELESS, Critic, Group, GroupPlanner, Judgement, Pictures, Planner, PlanRequest

if TYPE_CHECKING:
    from robolayout.planners.file import FilePlanner
    from robolayout.planners.model.feedback import Feedback
    from robolayout.planners.model.judge import ModelJudge
    from robolayout.planners.model.planner import ModelPlanner
    from robolayout.planners.model.prompt import poses_text
    from robolayout.planners.model.ranking import Score, score_samples
    from robolayout.planners.offline import OfflinePlanner
    from robolayout.planners.sentence import Understanding, scene_from_sentence

_LAZY = {
    "FilePlanner": "file",
    "ModelJudge": "model.judge",
    "ModelPlanner": "model.planner",
    "OfflinePlanner": "offline",
    "Score": "model.ranking",
    "Understanding": "sentence",
    "Feedback": "model.feedback",
    "poses_text": "model.prompt",
    "scene_from_sentence": "sentence",
    "score_samples": "model.ranking",
}

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
    "Score",
    "Understanding",
    "poses_text",
    "scene_from_sentence",
    "score_samples",
]


def __getattr__(name: str) -> Any:
    """Load a planner when it is first asked for."""
    if name not in _LAZY:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_LAZY[name]}"), name)
