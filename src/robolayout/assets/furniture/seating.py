"""Things to sit on; all face +x, with their backs at -x."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, four
from robolayout.assets.palette import BLACK, CHROME, DARK, RUBBER, STEEL, Piece
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import ball, box, cylinder, moved, sheared, slab, soft


def sofa(p: Piece) -> Iterator[Part]:
    """Yield a sofa or armchair: base, arms, seat and back cushions on short feet."""
    arm = min(0.22, 0.14 * p.w + 0.04)
    foot, seat = 0.12 * p.h, 0.5 * p.h
    back = p.x[0] + 0.24 * p.d
    inner = (p.y[0] + arm, p.y[1] - arm)
    yield from four(p, p.dark, foot, thick=0.05, inset=0.05, round_=True)
    yield box("base", p.fabric, (p.x[0] + 0.01, p.x[1] - 0.015), (p.y[0] + 0.01, p.y[1] - 0.01), (foot, 0.34 * p.h))
    for y0, y1 in ((p.y[0], p.y[0] + arm - 0.003), (p.y[1] - arm + 0.003, p.y[1])):
        yield soft("arm", p.fabric, (p.x[0] + 0.02, p.x[1]), (y0, y1), (foot + 0.005, 0.7 * p.h), bevel=0.04)
    yield soft("backrest", p.fabric, (p.x[0], back - 0.02), (p.y[0] + 0.02, p.y[1] - 0.02), (foot + 0.01, p.h - 0.02), bevel=0.04)
    count = max(1, round((inner[1] - inner[0]) / 0.72))
    step = (inner[1] - inner[0]) / count
    for i in range(count):
        y = (inner[0] + i * step + 0.003, inner[0] + (i + 1) * step - 0.003)
        yield soft("seat cushion", p.fabric, (back - 0.02, p.x[1] - 0.004), y, (0.34 * p.h, seat), bevel=0.035)
        yield sheared_cushion(p, y, (back - 0.04, back + 0.13), (seat - 0.01, p.h))
    if p.w > 1.3:
        for side in (-1, 1):
            y = side * (inner[1] - 0.26)
            yield soft("throw pillow", p.accent, (back + 0.12, back + 0.25), (y - 0.2, y + 0.2), (seat, seat + 0.36), bevel=0.06)


def sheared_cushion(p: Piece, y: tuple[float, float], x: tuple[float, float], z: tuple[float, float]) -> Part:
    """Return a back cushion that leans on the backrest."""
    part = soft("back cushion", p.fabric, x, y, z, bevel=0.05)
    lift = (part.vertices[:, 2] - z[0]) / (z[1] - z[0])
    part.vertices[:, 0] -= 0.04 * lift
    return part


def sectional(p: Piece) -> Iterator[Part]:
    """Yield an L-shaped sofa: a sofa along the back with a chaise on its left side."""
    deep = min(0.95, 0.56 * p.d)
    along = Piece(deep, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in sofa(along):
        yield moved(part, offset=(p.x[0] + deep / 2, 0.0, 0.0))
    wide = min(0.95, 0.42 * p.w)
    y = (p.y[1] - wide, p.y[1] - 0.001)
    front = p.x[0] + deep + 0.004
    yield box("chaise base", p.fabric, (front, p.x[1]), y, (0.12 * p.h, 0.34 * p.h))
    yield soft("chaise cushion", p.fabric, (front, p.x[1] - 0.01), (y[0] + 0.01, y[1] - 0.01), (0.34 * p.h, 0.5 * p.h), bevel=0.04)
    for y0 in (y[0] + 0.04, y[1] - 0.09):
        yield box("foot", p.dark, (p.x[1] - 0.1, p.x[1] - 0.05), (y0, y0 + 0.05), (0.0, 0.12 * p.h))


def recliner(p: Piece) -> Iterator[Part]:
    """Yield a wide armchair with a raised footrest in front."""
    body = Piece(0.86 * p.d, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in sofa(body):
        yield moved(part, offset=(-0.07 * p.d, 0.0, 0.0))
    yield soft("footrest", p.fabric, (p.x[1] - 0.14 * p.d, p.x[1]), (-0.3 * p.w, 0.3 * p.w), (0.16 * p.h, 0.4 * p.h), bevel=0.03)


def chair(p: Piece) -> Iterator[Part]:
    """Yield a chair in one of four styles: slats, upholstered, shell, ladder back."""
    style = p.variant % 4
    seat, t = 0.51 * p.h, p.thin(0.035, 0.08)
    yield from _chair_legs(p, p.wood if style != 2 else p.metal, seat - 0.04, t)
    cloth = p.fabric if style == 1 else p.accent if style == 2 else p.wood
    seat_x = (p.x[0] + 0.04, p.x[1])
    yield soft("seat", cloth, seat_x, (p.y[0], p.y[1]), (seat - 0.045, seat), bevel=0.015)
    if style == 0:
        yield soft("pad", p.fabric, (seat_x[0] + 0.04, seat_x[1] - 0.02), (p.y[0] + 0.02, p.y[1] - 0.02), (seat, seat + 0.025), bevel=0.012)
    if style in (1, 2):
        back = soft("back", cloth, (p.x[0] + 0.03, p.x[0] + 0.07), (p.y[0] + 0.02, p.y[1] - 0.02), (seat + 0.08, p.h), bevel=0.02)
        yield leaning(back, seat, p)
        for y0 in (p.y[0] + 0.06, p.y[1] - 0.06 - t):
            stay = box("stay", p.wood if style == 1 else p.metal, (p.x[0] + 0.035, p.x[0] + 0.06), (y0, y0 + t), (seat - 0.02, seat + 0.1))
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
            yield leaning(box("slat", p.wood, (thin[0] + 0.003, thin[1] - 0.003), (y - 0.009, y + 0.009), (seat, p.h - 0.09)), seat, p)
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
        yield box("arm post", p.wood, (p.x[1] - 0.26 * p.d, p.x[1] - 0.22 * p.d), (y - 0.02, y + 0.02), (0.46 * p.h, 0.64 * p.h))
        for i in range(4):
            x0, x1 = p.x[0] + i * p.d / 4, p.x[0] + (i + 1) * p.d / 4
            rise = (0.07, 0.015, 0.0, 0.015, 0.07)
            yield slanted("runner", p.dark, (x0, x1), (y - 0.022, y + 0.022), (rise[i], rise[i + 1]), 0.035)


def slanted(name: str, material: Material, x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], thick: float) -> Part:
    """Return a bar along x whose lower edge rises from z[0] to z[1]."""
    part = box(name, material, x, y, (0.0, thick))
    part.vertices[part.vertices[:, 0] <= x[0] + 1e-9, 2] += z[0]
    part.vertices[part.vertices[:, 0] > x[0] + 1e-9, 2] += z[1]
    return part


def chaise_longue(p: Piece) -> Iterator[Part]:
    """Yield a long upholstered seat with a raised end at the back."""
    seat = 0.46 * p.h
    yield from four(p, p.dark, 0.16 * p.h, thick=0.05, inset=0.06, round_=True)
    yield box("base", p.fabric, (p.x[0] + 0.04, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (0.16 * p.h, 0.3 * p.h))
    yield soft("seat", p.fabric, (p.x[0] + 0.1, p.x[1]), p.y, (0.3 * p.h, seat), bevel=0.04)
    back = soft("back", p.fabric, (p.x[0] + 0.1, p.x[0] + 0.24), (p.y[0] + 0.02, p.y[1] - 0.02), (0.25 * p.h, p.h), bevel=0.05)
    back.vertices[:, 0] -= 0.24 * (back.vertices[:, 2] / p.h - 0.25)
    yield back
    yield soft("cushion", p.accent, (p.x[0] + 0.2, p.x[0] + 0.36), (-0.22, 0.22), (seat, seat + 0.3), bevel=0.06)


def ottoman(p: Piece) -> Iterator[Part]:
    """Yield a padded block on short feet, or a round one where depth equals width."""
    foot = 0.14 * p.h
    if abs(p.d - p.w) < 0.03 and p.variant % 2:
        yield cylinder("body", p.fabric, (0.0, 0.0), p.d / 2, (0.0, 0.7 * p.h), sides=20)
        yield cylinder("cushion", p.fabric, (0.0, 0.0), (p.d / 2 - 0.005, p.d / 2 - 0.05), (0.7 * p.h, p.h), sides=20)
        return
    yield from four(p, p.dark, foot, thick=0.045, inset=0.04, round_=True)
    yield soft("body", p.fabric, (p.x[0] + 0.01, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (foot, 0.68 * p.h), bevel=0.015)
    yield soft("cushion", p.fabric, p.x, p.y, (0.68 * p.h, p.h), bevel=0.05)


def bean_bag(p: Piece) -> Iterator[Part]:
    """Yield a slumped sack with a dent to sit in."""
    yield ball("sack", p.fabric, p.x, p.y, (0.0, 0.62 * p.h))
    yield ball("back", p.fabric, (p.x[0] + 0.02, p.x[0] + 0.62 * p.d), (p.y[0] + 0.06, p.y[1] - 0.06), (0.1 * p.h, p.h))


def bench(p: Piece) -> Iterator[Part]:
    """Yield a bench: a plank with a cushion on four legs."""
    yield from four(p, p.dark, 0.8 * p.h, thick=0.05, inset=0.03)
    yield box("seat", p.wood, p.x, p.y, (0.8 * p.h, 0.88 * p.h))
    yield soft("cushion", p.fabric, (p.x[0] + 0.012, p.x[1] - 0.012), (p.y[0] + 0.012, p.y[1] - 0.012), (0.88 * p.h, p.h), bevel=0.02)


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
            yield sheared("leg", p.wood if not padded else p.dark, (x - t / 2, x + t / 2), (y - t / 2, y + t / 2), (0.0, seat), lean=lean)
    if p.h > 0.6:
        yield box("foot rest", p.metal, (p.d / 2 - 0.11 * p.d - t, p.d / 2 - 0.11 * p.d), (-0.34 * p.w, 0.34 * p.w), (0.3 * p.h, 0.3 * p.h + 0.02))


def bar_stool(p: Piece) -> Iterator[Part]:
    """Yield a bar stool: a column on a round foot, a seat with a low back."""
    seat = 0.84 * p.h
    yield cylinder("foot", CHROME, (0.0, 0.0), (0.46 * p.d, 0.42 * p.d), (0.0, 0.03), sides=20)
    yield cylinder("column", CHROME, (0.0, 0.0), 0.028, (0.03, seat - 0.06), sides=10)
    yield box("foot rest", CHROME, (0.0, 0.36 * p.d), (-0.12, 0.12), (0.32 * p.h, 0.32 * p.h + 0.02))
    yield soft("seat", p.fabric, p.x, p.y, (seat - 0.06, seat), bevel=0.025)
    yield soft("back", p.fabric, (p.x[0], p.x[0] + 0.05), (p.y[0] + 0.02, p.y[1] - 0.02), (seat - 0.02, p.h), bevel=0.02)


def folding_chair(p: Piece) -> Iterator[Part]:
    """Yield a folding chair: crossed legs, a slatted seat and back."""
    seat, t = 0.55 * p.h, 0.022
    for y0 in (p.y[0], p.y[1] - t):
        inside = y0 + (t if y0 < 0 else -t)
        yield sheared("leg", p.metal, (p.x[1] - 0.06, p.x[1] - 0.06 + t), (y0, y0 + t), (0.0, p.h), lean=(-(p.d - 0.08), 0.0))
        yield sheared("leg", p.metal, (p.x[0], p.x[0] + t), (inside, inside + t), (0.0, seat), lean=(p.d - 0.08, 0.0))
    for i in range(4):
        x = p.x[0] + 0.18 * p.d + i * 0.2 * p.d
        yield box("slat", p.wood, (x, x + 0.17 * p.d), (p.y[0] + 2 * t, p.y[1] - 2 * t), (seat, seat + 0.02))
    for z in (0.78 * p.h, 0.9 * p.h):
        x = p.x[1] - 0.06 - (p.d - 0.08) * z / p.h
        yield box("back slat", p.wood, (x + 0.012, x + 0.026), (p.y[0] + t, p.y[1] - t), (z, z + 0.07 * p.h))


def pew(p: Piece) -> Iterator[Part]:
    """Yield a wooden bench with a straight back and end panels."""
    seat = 0.48 * p.h
    for y0 in (p.y[0], p.y[1] - 0.04):
        yield box("end", p.dark, (p.x[0] + 0.002, p.x[1]), (y0, y0 + 0.04), (0.0, 0.72 * p.h))
    inner = (p.y[0] + 0.04, p.y[1] - 0.04)
    yield box("seat", p.wood, (p.x[0] + 0.08, p.x[1] - 0.02), inner, (seat - 0.04, seat))
    yield sheared("back", p.wood, (p.x[0] + 0.06, p.x[0] + 0.09), inner, (0.2 * p.h, p.h), lean=(-0.06, 0.0))


def booth(p: Piece) -> Iterator[Part]:
    """Yield an upholstered diner bench with a high, channelled back."""
    seat = 0.42 * p.h
    yield box("plinth", DARK, (p.x[0] + 0.02, p.x[1] - 0.08), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.12 * p.h))
    yield box("base", p.wood, (p.x[0] + 0.01, p.x[1] - 0.02), (p.y[0] + 0.003, p.y[1] - 0.003), (0.12 * p.h, 0.28 * p.h))
    yield soft("seat", p.fabric, (p.x[0] + 0.16, p.x[1]), p.y, (0.28 * p.h, seat), bevel=0.04)
    count = max(2, round(p.w / 0.26))
    for i in range(count):
        y0, y1 = p.y[0] + i * p.w / count, p.y[0] + (i + 1) * p.w / count
        yield soft("back", p.fabric, (p.x[0] + 0.03, p.x[0] + 0.16), (y0 + 0.002, y1 - 0.002), (0.28 * p.h, p.h - 0.03), bevel=0.03)
    yield box("back board", p.wood, (p.x[0], p.x[0] + 0.03), (p.y[0] + 0.001, p.y[1] - 0.001), (0.28 * p.h, p.h))


def waiting_bench(p: Piece) -> Iterator[Part]:
    """Yield several shell seats on one beam."""
    count, seat = max(2, round(p.w / 0.55)), 0.54 * p.h
    yield box("beam", STEEL, (-0.04, 0.02), p.y, (seat - 0.14, seat - 0.08))
    for y in (p.y[0] + 0.18 * p.w, p.y[1] - 0.18 * p.w):
        yield box("stand", STEEL, (-0.03, 0.01), (y - 0.03, y + 0.03), (0.03, seat - 0.14))
        yield box("foot", STEEL, (p.x[0] + 0.06, p.x[1] - 0.06), (y - 0.03, y + 0.03), (0.0, 0.03))
    for i in range(count):
        y = (p.y[0] + i * p.w / count + 0.02, p.y[0] + (i + 1) * p.w / count - 0.02)
        yield soft("seat", p.fabric, (p.x[0] + 0.12, p.x[1]), y, (seat - 0.06, seat), bevel=0.02)
        back = soft("back", p.fabric, (p.x[0] + 0.1, p.x[0] + 0.15), y, (seat + 0.02, p.h), bevel=0.02)
        back.vertices[:, 0] -= 0.1 * (back.vertices[:, 2] - seat) / (p.h - seat)
        yield back


def hanging_chair(p: Piece) -> Iterator[Part]:
    """Yield an egg-shaped basket that hangs from a stand."""
    yield cylinder("foot", p.metal, (0.0, 0.0), 0.45 * min(p.d, p.w), (0.0, 0.03), sides=20)
    yield box("mast", p.metal, (p.x[0], p.x[0] + 0.05), (-0.025, 0.025), (0.03, p.h))
    yield box("foot bar", p.metal, (p.x[0] + 0.05, 0.0), (-0.024, 0.024), (0.031, 0.06))
    yield box("jib", p.metal, (p.x[0] + 0.05, 0.1), (-0.02, 0.02), (p.h - 0.04, p.h - 0.002))
    yield cylinder("chain", p.metal, (0.06, 0.0), 0.008, (0.9 * p.h, p.h - 0.04), sides=6)
    shell = (p.x[0] + 0.1, p.x[1] - 0.12)
    yield ball("back shell", p.wood, shell, p.y, (0.2 * p.h, 0.91 * p.h), rings=6)
    yield ball("cushion", p.fabric, (shell[0] + 0.2, p.x[1]), (-0.36 * p.w, 0.36 * p.w), (0.24 * p.h, 0.74 * p.h))


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
    yield soft("seat", cloth, (p.x[0] + 0.16 * p.d, p.x[1] - 0.05 * p.d), (-0.4 * p.w, 0.4 * p.w), (seat - 0.08, seat), bevel=0.035)
    yield box("spine", DARK, (p.x[0] + 0.07 * p.d, p.x[0] + 0.1 * p.d), (-0.03, 0.03), (seat - 0.06, 0.7 * p.h))
    yield box("link", DARK, (p.x[0] + 0.1 * p.d, p.x[0] + 0.3 * p.d), (-0.03, 0.03), (seat - 0.11, seat - 0.081))
    back = soft("back", cloth, (p.x[0] + 0.1 * p.d, p.x[0] + 0.2 * p.d), (-0.38 * p.w, 0.38 * p.w), (seat + 0.08, p.h), bevel=0.035)
    yield leaning(back, seat, p)
    for side in (-1, 1):
        y = side * 0.44 * p.w
        yield soft("arm", DARK, (-0.2 * p.d, 0.2 * p.d), (y - 0.035, y + 0.035), (seat + 0.2, seat + 0.235), bevel=0.012)
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
    stripe = soft("stripe", p.accent, (p.x[0] + 0.19 * p.d, p.x[0] + 0.215 * p.d), (-0.1 * p.w, 0.1 * p.w), (seat + 0.14, p.h - 0.06), bevel=0.005)
    yield leaning(stripe, seat, p)


BUILDERS: dict[str, Builder] = {
    "sofa": sofa,
    "loveseat": sofa,
    "sofa bed": sofa,
    "armchair": sofa,
    "sectional sofa": sectional,
    "recliner": recliner,
    "rocking chair": rocking_chair,
    "chaise longue": chaise_longue,
    "ottoman": ottoman,
    "footstool": ottoman,
    "bean bag": bean_bag,
    "bench": bench,
    "window seat": bench,
    "chair": chair,
    "unknown seat": chair,
    "stool": stool,
    "bar stool": bar_stool,
    "folding chair": folding_chair,
    "pew": pew,
    "booth": booth,
    "waiting bench": waiting_bench,
    "hanging chair": hanging_chair,
    "office chair": office_chair,
    "gaming chair": gaming_chair,
    "kids chair": kids_chair,
    "high chair": high_chair,
}
