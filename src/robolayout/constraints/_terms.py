"""Rows for the solver's batched kernels.

Most of what people say about furniture is "a stands so and so in the frame of b": a bed at a wall (the frame of the wall),
a chair at a table, a lamp to the left of a sofa. A `FrameTerm` is one such row: an interval for the place along each axis of
b's frame, an interval for the distance, a heading and a direction to look. What two things are to each other as mirror
images is a `MirrorTerm`, what must stay empty a `ClearTerm`. Relations of users are made of the same rows.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from robolayout.assets.prisms import Prism
from robolayout.constraints._refs import AssetRef, Ref

FAR = 1.0e3  # metres that stand for "no bound" in a term; larger than any room


@dataclass(frozen=True)
class Interval:
    """Bounds in metres along one axis of b's frame.

    The near side of a must be at or above `low` and the far side at or below `high`, where the sides lie `low_extent` and
    `high_extent` half-extents of a's footprint away from its centre: u - low_extent * e >= low, u + high_extent * e <= high.
    With both 0 the bounds are on the centre.
    """

    low: float = -FAR
    high: float = FAR
    low_extent: float = 0.0
    high_extent: float = 0.0


@dataclass(frozen=True)
class FrameTerm:
    """One row of the frame kernel: where `a` stands in the frame of `b`."""

    a: Ref  # what stands there
    # whose frame it is: an asset (x along its front), a wall (origin in its middle, x along it, y into the room), a
    # point (its axes: the world's, turned by its yaw)
    b: Ref
    along: Interval = Interval()  # interval along b's x axis
    across: Interval = Interval()  # interval along b's y axis
    fold: bool = False  # whether `across` bounds the absolute value (either side of b will do)
    # lowest and highest distance in metres between centres (to a wall: from the centre to its segment)
    distance: tuple[float, float] = (0.0, FAR)
    heading: float | None = None  # angle in radians of a's front in b's frame; None leaves it free
    # angle in radians by which a's front is turned before it must point at b; None leaves it free
    look: float | None = None
    moves: str = "a"  # which of the two yields: "a", "b" or "both"
    weight: float = 1.0  # factor on this row

    def row(self) -> tuple[float, ...]:
        """Return its numbers in the order that `_geometry.frame_residual` reads them."""
        heading, look = self.heading or 0.0, self.look or 0.0
        return (
            *(self.along.low, self.along.high, self.along.low_extent, self.along.high_extent),
            *(self.across.low, self.across.high, self.across.low_extent, self.across.high_extent),
            *self.distance,
            float(self.heading is not None),
            math.cos(heading),
            math.sin(heading),
            float(self.look is not None),
            math.cos(look),
            math.sin(look),
            float(self.fold),
            float(self.moves in ("a", "both")),
            float(self.moves in ("b", "both")),
            self.weight,
        )


@dataclass(frozen=True)
class MirrorTerm:
    """One row of the mirror kernel: `a` and `b` are mirror images about the axis of `ref` (its front; a wall's normal)."""

    a: Ref
    b: Ref
    ref: Ref
    weight: float = 1.0


@dataclass(frozen=True)
class ClearTerm:
    """One row of the clear kernel: a box that stays free of assets."""

    owner: Ref  # Whose frame the box is in; the owner itself may be in it. A wall's frame as in `FrameTerm`.
    center: tuple[float, float]  # middle of the box in that frame, metres
    half: tuple[float, float]  # half its size along the axes of that frame, metres
    span: tuple[float, float]  # lowest and highest height of the box in metres
    exempt: frozenset[str] = frozenset()  # names of assets that may be in it
    hard: bool = True  # whether it must stay free before anything else counts
    weight: float = 1.0  # factor on this row


@dataclass(frozen=True)
class OverlapTerm:
    """One row of the overlap kernel: a prism of `a` and one of `b`, which share a height, keep apart in plan."""

    a: AssetRef
    b: AssetRef
    first: Prism  # the prism of `a`
    second: Prism  # the prism of `b`


@dataclass(frozen=True)
class InsideTerm:
    """One row of the boundary kernel: the footprint of `a` stays in the room."""

    a: AssetRef


@dataclass(frozen=True)
class PairwiseTerm:
    """One row of the paper's reachability kernel: centres at least `required` metres apart, relu(required^2 - d^2)."""

    a: AssetRef
    b: AssetRef
    required: float
    weight: float


Term = FrameTerm | MirrorTerm | ClearTerm | OverlapTerm | InsideTerm | PairwiseTerm
