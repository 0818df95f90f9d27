"""The command line: arguments in, exit code out.

Exit codes: 0 all demands met, 1 a layout was made but the report lists unmet demands, 2 the input is wrong.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from robolayout._errors import InputError, RoboLayoutError
from robolayout._version import __version__

if TYPE_CHECKING:
    from robolayout.pipeline import Result
    from robolayout.scene import Scene
    from robolayout.verify import Report

app = typer.Typer(
    help="Lay out a 3D room for a body, and prove that it can move through and use it.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

SceneArgument = Annotated[str, typer.Argument(help="A scene file (JSON).")]
LayoutArgument = Annotated[Path, typer.Argument(help="A layout file (JSON).")]
AgentOption = Annotated[
    str | None, typer.Option("--agent", help="Body or bodies: names or files, separated by commas.")
]
AssetDirOption = Annotated[
    Path | None, typer.Option("--asset-dir", help="Folder of the assets that the scene refers to.")
]
SeedOption = Annotated[int, typer.Option("--seed", min=0, help="Settles every choice.")]
QuietOption = Annotated[bool, typer.Option("--quiet", help="Print nothing but errors.")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print JSON for machines.")]


def main() -> None:
    """Run the command line; user errors become one sentence and exit code 2."""
    try:
        app()
    except RoboLayoutError as error:
        sys.stderr.write(f"robolayout: {error}\n")
        raise SystemExit(2) from None


def _version(value: bool) -> None:
    if value:
        typer.echo(f"robolayout {__version__}")
        raise typer.Exit


@app.callback()
def _page(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Lay out a 3D room for a body, and prove that it can move through and use it."""


