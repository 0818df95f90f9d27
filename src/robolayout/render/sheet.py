"""A plan to print: one sheet of paper with the room to scale, its dimensions, a furniture list and what was found.

Paper (A4, else A3), direction, scale and size of the lists are those of the first arrangement that holds everything.
A millimetre of the drawing is a millimetre of paper, so that lengths can be measured with a ruler.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from itertools import groupby

from robolayout.render._dimensions import Outline, chained, draw_chains
from robolayout.render._drawing import Drawing, Point, rectangle, text_width
from robolayout.render._labels import Label, upright
from robolayout.render._marked import Naming
from robolayout.render._style import PLAN, SHEET
from robolayout.render.contents import Place, PlanMarks, Shown, named_at, placing, swings
from robolayout.render.palette import INK, QUIET
from robolayout.render.plan import draw_legend, draw_room, draw_scale_bar
from robolayout.scene import Agent, Asset, Layout, Opening, Scene, Wall

PAPERS = {"A4": (210.0, 297.0), "A3": (297.0, 420.0)}  # width and height of the papers, millimetres
SCALES = (
    *(("A4", scale) for scale in (20, 25, 50)),
    *(("A3", scale) for scale in (20, 25, 50)),
    *((paper, scale) for scale in (100, 200, 500, 1000, 2000, 5000) for paper in PAPERS),
)
"""Papers and scales in the order in which they are tried: what a home printer takes, before small drawings."""


@dataclass(frozen=True)
class SheetNotes:
    """What a sheet says beside the drawing."""

    date: str = ""  # what the title block gives as the date, as the user wrote it; nothing leaves it out
    areas: tuple[tuple[str, str], ...] = ()  # what is measured of the room, and the figure with its unit
    verdict: str = ""  # whether all demands are met, in a few words
    findings: tuple[str, ...] = ()  # what is wrong and what would help, in sentences
    rules: tuple[tuple[str, str, bool], ...] = ()  # names of rules, what was measured in words, and whether each is met
    # for each thing that stands on another one the name of that
    carriers: Mapping[str, str] = field(default_factory=dict[str, str])


@dataclass(frozen=True)
class _Given:
    """What is drawn."""

    scene: Scene
    layout: Layout
    notes: SheetNotes
    marks: PlanMarks
    agent: Agent
    numbers: Mapping[str, int]  # of each thing that has one; equal things have numbers that follow each other
    carriers: Mapping[str, str]  # for each thing without a number, the numbered one that carries it
    rows: tuple[Line, ...]  # the furniture list


@dataclass(frozen=True)
class _Arranged:
    """Where everything stands on the paper, millimetres."""

    paper: str
    size: Point
    scale: int
    plan: Point
    lists: Point
    text: float
    width: float
    lines: list[list[Line]]


def draw_sheet(scene: Scene, layout: Layout, notes: SheetNotes, *, marks: PlanMarks, agent: Agent) -> Drawing:
    """Return the sheet as a drawing in paper millimetres."""
    marks = replace(marks, routes={}, arcs=(), agent_at=None)
    given = _Given(scene, layout, notes, marks, agent, *_furniture(scene, layout, notes.carriers))
    at = _arranged(scene, _blocks(given))
    sheet = Drawing(*at.size)
    right, bottom = sheet.width - SHEET.edge, sheet.height - SHEET.edge
    sheet.polygon([rectangle(SHEET.edge, SHEET.edge, right, bottom)], None, stroke=INK, width=0.4)
    sheet.line([(SHEET.edge, bottom - SHEET.title), (right, bottom - SHEET.title)], INK, width=0.4)
    _draw_plan(sheet, given, at)
    draw_columns(sheet, at.lines, at.lists, at.text, at.width)
    _draw_title(sheet, given, at)
    return sheet


def _arranged(scene: Scene, blocks: Sequence[Block]) -> _Arranged:
    """Return the first arrangement that holds the plan and the lists; if none does, the lists are cut."""
    for paper, scale in SCALES:
        for text in SHEET.texts:
            for found, count, height in _places(scene, paper, scale, text):
                lines = columns(blocks, text, found.width, count, height)
                if lines is not None:
                    return replace(found, lines=lines)
    fallbacks = (
        place for paper, scale in SCALES for place in _places(scene, paper, scale, SHEET.texts[-1]) if paper == "A3"
    )
    found, count, height = next(fallbacks)
    return replace(found, lines=shortened(blocks, found.text, found.width, count, height))


def _places(scene: Scene, paper: str, scale: int, text: float) -> Iterator[tuple[_Arranged, int, float]]:
    """Yield where plan and lists can stand, with the number and the height of the lists' columns."""
    width, height = _plan_size(scene, scale)
    short, long = PAPERS[paper]
    for size in ((long, short), (short, long)):
        inner = (size[0] - 2 * (SHEET.edge + SHEET.inset), size[1] - 2 * SHEET.edge - SHEET.title - 2 * SHEET.inset)
        if width > inner[0] or height + SHEET.legend > inner[1]:
            continue
        corner = SHEET.edge + SHEET.inset
        right = inner[0] - width - SHEET.gap
        if (count := int((right + SHEET.gap) / (SHEET.column * text + SHEET.gap))) > 0:
            column = min((right - (count - 1) * SHEET.gap) / count, SHEET.widest * text)
            taken = count * (column + SHEET.gap)
            left = (inner[0] - taken - width) / 2
            plan = (corner + left, corner + (inner[1] - height - SHEET.legend) / 2)
            lists = (corner + inner[0] - taken + SHEET.gap, corner)
            yield _Arranged(paper, size, scale, plan, lists, text, column, []), count, inner[1]
        below = inner[1] - height - SHEET.legend - SHEET.gap
        count = max(1, int((inner[0] + SHEET.gap) / (SHEET.column * text + SHEET.gap)))
        if below > 10 * text:
            column = (inner[0] - (count - 1) * SHEET.gap) / count
            plan = (corner + (inner[0] - width) / 2, corner)
            lists = (corner, corner + height + SHEET.legend + SHEET.gap)
            yield _Arranged(paper, size, scale, plan, lists, text, column, []), count, below


