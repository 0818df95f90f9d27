"""`robolayout generate`: from a scene file, or one sentence, to an output folder."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass, fields, replace
from pathlib import Path
from shutil import copytree
from typing import TYPE_CHECKING, Annotated

import typer
from typer import Argument, Option

from robolayout._errors import InputError
from robolayout._files import write_atomic
from robolayout._text import TOLD, file_name, pretty
from robolayout.cli import options
from robolayout.cli.terminal import say, show, warn

if TYPE_CHECKING:
    from robolayout.many.variety import Plan
    from robolayout.planners import Planner, Understanding
    from robolayout.run.folder import RunFolder
    from robolayout.run.result import Result
    from robolayout.scene import Scene


OF_A_MODEL = ("mode", "samples", "retries", "critic", "max_cost", "timeout", "thinking", "fallback", "at_once")
"""What is asked of a model, and means nothing without one."""


@dataclass(frozen=True, kw_only=True)
class Who:
    """Who plans."""

    program: Annotated[Path | None, Option(help="Use this constraint program instead of planning.")] = None
    knowledge: options.KnowledgeOption = None
    model: Annotated[str | None, Option(help="Let a model plan: openai:gpt-4o, ollama:llava, ...")] = None
    mode: Annotated[str, Option(help="grouped, one_shot, no_image or no_constraint (with --model).")] = "grouped"
    samples: Annotated[int, Option(min=1, max=16, help="Programs asked for per group.")] = 1
    retries: Annotated[int, Option(min=0, max=10, help="Further questions per group.")] = 3
    critic: Annotated[bool, Option("--critic", help="Let the model rate the room and amend it once.")] = False
    base_url: options.BaseUrlOption = None
    max_cost: options.MaxCostOption = None
    timeout: Annotated[float, Option(help="Seconds to wait for a model's answer.")] = 60.0
    thinking: Annotated[str | None, Option(help="How much a model thinks first: minimal, low, medium or high.")] = None
    fallback: Annotated[list[str] | None, Option(help="A model to ask where the first fails; may be repeated.")] = None
    at_once: Annotated[int | None, Option(min=1, max=64, help="Most questions at the same time.")] = None
    cache: Annotated[bool, Option(help="Ask the provider to keep what all questions share.")] = True
    replay: options.ReplayOption = None

    def __post_init__(self) -> None:
        """Refuse what excludes each other, before any work."""
        if self.program is not None and self.asks_a_model:
            raise InputError("--program and --model (or --base-url, --replay) exclude each other: give one of them.")
        if self.knowledge and (self.program is not None or self.asks_a_model):
            raise InputError(
                "--knowledge is for the offline planner: leave it out, or leave --program and --model out."
            )
        if not self.asks_a_model:
            chosen = {one.name: getattr(self, one.name) not in (one.default, []) for one in fields(Who)}
            options.need("--model", {name: chosen[name] for name in OF_A_MODEL})
        if self.knowledge:
            self.by_rules()

    @property
    def asks_a_model(self) -> bool:
        """Whether a model plans, or a recording of one."""
        return bool(self.model or self.base_url or self.replay)

    def by_rules(self) -> Planner:
        """Return the offline planner, with the user's own knowledge."""
        from robolayout.planners import OfflinePlanner

        return OfflinePlanner(self.knowledge or ())

    def planner(self, run: RunFolder, seed: int) -> Planner:
        """Return the planner of one run."""
        if not self.asks_a_model:
            return self.by_rules()
        from robolayout.planners import ModelPlanner  # and with it pydantic, which takes 60 ms

        given = {one.name: getattr(self, one.name) for one in fields(Who) if one.name not in ("program", "knowledge")}
        given |= {"fallback": tuple(self.fallback or ()), "exchanges": self._exchanges(run), "seed": seed}
        return ModelPlanner(**given)

    def _exchanges(self, run: RunFolder) -> Path | None:
        """Return where answers are recorded; None where a run replays its own, which are taken over as they are."""
        from robolayout.run.folder import ANSWERS

        folder = run.path / ANSWERS
        if self.replay is None or self.replay.resolve() != (run.target / ANSWERS).resolve():
            return folder
        if self.replay.is_dir():
            copytree(self.replay, folder)
        return None


