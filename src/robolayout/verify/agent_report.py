"""What one body can do in a layout: figures, sentences, routes and uses."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from robolayout.scene import Agent, Point, Pose
from robolayout.verify.drives import Drive, entry, find_drives
from robolayout.verify.heading import HeadingSpace
from robolayout.verify.limits import Demands
from robolayout.verify.navigation import Navigation
from robolayout.verify.proofs import Remedies, exempt_from_reach, exempt_from_use, impossible, remedies
from robolayout.verify.sentences import agent_violations
from robolayout.verify.use import Usage


@dataclass(frozen=True, eq=False)
class AgentReport:
    """What one agent can do in the layout."""

    agent: Agent  # the body
    navigation: Navigation  # where it can go and what it reaches
    usage: Usage  # what it can use
    demands: Demands = field(default_factory=Demands)  # what is asked of it

    @property
    def headings(self) -> HeadingSpace | None:
        """Where a rectangular body gets to and turns; None for a disc."""
        return self.usage.headings

    @cached_property
    def exempt(self) -> Mapping[str, str]:
        """Assets that this body is not asked to use (the figures still count them), and why."""
        return exempt_from_use(self.navigation.scene, self.agent)

    @cached_property
    def short(self) -> tuple[str, ...]:
        """Names of assets that it is asked to reach and use and does not, in the order of the scene."""
        return self.lacking(self.usage.usable)

    def lacking(self, usable: Mapping[str, bool]) -> tuple[str, ...]:
        """Return the names of assets that it is asked to reach and use and does not, if it uses these."""
        scene, reached = self.navigation.scene, self.navigation.reached
        reach, use = exempt_from_reach(scene, self.agent), self.exempt
        return tuple(n for n in reached if not (reached[n] or n in reach) or not (usable[n] or n in use))

    @cached_property
    def impossible(self) -> tuple[str, ...]:
        """What no layout of this scene can achieve for this body, with proofs in numbers."""
        return impossible(self.navigation.scene, self.agent)

    @cached_property
    def remedies(self) -> Remedies:
        """The smallest changes to this layout that would let it reach everything."""
        return remedies(self.navigation)

    @cached_property
    def drives(self) -> Mapping[str, Drive]:
        """For a rectangular body the way, with its heading, to where it uses each thing; empty for a disc."""
        if self.headings is None:
            return {}
        found = self.usage.drives
        if found is None:
            return find_drives(self.navigation.scene.room, self.headings, self._stands)
        return {name: found[name] for name in self._stands}

    @property
    def ways(self) -> Mapping[str, Sequence[tuple[float, ...]]]:
        """The ways that its real footprint takes: x, y and heading of a rectangle, x and y of a disc; what it does not use aside."""
        if self.headings is not None:
            return {name: drive.poses for name, drive in self.drives.items()}
        return {name: route.points for name, route in self.navigation.routes.items()}

    @cached_property
    def start(self) -> Pose | None:
        """Where it comes in, wholly inside the room; None if it cannot."""
        space, room, first = self.headings, self.navigation.scene.room, next(iter(self.ways.values()), ())
        if first and len(first[0]) > 2:
            x, y, yaw = first[0]
            return Pose(x, y, 0.0, yaw)
        place = self.navigation.entry if space is None else space.start and entry(room, space.pieces[space.start])
        wall = room.walls[room.doors[0].wall if room.doors else 0]
        return Pose(*place, 0.0, math.atan2(wall.normal[1], wall.normal[0])) if place else None

    @cached_property
    def _stands(self) -> Mapping[str, Point]:
        """Where it stands to use things, no chair moved, by name."""
        uses, asset = self.usage.uses.items(), self.navigation.scene.by_name
        uses = [(name, use) for name, use in uses if not asset[name].lies_about]
        return {name: use.stand for name, use in uses if use.stand is not None and not use.moved}

    @property
    def doors_reached(self) -> bool:
        """Whether it gets from the first door to every other one that it fits through and gets to in the empty room."""
        return not self.navigation.shut_doors

    @property
    def figures(self) -> dict[str, float]:
        """The shares of DESIGN section 8 for this agent."""
        return {
            "walkable_ratio": self.navigation.walkable_ratio,
            "reachable_share": self.navigation.reachable_share,
            "reachable_share_chairs_aside": self.navigation.reachable_share_chairs_aside,
            "usable_share": self.usage.usable_share,
        }

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """What this agent cannot do, in sentences with numbers and names."""
        return agent_violations(self.navigation, self.usage, self.exempt, self.demands)

    def to_dict(self) -> dict[str, Any]:
        """Return figures, routes, passages and uses as plain data."""
        nav = self.navigation
        return {
            "name": self.agent.name,
            **self.figures,
            "free_area": nav.free.area,
            "routes": {
                name: {"length": route.length, "points": [list(point) for point in route.points]}
                for name, route in nav.routes.items()
            },
            "passages": {
                name: {"width": p.width, "point": p.point and list(p.point), "between": list(p.between)}
                for name, p in nav.passages.items()
            },
            "shut_doors": {
                str(door.number): {
                    "width": nav.door_passages[door.number].width,
                    "between": list(nav.shutting(door)),
                    "area": door.beyond.buffer(self.agent.radius).area,
                    "only_behind": list(nav.only_behind(door)),
                }
                for door in nav.shut_doors
            },
            "unreached": {name: finite(nav.distances[name]) for name in nav.unreached},
            "moved": {name: list(use.moved) for name, use in self.usage.uses.items() if use.moved},
            "opened": {name: use.opens for name, use in self.usage.uses.items() if use.opens},
            "stays_shut": [f"{hold.asset}/{hold.joint}" for hold in self.usage.holds if not hold.poses],
            "unusable": {name: use.reason for name, use in self.usage.uses.items() if not use.usable},
            "drives": {
                name: {
                    "length": drive.length,
                    "turned": math.degrees(drive.turned),
                    "reversals": drive.reversals,
                    "poses": [[x, y, math.degrees(heading)] for x, y, heading in drive.poses],
                }
                for name, drive in self.drives.items()
            },
            "undriven": list(self.usage.undriven),
            "turning_places": None if self.headings is None else _places(self.headings),
            "exempt": dict(self.exempt),
            "impossible": list(self.impossible),
            "remedies": list(self.remedies.sentences(self.agent)),
            "largest_disc": self.remedies.largest_disc,
            "violations": list(self.violations),
        }


def finite(value: float) -> float | None:
    """Return a figure for plain data: None where it does not exist."""
    return float(value) if math.isfinite(value) else None


def _places(space: HeadingSpace) -> list[dict[str, Any]]:
    """Return a point of each place where the centre can be while the body turns right round, and the place's area."""
    points = [place.representative_point() for place in space.turning.geoms]
    return [{"point": [p.x, p.y], "area": g.area} for p, g in zip(points, space.turning.geoms, strict=True)]
