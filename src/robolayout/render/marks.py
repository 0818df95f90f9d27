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
        under: Polygons of the free space under or inside furniture.
        parts: Outlines of the parts of such furniture that are in the agent's way (the legs of a table).
        circles: Turning circles: centre, and diameter in metres.
        arcs: How far the agent reaches: where it stands to use something, then an arc as a polyline.
        ghosts: Outlines of things where they stood before.
        arrows: From where a thing stood before to where it stands now.
        added: Outlines of things that were not there before.
        gone: Outlines of things that are not there any more.
    """

    free: tuple[Rings, ...] = ()
    islands: tuple[Rings, ...] = ()
    routes: Mapping[str, tuple[Point, ...]] = field(default_factory=dict[str, tuple[Point, ...]])
    passages: tuple[tuple[Point, Point, float], ...] = ()
    blocked: tuple[str, ...] = ()
    agent_at: Point | None = None
    under: tuple[Rings, ...] = ()
    parts: tuple[tuple[Point, ...], ...] = ()
    circles: tuple[tuple[Point, float], ...] = ()
    arcs: tuple[tuple[Point, ...], ...] = ()
    ghosts: tuple[tuple[Point, ...], ...] = ()
    arrows: tuple[tuple[Point, Point], ...] = ()
    added: tuple[tuple[Point, ...], ...] = ()
    gone: tuple[tuple[Point, ...], ...] = ()
