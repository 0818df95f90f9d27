"""Shelves, cabinets, boxes and racks."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, board, books, carcass, doors, drawers, four, open_case, plinth
from robolayout.assets.palette import BLACK, BRIGHT, CARDBOARD, GLASS, LEAF, LIGHT_GREY, SPINES, WICKER, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, prism, slab, soft


def levels(p: Piece, pitch: float, *, foot: float = 0.08) -> list[float]:
    """Return the heights of the upper faces of shelves, from `foot` to the top, about `pitch` metres apart."""
    count = max(1, round((p.h - foot) / pitch))
    return [foot + i * (p.h - foot) / count for i in range(count)] + [p.h - 0.001]


def bookshelf(p: Piece) -> Iterator[Part]:
    """Yield a bookcase with books and a few objects."""
    t = 0.022
    rows = levels(p, 0.34)
    yield from open_case(p, p.wood, rows, t)
    yield box("plinth", p.wood, (p.x[1] - 0.03, p.x[1] - 0.01), (p.y[0] + t, p.y[1] - t), (0.0, rows[0] - t))
    rng = p.rng()
    for i, low in enumerate(rows[:-1]):
        room = rows[i + 1] - low - t
        inner = (p.y[0] + t, p.y[1] - t)
        width = inner[1] - inner[0]
        if rng.random() < 0.35 and room > 0.2 and width > 0.5:
            split = inner[0] + width * rng.uniform(0.5, 0.7)
            yield from books(p, (inner[0], split), low, room, salt=str(i))
            at = (split + inner[1]) / 2
            yield cylinder("vase", p.accent, (0.0, at), (0.05, 0.035), (low, low + 0.55 * room), sides=12)
        else:
            yield from books(p, inner, low, room, salt=str(i))


def shelving(p: Piece) -> Iterator[Part]:
    """Yield an open shelf of boards on posts with baskets, boxes and books."""
    t = p.thin(0.03)
    rows = levels(p, 0.42, foot=0.12)
    for x0 in (p.x[0], p.x[1] - t):
        for y0 in (p.y[0], p.y[1] - t):
            yield box("post", p.metal, (x0, x0 + t), (y0, y0 + t), (0.0, p.h))
    inner = (p.y[0] + t + 0.001, p.y[1] - t - 0.001)
    for level in rows:
        yield box("shelf", p.wood, (p.x[0] + 0.004, p.x[1] - 0.004), inner, (level - 0.025, level))
    yield from _filled(p, rows, inner)


def _filled(p: Piece, rows: list[float], inner: tuple[float, float]) -> Iterator[Part]:
    """Yield baskets, boxes, plants and books on the shelves, mixed by the asset's own seed."""
    rng = p.rng()
    depth = (p.x[0] + 0.03, p.x[1] - 0.03)
    for i, low in enumerate(rows[:-1]):
        room = rows[i + 1] - low - 0.03
        count = max(1, round((inner[1] - inner[0]) / 0.45))
        for j in range(count):
            y0 = inner[0] + j * (inner[1] - inner[0]) / count
            y1 = inner[0] + (j + 1) * (inner[1] - inner[0]) / count
            what = rng.random()
            if what < 0.35:
                yield slab("basket", WICKER, depth, (y0 + 0.03, y1 - 0.03), (low, low + 0.6 * room), top=(1.0, 1.06))
            elif what < 0.6:
                yield box(
                    "box",
                    rng.choice((CARDBOARD, p.fabric, p.accent)),
                    depth,
                    (y0 + 0.04, y1 - 0.04),
                    (low, low + rng.uniform(0.4, 0.7) * room),
                )
            elif what < 0.72:
                yield cylinder("pot", p.accent, (0.0, (y0 + y1) / 2), (0.05, 0.065), (low, low + 0.35 * room), sides=12)
                wide = min(0.13, 0.45 * p.d)
                middle = (y0 + y1) / 2
                yield ball(
                    "leaves",
                    LEAF,
                    (-wide, wide),
                    (middle - wide, middle + wide),
                    (low + 0.3 * room, low + 0.9 * room),
                    rings=3,
                    sides=8,
                )
            else:
                yield from books(p, (y0 + 0.02, y1 - 0.02), low, room, salt=f"{i}/{j}")


