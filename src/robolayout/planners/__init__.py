"""Who writes the constraint program: rules without a model, a model, or a file."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from robolayout.planners._types import Group, Planner, PlanRequest

if TYPE_CHECKING:
    from robolayout.planners.file import FilePlanner
    from robolayout.planners.offline import OfflinePlanner
    from robolayout.planners.sentence import Understanding, scene_from_sentence

_LAZY = {
    "FilePlanner": "file",
    "OfflinePlanner": "offline",
    "Understanding": "sentence",
    "scene_from_sentence": "sentence",
}

__all__ = [
    "FilePlanner",
    "Group",
    "OfflinePlanner",
    "PlanRequest",
    "Planner",
    "Understanding",
    "scene_from_sentence",
]


def __getattr__(name: str) -> Any:
    """Load a planner when it is first asked for."""
    if name not in _LAZY:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_LAZY[name]}"), name)
