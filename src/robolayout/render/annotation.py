"""Pictures for a model that must answer in coordinates: a view with a grid, fronts, names and walls written into it.

All marks are places of the room sent through the camera of the picture, so that each lies on its pixel. What is written
is what a constraint program says: `night_stand[0]`, `walls[2]`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any, Literal

import numpy as np
import shapely
from numpy.typing import NDArray
from PIL import Image

from robolayout._errors import UnknownNameError
from robolayout.render._drawing import Drawing, Point, Text, circle, paint, rectangle, text_width
from robolayout.render._labels import Box
from robolayout.render._style import MARKS, VIEW
from robolayout.render.camera import Camera, spherical_camera
from robolayout.render.view import Renderer, Studio, picture_size
from robolayout.scene import Layout, Room, Scene

GRID_COLOR = "#0072b2"
FRONT_COLOR = "#d55e00"
WALL_COLOR = "#a3006b"
DOOR_COLOR = "#006b4f"
WHITE = "#ffffff"


@dataclass(frozen=True)
class Mark:
    """One annotation."""

    kind: Literal["grid", "front", "wall", "door", "window"]  # "grid", "front", "wall", "door" or "window"
    text: str  # what is written
    place: tuple[float, float, float]  # world point, metres
    tip: tuple[float, float, float] | None = None  # world point of the arrow's head, or None
    small: bool = False  # whether it is written small, because it belongs to a small thing


def annotate(
    scene: Scene, layout: Layout, *, view: str = "top", size: int | tuple[int, int] = 768, renderer: Renderer = "auto"
) -> Image.Image:
    """Return an annotated view of the room, "top" or "side" (45 degrees), taken by the paper's camera."""
    studio = Studio(scene, layout, renderer=renderer)
    buffers = studio.buffers(annotation_camera(scene.room, view, picture_size(size)))
    return draw_marks(buffers.color, buffers.depth, buffers.camera, annotation_marks(scene, layout))


def annotation_camera(room: Room, view: str, size: tuple[int, int]) -> Camera:
    """Return the paper's camera for the "top" or the "side" view; `size` is (width, height) in pixels."""
    if view == "top":
        return spherical_camera(room, 0.0, VIEW.top_azimuth, size)
    if view == "side":
        return spherical_camera(room, VIEW.side_polar, MARKS.azimuth, size)
    raise UnknownNameError("annotated view", view, ["top", "side"])


def annotation_marks(scene: Scene, layout: Layout) -> tuple[Mark, ...]:
    """Return all annotations of a scene: grid points, fronts of placed assets, walls, doors and windows."""
    room = scene.room
    marks = [Mark("grid", f"{x:g},{y:g}", (x, y, 0.0)) for x, y in grid_points(room)]
    for name, pose in layout.items():
        asset = scene.by_name[name]
        c, s = pose.forward
        tip = (pose.x + MARKS.arrow * c, pose.y + MARKS.arrow * s, pose.z)
        marks.append(Mark("front", scene.expressions[name], (pose.x, pose.y, pose.z), tip, max(asset.size[:2]) < 0.4))
    for wall in room.walls:
        marks.append(Mark("wall", f"walls[{wall.index}]", (*wall.point(wall.length / 2, -MARKS.wall_offset), 0.0)))
    for door in room.doors:
        marks.append(Mark("door", "door", (*room.walls[door.wall].point(door.center), 0.0)))
    for window in room.windows:
        height = window.sill + window.height / 2
        marks.append(Mark("window", "window", (*room.walls[window.wall].point(window.center), height)))
    return tuple(marks)


def grid_spacing(room: Room) -> float:
    """Return the paper's grid spacing max(Delta_0, ceil(W / 500)) in metres: 1 m up to a room of 500 m."""
    x0, y0, x1, y1 = room.bounds
    return max(MARKS.grid_step, float(math.ceil(max(x1 - x0, y1 - y0) / 500)))


def grid_points(room: Room) -> list[Point]:
    """Return (x_min, y_min) + (i, j) spacing for all points on or in the room, metres."""
    x0, y0, x1, y1 = room.bounds
    step = grid_spacing(room)
    polygon = shapely.Polygon(room.vertices).buffer(1e-6)
    xs = [x0 + step * i for i in range(int((x1 - x0) / step + 1e-9) + 1)]
    ys = [y0 + step * j for j in range(int((y1 - y0) / step + 1e-9) + 1)]
    return [(round(x, 6), round(y, 6)) for y in ys for x in xs if polygon.covers(shapely.Point(x, y))]


def draw_marks(
    color: NDArray[np.uint8], depth: NDArray[np.float32], camera: Camera, marks: Sequence[Mark]
) -> Image.Image:
    """Return the picture with marks drawn over it; grid points behind something (`depth` in metres) are faint and carry no numbers."""
    samples = 2 if camera.width <= 2048 else 1
    image = Image.fromarray(color)
    image = image.resize((camera.width * samples, camera.height * samples), Image.Resampling.NEAREST)
    sheet = Drawing(camera.width, camera.height)
    unit = max(camera.height / 768, 0.6)
    numbers = _draw_grid(sheet, [m for m in marks if m.kind == "grid"], camera, depth, unit)
    fronts = [m for m in marks if m.kind == "front"]
    _draw_arrows(sheet, fronts, camera, unit)
    taken: list[Box] = []
    for number in numbers:  # each with the point above it
        (x, y), half = number.at, text_width(number.text, number.size) / 2
        taken.append((x - half, y - 12 * unit, x + half, y + number.size / 2))
    for mark in [*(m for m in marks if m.kind not in ("grid", "front")), *fronts]:
        _draw_tag(sheet, mark, camera, taken, unit)
    sheet.items += numbers  # last, so that no name covers a coordinate
    paint(image, sheet.items, samples)
    return image.reduce(samples) if samples > 1 else image


