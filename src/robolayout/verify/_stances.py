"""Stances: where a body's centre can be when it uses something, which way round, and with which chairs moved away."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout.verify.heading import Headings, HeadingSpace, rectangle
from robolayout.verify.navigation import Navigation

Region = tuple[int, BaseGeometry]  # number of a heading (0 for a disc), and where the centre can be


class Stances:
    """Where a body gets to: the disc's main component, or one region per heading of a rectangle."""

    def __init__(self, nav: Navigation) -> None:
        agent = nav.agent
        self._nav = nav
        rectangular = agent.length is not None and agent.width is not None
        self._headings = Headings(nav.scene.room, nav.blocking, agent) if rectangular else None

    @property
    def space(self) -> HeadingSpace | None:
        """The free space by heading; None for a disc."""
        return None if self._headings is None else self._headings.space

    @property
    def rectangular(self) -> bool:
        """Whether the body has a heading."""
        return self._headings is not None

    def surely(self) -> tuple[Region, ...]:
        """Return parts of `everywhere` that take little time to find."""
        return () if self._headings is None else tuple(_regions(self._headings.surely))

    def nowhere(self, zones: NDArray[np.object_]) -> NDArray[np.bool_]:
        """Return from which of some zones it takes little time to tell that the body does not get there."""
        if self._headings is None:
            return np.zeros(len(zones), dtype=bool)
        region = self._headings.at_most
        shapely.prepare(region)
        return ~shapely.intersects(region, zones)

    @cached_property
    def everywhere(self) -> tuple[Region, ...]:
        """Where the body gets to as things stand."""
        space = self.space
        return tuple(_regions((self._nav.main,) if space is None else space.standing))

    def opened(self, row: int) -> tuple[frozenset[int], tuple[Region, ...]]:
        """Return which chairs are moved away to use an asset, and what that opens."""
        nav = self._nav
        moved = nav.blocking.moved_for(nav.boxes, row)
        if not moved:
            return moved, ()
        return moved, self._headings.opened(moved) if self._headings else tuple(_regions(nav.space.opened(moved)))

    def heading(self, number: int) -> float:
        """Return a heading in radians; any for a disc."""
        return 0.0 if self._headings is None else self._headings.headings[number]

    def body(self, number: int) -> NDArray[np.float64]:
        """Return the corners (4, 2) of a rectangular body at a heading, around its centre."""
        assert self._headings is not None
        return rectangle(self._nav.agent, self._headings.headings[number])


def _regions(found: Iterable[BaseGeometry]) -> Iterator[Region]:
    return ((number, region) for number, region in enumerate(found) if not region.is_empty)