@dataclass(frozen=True, kw_only=True)
class Call(options.ForBody, Who, options.Told):
    """What is asked of one call: what to lay out, how to look for it, what to write, and where."""

    scene: Annotated[str, Argument(metavar="SCENE", help="A scene file (JSON), or one sentence in quotes.")]
    variants: Annotated[int, Option(min=1, max=64, help="Different rooms for one sentence or scene file.")] = 1
    constraints: options.ConstraintsOption = None

    seed: options.SeedOption = 0
    starts: Annotated[int, Option(min=1, max=256, help="Starts of the search.")] = 16
    solver: Annotated[str, Option(help="default, paper, paper-unrefined, trust-constr or dual-annealing.")] = "default"
    effort: Annotated[str, Option(help="How long to search: quick, normal or thorough.")] = "normal"
    start: Annotated[
        Path | None, Option("--from", help="Mend this layout with the least change instead of planning.")
    ] = None
    keep: Annotated[str, Option(help="With --from: what does not move at all, names and commas.")] = ""
    free: Annotated[str, Option(help="With --from: all that may move, names and commas.")] = ""
    dress: Annotated[
        str | None, Option(help="Small things left about: none, some or full; the scene's own if not given.")
    ] = None

    out: Annotated[Path | None, Option(help="Output folder; out/<scene> if not given.")] = None
    pictures: Annotated[bool, Option(help="Draw plan, views, animation.")] = True
    export: Annotated[str, Option(help="Further formats, separated by commas.")] = ""
    walk: Annotated[bool, Option("--walk", help="Also draw the body on its round: walk.gif.")] = False
    settle: Annotated[bool, Option("--settle", help="Let gravity act in MuJoCo (extra `sim`).")] = False


@options.spread
def generate(asked: Call) -> None:
    """Lay out a scene, verify it, and write layout, report, pictures and GLB."""
    from robolayout.run.given import names_a_file

    _check(asked)
    given = None
    if names_a_file(asked.scene):
        given = asked.read(asked.scene, asked.knowledge or (), quiet=asked.quiet)
    whole = asked.out or Path("out") / (file_name(given.name) if given else "scene")
    met = True
    before: list[Plan] = []
    for variant in range(asked.variants):
        with _output(whole if asked.variants == 1 else whole / f"variant-{variant}") as run:
            result = _different(asked, given, run, variant, before)
            with asked.progress() as tell:
                result, files = _written(asked, result, run, tell)
        _tell(asked, result, run, files)
        met = met and result.report.ok
    raise typer.Exit(0 if met else 1)


def _different(asked: Call, given: Scene | None, run: RunFolder, variant: int, before: list[Plan]) -> Result:
    """Return a room that is not much like the variants before it: of a few draws the first one, else the most different."""
    from robolayout.many.variety import VARIETY, Plan, nearest, things

    found: list[tuple[tuple[bool, float], Plan, Result, Understanding | None]] = []
    for draw in range(VARIETY.draws if variant and not asked.asks_a_model else 1):
        number = variant + draw * asked.variants
        planner = asked.planner(run, asked.seed + number)
        room, understood = (given, None) if given else _furnished(asked, planner, number)
        result = _laid_out(asked, room, planner, asked.seed + number)
        plan = Plan(things(result.scene, result.layout))
        apart = nearest(plan, list(enumerate(before)))[0]
        found.append(((result.report.ok, min(apart, VARIETY.varied)), plan, result, understood))
        if found[-1][0] == (True, VARIETY.varied):
            break
    worth, plan, result, understood = max(found, key=lambda one: one[0])
    if understood is not None:
        if not asked.quiet:
            for line in understood.sentences():
                warn(line)
        write_atomic(run.path / "understood.json", pretty(understood.to_dict()))
    if variant and worth[1] < VARIETY.least:
        warn(
            f"{run.target.name} is much like another variant (difference {worth[1]:.2f}); say less of the room to get others."
        )
    before.append(plan)
    return result


