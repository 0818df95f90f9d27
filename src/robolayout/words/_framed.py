"""What is said of doors and windows besides their wall: how wide they are, and where along it: "80 cm wide", "near the corner"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from robolayout.words._chunk import NOTHING, Chunk, Framed
from robolayout.words._said import sides
from robolayout.words._tokens import count_of

WIDTHS = ("wide", "long", "length", "size", "across")
"""Measures that may be a width."""

WIDEST = (0.5, 6.0)
"""Metres that a door or window is wide."""

BY = ("in", "on", "by", "near", "next", "wall")
"""Relations to a wall, a side of the room, an end of a wall or a corner."""

BETWEEN = ("filler", "verb", "comma", "and", "pron")
"""What may stand before what is said."""

ENDS = ("", "stop", "comma", "and", "colon")
"""What may stand behind a place along the wall."""


def framed(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Return phrases with what is said of each door or window in it, and its wall right behind it."""
    found, at = list[Chunk](), 0
    while at < len(chunks):
        refused = at > 0 and chunks[at - 1].kind == "not"  # "without windows, 5 m long and 3 m wide" is the room
        if chunks[at].kind != "part" or chunks[at].value not in ("door", "window") or refused:
            found.append(chunks[at])
            at += 1
            continue
        told = _Told(chunks, at, _before(found, chunks[at]))
        found += told.said()
        at = told.at
    return found


def _before(found: list[Chunk], opening: Chunk) -> Chunk:
    """Return a door or window with the width before it, which is taken out: "a 2 m wide window"."""
    width = found[-1] if found else NOTHING
    measured = _width(width)
    if measured is None or width.end != opening.start:
        return opening
    article = found[-2] if found[1:] and found[-2].kind == "filler" and found[-2].value in ("a", "an", "the") else None
    del found[-2 if article else -1 :]
    det = "" if article is None else article.value.removesuffix("n")
    return replace(opening, start=(article or width).start, det=opening.det or det, opening=measured)


def _width(chunk: Chunk) -> Framed | None:
    """Return the width, and the height where both are said, that a measure gives."""
    measure = chunk.measure if chunk.kind == "measure" else None
    if measure is None or not WIDEST[0] <= measure.values[0] <= WIDEST[1]:
        return None
    if measure.kind == "height":
        return Framed(height=measure.values[0])
    if measure.kind not in WIDTHS:
        return None
    return Framed(width=measure.values[0], height=measure.values[1] if measure.kind == "size" else 0.0)


