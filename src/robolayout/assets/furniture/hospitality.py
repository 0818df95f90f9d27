"""Restaurants, cafes and bars."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, four, open_case
from robolayout.assets.furniture.retail import bottles
from robolayout.assets.palette import (
    BLACK,
    BREAD,
    BRICK,
    CERAMIC,
    CHROME,
    DARK,
    EMBER,
    GLASS,
    IVORY,
    LEAF,
    LIGHT_GREY,
    ORANGE,
    RED,
    SLATE,
    STEEL,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, sheared, slab, soft


def menu_board(p: Piece) -> Iterator[Part]:
    """Yield a wall menu in three columns."""
    yield box("frame", p.dark, (p.x[0], p.x[0] + 0.5 * p.d), p.y, p.z)
    yield box(
        "board",
        SLATE,
        (p.x[0] + 0.5 * p.d, p.x[0] + 0.8 * p.d),
        (0.95 * p.y[0], 0.95 * p.y[1]),
        (0.05 * p.h, 0.95 * p.h),
    )
    for j in range(3):
        y = (-0.44 + 0.3 * j) * p.w
        for i in range(6):
            z = (0.72 - 0.11 * i) * p.h
            yield box(
                "text",
                YELLOW if i == 0 else IVORY,
                (p.x[0] + 0.8 * p.d, p.x[1]),
                (y, y + (0.24 - 0.03 * ((i + j) % 3)) * p.w),
                (z, z + 0.04 * p.h),
            )
    yield box("title", ORANGE, (p.x[0] + 0.8 * p.d, p.x[1]), (-0.2 * p.w, 0.2 * p.w), (0.83 * p.h, 0.9 * p.h))


def buffet(p: Piece) -> Iterator[Part]:
    """Yield a table under a long cloth with a runner, clear for dishes."""
    low = p.h - 0.004
    yield slab("cloth", p.bedding, p.x, p.y, (0.0, low), top=(0.97, 0.988))
    yield box("runner", p.accent, (-0.475 * p.d, 0.475 * p.d), (-0.488 * p.w, 0.488 * p.w), (low, p.h))
    yield slab(
        "overlay",
        p.accent,
        (-0.5 * p.d - 0.003, 0.5 * p.d + 0.003),
        (-0.16 * p.w, 0.16 * p.w),
        (0.45 * p.h, low - 0.002),
        top=(0.985, 1.0),
    )


def _dishes(p: Piece, low: float, high: float) -> Iterator[Part]:
    """Yield serving dishes along a counter."""
    tones = (ORANGE, LEAF, BREAD, YELLOW, RED, IVORY)
    count = max(2, round(p.w / 0.42))
    for i in range(count):
        y = 0.9 * (p.y[0] + (i + 0.5) * p.w / count)
        half = min(0.17, 0.36 * p.w / count)
        if i % 3 == 1:
            yield cylinder("bowl", CERAMIC, (0.0, y), (0.5 * half, half), (low, low + 0.09), sides=18)
            yield cylinder(
                "salad",
                tones[(i + p.variant) % 6],
                (0.0, y),
                (0.9 * half, 0.4 * half),
                (low + 0.09, low + 0.13),
                sides=18,
            )
        else:
            yield box("pan", STEEL, (-0.14, 0.14), (y - half, y + half), (low, low + 0.09))
            yield box(
                "food",
                tones[(i + p.variant) % 6],
                (-0.125, 0.125),
                (y - 0.9 * half, y + 0.9 * half),
                (low + 0.09, low + 0.1),
            )
            if i % 2 == 0:
                yield slab("lid", CHROME, (-0.14, -0.02), (y - half, y + half), (low + 0.1, high), top=(0.6, 0.9))


def buffet_counter(p: Piece) -> Iterator[Part]:
    """Yield a food counter with wells, a sneeze guard and a tray rail; guests at +x."""
    top = 0.66 * p.h
    rail = 0.22
    body = (p.x[0], p.x[1] - rail)
    yield box("plinth", DARK, (body[0] + 0.04, body[1] - 0.04), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.1))
    yield box("body", p.wood, body, (p.y[0] + 0.01, p.y[1] - 0.01), (0.1, top - 0.03))
    yield box("band", p.accent, (body[1], body[1] + 0.012), (p.y[0] + 0.05, p.y[1] - 0.05), (0.3 * top, 0.7 * top))
    yield box("top", STEEL, (body[0], body[1] + 0.02), p.y, (top - 0.029, top))
    for i in range(3):
        x = body[1] + 0.04 + 0.06 * i
        yield cylinder("tray rail", CHROME, (top - 0.06, x), 0.012, p.y, axis="y", sides=8)
    yield box("tray end", CHROME, (body[1] + 0.02, p.x[1]), (-0.01, 0.01), (top - 0.1, top - 0.075))
    moved_piece = Piece(p.d, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in _dishes(moved_piece, top, top + 0.18):
        part.vertices[:, 0] += (body[0] + body[1]) / 2
        yield part
    for y in (p.y[0] + 0.04, p.y[1] - 0.06):
        yield box("post", CHROME, (body[1] - 0.16, body[1] - 0.14), (y, y + 0.02), (top, p.h - 0.03))
    yield sheared(
        "guard",
        GLASS,
        (body[1] - 0.02, body[1] - 0.01),
        (p.y[0] + 0.03, p.y[1] - 0.03),
        (top + 0.2, p.h - 0.03),
        lean=(-0.12, 0.0),
    )
    yield box("lamp bar", CHROME, (body[0] + 0.12, body[1] - 0.1), (p.y[0] + 0.02, p.y[1] - 0.02), (p.h - 0.029, p.h))


def bar_counter(p: Piece) -> Iterator[Part]:
    """Yield a bar with panels and a foot rail, clear on top; guests at +x."""
    top = p.h
    yield box("body", p.dark, (p.x[0] + 0.04, p.x[1] - 0.16), (p.y[0] + 0.02, p.y[1] - 0.02), (0.0, top - 0.05))
    yield box("top", p.wood, p.x, p.y, (top - 0.049, top))
    count = max(2, round(p.w / 0.5))
    for i in range(count):
        y = (p.y[0] + 0.04 + i * (p.w - 0.08) / count + 0.03, p.y[0] + 0.04 + (i + 1) * (p.w - 0.08) / count - 0.03)
        yield box("panel", p.wood, (p.x[1] - 0.16, p.x[1] - 0.145), y, (0.2 * top, 0.88 * top))
    yield cylinder("foot rail", CHROME, (0.16, p.x[1] - 0.08), 0.02, (p.y[0] + 0.05, p.y[1] - 0.05), axis="y", sides=10)


def back_bar(p: Piece) -> Iterator[Part]:
    """Yield shelves of bottles above a cabinet."""
    low = 0.45 * p.h
    yield box("cabinet", p.dark, p.x, p.y, (0.0, low - 0.03))
    yield box("top", p.wood, p.x, p.y, (low - 0.029, low))
    back = Piece(0.5 * p.d, p.w - 0.04, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key)
    rows = [low + 0.002 + (p.h - low) * share for share in (0.34, 0.67, 0.999)]
    for part in open_case(back, p.wood, rows, 0.02, z=(low, p.h)):
        part.vertices[:, 0] -= 0.25 * p.d
        yield part
    for level in (low, *rows[:2]):
        yield from bottles(p, (p.y[0] + 0.06, p.y[1] - 0.06), level, 0.2 * (p.h - low), p.x[0] + 0.24 * p.d)


def chafing_dish(p: Piece) -> Iterator[Part]:
    """Yield a chafing dish with an open lid."""
    low = 0.4 * p.h
    yield from four(p, CHROME, low, thick=0.03, inset=0.02)
    yield box("pan", CHROME, p.x, p.y, (low, 0.62 * p.h))
    yield box("food", ORANGE, (0.9 * p.x[0], 0.9 * p.x[1]), (0.92 * p.y[0], 0.92 * p.y[1]), (0.62 * p.h, 0.66 * p.h))
    yield slab("lid", CHROME, (0.94 * p.x[0], 0.0), (0.96 * p.y[0], 0.96 * p.y[1]), (0.661 * p.h, p.h), top=(0.6, 0.84))
    for y in (-0.22 * p.w, 0.22 * p.w):
        yield cylinder("burner", EMBER, (0.0, y), 0.04, (0.0, 0.14 * p.h), sides=12)


def dispenser(p: Piece) -> Iterator[Part]:
    """Yield a drinks dispenser: two tanks over taps."""
    yield soft("base", STEEL, p.x, p.y, (0.0, 0.12 * p.h), bevel=0.01)
    yield box("body", DARK, (p.x[0] + 0.01, 0.2 * p.d), (0.94 * p.y[0], 0.94 * p.y[1]), (0.12 * p.h, 0.46 * p.h))
    for i, y in enumerate((-0.24 * p.w, 0.24 * p.w)):
        yield box(
            "juice",
            (ORANGE, RED)[i],
            (-0.36 * p.d, 0.3 * p.d),
            (y - 0.18 * p.w, y + 0.18 * p.w),
            (0.46 * p.h, 0.8 * p.h),
        )
        yield box("tank", GLASS, (-0.38 * p.d, 0.32 * p.d), (y - 0.2 * p.w, y + 0.2 * p.w), (0.465 * p.h, 0.92 * p.h))
        yield box("lid", BLACK, (-0.4 * p.d, 0.34 * p.d), (y - 0.21 * p.w, y + 0.21 * p.w), (0.92 * p.h, p.h))
        yield box("tap", CHROME, (0.2 * p.d, 0.34 * p.d), (y - 0.03, y + 0.03), (0.3 * p.h, 0.36 * p.h))


def tray_cart(p: Piece) -> Iterator[Part]:
    """Yield a rack of trays on castors."""
    for x0 in (p.x[0], p.x[1] - 0.03):
        for y0 in (p.y[0], p.y[1] - 0.03):
            yield box("post", STEEL, (x0, x0 + 0.03), (y0, y0 + 0.03), (0.1, p.h))
            yield cylinder("castor", BLACK, (0.05, x0 + 0.015), 0.05, (y0, y0 + 0.03), axis="y", sides=10)
    count = max(4, min(12, round(p.h / 0.15)))
    for i in range(count):
        z = 0.14 + i * (p.h - 0.18) / count
        yield box(
            "tray",
            p.accent if i % 2 else p.bedding,
            (0.94 * p.x[0], 0.94 * p.x[1]),
            (p.y[0] + 0.035, p.y[1] - 0.035),
            (z, z + 0.02),
        )
        if i % 3 == 0:
            yield cylinder("plate", CERAMIC, (0.0, -0.1 * p.w), 0.12, (z + 0.02, z + 0.035), sides=16)
    yield box("roof", STEEL, (p.x[0] + 0.001, p.x[1] - 0.001), (p.y[0] + 0.03, p.y[1] - 0.03), (p.h - 0.02, p.h))


def oven(p: Piece) -> Iterator[Part]:
    """Yield a pizza oven: a brick dome on a stand with a fire."""
    low = 0.5 * p.h
    yield box("stand", p.dark, (0.94 * p.x[0], 0.94 * p.x[1]), (0.94 * p.y[0], 0.94 * p.y[1]), (0.0, low - 0.05))
    yield box("slab", LIGHT_GREY, p.x, p.y, (low - 0.05, low))
    yield oval(
        "dome",
        BRICK,
        (-0.04 * p.d, 0.0),
        ((0.44 * p.d, 0.46 * p.w), (0.4 * p.d, 0.418 * p.w)),
        (low, 0.72 * p.h),
        sides=20,
    )
    yield oval(
        "dome",
        BRICK,
        (-0.04 * p.d, 0.0),
        ((0.4 * p.d, 0.42 * p.w), (0.14 * p.d, 0.147 * p.w)),
        (0.72 * p.h, 0.88 * p.h),
        sides=20,
    )
    yield cylinder("chimney", STEEL, (0.1 * p.d, 0.0), 0.07, (0.8 * p.h, p.h), sides=12)
    yield box("mouth", BRICK, (0.2 * p.d, 0.45 * p.d), (-0.28 * p.w, 0.28 * p.w), (low - 0.004, 0.7 * p.h))
    yield box("opening", BLACK, (0.45 * p.d, 0.455 * p.d), (-0.2 * p.w, 0.2 * p.w), (low + 0.01, 0.66 * p.h))
    yield ball(
        "fire", EMBER, (0.453 * p.d, 0.47 * p.d), (-0.1 * p.w, 0.1 * p.w), (low + 0.01, low + 0.09), rings=3, sides=8
    )


def grill(p: Piece) -> Iterator[Part]:
    """Yield a barbecue on a cart with a lid."""
    low = 0.62 * p.h
    yield from four(p, DARK, low, thick=0.05, inset=0.03)
    yield box("shelf", p.wood, (0.8 * p.x[0], 0.8 * p.x[1]), (0.84 * p.y[0], 0.84 * p.y[1]), (0.2 * p.h, 0.23 * p.h))
    yield box("bowl", BLACK, (0.9 * p.x[0], 0.9 * p.x[1]), (-0.32 * p.w, 0.32 * p.w), (low, 0.76 * p.h))
    yield slab(
        "lid", BLACK, (0.9 * p.x[0], 0.9 * p.x[1]), (-0.32 * p.w, 0.32 * p.w), (0.762 * p.h, p.h), top=(0.6, 0.9)
    )
    yield box("handle", CHROME, (0.84 * p.x[1], p.x[1]), (-0.2 * p.w, 0.2 * p.w), (0.82 * p.h, 0.85 * p.h))
    for y in ((p.y[0], -0.33 * p.w), (0.33 * p.w, p.y[1])):
        yield box("side table", p.wood, (0.8 * p.x[0], 0.8 * p.x[1]), y, (0.72 * p.h, 0.75 * p.h))


BUILDERS: dict[str, Builder] = {
    "menu board": menu_board,
    "buffet table": buffet,
    "buffet counter": buffet_counter,
    "bar counter": bar_counter,
    "back bar": back_bar,
    "chafing dish": chafing_dish,
    "beverage dispenser": dispenser,
    "tray return": tray_cart,
    "pizza oven": oven,
    "grill": grill,
}
