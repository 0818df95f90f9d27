"""A layout with everything that is known of it: what a run made, or what somebody else made, judged; and a run's clock."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from robolayout._errors import InputError, ModelError
from robolayout.program import Program, Reconciled, read_program, reconcile
from robolayout.run.given import as_text
from robolayout.scene import Layout, Scene, Snapshot, Trace, load_layout
from robolayout.verify import Report, verify
from robolayout.words import read_words

if TYPE_CHECKING:
    from robolayout.planners import Group, ModelJudge
    from robolayout.run.answers import Sample
    from robolayout.solve import Solution

Progress = Callable[[str], None]  # told the name of each phase as it begins
SOUND = {"CF": 100.0, "IB": 100.0}
"""Percent of the things that overlap nothing, and that are inside the room, in a plausible room (LayoutVLM's rule)."""


@dataclass(frozen=True)
class Attempt:
    """One program and what came of it."""

    asked: Program  # the program as the planner wrote it
    reconciled: Reconciled  # the same after the filter
    solution: Solution  # what the solver made of it

    def denied(self, report: Report) -> bool:
        """Whether nothing is unmet in its report but what users ask and the filter rejects, which no other plan can mend."""
        rejected = {
            one.statement.number for one in self.reconciled.decisions if one.kept is None and one.statement.by == "user"
        }
        unmet = {one.number for one in report.statements if not one.met}
        return bool(unmet) and rejected >= unmet and len(report.violations) == len(unmet)


def joined_traces(traces: Iterable[Trace]) -> Trace:
    """Return the record of searches that followed each other."""
    losses: list[Mapping[str, float]] = []
    snapshots: list[Snapshot] = []
    for trace in traces:
        snapshots += [replace(snapshot, step=snapshot.step + len(losses)) for snapshot in trace.snapshots]
        losses += trace.losses
    return Trace(tuple(losses), tuple(snapshots))


class Clock:
    """Collects wall and CPU seconds by station."""

    def __init__(self) -> None:
        self.seconds: dict[str, dict[str, float]] = {}

    @contextmanager
    def station(self, name: str) -> Generator[None]:
        """Add the seconds of a block to a station."""
        wall, cpu = time.perf_counter(), time.process_time()
        try:
            yield
        finally:
            spent = self.seconds.setdefault(name, {"wall": 0.0, "cpu": 0.0})
            spent["wall"] += time.perf_counter() - wall
            spent["cpu"] += time.process_time() - cpu


@dataclass(frozen=True)
class Result:
    """A layout and its report, with all that a run made of it."""

    scene: Scene = field(repr=False)  # what was given
    layout: Layout  # poses
    report: Report  # what the verifier says of them
    program: Program = field(default_factory=Program, repr=False)  # what it says, as asked; empty if there was none
    # the same after the filter, with a decision for every statement
    reconciled: Reconciled = field(default_factory=lambda: Reconciled(Program(), ()), repr=False)
    groups: tuple[Group, ...] = field(default=(), repr=False)  # the planner's groups, in order
    # what the solver says of its run; None where somebody else made the layout
    solution: Solution | None = field(default=None, repr=False)
    # every answer of a model, with its score; empty without a model
    samples: tuple[Sample, ...] = field(default=(), repr=False)

    @property
    def trace(self) -> Trace:
        """The record of the search; empty unless asked for."""
        return self.solution.trace if self.solution else Trace()

    def to_frame(self) -> Any:
        """Return a pandas DataFrame with one row per asset (see `Report.to_frame`)."""
        return self.report.to_frame()

    def _repr_html_(self) -> str:
        """Return the plan for the first agent beside the short report, for notebooks."""
        from robolayout.page.marks import plan_marks
        from robolayout.render import plan_svg

        first = self.report.agents[0]
        plan = plan_svg(self.scene, self.layout, navigation=plan_marks(first), agent=first.agent)
        shown = self.report.to_html()
        return f'<div style="display:flex;flex-wrap:wrap;gap:2em;align-items:flex-start">{plan}<div>{shown}</div></div>'


def judge(scene: Scene, layout: Layout, program: Program | str | Path | None = None) -> Result:
    """Judge a layout, whoever made it, by a program if one is given: itself, its text, or its file as a `Path`."""
    wishes, said = read_words(scene), Program()
    if program is not None:
        said = wishes.marked(read_program(as_text(program), scene))
    report = verify(scene, layout, None if program is None else said)
    report = replace(report, asked=wishes.judged(scene, report.layout, report.agents[0].navigation.main))
    return Result(scene, report.layout, report, said, reconcile(said, scene))


def load_judged(
    path: Path, scene: Scene | None, read_scene: Callable[[str], Scene], program: Path | None = None
) -> Result:
    """Judge the layout of a run's folder, or a layout file for a scene that is given.

    The statements measured are those of a program's file; of a folder its own, if none is given.
    """
    folder = path if path.is_dir() else None
    if scene is None:
        if folder is None or not (folder / "scene.json").exists():
            raise InputError(
                f"{path} is not the folder of a run (it has no scene.json): name one, or give the scene with --scene."
            )
        scene = read_scene(str(folder / "scene.json"))
        own = folder / "program.py"
        program = program or (own if own.exists() else None)
    return judge(scene, load_layout(path if folder is None else folder / "layout.json", scene), program)


def scored(judged: Result, model: ModelJudge) -> Result:
    """Return a judged layout with a model's scores in its report; where no vote comes, with the reason."""
    from robolayout.run.sight import finished_pictures

    report = judged.report
    valid = SOUND.items() <= report.metrics["LayoutVLM"].items() and all(report.physics.placed.values())
    images = finished_pictures(judged.scene, judged.layout, model.pictures)
    try:
        found = model.opinion(judged.scene, judged.layout, images, valid=valid).to_dict()
    except ModelError as error:
        found = {"sentences": [f"No model scored the room: {error}"]}
    return replace(judged, report=replace(report, opinion=found))
