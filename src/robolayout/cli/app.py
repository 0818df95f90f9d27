"""The commands: arguments in, exit code out (`robolayout.cli.guard` says which)."""

from __future__ import annotations

import errno
import json
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from robolayout._errors import InputError, UnknownNameError
from robolayout._version import __version__
from robolayout.cli.assets import assets
from robolayout.cli.bodies import agents
from robolayout.cli.diff import diff
from robolayout.cli.generate import (
    AgentOption,
    AssetDirOption,
    JsonOption,
    KnowledgeOption,
    QuietOption,
    SeedOption,
    generate,
    read_scene,
)
from robolayout.cli.guard import Unforeseen, main
from robolayout.cli.many import batch, evaluate
from robolayout.cli.models import BaseUrlOption, MaxCostOption, ReplayOption
from robolayout.cli.physics import DoorsOption, drive, settle, standing
from robolayout.cli.pictures import DateOption, render
from robolayout.cli.terminal import progress, say, show, table

__all__ = ["app", "main"]

BODIES = ("none", "base")
"""What of a body a file may hold."""

REFUSALS = (errno.ENAMETOOLONG, errno.EACCES, errno.EPERM, errno.ELOOP, errno.ENOTDIR, errno.EISDIR, errno.EROFS)
"""What a system says of a path that is no good, rather than of one that should be there and is not."""


class Commands(TyperGroup):
    """The group of all commands."""

    def invoke(self, ctx: Any) -> Any:
        """Run a command; a path that the system refuses is the user's, all else is nobody's fault but ours."""
        try:
            return super().invoke(ctx)
        except (OSError, EOFError) as error:
            if isinstance(error, OSError) and error.errno in REFUSALS and isinstance(error.filename, str):
                raise InputError(f"cannot use {error.filename}: {error.strerror}; give another path.") from None
            raise Unforeseen from error