def wall_shelf(p: Piece) -> Iterator[Part]:
    """Yield a board on the wall with a few things on it, or a bare ledge where it is flat."""
    if p.h < 0.1:
        yield box("board", p.wood, p.x, p.y, p.z)
        return
    t = min(0.03, 0.2 * p.h)
    yield box("board", p.wood, p.x, p.y, (0.0, t))
    yield from books(p, (p.y[0] + 0.03, p.y[0] + 0.55 * p.w), t, p.h - t, x=(p.x[0] + 0.01, p.x[1] - 0.02))
    y = p.y[0] + 0.75 * p.w
    r = min(0.3 * p.d, 0.1 * p.w)
    yield cylinder("vase", p.accent, (0.0, y), (r, 0.6 * r), (t, p.h), sides=12)


def corner_shelf(p: Piece) -> Iterator[Part]:
    """Yield quarter-round boards between two panels at the back and the right."""
    yield box("back", p.wood, (p.x[0], p.x[0] + 0.016), p.y, p.z)
    yield box("side", p.wood, (p.x[0] + 0.016, p.x[1]), (p.y[0], p.y[0] + 0.016), p.z)
    d, w = p.d - 0.017, p.w - 0.017
    x0, y0 = p.x[0] + 0.016, p.y[0] + 0.016
    for level in levels(p, 0.36):
        outline = [(x0, y0), (x0 + d, y0), (x0 + 0.9 * d, y0 + 0.42 * w), (x0 + 0.42 * d, y0 + 0.9 * w), (x0, y0 + w)]
        yield prism("shelf", p.wood, outline, (level - 0.02, level - 0.001))
        if level < 0.9 * p.h:
            yield cylinder(
                "vase", p.accent, (x0 + 0.4 * d, y0 + 0.35 * w), (0.045, 0.03), (level, level + 0.17), sides=10
            )


def cabinet(p: Piece) -> Iterator[Part]:
    """Yield a cabinet: doors, with drawers above them where it is high enough."""
    yield plinth(p, p.dark, min(0.06, 0.1 * p.h))
    base = min(0.06, 0.1 * p.h)
    yield carcass(p, p.wood, (base, p.h - 0.023))
    yield board(p, p.wood, (p.h - 0.022, p.h))
    count = max(1, round(p.w / 0.48))
    split = p.h - 0.023 if p.h > 1.3 or p.variant % 2 else p.h - 0.2 * p.h
    yield from doors(p, p.front, p.y, (base, split), count=count)
    if split < p.h - 0.05:
        yield from drawers(p, p.front, p.y, (split, p.h - 0.023), rows=1, columns=count)


def drawer_chest(p: Piece) -> Iterator[Part]:
    """Yield a stack of drawers in painted steel or wood."""
    yield carcass(p, p.front, (0.02, p.h))
    yield plinth(p, p.dark, 0.02)
    yield from drawers(p, p.front, p.y, (0.02, p.h), rows=max(2, round(p.h / 0.32)), columns=max(1, round(p.w / 0.8)))


def display_cabinet(p: Piece) -> Iterator[Part]:
    """Yield a glazed cabinet with lit shelves and objects."""
    t = 0.025
    rows = levels(p, 0.38)
    yield from open_case(
        Piece(p.d - 0.01, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key), p.dark, rows, t
    )
    rng = p.rng()
    for low in rows[:-1]:
        for share in (0.25, 0.5, 0.75):
            y, tall = p.y[0] + share * p.w, rng.uniform(0.1, 0.24)
            yield cylinder(
                "object",
                rng.choice((p.accent, p.bedding, *SPINES[3:5])),
                (-0.02, y),
                (0.05, 0.03),
                (low, low + tall),
                sides=10,
            )
    yield box("glass", GLASS, (p.x[1] - 0.004, p.x[1]), (p.y[0] + 0.004, p.y[1] - 0.004), (rows[0], p.h - 0.02))


def locker(p: Piece) -> Iterator[Part]:
    """Yield a row of steel lockers with vents."""
    paint = p.fabric
    yield carcass(p, LIGHT_GREY, (0.06, p.h))
    yield plinth(p, BLACK, 0.06)
    count = max(1, round(p.w / 0.31))
    yield from doors(p, paint, p.y, (0.06, p.h), count=count)
    face = p.x[1] - 0.022
    for i in range(count):
        y0, y1 = p.y[0] + i * p.w / count, p.y[0] + (i + 1) * p.w / count
        for j in range(3):
            z = p.h - 0.16 - j * 0.04
            yield box(
                "vent",
                BLACK,
                (face - 0.001, face + 0.002),
                (y0 + 0.3 * (y1 - y0), y1 - 0.3 * (y1 - y0)),
                (z, z + 0.012),
            )


