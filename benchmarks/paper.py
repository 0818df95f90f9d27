"""The paper's experiments (`paper.toml`): rooms, sizes, solvers, with and without reach and refinement."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from benchmarks.examples import ROOT
from benchmarks.measures import figures, watch
from benchmarks.store import Row
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
