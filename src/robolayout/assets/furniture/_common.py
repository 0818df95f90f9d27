"""What several builders share: legs, open cases, books."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from robolayout._text import utf8
from robolayout.assets.palette import SPINES, Piece
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import Range, box, cylinder

Builder = Callable[[Piece], Iterable[Part]]


def four(
    p: Piece, material: Material, top: float, *, thick: float = 0.045, inset: float = 0.01, round_: bool = False
) -> Iterator[Part]:
    """Yield four legs from the floor up to `top`, tapered towards the floor, `inset` metres from the edges."""
    t = min(thick, 0.2 * p.d, 0.2 * p.w)
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (p.d / 2 - inset - t / 2), sy * (p.w / 2 - inset - t / 2)
            if round_:
                yield cylinder("leg", material, (x, y), (t * 0.3, t / 2), (0.0, top), sides=10)
            else:
                yield box("leg", material, (x - t / 2, x + t / 2), (y - t / 2, y + t / 2), (0.0, top))


def open_case(
    p: Piece, material: Material, levels: Iterable[float], thick: float, *, z: Range | None = None
) -> Iterator[Part]:
    """Yield an open shelf: two sides, a back, and boards whose upper faces lie at `levels`."""
    bottom, top = z or p.z
    for y0, y1 in ((p.y[0], p.y[0] + thick), (p.y[1] - thick, p.y[1])):
        yield box("side", material, p.x, (y0, y1), (bottom, top))
    inner = (p.y[0] + thick, p.y[1] - thick)
    yield box("back", material, (p.x[0], p.x[0] + 0.008), inner, (bottom, top - 0.002))
    for level in levels:
        yield box("shelf", material, (p.x[0] + 0.008, p.x[1] - 0.002), inner, (level - thick, level))


def books(p: Piece, y: Range, floor: float, room: float, *, x: Range | None = None, salt: str = "") -> Iterator[Part]:
    """Yield blocks of books that stand on `floor` with `room` metres of air above it."""
    rng = p.rng()
    rng.seed(utf8(f"{p.key}/{salt}/{floor:.4f}"))
    back, front = x or (p.x[0] + 0.02, p.x[1] - 0.03)
    at = y[0] + 0.004
    while at < y[1] - 0.06:
        width = rng.choice((0.035, 0.05, 0.07, 0.09))
        if at + width > y[1] - 0.004:
            break
        if rng.random() < 0.85:
            tall = room * rng.uniform(0.62, 0.92)
            depth = (front - back) * rng.uniform(0.7, 0.95)
            yield box(
                "books", rng.choice(SPINES), (back, back + depth), (at, at + width - 0.003), (floor, floor + tall)
            )
        at += width
