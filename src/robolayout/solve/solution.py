"""What every solver returns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from robolayout.scene import Layout, Snapshot, Trace
from robolayout.solve.judge import Verdict

Progress = Callable[[str], None]
"""Told the name of each phase as it begins."""


def silent(_phase: str) -> None:
    """Tell nobody."""


@dataclass(frozen=True)
class Solution:
    """What a solver found."""

    layout: Layout  # poses of all assets
    verdict: Verdict  # what the judge says of it
    status: str  # "solved", or "unmet" if demands are left
    message: str  # the status as a sentence
    phase: str = ""  # what made the winning layout: "guess", "push", "polish", ...; empty where a solver does not say
    trace: Trace = field(default_factory=Trace, repr=False)  # losses and poses on the way; empty unless asked for


def snapshot(step: int, label: str, layout: Layout) -> Snapshot:
    """Return where everything is at a step of a phase."""
    return Snapshot(step, label, {name: (pose.x, pose.y, pose.yaw) for name, pose in layout.items()})


def conclude(layout: Layout, verdict: Verdict, trace: Trace, phase: str = "") -> Solution:
    """Return a layout with its status in a word and in a sentence."""
    if verdict.ok:
        return Solution(layout, verdict, "solved", "Every demand and every statement is met.", phase, trace)
    parts = [
        f"{verdict.hard:g} hard violations" if verdict.hard else "",
        f"{verdict.access:.2f} of access missing" if verdict.access else "",
        f"statements of weight {verdict.soft:g} unmet" if verdict.soft else "",
    ]
    text = ", ".join(part for part in parts if part)
    return Solution(layout, verdict, "unmet", f"Budget spent with {text}; the report names them.", phase, trace)
