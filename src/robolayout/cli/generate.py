"""`robolayout generate`: from a scene file, or one sentence, to an output folder."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from shutil import copytree
from typing import TYPE_CHECKING, Annotated

import typer

from robolayout._errors import InputError
from robolayout._text import file_name
from robolayout.cli.terminal import progress, say, show, warn

if TYPE_CHECKING:
    from robolayout.planners import Planner, Understanding
    from robolayout.run.flow import Result
    from robolayout.run.folder import RunFolder
    from robolayout.scene import Scene

KEPT_SHOWN = 5
"""Names of kept files that are said."""

SceneOrSentence = Annotated[
    str, typer.Argument(metavar="SCENE", help="A scene file (JSON), or one sentence in quotes.")
]
ProgramOption = Annotated[
    Path | None, typer.Option("--program", help="Use this constraint program instead of planning.")
]
AgentOption = Annotated[
    str | None, typer.Option("--agent", help="Body or bodies: names or files, separated by commas.")
]
AssetDirOption = Annotated[
    Path | None, typer.Option("--asset-dir", help="Folder of the assets that the scene refers to.")
]
SeedOption = Annotated[int, typer.Option("--seed", min=0, help="Settles every choice.")]
QuietOption = Annotated[bool, typer.Option("--quiet", help="Print nothing but errors.")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print JSON for machines.")]
StartsOption = Annotated[int, typer.Option("--starts", min=1, max=256, help="Starts of the search.")]
SolverOption = Annotated[str, typer.Option("--solver", help="default, paper, trust-constr or dual-annealing.")]
EffortOption = Annotated[str, typer.Option("--effort", help="How long to search: quick, normal or thorough.")]
VariantsOption = Annotated[
    int, typer.Option("--variants", min=1, max=64, help="Different rooms for one sentence or scene file.")
]
ModelOption = Annotated[str | None, typer.Option("--model", help="Let a model plan: openai:gpt-4o, ollama:llava, ...")]
ModeOption = Annotated[str, typer.Option("--mode", help="grouped, one_shot, no_image or no_constraint (with --model).")]
SamplesOption = Annotated[int, typer.Option("--samples", min=1, max=16, help="Programs asked for at once.")]
RetriesOption = Annotated[int, typer.Option("--retries", min=0, max=10, help="Further questions per group.")]
BaseUrlOption = Annotated[str | None, typer.Option("--base-url", help="An OpenAI-compatible server.")]
MaxCostOption = Annotated[float | None, typer.Option("--max-cost", help="Most dollars to spend on a model.")]
TimeoutOption = Annotated[float, typer.Option("--timeout", help="Seconds to wait for a model's answer.")]
CriticOption = Annotated[bool, typer.Option("--critic", help="Let the model rate the room and amend it once.")]
ConstraintsOption = Annotated[
    Path | None, typer.Option("--constraints", help="A Python file with constraints of your own; it is run.")
]
KnowledgeOption = Annotated[
    list[Path] | None,
    typer.Option("--knowledge", help="A file with kinds of things, roles and rooms of your own; may be repeated."),
]
StartOption = Annotated[
    Path | None, typer.Option("--from", help="Mend this layout with the least change instead of planning.")
]
KeepOption = Annotated[str, typer.Option("--keep", help="With --from: what does not move at all, names and commas.")]
FreeOption = Annotated[str, typer.Option("--free", help="With --from: all that may move, names and commas.")]
ReplayOption = Annotated[Path | None, typer.Option("--replay", help="Answer from recorded exchanges, offline.")]


LONGEST_NAME = 255
"""Characters of a file name at the most, on the usual systems."""


def generate(  # noqa: PLR0913 - one parameter per option
    scene: SceneOrSentence,
    program: ProgramOption = None,
    agent: AgentOption = None,
    seed: SeedOption = 0,
    starts: StartsOption = 16,
    solver: SolverOption = "default",
    effort: EffortOption = "normal",
    start: StartOption = None,
    keep: KeepOption = "",
    free: FreeOption = "",
    out: Annotated[Path | None, typer.Option("--out", help="Output folder; out/<scene> if not given.")] = None,
    pictures: Annotated[bool, typer.Option("--pictures/--no-pictures", help="Draw plan, views, animation.")] = True,
    export: Annotated[str, typer.Option("--export", help="Further formats, separated by commas.")] = "",
    walk: Annotated[bool, typer.Option("--walk", help="Also draw the body on its round: walk.gif.")] = False,
    dress: Annotated[
        str | None,
        typer.Option("--dress", help="Small things left about: none, some or full; the scene's own if not given."),
    ] = None,
    settle: Annotated[bool, typer.Option("--settle", help="Let gravity act in MuJoCo (extra `sim`).")] = False,
    asset_dir: AssetDirOption = None,
    constraints: ConstraintsOption = None,
    knowledge: KnowledgeOption = None,
    variants: VariantsOption = 1,
    model: ModelOption = None,
    mode: ModeOption = "grouped",
    samples: SamplesOption = 1,
    retries: RetriesOption = 3,
    critic: CriticOption = False,
    base_url: BaseUrlOption = None,
    max_cost: MaxCostOption = None,
    timeout: TimeoutOption = 60.0,
    replay: ReplayOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Lay out a scene, verify it, and write layout, report, pictures and GLB."""
    from robolayout.run.flow import generate as arrange
    from robolayout.run.outputs import write_files
    from robolayout.solve import SolverConfig

    formats = _checked(export, constraints, settle=settle)
    offline = own_planner(knowledge, program, model or base_url or replay)
    other = _not_offline(program, model or base_url or replay)
    config = SolverConfig(starts=starts, trace=pictures).at(effort)
    arranged = partial(
        arrange, solver=solver, config=config, start=start, keep=_names(keep), free=_names(free), dress=_amount(dress)
    )
    every_ok = True
    for job in _jobs(scene, agent, asset_dir, (seed, variants), out, knowledge or (), quiet=quiet):
        _check_meshes(job.scene)
        for line in () if quiet or job.understood is None else job.understood.sentences():
            warn(line)
        with _output(job.folder) as run, progress(quiet or as_json) as tell:
            how, limits = (model, mode, samples, retries, critic), (base_url, max_cost, timeout, replay)
            planner = _model_or_file(program, how, limits, run, job.seed) if other else offline
            result = arranged(job.scene, planner=planner, seed=job.seed, progress=tell)
            result = _settled(result, tell) if settle else result
            tell("write")
            job.write(run.path)
            files = write_files(result, run, pictures=pictures, formats=formats)
            files += _walk(result, run.path) if walk else []
        _tell(result, run, files, quiet=quiet, as_json=as_json)
        every_ok &= result.report.ok
    raise typer.Exit(0 if every_ok else 1)


