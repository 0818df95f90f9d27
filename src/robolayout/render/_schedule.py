"""The lists beside a plan on a sheet: rows of text in columns, as large as fits."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from robolayout.render._drawing import Drawing, Point, text_width
from robolayout.render._style import SHEET
from robolayout.render.palette import INK, QUIET


@dataclass(frozen=True)
class Line:
    """One entry of a list, and each line that is printed of it."""

    words: str  # what it says; an entry runs on over several lines where it must
    mark: str = ""  # what stands before it: a number, a bullet
    value: str = ""  # what stands at the right end of its first line
    indent: float = 0.0  # where its words begin, in font sizes
    heading: bool = False  # whether it is the heading of a block


@dataclass(frozen=True)
class Block:
    """A heading and its rows."""

    title: str  # the heading
    rows: tuple[Line, ...]  # what stands below it
    indent: float = 0.0  # width that is kept for the marks, in font sizes


def columns(blocks: Sequence[Block], size: float, width: float, count: int, height: float) -> list[list[Line]] | None:
    """Return the lines of columns as low as may be; None if `count` of this width and height do not hold the blocks."""
    most = int(height / (size * SHEET.line) + 1e-6)
    found = _filled(blocks, size, width, most)
    if most < SHEET.shortest or len(found) > count:
        return None
    while most > SHEET.shortest and len(lower := _filled(blocks, size, width, most - 1)) <= count:
        found, most = lower, most - 1
    return found


def _filled(blocks: Sequence[Block], size: float, width: float, most: int) -> list[list[Line]]:
    """Return the lines of columns that hold `most` lines each; no heading is the last of its column."""
    found: list[list[Line]] = [[]]
    for block in blocks:
        lines = list(_lines(block, size, width))
        if found[-1] and len(found[-1]) + 1 + min(len(lines), 3) > most:
            found.append([])
        if found[-1]:
            found[-1].append(Line(""))
        for line in lines:
            if len(found[-1]) >= most:
                found.append([])
            found[-1].append(line)
    return found


def shortened(blocks: Sequence[Block], size: float, width: float, count: int, height: float) -> list[list[Line]]:
    """Return the lines that find a place in so many columns; the last one says how many do not."""
    every = _filled(blocks, size, width, max(int(height / (size * SHEET.line)), SHEET.shortest))
    kept = every[:count]
    lost = sum(len(column) for column in every[count:])
    if lost and kept:
        kept[-1] = [*kept[-1][:-1], Line(f"... and {lost + 1} more lines, which found no place: see the report")]
    return kept


def draw_columns(sheet: Drawing, lines: Sequence[Sequence[Line]], corner: Point, size: float, width: float) -> None:
    """Write columns side by side from a left upper corner on, in millimetres."""
    for number, column in enumerate(lines):
        x, y = corner[0] + number * (width + SHEET.gap), corner[1]
        for line in column:
            y += size * SHEET.line
            middle = y - size * SHEET.line / 2
            if line.heading:
                sheet.words((x, middle), line.words, size * SHEET.head, anchor="start", color=INK)
                sheet.line([(x, y - 0.1), (x + width, y - 0.1)], QUIET, width=0.15)
                continue
            if line.mark:
                sheet.words((x, middle), line.mark, size, anchor="start", color=INK)
            sheet.words((x + line.indent * size, middle), line.words, size, anchor="start", color=INK)
            if line.value:
                sheet.words((x + width, middle), line.value, size, anchor="end", color=INK)


def _lines(block: Block, size: float, width: float) -> Iterator[Line]:
    """Yield the lines of a block: its heading, then its rows, wrapped."""
    yield Line(block.title, heading=True)
    for row in block.rows:
        value = text_width(row.value, size) + size if row.value else 0.0
        pieces = wrapped(row.words, size, width - block.indent * size - value)
        yield Line(pieces[0], row.mark, row.value, block.indent)
        yield from (Line(piece, indent=block.indent) for piece in pieces[1:])


@lru_cache(maxsize=4096)
def wrapped(text: str, size: float, width: float) -> tuple[str, ...]:
    """Return a text in lines no wider than `width`: broken at spaces, and inside words that are wider."""
    lines = [""]
    for word in re.findall(r"\S+", text):
        joined = f"{lines[-1]} {word}".strip()
        if text_width(joined, size) <= width:
            lines[-1] = joined
            continue
        if lines[-1]:
            lines.append("")
        for letter in word:
            if lines[-1] and text_width(lines[-1] + letter, size) > width:
                lines.append("")
            lines[-1] += letter
    return tuple(lines)
