"""Navigation: can a body of this radius get from the door to every asset?

The agent is a disc; its free space is the room shrunk by its radius minus the obstacles grown by it (`_space.py`). What
it can enter through the first door is the main component; every other door's landing must meet it. An asset
is reached when its footprint lies within the agent's reach, measured in plan from the agent's centre, there or where it
has moved a chair away that it gets to. Ceiling assets and rugs count as reached, unplaced ones never.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import shapely
from shapely import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout._text import TOLD
from robolayout.scene import ROUNDING, Agent, Layout, Point, Room, Scene
from robolayout.scene.agent import horizontal_reach
from robolayout.verify._boxes import Boxes, boxes, share
from robolayout.verify._obstacles import Obstacles, obstacles
from robolayout.verify._space import (
    Space,
    disc_space,
    further_doors,
    met,
    plan_distances,
    reached_rows,
    standing_distances,
)  # fmt: skip
from robolayout.verify.limits import JUDGE
from robolayout.verify.passages import Passage, Passages
from robolayout.verify.routes import Route, entry_point, find_routes


@dataclass(frozen=True, eq=False)
class ShutDoor:
    """A door that a body does not get to from the first one."""

    number: int  # index of the door
    zone: Polygon  # its landing
    beyond: Polygon  # where the body's centre can be behind it; empty where it cannot even stand in the landing


@dataclass(frozen=True, eq=False)
class Navigation:
    """Where an agent can go and what it reaches; routes and passages are computed when first asked for."""

    scene: Scene
    layout: Layout
    agent: Agent  # the body
    space: Space  # its free space and the component it enters
    # metres in plan from each asset's footprint to the nearest place of the agent's centre in the main component, for
    # what is out of reach there also to the places of chairs; infinite if there is none, NaN if unplaced
    distances: Mapping[str, float]
    reached: Mapping[str, bool]  # verdict per asset
    boxes: Boxes = field(repr=False)  # the assets' boxes
    blocking: Obstacles = field(repr=False)  # what stands in its way

    @property
    def free(self) -> MultiPolygon:
        """Everywhere the agent's centre could be."""
        return self.space.free

    @property
    def main(self) -> Polygon:
        """Everywhere the agent's centre can get to from the door."""
        return self.space.main

    @property
    def walkable_ratio(self) -> float:
        """Area of the main component over all free area; 0 if there is none."""
        return float(self.main.area / self.free.area) if self.free.area > 0 else 0.0

    @cached_property
    def reachable_share(self) -> float:
        """Share of all assets that are reached as things stand, no chair moved."""
        standing = standing_distances(self.boxes, self.space)
        return share(reached_rows(self.boxes, standing, self.agent.reach))

    @property
    def reachable_share_chairs_aside(self) -> float:
        """Share of all assets that are reached, with chairs moved away that stand at them."""
        return share(list(self.reached.values()))

    @cached_property
    def shut_doors(self) -> tuple[ShutDoor, ...]:
        """Doors that the agent fits through and does not get to from the first one, though it would in the empty room.

        However little floor lies behind them: what furniture cuts off is a violation.
        """
        room, space = self.scene.room, self.space
        return tuple(
            ShutDoor(number, zone, met(shapely.get_parts(space.free), zone))
            for number, zone in further_doors(room, self.agent.radius).items()
            if not any(misfits(room, number, self.agent)) and space.main.intersection(zone).area <= JUDGE.sliver
        )

    def only_behind(self, door: ShutDoor) -> tuple[str, ...]:
        """Return the assets that are within reach from behind a shut door and from nowhere else."""
        near = shapely.distance(self.boxes.footprints, door.beyond) <= self.agent.reach + ROUNDING
        return tuple(name for name in self.unreached if near[self.boxes.names.index(name)])

    @cached_property
    def unreached(self) -> tuple[str, ...]:
        """Placed assets that are not reached, in the order of the scene."""
        found = self.boxes
        return tuple(found.names[row] for row in np.flatnonzero(found.placed) if not self.reached[found.names[row]])

    @cached_property
    def obstacles(self) -> tuple[str, ...]:
        """Names of the assets that stand in this body's way."""
        return tuple(self.boxes.names[row] for row in sorted(set(self.blocking.rows.tolist())))

    @cached_property
    def dividing(self) -> tuple[str, ...]:
        """Assets between the main component and free places that it does not hold, those nearest to both first."""
        return self._between(MultiPolygon([part for part in self.free.geoms if not part.intersects(self.main)]))

    def shutting(self, door: ShutDoor) -> tuple[str, ...]:
        """Return the assets between the main component and a shut door, or those that leave no room in its landing."""
        if not door.beyond.is_empty:
            return self._between(door.beyond)
        near = shapely.distance(self.blocking.shapes, door.zone) < self.space.radius
        return tuple(dict.fromkeys(self.boxes.names[row] for row in self.blocking.rows[near]))

    def _between(self, beyond: BaseGeometry) -> tuple[str, ...]:
        if beyond.is_empty or self.main.is_empty:
            return ()
        shapes = self.blocking.shapes
        gaps = np.maximum(shapely.distance(shapes, beyond), shapely.distance(shapes, self.main))
        touching = np.flatnonzero(gaps <= self.space.radius + JUDGE.touch)
        rows = self.blocking.rows[touching[np.argsort(gaps[touching], kind="stable")]]
        return tuple(dict.fromkeys(self.boxes.names[row] for row in rows))

    @cached_property
    def entry(self) -> Point | None:
        """Where routes start: the place of its centre nearest to the first door (no door: to the room's middle)."""
        return entry_point(self.scene.room, self.space)

    @cached_property
    def routes(self) -> Mapping[str, Route]:
        """A short collision-free way to every asset that is reached and stands or hangs within the walls."""
        feet = self.boxes.by_name(self.boxes.footprints)
        goals = {name: feet[name] for name in self._wanted if self.reached[name]}
        return find_routes(self.scene.room, self.space, goals)

    @cached_property
    def _search(self) -> Passages:
        return Passages(self.scene.room, self.boxes, self.blocking, self.agent)

    @cached_property
    def passages(self) -> Mapping[str, Passage]:
        """The narrowest passage on the widest way to every placed asset, reached or not."""
        return self._search.to_assets(self._wanted)

    @cached_property
    def door_passages(self) -> Mapping[int, Passage]:
        """The narrowest passage on the widest way to every shut door."""
        return self._search.to_doors([door.number for door in self.shut_doors])

    @cached_property
    def _wanted(self) -> tuple[str, ...]:
        found = self.boxes
        rows = np.flatnonzero(found.placed & ~found.needs_no_reach).tolist()
        return tuple(found.names[row] for row in rows if not found.assets[row].lies_about)

    def __repr__(self) -> str:
        shares = f"walkable {self.walkable_ratio:.2f}, reachable {self.reachable_share_chairs_aside:.2f}"
        return f"Navigation({self.agent.name}: {shares}, unreached {list(self.unreached)})"


