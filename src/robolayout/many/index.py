"""What is about the whole set: the index, splits, the card, one picture of all rooms and a page to leaf through."""

from __future__ import annotations

import base64
import csv
import io
import statistics
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from string import Template
from typing import Any

import numpy as np
from PIL import Image

from robolayout._errors import MissingExtraError
from robolayout._files import write_atomic
from robolayout._reading import LIMITS, Unreadable, regular_bytes
from robolayout._reading.glb import glb_notice
from robolayout._text import TOLD, html, markdown, printable
from robolayout._version import __version__
from robolayout.many.spec import Ready
from robolayout.many.variety import VARIETY
from robolayout.page import part, sealed
from robolayout.render import png_bytes
from robolayout.render.animation import spread


@dataclass(frozen=True)
class PageConfig:
    """How much of a data set its pages and pictures show."""

    rows: int = 5000  # rows that one page holds; the index has all
    tile: int = 160  # pixels of a side of one room in the picture of all
    tiles: int = 600  # rooms in that picture; of more, so many at even distances
    plotted: int = 24  # figures that a plot shows
    thumb: int = 240  # pixels of a side of the small picture that every room has


PAGES = PageConfig()

OWN = "Own meshes, with the notice that each file holds:"

SUMMED = (
    "area", "things", "kinds", "collision_free_share", "walkable_ratio", "reachable_share_chairs_aside", "usable_share",
    "statements_met_share", "asked_met_share", "difference",
)  # fmt: skip
"""Figures whose range the card tells."""


def write_index(ready: Ready, folder: Path, rows: list[dict[str, Any]], reasons: Mapping[str, int]) -> None:
    """Write everything that is about the whole set: of its rows, one a room in order, and why tries were replaced."""
    spec = ready.spec
    order = np.random.default_rng(spec.seed).permutation(len(rows))
    test = set(order[: round(spec.test * len(rows))].tolist())
    for number, row in enumerate(rows):
        row["split"] = "test" if number in test else "train"
    for split in ("train", "test"):
        paths = [f"{row['path']}\n" for row in rows if row["split"] == split and row["status"] != "missing"]
        write_atomic(folder / f"{split}.txt", "".join(paths))
    write_rows(folder / "index", rows)
    write_atomic(folder / "README.md", card(ready, rows, reasons))
    write_atomic(folder / "contact.png", contact(folder, rows))
    write_atomic(folder / "index.html", page(f"{len(rows)} rooms", rows, thumbs=True))


def check_tables() -> None:
    """Raise MissingExtraError where Parquet cannot be written."""
    if find_spec("pyarrow") is None:
        raise MissingExtraError("a table in Parquet", "many")


def write_rows(stem: Path, rows: Sequence[Mapping[str, Any]]) -> list[Path]:
    """Write rows as `<stem>.csv` and `<stem>.parquet`; what a row lacks is empty."""
    import pyarrow
    import pyarrow.parquet

    names = columns(rows)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([names, *([row.get(name, "") for name in names] for row in rows)])
    table: dict[str, list[Any]] = {}
    for name in names:
        values = [row.get(name) for row in rows]
        if {type(value) for value in values} - {type(None)} in ({int, float}, {bool, float}):  # one type in a column
            values = [None if value is None else float(value) for value in values]
        table[name] = values
    stream = io.BytesIO()
    pyarrow.parquet.write_table(pyarrow.table(table), stream, compression="zstd")
    files = {".csv": text.getvalue(), ".parquet": stream.getvalue()}
    return [write_atomic(stem.with_name(stem.name + suffix), data) for suffix, data in files.items()]


