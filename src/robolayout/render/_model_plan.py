"""The plan for a model that answers in coordinates: ticks along the edges, names of programs, what must stay free."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import shapely
from PIL import Image
from shapely.affinity import rotate, translate

from robolayout.assets import sweeps_of
from robolayout.render._drawing import Drawing, Point, text_width
from robolayout.render._marked import Naming, draw_labels, draw_marks, millimetres
from robolayout.render._style import MODEL_PLAN, PLAN
from robolayout.render.annotation import DOOR_COLOR, GRID_COLOR, WALL_COLOR, WHITE
from robolayout.render.contents import (
    Place,
    PlanMarks,
    Shown,
    draw_contents,
    draw_floor,
    draw_walls,
    named_at,
    placing,
    swings,
)
from robolayout.render.palette import INK, QUIET, TIGHT
from robolayout.render.plan import draw_legend
from robolayout.scene import Agent, Layout, Room, Scene, Wall


def model_plan(
    scene: Scene, layout: Layout, *, marks: PlanMarks | None = None, agent: Agent | None = None, size: int = 1024
) -> Image.Image:
    """Return the plan of a room for a model: seen from straight above, so that lengths are lengths everywhere.

    Its marks are what the body can do there and, as ghosts, where things were meant to stand.
    """
    sheet = _sheet(scene, layout, marks or PlanMarks(), agent)
    return sheet.image(round(size * sheet.width / max(sheet.width, sheet.height)))


def _sheet(scene: Scene, layout: Layout, marks: PlanMarks, agent: Agent | None) -> Drawing:
    """Return the drawing, with a key below it for the things whose names find no place."""
    x0, y0, x1, y1 = scene.room.extent()
    k = MODEL_PLAN.longest / max(x1 - x0, y1 - y0)
    bounds = x0, y0, x1, y1 = scene.room.extent((MODEL_PLAN.edge - PLAN.least) / k)
    edge = MODEL_PLAN.edge + PLAN.wall * k
    width, height = max((x1 - x0) * k + 2 * edge, 0.6 * MODEL_PLAN.longest), (y1 - y0) * k + 2 * edge
    left = (width - (x1 - x0) * k) / 2
    sheet = Drawing(width, height)

    room, place = scene.room, placing(bounds, k, left, edge)
    shown = Shown(scene, layout, replace(marks, routes={}, arcs=(), parts=()), agent, place)
    draw_floor(sheet, room, place)
    draw_contents(sheet, shown)
    for area in _kept_free(scene, layout):
        _draw_hatched(sheet, [place(*corner) for corner in area])
    draw_walls(sheet, room, place)
    _draw_ticks(sheet, room, place)
    draw_marks(sheet, shown)
    _draw_names(sheet, room, place)
    numbers = {asset.name: f"#{i}" for i, asset in enumerate(scene.assets, 1)}
    texts = {name: (scene.expressions[name], numbers[name]) for name in layout}
    box = (left - 1, edge - 1, width - left + 1, height - edge + 1)
    written = draw_labels(sheet, shown, Naming(box, texts, MODEL_PLAN.sizes, lines=swings(room)))
    _draw_key(sheet, scene, {name: numbers[name] for name in layout if texts[name][0] not in written})
    sheet.height += 2 * MODEL_PLAN.text
    draw_legend(sheet, shown.marks, (4.0, sheet.height - MODEL_PLAN.text), width - 8.0)
    return sheet


def _kept_free(scene: Scene, layout: Layout) -> Iterator[Sequence[Point]]:
    """Yield the outlines of what must stay free, metres: landings, and what doors, drawers and flaps sweep."""
    yield from (scene.room.landing(door) for door in scene.room.doors)
    for name, pose in layout.items():
        for sweep in sweeps_of(scene.by_name[name]):
            swept = translate(rotate(sweep.region, pose.yaw, (0, 0), use_radians=True), pose.x, pose.y)
            yield from ([*part.exterior.coords] for part in shapely.get_parts(swept) if part.geom_type == "Polygon")


def _draw_hatched(sheet: Drawing, corners: Sequence[Point]) -> None:
    """Cross out an area."""
    area = shapely.Polygon(corners)
    low_x, low_y, high_x, high_y = area.bounds
    drop = high_y - low_y
    for i in range(math.ceil((high_x - low_x + drop) / MODEL_PLAN.hatch)):
        x = low_x - drop + i * MODEL_PLAN.hatch
        crossed = shapely.intersection(area, shapely.LineString([(x, high_y), (x + drop, low_y)]))
        if crossed.geom_type == "LineString" and not crossed.is_empty:
            sheet.line([(p[0], p[1]) for p in crossed.coords], TIGHT, width=0.15)
    sheet.polygon([corners], None, stroke=TIGHT, width=0.25, dash=(1.0, 0.6))


def _draw_ticks(sheet: Drawing, room: Room, place: Place) -> None:
    """Draw a line for every metre and its number at both ends."""
    x0, y0, x1, y1 = room.bounds
    step = next(s for s in (1, 2, 5, 10, 20, 50, 100, 1000) if max(x1 - x0, y1 - y0) / s <= MODEL_PLAN.ticks)
    out = PLAN.wall * millimetres(place) + 0.5
    for upright, low, high, across in ((True, x0, x1, (y0, y1)), (False, y0, y1, (x0, x1))):
        for number in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1):
            value = float(number * step)
            ends = [place(value, end) if upright else place(end, value) for end in across]
            sheet.line(ends, GRID_COLOR, width=0.1, dash=(0.5, 1.2))
            for (x, y), sign in zip(ends, (1, -1), strict=True):
                dx, dy = (0.0, sign) if upright else (-sign, 0.0)
                start = (x + dx * out, y + dy * out)
                sheet.line([start, (start[0] + 1.5 * dx, start[1] + 1.5 * dy)], GRID_COLOR, width=0.3)
                at = (start[0] + 3.6 * dx, start[1] + 3.2 * dy)
                sheet.words(at, f"{value:g}", MODEL_PLAN.text, color=GRID_COLOR, halo=WHITE)


def _draw_names(sheet: Drawing, room: Room, place: Place) -> None:
    """Write the names of doors, windows and walls outside the room, farther out than the ticks; a wall where it is clear."""
    k = millimetres(place)
    named = [("door", i, door) for i, door in enumerate(room.doors)]
    named += [("window", i, window) for i, window in enumerate(room.windows)]
    taken: dict[int, list[tuple[float, float]]] = {}
    for what, number, opening in named:
        wall, text = room.walls[opening.wall], f"{what} {number}"
        out = named_at(opening) if what == "door" else 0.0
        width = max(text_width(text, MODEL_PLAN.text) / k, opening.width)
        taken.setdefault(wall.index, []).append((opening.center, width))
        ends = [place(*wall.point(s)) for s in (opening.offset, opening.offset + opening.width)]
        sheet.line(ends, DOOR_COLOR, width=0.8)
        _write(sheet, wall, (opening.center, out), text, DOOR_COLOR, place)
    for wall in room.walls:
        text = f"walls[{wall.index}]"
        half, others = text_width(text, MODEL_PLAN.text) / k, taken.get(wall.index, ())
        spots = (wall.length * share for share in (0.5, 0.3, 0.7, 0.15, 0.85))
        spot = max(spots, key=lambda s: min([0.0, *(abs(s - at) - (half + other) / 2 for at, other in others)]))
        _write(sheet, wall, (spot, 0.0), text, WALL_COLOR, place)


def _write(sheet: Drawing, wall: Wall, at: Point, text: str, color: str, place: Place) -> None:
    """Write a name outside a wall, so far along it and at least so far out, metres; upright where the wall is."""
    along, out = at
    (x, y), (ox, oy) = place(*wall.point(along)), place(*wall.point(along, -1.0))
    k = math.dist((x, y), (ox, oy))
    ux, uy, away = (ox - x) / k, (oy - y) / k, PLAN.wall * k + max(MODEL_PLAN.named_at, out * k)
    angle = 90.0 if abs(ux) > abs(uy) else 0.0
    sheet.words((x + ux * away, y + uy * away), text, MODEL_PLAN.text, color=color, angle=angle, halo=WHITE)


def _draw_key(sheet: Drawing, scene: Scene, numbers: Mapping[str, str]) -> None:
    """Write below the plan which names the numbers stand for."""
    x, y = 4.0, sheet.height + 0.5 * MODEL_PLAN.text
    for name, number in numbers.items():
        text = f"{number} {scene.expressions[name]}"
        needed = text_width(text, MODEL_PLAN.text) + 3.0
        if x + needed > sheet.width:
            x, y = 4.0, y + 1.5 * MODEL_PLAN.text
        sheet.words((x, y), text, MODEL_PLAN.text, color=INK, anchor="start")
        x += needed
    if numbers:
        sheet.height = y + MODEL_PLAN.text
        sheet.line([(4.0, sheet.height), (sheet.width - 4.0, sheet.height)], QUIET, width=0.1)