def _pixel(camera: Camera, place: tuple[float, float, float]) -> Point:
    """Return where a world point lands, pixels."""
    pixel, _ = camera.project(place)
    return (float(pixel[0]), float(pixel[1]))


def _draw_grid(
    sheet: Drawing, grid: Sequence[Mark], camera: Camera, depth: NDArray[np.float32], unit: float
) -> list[Text]:
    """Draw grid points; return their coordinates, where there is room for them."""
    if not grid:
        return []
    numbers: list[Text] = []
    pixels, depths = camera.project([mark.place for mark in grid])
    gap = min((math.dist(pixels[0], p) for p in pixels[1:]), default=MARKS.enough)
    every = max(1, math.ceil(MARKS.enough * unit / max(gap, 1e-6)))
    corner = np.array(grid[0].place[:2])
    step = min((abs(m.place[0] - corner[0]) for m in grid if abs(m.place[0] - corner[0]) > 1e-6), default=1.0)
    for mark, (u, v), far in zip(grid, pixels, depths, strict=True):
        if not (0 <= u < camera.width and 0 <= v < camera.height):
            continue
        if far >= float(depth[int(v), int(u)]) + 0.12:
            sheet.polygon([circle((u, v), 1.3 * unit, 20)], GRID_COLOR, opacity=0.45)
            continue
        sheet.polygon([circle((u, v), 3.0 * unit, 20)], GRID_COLOR, stroke=WHITE, width=0.8 * unit)
        column, row = np.round((np.array(mark.place[:2]) - corner) / step).astype(int)
        if column % every == 0 and row % every == 0:
            numbers.append(Text((u, v + 9 * unit), mark.text, MARKS.number * unit, color=GRID_COLOR, halo=WHITE))
    return numbers


def _draw_arrows(sheet: Drawing, fronts: Sequence[Mark], camera: Camera, unit: float) -> None:
    """Draw the arrow along each asset's front."""
    for mark in fronts:
        assert mark.tip is not None
        (ax, ay), (bx, by) = _pixel(camera, mark.place), _pixel(camera, mark.tip)
        length = max(math.hypot(bx - ax, by - ay), 1e-6)
        dx, dy = (bx - ax) / length, (by - ay) / length
        head = min(10 * unit, 0.5 * length)
        neck = (bx - dx * head, by - dy * head)
        wings = [
            (bx, by),
            (neck[0] - dy * head * 0.55, neck[1] + dx * head * 0.55),
            (neck[0] + dy * head * 0.55, neck[1] - dx * head * 0.55),
        ]
        sheet.line([(ax, ay), neck], WHITE, width=5.0 * unit)
        sheet.polygon([wings], WHITE, stroke=WHITE, width=2.4 * unit)
        sheet.line([(ax, ay), neck], FRONT_COLOR, width=2.6 * unit)
        sheet.polygon([wings], FRONT_COLOR)
        sheet.polygon([circle((ax, ay), 3.6 * unit, 20)], FRONT_COLOR, stroke=WHITE, width=0.8 * unit)


def _draw_tag(sheet: Drawing, mark: Mark, camera: Camera, taken: list[Box], unit: float) -> None:
    """Draw a mark's point and its text beside it, where it covers the least of what is written already."""
    color = {"front": "#3a2413", "wall": WALL_COLOR, "door": DOOR_COLOR, "window": DOOR_COLOR}[mark.kind]
    u, v = _pixel(camera, mark.place)
    size = (10.0 if mark.small else 12.0) * unit
    w, h = text_width(mark.text, size) + 6 * unit, size + 3 * unit
    if mark.kind != "front":
        sheet.polygon([circle((u, v), 3.6 * unit, 20)], color, stroke=WHITE, width=0.8 * unit)
    reach = 6 * unit
    options: list[tuple[Box, float]] = []
    for ring, (dx, dy) in product((0.0, 14.0, 30.0, 50.0, 75.0), MARKS.compass):
        x = min(max(u + dx * (w / 2 + reach + ring * unit), w / 2 + 1), camera.width - w / 2 - 1)
        y = min(max(v + dy * (h / 2 + reach + ring * unit), h / 2 + 1), camera.height - h / 2 - 1)
        box = (x - w / 2, y - h / 2, x + w / 2, y + h / 2)
        hides = box[0] < u < box[2] and box[1] < v < box[3]
        options.append((box, 400 * hides + 1.5 * ring * unit))
    costs = _covered([box for box, _ in options], taken) + np.array([cost for _, cost in options])
    best, least = options[int(np.argmin(costs))][0], float(costs.min())
    taken += [best, (u - reach, v - reach, u + reach, v + reach)]
    middle = ((best[0] + best[2]) / 2, (best[1] + best[3]) / 2)
    if least > 10 * unit:
        sheet.line([(u, v), middle], color, width=0.7 * unit)
    sheet.polygon([rectangle(*best)], WHITE, opacity=0.86, stroke=color, width=0.7 * unit)
    sheet.words(middle, mark.text, size, color=color)


def _covered(boxes: Sequence[Box], taken: Sequence[Box]) -> NDArray[np.float64]:
    """Return for each box the area that it shares with those taken, square pixels."""
    a: Any = np.array(boxes).reshape(-1, 4).T
    b: Any = np.array(taken).reshape(-1, 4).T
    return shapely.area(shapely.intersection(shapely.box(*a)[:, None], shapely.box(*b))).sum(axis=1)