def _plan_size(scene: Scene, scale: int) -> Point:
    """Return width and height of the plan with its dimension lines, millimetres."""
    k = 1000 / scale
    x0, y0, x1, y1 = chained(scene.room, k)
    return ((x1 - x0) * k, (y1 - y0) * k)


def _draw_plan(sheet: Drawing, given: _Given, at: _Arranged) -> None:
    """Draw room, dimension lines, numbers and legend."""
    scene = given.scene
    k = 1000 / at.scale
    place = placing(chained(scene.room, k), k, *at.plan)
    width, height = _plan_size(scene, at.scale)
    written = draw_chains(sheet, scene.room, place, k, _draw_names(sheet, given, place, k))
    numbers = given.numbers.items()
    texts = {name: (f"{number} {scene.by_name[name].category}".strip(), str(number)) for name, number in numbers}
    box = (at.plan[0], at.plan[1], at.plan[0] + width, at.plan[1] + height)
    naming = Naming(box, texts, SHEET.names, tuple(written), swings(scene.room))
    draw_room(sheet, Shown(scene, given.layout, given.marks, given.agent, place), naming)
    (left, _), (right, _) = place(*scene.room.bounds[:2]), place(*scene.room.bounds[2:])
    draw_legend(sheet, given.marks, (left, at.plan[1] + height + SHEET.legend / 2), right - left)


def _openings(scene: Scene) -> list[tuple[str, str, Opening]]:
    """Return doors and windows with the names that the sheet gives them, and what they are."""
    kinds = (("D", "door", scene.room.doors), ("W", "window", scene.room.windows))
    return [(f"{letter}{n}", what, opening) for letter, what, row in kinds for n, opening in enumerate(row, 1)]


