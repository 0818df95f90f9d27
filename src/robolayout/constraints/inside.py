"""`inside`: a thing stands in another."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.assets import Surface
from robolayout.assets.surfaces import inner_surfaces
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.scene import Asset, Scene


@dataclass(frozen=True)
class Inside(OnTopOf):
    """`a` stands in `b`: on a shelf or in a drawer that can hold it, on the `surface` named so ("shelf 2"), in a box or basket."""

    name = "inside"
    example = 'solver.inside(box[0], bookshelf[0], surface="shelf 2")'

    @staticmethod
    def usual(lower: Asset) -> tuple[Surface, ...]:
        """Return the surfaces that are meant where none is named."""
        return inner_surfaces(lower)

    def fault(self, scene: Scene) -> str:
        """Return that nothing can stand in b, or which surfaces there are."""
        if not self.surface and not self.meant(scene):
            return f"nothing can stand in {self.b}: it has no open shelf and no drawer, and is no open box"
        return super().fault(scene)
