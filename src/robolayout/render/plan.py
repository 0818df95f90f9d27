"""The plan: a room to scale, as an architect would draw it, with what the agent can do in it.

`draw_plan` makes the drawing; `plan_svg`, `plan_image` and `plan_pdf` are its forms.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from robolayout.render._architecture import THICKNESS, Place, draw_floor, draw_walls
from robolayout.render._drawing import Drawing, Point, draw_image, draw_svg, text_width
from robolayout.render._labels import LINE, Label, Tag, place_labels
from robolayout.render.marks import PlanMarks, Rings
from robolayout.render.palette import (
    BLOCKED,
    FREE,
    INK,
    ISLAND,
    NARROW,
    PAPER,
    QUIET,
    REACH,
    ROUTE,
    TIGHT,
    TURN,
    asset_colors,
)
from robolayout.scene import Agent, Asset, Layout, Pose, Scene, Wall, split_name, vertical_span

if TYPE_CHECKING:
    from PIL.Image import Image

SCALES = (25, 50, 100, 200, 500)
"""Scales that a plan may have."""

LONGEST = 180.0
"""Millimetres that the room may take; the first scale that fits is used."""

LINES: dict[str, tuple[float, tuple[float, float] | None]] = {
    "line": (0.5, None),
    "dash": (0.35, (1.1, 0.6)),
}
"""Width, dash and gap of the lines in the legend, millimetres."""

WIDTH_TEXT = 2.1
"""Font size of the width of a passage, millimetres."""

MARGIN = 6.0
"""Millimetres around the room's walls."""


def plan_svg(
    scene: Scene,
    layout: Layout,
    *,
    navigation: PlanMarks | None = None,
    agent: Agent | None = None,
    title: str | None = None,
) -> str:
    """Return the plan as SVG text, to scale (see `draw_plan`)."""
    return draw_svg(draw_plan(scene, layout, navigation=navigation, agent=agent, title=title))


def plan_image(
    scene: Scene,
    layout: Layout,
    *,
    navigation: PlanMarks | None = None,
    agent: Agent | None = None,
    title: str | None = None,
    width: int = 1000,
) -> Image:
    """Return the plan as an RGB picture `width` pixels wide (see `draw_plan`)."""
    return draw_image(draw_plan(scene, layout, navigation=navigation, agent=agent, title=title), width)


def plan_pdf(
    scene: Scene,
    layout: Layout,
    *,
    navigation: PlanMarks | None = None,
    agent: Agent | None = None,
    title: str | None = None,
) -> bytes:
    """Return the plan as a PDF page of its own size, to scale (see `draw_plan`)."""
    from robolayout.render._pdf import draw_pdf

    return draw_pdf(draw_plan(scene, layout, navigation=navigation, agent=agent, title=title))


def draw_plan(
    scene: Scene,
    layout: Layout,
    *,
    navigation: PlanMarks | None = None,
    agent: Agent | None = None,
    title: str | None = None,
    scale: int | None = None,
) -> Drawing:
    """Return the plan of a room as a drawing in paper millimetres.

    Args:
        scene: The scene.
        layout: Poses; assets without one are not drawn.
        navigation: What the agent can do: free space, routes, passages, blocked assets.
        agent: The agent, for the legend; None leaves it out.
        title: A line above the plan.
        scale: Denominator of the scale (50 is 1:50); None chooses.
    """
    marks = navigation or PlanMarks()
    x0, y0, x1, y1 = scene.room.bounds
    scale = scale or plan_scale(scene)
    k = 1000 / scale
    head = 5.0 if title else 0.0
    foot = 15.0 if agent is not None or navigation is not None else 9.0
    border = MARGIN + THICKNESS * k
    width = max((x1 - x0) * k + 2 * border, 46.0)
    left = (width - (x1 - x0) * k) / 2
    sheet = Drawing(width, (y1 - y0) * k + 2 * border + head + foot)

    def place(x: float, y: float) -> Point:
        return (left + (x - x0) * k, head + border + (y1 - y) * k)

    if title:
        sheet.words((width / 2, 6.0), title, min(3.4, 3.4 * (width - 8) / max(text_width(title, 3.4), 1)), color=INK)
    draw_floor(sheet, scene.room, place)
    draw_contents(sheet, scene, layout, marks, place)
    _draw_marks(sheet, marks, agent, place, k)
    draw_walls(sheet, scene.room, place)
    _draw_labels(sheet, scene, layout, place, marks, agent)
    _draw_foot(sheet, agent, navigation, scale, left)
    return sheet