def _draw_names(sheet: Drawing, given: _Given, place: Place, k: float) -> list[Outline]:
    """Write the names of doors and windows, and of walls that are spoken of, outside them; return their outlines."""
    scene, walls = given.scene, given.scene.room.walls
    spoken = sorted({int(number) for text in given.notes.findings for number in re.findall(r"\bwall (\d+)", text)})
    named = [
        (name, walls[opening.wall], opening.center, named_at(opening) if what == "door" else 0.0)
        for name, what, opening in _openings(scene)
    ]
    named += [(f"wall {i}", walls[i], _bare_middle(scene, walls[i]), 0.0) for i in spoken if i < len(walls)]
    outlines: list[Outline] = []
    for name, wall, along, out in named:
        at = place(*wall.point(along, -PLAN.wall - max(out, 2.2 / k)))
        quiet = name.startswith("wall")
        (ax, ay), (bx, by) = place(*wall.start), place(*wall.end)
        angle = upright(math.degrees(math.atan2(ay - by, bx - ax))) if quiet else 0.0
        label = Label((name,), at, 1.8 if quiet else 2.1, angle)
        sheet.words(at, name, label.size, color=QUIET if quiet else INK, angle=angle)
        outlines.append(label.corners)
    return outlines


def _bare_middle(scene: Scene, wall: Wall) -> float:
    """Return the middle of a wall's longest stretch without opening, metres from its start."""
    free = wall.between((*scene.room.doors, *scene.room.windows))
    a, b = max(free, key=lambda pair: pair[1] - pair[0], default=(0.0, 0.0))
    return (a + b) / 2


def _blocks(given: _Given) -> list[Block]:
    """Return the lists of the sheet."""
    scene, notes = given.scene, given.notes
    areas = [Line(words, value=value) for words, value in notes.areas]
    sizes = [
        Line(f"{name} {what}", value=f"{o.width:.2f} x {o.height:.2f}{f', sill {o.sill:.2f}' if o.sill else ''}")
        for name, what, o in _openings(scene)
    ]
    findings = [Line(_numbered(sentence, given), "-") for sentence in notes.findings]
    rules = [Line(f"{rule}: {_numbered(words, given)}", "met" if met else "NOT") for rule, words, met in notes.rules]
    blocks = [
        Block("Room", tuple(areas)),
        Block("Doors and windows, m", tuple(sizes)),
        Block("Furniture, cm: width x depth x height", given.rows, 4.2),
        Block("Rules of accessibility", tuple(rules), 2.6),
    ]
    told = Block(f"Findings: {notes.verdict}".removesuffix(": "), tuple(findings), 1.0)
    return [*(block for block in blocks if block.rows), told]


def _numbered(sentence: str, given: _Given) -> str:
    """Return a sentence with the things' numbers in place of their keys, and the sheet's names of the doors."""
    sentence = re.sub(r"\bdoor (\d+)", lambda match: f"door D{int(match[1]) + 1}", sentence)
    scene, numbers, carriers = given.scene, given.numbers, given.carriers
    names = sorted(scene.by_name, key=len, reverse=True)
    if not names:
        return sentence

    def shown(match: re.Match[str]) -> str:
        name = match[0]
        words = scene.by_name[name].category or name
        if name in numbers:
            return f"{words} ({numbers[name]})"
        return f"{words} (on {numbers[carriers[name]]})" if name in carriers else words

    return re.sub(rf"(?<![\w-])(?:{'|'.join(map(re.escape, names))})(?![\w-])", shown, sentence)


