"""What is marked on a plan: routes, reach, passages with their widths, and the names of things."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
import shapely

from robolayout.render._drawing import Drawing, Point, circle, rectangle, text_width
from robolayout.render._labels import Box, Label, Tag, place_labels
from robolayout.render._style import LABELS, PLAN
from robolayout.render.contents import Place, PlanMarks, Shown, cord, display_name, front, has_arrow
from robolayout.render.palette import INK, NARROW, PAPER, QUIET, REACH, ROUTE, TIGHT, TURN
from robolayout.scene import Pose, Scene, vertical_span

Passage = tuple[Point, Point, float]
"""The two ends of a passage on the paper, millimetres, and its width in metres."""


@dataclass(frozen=True)
class Naming:
    """How the names on a plan are written."""

    box: Box  # left, upper, right and lower edge that they keep within, millimetres
    # for each asset that is named, what is written, and what where that finds no place; None is the names of all
    texts: Mapping[str, tuple[str, str]] | None = None
    sizes: tuple[float, ...] = LABELS.sizes  # font sizes that are tried, millimetres
    obstacles: tuple[tuple[Point, ...], ...] = ()  # outlines that names keep off, besides things and walls
    # lines in metres that names and widths keep off if they can: doors and how they swing
    lines: tuple[tuple[Point, ...], ...] = ()


def draw_marks(sheet: Drawing, shown: Shown) -> None:
    """Draw turning circles, reach, routes with a dot at their end, and the agent's disc."""
    marks, agent, place = shown.marks, shown.agent, shown.place
    k = millimetres(place)
    for center, diameter in marks.circles:
        sheet.polygon([circle(place(*center), diameter / 2 * k, 72)], None, stroke=TURN, width=0.3, dash=(1.4, 0.8))
    for points in marks.arcs:
        fan = [place(*p) for p in points]
        sheet.polygon([fan], REACH, opacity=0.09)
        sheet.line(fan[1:], REACH, width=0.25)
        sheet.polygon([circle(fan[0], 0.45)], PAPER, stroke=REACH, width=0.2)
    lines = [[place(*p) for p in points] for _, points in sorted(marks.routes.items()) if len(points) > 1]
    for points in lines:
        sheet.line(points, PAPER, width=0.75)
    for points in lines:
        sheet.line(points, ROUTE, width=0.32)
    for points in lines:
        sheet.polygon([circle(points[-1], 0.55)], ROUTE, stroke=PAPER, width=0.15)
    _draw_changes(sheet, marks, place)
    if marks.agent_at is not None and agent is not None:
        at = place(*marks.agent_at)
        sheet.polygon([circle(at, agent.radius * k)], ROUTE, opacity=0.22, stroke=ROUTE, width=0.3)


def _draw_changes(sheet: Drawing, marks: PlanMarks, place: Place) -> None:
    """Draw where things stood before, what is new and what is gone, and arrows from then to now."""
    for outline in marks.ghosts:
        sheet.polygon([[place(*p) for p in outline]], QUIET, opacity=0.1, stroke=QUIET, width=0.25, dash=(0.9, 0.6))
    for outline in marks.gone:
        corners = [place(*p) for p in outline]
        sheet.polygon([corners], None, stroke=TIGHT, width=0.3, dash=(0.9, 0.6))
        for a, b in zip(corners[:2], corners[2:], strict=False):
            sheet.line([a, b], TIGHT, width=0.2, dash=(0.9, 0.6))
    for outline in marks.added:
        sheet.polygon([[place(*p) for p in outline]], None, stroke=NARROW, width=0.6)
    for start, end in marks.arrows:
        (ax, ay), (bx, by) = place(*start), place(*end)
        length = math.dist((ax, ay), (bx, by))
        head = min(PLAN.arrow, 0.6 * length)
        ux, uy = (bx - ax) / length, (by - ay) / length
        neck = (bx - head * ux, by - head * uy)
        sides = [(neck[0] - 0.4 * head * s * uy, neck[1] + 0.4 * head * s * ux) for s in (1, -1)]
        sheet.line([(ax, ay), neck], PAPER, width=0.9)
        sheet.line([(ax, ay), neck], ROUTE, width=0.4)
        sheet.polygon([[(bx, by), *sides]], ROUTE)
        sheet.polygon([circle((ax, ay), 0.5)], PAPER, stroke=ROUTE, width=0.25)


