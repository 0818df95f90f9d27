"""Parts of the room where things stand together: "a sleeping area on the left", "a reading nook by the window"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from robolayout.words._chunk import Chunk
from robolayout.words._said import Link, Mention, Place, named, place_in


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
        placed = {thing for k in said if place_in(k.objects) for thing in named(k.subjects)}
        free = [m for m in self.things if m.thing.category.on_floor and m.thing not in placed]
        if free:
            about = tuple(free if place_in(objects, "side") else free[:1])
            yield Link(chunk.value, about, tuple(objects), chunk.start, chunk.end)
