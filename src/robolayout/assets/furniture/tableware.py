"""Small things on tops: what is laid on a table, food, bottles."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import (
    BREAD,
    BRIGHT,
    CERAMIC,
    CHROME,
    COFFEE,
    EMBER,
    GLASS,
    IVORY,
    LEAF,
    LINEN,
    SPINES,
    STEEL,
    WATER,
    WHITE,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import ball, box, cylinder, oval, soft


def _round(
    p: Piece, name: str, material: Material, radii: tuple[float, float], z: tuple[float, float], *, sides: int = 20
) -> Part:
    """Return an elliptic frustum about the middle; radii and heights are shares of the box."""
    rows = tuple((r * p.d / 2, r * p.w / 2) for r in radii)
    return oval(name, material, (0.0, 0.0), (rows[0], rows[1]), (z[0] * p.h, z[1] * p.h), sides=sides)


def plate(p: Piece) -> Iterator[Part]:
    """Yield a plate: a foot, a flaring rim, a well that shows as a ring."""
    glaze = (CERAMIC, IVORY, p.accent)[p.variant % 3]
    yield _round(p, "foot", glaze, (0.55, 0.62), (0.0, 0.3), sides=24)
    yield _round(p, "rim", glaze, (0.66, 1.0), (0.3, 0.92), sides=24)
    yield _round(p, "well", WHITE if glaze is not CERAMIC else IVORY, (0.68, 0.68), (0.92, 1.0), sides=24)


def bowl(p: Piece) -> Iterator[Part]:
    """Yield a bowl that holds soup or fruit."""
    glaze = (p.accent, CERAMIC, p.fabric)[p.variant % 3]
    yield _round(p, "foot", glaze, (0.45, 0.42), (0.0, 0.1))
    yield _round(p, "bowl", glaze, (0.48, 0.9), (0.1, 0.7))
    yield _round(p, "rim", glaze, (0.92, 1.0), (0.7, 0.94))
    yield _round(p, "content", p.bedding, (0.84, 0.84), (0.94, 1.0))


def glass(p: Piece) -> Iterator[Part]:
    """Yield a tumbler with water."""
    yield _round(p, "glass", GLASS, (0.8, 1.0), (0.0, 1.0), sides=14)
    yield _round(p, "water", WATER, (0.68, 0.78), (0.06, 0.62), sides=14)


def wine_glass(p: Piece) -> Iterator[Part]:
    """Yield a stemmed glass."""
    yield _round(p, "foot", GLASS, (0.85, 0.8), (0.0, 0.03), sides=14)
    yield _round(p, "stem", GLASS, (0.12, 0.12), (0.03, 0.42), sides=6)
    yield _round(p, "bowl", GLASS, (0.3, 1.0), (0.42, 0.68), sides=14)
    yield _round(p, "lip", GLASS, (1.0, 0.82), (0.68, 1.0), sides=14)


def cup(p: Piece) -> Iterator[Part]:
    """Yield a mug with a handle on its left and coffee inside."""
    side = 0.14 * p.w
    glaze = p.accent
    yield cylinder("cup", glaze, (0.0, -side), (0.84 * p.d / 2, p.d / 2), (0.0, 0.94 * p.h), sides=16)
    yield cylinder("coffee", COFFEE, (0.0, -side), 0.4 * p.d, (0.94 * p.h, p.h), sides=16)
    y = (-side + 0.4 * p.d, p.w / 2)
    for z in (0.22 * p.h, 0.68 * p.h):
        yield box("handle", glaze, (-0.07 * p.d, 0.07 * p.d), y, (z, z + 0.1 * p.h))
    yield box("grip", glaze, (-0.065 * p.d, 0.065 * p.d), (y[1] - 0.1 * p.w, y[1] - 0.001), (0.32 * p.h, 0.68 * p.h))


def saucer(p: Piece) -> Iterator[Part]:
    """Yield a small round plate."""
    yield _round(p, "saucer", CERAMIC, (0.6, 1.0), (0.0, 0.85))
    yield _round(p, "well", IVORY, (0.5, 0.5), (0.85, 1.0))


def cutlery(p: Piece) -> Iterator[Part]:
    """Yield a fork, knife or spoon that points to +x."""
    metal = CHROME
    x0, x1 = p.x
    neck = x0 + 0.68 * p.d
    yield soft("handle", metal, (x0, neck), (-0.24 * p.w, 0.24 * p.w), (0.0, 0.6 * p.h), bevel=0.003)
    if p.kind == "spoon":
        yield ball("bowl", metal, (neck - 0.004, x1), p.y, (0.0, p.h), rings=3, sides=10)
        return
    if p.kind == "knife":
        yield soft("blade", metal, (neck, x1), p.y, (0.0, p.h), bevel=0.003)
        return
    yield box("neck", metal, (neck, neck + 0.1 * p.d), p.y, (0.0, 0.7 * p.h))
    for i in range(4):
        y = p.y[0] + (i + 0.12) * p.w / 4
        yield box("tine", metal, (neck + 0.1 * p.d, x1), (y, y + 0.15 * p.w), (0.2 * p.h, p.h))


def cutlery_set(p: Piece) -> Iterator[Part]:
    """Yield knife, fork and spoon side by side."""
    for i in range(3):
        y = p.y[0] + (i + 0.5) * p.w / 3
        t = 0.06 * p.w
        yield box("handle", CHROME, (p.x[0] + 0.01 * i, 0.1 * p.d), (y - t, y + t), (0.0, 0.7 * p.h))
        yield soft("head", CHROME, (0.1 * p.d, p.x[1] - 0.008 * i), (y - p.w / 6, y + p.w / 6), (0.0, p.h), bevel=0.005)


def napkin(p: Piece) -> Iterator[Part]:
    """Yield a folded napkin."""
    yield box("fold", p.accent, p.x, p.y, (0.0, 0.48 * p.h))
    yield box("fold", p.accent, (p.x[0] + 0.01, p.x[1] - 0.004), (p.y[0] + 0.006, p.y[1] - 0.006), (0.5 * p.h, p.h))


def flat_mat(p: Piece) -> Iterator[Part]:
    """Yield a place mat with a border."""
    yield box("mat", p.fabric, p.x, p.y, (0.0, 0.7 * p.h))
    b = 0.07 * min(p.d, p.w)
    yield box("field", p.bedding, (p.x[0] + b, p.x[1] - b), (p.y[0] + b, p.y[1] - b), (0.7 * p.h, p.h))


def place_setting(p: Piece) -> Iterator[Part]:
    """Yield mat, plate, cutlery and a glass."""
    yield box("mat", p.fabric, p.x, p.y, (0.0, 0.004))
    r = 0.36 * min(p.d, p.w)
    yield cylinder("plate", CERAMIC, (-0.02, 0.0), (0.7 * r, r), (0.004, 0.022), sides=24)
    yield cylinder("well", IVORY, (-0.02, 0.0), 0.62 * r, (0.022, 0.024), sides=24)
    for y, t in ((-0.36 * p.w, 0.011), (0.36 * p.w, 0.013)):
        yield box("cutlery", CHROME, (-0.12, 0.08), (y - t, y + t), (0.004, 0.01))
    yield cylinder("glass", GLASS, (0.36 * p.d, -0.3 * p.w), (0.028, 0.034), (0.004, p.h), sides=12)


def tray(p: Piece) -> Iterator[Part]:
    """Yield a tray with a rim."""
    t = 0.012
    yield box("bottom", p.wood, p.x, p.y, (0.0, 0.3 * p.h))
    for x0 in (p.x[0], p.x[1] - t):
        yield box("rim", p.dark, (x0, x0 + t), p.y, (0.3 * p.h, p.h))
    for y0 in (p.y[0], p.y[1] - t):
        yield box("rim", p.dark, (p.x[0] + t, p.x[1] - t), (y0, y0 + t), (0.3 * p.h, p.h))


def teapot(p: Piece) -> Iterator[Part]:
    """Yield a teapot, kettle or watering can: belly, lid, spout at the left, handle at the right."""
    skin = STEEL if p.kind == "kettle" else p.accent
    r = 0.66
    yield ball("belly", skin, p.x, (-0.32 * p.w, 0.32 * p.w), (0.0, 0.84 * p.h))
    yield cylinder("lid", skin, (0.0, 0.0), (0.26 * p.d, 0.14 * p.d), (0.8 * p.h, 0.93 * p.h), sides=12)
    yield ball("knob", p.dark, (-0.09 * p.d, 0.09 * p.d), (-0.06 * p.w, 0.06 * p.w), (0.9 * p.h, p.h), rings=3, sides=8)
    spout = box("spout", skin, (-0.07 * p.d, 0.07 * p.d), (0.24 * p.w, p.y[1] - 0.12 * p.w), (0.3 * p.h, 0.48 * p.h))
    spout.vertices[spout.vertices[:, 1] > 0.3 * p.w, 2] += 0.26 * p.h
    spout.vertices[spout.vertices[:, 1] > 0.3 * p.w, 1] += 0.12 * p.w
    yield spout
    y = (p.y[0], -0.24 * p.w)
    for z in (0.28 * p.h, r * p.h):
        yield box("handle", p.dark, (-0.06 * p.d, 0.06 * p.d), y, (z, z + 0.07 * p.h))
    yield box("grip", p.dark, (-0.055 * p.d, 0.055 * p.d), (p.y[0] + 0.001, p.y[0] + 0.08 * p.w), (0.35 * p.h, r * p.h))


def pitcher(p: Piece) -> Iterator[Part]:
    """Yield a jug with a handle."""
    skin = GLASS if p.variant % 2 else p.accent
    yield cylinder("jug", skin, (0.0, 0.1 * p.w), (p.d / 2, 0.34 * p.d), (0.0, 0.7 * p.h), sides=16)
    yield cylinder("neck", skin, (0.0, 0.1 * p.w), (0.34 * p.d, 0.42 * p.d), (0.7 * p.h, p.h), sides=16)
    for z in (0.3 * p.h, 0.8 * p.h):
        yield box("handle", skin, (-0.06 * p.d, 0.06 * p.d), (p.y[0], -0.22 * p.w), (z, z + 0.06 * p.h))
    yield box("grip", skin, (-0.055 * p.d, 0.055 * p.d), (p.y[0] + 0.001, p.y[0] + 0.08 * p.w), (0.36 * p.h, 0.8 * p.h))


def cake(p: Piece) -> Iterator[Part]:
    """Yield a cake on a footed stand."""
    yield _round(p, "foot", CERAMIC, (0.55, 0.3), (0.0, 0.1))
    yield _round(p, "stem", CERAMIC, (0.14, 0.14), (0.1, 0.38), sides=10)
    yield _round(p, "plate", CERAMIC, (0.92, 1.0), (0.38, 0.46), sides=24)
    yield _round(p, "cake", BREAD, (0.78, 0.78), (0.46, 0.78), sides=24)
    yield _round(p, "icing", LINEN, (0.8, 0.78), (0.78, 0.9), sides=24)
    for i in range(5):
        x, y = ((0.5, 0.0), (0.15, 0.48), (-0.4, 0.3), (-0.4, -0.3), (0.15, -0.48))[i]
        r = 0.035 * min(p.d, p.w)
        yield cylinder("candle", BRIGHT[i], (x * 0.4 * p.d, y * 0.4 * p.w), r, (0.9 * p.h, p.h), sides=6)


def shaker(p: Piece) -> Iterator[Part]:
    """Yield a salt shaker."""
    yield _round(p, "body", CERAMIC, (1.0, 0.7), (0.0, 0.78), sides=12)
    yield _round(p, "cap", STEEL, (0.72, 0.5), (0.78, 1.0), sides=12)


def fruit(p: Piece) -> Iterator[Part]:
    """Yield one fruit with a stalk."""
    yield ball("fruit", BRIGHT[p.variant % 4], p.x, p.y, (0.0, 0.9 * p.h), rings=6)
    yield cylinder("stalk", LEAF, (0.0, 0.0), 0.05 * p.d, (0.86 * p.h, p.h), sides=5)


def bread(p: Piece) -> Iterator[Part]:
    """Yield a loaf with three cuts."""
    yield soft("loaf", BREAD, p.x, p.y, (0.0, 0.94 * p.h), bevel=0.4 * p.h)
    for x in (-0.24 * p.d, 0.0, 0.24 * p.d):
        yield box("cut", IVORY, (x - 0.02 * p.d, x + 0.02 * p.d), (-0.18 * p.w, 0.18 * p.w), (0.9 * p.h, p.h))


def bottle(p: Piece) -> Iterator[Part]:
    """Yield a bottle with a label and a cap."""
    skin = (SPINES[2], GLASS, SPINES[0], SPINES[5])[p.variant % 4]
    yield _round(p, "body", skin, (0.94, 0.94), (0.0, 0.6), sides=14)
    yield _round(p, "label", LINEN, (1.0, 1.0), (0.16, 0.46), sides=14)
    yield _round(p, "shoulder", skin, (0.94, 0.36), (0.6, 0.74), sides=14)
    yield _round(p, "neck", skin, (0.36, 0.32), (0.74, 0.95), sides=10)
    yield _round(p, "cap", p.accent, (0.4, 0.4), (0.95, 1.0), sides=10)


def jar(p: Piece) -> Iterator[Part]:
    """Yield a jar with a lid."""
    yield _round(p, "jar", (p.accent, GLASS)[p.variant % 2], (0.9, 1.0), (0.0, 0.8), sides=16)
    yield _round(p, "lid", p.wood, (0.86, 0.86), (0.8, 0.94), sides=16)
    yield _round(p, "knob", p.wood, (0.24, 0.2), (0.94, 1.0), sides=8)


def candle(p: Piece) -> Iterator[Part]:
    """Yield a candle with a flame."""
    yield _round(p, "wax", LINEN, (1.0, 1.0), (0.0, 0.8), sides=14)
    yield _round(p, "wick", COFFEE, (0.1, 0.1), (0.8, 0.86), sides=5)
    yield ball(
        "flame", EMBER, (-0.16 * p.d, 0.16 * p.d), (-0.16 * p.w, 0.16 * p.w), (0.84 * p.h, p.h), rings=3, sides=8
    )


def candlestick(p: Piece) -> Iterator[Part]:
    """Yield a candle in a metal holder."""
    yield _round(p, "foot", p.metal, (1.0, 0.8), (0.0, 0.05))
    yield _round(p, "stem", p.metal, (0.2, 0.14), (0.05, 0.44), sides=10)
    yield _round(p, "cup", p.metal, (0.25, 0.5), (0.44, 0.5), sides=12)
    yield _round(p, "candle", LINEN, (0.26, 0.22), (0.5, 0.9), sides=10)
    yield ball("flame", EMBER, (-0.06 * p.d, 0.06 * p.d), (-0.06 * p.w, 0.06 * p.w), (0.9 * p.h, p.h), rings=3, sides=6)


def ice_bucket(p: Piece) -> Iterator[Part]:
    """Yield a steel bucket with a bottle neck that looks out."""
    yield _round(p, "bucket", STEEL, (0.78, 1.0), (0.0, 0.74))
    yield _round(p, "ice", WHITE, (0.9, 0.9), (0.74, 0.78))
    yield _round(p, "neck", SPINES[2], (0.3, 0.18), (0.78, 1.0), sides=10)


def lazy_susan(p: Piece) -> Iterator[Part]:
    """Yield a turning tray."""
    yield _round(p, "foot", p.dark, (0.4, 0.4), (0.0, 0.5))
    yield _round(p, "tray", p.wood, (1.0, 1.0), (0.5, 1.0), sides=28)


BUILDERS: dict[str, Builder] = {
    "plate": plate,
    "bowl": bowl,
    "glass": glass,
    "wine glass": wine_glass,
    "cup": cup,
    "saucer": saucer,
    "fork": cutlery,
    "knife": cutlery,
    "spoon": cutlery,
    "cutlery set": cutlery_set,
    "napkin": napkin,
    "place mat": flat_mat,
    "place setting": place_setting,
    "tray": tray,
    "teapot": teapot,
    "kettle": teapot,
    "watering can": teapot,
    "pitcher": pitcher,
    "cake stand": cake,
    "salt shaker": shaker,
    "fruit": fruit,
    "bread": bread,
    "bottle": bottle,
    "soap dispenser": bottle,
    "jar": jar,
    "candle": candle,
    "candlestick": candlestick,
    "ice bucket": ice_bucket,
    "lazy susan": lazy_susan,
    "pet bowl": bowl,
}