def _check(asked: Call) -> None:
    """Refuse what is unknown or missing before any work, and read the user's constraints."""
    from robolayout.export import find_exporter, simulator
    from robolayout.scene import check_dress

    for name in options.names(asked.export):
        find_exporter(name)
    if asked.settle:
        simulator()
    if asked.dress is not None:
        check_dress(asked.dress)
    options.read_constraints(asked.constraints)


@contextmanager
def _output(folder: Path) -> Generator[RunFolder]:
    """Open the output folder, and say where a model's answers are if the run fails."""
    from robolayout.run.folder import open_folder

    run: RunFolder | None = None
    try:
        with open_folder(folder) as run:
            yield run
    finally:
        if run is not None and run.answers is not None:
            warn(f"the answers so far are in {run.answers}.")


def _furnished(asked: Call, planner: Planner, variant: int) -> tuple[Scene, Understanding]:
    """Return the scene of a sentence, and what was understood: by the model that plans, else by rules."""
    from robolayout.run.given import furnished

    return furnished(
        asked.scene,
        planner,
        seed=asked.seed,
        variant=variant,
        agents=asked.agents,
        knowledge=asked.knowledge or (),
        assets=asked.asset_dir,
    )


def _laid_out(asked: Call, room: Scene, planner: Planner, seed: int) -> Result:
    """Lay one room out."""
    from robolayout.run.flow import generate as arrange
    from robolayout.solve import SolverConfig

    if any(asset.path is not None for asset in room.assets):
        from robolayout.assets import check_meshes

        check_meshes(room)
    with asked.progress() as tell:
        return arrange(
            room,
            program=asked.program,
            planner=planner,
            seed=seed,
            solver=asked.solver,
            config=SolverConfig(starts=asked.starts, trace=asked.pictures).at(asked.effort),
            start=asked.start,
            keep=options.names(asked.keep),
            free=options.names(asked.free),
            dress=asked.dress,
            progress=tell,
        )


def _written(asked: Call, result: Result, run: RunFolder, tell: Callable[[str], None]) -> tuple[Result, list[Path]]:
    """Write the files of a run, after asking gravity if so wished, and walk.gif; return the run and the files."""
    from robolayout.run.outputs import write_files

    if asked.settle:
        from robolayout.export import settle

        tell("settle")
        found = settle(result.scene, result.layout).to_dict()
        result = replace(result, report=replace(result.report, stability=found))
    tell("write")
    files = write_files(result, run, pictures=asked.pictures, formats=options.names(asked.export))
    if asked.walk:
        from robolayout.page.marks import plan_marks
        from robolayout.render import walk_gif

        first = result.report.agents[0]
        try:
            data = walk_gif(result.scene, result.layout, plan_marks(first), ways=first.ways, agent=first.agent)
        except InputError as error:
            warn(f"no walk.gif: {error}")
        else:
            files.append(write_atomic(run.path / "walk.gif", data))
    return result, files


def _tell(asked: Call, result: Result, run: RunFolder, files: list[Path]) -> None:
    """Say what came of one room."""
    who = result.report.planner
    for warning in who.get("warnings", ()):
        warn(f"warning: {warning}")
    if run.kept and not asked.quiet:
        more = f" and {len(run.kept) - TOLD.kept} more" if len(run.kept) > TOLD.kept else ""
        warn(f"kept in {run.target} what no run wrote: {', '.join(run.kept[: TOLD.kept])}{more}.")

    def told() -> None:
        show(result.report, [run.place(path) for path in files])
        say(*(sentence for sentence in who.get("sentences", ()) if sentence not in who["warnings"]))

    asked.tell({"out": str(run.target), **result.report.to_dict()}, told)