def contact(folder: Path, rows: Sequence[Mapping[str, Any]]) -> bytes:
    """Return one picture of the rooms, in order."""
    there = [row for row in rows if row["status"] != "missing"]
    there = [there[k] for k in spread(len(there), PAGES.tiles)]
    across = max(1, int(np.ceil(np.sqrt(1.6 * len(there)))))
    down = max(1, -(-len(there) // across))
    sheet = Image.new("RGB", (across * PAGES.tile, down * PAGES.tile), "white")
    for number, row in enumerate(there):
        with Image.open(folder / row["path"] / "thumb.png") as picture:
            tile = picture.convert("RGB")
        tile.thumbnail((PAGES.tile - 4, PAGES.tile - 4), Image.Resampling.LANCZOS)
        left, top = (PAGES.tile - tile.width) // 2, (PAGES.tile - tile.height) // 2
        sheet.paste(tile, (number % across * PAGES.tile + left, number // across * PAGES.tile + top))
    return png_bytes(sheet.quantize(256))


def card(ready: Ready, rows: Sequence[Mapping[str, Any]], reasons: Mapping[str, int]) -> str:
    """Return the card of the set in Markdown: how it was made, what it holds, whose things are in it."""
    spec = ready.spec
    count = Counter(row["status"] for row in rows)
    told = {"unmet": "do not, and were kept", "missing": "were given up (status `missing`, with the reason)"}
    states = [f"- {count['met']} rooms meet all their demands"]
    states += [f"- {count[status]} rooms {words}" for status, words in told.items() if count[status]]
    states += [f"- {sum(reasons.values())} tries were replaced"]
    states += [f"  - {number} x {markdown(why)}" for why, number in list(reasons.items())[: TOLD.shown]]
    if spec.distinct:
        near = sum(row["difference"] < VARIETY.least for row in rows if row["status"] != "missing")
        alike = f"pairs with less than {VARIETY.least:.0%} of their things at other places"
        states += [f"- {near} near-duplicates ({alike}) are left"]
    known = {name: [float(row[name]) for row in rows if row.get(name) is not None] for name in SUMMED}
    found = [(name, min(v), statistics.fmean(v), max(v)) for name, v in known.items() if v]
    filled = {
        "count": len(rows),
        "version": __version__,
        "seed": spec.seed,
        "states": "\n".join(states),
        "figures": "\n".join(f"| {name} | {low:.3g} | {mean:.3g} | {high:.3g} |" for name, low, mean, high in found),
        "sources": _table(Counter(row["source"] for row in rows).items()),
        "things": "",
    }
    if meshes := ready.meshes:
        notices = _table((name, markdown(_notice(path))) for name, path in sorted(meshes.items()))
        filled["things"] = f" {OWN}\n\n| mesh | notice |\n|---|---|\n{notices}"
    return Template(part("robolayout.many", "card.md")).substitute(filled)


def _table(rows: Iterable[tuple[str, object]]) -> str:
    return "\n".join(f"| {markdown(name)} | {value} |" for name, value in rows)


def _notice(path: Path) -> str:
    """Return the copyright notice of a mesh file."""
    try:
        return glb_notice(regular_bytes(path, LIMITS.mesh_bytes)) or "none stated"
    except Unreadable:  # another format, which has no place for one
        return "none stated"


def columns(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the names of all columns, in the order in which they first come."""
    return list(dict.fromkeys(name for row in rows for name in row))


def page(
    title: str, rows: Sequence[Mapping[str, Any]], *, thumbs: bool = False, plots: Mapping[str, bytes] | None = None
) -> str:
    """Return the page: PNG plots by what they show, then the rows, each with `thumb.png` of its `path` if that is asked for."""
    names = columns(rows)
    values = ((row.get(name) for name in names) for row in rows[: PAGES.rows])
    cells = [[printable(value) if isinstance(value, str) else value for value in row] for row in values]
    note = f"The first {PAGES.rows} of {len(rows)} rooms; the index has all." if len(rows) > PAGES.rows else ""
    shown = "".join(
        f'<figure><img alt="{html(name)}" src="data:image/png;base64,{base64.b64encode(data).decode()}">'
        f"<figcaption>{html(name)}</figcaption></figure>"
        for name, data in (plots or {}).items()
    )
    data = {"columns": names, "rows": cells, "thumbs": thumbs}
    parts = {"title": html(title), "note": html(note), "plots": shown}
    html_, script, style = (part("robolayout.many", f"many.{suffix}") for suffix in ("html", "js", "css"))
    return sealed(html_, script, style, data, images="'self' file: data:", **parts)
