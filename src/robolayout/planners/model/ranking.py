"""Which of several sampled programs is the best: what the judge measured first, agreement among the samples last.

Self-consistent decoding: n programs are drawn for the same question, all are solved and verified, and one is kept. Three samples
that collide less than a fourth come first whatever they say; among equals, the one whose statements the others make too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from robolayout.program import Program

HARD = ("placed_share", "collision_free_share", "in_boundary_share", "supported_share", "door_clear")
ACCESS = ("doors_reached", "reachable_share_chairs_aside", "usable_share")
WALKABLE = 0.95  # walkable ratio that a report demands (DESIGN section 8); more than that is no merit
STEP = 1e-4  # differences between shares below this do not count


@dataclass(frozen=True)
class SampleScore:
    """What one sample achieves, to be compared from the first figure to the last."""

    hard: float  # mean of the hard demands, 0 to 1
    access: float  # mean of what the agent reaches, uses and can walk (as far as that is demanded), 0 to 1
    statements: float  # share of statements met
    agreement: float  # mean overlap of its statements with those of the other samples

    @property
    def key(self) -> tuple[int, int, int, int]:
        """The figures in whole steps, so that rounding decides nothing."""
        hard, access, statements, agreed = (round(value / STEP) for value in vars(self).values())
        return hard, access, statements, agreed

    def to_dict(self) -> dict[str, float]:
        """Return the score as it is written beside the samples."""
        return {name: round(value, 4) for name, value in vars(self).items()}


def score_samples(
    figures: Sequence[Mapping[str, float | bool]], programs: Sequence[Program]
) -> tuple[SampleScore, ...]:
    """Return one score per sample, of its `Report.figures` and its program as asked."""
    return tuple(
        SampleScore(_mean(row, HARD), _access(row), float(row["statements_met_share"]), shared)
        for row, shared in zip(figures, agreement(programs), strict=True)
    )


def agreement(programs: Sequence[Program]) -> tuple[float, ...]:
    """Return for each program the mean share of statements that it has in common with the others; 1 for a single one.

    Two statements are the same when relation and things are, whatever their numbers: 1.0 m and 1.2 m are one opinion.
    """
    said = [{(one.relation.name, *map(str, one.relation.refs())) for one in program.statements} for program in programs]
    if len(said) < 2:
        return (1.0,) * len(said)
    return tuple(
        sum(_overlap(mine, other) for j, other in enumerate(said) if j != i) / (len(said) - 1)
        for i, mine in enumerate(said)
    )


def _overlap(a: set[tuple[str, ...]], b: set[tuple[str, ...]]) -> float:
    return len(a & b) / len(a | b) if a | b else 1.0


def _access(row: Mapping[str, float | bool]) -> float:
    walkable = min(1.0, float(row["walkable_ratio"]) / WALKABLE)
    return (len(ACCESS) * _mean(row, ACCESS) + walkable) / (len(ACCESS) + 1)


def _mean(row: Mapping[str, float | bool], names: Sequence[str]) -> float:
    return sum(float(row[name]) for name in names) / len(names)