def _draw_passage(sheet: Drawing, passage: Passage, spot: Point, color: str) -> None:
    """Draw a narrowest passage as a measured line, with its width at a place."""
    (ax, ay), (bx, by), metres = passage
    length = max(((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5, 1e-6)
    tick = ((by - ay) / length * 0.9, -(bx - ax) / length * 0.9)
    for stroke, width in ((PAPER, 1.1), (color, 0.5)):
        sheet.line(passage[:2], stroke, width=width)
        for x, y in passage[:2]:
            sheet.line([(x - tick[0], y - tick[1]), (x + tick[0], y + tick[1])], stroke, width=width)
    sheet.words(spot, f"{metres:.2f} m", PLAN.width_text, color=color, halo=PAPER)


def passage_spots(
    passages: Sequence[Passage], lines: Sequence[Sequence[Point]], solids: Sequence[Sequence[Point]]
) -> list[Point]:
    """Return where the width of each passage is written: beside its line, where it covers least."""
    paths = np.array([shapely.LineString(line) for line in (*lines, *(p[:2] for p in passages))], dtype=object)
    blocks = [shapely.Polygon(outline) for outline in solids]
    spots: list[Point] = []
    for number, ((ax, ay), (bx, by), metres) in enumerate(passages):
        length = max(math.dist((ax, ay), (bx, by)), 1e-6)
        nx, ny = (by - ay) / length, (ax - bx) / length
        wide, high = text_width(f"{metres:.2f} m", PLAN.width_text) / 2, 0.45 * PLAN.width_text
        away = 0.7 + abs(nx) * wide + abs(ny) * high
        others, solid = np.delete(paths, len(lines) + number), np.array(blocks, dtype=object)
        found: list[tuple[float, Point, shapely.Polygon]] = []
        for t, side in product((0.5, 0.35, 0.65, 0.2, 0.8), (1, -1)):
            x, y = ax + t * (bx - ax) + side * away * nx, ay + t * (by - ay) + side * away * ny
            box = shapely.box(x - wide, y - high, x + wide, y + high)
            crossed = shapely.length(shapely.intersection(others, box)).sum()
            found.append((float(crossed + 4.0 * shapely.intersects(solid, box).sum()), (x, y), box))
        _, spot, box = min(found, key=lambda row: row[0])
        spots.append(spot)
        blocks.append(box)
    return spots


def draw_labels(sheet: Drawing, shown: Shown, naming: Naming) -> frozenset[str]:
    """Draw the passages and write the names; return what is written."""
    scene, layout, marks, place = shown.scene, shown.layout, shown.marks, shown.place
    outlines = {n: tuple(place(*c) for c in layout[n].corners(scene.by_name[n].size)) for n in layout}
    solid = [n for n in layout if not scene.by_name[n].is_flat and not scene.by_name[n].on_ceiling]
    obstacles = [outlines[n] for n in solid] + list(naming.obstacles)
    for wall in scene.room.walls:
        corners = rectangle(0.0, 0.0, wall.length, -PLAN.wall)
        obstacles.append(tuple(place(*wall.point(s, d)) for s, d in corners))
    k = millimetres(place)
    lines = [[place(*p) for p in line] for line in marks.routes.values() if len(line) > 1]
    lines += [circle(place(*center), diameter / 2 * k, 72) for center, diameter in marks.circles]
    lines += [[place(*p) for p in line] for line in (*naming.lines, *marks.arrows)]
    passages = [(place(*a), place(*b), metres) for a, b, metres in sorted(marks.passages)]
    needed = 2 * shown.agent.radius if shown.agent is not None else 0.0
    for passage, (x, y) in zip(passages, passage_spots(passages, lines, obstacles), strict=True):
        _draw_passage(sheet, passage, (x, y), TIGHT if passage[2] < needed - 1e-6 else NARROW)
        half = text_width(f"{passage[2]:.2f} m", PLAN.width_text) / 2 + 0.5
        obstacles.append(rectangle(x - half, y - 1.4, x + half, y + 1.4))
        lines.append([*passage[:2]])
    lines += [[place(*p) for p in arc[1:]] for arc in marks.arcs]
    tags = _tags(shown, outlines, solid, naming.texts)
    labels = place_labels(tags, obstacles, naming.box, naming.sizes, lines)
    for label in labels:
        _draw_label(sheet, label)
    return frozenset(" ".join(label.lines) for label in labels)


def _tags(
    shown: Shown,
    outlines: Mapping[str, tuple[Point, ...]],
    solid: Sequence[str],
    texts: Mapping[str, tuple[str, str]] | None,
) -> Iterator[Tag]:
    """Yield the names and where they may stand; without texts every thing has its own name."""
    scene, layout, place = shown.scene, shown.layout, shown.place
    spans = {n: vertical_span(scene.by_name[n], layout[n]) for n in layout}
    hanging = {n: outlines[n] for n in layout if scene.by_name[n].on_ceiling}
    for asset in scene.assets:
        name = asset.name
        if name not in layout or (texts is not None and name not in texts):
            continue
        text, short = (display_name(scene, asset), "") if texts is None else texts[name]
        above = solid if asset.is_flat else [n for n in solid if n != name and spans[n][0] > spans[name][0] + 0.05]
        covers = [outlines[n] for n in above]
        if asset.on_ceiling:
            covers.append(cord(layout[name], place))
        if has_arrow(asset):
            covers.append(tuple(place(*p) for p in front(asset, layout[name])))
        yield Tag(
            text,
            outlines[name],
            beside=not asset.on_object and (asset.on_floor or asset.on_wall or asset.on_ceiling),
            covers=tuple(covers),
            outward=_outward(scene, layout[name]) if asset.on_wall else None,
            halo=name in shown.marks.blocked,
            quiet=asset.on_ceiling,
            shuns=tuple(corners for other, corners in hanging.items() if other != name),
            short=short,
        )


def _outward(scene: Scene, pose: Pose) -> Point:
    """Return the direction on the sheet out of the room through the nearest wall, along the sheet's sides."""
    nx, ny = min(scene.room.walls, key=lambda wall: abs(wall.place(pose.at)[1])).normal
    return (-math.copysign(1, nx), 0.0) if abs(nx) > abs(ny) else (0.0, math.copysign(1, ny))


def _draw_label(sheet: Drawing, label: Label) -> None:
    """Write one name."""
    if label.leader is not None:
        sheet.line([label.leader, label.at], QUIET, width=0.1)
    pitch = label.size * LABELS.line
    for number, line in enumerate(label.lines):
        at = label.point(0.0, (number - (len(label.lines) - 1) / 2) * pitch)
        color = QUIET if label.quiet else INK
        sheet.words(at, line, label.size, color=color, angle=label.angle, halo=PAPER if label.halo else None)


def millimetres(place: Place) -> float:
    """Return how many millimetres of paper a metre takes."""
    return math.dist(place(0.0, 0.0), place(1.0, 0.0))
