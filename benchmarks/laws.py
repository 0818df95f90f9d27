"""Laws of the solver: a room turned, moved, mirrored, its things renamed or in another order, ends in the same verdict."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

from benchmarks.measures import warmed
from benchmarks.rough import rough
from benchmarks.store import Row
from benchmarks.tables import Rows, table
from robolayout.scene import Opening, Scene

TASKS = ("bedroom_small", "deli_small", "kitchen", "office", "dining_room_medium", "cafe", "bedroom_crowded")
"""Rooms of 9 to 44 assets with rough programs."""

NUMBERS = re.compile(r"(.*)\.(position|rotation) = \[(.*)\]")
WALL = re.compile(r"walls\[(\d+)\]")
INDEXED = re.compile(r"\b([a-z_]\w*)\[(\d+)\]")

Given = tuple[Scene, str]
Line = Callable[[str], str]
Numbers = Callable[[list[float]], list[float]]


def _unchanged(line: str) -> str:
    return line


def _program(text: str, position: Numbers, rotation: Numbers, line: Line = _unchanged) -> str:
    """Return a program with every position, every rotation and every other line changed."""
    lines = list[str]()
    for one in text.splitlines():
        if found := NUMBERS.match(one):
            numbers = [float(number) for number in found[3].split(",")]
            numbers = rotation(numbers) if found[2] == "rotation" else position(numbers)
            lines.append(f"{found[1]}.{found[2]} = {[round(number, 5) for number in numbers]}")
        else:
            lines.append(line(one))
    return "\n".join(lines)


def _with_floor(scene: Scene, vertices: tuple[tuple[float, float], ...]) -> Scene:
    return replace(scene, room=replace(scene.room, vertices=vertices))


def as_given(scene: Scene, text: str) -> Given:
    """Return a scene and its program as they are."""
    return scene, text


def turned(scene: Scene, text: str, degrees: float = 30.0) -> Given:
    """Return them turned about the origin."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    corners = tuple((c * x - s * y, s * x + c * y) for x, y in scene.room.vertices)
    program = _program(
        text, lambda at: [c * at[0] - s * at[1], s * at[0] + c * at[1], at[2]], lambda yaw: [yaw[0] + degrees]
    )
    return _with_floor(scene, corners), program


def moved(scene: Scene, text: str) -> Given:
    """Return them 7 m to the east and 3 m to the south."""
    corners = tuple((x + 7.0, y - 3.0) for x, y in scene.room.vertices)
    return _with_floor(scene, corners), _program(text, lambda at: [at[0] + 7.0, at[1] - 3.0, at[2]], lambda yaw: yaw)


def mirrored(scene: Scene, text: str) -> Given:
    """Return their mirror image about the y axis."""
    room, count = scene.room, len(scene.room.vertices)

    def index(wall: int) -> int:
        return (count - 2 - wall) % count

    def opening(one: Opening) -> Opening:
        return replace(one, wall=index(one.wall), offset=room.walls[one.wall].length - one.offset - one.width)

    def line(one: str) -> str:
        one = WALL.sub(lambda found: f"walls[{index(int(found[1]))}]", one)
        return one.replace('"left"', '"@"').replace('"right"', '"left"').replace('"@"', '"right"')

    corners = tuple((-x, y) for x, y in reversed(room.vertices))
    openings = {"doors": tuple(map(opening, room.doors)), "windows": tuple(map(opening, room.windows))}
    image = replace(scene, room=replace(room, vertices=corners, **openings))
    return image, _program(text, lambda at: [-at[0], at[1], at[2]], lambda yaw: [180.0 - yaw[0]], line)


def renamed(scene: Scene, text: str) -> Given:
    """Return them with other names, which sort the other way round."""
    kinds = sorted({asset.variable for asset in scene.assets}, reverse=True)
    names = {
        kind: f"{chr(ord('a') + number // 26)}{chr(ord('a') + number % 26)}_{kind}" for number, kind in enumerate(kinds)
    }
    assets = (replace(a, name=f"{names[a.variable]}-{a.name.rpartition('-')[2]}") for a in scene.assets)
    program = INDEXED.sub(lambda found: f"{names.get(found[1], found[1])}[{found[2]}]", text)
    return replace(scene, assets=tuple(assets)), program


def reordered(scene: Scene, text: str) -> Given:
    """Return them with the things in reverse order."""
    return replace(scene, assets=tuple(reversed(scene.assets))), text


CHANGES = (as_given, turned, moved, mirrored, renamed, reordered)


@cache
def _given(task: str) -> Given:
    found = rough(task, 0)
    return found.scene, found.text


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield every room as it is and in every change."""
    for task in TASKS[:1] if quick else TASKS:
        for change in CHANGES:
            yield f"{task}/{change.__name__}", partial(measured, task, change)


def measured(task: str, change: Callable[[Scene, str], Given]) -> Row:
    """Lay a changed room out."""
    scene, text = change(*_given(task))
    return warmed(scene, program=text)[1]


def section(rows: Rows, images: Path) -> str:
    """Return the table of changed rooms, one line per room."""
    changes = [change.__name__ for change in CHANGES]
    lines = [
        [task.replace("_", " "), *(_cell(rows.get(f"{task}/{name}"), rows.get(f"{task}/as_given")) for name in changes)]
        for task in TASKS
    ]
    intro = (
        "A room with a rough program (`benchmarks/laws.py`), turned by 30 degrees, moved, mirrored, its things renamed or listed "
        "in reverse order: statements met, what else is amiss, and CPU against the room as it is given.\n"
    )
    heads = ["room", *(name.replace("_", " ") for name in changes)]
    return f"## Laws of the solver\n\n{intro}\n{table(heads, lines)}"


def _cell(row: Row | None, first: Row | None) -> str:
    """Return what a change comes to."""
    if row is None or first is None:
        return ""
    amiss = "" if row["hard_ok"] else ", hard demands unmet"
    amiss += f", {row['short']} out of reach" if row["short"] else ""
    time = f"{row['cpu']:.1f} s" if row is first else f"{row['cpu'] / first['cpu']:.1f} x"
    return f"{row['met']} of {row['asked']}{amiss}, {time}"
