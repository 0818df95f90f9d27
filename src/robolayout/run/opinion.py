"""What a model thinks of a finished room, beside what the judge measures."""

from __future__ import annotations

from dataclasses import replace

from robolayout._errors import ModelError
from robolayout.planners import ModelJudge
from robolayout.run.judged import Judged
from robolayout.run.sight import finished_pictures

SOUND = 100.0
"""Percent of the things that must overlap nothing and be inside the room for a room to count as plausible."""


def scored(judged: Judged, model: ModelJudge) -> Judged:
    """Return a judged layout with a model's scores in its report; where no vote comes, with the reason."""
    report = judged.report
    valid = set(report.metrics["LayoutVLM"].values()) >= {SOUND} and all(report.physics.placed.values())
    images = finished_pictures(judged.scene, judged.layout, model.pictures)
    try:
        found = model.opinion(judged.scene, images, valid=valid).to_dict()
    except ModelError as error:
        found = {"sentences": [f"No model scored the room: {error}"]}
    return replace(judged, report=report.with_opinion(found))
