"""What a model thinks of a finished room, beside what the judge measures."""

from __future__ import annotations

from dataclasses import replace

from robolayout._errors import ModelError
from robolayout.planners import ModelJudge
from robolayout.run.judged import Judged
from robolayout.run.sight import finished_pictures

SOUND = {"CF": 100.0, "IB": 100.0}
"""Percent of the things that overlap nothing, and that are inside the room, in a plausible room (LayoutVLM's rule)."""


def scored(judged: Judged, model: ModelJudge) -> Judged:
    """Return a judged layout with a model's scores in its report; where no vote comes, with the reason."""
    report = judged.report
    valid = SOUND.items() <= report.metrics["LayoutVLM"].items() and all(report.physics.placed.values())
    images = finished_pictures(judged.scene, judged.layout, model.pictures)
    try:
        found = model.opinion(judged.scene, judged.layout, images, valid=valid).to_dict()
    except ModelError as error:
        found = {"sentences": [f"No model scored the room: {error}"]}
    return replace(judged, report=report.with_opinion(found))
