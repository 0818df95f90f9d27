"""The commands: arguments in, exit code out (`robolayout.cli.guard` says which)."""

from __future__ import annotations

import errno
import re
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

import typer
from typer import Argument, Option
from typer.core import TyperGroup

from robolayout._errors import InputError, among
from robolayout._files import check_writable, write_atomic
from robolayout._version import __version__
from robolayout.cli import options
from robolayout.cli.generate import generate
from robolayout.cli.guard import Unforeseen, main
from robolayout.cli.lists import agents, assets, constraints
from robolayout.cli.many import batch, evaluate
from robolayout.cli.physics import drive, settle, standing
from robolayout.cli.pictures import render
from robolayout.cli.terminal import progress, say, show, table

__all__ = ["app", "main"]

BODIES = ("none", "base", "full")  # what of a body a file may hold

COMPARED = 6  # most bodies side by side in one picture

REFUSALS = (errno.ENAMETOOLONG, errno.EACCES, errno.EPERM, errno.ELOOP, errno.ENOTDIR, errno.EISDIR, errno.EROFS)
"""What a system says of a path that is no good, rather than of one that should be there and is not."""


class Commands(TyperGroup):
    """The group of all commands."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read the arguments; what begins with a dash and has a blank is a list in words ("- 1 sofa"), no option."""
        return super().parse_args(ctx, [f" {arg}" if re.match(r"-[^=]*\s", arg) else arg for arg in args])

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

WIDTH = 1400  # pixels of a drawn difference, if nobody says how many
VOTES = 3  # of a judge, if nobody says how many
JUDGED = "judged"  # folder of a judge's votes beside the report


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


@options.spread
def check(  # noqa: PLR0913 - one parameter per option
    laid: options.Laid,
    program: options.ProgramOption = None,
    constraints: options.ConstraintsOption = None,
    out: Annotated[Path | None, Option(help="Also write report, page, plan, pictures and GLB to this folder.")] = None,
    pictures: Annotated[bool, Option(help="Draw page, plan and views.")] = True,
    date: options.DateOption = "",
    judge: Annotated[
        str | None, Option(help="Also let a model score the room: openai:gpt-4o, ... (docs/vlm.md).")
    ] = None,
    votes: Annotated[int, Option(min=1, max=32, help="How often it scores the room.")] = VOTES,
    base_url: options.BaseUrlOption = None,
    max_cost: options.MaxCostOption = None,
    replay: options.ReplayOption = None,
    *,
    told: options.Told,
) -> None:
    """Verify a layout, whoever made it."""
    from robolayout.run import result
    from robolayout.run.outputs import write_result

    if date and (out is None or not pictures):
        raise InputError(
            "--date is for the sheet to print, which is not drawn: give --out, and leave --no-pictures out."
        )
    if not (judge or replay):
        options.need("--judge", {"votes": votes != VOTES, "max_cost": max_cost is not None, "base_url": base_url})
    options.read_constraints(constraints)
    given, placed = laid.read_both(quiet=told.quiet)
    if out is not None:
        check_writable(out)
    found = result.judge(given, placed, program)
    if judge or replay:
        from robolayout.planners import ModelJudge

        record = out / JUDGED if out is not None and replay is None else None
        asked = ModelJudge(judge, votes=votes, base_url=base_url, max_cost=max_cost, replay=replay, exchanges=record)
        found = result.scored(found, asked)
    files = [] if out is None else write_result(found, out, pictures=pictures, date=date)
    told.tell(found.report.to_dict(), lambda: show(found.report, files))
    raise typer.Exit(0 if found.report.ok else 1)


Side = Annotated[Path, Argument(help="A run's folder, or a layout file (with --scene).")]


@options.spread
def diff(  # noqa: PLR0913 - one parameter per option
    before: Side,
    after: Side,
    body: options.ForBody,
    told: options.Told,
    scene: Annotated[str | None, Option(help="The scene of both layouts; else each folder's own.")] = None,
    program: options.ProgramOption = None,
    constraints: options.ConstraintsOption = None,
    out: Annotated[Path | None, Option(help="Draw before and after: PNG or SVG.")] = None,
    width: Annotated[int, Option(min=256, max=8192, help="Pixels of the PNG's width.")] = WIDTH,
) -> None:
    """Say what moved, turned, came, went, became better or worse between two layouts (exit code 1: something is worse)."""
    from robolayout.run.diff import diff as differences
    from robolayout.run.outputs import difference_picture
    from robolayout.run.result import load_judged

    if out is None:
        options.need("--out", {"width": width != WIDTH})
    options.read_constraints(constraints)
    suffix = "" if out is None else options.ending(out, "a difference", (".png", ".svg"))
    given = None if scene is None else body.read(scene)
    found = differences(*(load_judged(side, given, body.read, program) for side in (before, after)))
    if out is not None:
        write_atomic(out, difference_picture(found, suffix, width=width))

    def show() -> None:
        if found.changes:
            rows = [[change.verdict, change.name, change.text] for change in found.changes]
            table(f"{before} -> {after}", ["", "what", "difference"], rows)
        count, outcome = len(found.changes), "Nothing differs."
        if count:
            outcome = f"{count} {'difference' if count == 1 else 'differences'}, {len(found.worse)} for the worse."
        say(outcome, *([] if out is None else [str(out)]))

    told.tell(found.to_dict(), show)
    raise typer.Exit(1 if found.worse else 0)


