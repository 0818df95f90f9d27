"""A page to leaf through rows of rooms with filters; it needs no network and runs nothing that a room says."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from robolayout._text import html, printable
from robolayout.page import part, sealed


@dataclass(frozen=True)
class PageConfig:
    """How much of a data set its pages and pictures show."""

    rows: int = 5000  # rows that one page holds; the index has all
    tile: int = 160  # pixels of a side of one room in the picture of all
    tiles: int = 600  # rooms in that picture; of more, so many at even distances
    plotted: int = 24  # figures that a plot shows
    thumb: int = 240  # pixels of a side of the small picture that every room has


PAGES = PageConfig()


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
