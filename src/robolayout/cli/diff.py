"""`robolayout diff`: what differs between two layouts, in words, as JSON and as a picture."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer

from robolayout._errors import InputError
from robolayout.cli.generate import AgentOption, AssetDirOption, JsonOption, QuietOption, read_scene
from robolayout.cli.terminal import say, table

Side = Annotated[Path, typer.Argument(help="A run's folder, or a layout file (with --scene).")]


def diff(  # noqa: PLR0913 - one parameter per option
    before: Side,
    after: Side,
    scene: Annotated[
        str | None, typer.Option("--scene", help="The scene of both layouts; else each folder's own.")
    ] = None,
    program: Annotated[
        Path | None, typer.Option("--program", help="Measure the statements of this program in both.")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Draw before and after: PNG or SVG.")] = None,
    width: Annotated[int, typer.Option("--width", min=256, max=8192, help="Pixels of the PNG's width.")] = 1400,
    agent: AgentOption = None,
    asset_dir: AssetDirOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Say what moved, turned, came, went, became better or worse between two layouts (exit code 1: something is worse)."""
    from robolayout._files import check_writable, write_atomic
    from robolayout.run.diff import diff as compare
    from robolayout.run.diff import load_judged
    from robolayout.run.outputs import difference_picture

    if out is not None:
        if out.suffix.lower() not in (".png", ".svg"):
            raise InputError(f"a difference cannot be drawn to {out}: name a file that ends in .png or .svg.")
        check_writable(out.absolute().parent)
    given = None if scene is None else read_scene(scene, agent, asset_dir)
    sides = [
        load_judged(side, given, lambda file: read_scene(file, agent, asset_dir), program) for side in (before, after)
    ]
    found = compare(*sides)
    if out is not None:
        write_atomic(out, difference_picture(found, out.suffix.lower(), width=width))
    if as_json:
        say(json.dumps(found.to_dict()))
    elif not quiet:
        rows = [[change.verdict, change.name, change.text] for change in found.changes]
        if rows:
            table(f"{before} -> {after}", ["", "what", "difference"], rows)
        say(_summary(len(found.changes), len(found.worse)))
        if out is not None:
            say(str(out))
    raise typer.Exit(1 if found.worse else 0)


def _summary(changes: int, worse: int) -> str:
    """Return the outcome in one sentence."""
    if not changes:
        return "Nothing differs."
    return f"{changes} {'difference' if changes == 1 else 'differences'}, {worse} for the worse."
