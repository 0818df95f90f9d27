"""What several builders share: books."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from robolayout._text import utf8
from robolayout.assets.palette import SPINES, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import Range, box

Builder = Callable[[Piece], Iterable[Part]]


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
