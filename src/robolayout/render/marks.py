"""What a plan shows besides furniture: the agent's free space, routes and passages, as plain shapes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

Point = tuple[float, float]
Rings = tuple[tuple[Point, ...], ...]


@dataclass(frozen=True)
class PlanMarks:
    """Shapes to mark on a plan, in metres.

    Attributes:
        free: Polygons of the free space that the agent can get to (for its centre), each as rings: outer first, holes.
        islands: Polygons of free space that it cannot get to.
        routes: Polyline from the entrance to each asset, by name.
        passages: Narrowest passages: the two points between which it is narrowest, and the width in metres.
        blocked: Names of assets that the agent cannot reach.
        agent_at: Where the agent's disc is drawn, or None.
    """

    free: tuple[Rings, ...] = ()
    islands: tuple[Rings, ...] = ()
    routes: Mapping[str, tuple[Point, ...]] = field(default_factory=dict[str, tuple[Point, ...]])
    passages: tuple[tuple[Point, Point, float], ...] = ()
    blocked: tuple[str, ...] = ()
    agent_at: Point | None = None