def navigation(scene: Scene, layout: Layout, agent: Agent | None = None) -> Navigation:
    """Judge where an agent can go by the definitions of DESIGN section 8; about 5 ms for 40 assets."""
    agent = agent or scene.agent
    found = boxes(scene, layout)
    blocking = obstacles(found, agent)
    space = disc_space(scene.room, blocking, agent.radius)
    distances = plan_distances(found, space, agent.reach)
    reached = reached_rows(found, distances, agent.reach)
    by_name = found.by_name(distances), found.by_name(reached)
    return Navigation(scene, layout, agent, space, *by_name, found, blocking)


def misfits(room: Room, number: int, agent: Agent) -> Iterator[str]:
    """Yield why a body does not fit through a door."""
    door, across = room.doors[number], agent.width or 2 * agent.radius
    if door.width < across - ROUNDING:
        yield f"Door {number} is {door.width:.2f} m wide, {agent.name} needs {across:.2f} m: it cannot come in."
    if door.height < agent.height - ROUNDING:
        yield f"Door {number} is {door.height:.2f} m high, {agent.name} is {agent.height:.2f} m: it cannot come in."


def blocked_sentence(nav: Navigation) -> str:
    """Return what keeps a body out of a room that it could enter if it were empty."""
    zone, wide = nav.space.door, 2 * nav.agent.radius
    if zone is None:
        return f"{nav.agent.name} (a disc of {wide:.2f} m) has no place to stand: the furniture leaves none."
    near = nav.blocking.rows[shapely.distance(nav.blocking.shapes, zone) < nav.agent.radius]
    names = " and ".join(nav.boxes.names[row] for row in np.unique(near)[: TOLD.named])
    return f"{nav.agent.name} (a disc of {wide:.2f} m) cannot come in: the landing of door 0 is blocked by {names}."


