"""The report: what a layout achieves, in figures, verdicts and sentences (the definitions are DESIGN section 8)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from robolayout.scene import Agent, Layout, Scene
from robolayout.verify._boxes import share
from robolayout.verify.drives import Drive, find_drives
from robolayout.verify.heading import HeadingSpace
from robolayout.verify.metrics import published_metrics
from robolayout.verify.moves import Move, moves
from robolayout.verify.navigation import Navigation
from robolayout.verify.passages import WIDE
from robolayout.verify.physics import Physics
from robolayout.verify.proofs import Remedies, exempt_from_reach, exempt_from_use, impossible, remedies
from robolayout.verify.sentences import agent_violations
from robolayout.verify.use import Usage, Use

if TYPE_CHECKING:
    from robolayout.program import Program

SHOWN = 12
"""Violations that a notebook shows; the report holds all."""


@dataclass(frozen=True)
class Demands:
    """What a layout must achieve for `Report.ok`; every other share must be 1.

    Attributes:
        walkable_ratio: Smallest walkable ratio.
        statements_met_share: Smallest share of statements met.
    """

    walkable_ratio: float = 0.95
    statements_met_share: float = 0.95


@dataclass(frozen=True)
class StatementResult:
    """One statement of the program, as asked, measured in the layout.

    Attributes:
        number: Its number in the program.
        line: Line of the program text.
        source: Its program text.
        sentence: What it says.
        met: The verdict.
        value: The measured figure; NaN if an asset is unplaced.
        limit: What the figure is compared with.
        unit: Unit of both.
        text: The measurement in words.
        lost_to: Where it is not met: what meeting it would break, in words; empty if nobody looked.
    """

    number: int
    line: int
    source: str
    sentence: str
    met: bool
    value: float
    limit: float
    unit: str
    text: str
    lost_to: str = ""

    @property
    def complaint(self) -> str:
        """What is wrong, in a sentence; empty where it is met."""
        lost = f"; it lost to {self.lost_to}" if self.lost_to else ""
        return "" if self.met else f"{self.sentence} is not met: {self.text}{lost}."

    def to_dict(self) -> dict[str, Any]:
        """Return plain data; figures that do not exist are None."""
        return vars(self) | {"value": _finite(self.value), "limit": _finite(self.limit)}


@dataclass(frozen=True, eq=False)
class AgentReport:
    """What one agent can do in the layout.

    Attributes:
        agent: The body.
        navigation: Where it can go and what it reaches.
        usage: What it can use.
    """

    agent: Agent
    navigation: Navigation
    usage: Usage

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
        scene, reached, usable = self.navigation.scene, self.navigation.reached, self.usage.usable
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
        uses = self.usage.uses.items()
        stands = {name: use.stand for name, use in uses if use.stand is not None and not use.moved}
        return find_drives(self.navigation.scene.room, self.headings, stands)

    @property
    def figures(self) -> dict[str, float]:
        """The shares of DESIGN section 8 for this agent."""
        return {
            "walkable_ratio": self.navigation.walkable_ratio,
            "reachable_share": self.navigation.reachable_share,
            "usable_share": self.usage.usable_share,
        }

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """What this agent cannot do, in sentences with numbers and names."""
        return agent_violations(self.navigation, self.usage, self.exempt)

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
            "unreached": {name: _finite(nav.distances[name]) for name in nav.unreached},
            "moved": {name: list(use.moved) for name, use in self.usage.uses.items() if use.moved},
            "unusable": {name: use.reason for name, use in self.usage.uses.items() if not use.usable},
            "drives": {
                name: {
                    "length": drive.length,
                    "turned": math.degrees(drive.turned),
                    "poses": [[x, y, math.degrees(heading)] for x, y, heading in drive.poses],
                }
                for name, drive in self.drives.items()
            },
            "turning_places": None if self.headings is None else _places(self.headings),
            "exempt": dict(self.exempt),
            "impossible": list(self.impossible),
            "remedies": list(self.remedies.sentences(self.agent)),
            "largest_disc": self.remedies.largest_disc,
            "violations": list(self.violations),
        }


@dataclass(frozen=True, eq=False)
class Report:
    """What a layout achieves; routes, passages and published metrics are computed when first asked for.

    Attributes:
        scene: The scene.
        layout: The layout.
        physics: The physical checks.
        agents: One report per agent; top-level figures are the worst over agents.
        statements: Every statement as asked.
        demands: What `ok` asks for.
        timing: Wall and CPU seconds per station.
        planner: Who planned and what that took, where that was a model.
        stability: What a simulator found (`robolayout.export.settle`), as plain data; empty if none was asked.
        program: The program as asked, with its guesses.
    """

    scene: Scene
    layout: Layout
    physics: Physics
    agents: tuple[AgentReport, ...]
    statements: tuple[StatementResult, ...] = ()
    demands: Demands = Demands()
    timing: Mapping[str, Mapping[str, float]] = field(default_factory=dict[str, Mapping[str, float]])
    planner: Mapping[str, Any] = field(default_factory=dict[str, Any])
    stability: Mapping[str, Any] = field(default_factory=dict[str, Any])
    program: Program | None = None

    @cached_property
    def moved(self) -> tuple[Move, ...]:
        """What is not where the program put it, how far it went, and what it would violate there; the farthest first."""
        return moves(self.scene, self.layout, self.program, tuple(report.agent for report in self.agents))

    @cached_property
    def figures(self) -> dict[str, float | bool]:
        """The figures of DESIGN section 8, by name, in its order."""
        worst = {
            name: min(report.figures[name] for report in self.agents)
            for name in ("walkable_ratio", "reachable_share", "usable_share")
        }
        shares = self.physics.shares
        return {
            "placed_share": shares["placed_share"],
            "collision_free_share": shares["collision_free_share"],
            "collision_free_scene": shares["collision_free_share"] == 1.0,
            "in_boundary_share": shares["in_boundary_share"],
            "supported_share": shares["supported_share"],
            "door_clear": self.physics.door_clear,
            **worst,
            "statements_met_share": share([item.met for item in self.statements]),
        }

    @cached_property
    def metrics(self) -> Mapping[str, Mapping[str, object]]:
        """Published metrics under their own names and rules; they see only the placed assets."""
        found = published_metrics(self.scene, self.layout)
        if self.statements:
            valid = all(self.physics.placed.values()) and set(found["LayoutVLM"].values()) == {100.0}
            met = share([item.met for item in self.statements])
            found["LayoutVLM"]["PSA_style"] = 100.0 * met if valid else 0.0
        return found

    @cached_property
    def unmet(self) -> tuple[str, ...]:
        """Names of the figures that fall short of what is demanded; exempt assets are not demanded of an agent."""
        least = dict.fromkeys(self.figures, 1.0) | vars(self.demands)
        if not any(report.short for report in self.agents):
            least |= {"reachable_share": 0.0, "usable_share": 0.0}
        return tuple(name for name, value in self.figures.items() if value < least[name])

    @property
    def ok(self) -> bool:
        """Whether every demand is met and nothing that is demanded is impossible."""
        return not self.unmet and not any(report.impossible for report in self.agents)

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """Everything that is wrong, in sentences with numbers and names: physics, then each agent, then statements."""
        found = list(self.physics.reasons)
        for report in self.agents:
            found += report.violations
        found += [item.complaint for item in self.statements if not item.met]
        return tuple(found)

    def with_timing(self, timing: Mapping[str, Mapping[str, float]]) -> Report:
        """Return the same report with further stations' wall and CPU seconds in front of its own."""
        return replace(self, timing={**timing, **self.timing})

    def with_conflicts(self, lost_to: Mapping[int, str]) -> Report:
        """Return the same report with what unmet statements lost to, by their numbers."""
        told = (s if s.met else replace(s, lost_to=lost_to.get(s.number, "")) for s in self.statements)
        return replace(self, statements=tuple(told))

    def with_planner(self, planner: Mapping[str, Any]) -> Report:
        """Return the same report with who planned and what that took."""
        return replace(self, planner=planner)

    def with_stability(self, stability: Mapping[str, Any]) -> Report:
        """Return the same report with what a simulator found; the demands do not change."""
        return replace(self, stability=stability)

    def to_dict(self) -> dict[str, Any]:
        """Return the content of `report.json`: the keys of DESIGN section 8, then details."""
        return {
            **self.figures,
            "statements": [item.to_dict() for item in self.statements],
            "moved": [move.to_dict() for move in self.moved],
            "violations": list(self.violations),
            "timing": {name: dict(seconds) for name, seconds in self.timing.items()},
            "ok": self.ok,
            "metrics": {name: dict(figures) for name, figures in self.metrics.items()},
            "agents": {report.agent.name: report.to_dict() for report in self.agents},
            **({"planner": dict(self.planner)} if self.planner else {}),
            **({"stability": dict(self.stability)} if self.stability else {}),
        }

    def rows(self) -> tuple[tuple[str, str, bool], ...]:
        """Return a short table: what was checked, what came out, whether that is enough."""
        shown: list[tuple[str, str, bool]] = []
        for name, value in self.figures.items():
            text = ("yes" if value else "no") if isinstance(value, bool) else f"{value:.2f}"
            shown.append((name.removesuffix("_share").replace("_", " "), text, name not in self.unmet))
        return tuple(shown)

    def to_markdown(self) -> str:
        """Return the content of `report.md`: the table, what is wrong, and the way to each asset."""
        lines = [f"# {self.scene.name}: {'all demands met' if self.ok else 'not all demands are met'}", ""]
        lines += ["| check | result | |", "|---|---:|---|"]
        lines += [f"| {name} | {value} | {'ok' if met else '**short**'} |" for name, value, met in self.rows()]
        if self.violations:
            lines += ["", "## What is wrong", "", *(f"- {sentence}" for sentence in self.violations)]
        helps = [sentence for report in self.agents for sentence in report.remedies.sentences(report.agent)]
        if helps:
            lines += ["", "## What would help", "", *(f"- {sentence}" for sentence in helps)]
        if self.stability:
            lines += ["", "## In a simulator", "", *_stability(self.stability)]
        if self.moved:
            lines += ["", "## What was moved from its guess", "", *(f"- {move.sentence}" for move in self.moved)]
        for report in self.agents:
            lines += ["", f"## {report.agent.title or report.agent.name}", "", *_agent_table(report)]
        if self.planner:
            lines += ["", "## Who planned", "", *(f"- {sentence}" for sentence in self.planner.get("sentences", ()))]
        return "\n".join(lines) + "\n"

    def to_frame(self) -> Any:
        """Return a pandas DataFrame with one row per asset: pose, box, verdicts, and what each agent can do with it.

        Raises:
            MissingExtraError: pandas is not installed.
        """
        from robolayout.verify.frame import report_frame

        return report_frame(self)

    def to_html(self) -> str:
        """Return the short table and the first things that are wrong as HTML."""
        from robolayout._html import bullets, paragraph, table

        bodies = ", ".join(report.agent.title or report.agent.name for report in self.agents)
        verdict = "all demands met" if self.ok else "not all demands are met"
        rows = [[name, value, "ok" if met else "short"] for name, value, met in self.rows()]
        head = paragraph(f"{self.scene.name} for {bodies}: {verdict}")
        return head + table(["check", "result", ""], rows) + bullets(self.violations, SHOWN)

    def _repr_html_(self) -> str:
        return self.to_html()

    def __repr__(self) -> str:
        shown = ", ".join(f"{name} {value}" for name, value, _ in self.rows())
        return f"Report({'ok' if self.ok else f'{len(self.violations)} violations'}: {shown})"