def _amount(dress: str | None) -> str | None:
    """Return how much is to lie about, refused before any work if it is not known."""
    from robolayout.scene import check_dress

    return None if dress is None else check_dress(dress)


def _names(given: str) -> list[str]:
    """Return names that are separated by commas."""
    return [name.strip() for name in given.split(",") if name.strip()]


@dataclass(frozen=True)
class _Job:
    """One room to lay out.

    Attributes:
        scene: The room.
        folder: Its output folder.
        seed: Settles every choice.
        understood: What was understood of a sentence; None for a scene file.
    """

    scene: Scene
    folder: Path
    seed: int
    understood: Understanding | None = None

    def write(self, folder: Path) -> None:
        """Write what was understood of a sentence."""
        from robolayout._files import write_atomic

        if self.understood is not None:
            text = json.dumps(self.understood.to_dict(), indent=2, ensure_ascii=False) + "\n"
            write_atomic(folder / "understood.json", text)


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


def _check_meshes(scene: Scene) -> None:
    """Refuse broken mesh files before any work; a scene without meshes loads nothing for it."""
    if any(asset.path is not None for asset in scene.assets):
        from robolayout.assets import check_meshes

        check_meshes(scene)


def _checked(export: str, constraints: Path | None, *, settle: bool) -> list[str]:
    """Refuse unknown formats and a missing simulator before any work, read the user's constraints, return the formats."""
    from robolayout.export import check_simulator, find_exporter

    formats = [name for name in export.split(",") if name]
    for name in formats:
        find_exporter(name)
    if settle:
        check_simulator()
    if constraints is not None:
        from robolayout.constraints import register_file

        register_file(constraints)
    return formats


def _settled(result: Result, tell: Callable[[str], None]) -> Result:
    """Return the run with a report that also says what gravity does."""
    from dataclasses import replace

    from robolayout.export import settle

    tell("settle")
    found = settle(result.scene, result.layout)
    return replace(result, report=result.report.with_stability(found.to_dict()))


def _walk(result: Result, folder: Path) -> list[Path]:
    """Write walk.gif, or say why there is none."""
    from robolayout._files import write_atomic
    from robolayout.page.marks import plan_marks
    from robolayout.render import walk_gif

    first = result.report.agents[0]
    try:
        data = walk_gif(result.scene, result.layout, plan_marks(first), agent=first.agent)
    except InputError as error:
        warn(f"no walk.gif: {error}")
        return []
    return [write_atomic(folder / "walk.gif", data)]


def _not_offline(program: Path | None, model: object) -> bool:
    """Return whether something else than the offline planner is asked for; both at once are an error."""
    if program is not None and model is not None:
        raise InputError("--program and --model (or --base-url, --replay) exclude each other: give one of them.")
    return program is not None or model is not None