def plan_scale(scene: Scene) -> int:
    """Return the denominator of the scale at which the room fits the sheet."""
    x0, y0, x1, y1 = scene.room.bounds
    longest = max(x1 - x0, y1 - y0) * 1000
    return next(
        (s for s in SCALES if longest / s <= LONGEST and longest / s > 0 and (s > 25 or longest < 2500)), SCALES[-1]
    )


def draw_contents(sheet: Drawing, scene: Scene, layout: Layout, marks: PlanMarks, place: Place) -> None:
    """Draw rugs, free space, then every footprint from the floor up; what hangs from the ceiling is dashed."""
    placed = [(asset, layout[asset.name]) for asset in scene.assets if asset.name in layout]
    placed.sort(key=lambda pair: (vertical_span(*pair)[0], -pair[0].size[0] * pair[0].size[1]))
    for asset, pose in placed:
        if asset.is_flat:
            draw_footprint(sheet, asset, pose, place)
    _draw_areas(sheet, marks.free, FREE, place, opacity=0.72)
    _draw_areas(sheet, marks.islands, ISLAND, place, opacity=0.72)
    for asset, pose in placed:
        if not (asset.is_flat or asset.on_ceiling):
            draw_footprint(sheet, asset, pose, place, blocked=asset.name in marks.blocked)
    _draw_areas(sheet, marks.under, FREE, place, opacity=0.6)
    for outline in marks.parts:
        sheet.polygon([[place(x, y) for x, y in outline]], QUIET, opacity=0.3, stroke=QUIET, width=0.12)
    for asset, pose in placed:
        if asset.on_ceiling:
            draw_footprint(sheet, asset, pose, place)


def _draw_areas(sheet: Drawing, areas: tuple[Rings, ...], color: str, place: Place, *, opacity: float) -> None:
    """Fill areas, each given as its outer ring and its holes."""
    for rings in areas:
        sheet.polygon([[place(x, y) for x, y in ring] for ring in rings], color, opacity=opacity)


def draw_footprint(sheet: Drawing, asset: Asset, pose: Pose, place: Place, *, blocked: bool = False) -> None:
    """Draw one asset's box from above, with a small arrow at its front."""
    fill, line = asset_colors(asset)
    corners = [place(*corner) for corner in pose.corners(asset.size)]
    if asset.on_ceiling:
        sheet.polygon([corners], None, stroke=line, width=0.2, dash=(0.9, 0.6), title=asset.name)
        return
    if asset.is_flat:
        sheet.polygon([corners], fill, stroke=line, width=0.14, opacity=0.55, dash=(0.5, 0.4), title=asset.name)
        return
    raised = vertical_span(asset, pose)[0] > 0.05
    sheet.polygon(
        [corners],
        fill,
        stroke=BLOCKED if blocked else line,
        width=0.6 if blocked else 0.14 if raised else 0.28,
        title=asset.name,
    )
    if blocked:
        sheet.line([corners[0], corners[2]], BLOCKED, width=0.2)
        sheet.line([corners[1], corners[3]], BLOCKED, width=0.2)
    if has_arrow(asset):
        sheet.polygon([[place(*p) for p in _front(asset, pose)]], line)


def display_name(scene: Scene, asset: Asset) -> str:
    """Return the asset's name for people: "bed", or "night stand 1" where there are several."""
    alike = scene.variables[asset.variable]
    stems = {split_name(other.name)[0] for other in alike}
    words = split_name(asset.name)[0].replace("_", " ").strip()
    if len(stems) > 1 or not words:
        return asset.name
    return f"{words} {asset.index}" if len(alike) > 1 else words


