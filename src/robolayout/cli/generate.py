"""`robolayout generate`: from a scene file, or one sentence, to an output folder."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from robolayout._errors import InputError
from robolayout._text import file_name
from robolayout.cli.models import (
    AtOnceOption,
    BaseUrlOption,
    CacheOption,
    CriticOption,
    FallbackOption,
    MaxCostOption,
    ModelOption,
    ModeOption,
    ReplayOption,
    RetriesOption,
    SamplesOption,
    ThinkingOption,
    TimeoutOption,
    Who,
)
from robolayout.cli.terminal import progress, say, show, warn

if TYPE_CHECKING:
    from robolayout.planners import Planner
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
SolverOption = Annotated[
    str, typer.Option("--solver", help="default, paper, paper-unrefined, trust-constr or dual-annealing.")
]
EffortOption = Annotated[str, typer.Option("--effort", help="How long to search: quick, normal or thorough.")]
VariantsOption = Annotated[
    int, typer.Option("--variants", min=1, max=64, help="Different rooms for one sentence or scene file.")
]
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
    thinking: ThinkingOption = None,
    fallback: FallbackOption = None,
    at_once: AtOnceOption = None,
    cache: CacheOption = True,
    replay: ReplayOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Lay out a scene, verify it, and write layout, report, pictures and GLB."""
    from robolayout.run.flow import generate as arrange
    from robolayout.solve import SolverConfig

    formats = _checked(export, constraints, settle=settle)
    limits = {"base_url": base_url, "max_cost": max_cost, "timeout": timeout, "replay": replay, "cache": cache}
    limits |= {"thinking": thinking, "fallback": tuple(fallback or ()), "at_once": at_once}
    asked = {"mode": mode, "samples": samples, "retries": retries, "critic": critic}
    who = Who(program, model, tuple(knowledge or ()), asked, limits)
    config = SolverConfig(starts=starts, trace=pictures).at(effort)
    arranged = partial(
        arrange, solver=solver, config=config, start=start, keep=_names(keep), free=_names(free), dress=_amount(dress)
    )
    write = partial(_write, pictures=pictures, formats=formats, walk=walk, settle=settle)
    given = _Given(scene, agent, asset_dir, who.knowledge, quiet, as_json)
    made = [_laid_out(job, given, who, arranged, write) for job in _jobs(given, who, (seed, variants), out)]
    raise typer.Exit(0 if all(result.report.ok for result in made) else 1)


def _laid_out(
    job: _Job, given: _Given, who: Who, arranged: Callable[..., Result], write: Callable[..., tuple[Result, list[Path]]]
) -> Result:
    """Lay one room out, write its files, and say what came of it."""
    with _output(job.folder) as run:
        planner = who.planner(run, job.seed)
        room = job.scene or _furnished(given, planner, run, job)
        _check_meshes(room)
        with progress(given.quiet or given.as_json) as tell:
            result, files = write(arranged(room, planner=planner, seed=job.seed, progress=tell), run, tell)
    _tell(result, run, files, quiet=given.quiet, as_json=given.as_json)
    return result


def _write(
    result: Result,
    run: RunFolder,
    tell: Callable[[str], None],
    *,
    pictures: bool,
    formats: list[str],
    walk: bool,
    settle: bool,
) -> tuple[Result, list[Path]]:
    """Write the files of a run, after asking gravity if so wished; return the run and the files."""
    from robolayout.run.outputs import write_files

    result = _settled(result, tell) if settle else result
    tell("write")
    files = write_files(result, run, pictures=pictures, formats=formats)
    return result, files + (_walk(result, run.path) if walk else [])


def _amount(dress: str | None) -> str | None:
    """Return how much is to lie about, refused before any work if it is not known."""
    from robolayout.scene import check_dress

    return None if dress is None else check_dress(dress)


def _names(given: str) -> list[str]:
    """Return names that are separated by commas."""
    return [name.strip() for name in given.split(",") if name.strip()]


@dataclass(frozen=True)
class _Given:
    """What to lay out, as it was given.

    Attributes:
        text: A scene file, or a sentence.
        agent: Bodies in place of its own.
        asset_dir: Folder of assets.
        knowledge: Files of the user's own kinds and rooms.
        quiet: Whether to say nothing but errors.
        as_json: Whether to say JSON alone.
    """

    text: str
    agent: str | None
    asset_dir: Path | None
    knowledge: tuple[Path, ...]
    quiet: bool
    as_json: bool

    def for_agent(self, scene: Scene) -> Scene:
        """Return the scene for the bodies that were named."""
        from robolayout.scene import load_agents

        return scene if self.agent is None else scene.with_agents(*load_agents(self.agent))


@dataclass(frozen=True)
class _Job:
    """One room to lay out.

    Attributes:
        folder: Its output folder.
        seed: Settles every choice.
        scene: The room; None where words are still to be read, by whoever plans.
        variant: Which of several rooms for the same words.
    """

    folder: Path
    seed: int
    scene: Scene | None = None
    variant: int = 0


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


def _jobs(given: _Given, who: Who, seed_variants: tuple[int, int], out: Path | None) -> Iterator[_Job]:
    """Yield the variants of a scene file (by seed) or of a sentence (by what it leaves open), each with its output folder."""
    seed, variants = seed_variants
    scene = None
    if _names_a_file(given.text):
        scene = read_scene(given.text, given.agent, given.asset_dir, given.knowledge, quiet=given.quiet)
    whole = out or Path("out") / (file_name(scene.name) if scene else "scene")
    for variant in range(variants):
        folder = whole if variants == 1 else whole / f"variant-{variant}"
        by_seed = scene is not None or who.asks_a_model
        yield _Job(folder, seed + variant * by_seed, scene, variant)


def _furnished(given: _Given, planner: Planner | None, run: RunFolder, job: _Job) -> Scene:
    """Return the scene of a sentence, and write and say what was understood: by the model that plans, else by rules."""
    from robolayout._files import write_atomic
    from robolayout.planners import ModelPlanner, scene_from_sentence

    if isinstance(planner, ModelPlanner):
        scene, understood = planner.furnish(given.text, assets=given.asset_dir)
    else:
        scene, understood = scene_from_sentence(
            given.text, seed=job.seed, variant=job.variant, knowledge=given.knowledge
        )
    if not given.quiet:
        for line in understood.sentences():
            warn(line)
    text = json.dumps(understood.to_dict(), indent=2, ensure_ascii=False) + "\n"
    write_atomic(run.path / "understood.json", text)
    return given.for_agent(scene)


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
