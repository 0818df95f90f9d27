"""What differs between two layouts: what moved, turned, came and went, and what became better or worse."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from robolayout.render import PlanMarks
from robolayout.run.result import Result
from robolayout.scene import Asset, Pose
from robolayout.verify import Report


@dataclass(frozen=True)
class DiffConfig:
    """From when on something counts as changed."""

    moved: float = 0.001  # metres from which on a thing counts as moved: files round to less
    turned: float = 0.1  # degrees from which on it counts as turned
    changed: float = 1e-4  # difference of a figure from which on it counts as changed


DIFF = DiffConfig()


@dataclass(frozen=True)
class Change:
    """One thing that differs."""

    kind: str  # "thing", "figure", "violation" or "statement"
    name: str  # of the asset or the figure; of a violation or statement its sentence
    verdict: str  # "better", "worse", or nothing where it is neither
    text: str  # what differs, in words
    metres: float = 0.0  # how far a thing moved
    degrees: float = 0.0  # how far it turned, at most 180


@dataclass(frozen=True)
class Difference:
    """What differs between two layouts."""

    before: Result  # the first one
    after: Result  # the second one
    # things, the farthest moved first; then figures, violations and statements, the worse ones first
    changes: tuple[Change, ...]

    @property
    def worse(self) -> tuple[Change, ...]:
        """What became worse."""
        return tuple(change for change in self.changes if change.verdict == "worse")

    def to_dict(self) -> dict[str, Any]:
        """Return plain data: all changes, and whether anything became worse."""
        return {"worse": bool(self.worse), "changes": [vars(change) for change in self.changes]}

    def marks(self) -> PlanMarks:
        """Return, as shapes for the plan of the second layout, where its things stood in the first one."""
        (old, old_sizes), (new, new_sizes) = ((one.layout, one.scene.by_name) for one in (self.before, self.after))
        changed = {change.name for change in self.changes if change.kind == "thing"}
        kept = [name for name in new if name in old and name in changed]
        return PlanMarks(
            ghosts=tuple(old[name].corners(old_sizes[name].size) for name in kept),
            arrows=tuple((old[n].at, new[n].at) for n in kept if _metres(old[n], new[n]) >= DIFF.moved),
            added=tuple(new[name].corners(new_sizes[name].size) for name in new if name not in old),
            gone=tuple(old[name].corners(old_sizes[name].size) for name in old if name not in new),
        )


def diff(before: Result, after: Result) -> Difference:
    """Return what differs between two layouts, each with its report, from `generate` or `judge`; their scenes may differ."""
    things = sorted(_things(before, after), key=lambda change: (-change.metres, -change.degrees))
    judged = [*_figures(before.report, after.report), *_violations(before.report, after.report)]
    judged += _statements(before.report, after.report)
    judged.sort(key=lambda change: ("worse", "better", "").index(change.verdict))
    return Difference(before, after, (*things, *judged))


def _things(before: Result, after: Result) -> Iterator[Change]:
    """Yield what happened to each thing; what came or went last, since it went no distance."""
    old, new = before.layout, after.layout
    for name in dict.fromkeys([*(a.name for a in after.scene.assets), *(a.name for a in before.scene.assets)]):
        if name in old and name in new:
            yield from _moved(before.scene.by_name[name], after.scene.by_name[name], old[name], new[name])
        elif name in new:
            yield Change("thing", name, "", "came")
        elif name in old:
            yield Change("thing", name, "", "went")


def _moved(old: Asset, new: Asset, start: Pose, end: Pose) -> Iterator[Change]:
    """Yield how far a thing moved and turned and whether it has another size, if any of that is so."""
    metres = _metres(start, end)
    turn = math.degrees(end.yaw - start.yaw) % 360.0
    degrees = min(turn, 360.0 - turn)
    parts = [f"moved {metres:.2f} m"] if metres >= DIFF.moved else []
    parts += [f"turned {degrees:.0f} degrees"] if degrees >= DIFF.turned else []
    if math.dist(old.size, new.size) >= DIFF.moved:
        sizes = (" x ".join(f"{length:.2f}" for length in size) for size in (old.size, new.size))
        parts.append("is {1} m instead of {0} m".format(*sizes))
    if parts:
        shift, turn = metres * (metres >= DIFF.moved), degrees * (degrees >= DIFF.turned)
        yield Change("thing", new.name, "", ", ".join(parts), shift, turn)


def _metres(start: Pose, end: Pose) -> float:
    return math.dist((start.x, start.y, start.z), (end.x, end.y, end.z))


def _figures(before: Report, after: Report) -> Iterator[Change]:
    """Yield the figures of the reports that differ."""
    old_text, new_text = (dict(zip(r.figures, (row[1] for row in r.rows()), strict=True)) for r in (before, after))
    for name, value in after.figures.items():
        gain = float(value) - float(before.figures.get(name, value))
        if abs(gain) >= DIFF.changed:
            verdict = "better" if gain > 0 else "worse"
            words = name.removesuffix("_share").replace("_", " ")
            yield Change("figure", words, verdict, f"{old_text[name]} -> {new_text[name]}")


def _violations(before: Report, after: Report) -> Iterator[Change]:
    """Yield violations that came, went, or have other figures now."""
    old, new = _sentences(before), _sentences(after)
    for key, text in new.items():
        if key not in old:
            yield Change("violation", text, "worse", "is new")
        elif old[key] != text:
            yield Change("violation", text, "", f"was: {old[key]}")
    for key, text in old.items():
        if key not in new:
            yield Change("violation", text, "better", "is gone")


def _sentences(report: Report) -> Mapping[str, str]:
    """Return what is wrong besides statements, each sentence under itself without its decimal figures."""
    stated = {item.complaint for item in report.statements}
    return {without_figures(text): text for text in report.violations if text not in stated}


def without_figures(sentence: str) -> str:
    """Return a sentence of the judge without its decimal figures: the same complaint measured anew is the same."""
    return re.sub(r"\d+\.\d+", "#", sentence)


def _statements(before: Report, after: Report) -> Iterator[Change]:
    """Yield statements of both programs that are met in one layout only."""
    old = {item.sentence: item for item in before.statements}
    for item in after.statements:
        if item.sentence in old and old[item.sentence].met != item.met:
            verdict, met = ("better", "met now") if item.met else ("worse", "not met any more")
            yield Change("statement", item.sentence, verdict, f"{met}: {item.text}")
