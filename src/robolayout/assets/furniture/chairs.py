"""Chairs and stools; all face +x, with their backs at -x."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, four
from robolayout.assets.palette import BLACK, CHROME, DARK, RUBBER, STEEL, Piece
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import box, cylinder, moved, sheared, slab, soft


def chair(p: Piece) -> Iterator[Part]:
    """Yield a chair in one of four styles: slats, upholstered, shell, ladder back."""
    style = p.variant % 4
    seat, t = 0.51 * p.h, p.thin(0.035, 0.08)
    yield from _chair_legs(p, p.wood if style != 2 else p.metal, seat - 0.04, t)
    cloth = p.fabric if style == 1 else p.accent if style == 2 else p.wood
    seat_x = (p.x[0] + 0.04, p.x[1])
    yield soft("seat", cloth, seat_x, (p.y[0], p.y[1]), (seat - 0.045, seat), bevel=0.015)
    if style == 0:
        yield soft(
            "pad",
            p.fabric,
            (seat_x[0] + 0.04, seat_x[1] - 0.02),
            (p.y[0] + 0.02, p.y[1] - 0.02),
            (seat, seat + 0.025),
            bevel=0.012,
        )
    if style in (1, 2):
        back = soft(
            "back",
            cloth,
            (p.x[0] + 0.03, p.x[0] + 0.07),
            (p.y[0] + 0.02, p.y[1] - 0.02),
            (seat + 0.08, p.h),
            bevel=0.02,
        )
        yield leaning(back, seat, p)
        for y0 in (p.y[0] + 0.06, p.y[1] - 0.06 - t):
            stay = box(
                "stay",
                p.wood if style == 1 else p.metal,
                (p.x[0] + 0.035, p.x[0] + 0.06),
                (y0, y0 + t),
                (seat - 0.02, seat + 0.1),
            )
            yield leaning(stay, seat, p)
        return
    yield from _wooden_back(p, seat, t, style)


def _wooden_back(p: Piece, seat: float, t: float, style: int) -> Iterator[Part]:
    """Yield posts and slats of a chair's back."""
    x = (p.x[0] + 0.035, p.x[0] + 0.035 + t)
    for y0 in (p.y[0] + 0.005, p.y[1] - 0.005 - t):
        yield leaning(box("post", p.wood, x, (y0, y0 + t), (seat - 0.02, p.h - 0.002)), seat, p)
    inner = (p.y[0] + 0.005 + t, p.y[1] - 0.005 - t)
    thin = (x[0] + 0.006, x[1] - 0.006)
    if style == 0:
        yield leaning(box("rail", p.wood, thin, inner, (p.h - 0.09, p.h)), seat, p)
        for i in range(1, 5):
            y = inner[0] + i * (inner[1] - inner[0]) / 5
            yield leaning(
                box("slat", p.wood, (thin[0] + 0.003, thin[1] - 0.003), (y - 0.009, y + 0.009), (seat, p.h - 0.09)),
                seat,
                p,
            )
        return
    for i in range(3):
        z = seat + 0.12 * p.h + i * 0.135 * p.h
        yield leaning(box("rung", p.wood, thin, inner, (z, min(z + 0.07 * p.h, p.h))), seat, p)


def leaning(part: Part, seat: float, p: Piece) -> Part:
    """Lean a piece of a back backwards, in place: 0 at the seat, up to 5 cm at the top."""
    lift = (part.vertices[:, 2] - seat) / (p.h - seat)
    part.vertices[:, 0] -= min(0.05, 0.1 * p.d) * lift
    return part


def _chair_legs(p: Piece, material: Material, top: float, t: float) -> Iterator[Part]:
    """Yield four slightly splayed legs."""
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (p.d / 2 - t / 2) + (0.02 if sx < 0 else 0.0), sy * (p.w / 2 - t / 2)
            leg = box("leg", material, (x - t / 2, x + t / 2), (y - t / 2, y + t / 2), (0.0, top))
            upper = leg.vertices[:, 2] > 0
            leg.vertices[upper, 0] -= sx * 0.02
            leg.vertices[upper, 1] -= sy * 0.02
            yield leg


def rocking_chair(p: Piece) -> Iterator[Part]:
    """Yield a chair with arms on two runners."""
    body = Piece(0.72 * p.d, 0.88 * p.w, p.h - 0.06, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key)
    for part in chair(body):
        yield moved(part, offset=(-0.02, 0.0, 0.05))
    for side in (-1, 1):
        y = side * 0.44 * p.w
        arm_y = (y - 0.03, y + 0.03)
        yield box("arm", p.wood, (p.x[0] + 0.2 * p.d, p.x[1] - 0.16 * p.d), arm_y, (0.64 * p.h, 0.67 * p.h))
        yield box(
            "arm post",
            p.wood,
            (p.x[1] - 0.26 * p.d, p.x[1] - 0.22 * p.d),
            (y - 0.02, y + 0.02),
            (0.46 * p.h, 0.64 * p.h),
        )
        for i in range(4):
            x0, x1 = p.x[0] + i * p.d / 4, p.x[0] + (i + 1) * p.d / 4
            rise = (0.07, 0.015, 0.0, 0.015, 0.07)
            yield slanted("runner", p.dark, (x0, x1), (y - 0.022, y + 0.022), (rise[i], rise[i + 1]), 0.035)


