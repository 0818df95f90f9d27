"""A layout that somebody else made, judged: what is written of it, with no search behind it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from robolayout.planners import FilePlanner, PlanRequest
from robolayout.program import Program, Reconciled, read_program, reconcile
from robolayout.scene import Layout, Scene, Trace
from robolayout.verify import Report, verify


@dataclass(frozen=True)
class Judged:
    """A layout and its report; `write_result` writes it as it writes a run.

    Attributes:
        scene: What was given.
        layout: Poses.
        report: What the verifier says of them.
        program: The statements that were measured; empty if none were given.
        reconciled: The same after the filter.
        trace: Empty: nothing was searched.
    """

    scene: Scene
    layout: Layout
    report: Report
    program: Program = field(default_factory=Program)
    reconciled: Reconciled = field(default_factory=lambda: Reconciled(Program(), ()))
    trace: Trace = field(default_factory=Trace)


def judge(scene: Scene, layout: Layout, program: str | Path | None = None) -> Judged:
    """Judge a layout, whoever made it.

    Args:
        scene: What was given.
        layout: Poses.
        program: File of the program whose statements are measured as well.
    """
    if program is None:
        return Judged(scene, layout, verify(scene, layout))
    asked = read_program(FilePlanner(program).plan(PlanRequest(scene)), scene)
    return Judged(scene, layout, verify(scene, layout, asked), asked, reconcile(asked, scene))
