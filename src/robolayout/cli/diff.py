"""`robolayout diff`: what differs between two layouts, in words, as JSON and as a picture."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from typer import Argument, Option

from robolayout._files import write_atomic
from robolayout.cli.options import Body, ProgramOption, Told, ending, spread
from robolayout.cli.terminal import say, table

Side = Annotated[Path, Argument(help="A run's folder, or a layout file (with --scene).")]


@spread
def diff(  # noqa: PLR0913 - one parameter per option
    before: Side,
    after: Side,
    body: Body,
    told: Told,
    scene: Annotated[str | None, Option(help="The scene of both layouts; else each folder's own.")] = None,
    program: ProgramOption = None,
    out: Annotated[Path | None, Option(help="Draw before and after: PNG or SVG.")] = None,
    width: Annotated[int, Option(min=256, max=8192, help="Pixels of the PNG's width.")] = 1400,
) -> None:
    """Say what moved, turned, came, went, became better or worse between two layouts (exit code 1: something is worse)."""
    from robolayout.run.diff import diff as compare
    from robolayout.run.outputs import difference_picture
    from robolayout.run.result import load_judged

    suffix = "" if out is None else ending(out, "a difference", (".png", ".svg"))
    given = None if scene is None else body.read(scene)
    found = compare(*(load_judged(side, given, body.read, program) for side in (before, after)))
    if out is not None:
        write_atomic(out, difference_picture(found, suffix, width=width))

    def show() -> None:
        if found.changes:
            rows = [[change.verdict, change.name, change.text] for change in found.changes]
            table(f"{before} -> {after}", ["", "what", "difference"], rows)
        say(_summary(len(found.changes), len(found.worse)), *([] if out is None else [str(out)]))

    told.tell(found.to_dict(), show)
    raise typer.Exit(1 if found.worse else 0)


def _summary(changes: int, worse: int) -> str:
    """Return the outcome in one sentence."""
    if not changes:
        return "Nothing differs."
    return f"{changes} {'difference' if changes == 1 else 'differences'}, {worse} for the worse."