def slanted(
    name: str, material: Material, x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], thick: float
) -> Part:
    """Return a bar along x whose lower edge rises from z[0] to z[1]."""
    part = box(name, material, x, y, (0.0, thick))
    part.vertices[part.vertices[:, 0] <= x[0] + 1e-9, 2] += z[0]
    part.vertices[part.vertices[:, 0] > x[0] + 1e-9, 2] += z[1]
    return part


def stool(p: Piece) -> Iterator[Part]:
    """Yield a stool: a round or square seat on four legs with a foot ring on high ones."""
    seat = p.h - min(0.05, 0.12 * p.h)
    padded = p.variant % 2 == 0
    yield cylinder("seat", p.fabric if padded else p.wood, (0.0, 0.0), min(p.d, p.w) / 2 - 0.012, (seat, p.h), sides=20)
    t = p.thin(0.035)
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (p.d / 2 - t / 2), sy * (p.w / 2 - t / 2)
            lean = (-sx * 0.2 * p.d, -sy * 0.2 * p.w)
            yield sheared(
                "leg",
                p.wood if not padded else p.dark,
                (x - t / 2, x + t / 2),
                (y - t / 2, y + t / 2),
                (0.0, seat),
                lean=lean,
            )
    if p.h > 0.6:
        yield box(
            "foot rest",
            p.metal,
            (p.d / 2 - 0.11 * p.d - t, p.d / 2 - 0.11 * p.d),
            (-0.34 * p.w, 0.34 * p.w),
            (0.3 * p.h, 0.3 * p.h + 0.02),
        )


def bar_stool(p: Piece) -> Iterator[Part]:
    """Yield a bar stool: a column on a round foot, a seat with a low back."""
    seat = 0.84 * p.h
    yield cylinder("foot", CHROME, (0.0, 0.0), (0.46 * p.d, 0.42 * p.d), (0.0, 0.03), sides=20)
    yield cylinder("column", CHROME, (0.0, 0.0), 0.028, (0.03, seat - 0.06), sides=10)
    yield box("foot rest", CHROME, (0.3 * p.d, 0.36 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.32 * p.h, 0.32 * p.h + 0.02))
    yield box("link", CHROME, (0.02, 0.3 * p.d), (-0.015, 0.015), (0.32 * p.h + 0.002, 0.32 * p.h + 0.018))
    yield soft("seat", p.fabric, p.x, p.y, (seat - 0.06, seat), bevel=0.025)
    yield soft(
        "back", p.fabric, (p.x[0], p.x[0] + 0.05), (p.y[0] + 0.02, p.y[1] - 0.02), (seat - 0.02, p.h), bevel=0.02
    )


def folding_chair(p: Piece) -> Iterator[Part]:
    """Yield a folding chair: crossed legs, a slatted seat and back."""
    seat, t = 0.55 * p.h, 0.022
    for y0 in (p.y[0], p.y[1] - t):
        inside = y0 + (t if y0 < 0 else -t)
        yield sheared(
            "leg", p.metal, (p.x[1] - 0.06, p.x[1] - 0.06 + t), (y0, y0 + t), (0.0, p.h), lean=(-(p.d - 0.08), 0.0)
        )
        yield sheared("leg", p.metal, (p.x[0], p.x[0] + t), (inside, inside + t), (0.0, seat), lean=(p.d - 0.08, 0.0))
    for i in range(4):
        x = p.x[0] + 0.18 * p.d + i * 0.2 * p.d
        yield box("slat", p.wood, (x, x + 0.17 * p.d), (p.y[0] + 2 * t, p.y[1] - 2 * t), (seat, seat + 0.02))
    for z in (0.78 * p.h, 0.9 * p.h):
        x = p.x[1] - 0.06 - (p.d - 0.08) * z / p.h
        yield box("back slat", p.wood, (x + 0.012, x + 0.026), (p.y[0] + t, p.y[1] - t), (z, z + 0.07 * p.h))


