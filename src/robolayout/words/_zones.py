"""Parts of the room where things stand together: "a sleeping area on the left", "a reading nook by the window"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from robolayout.assets import CATALOGUE
from robolayout.words._chunk import Chunk
from robolayout.words._said import Link, Mention, Place, topped


@dataclass(eq=False)
class Zone:
    """A part of the room."""

    things: list[Mention] = field(default_factory=list[Mention])  # what was first named as being there
    half: bool = False  # whether it is a half of the room by its name
    place: tuple[Chunk, Sequence[Mention | Place]] | None = (
        None  # where it is, if that is said: a relation, and to what
    )

    def links(self, said: Sequence[Link]) -> Iterator[Link]:
        """Yield where its things stand, given what is said of them: all in a half of the room, else the first at the place."""
        if self.place is None:
            return
        chunk, objects = self.place
        placed = {m.thing for k in said for m in k.subjects if any(isinstance(item, Place) for item in k.objects)}
        free = [
            m for m in self.things if CATALOGUE[m.thing.noun.kind].on_floor and not topped(m) and m.thing not in placed
        ]
        half = any(isinstance(item, Place) and item.name == "side" for item in objects)
        if free:
            yield Link(chunk.value, tuple(free if half else free[:1]), tuple(objects), chunk.start, chunk.end)