app = typer.Typer(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Lay out a 3D room for a body, and prove that it can move through and use it.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

JUDGED = "judged"
"""Folder of a judge's votes beside the report."""

SceneArgument = Annotated[str, typer.Argument(help="A scene file (JSON).")]
LayoutArgument = Annotated[Path, typer.Argument(help="A layout file (JSON).")]


def _version(value: bool) -> None:
    if value:
        say(f"robolayout {__version__}")
        raise typer.Exit


@app.callback()
def _page(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Lay out a 3D room for a body, and prove that it can move through and use it."""


app.command()(generate)
app.command()(batch)
app.command()(evaluate)


@app.command()
def check(  # noqa: PLR0913 - one parameter per option
    scene: SceneArgument,
    layout: LayoutArgument,
    agent: AgentOption = None,
    program: Annotated[
        Path | None, typer.Option("--program", help="Also measure the statements of this program.")
    ] = None,
    asset_dir: AssetDirOption = None,
    out: Annotated[
        Path | None, typer.Option("--out", help="Also write report, page, plan, pictures and GLB to this folder.")
    ] = None,
    pictures: Annotated[bool, typer.Option("--pictures/--no-pictures", help="Draw page, plan and views.")] = True,
    date: DateOption = "",
    opinion: Annotated[
        str | None, typer.Option("--judge", help="Also let a model score the room: openai:gpt-4o, ... (docs/vlm.md).")
    ] = None,
    votes: Annotated[int, typer.Option("--votes", min=1, max=32, help="How often it scores the room.")] = 3,
    base_url: BaseUrlOption = None,
    max_cost: MaxCostOption = None,
    replay: ReplayOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Verify a layout, whoever made it."""
    from robolayout._files import check_writable
    from robolayout.run.judged import judge
    from robolayout.run.outputs import write_result
    from robolayout.scene import load_layout

    if date and (out is None or not pictures):
        raise InputError(
            "--date is for the sheet to print, which is not drawn: give --out, and leave --no-pictures out."
        )
    given = read_scene(scene, agent, asset_dir, quiet=quiet)
    placed = load_layout(layout, given)
    if out is not None:
        check_writable(out)
    judged = judge(given, placed, program)
    if opinion or replay:
        from robolayout.planners import ModelJudge
        from robolayout.run.opinion import scored

        record = out / JUDGED if out is not None and replay is None else None
        asked = ModelJudge(opinion, votes=votes, base_url=base_url, max_cost=max_cost, replay=replay, exchanges=record)
        judged = scored(judged, asked)
    files = [] if out is None else write_result(judged, out, pictures=pictures, date=date)
    if as_json:
        say(json.dumps(judged.report.to_dict()))
    elif not quiet:
        show(judged.report, files)
    raise typer.Exit(0 if judged.report.ok else 1)


app.command()(render)
app.command()(diff)


@app.command()
def compare(  # noqa: PLR0913 - one parameter per option
    scene: SceneArgument,
    bodies: Annotated[str, typer.Option("--agents", help="Two to six bodies: names or files, separated by commas.")],
    out: Annotated[Path, typer.Option("--out", help="Picture file, PNG or SVG.")] = Path("compare.png"),
    seed: SeedOption = 0,
    width: Annotated[int, typer.Option("--width", min=256, max=8192, help="Pixels of the PNG's width.")] = 1800,
    asset_dir: AssetDirOption = None,
    knowledge: KnowledgeOption = None,
    quiet: QuietOption = False,
) -> None:
    """Lay out one room for several bodies, side by side in one picture."""
    from robolayout._files import check_writable, write_atomic
    from robolayout.planners import OfflinePlanner
    from robolayout.run import flow
    from robolayout.run.outputs import comparison

    if out.suffix not in (".png", ".svg"):
        raise InputError(f"a comparison cannot be written to {out}: name a file that ends in .png or .svg.")
    given = read_scene(scene, bodies, asset_dir, quiet=quiet)
    check_writable(out.parent)
    with progress(quiet) as tell:
        planner = OfflinePlanner(knowledge or ())
        results = flow.compare(given, given.agents, planner=planner, seed=seed, progress=tell)
    write_atomic(out, comparison(results, out.suffix, width=width))
    if not quiet:
        rows = zip(*(result.report.rows() for result in results), strict=True)
        heads = ["check", *(body.name for body in given.agents)]
        table(given.name, heads, [[row[0][0], *(value for _, value, _ in row)] for row in rows])
        say(str(out))
    raise typer.Exit(0 if all(result.report.ok for result in results) else 1)


@app.command()
def export(  # noqa: PLR0913 - one parameter per option
    scene: SceneArgument,
    layout: LayoutArgument,
    to: Annotated[
        str, typer.Option("--to", help="Formats, separated by commas: glb, usd, mjcf, dxf, pdf, ...")
    ] = "glb",
    out: Annotated[Path, typer.Option("--out", help="Folder to write to.")] = Path(),
    partial: Annotated[bool, typer.Option("--partial", help="Leave assets without a pose out.")] = False,
    agent: AgentOption = None,
    body: Annotated[
        str, typer.Option("--body", help="What of the body goes into MJCF: none, or base (its driving base).")
    ] = "base",
    doors: DoorsOption = "swinging",
    asset_dir: AssetDirOption = None,
) -> None:
    """Write a layout for simulators and viewers."""
    from robolayout._files import check_writable
    from robolayout.export import export_all, exporters, find_exporter
    from robolayout.run.outputs import export_options
    from robolayout.scene import load_layout
    from robolayout.verify import verify

    given = read_scene(scene, agent, asset_dir)
    placed = load_layout(layout, given)
    names = [name for name in to.split(",") if name]
    if not names:
        raise InputError(f"--to names no format. Known: {', '.join(sorted(exporters()))}.")
    for name in names:
        find_exporter(name)
    check_writable(out)
    if body not in BODIES:
        raise UnknownNameError("body to export", body, BODIES)
    options = replace(export_options(verify(given, placed)), leaves=standing(doors))
    options = options if body == "base" else replace(options, agent=None)
    for path in export_all(given, placed, names, folder=out, options=options, partial=partial):
        say(str(path))


app.command()(agents)


@app.command()
def constraints() -> None:
    """List the relations that a constraint program can state."""
    from robolayout.constraints import RELATIONS

    rows = [[relation.example.removeprefix("solver."), relation.meaning()] for relation in RELATIONS.values()]
    table("Relations", ["example", "meaning"], rows)


app.command()(assets)
app.command()(settle)
app.command()(drive)