def has_arrow(asset: Asset) -> bool:
    """Return whether the plan shows the asset's front: not of small, flat or hanging things."""
    return min(asset.size[:2]) > 0.26 and not asset.is_flat and not asset.on_ceiling


def _front(asset: Asset, pose: Pose) -> list[Point]:
    """Return the small triangle that points out of the asset's front, metres."""
    depth, width, _ = asset.size
    arrow = min(0.08, 0.3 * depth, 0.3 * width)
    tips = ((depth / 2 - 0.2 * arrow, 0.0), (depth / 2 - arrow, 0.7 * arrow), (depth / 2 - arrow, -0.7 * arrow))
    return [_world(pose, *tip) for tip in tips]


def _world(pose: Pose, forward: float, left: float) -> Point:
    """Return the point `forward` and `left` metres from the pose."""
    c, s = pose.forward
    return (pose.x + c * forward - s * left, pose.y + s * forward + c * left)


def _draw_marks(sheet: Drawing, marks: PlanMarks, agent: Agent | None, place: Place, k: float) -> None:
    """Draw turning circles, reach, routes with a dot at their end, and the agent's disc."""
    for center, diameter in marks.circles:
        sheet.polygon([_circle(place(*center), diameter / 2 * k, 72)], None, stroke=TURN, width=0.3, dash=(1.4, 0.8))
    for points in marks.arcs:
        fan = [place(*p) for p in points]
        sheet.polygon([fan], REACH, opacity=0.09)
        sheet.line(fan[1:], REACH, width=0.25)
        sheet.polygon([_circle(fan[0], 0.45)], PAPER, stroke=REACH, width=0.2)
    lines = [[place(*p) for p in points] for _, points in sorted(marks.routes.items()) if len(points) > 1]
    for points in lines:
        sheet.line(points, PAPER, width=0.75)
    for points in lines:
        sheet.line(points, ROUTE, width=0.32)
    for points in lines:
        sheet.polygon([_circle(points[-1], 0.55)], ROUTE, stroke=PAPER, width=0.15)
    if marks.agent_at is not None and agent is not None:
        at = place(*marks.agent_at)
        sheet.polygon([_circle(at, agent.radius * k)], ROUTE, opacity=0.22, stroke=ROUTE, width=0.3)


