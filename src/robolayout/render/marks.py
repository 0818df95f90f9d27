"""What a plan shows besides furniture: the agent's free space, routes and passages, as plain shapes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

Point = tuple[float, float]
Rings = tuple[tuple[Point, ...], ...]


@dataclass(frozen=True)
class PlanMarks:
    """Shapes to mark on a plan, in metres."""

    # polygons of the free space that the agent can get to (for its centre), each as rings: outer first, holes
    free: tuple[Rings, ...] = ()
    islands: tuple[Rings, ...] = ()  # polygons of free space that it cannot get to
    # polyline from the entrance to each asset, by name
    routes: Mapping[str, tuple[Point, ...]] = field(default_factory=dict[str, tuple[Point, ...]])
    # narrowest passages: the two points between which it is narrowest, and the width in metres
    passages: tuple[tuple[Point, Point, float], ...] = ()
    blocked: tuple[str, ...] = ()  # names of assets that the agent cannot reach
    agent_at: Point | None = None  # where the agent's disc is drawn, or None
    under: tuple[Rings, ...] = ()  # polygons of the free space under or inside furniture
    # outlines of the parts of such furniture that are in the agent's way (the legs of a table)
    parts: tuple[tuple[Point, ...], ...] = ()
    circles: tuple[tuple[Point, float], ...] = ()  # turning circles: centre, and diameter in metres
    # how far the agent reaches: where it stands to use something, then an arc as a polyline
    arcs: tuple[tuple[Point, ...], ...] = ()
    ghosts: tuple[tuple[Point, ...], ...] = ()  # outlines of things where they stood before
    arrows: tuple[tuple[Point, Point], ...] = ()  # from where a thing stood before to where it stands now
    added: tuple[tuple[Point, ...], ...] = ()  # outlines of things that were not there before
    gone: tuple[tuple[Point, ...], ...] = ()  # outlines of things that are not there any more
