"""`verify` judges a finished layout, whoever made it; the report says what that achieves (the definitions are DESIGN section 8)."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from robolayout._errors import MissingExtraError
from robolayout.constraints import Outcome
from robolayout.scene import Agent, Asset, Layout, Scene, layout_digest, load_agents, scene_digest
from robolayout.verify._boxes import share
from robolayout.verify.agent_report import AgentReport, finite, judge_agent
from robolayout.verify.limits import Demands
from robolayout.verify.metrics import published_metrics
from robolayout.verify.moves import Move, moves
from robolayout.verify.physics import CHECKS, Physics, physics
from robolayout.verify.present import html, label, markdown, shown
from robolayout.verify.rules import RuleResult, rule_results
from robolayout.words import AskedRow, share_met

if TYPE_CHECKING:
    from robolayout.program import Program, Statement


AgentSpec = Agent | str | Path | Mapping[str, Any]

TOLD_ONLY = ("reachable_share", "collision_free_boxes_share")  # figures of which nothing is demanded


@dataclass(frozen=True)
class StatementResult:
    """One statement of the program, as asked, measured in the layout."""

    number: int  # its number in the program
    line: int  # line of the program text
    source: str  # its program text
    sentence: str  # what it says
    met: bool  # the verdict
    value: float  # the measured figure; NaN if an asset is unplaced
    limit: float  # what the figure is compared with
    unit: str  # unit of both
    text: str  # the measurement in words
    lost_to: str = ""  # where it is not met: what meeting it would break, in words; empty if nobody looked
    by: str = "plan"  # who asks for it: "user" or "plan"

    @property
    def complaint(self) -> str:
        """What is wrong, in a sentence; empty where it is met."""
        lost = f"; it lost to {self.lost_to}" if self.lost_to else ""
        return "" if self.met else f"{self.sentence} is not met: {self.text}{lost}."

    def to_dict(self) -> dict[str, Any]:
        """Return plain data; figures that do not exist are None."""
        return vars(self) | {"value": finite(self.value), "limit": finite(self.limit)}


@dataclass(frozen=True, eq=False)
class Report:
    """What a layout achieves; routes, passages and published metrics are computed when first asked for."""

    scene: Scene
    layout: Layout
    physics: Physics  # the physical checks
    agents: tuple[AgentReport, ...]  # one report per agent; top-level figures are the worst over agents
    statements: tuple[StatementResult, ...] = ()  # every statement as asked
    demands: Demands = field(default_factory=Demands)  # what `ok` asks for
    # wall and CPU seconds per station
    timing: Mapping[str, Mapping[str, float]] = field(default_factory=dict[str, Mapping[str, float]])
    # who planned and what that took, where that was a model
    planner: Mapping[str, Any] = field(default_factory=dict[str, Any])
    # what a simulator found (`robolayout.export.settle`), as plain data; empty if none was asked
    stability: Mapping[str, Any] = field(default_factory=dict[str, Any])
    # What a model thinks of the room, as plain data; empty if none was asked. It changes no verdict.
    opinion: Mapping[str, Any] = field(default_factory=dict[str, Any])
    # the ledger: one row for each phrase of the user's words; empty where nobody looked
    asked: tuple[AskedRow, ...] = ()
    notes: tuple[str, ...] = ()  # what else a reader should know of how the layout was found, in sentences
    program: Program | None = None  # the program as asked, with its guesses

    @cached_property
    def moved(self) -> tuple[Move, ...]:
        """What is not where the program put it, how far it went, and what it would violate there; the farthest first."""
        return moves(self.scene, self.layout, self.program, tuple(report.agent for report in self.agents))

    @cached_property
    def wishes(self) -> tuple[dict[str, Any], ...]:
        """What the program would like, and no more: each wish with its weight, whether it holds, and what was measured."""
        rows: list[dict[str, Any]] = []
        for wish in self.program.wishes if self.program else ():
            relation = wish.relation
            placed = set(relation.asset_names()) <= set(self.layout)
            outcome = relation.check(self.scene, self.layout) if placed else None
            holds, text = (outcome.met, outcome.text) if outcome else (False, "not placed")
            rows.append({"sentence": relation.sentence(), "weight": wish.wish, "holds": holds, "text": text})
        return tuple(rows)

    @cached_property
    def figures(self) -> dict[str, float | bool]:
        """The figures of DESIGN section 8, by name, in its order."""
        shares, bodies = self.physics.shares, [report.figures for report in self.agents]
        return {
            "placed_share": shares["placed_share"],
            "collision_free_share": shares["collision_free_share"],
            "collision_free_scene": shares["collision_free_share"] == 1.0,
            "collision_free_boxes_share": share(list(self.physics.boxes_apart.values())),
            "in_boundary_share": shares["in_boundary_share"],
            "supported_share": shares["supported_share"],
            "door_clear": self.physics.door_clear,
            "doors_reached": all(report.doors_reached for report in self.agents),
            **{name: min(figures[name] for figures in bodies) for name in bodies[0]},
            "statements_met_share": share([item.met for item in self.statements]),
            **({"stable_share": float(self.stability["stable_share"])} if self.stability else {}),
        }

    @cached_property
    def dressing(self) -> dict[str, Any]:
        """How many small things lie about, and how many of them each body can fetch; empty where none do."""
        lying = [asset.name for asset in self.scene.assets if asset.lies_about and asset.name in self.layout]
        fetched = {body.agent.name: sum(body.usage.usable[name] for name in lying) for body in self.agents}
        return {"things": len(lying), "fetched": fetched} if lying else {}

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
    def rules(self) -> tuple[RuleResult, ...]:
        """Named rules of accessibility for the bodies that they concern; they do not change `ok`."""
        return tuple(result for report in self.agents for result in rule_results(report))

    @cached_property
    def unmet(self) -> tuple[str, ...]:
        """Names of the figures that fall short of what is demanded; exempt assets are not demanded of an agent."""
        least = dict.fromkeys(self.figures, 1.0) | vars(self.demands) | dict.fromkeys(TOLD_ONLY, 0.0)
        if not any(report.short for report in self.agents):
            least |= {"reachable_share_chairs_aside": 0.0, "usable_share": 0.0}
        return tuple(name for name, value in self.figures.items() if value < least[name])

    @property
    def ok(self) -> bool:
        """Whether every demand is met and nothing that is demanded is impossible."""
        wished = all(row.verdict != "unmet" for row in self.asked)
        return wished and not self.unmet and not any(report.impossible for report in self.agents)

    @property
    def asked_met_share(self) -> float:
        """Share of the understood phrases of the user that are met; 1 where there are none."""
        return share_met(self.asked)

    @property
    def verdict(self) -> str:
        """Whether all demands are met, and how many statements are unmet and phrases not judged beside that, in a few words."""
        told = "all demands met" if self.ok else "not all demands are met"
        unmet = sum(not one.met for one in self.statements)
        told += f", {unmet} of {len(self.statements)} statements unmet" if unmet and self.ok else ""
        for kind in ("not understood", "not judged"):
            count = sum(row.verdict == kind for row in self.asked)
            told += f", {count} {'phrase' if count == 1 else 'phrases'} {kind}" if count else ""
        return told

    @property
    def not_understood(self) -> str:
        """What was not understood, in one line; empty if everything was."""
        words = dict.fromkeys(row.words for row in self.asked if row.verdict == "not understood")
        return f"Not understood: {', '.join(words)}." if words else ""

    @cached_property
    def violations(self) -> tuple[str, ...]:
        """Everything that is wrong, in sentences with numbers and names: physics, each agent, statements, gravity."""
        found = list(self.physics.reasons)
        for report in self.agents:
            found += report.violations
        found += [item.complaint for item in self.statements if not item.met]
        found += self.stability.get("violations", ())
        found += [f"asked, and not met: {row.words} ({row.value})." for row in self.asked if row.verdict == "unmet"]
        return tuple(found)

    def with_timing(self, timing: Mapping[str, Mapping[str, float]]) -> Report:
        """Return the same report with further stations' wall and CPU seconds in front of its own."""
        return replace(self, timing={**timing, **self.timing})

    def with_conflicts(self, lost_to: Mapping[int, str]) -> Report:
        """Return the same report with what unmet statements lost to, by their numbers."""
        told = (s if s.met else replace(s, lost_to=lost_to.get(s.number, "")) for s in self.statements)
        return replace(self, statements=tuple(told))

    def with_notes(self, notes: tuple[str, ...]) -> Report:
        """Return the same report with what else a reader should know."""
        return replace(self, notes=(*self.notes, *notes))

    def to_dict(self) -> dict[str, Any]:
        """Return the content of `report.json`: the keys of DESIGN section 8, then details."""
        return {
            "asked": [row.to_dict() for row in self.asked],
            "asked_met_share": self.asked_met_share,
            **self.figures,
            "statements": [item.to_dict() for item in self.statements],
            "wishes": list(self.wishes),
            "moved": [move.to_dict() for move in self.moved],
            "rules": [result.to_dict() for result in self.rules],
            "violations": list(self.violations),
            "timing": {name: dict(seconds) for name, seconds in self.timing.items()},
            "hashes": {"scene": scene_digest(self.scene), "layout": layout_digest(self.layout)},
            "ok": self.ok,
            "metrics": {name: dict(figures) for name, figures in self.metrics.items()},
            "agents": {report.agent.name: report.to_dict() for report in self.agents},
            **({"dressing": self.dressing} if self.dressing else {}),
            **({"notes": list(self.notes)} if self.notes else {}),
            **({"planner": dict(self.planner)} if self.planner else {}),
            **({"stability": dict(self.stability)} if self.stability else {}),
            **({"opinion": dict(self.opinion)} if self.opinion else {}),
        }

    def rows(self) -> tuple[tuple[str, str, bool | None], ...]:
        """Return a short table: what was checked, what came out, whether that is enough; None where nothing is demanded."""
        texts = {n: ("yes" if v else "no") if isinstance(v, bool) else shown(v) for n, v in self.figures.items()}
        verdicts = {name: None if name in TOLD_ONLY else name not in self.unmet for name in texts}
        return tuple((label(name), text, verdicts[name]) for name, text in texts.items())

    def to_markdown(self) -> str:
        """Return the content of `report.md`: the table, what is wrong, and the way to each asset."""
        return markdown(self)

    def to_frame(self) -> Any:
        """Return a pandas DataFrame with one row per asset: pose, box, verdicts, and what each agent can do with it."""
        if find_spec("pandas") is None:
            raise MissingExtraError("to_frame()", "pandas", package=True)
        pandas: Any = import_module("pandas")
        assets = self.scene.assets
        rows = [dict(_cells(self, asset)) for asset in assets]
        return pandas.DataFrame(rows, index=pandas.Index([asset.name for asset in assets], name="asset"))

    def to_html(self) -> str:
        """Return the short table and the first things that are wrong as HTML."""
        return html(self)

    def _repr_html_(self) -> str:
        return self.to_html()

    def __repr__(self) -> str:
        shown = ", ".join(f"{name} {value}" for name, value, _ in self.rows())
        return f"Report({'ok' if self.ok else f'{len(self.violations)} violations'}: {shown})"


