"""A page to leaf through rows of rooms with filters; it needs no network and runs nothing that a room says."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from typing import Any

from robolayout._text import html, printable
from robolayout.page import part, sealed

MOST = 5000  # rows that one page holds; the index has all


def columns(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the names of all columns, in the order in which they first come."""
    return list(dict.fromkeys(name for row in rows for name in row))


def page(
    title: str, rows: Sequence[Mapping[str, Any]], *, thumbs: bool = False, plots: Mapping[str, bytes] | None = None
) -> str:
    """Return the page.

    Args:
        thumbs: Whether each row's `path` holds a picture `thumb.png`.
        plots: PNG pictures to show above, by what they show.
    """
    names = columns(rows)
    values = ((row.get(name) for name in names) for row in rows[:MOST])
    cells = [[printable(value) if isinstance(value, str) else value for value in row] for row in values]
    note = f"The first {MOST} of {len(rows)} rooms; the index has all." if len(rows) > MOST else ""
    shown = "".join(
        f'<figure><img alt="{html(name)}" src="data:image/png;base64,{base64.b64encode(data).decode()}">'
        f"<figcaption>{html(name)}</figcaption></figure>"
        for name, data in (plots or {}).items()
    )
    data = {"columns": names, "rows": cells, "thumbs": thumbs}
    parts = {"title": html(title), "note": html(note), "plots": shown}
    html_, script, style = (part("robolayout.many", f"many.{suffix}") for suffix in ("html", "js", "css"))
    return sealed(html_, script, style, data, images="'self' file: data:", **parts)