def _draw_passages(sheet: Drawing, marks: PlanMarks, agent: Agent | None, place: Place, at: Sequence[Point]) -> None:
    """Draw each narrowest passage as a measured line, with its width at the places `at`."""
    needed = 2 * agent.radius if agent is not None else 0.0
    for (a, b, metres), spot in zip(sorted(marks.passages), at, strict=True):
        color = TIGHT if metres < needed - 1e-6 else NARROW
        (ax, ay), (bx, by) = place(*a), place(*b)
        length = max(((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5, 1e-6)
        tick = ((by - ay) / length * 0.9, -(bx - ax) / length * 0.9)
        for color_, width in ((PAPER, 1.1), (color, 0.5)):
            sheet.line([(ax, ay), (bx, by)], color_, width=width)
            for x, y in ((ax, ay), (bx, by)):
                sheet.line([(x - tick[0], y - tick[1]), (x + tick[0], y + tick[1])], color_, width=width)
        sheet.words(spot, f"{metres:.2f} m", WIDTH_TEXT, color=color, halo=PAPER)


def passage_spots(
    marks: PlanMarks, place: Place, lines: Sequence[Sequence[Point]], solids: Sequence[Sequence[Point]]
) -> list[Point]:
    """Return where the width of each passage is written: beside its line, where it covers least."""
    import shapely

    strokes = np.array([shapely.LineString(line) for line in lines], dtype=object)
    blocks = np.array([shapely.Polygon(outline) for outline in solids], dtype=object)
    spots: list[Point] = []
    for a, b, metres in sorted(marks.passages):
        (ax, ay), (bx, by) = place(*a), place(*b)
        length = max(math.dist((ax, ay), (bx, by)), 1e-6)
        nx, ny = (by - ay) / length, (ax - bx) / length
        half = (text_width(f"{metres:.2f} m", WIDTH_TEXT) / 2, 0.45 * WIDTH_TEXT)
        away = 0.7 + abs(nx) * half[0] + abs(ny) * half[1]
        found: list[tuple[float, int, Point]] = []
        for t, side in product((0.5, 0.35, 0.65, 0.2, 0.8), (1, -1)):
            x, y = ax + t * (bx - ax) + side * away * nx, ay + t * (by - ay) + side * away * ny
            box = shapely.box(x - half[0], y - half[1], x + half[0], y + half[1])
            cost = (
                shapely.length(shapely.intersection(strokes, box)).sum() + 4.0 * shapely.intersects(blocks, box).sum()
            )
            found.append((float(cost), len(found), (x, y)))
        spots.append(min(found)[2])
    return spots


def _draw_labels(
    sheet: Drawing, scene: Scene, layout: Layout, place: Place, marks: PlanMarks, agent: Agent | None
) -> None:
    """Draw the passages and write the names."""
    outlines = {n: tuple(place(*c) for c in layout[n].corners(scene.by_name[n].size)) for n in layout}
    solid = [n for n in layout if not scene.by_name[n].is_flat and not scene.by_name[n].on_ceiling]
    obstacles = [outlines[n] for n in solid]
    for wall in scene.room.walls:
        corners = [(0.0, 0.0), (wall.length, 0.0), (wall.length, -THICKNESS), (0.0, -THICKNESS)]
        obstacles.append(tuple(place(*wall.point(s, d)) for s, d in corners))
    k = math.dist(place(0.0, 0.0), place(1.0, 0.0))
    lines = [[place(*p) for p in line] for line in marks.routes.values() if len(line) > 1]
    lines += [_circle(place(*center), diameter / 2 * k, 72) for center, diameter in marks.circles]
    spots = passage_spots(marks, place, lines, obstacles)
    _draw_passages(sheet, marks, agent, place, spots)
    for (a, b, metres), (x, y) in zip(sorted(marks.passages), spots, strict=True):
        half = text_width(f"{metres:.2f} m", WIDTH_TEXT) / 2 + 0.5
        obstacles.append(((x - half, y - 1.4), (x + half, y - 1.4), (x + half, y + 1.4), (x - half, y + 1.4)))
        lines.append([place(*a), place(*b)])
    lines += [[place(*p) for p in arc[1:]] for arc in marks.arcs]
    tags = _tags(scene, layout, place, marks, outlines)
    for label in place_labels(tags, obstacles, (1.0, 1.0, sheet.width - 1, sheet.height - 1), lines=lines):
        _draw_label(sheet, label)


def _tags(
    scene: Scene, layout: Layout, place: Place, marks: PlanMarks, outlines: Mapping[str, tuple[Point, ...]]
) -> list[Tag]:
    """Return the names and where they may stand."""
    spans = {n: vertical_span(scene.by_name[n], layout[n]) for n in layout}
    solid = [n for n in layout if not scene.by_name[n].is_flat and not scene.by_name[n].on_ceiling]
    hanging = {n: outlines[n] for n in layout if scene.by_name[n].on_ceiling}
    tags: list[Tag] = []
    for name in (asset.name for asset in scene.assets if asset.name in layout):
        asset = scene.by_name[name]
        above = solid if asset.is_flat else [n for n in solid if n != name and spans[n][0] > spans[name][0] + 0.05]
        beside = not asset.on_object and (asset.on_floor or asset.on_wall or asset.on_ceiling)
        covers = [outlines[n] for n in above]
        if has_arrow(asset):
            covers.append(tuple(place(*p) for p in _front(asset, layout[name])))
        tags.append(
            Tag(
                display_name(scene, asset),
                outlines[name],
                beside,
                tuple(covers),
                _outward(scene, layout[name]) if asset.on_wall else None,
                halo=name in marks.blocked,
                quiet=asset.on_ceiling,
                shuns=tuple(corners for other, corners in hanging.items() if other != name),
            )
        )
    return tags


def _outward(scene: Scene, pose: Pose) -> Point:
    """Return the direction on the sheet out of the room through the nearest wall, along the sheet's sides."""

    def away(wall: Wall) -> float:
        return abs((pose.x - wall.start[0]) * wall.normal[0] + (pose.y - wall.start[1]) * wall.normal[1])

    nx, ny = min(scene.room.walls, key=away).normal
    return (-math.copysign(1, nx), 0.0) if abs(nx) > abs(ny) else (0.0, math.copysign(1, ny))


def _draw_label(sheet: Drawing, label: Label) -> None:
    """Write one name."""
    if label.leader is not None:
        sheet.line([label.leader, label.at], QUIET, width=0.1)
    pitch = label.size * LINE
    for number, line in enumerate(label.lines):
        at = label.point(0.0, (number - (len(label.lines) - 1) / 2) * pitch)
        color = QUIET if label.quiet else INK
        sheet.words(at, line, label.size, color=color, angle=label.angle, halo=PAPER if label.halo else None)


def _draw_foot(sheet: Drawing, agent: Agent | None, marks: PlanMarks | None, scale: int, left: float) -> None:
    """Draw the scale bar and, where there is something to explain, the agent and the legend."""
    k, y = 1000 / scale, sheet.height - 5.0
    metres = next((m for m in (2, 1, 0.5) if m * k <= sheet.width / 3), 0.5) if scale <= 50 else 10 * scale / 500
    step = metres * k / 4
    for i in range(4):
        x = left + i * step
        corners = [(x, y - 0.5), (x + step, y - 0.5), (x + step, y + 0.5), (x, y + 0.5)]
        sheet.polygon([corners], (INK, PAPER)[i % 2], stroke=INK, width=0.13)
    sheet.words((left, y + 2.2), "0", 1.8, color=QUIET)
    sheet.words((left + 4 * step, y + 2.2), f"{metres:g} m", 1.8, color=QUIET)
    sheet.words((sheet.width - left, y + 2.2), f"1 : {scale}", 1.8, color=QUIET, anchor="end")
    if agent is not None:
        name = agent.title or agent.name
        room = sheet.width - left - (left + 4 * step + 6)
        size = min(2.2, 2.2 * room / max(text_width(name, 2.2), 0.1))
        sheet.words((sheet.width - left, y - 0.6), name, size, anchor="end")
    if marks is not None:
        _draw_legend(sheet, marks, left, y - 5.2)


def _draw_legend(sheet: Drawing, marks: PlanMarks, left: float, y: float) -> None:
    """Explain the marks that are on the plan, in one row."""
    x, size = left, 1.9
    rows: list[tuple[str, str, str]] = []
    rows += [("area", FREE, "free to move")] if marks.free else []
    rows += [("area", ISLAND, "cut off")] if marks.islands else []
    rows += [("line", ROUTE, "route")] if marks.routes else []
    rows += [("line", NARROW, "narrowest")] if marks.passages else []
    rows += [("dash", TURN, "turning circle")] if marks.circles else []
    rows += [("line", REACH, "reach")] if marks.arcs else []
    rows += [("cross", BLOCKED, "out of reach")] if marks.blocked else []
    total = sum(6.0 + text_width(words, size) for *_, words in rows)
    size *= min(1.0, (sheet.width - 2 * left) / max(total, 1))
    for kind, color, words in rows:
        box = [(x, y - 0.9), (x + 3, y - 0.9), (x + 3, y + 0.9), (x, y + 0.9)]
        if kind == "area":
            sheet.polygon([box], color, stroke=QUIET, width=0.1)
        elif kind in LINES:
            width, dash = LINES[kind]
            sheet.line([(x, y), (x + 3, y)], color, width=width, dash=dash)
        else:
            sheet.line([box[0], box[2]], color, width=0.3)
            sheet.line([box[1], box[3]], color, width=0.3)
        sheet.words((x + 3.8, y), words, size, anchor="start")
        x += 3.8 + text_width(words, size) + 2.2


def _circle(center: Point, radius: float, sides: int = 40) -> list[Point]:
    """Return a circle as a polygon."""
    angles = [2 * math.pi * i / sides for i in range(sides)]
    return [(center[0] + radius * math.cos(a), center[1] + radius * math.sin(a)) for a in angles]
