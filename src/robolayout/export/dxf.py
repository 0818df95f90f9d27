"""DXF (release 12, plain text): the plan for drawing programs, in metres, one layer per kind of thing.

Every asset is a block (its footprint and a line along its front) inserted at its pose, so that a draughtsman moves it
as one thing; its exact name, size and the height of its centre travel with the insert as extended data.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

from robolayout._errors import LayoutError
from robolayout._text import printable
from robolayout.export._exporter import Exporter, Options, Rows, data_file, placed, reader
from robolayout.scene import Asset, Layout, Opening, Point, Pose, Room, Scene

APPLICATION = "ROBOLAYOUT"


@dataclass(frozen=True)
class DrawingConfig:
    """How the plan is drawn, in metres."""

    wall: float = 0.1  # metres of thickness that walls are drawn with
    letter: tuple[float, float] = (0.03, 0.1)  # metres of the smallest and the largest height of letters


DRAWING = DrawingConfig()

PLAIN = frozenset(range(32, 127)) - frozenset(b"%^\\")
"""Codes of the letters that stand for themselves in a text: `%%d`, `^J` and `\\U+` stand for others."""

Group = tuple[int, object]  # one line pair of a DXF file: group code and value


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the plan of a layout."""
    rows = placed(scene, layout)
    names = [re.sub(r"[^A-Z0-9_]", "_", asset.name.upper())[:20] for asset, _ in rows]
    blocks = {asset.name: f"A{i}_{names[i]}" for i, (asset, _) in enumerate(rows)}
    entities = _room(scene.room)
    for name, line in options.routes.items():
        if len(line) > 1 and name in layout:
            entities += _polyline("ROUTES", line)
    for asset, pose in rows:
        entities += _insert(blocks[asset.name], asset, pose) + _name(asset, pose)
    x0, y0, x1, y1 = scene.room.extent()
    head = data_file("plan.dxf").format(left=x0 - 0.5, low=y0 - 0.5, right=x1 + 0.5, high=y1 + 0.5)
    groups: list[Group] = [(int(code), value) for code, value in (line.split(" ", 1) for line in head.splitlines())]
    groups += [
        (0, "SECTION"),
        (2, "BLOCKS"),
        *(group for asset, _ in rows for group in _block(blocks[asset.name], asset)),
    ]
    groups += [(0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES"), *entities, (0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\r\n{_text(value)}\r\n" for code, value in groups).encode("ascii")


def _text(value: object) -> str:
    """Return a value as DXF text: floats with every digit, all that is not plain as \\U+XXXX, in units of UTF-16."""
    if isinstance(value, float):
        return repr(value + 0.0)
    units = printable(str(value)).encode("utf-16-be").hex(" ", 2).upper().split()
    return "".join(chr(int(unit, 16)) if int(unit, 16) in PLAIN else f"\\U+{unit}" for unit in units)


def _plain(text: str) -> str:
    """Return what `_text` was made from."""
    whole = re.sub(r"\\U\+([0-9A-F]{4})", lambda found: chr(int(found[1], 16)), text)
    return whole.encode("utf-16-be", "surrogatepass").decode("utf-16-be", "replace")


def _polyline(layer: str, points: Iterable[Point], *, closed: bool = False) -> list[Group]:
    groups: list[Group] = [(0, "POLYLINE"), (8, layer), (66, 1), (10, 0.0), (20, 0.0), (30, 0.0), (70, int(closed))]
    for x, y in points:
        groups += [(0, "VERTEX"), (8, layer), (10, float(x)), (20, float(y)), (30, 0.0)]
    return [*groups, (0, "SEQEND"), (8, layer)]


def _layer(asset: Asset) -> str:
    """Return the layer of an asset, by where it may stand."""
    if asset.is_flat:
        return "RUGS"
    if asset.on_floor:
        return "FURNITURE"
    return "TOPS" if asset.on_object else "CEILING" if asset.on_ceiling else "WALL_MOUNTED"


def _block(block: str, asset: Asset) -> list[Group]:
    """Return an asset's block around the middle of its box: its footprint and a line along its front."""
    half_x, half_y = asset.size[0] / 2, asset.size[1] / 2
    inset = half_x - min(0.04, half_x / 4)
    groups: list[Group] = [(0, "BLOCK"), (8, "0"), (2, block), (70, 0), (10, 0.0), (20, 0.0), (30, 0.0), (3, block)]
    groups += _polyline(_layer(asset), Pose(0.0, 0.0, 0.0, 0.0).corners(asset.size), closed=True)
    groups += _polyline(_layer(asset), ((inset, -half_y), (inset, half_y)))
    return [*groups, (0, "ENDBLK"), (8, "0")]


def _name(asset: Asset, pose: Pose) -> list[Group]:
    """Return an asset's name along the longer side of its footprint, never upside down; a rug's along its edge."""
    depth, width, _ = asset.size
    along = pose.yaw if depth >= width else pose.yaw + math.pi / 2
    along = math.remainder(along - 1e-9, math.pi) + 1e-9
    long, short = max(depth, width), min(depth, width)
    height = min(DRAWING.letter[1], max(DRAWING.letter[0], min(long / (0.7 * len(asset.name)), short / 2)))
    down = short / 2 - height if asset.is_flat else 0.0
    x, y = pose.x + down * math.sin(along), pose.y - down * math.cos(along)
    groups: list[Group] = [(0, "TEXT"), (8, "NAMES"), (10, x), (20, y), (30, 0.0), (40, height), (1, asset.name)]
    return [*groups, (50, math.degrees(along)), (72, 1), (73, 2), (11, x), (21, y), (31, 0.0)]


def _insert(block: str, asset: Asset, pose: Pose) -> list[Group]:
    """Return the insert of an asset, with its exact name, size and centre height as extended data."""
    groups: list[Group] = [(0, "INSERT"), (8, _layer(asset)), (2, block), (10, pose.x), (20, pose.y), (30, 0.0)]
    groups += [(50, math.degrees(pose.yaw)), (1001, APPLICATION), (1000, asset.name)]
    return [*groups, *((1040, float(value)) for value in (*asset.size, pose.z))]


def _room(room: Room) -> list[Group]:
    """Return floor, walls with gaps for doors and windows, leaves and panes."""
    groups = _polyline("FLOOR", room.vertices, closed=True)
    outer = [_mitre(room, i) for i in range(len(room.walls))]
    for wall in room.walls:
        for start, end in wall.between((*room.doors, *room.windows)):
            far = outer[(wall.index + 1) % len(outer)] if end == wall.length else wall.point(end, -DRAWING.wall)
            near = outer[wall.index] if start == 0.0 else wall.point(start, -DRAWING.wall)
            groups += _polyline("WALLS", (wall.point(start), wall.point(end), far, near), closed=True)
    for door in room.doors:
        groups += _door(room, door)
    for window in room.windows:
        wall, ends = room.walls[window.wall], (window.offset, window.offset + window.width)
        for depth in (0.0, -DRAWING.wall / 2, -DRAWING.wall):
            groups += _polyline("WINDOWS", [wall.point(offset, depth) for offset in ends])
    return groups


def _mitre(room: Room, corner: int) -> Point:
    """Return where the outer faces of the two walls at a corner meet."""
    (ax, ay), (bx, by) = room.walls[corner - 1].normal, room.walls[corner].normal
    scale = DRAWING.wall / max(1 + ax * bx + ay * by, 0.1)
    x, y = room.vertices[corner]
    return (x - (ax + bx) * scale, y - (ay + by) * scale)


def _door(room: Room, door: Opening) -> list[Group]:
    """Return a door's leaves, open by 90 degrees, and their swings."""
    wall, groups = room.walls[door.wall], list[Group]()
    for leaf in door.hung():
        face = 0.0 if leaf.into > 0 else -DRAWING.wall
        hinge = wall.point(leaf.hinge, face)
        groups += _polyline("DOORS", (hinge, wall.point(leaf.hinge, face + leaf.into * leaf.width)))
        groups += [(0, "ARC"), (8, "DOORS"), (10, hinge[0]), (20, hinge[1]), (30, 0.0), (40, leaf.width)]
        shut_open = ((leaf.toward, wall.direction), (leaf.into, wall.normal))
        angles = [math.degrees(math.atan2(sign * y, sign * x)) % 360.0 for sign, (x, y) in shut_open]
        groups += zip((50, 51), angles[:: leaf.toward * leaf.into], strict=True)
    return groups


@reader("DXF file")
def read(data: bytes) -> Rows:
    """Yield the names, poses and sizes of the inserts in a plan that this package wrote."""
    lines = data.decode("ascii", errors="replace").splitlines()
    if len(lines) < 4 or lines[0].strip() != "0" or lines[-1].strip() != "EOF":
        raise LayoutError("this is no DXF text: it must begin with a section and end with EOF.")
    pairs = [(int(code), value) for code, value in zip(lines[::2], lines[1::2], strict=False)]
    starts = [i for i, (code, _) in enumerate(pairs) if code == 0]
    for start, end in pairwise(starts):
        if pairs[start][1] == "INSERT" and (1001, APPLICATION) in pairs[start:end]:
            entity = dict(pairs[start:end])
            *size, z = (float(value) for code, value in pairs[start:end] if code == 1040)
            pose = Pose(float(entity[10]), float(entity[20]), z, math.radians(float(entity[50])))
            yield _plain(entity[1000]), pose, size


DXF = Exporter("dxf", ".dxf", "the plan as a drawing: walls, doors, windows, footprints as blocks", None, write, read)