@app.command()
def generate(  # noqa: PLR0913 - one parameter per option
    scene: SceneArgument,
    program: Annotated[
        Path | None, typer.Option("--program", help="Use this constraint program instead of planning.")
    ] = None,
    agent: AgentOption = None,
    seed: SeedOption = 0,
    starts: Annotated[int, typer.Option("--starts", min=1, max=256, help="Starts of the search.")] = 16,
    out: Annotated[Path | None, typer.Option("--out", help="Output folder; out/<scene> if not given.")] = None,
    pictures: Annotated[bool, typer.Option("--pictures/--no-pictures", help="Draw plan, views, animation.")] = True,
    export: Annotated[str, typer.Option("--export", help="Further formats, separated by commas.")] = "",
    asset_dir: AssetDirOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Lay out a scene, verify it, and write layout, report, pictures and GLB."""
    from robolayout._files import check_writable
    from robolayout.export import find_exporter
    from robolayout.outputs import write_result

    formats = [name for name in export.split(",") if name]
    for name in formats:
        find_exporter(name)
    given = _scene(scene, agent, asset_dir)
    folder = out or Path("out") / given.name
    check_writable(folder)
    with _progress(quiet or as_json) as say:
        result = _generate(given, program, seed=seed, starts=starts, trace=pictures, say=say)
        say("write")
        files = write_result(result, folder, pictures=pictures, formats=formats)
    if as_json:
        typer.echo(json.dumps({"out": str(folder), **result.report.to_dict()}))
    elif not quiet:
        _show(result.report, files)
    raise typer.Exit(0 if result.report.ok else 1)


@app.command()
def check(
    scene: SceneArgument,
    layout: LayoutArgument,
    agent: AgentOption = None,
    program: Annotated[
        Path | None, typer.Option("--program", help="Also measure the statements of this program.")
    ] = None,
    asset_dir: AssetDirOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Verify a layout, whoever made it."""
    from robolayout.planners import FilePlanner, PlanRequest
    from robolayout.program import read_program
    from robolayout.scene import load_layout
    from robolayout.verify import verify

    given = _scene(scene, agent, asset_dir)
    asked = read_program(FilePlanner(program).plan(PlanRequest(given)), given) if program else None
    report = verify(given, load_layout(layout, given), asked)
    if as_json:
        typer.echo(json.dumps(report.to_dict()))
    elif not quiet:
        _show(report, [])
    raise typer.Exit(0 if report.ok else 1)


@app.command()
def render(
    scene: SceneArgument,
    layout: LayoutArgument,
    view: Annotated[str, typer.Option("--view", help="top, side, plan, an asset's name, or eye:ASSET.")] = "side",
    size: Annotated[int, typer.Option("--size", min=64, max=4096, help="Pixels of a side.")] = 1024,
    out: Annotated[Path | None, typer.Option("--out", help="Picture file; <view>.png if not given.")] = None,
    agent: AgentOption = None,
    asset_dir: AssetDirOption = None,
) -> None:
    """Draw a layout."""
    from robolayout._files import write_atomic
    from robolayout.outputs import plan_marks, png
    from robolayout.render import plan_image, render_view
    from robolayout.scene import load_layout
    from robolayout.verify import judge_agent

    given = _scene(scene, agent, asset_dir)
    placed = load_layout(layout, given)
    if view == "plan":
        marks = plan_marks(judge_agent(given, placed, given.agent))
        image = plan_image(given, placed, navigation=marks, agent=given.agent, width=size)
    else:
        image = render_view(given, placed, view=view, size=size)
    target = out or Path(f"{view.replace(':', '_')}.png")
    typer.echo(str(write_atomic(target, png(image))))


@app.command()
def compare(
    scene: SceneArgument,
    bodies: Annotated[str, typer.Option("--agents", help="Two to six bodies: names or files, separated by commas.")],
    out: Annotated[Path, typer.Option("--out", help="Picture file, PNG or SVG.")] = Path("compare.png"),
    seed: SeedOption = 0,
    width: Annotated[int, typer.Option("--width", min=256, max=8192, help="Pixels of the PNG's width.")] = 1800,
    asset_dir: AssetDirOption = None,
    quiet: QuietOption = False,
) -> None:
    """Lay out one room for several bodies, side by side in one picture."""
    from robolayout import pipeline
    from robolayout._files import check_writable, write_atomic
    from robolayout.outputs import comparison

    if out.suffix not in (".png", ".svg"):
        raise InputError(f"a comparison cannot be written to {out}: name a file that ends in .png or .svg.")
    given = _scene(scene, bodies, asset_dir)
    check_writable(out.parent)
    with _progress(quiet) as say:
        results = pipeline.compare(given, given.agents, seed=seed, progress=say)
    write_atomic(out, comparison(results, out.suffix, width=width))
    if not quiet:
        rows = zip(*(result.report.rows() for result in results), strict=True)
        heads = ["check", *(body.name for body in given.agents)]
        _table(given.name, heads, [[row[0][0], *(value for _, value, _ in row)] for row in rows])
        typer.echo(str(out))
    raise typer.Exit(0 if all(result.report.ok for result in results) else 1)


@app.command()
def export(
    scene: SceneArgument,
    layout: LayoutArgument,
    to: Annotated[str, typer.Option("--to", help="Formats, separated by commas.")] = "glb",
    out: Annotated[Path, typer.Option("--out", help="Folder to write to.")] = Path(),
    agent: AgentOption = None,
    asset_dir: AssetDirOption = None,
) -> None:
    """Write a layout for simulators and viewers."""
    from robolayout.export import EXPORTERS, find_exporter
    from robolayout.export import export as write
    from robolayout.outputs import export_options
    from robolayout.scene import load_layout
    from robolayout.verify import verify

    given = _scene(scene, agent, asset_dir)
    placed = load_layout(layout, given)
    names = [name for name in to.split(",") if name]
    if not names:
        raise InputError(f"--to names no format. Known: {', '.join(EXPORTERS)}.")
    for name in names:
        find_exporter(name)
    options = export_options(verify(given, placed))
    for name in names:
        typer.echo(str(write(given, placed, name, folder=out, options=options)))


@app.command()
def agents(name: Annotated[str | None, typer.Argument(help="Show one profile with its sources.")] = None) -> None:
    """List the built-in bodies, or one with its sources."""
    from robolayout.scene import agent_names, load_agent

    if name is not None:
        body = load_agent(name)
        figures = [
            [key, f"{getattr(body, key):g}", "yes" if source.verified else "no", source.text]
            for key, source in body.sources.items()
        ]
        _table(f"{body.title or body.name} (metres)", ["figure", "value", "verified", "source"], figures)
        return
    rows: list[list[str]] = []
    for known in agent_names():
        a = load_agent(known)
        shape = f"disc {2 * a.radius:.2f}" if a.length is None or a.width is None else f"{a.length:.2f} x {a.width:.2f}"
        heights = "-" if a.reach_distance is None else f"{a.reach_low:.2f}-{a.reach_high:.2f}"
        rows.append([known, a.title, shape, f"{a.radius:.3f}", f"{a.height:.2f}", f"{a.reach:.2f}", heights])
    _table("Agents (metres)", ["name", "body", "footprint", "radius", "height", "reach", "heights"], rows)


@app.command()
def constraints() -> None:
    """List the relations that a constraint program can state."""
    from robolayout.constraints import RELATIONS

    rows = [[relation.example.removeprefix("solver."), relation.meaning()] for relation in RELATIONS.values()]
    _table("Relations", ["example", "meaning"], rows)


@app.command()
def assets(word: Annotated[str | None, typer.Argument(help="Show what this word is understood as.")] = None) -> None:
    """List the catalogue of furniture with typical sizes, or look a word up."""
    from robolayout.assets import CATALOGUE, find_category

    found = CATALOGUE.values() if word is None else [find_category(word)]
    rows = [[c.name, c.group, " x ".join(f"{v:g}" for v in c.size), ", ".join(c.places), c.source] for c in found]
    _table("Catalogue (depth x width x height in metres)", ["category", "group", "size", "place", "source"], rows)


def _scene(path: str, agent: str | None, asset_dir: Path | None) -> Scene:
    """Read a scene, for other agents if given, and show what was mended on reading."""
    from robolayout.scene import load_agents, load_scene

    scene = load_scene(path, asset_dir)
    for warning in scene.warnings:
        sys.stderr.write(f"robolayout: warning: {warning}\n")
    return scene if agent is None else scene.with_agents(*load_agents(agent))


def _generate(
    scene: Scene, program: Path | None, *, seed: int, starts: int, trace: bool, say: Callable[[str], None]
) -> Result:
    from robolayout.pipeline import generate
    from robolayout.planners import FilePlanner
    from robolayout.solve import SolverConfig

    planner = FilePlanner(program) if program else None
    config = SolverConfig(starts=starts, trace=trace)
    return generate(scene, planner=planner, seed=seed, config=config, progress=say)


@contextmanager
def _progress(silent: bool) -> Generator[Callable[[str], None]]:
    """Show the running phase on a terminal."""
    if silent or not sys.stderr.isatty():
        yield _hushed
        return
    from rich.console import Console

    with Console(stderr=True).status("starting") as status:

        def say(phase: str) -> None:
            status.update(f"{phase} ...")

        yield say


def _hushed(phase: str) -> None:
    """Say nothing."""


def _table(title: str, heads: list[str], rows: list[list[str]]) -> None:
    from rich.console import Console
    from rich.table import Table

    table = Table(title=title, title_justify="left")
    for head in heads:
        table.add_column(head, overflow="fold")
    for row in rows:
        table.add_row(*row)
    Console(width=None if sys.stdout.isatty() else 140).print(table)


def _show(report: Report, files: list[Path]) -> None:
    """Print the short report, what is wrong, and where the files are."""
    rows = [[name, value, "ok" if met else "SHORT"] for name, value, met in report.rows()]
    title = f"{report.scene.name} for {', '.join(a.agent.name for a in report.agents)}"
    _table(title, ["check", "result", ""], rows)
    for sentence in report.violations[:12]:
        typer.echo(f"- {sentence}")
    if len(report.violations) > 12:
        typer.echo(f"- and {len(report.violations) - 12} more in the report")
    for path in files:
        typer.echo(str(path))
