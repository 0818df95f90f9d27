"""Lists as others give them - room type, size, names and counts - furnished, and judged by rules that a person would apply.

Eleven types of room, each small, medium and large. The rules look at the dictionaries of `scene.json` and `layout.json` alone:

    seats       every seat is at a table, desk, counter or instrument, or beside or before another seat; a sofa may look at a game
    soft        nothing lies on a seat but soft things
    filled      of a room of more than 30 m2 at least 60 % of the floor lies within 1.5 m of furniture
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from shapely import Polygon
from shapely.ops import unary_union

from benchmarks.seen import Room, resting, turned_to
from benchmarks.store import Row
from benchmarks.tables import Rows, table

LISTS = {
    "bedroom": ("3.5 x 4", "1 bed, 2 nightstands, 1 wardrobe, 1 desk, 1 chair, 1 lamp, 1 rug"),
    "living room": ("5 x 4", "1 sofa, 2 armchairs, 1 coffee table, 1 tv stand, 1 television, 2 bookshelves, 1 rug, 2 plants"),
    "dining room": ("5 x 4", "1 dining table, 6 chairs, 1 sideboard, 1 china cabinet, 1 pendant lamp, 1 plant"),
    "bookstore": ("6 x 5", "6 bookshelves, 2 display tables, 1 checkout counter, 1 cash register, 2 armchairs, 1 rug"),
    "buffet restaurant": ("8 x 6", "2 buffet tables, 4 tables, 16 chairs, 1 host stand, 2 plants, 6 plates"),
    "children's room": ("4 x 4", "1 bunk bed, 1 kids table, 2 kids chairs, 1 toy box, 1 toy shelf, 1 play tent, 1 rug"),
    "classroom": ("7 x 6", "12 student desks, 12 chairs, 1 teacher desk, 1 whiteboard, 1 bookshelf, 1 globe"),
    "computer room": ("7 x 6", "8 desks, 8 office chairs, 8 monitors, 8 keyboards, 1 printer, 1 whiteboard"),
    "deli": ("6 x 5", "1 deli counter, 1 display fridge, 3 shelves, 2 small tables, 4 chairs, 1 cash register"),
    "florist's shop": ("6 x 5", "2 display tables, 4 flower buckets, 6 potted plants, 1 counter, 1 cash register, 2 stools"),
    "game room": ("6 x 5", "1 pool table, 1 foosball table, 2 arcade machines, 1 dart board, 1 sofa, 2 bar stools, 1 bar table"),
}  # fmt: skip
"""Size in metres and list of things of the small room of each type."""

SIZES = {"small": 1, "medium": 2, "large": 4}
"""By how much a list and its floor grow."""

SEATS = ("chair", "armchair", "stool", "sofa", "bench", "recliner", "loveseat")
TABLES = ("table", "desk", "counter", "island", "piano", "machine", "easel")
SOFT = ("cushion", "pillow", "blanket", "bear", "clothes", "towel", "throw", "book")
NEAR, TOGETHER, WATCHED, AROUND, BIG, FILLED = 0.8, 2.2, 3.5, 1.5, 30.0, 0.6
"""Metres from a seat to its table, to another seat, and from a sofa to a game; metres around furniture; what a big room is (m2), and
the share asked of it."""


def _last(room: Room, name: str) -> str:
    return str(room.scene["assets"][name]["category"]).split()[-1]


def _footprints(room: Room) -> dict[str, Polygon]:
    """Return the footprints of what stands on the floor, rugs aside."""
    found = {name: room.outline(name) for name in room.layout}
    return {name: shape for name, shape in found.items() if room.box(name)[2] < 0.1 and room.box(name)[3] > 0.05}


def idle_seats(room: Room) -> list[str]:
    """Return the seats that are at nothing."""
    shapes = _footprints(room)
    found: list[str] = []
    for name, shape in shapes.items():
        if _last(room, name) not in SEATS:
            continue
        gaps = {other: shape.distance(there) for other, there in shapes.items() if other != name}
        at_table = any(gap <= NEAR and _last(room, other) in TABLES for other, gap in gaps.items())
        in_company = any(gap <= TOGETHER and _last(room, other) in SEATS for other, gap in gaps.items())
        looks = _last(room, name) == "sofa" and any(
            gap <= WATCHED and _last(room, other) in TABLES and turned_to(room, name, shapes[other])
            for other, gap in gaps.items()
        )
        if not at_table and not looks and not (in_company and _last(room, name) != "stool"):
            found.append(name)
    return found


def laid_on_seats(room: Room) -> list[str]:
    """Return what lies on seats, not on a table that they are under, and is not soft."""
    seats = [name for name in room.layout if _last(room, name) in SEATS]
    others = [name for name in room.layout if name not in seats]
    found: list[str] = []
    for name in room.layout:
        bottom = room.box(name)[2]
        over = any(
            seat != name
            and 0.2 < bottom <= room.box(seat)[3] + 0.03
            and room.outline(seat).contains(room.outline(name).centroid)
            for seat in seats
        )
        if not over or _last(room, name) in SOFT or not room.scene["assets"][name]["onObject"]:
            continue
        if not any(resting(room, name, other) for other in others if other != name):
            found.append(name)
    return found


def filled(room: Room) -> float:
    """Return the share of the floor within 1.5 m of furniture."""
    floor = Polygon(room.floor)
    return (
        unary_union([shape.buffer(AROUND) for shape in _footprints(room).values()]).intersection(floor).area
        / floor.area
    )


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case for each type and size."""
    for kind in list(LISTS)[:1] if quick else LISTS:
        for size in SIZES:
            yield f"{kind}/{size}", partial(measured, kind, size)


