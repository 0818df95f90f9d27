"""Planning with a model: one group after the other, feedback and retries, and the offline planner as the last resort."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from robolayout._errors import ModelError, ProgramError
from robolayout.attempt import Attempt, Clock, Progress
from robolayout.planners import Group, GroupPlanner, OfflinePlanner, PlanRequest, feedback_text
from robolayout.program import Guess, Program, read_program
from robolayout.scene import Layout, Pose, Scene
from robolayout.verify import verify

Finish = Callable[[Program, Scene, Mapping[str, Pose]], Attempt]
"""Filters and solves a program for a scene; the poses given stay."""


@dataclass(frozen=True)
class GroupedRun:
    """The loop over groups.

    Attributes:
        scene: What is given.
        planner: Who is asked.
        seed: Settles every choice.
        clock: Where seconds are counted.
        say: Told the name of each phase.
        finish: Filters and solves a program.
    """

    scene: Scene
    planner: GroupPlanner
    seed: int
    clock: Clock
    say: Progress
    finish: Finish

    def run(self, groups: tuple[Group, ...]) -> tuple[Attempt, tuple[Group, ...]]:
        """Plan one group after the other; what is placed stays, and what is said stays said."""
        placed: dict[str, Pose] = {}
        best, done = None, list[Group]()
        for group in groups:
            here = replace(
                self.scene, assets=tuple(a for a in self.scene.assets if a.name in placed or a.name in group.items)
            )
            best, taken_over = self._group(here, group, placed, best)
            note = " The model's answers stayed unusable; the offline planner took over." if taken_over else ""
            done.append(replace(group, rationale=group.rationale + note))
            placed |= dict(best.solution.layout)
        assert best is not None
        if not best.solution.verdict.ok:
            guesses = {name: Guess((p.x, p.y, p.z), p.yaw) for name, p in placed.items()}
            joint = self.finish(replace(best.asked, guesses=guesses), self.scene, {})
            best = min((best, joint), key=lambda attempt: attempt.solution.verdict.merit)
        return best, tuple(done)

    def _group(
        self, here: Scene, group: Group, placed: dict[str, Pose], before: Attempt | None
    ) -> tuple[Attempt, bool]:
        """Ask for one group, tell what was wrong, and ask again; the offline planner takes over if nothing is usable."""
        best: Attempt | None = None
        feedback, previous = "", ""
        for _ in range(1 + self.planner.retries):
            request = PlanRequest(
                self.scene, group, Layout(placed), feedback, self.seed, previous, self._images(here, placed, group)
            )
            with self.clock.station("plan"):
                try:
                    texts = self.planner.plan_many(request, self.planner.samples)
                except ModelError as error:
                    self.say(f"model failed: {error}")
                    break
            found: list[Attempt] = []
            for text in texts:
                try:
                    found.append(self._solved(text, here, group, placed, before))
                except ProgramError as error:
                    previous, feedback = text, feedback_text(error=error)
            if found:
                best = min((best, *found) if best else found, key=lambda attempt: attempt.solution.verdict.merit)
                if best.solution.verdict.ok:
                    break
                report = verify(here, best.solution.layout, best.asked)
                previous = best.asked.text
                feedback = feedback_text(rejections=best.reconciled.rejections, violations=report.violations)
        if best is not None:
            return best, False
        text = OfflinePlanner().plan(PlanRequest(self.scene, group, Layout(placed), seed=self.seed))
        return self._solved(text, here, group, placed, before), True

    def _images(self, here: Scene, placed: dict[str, Pose], group: Group) -> dict[str, bytes]:
        """Return the annotated room as it stands and one picture per new kind of asset."""
        if self.planner.mode == "no_image":
            return {}
        from robolayout.render import annotate, png_bytes, render_asset

        layout = Layout(placed)
        images = {view: png_bytes(annotate(here, layout, view=view)) for view in ("top", "side")}
        kinds = {here.by_name[name].variable: name for name in reversed(group.items)}
        return images | {name: png_bytes(render_asset(here.by_name[name])) for name in sorted(kinds.values())}

    def _solved(
        self, text: str, here: Scene, group: Group, placed: Mapping[str, Pose], before: Attempt | None
    ) -> Attempt:
        """Read, filter and solve a group's program: only what is about it, after what was said before."""
        with self.clock.station("program"):
            self.say("program")
            asked = about(read_program(text, self.scene), group, here, before.asked if before else None)
        return self.finish(asked, here, placed)


def about(program: Program, group: Group, here: Scene, before: Program | None) -> Program:
    """Return what a program says about a group and things already there, after the earlier groups' statements."""
    mine, known = set(group.items), set(here.by_name)
    new = [s for s in program.statements if (names := set(s.relation.asset_names())) & mine and names <= known]
    statements = (*(before.statements if before else ()), *new)
    numbered = tuple(replace(statement, number=i) for i, statement in enumerate(statements, 1))
    return replace(program, statements=numbered, guesses={n: g for n, g in program.guesses.items() if n in mine})