def _stability(found: Mapping[str, Any]) -> list[str]:
    """Return what gravity did, in a sentence and one for each asset that did not stay."""
    head = f"After {found['seconds']:g} s of gravity, {found['stable_share']:.2f} of the assets stay where they are."
    return [head, *(f"- {sentence}" for sentence in found["violations"])]


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None


def _places(space: HeadingSpace) -> list[dict[str, Any]]:
    """Return a point of each place where the centre can be while the body turns right round, and the place's area."""
    points = [place.representative_point() for place in space.turning.geoms]
    return [{"point": [p.x, p.y], "area": g.area} for p, g in zip(points, space.turning.geoms, strict=True)]


def _usable(use: Use) -> str:
    """Return whether an asset can be used, and what has to be moved for it."""
    if not use.usable:
        return "**no**"
    return f"yes, {' and '.join(use.moved)} moved" if use.moved else "yes"


def _agent_table(report: AgentReport) -> list[str]:
    nav = report.navigation
    shown = [f"{name.removesuffix('_share').replace('_', ' ')} {value:.2f}" for name, value in report.figures.items()]
    lines = [f"{', '.join(shown)}."]
    if not nav.scene.room.doors:
        lines.append(f"The room has no door: {report.agent.name} starts in the largest free part of the floor.")
    largest, needed = report.remedies.largest_disc, 2 * report.agent.radius
    if largest > 0:
        more = " or more" if largest >= WIDE - 1e-9 else ""
        lines.append(
            f"The widest disc that reaches everything asked is {largest:.2f} m{more}; this body needs {needed:.2f} m."
        )
    if report.headings is not None:
        turns = len(report.headings.turning.geoms)
        lines.append(f"It can turn right round in {turns} {'place' if turns == 1 else 'places'}.")
    lines += ["", "| asset | reached | route | narrowest passage | between | usable |"]
    lines.append("|---|---|---:|---:|---|---|")
    for name, passage in nav.passages.items():
        route = nav.routes.get(name)
        length = f"{route.length:.1f} m" if route else "-"
        between = passage.sides or "-"
        reached = "yes" if nav.reached[name] else "**no**"
        usable = _usable(report.usage.uses[name])
        lines.append(f"| {name} | {reached} | {length} | {passage.shown} | {between} | {usable} |")
    if report.exempt:
        lines += ["", *(f"- not asked: {reason}." for reason in report.exempt.values())]
    return lines
