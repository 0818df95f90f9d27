"""`grid`: things stand in rows and columns, all facing the same way."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, Term, argument
from robolayout.constraints.row import Link, link_terms, links_outcome
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Grid(Relation):
    """The `items` fill `rows` x `columns`, row by row to the right and backwards, `aisle` m between rows, `gap` m (None: aisle) beside."""

    name = "grid"
    moves = ("items",)
    orients = True
    example = "solver.grid([desk[i] for i in range(6)], 2, 3, aisle=1.2, gap=0.9)"

    items: tuple[AssetRef, ...] = argument("asset", many=True)
    rows: int = argument("integer")
    columns: int = argument("integer")
    aisle: float = argument("number", unit="m", default=1.0)
    gap: float | None = argument("number", "none", unit="m", default=None)

    def fault(self, scene: Scene) -> str:
        """Refuse a grid without rows or columns, and one with fewer places than things."""
        if self.rows < 1 or self.columns < 1:
            return f"a grid has at least 1 row and 1 column, not {self.rows} x {self.columns}"
        if self.rows * self.columns < len(self.items):
            return f"{len(self.items)} things do not fit into {self.rows} x {self.columns} places"
        return ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per neighbour in front and one per neighbour at the left hand."""
        return link_terms(self._links(scene))

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Each within 5 cm and 10 degrees of its place beside its neighbours."""
        return links_outcome(self._links(scene), scene, layout)

    def _links(self, scene: Scene) -> list[Link]:
        gap = self.aisle if self.gap is None else self.gap
        links: list[Link] = []
        for i, item in enumerate(self.items):
            depth, width, _ = scene.by_name[item.name].size
            if i >= self.columns:
                ahead = self.items[i - self.columns]
                links.append((item, ahead, -(scene.by_name[ahead.name].size[0] + depth) / 2 - self.aisle, 0.0))
            if i % self.columns:
                left = self.items[i - 1]
                links.append((item, left, 0.0, -(scene.by_name[left.name].size[1] + width) / 2 - gap))
        return links
