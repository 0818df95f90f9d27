"""The report: what a layout achieves, in figures, verdicts and sentences (the definitions are DESIGN section 8)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from robolayout.scene import Agent, Layout, Scene
from robolayout.verify._boxes import share
from robolayout.verify.navigation import Navigation
from robolayout.verify.physics import Physics
from robolayout.verify.sentences import agent_violations
from robolayout.verify.use import Usage


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
        return agent_violations(self.navigation, self.usage)

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
            "unreached": {name: nav.distances[name] for name in nav.unreached},
            "unusable": {name: use.reason for name, use in self.usage.uses.items() if not use.usable},
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
    """

    scene: Scene
    layout: Layout
    physics: Physics
    agents: tuple[AgentReport, ...]
    statements: tuple[StatementResult, ...] = ()
    demands: Demands = Demands()
    timing: Mapping[str, Mapping[str, float]] = field(default_factory=dict[str, Mapping[str, float]])

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
    def unmet(self) -> tuple[str, ...]:
        """Names of the figures that fall short of what is demanded."""
        least = {name: 1.0 for name in self.figures} | {
            "walkable_ratio": self.demands.walkable_ratio,
            "statements_met_share": self.demands.statements_met_share,
        }
        return tuple(name for name, value in self.figures.items() if value < least[name])

    @property
    def ok(self) -> bool:
        """Whether every demand is met."""
        return not self.unmet

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """Everything that is wrong, in sentences with numbers and names: physics, then each agent, then statements."""
        found = list(self.physics.reasons)
        for report in self.agents:
            found += report.violations
        found += [f"{item.sentence} is not met: {item.text}." for item in self.statements if not item.met]
        return tuple(found)

    def with_timing(self, timing: Mapping[str, Mapping[str, float]]) -> Report:
        """Return the same report with further stations' wall and CPU seconds in front of its own."""
        return replace(self, timing={**timing, **self.timing})

    def to_dict(self) -> dict[str, Any]:
        """Return the content of `report.json`: the keys of DESIGN section 8, then details."""
        return {
            **self.figures,
            "statements": [vars(item) for item in self.statements],
            "violations": list(self.violations),
            "timing": {name: dict(seconds) for name, seconds in self.timing.items()},
            "ok": self.ok,
            "agents": {report.agent.name: report.to_dict() for report in self.agents},
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
        for report in self.agents:
            lines += ["", f"## {report.agent.title or report.agent.name}", "", *_agent_table(report)]
        return "\n".join(lines) + "\n"

    def __repr__(self) -> str:
        shown = ", ".join(f"{name} {value}" for name, value, _ in self.rows())
        return f"Report({'ok' if self.ok else f'{len(self.violations)} violations'}: {shown})"


def _agent_table(report: AgentReport) -> list[str]:
    nav = report.navigation
    lines = ["| asset | reached | route | narrowest passage | between | usable |", "|---|---|---:|---:|---|---|"]
    for name, passage in nav.passages.items():
        route = nav.routes.get(name)
        length = f"{route.length:.1f} m" if route else "-"
        between = " and ".join(passage.between) or "-"
        reached = "yes" if nav.reached[name] else "**no**"
        usable = "yes" if report.usage.usable[name] else "**no**"
        lines.append(f"| {name} | {reached} | {length} | {passage.shown} | {between} | {usable} |")
    return lines
