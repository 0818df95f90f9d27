"""`robolayout agents`: the bodies that can be given by name, and one of them with sources and a drawing."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from robolayout._errors import InputError
from robolayout._files import write_atomic
from robolayout.cli.options import ending
from robolayout.cli.terminal import say, table

if TYPE_CHECKING:
    from robolayout.scene import Agent


def agents(
    name: Annotated[
        str | None,
        typer.Argument(help="Show one body with its sources: a name, or a .toml, .json, .urdf or .xml file."),
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", help="Draw it to this file: SVG, PNG or PDF.")] = None,
) -> None:
    """List the built-in bodies, or one with its sources and a drawing."""
    from robolayout.scene import agent_names, load_agent

    if name is not None:
        _one(load_agent(name), out)
        return
    if out is not None:
        raise InputError("--out draws one body: name it, such as `robolayout agents wheelchair --out wheelchair.svg`.")
    rows: list[list[str]] = []
    for known in agent_names():
        a = load_agent(known)
        shape = f"disc {2 * a.radius:.2f}" if a.length is None or a.width is None else f"{a.length:.2f} x {a.width:.2f}"
        heights = "-" if a.reach_distance is None else f"{a.reach_low:.2f}-{a.reach_high:.2f}"
        rows.append([known, a.title, shape, f"{a.radius:.3f}", f"{a.height:.2f}", f"{a.reach:.2f}", heights])
    table("Agents (metres)", ["name", "body", "footprint", "radius", "height", "reach", "heights"], rows)


def _one(body: Agent, out: Path | None) -> None:
    """Show a body: its figures with their sources, and a drawing on the terminal or in a file."""
    from robolayout.render import body_text, draw_body

    suffix = "" if out is None else ending(out, "a body", (".svg", ".png", ".pdf"))
    figures = [
        [key, f"{value:g}", "yes" if source.verified else "no", source.text]
        for key, source in body.sources.items()
        if (value := getattr(body, key)) is not None
    ]
    figures += [[key, f"{value:g}", "-", "given without a source"] for key, value in _unsourced(body)]
    table(f"{body.title or body.name} (metres)", ["figure", "value", "verified", "source"], figures)
    if out is not None:
        say(str(write_atomic(out, draw_body(body).file(suffix))))
    elif (sys.stdout.encoding or "utf-8").lower().startswith("utf"):
        say(*body_text(body).splitlines())


def _unsourced(body: Agent) -> list[tuple[str, float]]:
    """Return the figures of a body that have no source: those of a user's own file."""
    from robolayout.scene.agents_io import FIGURES

    found = [(key, getattr(body, key)) for key in ("radius", "height", *FIGURES) if key not in body.sources]
    given = body.reach_distance is not None
    return [(k, v) for k, v in dict(found).items() if v is not None and (given or not k.startswith("reach_"))]