def own_planner(knowledge: list[Path] | None, *others: object) -> Planner | None:
    """Return the offline planner with the user's own knowledge, if any is given; another planner has no use for it."""
    from robolayout.planners import OfflinePlanner

    if not knowledge:
        return None
    if any(other is not None for other in others):
        raise InputError("--knowledge is for the offline planner: leave it out, or leave --program and --model out.")
    return OfflinePlanner(knowledge)


def _model_or_file(
    program: Path | None,
    how: tuple[str | None, str, int, int, bool],
    limits: tuple[str | None, float | None, float, Path | None],
    run: RunFolder,
    seed: int,
) -> Planner:
    from robolayout.planners import FilePlanner, ModelPlanner
    from robolayout.run.folder import ANSWERS

    if program is not None:
        return FilePlanner(program)
    model, mode, samples, retries, critic = how
    base_url, max_cost, timeout, replay = limits
    exchanges = run.path / ANSWERS
    again = replay is not None and replay.resolve() == (run.target / ANSWERS).resolve()
    if again and replay is not None and replay.is_dir():
        copytree(replay, exchanges)
    return ModelPlanner(
        model,
        mode=mode,  # type: ignore[arg-type]
        samples=samples,
        retries=retries,
        critic=critic,
        base_url=base_url,
        max_cost=max_cost,
        timeout=timeout,
        replay=replay,
        exchanges=None if again else exchanges,
        seed=seed,
    )


def _jobs(
    text: str,
    agent: str | None,
    asset_dir: Path | None,
    seed_variants: tuple[int, int],
    out: Path | None,
    knowledge: Sequence[Path],
    *,
    quiet: bool,
) -> Iterator[_Job]:
    """Yield the variants of a scene file (by seed) or of a sentence (by what it leaves open), each with its output folder."""
    from robolayout.planners import scene_from_sentence
    from robolayout.scene import load_agents

    seed, variants = seed_variants

    def folder(scene: Scene, variant: int) -> Path:
        whole = out or Path("out") / file_name(scene.name)
        return whole if variants == 1 else whole / f"variant-{variant}"

    if _names_a_file(text):
        scene = read_scene(text, agent, asset_dir, knowledge, quiet=quiet)
        for variant in range(variants):
            yield _Job(scene, folder(scene, variant), seed + variant)
        return
    for variant in range(variants):
        scene, understood = scene_from_sentence(text, seed=seed, variant=variant, knowledge=knowledge)
        if agent is not None:
            scene = scene.with_agents(*load_agents(agent))
        yield _Job(scene, folder(scene, variant), seed, understood)


LONGEST_WORD = 45
"""Letters of the longest word of a dictionary: more of them without a blank are a path."""


def _names_a_file(text: str) -> bool:
    """Return whether an argument names a scene file rather than saying what the room should be."""
    name = text.strip()
    if " " in name or "\n" in name:
        return Path(text).suffix == ".json" or os.path.exists(text)
    return bool(name) and (not name.isalpha() or len(name) > LONGEST_WORD or os.path.exists(text))


def read_scene(
    path: str, agent: str | None, asset_dir: Path | None, knowledge: Sequence[Path] = (), *, quiet: bool = False
) -> Scene:
    """Read a scene, for other agents if given; show what was mended on reading and, unless quiet, what is of no known kind."""
    from robolayout.assets import unknown_kinds
    from robolayout.scene import load_agents, load_scene

    known = scene = load_scene(path, asset_dir)
    if knowledge:
        from robolayout.planners import OfflinePlanner

        known = OfflinePlanner(knowledge).recognised(scene)
    for warning in (*scene.warnings, *(() if quiet else unknown_kinds(known.assets))):
        warn(f"warning: {warning}")
    return scene if agent is None else scene.with_agents(*load_agents(agent))


def _tell(result: Result, run: RunFolder, files: list[Path], *, quiet: bool, as_json: bool) -> None:
    who = result.report.planner
    warn_of = [f"warning: {warning}" for warning in who.get("warnings", ())]
    if run.kept and not quiet:
        more = f" and {len(run.kept) - KEPT_SHOWN} more" if len(run.kept) > KEPT_SHOWN else ""
        warn_of.append(f"kept in {run.target} what no run wrote: {', '.join(run.kept[:KEPT_SHOWN])}{more}.")
    for line in warn_of:
        warn(line)
    if as_json:
        say(json.dumps({"out": str(run.target), **result.report.to_dict()}))
    elif not quiet:
        show(result.report, [run.place(path) for path in files])
        say(*(sentence for sentence in who.get("sentences", ()) if sentence not in who["warnings"]))