def chest(p: Piece) -> Iterator[Part]:
    """Yield a trunk with a lid and metal bands."""
    lid = 0.7 * p.h
    wood = p.front if p.kind == "toy box" else p.wood
    yield box("body", wood, (p.x[0] + 0.006, p.x[1] - 0.012), (p.y[0] + 0.006, p.y[1] - 0.006), (0.0, lid - 0.006))
    yield slab(
        "lid", p.accent if p.kind == "toy box" else p.dark, (p.x[0], p.x[1] - 0.006), p.y, (lid, p.h), top=(0.92, 0.98)
    )
    for y in (-0.32 * p.w, 0.32 * p.w):
        yield box("band", p.metal, (p.x[0] + 0.003, p.x[1] - 0.009), (y - 0.02, y + 0.02), (0.003, lid - 0.003))
    yield box("lock", p.metal, (p.x[1] - 0.012, p.x[1]), (-0.035, 0.035), (lid - 0.07, lid + 0.02))


def storage_box(p: Piece) -> Iterator[Part]:
    """Yield a box with a lid and a label."""
    lid = 0.82 * p.h
    yield slab(
        "box", p.fabric, (p.x[0] + 0.008, p.x[1] - 0.008), (p.y[0] + 0.008, p.y[1] - 0.008), (0.0, lid), top=(1.0, 1.0)
    )
    yield box("lid", p.accent, (p.x[0], p.x[1] - 0.002), p.y, (lid + 0.002, p.h))
    yield box("label", LIGHT_GREY, (p.x[1] - 0.008, p.x[1]), (-0.16 * p.w, 0.16 * p.w), (0.35 * p.h, 0.55 * p.h))


def basket(p: Piece) -> Iterator[Part]:
    """Yield a woven basket: rings that widen upwards, with a rolled blanket inside."""
    rings = 4
    for i in range(rings):
        a, b = 0.78 + 0.2 * i / rings, 0.78 + 0.2 * (i + 0.8) / rings
        z = (0.86 * p.h * i / rings, 0.86 * p.h * (i + 1) / rings)
        yield oval(
            "weave",
            WICKER if i % 2 == 0 else p.wood,
            (0.0, 0.0),
            ((a * p.d / 2, a * p.w / 2), (b * p.d / 2 + 0.004, b * p.w / 2 + 0.004)),
            z,
            sides=20,
        )
    yield oval("rim", p.dark, (0.0, 0.0), ((p.d / 2, p.w / 2), (p.d / 2, p.w / 2)), (0.86 * p.h, 0.92 * p.h), sides=20)
    yield ball("content", p.bedding, (-0.42 * p.d, 0.42 * p.d), (-0.42 * p.w, 0.42 * p.w), (0.7 * p.h, p.h), rings=4)


def suitcase(p: Piece) -> Iterator[Part]:
    """Yield an upright suitcase on wheels with its handle out."""
    yield soft("shell", p.fabric, p.x, p.y, (0.05 * p.h, 0.82 * p.h), bevel=0.04)
    for y in (-0.3 * p.w, 0.3 * p.w):
        for x in (-0.3 * p.d, 0.3 * p.d):
            yield cylinder("wheel", BLACK, (0.028 * p.h, x), 0.028 * p.h, (y - 0.012, y + 0.012), axis="y", sides=8)
    for y in (-0.16 * p.w, 0.16 * p.w):
        yield box("stem", p.metal, (-0.36 * p.d, -0.3 * p.d), (y - 0.008, y + 0.008), (0.8 * p.h, 0.97 * p.h))
    yield box("grip", BLACK, (-0.37 * p.d, -0.29 * p.d), (-0.2 * p.w, 0.2 * p.w), (0.97 * p.h, p.h))


