"""The paper's experiments (`paper.toml`): rooms, sizes, solvers, with and without reach and refinement."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from benchmarks.examples import ROOT
from benchmarks.measures import figures, watch
from benchmarks.store import Row
from benchmarks.tables import HEADS, Rows, mean, summary, table
from robolayout.many import read_spec
from robolayout.many.room import Drawn, draw, laid_out

SPEC = ROOT / "benchmarks" / "paper.toml"
KINDS = 4
"""Kinds of room, of which the SPEC lists one size after the other."""


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield every combination, those of the first seed and the smaller rooms first."""
    ready = read_spec(SPEC)
    combinations = ready.count // ready.spec.each
    order = sorted(range(ready.count), key=lambda index: (index // combinations, index % len(ready.sources) // KINDS))
    for index in order[: 2 if quick else None]:
        drawn = draw(ready, index)
        room, reach = Path(drawn.facts["source"]).stem, "reach" if drawn.reach else "no reach"
        yield f"{room}/{drawn.solver}/{reach}/{index // combinations}", partial(measured, drawn)


def measured(drawn: Drawn) -> Row:
    """Lay a room out and judge it for its body."""
    with watch() as spent:
        result = laid_out(drawn, "normal")
    return figures(result.report) | {"wall": spent.wall, "cpu": spent.cpu, "assets": len(drawn.scene.assets)}


def section(rows: Rows, images: Path) -> str:
    """Return the table of the paper's experiments, by solver and whether it knows the body."""
    groups: dict[str, list[Row]] = {}
    for key, row in rows.items():
        _, solver, reach, _ = key.split("/")
        groups.setdefault(f"{solver}, {reach}", []).append(row)
    heads = ["solver", "runs", "hard demands met", "all demands met", *HEADS, "CPU s"]
    lines = [[name, *summary(found), f"{mean(found, 'cpu'):.1f}"] for name, found in sorted(groups.items())]
    rooms = sorted({key.split("/")[0].replace("_", " ") for key in rows})
    intro = (
        f"`benchmarks/paper.toml`, as far as it has been measured: {', '.join(rooms)}; for the robot that it names. *No reach*: made for "
        "nobody, judged for the body. *Unrefined*: the paper's algorithm without its last step.\n"
    )
    return f"## The paper's experiments\n\n{intro}\n{table(heads, lines)}"
