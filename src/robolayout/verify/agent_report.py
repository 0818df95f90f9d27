"""What one body can do in a layout: figures, sentences, routes and uses."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from robolayout.scene import Agent, Layout, Pose, Scene
from robolayout.verify.heading import Drive, HeadingSpace, entry, find_drives
from robolayout.verify.limits import Demands
from robolayout.verify.navigation import Navigation, blocked_sentence, navigation, shut_sentence, unreached_sentence
from robolayout.verify.proofs import (
    Remedies,
    exempt_from_reach,
    exempt_from_use,
    impossible,
    kept_out,
    remedies,
    why_unused,
)
from robolayout.verify.use import Usage, usage


@dataclass(frozen=True, eq=False)
class AgentReport:
    """What one agent can do in the layout."""

    agent: Agent  # the body
    navigation: Navigation  # where it can go and what it reaches
    usage: Usage  # what it can use
    demands: Demands = field(default_factory=Demands)  # what is asked of it

    def __reduce__(self) -> tuple[Any, ...]:
        """Return how to make it again, in another process or as a copy: by judging once more, which is exact."""
        return judge_agent, (self.navigation.scene, self.navigation.layout, self.agent, self.demands)

    @property
    def headings(self) -> HeadingSpace | None:
        """Where a rectangular body gets to and turns; None for a disc."""
        return self.usage.headings

    @cached_property
    def exempt(self) -> Mapping[str, str]:
        """Assets that this body is not asked to use (the figures still count them), and why."""
        used = {name for name, usable in self.usage.usable.items() if usable}
        return exempt_from_use(self.navigation.scene, self.agent, used)

    @cached_property
    def short(self) -> tuple[str, ...]:
        """Names of assets that it is asked to reach and use and does not, in the order of the scene."""
        return self.lacking(self.usage.usable)

    def lacking(self, usable: Mapping[str, bool]) -> tuple[str, ...]:
        """Return the names of assets that it is asked to reach and use and does not, if it uses these."""
        scene, reached = self.navigation.scene, self.navigation.reached
        aside = exempt_from_reach(scene, self.agent)

        def used(name: str) -> bool:
            return reached[name] and (usable[name] or bool(why_unused(scene.by_name[name], self.agent)))

        return tuple(name for name in reached if name not in aside and not used(name))

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
        scene, found, uses = self.navigation.scene, self.usage.drives, self.usage.uses.items()
        uses = [(name, use) for name, use in uses if not (use.moved or scene.by_name[name].lies_about)]
        stands = {name: use.stand for name, use in uses if use.stand is not None}
        if found is None:
            return find_drives(scene.room, self.headings, stands)
        return {name: found[name] for name in stands}

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
        nav, name = self.navigation, self.agent.name
        found = list(self.impossible)
        wanted = [asset for asset in nav.unreached if asset not in exempt_from_reach(nav.scene, self.agent)]
        if nav.main.is_empty:
            found += [] if kept_out(nav.scene, self.agent) else [blocked_sentence(nav)]
            found += [f"{name} reaches none of {', '.join(wanted)}."] if wanted else []
        else:
            if nav.walkable_ratio < self.demands.walkable_ratio:
                parts = len(nav.free.geoms) - 1
                cut_off = f"{parts} further {'part is' if parts == 1 else 'parts are'} cut off"
                found.append(
                    f"{name} can walk only {math.floor(100 * nav.walkable_ratio)}% of the free floor: {cut_off}."
                )
            found += [shut_sentence(nav, door) for door in nav.shut_doors]
            found += [unreached_sentence(nav, asset) for asset in wanted]
        unused = (use for use in self.usage.uses.values() if not use.usable and use.asset not in self.exempt)
        found += [f"{use.asset} cannot be used by {name}: {use.reason}." for use in unused if nav.reached[use.asset]]
        return tuple(found)

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
            "turning_places": self.headings
            and [
                {"point": [point.x, point.y], "area": place.area}
                for place in self.headings.turning.geoms
                for point in [place.representative_point()]
            ],
            "exempt": dict(self.exempt),
            "impossible": list(self.impossible),
            "remedies": list(self.remedies.sentences(self.agent)),
            "largest_disc": self.remedies.largest_disc,
            "violations": list(self.violations),
        }


def judge_agent(scene: Scene, layout: Layout, agent: Agent, demands: Demands | None = None) -> AgentReport:
    """Judge what one agent can get to and use; its sentences complain of what falls short of the demands."""
    nav = navigation(scene, layout, agent)
    return AgentReport(agent, nav, usage(scene, layout, agent, nav=nav), demands or Demands())


def finite(value: float) -> float | None:
    """Return a figure for plain data: None where it does not exist."""
    return float(value) if math.isfinite(value) else None