@dataclass(eq=False)
class _Told:
    """Reads what is said behind a door or window."""

    chunks: Sequence[Chunk]
    first: int  # where it stands
    opening: Chunk

    def __post_init__(self) -> None:
        self.at, self.wall, self.end = self.first + 1, NOTHING, self.opening.end
        self.framed = self.opening.opening or Framed()
        self.to_it = [c.kind for c in self.chunks[max(self.first - 1, 0) : self.first]] == ["rel"]

    def said(self) -> list[Chunk]:
        """Return the door or window and its wall; what says nothing else of it stays behind it."""
        plain = self._peek(self.at).kind == "rel" and self._walled(self.at + 1)
        while (after := self._read()) > self.at:
            self.at, self.end = after, self.chunks[after - 1].end
        only_walled = plain and self.at == self.first + 3
        if self.framed == (self.opening.opening or Framed()) and (only_walled or not self.wall.kind):
            self.at = self.first + 1
            return [self.opening]
        if not self.wall.kind:
            return [replace(self.opening, end=self.end, opening=self.framed)]
        led = replace(
            NOTHING, kind="rel", value="in", adjectives=("in",), start=self.wall.start, end=self.wall.start + 1
        )
        opening = replace(self.opening, opening=self.framed if self.framed != Framed() else None)
        if self.to_it:  # "the corner farthest from the door, which is in the middle of the south wall"
            return [replace(opening, adjectives=(*opening.adjectives, *sides(self.wall)), end=self.end)]
        return [opening, led, replace(self.wall, end=self.end)]

    def _peek(self, at: int) -> Chunk:
        return self.chunks[at] if at < len(self.chunks) else NOTHING

    def _walled(self, at: int) -> bool:
        """Return whether a wall that is told from the others is named there."""
        chunk = self._peek(at)
        return chunk.kind == "part" and chunk.value in ("wall", "side") and bool(sides(chunk)) and not self.wall.kind

    def _read(self) -> int:
        """Return where that goes on which is read of it, or where it stands if nothing more is."""
        at = self.at
        while self._peek(at).kind in BETWEEN and count_of(self._peek(at).value) is None:
            at += 1
        between = {chunk.kind: chunk for chunk in self.chunks[self.at : at]}
        own = self._peek(at + 1).value not in ("door", "window")  # not "a door and a 2 m wide window"
        width = _width(self._peek(at)) if own else None
        if width is not None:
            self.framed = replace(
                self.framed, width=width.width or self.framed.width, height=width.height or self.framed.height
            )
            return at + 1
        headed = not self._peek(self.first - 1).kind or self._peek(self.first - 1).kind == "stop"
        if self._peek(at).kind == "colon" and headed and self._walled(at + 1):  # "Window: east wall."
            self.wall = self._peek(at + 1)
            self.opening = replace(self.opening, det=self.opening.det or "the")
            return at + 2
        if self.to_it and "pron" not in between:
            return self.at  # "a desk by the window, in the middle of the room"
        before = self.framed
        after = self._place(at, centred=[c.value for c in between.values()][-1:] == ["centered"])
        goes_on = self._peek(after).kind not in ENDS and not (self._peek(after).kind == "rel" and self.at == at)
        if "comma" in between and goes_on and "pron" not in between and "verb" not in between:
            return self.at  # "a door, and along the north wall a bench"
        return after if after > at or self.framed != before else self.at

    def _place(self, at: int, *, centred: bool) -> int:
        """Return where that goes on which says where it is: in which wall, and where along it."""
        how, to = self._peek(at), self._peek(at + 1)
        if how.kind != "rel":
            along = "middle" if centred and self.wall.kind and not self.framed.along else ""
            self.framed = replace(self.framed, along=along or self.framed.along)
            return at
        if how.value == "middle" and (self._walled(at + 1) or (self.wall.kind and to.value in ("", "wall", "stop"))):
            return self._along("middle", at + 1)
        if how.value in ("left", "right") and "of" in how.adjectives and self._walled(at + 1):
            return self._along(how.value, at + 1)
        if how.value == "apart" and to.value == "corner" and how.measure is not None:
            self.framed = replace(self.framed, off=how.measure.values[0])
            return self._along(self._end(to) or self.framed.along, at + 2)
        if how.value not in BY:
            return at
        if self._walled(at + 1) and "end" not in to.adjectives:
            self.wall = to
            return at + 2
        ended = (
            to.value == "corner"
            or "end" in to.adjectives
            or (to.value == "side" and {"left", "right"} & {*to.adjectives})
        )
        if to.kind == "part" and ended and not self.framed.along:
            beyond = at + 2 + (self._peek(at + 2).value == "of")
            if not (self._walled(beyond) or self.wall.kind) and to.value == "corner" and sides(to)[1:]:
                self.wall = replace(to, value="wall", adjectives=to.adjectives[:1])  # "a door in the north west corner"
            walled = self._walled(beyond) or self.wall.kind
            if walled and self._end(to):
                return self._along(self._end(to), beyond if self._walled(beyond) else at + 2)
        return at

    def _along(self, where: str, at: int) -> int:
        """Note where along its wall it is, and the wall, if that is named there."""
        self.framed = replace(self.framed, along=where)
        if self._walled(at):
            self.wall = self._peek(at)
        return at + 1 if self._peek(at).kind == "part" and self._peek(at).value == "wall" else at

    def _end(self, to: Chunk) -> str:
        """Return the word that says which corner of its wall, or which end, is meant."""
        own = set(sides(self.wall)) if self.wall.kind else set[str]()
        words = (*sides(to), *(word for word in to.adjectives if word in ("left", "right")))
        return next((word for word in words if word not in own), "")
