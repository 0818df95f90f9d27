"""A layout that somebody else made, judged: what is written of it, with no search behind it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from robolayout.planners import FilePlanner, PlanRequest
from robolayout.program import Program, Reconciled, read_program, reconcile
from robolayout.scene import Layout, Scene, Trace
from robolayout.verify import Report, verify
from robolayout.words import read_words


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
    wishes = read_words(scene)
    if program is None:
        asked, reconciled = Program(), Reconciled(Program(), ())
    else:
        asked = wishes.marked(read_program(FilePlanner(program).plan(PlanRequest(scene)), scene))
        reconciled = reconcile(asked, scene)
    report = verify(scene, layout, None if program is None else asked)
    report = report.with_asked(wishes.judged(scene, layout, report.agents[0].navigation.main))
    return Judged(scene, layout, report, asked, reconciled)