def shut_sentence(nav: Navigation, door: ShutDoor) -> str:
    """Return which door is cut off, by what, and what lies beyond it."""
    agent, passage, needed = nav.agent.name, nav.door_passages[door.number], 2 * nav.agent.radius
    wall = nav.scene.room.doors[door.number].wall
    none = "no way to it, not even for a disc of 1 cm"
    width = none if passage.cut_off else f"narrowest passage {passage.width:.2f} m"
    between = passage.sides or " and ".join(nav.shutting(door)[: TOLD.named])
    found = f"Door {door.number} in wall {wall} cannot be reached by {agent}: {width}, needs {needed:.2f} m"
    found += f", between {between}." if between else "."
    if door.beyond.is_empty:
        return f"{found} Its landing leaves {agent} no place to stand."
    area = door.beyond.buffer(nav.agent.radius).area
    only = ", ".join(nav.only_behind(door))
    return f"{found} {area:.1f} m2 of floor{f' and {only}' if only else ''} can then be reached only from there."


def unreached_sentence(nav: Navigation, name: str) -> str:
    """Return why an asset is not reached: a passage that is too narrow, an arm that is too short, a height besides."""
    agent, passage = nav.agent, nav.passages[name]
    needed, high = 2 * agent.radius, beyond_height(nav, name)
    high = f"; {high}." if high else "."
    if passage.cut_off:
        return f"{name} cannot be reached by {agent.name}: there is no way to it, not even for a disc of 1 cm{high}"
    if passage.between and passage.width < needed:
        return (
            f"{name} cannot be reached by {agent.name}: narrowest passage {passage.width:.2f} m, "
            f"needs {needed:.2f} m, between {passage.sides}{high}"
        )
    return (
        f"{name} is out of reach of {agent.name}: {nav.distances[name]:.2f} m from the nearest place to stand, "
        f"reach is {agent.reach:.2f} m{high}"
    )


def beyond_height(nav: Navigation, name: str) -> str:
    """Return why an asset is too high or too low for the body where it is; empty where it is not, and on the floor."""
    row = nav.boxes.names.index(name)
    bottom, top = float(nav.boxes.bottom[row]), float(nav.boxes.top[row])
    return height_reason(nav.agent, bottom, top) if bottom > ROUNDING else ""


def height_reason(agent: Agent, bottom: float, top: float) -> str:
    """Return why something between two heights is too high or too low for a body; empty where it is not."""
    if horizontal_reach(agent, bottom, top) is not None:
        return ""
    if bottom > agent.reach_high:
        return f"it begins {bottom:.2f} m high, reach ends at {agent.reach_high:.2f} m: {bottom - agent.reach_high:.2f} m too high"
    if top < agent.reach_low:
        return (
            f"it ends {top:.2f} m high, reach begins at {agent.reach_low:.2f} m: {agent.reach_low - top:.2f} m too low"
        )
    shoulder = agent.shoulder_height or 0.0
    away = bottom - shoulder if bottom > shoulder else shoulder - top
    if agent.reach_bands or away <= agent.reach:
        return f"its hand gets to nothing {bottom:.2f} to {top:.2f} m high beyond its own footprint"
    return (
        f"it is {away:.2f} m {'above' if bottom > shoulder else 'below'} the shoulder at {shoulder:.2f} m, reach is "
        f"{agent.reach:.2f} m: {away - agent.reach:.2f} m too {'high' if bottom > shoulder else 'low'}"
    )