def _draw_title(sheet: Drawing, given: _Given, at: _Arranged) -> None:
    """Draw the title block: what it is, for whom, at what scale, and when."""
    scene, notes, agent = given.scene, given.notes, given.agent
    top, bottom = sheet.height - SHEET.edge - SHEET.title, sheet.height - SHEET.edge
    right = sheet.width - SHEET.edge
    cells = [("Date", 30.0)] if notes.date else []
    cells = [*cells, ("Scale", 44.0), ("For", 46.0)]
    left = {}
    for caption, width in cells:
        right -= width
        left[caption] = right
        sheet.line([(right, top), (right, bottom)], INK, width=0.2)
        sheet.words((right + 2.0, top + 3.0), caption, 1.8, anchor="start", color=QUIET)
    if notes.date:
        _write(sheet, (left["Date"] + 2.0, top + 9.0), notes.date, 3.2, 26.0)
    x = left["Scale"] + 2.0
    sheet.words((x, top + 8.5), f"1 : {at.scale}", 4.2, anchor="start", color=INK)
    sheet.words((x, top + 13.0), f"on {at.paper}, printed at 100 %", 1.8, anchor="start", color=QUIET)
    draw_scale_bar(sheet, (x + 0.5, top + 17.0), at.scale, 36.0)
    _write(sheet, (left["For"] + 2.0, top + 8.5), agent.title or agent.name, 3.0, 42.0)
    needs = f"needs {2 * agent.radius:.2f} m to pass"
    turns = f", {agent.turning_diameter:.2f} m to turn" if agent.turning_diameter else ""
    _write(sheet, (left["For"] + 2.0, top + 13.0), needs + turns, 1.8, 42.0, QUIET)
    room = left["For"] - SHEET.edge - 4.0
    _write(sheet, (SHEET.edge + 2.0, top + 5.5), scene.name.replace("_", " "), 5.0, room)
    lines = wrapped(scene.task_description, 2.2, room)
    kept = lines if len(lines) <= 3 else (*lines[:2], f"{lines[2]} ...")
    for number, line in enumerate(kept):
        _write(sheet, (SHEET.edge + 2.0, top + 11.5 + 3.4 * number), line, 2.2, room, QUIET)


def _write(sheet: Drawing, at: Point, words: str, size: float, width: float, color: str = INK) -> None:
    """Write a line that keeps within a width: smaller if need be, and cut where that would be too small."""
    least = 0.6 * size
    if text_width(words, least) > width:
        words = f"{wrapped(words, least, width - text_width(' ...', least))[0]} ..."
    sheet.words(at, words, min(size, size * width / max(text_width(words, size), 0.1)), anchor="start", color=color)


def _furniture(
    scene: Scene, layout: Layout, below: Mapping[str, str]
) -> tuple[Mapping[str, int], Mapping[str, str], tuple[Line, ...]]:
    """Return the numbers and the list of everything in a scene; what stands on another thing (`below`) is listed with it."""
    carriers = {name: _lowest(name, below) for name in below}
    kinds: dict[tuple[str, tuple[float, ...]], list[Asset]] = {}
    for asset in scene.assets:
        kinds.setdefault((asset.category, asset.size), []).append(asset)
    order = [asset for kind in kinds.values() for asset in kind]
    numbered = [asset for asset in order if asset.name in layout and asset.name not in carriers]
    numbers = {asset.name: number for number, asset in enumerate(numbered, 1)}
    rows = [_row(found, _spans([numbers[a.name] for a in found]), "") for found in _kinds(numbered)]
    for found in _kinds([asset for asset in order if asset.name in carriers]):
        on = _spans(sorted({numbers[carriers[asset.name]] for asset in found}))
        rows.append(_row(found, "", f"on {on}"))
    rows += [_row(found, "-", "not placed") for found in _kinds([a for a in order if a.name not in layout])]
    return numbers, carriers, tuple(rows)


def _spans(numbers: Sequence[int]) -> str:
    """Return rising numbers in words: "3", "4-9, 12"."""
    runs = ([n for _, n in run] for _, run in groupby(enumerate(numbers), lambda pair: pair[1] - pair[0]))
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in runs)


def _centimetres(metres: float) -> str:
    """Return a length in whole _centimetres, below 10 cm to a millimetre."""
    return f"{100 * metres:.0f}" if metres >= 0.1 else f"{round(100 * metres, 1):g}"


def _kinds(assets: Sequence[Asset]) -> list[list[Asset]]:
    """Return neighbours of one category and size together."""
    return [list(found) for _, found in groupby(assets, lambda asset: (asset.category, asset.size))]


def _row(found: Sequence[Asset], mark: str, note: str) -> Line:
    asset = found[0]
    depth, width, height = map(_centimetres, asset.size)
    count = f"{len(found)} x " if len(found) > 1 and not mark.isdigit() else ""
    words = f"{count}{asset.category or asset.name}" + (f", {note}" if note else "")
    return Line(words, mark, f"{width} x {depth} x {height}")


def _lowest(name: str, below: Mapping[str, str]) -> str:
    """Return what carries a thing in the end; each step leads lower, so that there is an end."""
    while name in below:
        name = below[name]
    return name


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