def compare(  # noqa: PLR0913 - one parameter per option
    scene: options.SceneArgument,
    agents: Annotated[str, Option(help="Two to six bodies: names or files, separated by commas.")],
    out: Annotated[Path, Option(help="Picture file, PNG or SVG.")] = Path("compare.png"),
    seed: options.SeedOption = 0,
    width: Annotated[int, Option(min=256, max=8192, help="Pixels of the PNG's width.")] = 1800,
    asset_dir: options.AssetDirOption = None,
    knowledge: options.KnowledgeOption = None,
    quiet: options.QuietOption = False,
) -> None:
    """Lay out one room for several bodies, side by side in one picture."""
    from robolayout.planners import OfflinePlanner
    from robolayout.run import flow
    from robolayout.run.outputs import comparison

    suffix = options.ending(out, "a comparison", (".png", ".svg"))
    given = options.ForBody(agent=agents, asset_dir=asset_dir).read(scene, quiet=quiet)
    if not 2 <= len(given.agents) <= COMPARED:
        raise InputError(f"--agents names {len(given.agents)} bodies: 2 to {COMPARED} are compared; name so many.")
    with progress(quiet) as tell:
        planner = OfflinePlanner(knowledge or ())
        results = flow.compare(given, given.agents, planner=planner, seed=seed, progress=tell)
    write_atomic(out, comparison(results, suffix, width=width))
    if not quiet:
        rows = zip(*(result.report.rows() for result in results), strict=True)
        heads = ["check", *(body.name for body in given.agents)]
        table(given.name, heads, [[row[0][0], *(value for _, value, _ in row)] for row in rows])
        say(str(out))
    raise typer.Exit(0 if all(result.report.ok for result in results) else 1)


@options.spread
def export(
    laid: options.Laid,
    to: Annotated[str, Option(help="Formats, separated by commas: glb, usd, mjcf, dxf, pdf, ...")] = "glb",
    out: Annotated[Path, Option(help="Folder to write to.")] = Path(),
    partial: Annotated[bool, Option("--partial", help="Leave assets without a pose out.")] = False,
    body: Annotated[str, Option(help="In MJCF: none, base (what drives), or full (a robot's model).")] = "base",
    doors: options.DoorsOption = "swinging",
) -> None:
    """Write a layout for simulators and viewers."""
    from robolayout.export import export_all, exporters, find_exporter
    from robolayout.run.flow import generate as solve_again
    from robolayout.run.outputs import export_options
    from robolayout.verify import verify

    given, placed = laid.read_both()
    formats = options.names(to)
    if not formats:
        raise InputError(f"--to names no format. Known: {', '.join(sorted(exporters()))}.")
    for name in formats:
        find_exporter(name)
    check_writable(out)
    among("body to export", [body], BODIES)
    chosen = replace(export_options(verify(given, placed)), leaves=standing(doors))
    chosen = replace(chosen, agent=None if body == "none" else chosen.agent, whole=body == "full")
    plain = [name for name in formats if find_exporter(name).fit is None]
    for path in export_all(given, placed, plain, folder=out, options=chosen, partial=partial):
        say(str(path))
    for name in formats:
        if (fit := find_exporter(name).fit) is not None:
            room, there = fit(given, placed)
            found = solve_again(room, start=there)
            left = tuple(sorted(set(placed) - set(found.layout)))
            inside = replace(chosen, left_out=left)
            say(*map(str, export_all(found.scene, found.layout, [name], folder=out, options=inside, partial=partial)))
            verdict = "ok" if found.report.ok else " ".join(["not ok:", *found.report.violations])
            say(f"solved again with the sizes of {name}'s things: {verdict}")
            say(f"left out, for want of a counterpart: {', '.join(left) or 'nothing'}")


for _command in (
    generate, batch, evaluate, check, render, diff, compare, export, agents, constraints, assets, settle, drive
):  # fmt: skip
    app.command()(_command)
