"""The exact verifier as an order on layouts, handed to the solver."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass, field, replace

from robolayout.constraints import Outcome, Relation
from robolayout.program import Program
from robolayout.scene import Layout, Pose, Scene
from robolayout.solve import Enough, Judge, Verdict, never
from robolayout.verify import AgentReport, Navigation, judge_agent, kept_out, physics


@dataclass(frozen=True)
class WorthConfig:
    """What layouts are chosen by."""

    # share of the free space that the solver wants connected to the door; the report demands 0.95
    walkable: float = 0.98
    shut: float = 0.25  # weight of a door or drawer of a usable thing that no place lets a body open, in statements


WORTH = WorthConfig()


def make_judge(scene: Scene, program: Program) -> Judge:
    """Return the exact verifier as an order on (partial) layouts: what is not placed yet is not counted."""
    statements = [_Asked(s.relation, frozenset(s.relation.asset_names())) for s in program.statements]
    bodies = [agent for agent in scene.agents if not kept_out(scene, agent)]
    suspects = set[str]()  # what could not be used lately: looked at first

    def judge(layout: Layout, enough: Enough = never, /) -> Verdict:
        placed = set(layout)
        failing = [name for name in physics(scene, layout).failing if name in placed]
        found = Verdict(float(len(failing)), 0.0, 0.0, tuple(failing))
        if enough(found):
            return found
        soft, unmet = 0.0, list[str]()
        for asked in statements:
            if asked.names <= placed and not (outcome := asked.outcome(scene, layout)).met:
                soft += float(getattr(asked.relation, "weight", 1.0))
                unmet += (*asked.relation.asset_names(), *outcome.blamed)
        access, blamed = 0.0, list[str]()
        for agent in bodies:
            if enough(replace(found, access=access, soft=soft)):
                break
            report, fixable = judge_agent(scene, layout, agent), list[str]()
            for usable in _used(report, suspects):
                fixable = _fixable(report, usable, layout)
                suspects.update(fixable)
                if enough(replace(found, access=access + _missing(report, fixable), soft=soft)):
                    break
            else:
                holds = () if program.mends else report.usage.holds
                shut = [hold.asset for hold in holds if not hold.poses]
                soft += WORTH.shut * len(shut)
                blamed += _blamed(report, [*fixable, *dict.fromkeys(shut)])
            access += _missing(report, fixable)
        return Verdict(found.hard, access, soft, tuple(dict.fromkeys([*failing, *blamed, *unmet])))

    return judge


class _Read(dict[str, Pose]):
    """The poses of a layout, and which of them somebody looked at; None where there was none."""

    def __init__(self, poses: Mapping[str, Pose]) -> None:
        super().__init__(poses)
        self.read = dict[str, Pose | None]()

    def __getitem__(self, name: str) -> Pose:
        self.read[name] = self.get(name)
        return super().__getitem__(name)


@dataclass
class _Asked:
    """One statement; it is measured again only where a pose that it looked at has changed."""

    relation: Relation
    names: frozenset[str]
    _read: dict[str, Pose | None] = field(default_factory=dict[str, Pose | None])
    _outcome: Outcome | None = None

    def outcome(self, scene: Scene, layout: Layout) -> Outcome:
        if self._outcome is None or any(layout.get(name) != pose for name, pose in self._read.items()):
            seen = _Read(layout.poses)
            self._outcome, self._read = self.relation.check(scene, Layout(seen)), seen.read
        return self._outcome


def _used(found: AgentReport, suspects: Container[str]) -> Iterator[Mapping[str, bool]]:
    """Yield what a body uses: all, less what it has no place to use, then what it does not get to, then each that it cannot open.

    Each is dearer to find out than the one before.
    """
    yield dict.fromkeys(found.navigation.reached, True)
    yield found.usage.standing
    yield found.usage.got_to
    yield from found.usage.narrowed(suspects)


def _fixable(found: AgentReport, usable: Mapping[str, bool], layout: Layout) -> list[str]:
    """Return what an agent cannot get to or use, if it uses these, and might in another place."""
    reached = found.navigation.reached
    short = [name for name in found.lacking(usable) if name in layout]
    return [name for name in short if not reached[name] or not found.usage.too_high(name)]


def _missing(found: AgentReport, fixable: list[str]) -> float:
    """Return how much an agent cannot get to or use, in assets; a door counts as one."""
    nav = found.navigation
    unreached = sum(not nav.reached[name] for name in fixable)
    return unreached + 0.5 * (len(fixable) - unreached) + _cut_off(nav) + len(nav.shut_doors)


def _cut_off(nav: Navigation) -> float:
    """Return the share of free floor that an agent does not get to, as far as it matters."""
    return max(0.0, WORTH.walkable - nav.walkable_ratio) if nav.free.area > 0 else 0.0


def _blamed(found: AgentReport, names: list[str]) -> Iterator[str]:
    """Yield which assets to move for an agent that cannot use some."""
    nav = found.navigation
    yield from names
    yield from (other for name in names for other in found.usage.shutting(name))
    yield from nav.dividing if _cut_off(nav) else ()
    yield from (name for door in nav.shut_doors for name in nav.shutting(door))
