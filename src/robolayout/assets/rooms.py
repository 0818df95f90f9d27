"""The room's own parts: floor, walls with holes, doors, windows, skirting; in the world frame, ready to draw.

Walls stand outside the floor polygon, `SHELL.thickness` thick, and are cut into convex blocks around their openings. Names
say what a part belongs to: "floor", "wall-2", "door-0", "window-1", "skirting-3"; several parts may share a name.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon, box
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from robolayout.assets.category import read_data
from robolayout.assets.joints import turned
from robolayout.assets.palette import PLAIN, material_from
from robolayout.assets.part import Joint, Material, Part
from robolayout.assets.shapes import prism
from robolayout.scene import Opening, Point, Room, Wall


@dataclass(frozen=True)
class ShellConfig:
    """Walls, openings, skirting and curtains of a room, in metres unless said otherwise."""

    thickness: float = 0.1  # thickness of walls in metres, outside the room
    slab: float = 0.06  # thickness of the floor below z = 0 in metres
    frame: float = 0.05  # width of door and window frames in metres
    leaf: tuple[float, float] = (-0.075, -0.035)  # between which depths into the room a shut leaf hangs, in metres
    skirting: tuple[float, float] = (0.008, 0.07)  # depth into the room and height of the skirting board in metres
    gathered: float = 0.17  # share of a window's width that a curtain drawn aside takes
    folds: int = 6  # folds of a curtain
    widest: float = 2.6  # width beyond which a window has no curtain (a shop's)
    strips: int = 60  # most strips of a floor of boards
    tiles: int = 110  # most tiles of a floor
    shortest: float = 1e-6  # length below which a piece is left out


SHELL = ShellConfig()


@dataclass(frozen=True)
class RoomStyle:
    """How the room itself looks."""

    name: str  # what it is called
    floor: str  # "planks", "tiles" or "carpet"
    tones: tuple[Material, ...]  # floor materials; planks take turns, tiles take the first on joints of the second
    wall: Material  # wall paint
    trim: Material  # skirting, door and window frames
    door: Material  # door leaves
    curtain: Material | None = None  # what hangs at its windows; None where nothing does


def _style(name: str, entry: Mapping[str, Any]) -> RoomStyle:
    tones = tuple(map(material_from, entry["tones"]))
    rest = {key: material_from(entry[key]) for key in ("wall", "trim", "door", "curtain") if key in entry}
    return RoomStyle(name, entry["floor"], tones, **rest)


FLOORS = {name: _style(name, entry) for name, entry in read_data("room_styles.toml").items()}
"""Styles by the name of their floor."""
STYLES = tuple(FLOORS.values())[:5]  # those that seeds pick from


def room_style(seed: int, floor: str = "") -> RoomStyle:
    """Return the style with a floor of that name, else that of a seed."""
    return FLOORS.get(floor) or STYLES[seed % len(STYLES)]


def room_parts(room: Room, *, style: RoomStyle | None = None, seed: int = 0) -> tuple[Part, ...]:
    """Return all that is seen of the room, in the world frame; without a style in that which its floor names, else that of `seed`."""
    look = style or room_style(seed, room.floor)
    built = [*_floor(room, look), *_walls(room, look)]
    for i, door in enumerate(room.doors):
        built += _door(room.walls[door.wall], door, f"door-{i}", look)
    for i, window in enumerate(room.windows):
        built += _window(room.walls[window.wall], window, f"window-{i}", look)
    return tuple(built)


def _floor(room: Room, look: RoomStyle) -> Iterator[Part]:
    """Yield the slab below the floor and the sheets that lie on it."""
    outline = Polygon(room.vertices)
    base = look.tones[-1] if look.floor == "tiles" else look.tones[0]
    yield extruded("floor", base, outline, (-SHELL.slab, -0.001))
    for tone, pieces in zip(look.tones, _sheets(outline, look), strict=False):
        corners = _triangles(pieces).reshape(-1, 2)
        if len(corners):
            flat, faces = np.pad(corners, ((0, 0), (0, 1))), np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
            yield Part("floor", flat, faces, tone, convex=False)


def _sheets(outline: Polygon, look: RoomStyle) -> list[list[BaseGeometry]]:
    """Return the visible pieces of the floor, one list for each tone: planks along its longer side, tiles, or all of it."""
    x0, y0, x1, y1 = outline.bounds
    if look.floor == "planks":
        count = max(1, min(SHELL.strips, round(min(x1 - x0, y1 - y0) / 0.16)))
        grid = (1, count) if x1 - x0 >= y1 - y0 else (count, 1)
        planks = _cells(outline, ((x1 - x0) / grid[0], (y1 - y0) / grid[1]), grid, 0.0015)
        tones = len(look.tones)
        return [[plank for i, plank in enumerate(planks) if (i * 7 + i // 3) % tones == tone] for tone in range(tones)]
    if look.floor == "tiles":
        side = max(0.6, math.sqrt((x1 - x0) * (y1 - y0) / SHELL.tiles))
        grid = (max(1, math.ceil((x1 - x0) / side)), max(1, math.ceil((y1 - y0) / side)))
        return [_cells(outline, (side, side), grid, 0.004)]
    return [[outline]]


def _cells(outline: Polygon, edges: Point, grid: tuple[int, int], joint: float) -> list[BaseGeometry]:
    """Return what lies in the cells of a grid over a polygon, half a joint from their edges."""
    x0, y0, _, _ = outline.bounds
    corners = ((x0 + i * edges[0], y0 + j * edges[1]) for i in range(grid[0]) for j in range(grid[1]))
    cells = (box(x + joint, y + joint, x + edges[0] - joint, y + edges[1] - joint) for x, y in corners)
    return [outline.intersection(cell) for cell in cells]


def _triangles(shapes: Sequence[BaseGeometry]) -> NDArray[np.float64]:
    """Return counter-clockwise triangles (n, 3, 2) of the polygons, which may be concave, among shapes and their pieces."""
    pieces = shapely.get_parts(shapes)
    made = shapely.get_parts(shapely.constrained_delaunay_triangles(pieces[shapely.area(pieces) > SHELL.shortest]))
    return shapely.get_coordinates(shapely.orient_polygons(made)).reshape(-1, 4, 2)[:, :3]


def extruded(name: str, tone: Material, outline: Polygon, span: tuple[float, float]) -> Part:
    """Return a closed prism over a polygon, which may be concave and have holes."""
    ring: list[Point] = []
    walls: list[tuple[int, int]] = []
    whole = orient(outline)
    for edge in (whole.exterior, *whole.interiors):
        start, count = len(ring), len(edge.coords) - 1
        ring += [(x, y) for x, y, *_ in edge.coords[:-1]]
        walls += [(start + i, start + (i + 1) % count) for i in range(count)]
    index, n = {point: i for i, point in enumerate(ring)}, len(ring)
    caps = [[index[x, y] for x, y in triangle] for triangle in _triangles([whole]).tolist()]
    faces = [[c, b, a] for a, b, c in caps] + [[a + n, b + n, c + n] for a, b, c in caps]
    faces += [face for i, j in walls for face in ([i, j, j + n], [i, j + n, i + n])]
    points = np.array([(x, y, z) for z in span for x, y in ring])
    return Part(name, points, np.array(faces, dtype=np.int32), tone, convex=len(caps) == 2 and n == 4)


def _walls(room: Room, look: RoomStyle) -> Iterator[Part]:
    """Yield the convex blocks of every wall, and boards along its foot, left out at doors."""
    for name, tone, openings, outwards, height in (
        ("wall", look.wall, (*room.doors, *room.windows), SHELL.thickness, room.wall_height),
        ("skirting", look.trim, room.doors, -SHELL.skirting[0], SHELL.skirting[1]),
    ):
        corners = _offset_corners(room, outwards)
        for wall in room.walls:
            ends = (corners[wall.index], corners[(wall.index + 1) % len(corners)])
            holes = [hole for hole in openings if hole.wall == wall.index]
            for near, far, low, high in _blocks(wall.length, height, holes):
                second = ends[0] if near <= SHELL.shortest else wall.point(near, -outwards)
                third = ends[1] if far >= wall.length - SHELL.shortest else wall.point(far, -outwards)
                outline = (wall.point(near), second, third, wall.point(far))
                yield prism(f"{name}-{wall.index}", tone, outline if outwards > 0 else outline[::-1], (low, high))


def _offset_corners(room: Room, outwards: float) -> list[Point]:
    """Return where the walls' faces meet at each vertex when all move outwards by some metres; sharp ones are cut short."""
    corners: list[Point] = []
    for i, wall in enumerate(room.walls):
        (ax, ay), (bx, by) = room.walls[i - 1].normal, wall.normal
        sx, sy = ax + bx, ay + by
        length = math.hypot(sx, sy)
        if length < SHELL.shortest:
            corners.append(wall.point(0.0, -outwards))
            continue
        reach = outwards * min(2 / length, 3.0) / length
        corners.append((wall.start[0] - sx * reach, wall.start[1] - sy * reach))
    return corners