def magazine_rack(p: Piece) -> Iterator[Part]:
    """Yield a small rack with magazines."""
    for y0 in (p.y[0], p.y[1] - 0.02):
        yield box("side", p.wood, p.x, (y0, y0 + 0.02), (0.0, 0.8 * p.h))
    inner = (p.y[0] + 0.02, p.y[1] - 0.02)
    yield box("bottom", p.wood, (p.x[0] + 0.01, p.x[1] - 0.01), inner, (0.12 * p.h, 0.17 * p.h))
    for i in range(5):
        x = p.x[0] + 0.08 * p.d + i * 0.17 * p.d
        yield box(
            "magazine",
            SPINES[i],
            (x, x + 0.05 * p.d),
            (inner[0] + 0.02, inner[1] - 0.02),
            (0.17 * p.h, (0.86 + 0.035 * i) * p.h),
        )


def room_divider(p: Piece) -> Iterator[Part]:
    """Yield a folding screen of panels in zigzag."""
    count = max(2, round(p.w / 0.45))
    for i in range(count):
        y0, y1 = p.y[0] + i * p.w / count, p.y[0] + (i + 1) * p.w / count
        for material, inset, thick in ((p.dark, 0.0, 0.012), (p.bedding, 0.04, 0.016)):
            panel = box(
                "panel",
                material,
                (-thick / 2, thick / 2),
                (y0 + 0.002 + inset, y1 - 0.002 - inset),
                (inset, p.h - inset),
            )
            share = (panel.vertices[:, 1] - y0) / (y1 - y0)
            swing = (share - 0.5) * (1 if i % 2 else -1)
            panel.vertices[:, 0] += swing * max(0.0, p.d - 0.016)
            yield panel


def toy_shelf(p: Piece) -> Iterator[Part]:
    """Yield a low shelf of cubes with coloured boxes."""
    columns, rows = max(2, round(p.w / 0.36)), max(1, round(p.h / 0.36))
    t = 0.018
    yield from open_case(p, p.wood, [t + i * (p.h - t) / rows for i in range(rows + 1)], t)
    rng = p.rng()
    for j in range(1, columns):
        y = p.y[0] + j * p.w / columns
        for i in range(rows):
            z0 = t + i * (p.h - t) / rows
            yield box(
                "wall", p.wood, (p.x[0] + 0.01, p.x[1] - 0.004), (y - t / 2, y + t / 2), (z0, z0 + (p.h - t) / rows - t)
            )
    for i in range(rows):
        for j in range(columns):
            y0, z0 = p.y[0] + j * p.w / columns + 0.03, t + i * (p.h - t) / rows
            span = (y0, y0 + p.w / columns - 0.06)
            if rng.random() < 0.7:
                yield box(
                    "bin", rng.choice(BRIGHT), (p.x[0] + 0.02, p.x[1] - 0.012), span, (z0, z0 + 0.7 * (p.h - t) / rows)
                )
            else:
                yield from books(p, span, z0, (p.h - t) / rows - t, salt=f"{i}{j}")


def hamper(p: Piece) -> Iterator[Part]:
    """Yield a laundry basket with a lid and cloth that hangs out."""
    yield from four(p, p.wood, 0.06 * p.h, thick=0.03)
    yield slab(
        "basket", WICKER, (p.x[0] + 0.01, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (0.06 * p.h, 0.9 * p.h)
    )
    yield soft("lid", p.bedding, p.x, p.y, (0.9 * p.h, p.h), bevel=0.015)
    yield box("handle", p.wood, (p.x[1] - 0.01, p.x[1]), (-0.08, 0.08), (0.7 * p.h, 0.75 * p.h))


BUILDERS: dict[str, Builder] = {
    "bookshelf": bookshelf,
    "shelving unit": shelving,
    "industrial shelf": shelving,
    "wall shelf": wall_shelf,
    "corner shelf": corner_shelf,
    "cabinet": cabinet,
    "shoe cabinet": cabinet,
    "bathroom cabinet": cabinet,
    "medical cabinet": cabinet,
    "unknown storage": cabinet,
    "filing cabinet": drawer_chest,
    "display cabinet": display_cabinet,
    "locker": locker,
    "chest": chest,
    "toy box": chest,
    "storage box": storage_box,
    "jewelry box": storage_box,
    "bread box": storage_box,
    "basket": basket,
    "suitcase": suitcase,
    "magazine rack": magazine_rack,
    "room divider": room_divider,
    "toy shelf": toy_shelf,
    "laundry basket": hamper,
}