def office_chair(p: Piece) -> Iterator[Part]:
    """Yield a swivel chair: five castors, a gas column, seat, arms and a curved back."""
    cloth = BLACK if p.variant % 3 == 0 else p.fabric
    seat, reach = 0.46 * p.h, 0.44 * min(p.d, p.w)
    for i in range(5):
        turn = 2 * math.pi * i / 5
        yield moved(box("spoke", DARK, (0.03, reach), (-0.02, 0.02), (0.06, 0.095)), turn=turn)
        wheel = cylinder("castor", RUBBER, (0.03, reach - 0.012), 0.03, (-0.022, 0.022), axis="y", sides=10)
        yield moved(wheel, turn=turn)
    yield cylinder("column", STEEL, (0.0, 0.0), 0.03, (0.095, seat - 0.08), sides=10)
    yield soft(
        "seat",
        cloth,
        (p.x[0] + 0.16 * p.d, p.x[1] - 0.05 * p.d),
        (-0.4 * p.w, 0.4 * p.w),
        (seat - 0.08, seat),
        bevel=0.035,
    )
    yield box("spine", DARK, (p.x[0] + 0.07 * p.d, p.x[0] + 0.1 * p.d), (-0.03, 0.03), (seat - 0.06, 0.7 * p.h))
    yield box("link", DARK, (p.x[0] + 0.1 * p.d, p.x[0] + 0.3 * p.d), (-0.03, 0.03), (seat - 0.11, seat - 0.081))
    back = soft(
        "back",
        cloth,
        (p.x[0] + 0.1 * p.d, p.x[0] + 0.2 * p.d),
        (-0.38 * p.w, 0.38 * p.w),
        (seat + 0.08, p.h),
        bevel=0.035,
    )
    yield leaning(back, seat, p)
    for side in (-1, 1):
        y = side * 0.44 * p.w
        yield soft(
            "arm", DARK, (-0.2 * p.d, 0.2 * p.d), (y - 0.035, y + 0.035), (seat + 0.2, seat + 0.235), bevel=0.012
        )
        yield box("arm post", DARK, (-0.03, 0.02), (y - 0.015, y + 0.015), (seat - 0.05, seat + 0.2))


def kids_chair(p: Piece) -> Iterator[Part]:
    """Yield a small sturdy chair in a bright colour."""
    seat, t = 0.52 * p.h, p.thin(0.04)
    yield from four(p, p.wood, seat - 0.03, thick=t, inset=0.01, round_=True)
    yield soft("seat", p.accent, p.x, p.y, (seat - 0.03, seat), bevel=0.01)
    for y0 in (p.y[0] + 0.02, p.y[1] - 0.02 - t):
        yield box("post", p.wood, (p.x[0] + 0.008, p.x[0] + 0.034), (y0, y0 + t), (seat, p.h - 0.06))
    yield soft("back", p.accent, (p.x[0], p.x[0] + 0.042), p.y, (p.h - 0.3 * p.h, p.h), bevel=0.015)


def high_chair(p: Piece) -> Iterator[Part]:
    """Yield a child's high chair with a tray in front."""
    seat = 0.55 * p.h
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (p.d / 2 - 0.018), sy * (p.w / 2 - 0.018)
            lean = (-sx * 0.22 * p.d, -sy * 0.18 * p.w)
            yield sheared("leg", p.wood, (x - 0.018, x + 0.018), (y - 0.018, y + 0.018), (0.0, seat), lean=lean)
    yield soft("seat", p.fabric, (-0.3 * p.d, 0.26 * p.d), (-0.33 * p.w, 0.33 * p.w), (seat, seat + 0.05), bevel=0.02)
    yield soft("back", p.fabric, (-0.36 * p.d, -0.28 * p.d), (-0.33 * p.w, 0.33 * p.w), (seat + 0.02, p.h), bevel=0.02)
    tray = 0.72 * p.h
    yield soft("tray", p.front, (0.02 * p.d, 0.42 * p.d), (-0.44 * p.w, 0.44 * p.w), (tray, tray + 0.025), bevel=0.01)
    for y in (-0.36 * p.w, 0.36 * p.w):
        yield box("arm", p.wood, (-0.3 * p.d, 0.2 * p.d), (y - 0.012, y + 0.012), (tray - 0.03, tray - 0.001))
    yield slab("foot rest", p.wood, (0.16 * p.d, 0.4 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.26 * p.h, 0.28 * p.h))


def gaming_chair(p: Piece) -> Iterator[Part]:
    """Yield an office chair with a high racing back and a coloured stripe."""
    yield from (part for part in office_chair(p) if part.name != "spine")
    seat = 0.46 * p.h
    stripe = soft(
        "stripe",
        p.accent,
        (p.x[0] + 0.19 * p.d, p.x[0] + 0.215 * p.d),
        (-0.1 * p.w, 0.1 * p.w),
        (seat + 0.14, p.h - 0.06),
        bevel=0.005,
    )
    yield leaning(stripe, seat, p)


BUILDERS: dict[str, Builder] = {
    "rocking chair": rocking_chair,
    "chair": chair,
    "unknown seat": chair,
    "stool": stool,
    "bar stool": bar_stool,
    "folding chair": folding_chair,
    "office chair": office_chair,
    "gaming chair": gaming_chair,
    "kids chair": kids_chair,
    "high chair": high_chair,
}