def _blocks(length: float, height: float, openings: Sequence[Opening]) -> Iterator[tuple[float, float, float, float]]:
    """Yield (near, far, low, high) of the solid blocks of a wall around its openings."""
    ends = (end for opening in openings for end in (opening.offset, opening.offset + opening.width))
    for near, far in pairwise(sorted({0.0, length, *(min(max(end, 0.0), length) for end in ends)})):
        if far - near < SHELL.shortest:
            continue
        middle, level = (near + far) / 2, 0.0
        holes = sorted((o.sill, o.sill + o.height) for o in openings if o.offset < middle < o.offset + o.width)
        for low, high in [*holes, (height, height)]:
            if min(low, height) - level > SHELL.shortest:
                yield near, far, level, min(low, height)
            level = max(level, high)


def _bar(name: str, tone: Material, wall: Wall, along: Point, depth: Point, z: Point) -> Part:
    """Return a box in a wall's frame: metres along it, into the room, and up."""
    outline = (
        wall.point(along[0], depth[1]), wall.point(along[0], depth[0]),
        wall.point(along[1], depth[0]), wall.point(along[1], depth[1]),
    )  # fmt: skip
    return prism(name, tone, outline, z)


def _frame(wall: Wall, hole: Opening, name: str, tone: Material, *, depth: Point) -> Iterator[Part]:
    """Yield the jambs and the head that line an opening."""
    near, far, top = hole.offset, hole.offset + hole.width, hole.sill + hole.height
    t = min(SHELL.frame, 0.15 * hole.width, 0.15 * hole.height)
    yield _bar(name, tone, wall, (near, near + t), depth, (hole.sill, top))
    yield _bar(name, tone, wall, (far - t, far), depth, (hole.sill, top))
    yield _bar(name, tone, wall, (near + t, far - t), depth, (top - t, top))


