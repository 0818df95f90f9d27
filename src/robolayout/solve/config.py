"""The constants of the default search, one small frozen record per concern."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import astuple, dataclass, replace

from robolayout._errors import among


@dataclass(frozen=True)
class Weights:
    """Factors of the hard terms against a statement of weight 1."""

    overlap: float = 60.0  # no overlap: factor on p^2 + 0.02 p, p the penetration in metres plus margin
    inside: float = 60.0  # inside the room: factor on d^2 + 0.02 d, d metres outside
    clear: float = 60.0  # door landings and strips to keep clear: as overlap
    routes: float = 60.0  # routes: factor on d^2 + 0.02 d, d metres short of the clearance
    hinge: float = 0.02  # linear part of the hard terms in metres, so that small violations still have a slope
    margin: float = 0.015  # metres that things are kept apart beyond touching (DESIGN section 6)
    saturation: float = 1.0  # residual of a statement, in metres, at which its pull has fallen to half


@dataclass(frozen=True)
class SearchConfig:
    """One phase of gradient search."""

    steps: int
    rate: float  # first step size of positions (metres) and headings
    final_rate: float  # last step size


@dataclass(frozen=True)
class Effort:
    """How long the search goes on, as counts: never a clock. Whatever ends it, the best layout so far is returned."""

    layouts: int = 1500  # layouts that the judge looks at in one stage before no further phase or round begins
    stale: int = 160  # the same without a better one: the room is as right as it will be
    # share of what a stage moves that is out of place or out of reach after polishing, and metres that this moved each of them plus the
    # share of statements that it leaves unmet, above both of which the guess is worth nothing: else a way that is blocked is opened
    # first. Measured: guesses at random 0.8 to 1.5, rough ones of which as much is out of reach 0.3 to 0.5
    lost: tuple[float, float] = (0.6, 0.8)
    # the same share once the ways are opened, and share of the statements that do not hold after mending; of whole rooms the share
    # from which on a search does not mend for long, which only pays for the best of several
    blind: float = 0.25
    # hard demands and access that a room which is built lacks, up to which what is to blame is mended before gradients move the rest
    few: float = 3.0
    nearby: int = 30  # things that are tried elsewhere near their guess, at most; none leaves it out
    # of the tries of one thing, so many are judged as they are; at most four of them are polished, too
    looked_at: int = 6
    put_back: int = 64  # layouts judged while groups of moved things are put back to their guesses, at most
    built: int = 2  # batches of starts that are built one thing after the other
    # promise of a built start up to which single things in it are placed anew before it is polished
    nearly: float = 3.0
    # most layouts with one thing built anew that are judged in a row, before it goes on at the end as long as that gains something;
    # none leaves it out
    mendings: int = 32
    anywhere: int = 16  # the same at the end for statements of a guess that is kept, which no place near it meets

    def hopeless(self, broken: float, things: int) -> bool:
        """Return whether of so many things too much is out of place or out of reach to be mended soon (`Verdict.broken`)."""
        return broken > self.blind * things

    def at_most(self, other: Effort) -> Effort:
        """Return the lesser of each number of two schedules."""
        return Effort(*map(min, zip(astuple(self), astuple(other), strict=True)))


EFFORTS: Mapping[str, Effort] = {
    "quick": Effort(300, 40, nearby=8, looked_at=4, put_back=32, built=1, mendings=8, anywhere=4),
    "normal": Effort(),
    "thorough": Effort(6000, 640, nearby=90, looked_at=8, put_back=128, built=6, nearly=6.0, mendings=96, anywhere=32),
}
"""The schedules by name."""


@dataclass(frozen=True)
class SolverConfig:
    """The default search."""

    # starts, where polishing the guess is not enough: a quarter of them in each batch that is built; none leaves out building
    starts: int = 16
    kept: int = 8  # how many go on to routes
    polish: SearchConfig = SearchConfig(steps=140, rate=0.02, final_rate=0.0005)  # of starts that are near a solution
    reroute: SearchConfig = SearchConfig(steps=120, rate=0.03, final_rate=0.001)  # after each planning of routes
    # most rounds of planning routes and moving furniture out of their way; none leaves out all routes
    route_rounds: int = 3
    cell: float = 0.05  # metres per cell of the grid on which routes are planned
    effort: Effort = Effort()
    weights: Weights = Weights()
    trace: bool = False  # whether to record poses and losses for the animation

    def at(self, effort: str) -> SolverConfig:
        """Return the same search with the schedule of that name: "quick", "normal" or "thorough".

        Raises:
            UnknownNameError: There is no schedule of that name.
        """
        among("effort", [effort], EFFORTS)
        return replace(self, effort=EFFORTS[effort])