def _cells(report: Report, asset: Asset) -> Iterator[tuple[str, object]]:
    """Yield the cells of an asset by column: metres and degrees, NaN where there is nothing."""
    name, pose = asset.name, report.layout.get(asset.name)
    place = (math.nan,) * 4 if pose is None else (pose.x, pose.y, pose.z, math.degrees(pose.yaw) % 360.0)
    yield from zip(("x", "y", "z", "yaw"), place, strict=True)
    yield from zip(("depth", "width", "height"), asset.size, strict=True)
    yield from ((check, getattr(report.physics, check)[name]) for check in CHECKS)
    for found in report.agents:
        mark = f"{found.agent.name}: " if len(report.agents) > 1 else ""
        nav = found.navigation
        yield f"{mark}reached", nav.reached[name]
        yield f"{mark}usable", found.usage.usable[name]
        yield f"{mark}route", nav.routes[name].length if name in nav.routes else math.nan
        yield f"{mark}passage", nav.passages[name].width if name in nav.passages else math.nan


def verify(
    scene: Scene,
    layout: Layout,
    program: Program | None = None,
    *,
    agent: AgentSpec | Iterable[AgentSpec] | None = None,
    demands: Demands | None = None,
) -> Report:
    """Judge a layout: physics, navigation and use for each agent, and every statement as asked.

    Args:
        scene: What was given.
        layout: Poses; assets without one, or with one that is no number, fail every share.
        program: The statements as asked; None leaves semantics out.
        agent: One body or several: an `Agent`, names of profiles ("wheelchair,child_6"), a file, a mapping as in a
            scene file, or a list of those; the scene's own if None.
        demands: What the layout must achieve for `Report.ok`.
    """
    wall, cpu = time.perf_counter(), time.process_time()
    layout = Layout({name: pose for name, pose in layout.items() if pose.is_finite})
    demands, bodies = demands or Demands(), scene.agents if agent is None else load_agents(agent)
    reports = tuple(judge_agent(scene, layout, body, demands) for body in bodies)
    statements = () if program is None else tuple(_measure(scene, layout, s) for s in program.statements)
    judged = physics(scene, layout)
    timing = {"verify": {"wall": time.perf_counter() - wall, "cpu": time.process_time() - cpu}}
    return Report(scene, layout, judged, reports, statements, demands, timing, program=program)


def _measure(scene: Scene, layout: Layout, statement: Statement) -> StatementResult:
    """Measure one statement; it fails if one of its assets is unplaced."""
    relation = statement.relation
    missing = [name for name in relation.asset_names() if name not in layout]
    unplaced = Outcome(False, math.nan, math.nan, "", f"{' and '.join(missing)} not placed")
    found = unplaced if missing else relation.check(scene, layout)
    said = (statement.number, statement.line, statement.source, relation.sentence())
    return StatementResult(*said, found.met, found.value, found.limit, found.unit, found.text, by=statement.by)