def _door(wall: Wall, door: Opening, name: str, look: RoomStyle) -> Iterator[Part]:
    """Yield its frame; for each leaf a board, a raised panel and a handle, which turn about the edge at the side they swing to."""
    yield from _frame(wall, door, name, look.trim, depth=(-SHELL.thickness + 0.004, -0.002))
    rim = min(SHELL.frame, 0.15 * door.width, 0.15 * door.height) + 0.003
    top, wide = door.height - rim, (-math.pi / 2, 0.0) if door.open else (0.0, math.pi / 2)
    for leaf in door.hung(rim, 0.004):
        near, far = sorted((leaf.hinge, leaf.hinge + leaf.toward * leaf.width))
        inset, grip = 0.14 * leaf.width, leaf.hinge + leaf.toward * (leaf.width - 0.12)
        built = (
            _bar(name, look.door, wall, (near, far), SHELL.leaf, (0.004, top)),
            _bar(name, look.trim, wall, (near + inset, far - inset), (-0.034, -0.029), (0.55 * top, top - inset)),
            _bar(name, PLAIN["steel"], wall, (grip - 0.06, grip + 0.06), (-0.033, -0.012), (1.0, 1.02)),
        )
        axis, at = (0.0, 0.0, float(leaf.toward * leaf.into)), wall.point(leaf.hinge, SHELL.leaf[leaf.into > 0])
        own = name if door.leaves == 1 else f"{name} {'right' if leaf.toward > 0 else 'left'}"
        joint = Joint(own, "hinge", axis, (*at, 0.0), wide, (*wall.point(grip), 1.01), (1.0, 1.02))
        for part in built:
            yield replace(part, vertices=turned(joint, part.vertices, -wide[0]), joint=joint)


def _window(wall: Wall, window: Opening, name: str, look: RoomStyle) -> Iterator[Part]:
    """Yield a window: frame, sill board, a bar in the middle, glass."""
    depth = (-0.08, -0.02)
    yield from _frame(wall, window, name, look.trim, depth=depth)
    t = min(SHELL.frame, 0.15 * window.width, 0.15 * window.height)
    near, far = window.offset + t, window.offset + window.width - t
    low, top = window.sill + t, window.sill + window.height - t
    yield _bar(name, look.trim, wall, (near, far), depth, (window.sill, low))
    yield _bar(name, look.trim, wall, (window.offset + 0.002, window.offset + window.width - 0.002), (-0.019, -0.001),
               (window.sill + 0.001, window.sill + 0.02))  # fmt: skip
    panes = max(1, round(window.width / 0.8))
    for i in range(1, panes):
        at = near + i * (far - near) / panes
        yield _bar(name, look.trim, wall, (at - 0.02, at + 0.02), (-0.07, -0.03), (low, top))
    yield _bar(name, PLAIN["glass"], wall, (near, far), (-0.053, -0.047), (low, top))
    if panes > 1:
        yield _bar(name, PLAIN["black"], wall, (near + (far - near) / panes - 0.01, near + (far - near) / panes + 0.01),
                   (-0.03, -0.01), (low + 0.3 * (top - low), low + 0.3 * (top - low) + 0.1))  # fmt: skip
    if look.curtain is not None and window.width <= SHELL.widest:
        yield from _curtains(wall, window, name, look.curtain)


def _curtains(wall: Wall, window: Opening, name: str, cloth: Material) -> Iterator[Part]:
    """Yield curtains drawn aside, in folds, on a rod in the reveal of a window."""
    near, far, top = window.offset, window.offset + window.width, window.sill + window.height
    yield _bar(name, PLAIN["steel"], wall, (near, far), (-0.018, -0.008), (top - 0.03, top - 0.02))
    fold = SHELL.gathered * window.width / SHELL.folds
    for i in range(SHELL.folds):
        depth = ((-0.019, -0.009), (-0.012, -0.002))[i % 2]
        for at in (near + i * fold, far - (i + 1) * fold):
            yield _bar(name, cloth, wall, (at, at + fold), depth, (window.sill + 0.022, top - 0.018))
