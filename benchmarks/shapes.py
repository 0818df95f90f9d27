"""What shapes are worth: crowded rooms laid out and judged with the shapes of things, and with their boxes."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context
from pathlib import Path

import robolayout as rl
from benchmarks.measures import warmed
from benchmarks.rooms import Crowd, crowd
from benchmarks.store import Row
from benchmarks.tables import Rows, table
from robolayout.assets import Prism, prisms_of
from robolayout.scene import Asset

FILLS, COUNTS, SEEDS = (0.45, 0.60), (10, 20), range(3)


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield every room with shapes and with boxes, one right after the other."""
    for fill in FILLS[:1] if quick else FILLS:
        for count in COUNTS[:1] if quick else COUNTS:
            for seed in SEEDS[:1] if quick else SEEDS:
                asked = Crowd(count, fill, seed)
                for kind in ("shapes", "boxes"):
                    yield f"{fill:.0%}/{kind}/{asked.key}", partial(measured, asked, boxes=kind == "boxes")


def measured(asked: Crowd, *, boxes: bool) -> Row:
    """Lay a crowded room out in a process of its own, whose modules remember no other shapes."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(_laid_out, asked, boxes=boxes).result()


def _laid_out(asked: Crowd, *, boxes: bool) -> Row:
    """Lay it out, perhaps with every thing its box."""
    real = prisms_of  # this module's name for it is replaced, too
    for module in list(sys.modules.values()) if boxes else ():
        if getattr(module, "prisms_of", None) is real:
            vars(module)["prisms_of"] = _box
    content, program = crowd(asked)
    return warmed(rl.scene_from_dict(content), program=program, seed=asked.seed)[1]


def _box(asset: Asset) -> tuple[Prism, ...]:
    depth, width, height = asset.size
    return (Prism(0.0, 0.0, depth / 2, width / 2, 0.0, 0.0, height),)


def section(rows: Rows, images: Path) -> str:
    """Return the table of rooms by how full they are."""
    lines: list[list[str]] = []
    for fill in FILLS:
        found = {k: [r for key, r in rows.items() if key.startswith(f"{fill:.0%}/{k}/")] for k in ("shapes", "boxes")}
        for kind, some in found.items():
            met = f"{sum(r['met'] for r in some)} of {sum(r['asked'] for r in some)}"
            ok = f"{sum(r['ok'] for r in some)} of {len(some)}"
            lines.append(
                [f"{fill:.0%}", kind, ok, met, str(sum(r["short"] for r in some)), f"{sum(r['cpu'] for r in some):.1f}"]
            )
    intro = (
        "The crowded rooms with blind programs of 10 and 20 assets (`benchmarks/shapes.py`), laid out and judged with shapes, "
        "and with every thing its box.\n"
    )
    heads = ["floor filled", "with", "everything met", "statements met", "out of reach", "CPU s in all"]
    return f"## Shapes against boxes\n\n{intro}\n{table(heads, lines)}"
