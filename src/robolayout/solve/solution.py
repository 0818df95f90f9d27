"""What the solver needs to know of the judge, an order on layouts and who is to blame, and what every solver returns.

The solver never measures its own success: the pipeline hands it a judge that is built on the exact verifier.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

from robolayout.scene import Layout, Snapshot, Trace

SPARE = 0.03
"""Access that may lack before it outweighs statements: the solver wants that much more free floor than the report demands."""

Progress = Callable[[str], None]
"""Told the name of each phase as it begins."""


def silent(_phase: str) -> None:
    """Tell nobody."""


@dataclass(frozen=True)
class Verdict:
    """What an exact check says of a layout."""

    hard: float  # violations of hard demands (collisions, boundary, support, doors), counted in assets
    # what the agents cannot get to or use, in assets (a door counts as one), plus the share of free space cut off
    access: float
    soft: float  # weight of unmet statements
    culprits: tuple[str, ...] = ()  # assets to move, the most pressing first
    # how far things are from the program's guess, which tells equal layouts apart (`Problem.moved`)
    moved: float = field(default=0.0, compare=False)

    @property
    def worth(self) -> tuple[float, float, float, float]:
        """The order of layouts, smaller is better: hard demands, access, statements; among equals, how little was moved."""
        return (self.hard, self.barred, self.soft + 2.0 * self.access, self.moved)

    @property
    def barred(self) -> float:
        """What the agents cannot get to or use, as far as it outweighs statements."""
        return self.access if self.access > SPARE else 0.0

    @property
    def broken(self) -> float:
        """Hard demands and access that are not met: what nothing else makes up for."""
        return self.hard + self.barred

    @property
    def merit(self) -> float:
        """Smaller is better: a hard violation outweighs everything, an asset out of reach two statements."""
        return 100.0 * self.hard + 2.0 * self.access + self.soft

    @property
    def promise(self) -> float:
        """Smaller is a better layout to go on from: a collision between two things is sooner mended than a blocked way."""
        return 4.0 * self.hard + 2.0 * self.access + self.soft

    @property
    def right(self) -> bool:
        """Whether no demand and no statement is missed: at most something stays shut that could not be opened."""
        return not self.broken and self.soft < 1.0

    @property
    def ok(self) -> bool:
        """Whether nothing is left to do."""
        return self.merit == 0.0


Enough = Callable[[Verdict], bool]
"""Says of a verdict to which more can only be added whether it is bad enough for nobody to want to know the rest."""


def never(_verdict: Verdict) -> bool:
    """Want to know all of it."""
    return False


class Judge(Protocol):
    """The exact verifier as an order on layouts."""

    def __call__(self, layout: Layout, enough: Enough = never, /) -> Verdict:
        """Judge a layout of what is placed so far; `enough` is asked between the parts, the cheap ones first, whether to stop."""
        ...


@dataclass(frozen=True)
class Solution:
    """What a solver found."""

    layout: Layout  # poses of all assets
    verdict: Verdict  # what the judge says of it
    phase: str = ""  # what made the winning layout: "guess", "push", "polish", ...; empty where a solver does not say
    trace: Trace = field(default_factory=Trace, repr=False)  # losses and poses on the way; empty unless asked for

    @property
    def status(self) -> str:
        """The verdict in a word: "solved", or "unmet" if demands are left."""
        return "solved" if self.verdict.ok else "unmet"

    @property
    def message(self) -> str:
        """The status as a sentence."""
        verdict = self.verdict
        parts = [f"{verdict.hard:g} hard violations"] * bool(verdict.hard)
        parts += [f"{verdict.access:.2f} of access missing"] * bool(verdict.access)
        parts += [f"statements of weight {verdict.soft:g} unmet"] * bool(verdict.soft)
        if not parts:
            return "Every demand and every statement is met."
        return f"Budget spent with {', '.join(parts)}; the report names them."


def snapshot(step: int, label: str, layout: Layout) -> Snapshot:
    """Return where everything is at a step of a phase."""
    return Snapshot(step, label, {name: (pose.x, pose.y, pose.yaw) for name, pose in layout.items()})