def sentence(kind: str, size: str) -> str:
    """Return a list of a type in a size as one sentence."""
    floor, things = LISTS[kind]
    times = SIZES[size]
    width, depth = (float(side) * times**0.5 for side in floor.split(" x "))
    counts = (thing.strip().split(" ", 1) for thing in things.split(","))
    return f"A {width:.1f} x {depth:.1f} m {kind} with only " + ", ".join(
        f"{int(n) * times} {what}" for n, what in counts
    )


def measured(kind: str, size: str) -> Row:
    """Return what a person would object to in a room made from a list."""
    import robolayout as rl
    from robolayout.scene import scene_to_dict

    start = time.process_time()
    try:
        scene, _ = rl.scene_from_sentence(sentence(kind, size))
        result = rl.generate(scene)
    except rl.RoboLayoutError as error:
        return {"refused": str(error)[:160], "seconds": time.process_time() - start}
    room = Room(json.loads(json.dumps(scene_to_dict(result.scene))), result.layout.to_dict())
    share = filled(room)
    return {
        "ok": result.report.ok,
        "asked met": result.report.asked_met_share,
        "seats": ", ".join(idle_seats(room)),
        "soft": ", ".join(laid_on_seats(room)),
        "filled": share,
        "empty": Polygon(room.floor).area > BIG and share < FILLED,
        "seconds": time.process_time() - start,
    }


def section(rows: Rows, images: Path) -> str:
    """Return what a person would object to in rooms made from lists."""
    lines = [
        [
            *key.split("/"),
            "refused" if "refused" in row else "yes" if row["ok"] else "no",
            str(row.get("seats") or "-"),
            str(row.get("soft") or "-"),
            f"{row.get('filled', 0.0):.0%}",
        ]
        for key, row in rows.items()
    ]
    heads = [
        "room",
        "size",
        "all demands met",
        "seats at nothing",
        "hard things on seats",
        "floor within 1.5 m of furniture",
    ]
    intro = (
        "Rooms from lists of names and counts, in three sizes, judged by a person's rules (`benchmarks/lists.py`).\n"
    )
    return f"## Lists\n\n{intro}\n{table(heads, lines)}"
