"""Small pieces of HTML for notebooks; every text is escaped."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from robolayout._text import html


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table; the first column is text, the others are figures."""
    top = "".join(f"<th>{html(head)}</th>" for head in heads)
    styles = [' style="text-align:left"', *[""] * (len(heads) - 1)]
    cells = ("".join(f"<td{style}>{html(text)}</td>" for style, text in zip(styles, row, strict=True)) for row in rows)
    body = "".join(f"<tr>{row}</tr>" for row in cells)
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def paragraph(text: str) -> str:
    """Return a paragraph in bold."""
    return f"<p><b>{html(text)}</b></p>"


def bullets(sentences: Sequence[str], most: int) -> str:
    """Return a list of at most `most` sentences and how many more there are; nothing for none."""
    shown = list(sentences[:most])
    if len(sentences) > most:
        shown.append(f"and {len(sentences) - most} more")
    return f"<ul>{''.join(f'<li>{html(sentence)}</li>' for sentence in shown)}</ul>" if shown else ""
