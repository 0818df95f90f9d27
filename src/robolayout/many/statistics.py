"""How sure a mean is, and whether one set of rooms is better than another: no assumption about how figures are spread."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

RESAMPLES = 2000
"""Sets drawn with replacement from the rooms."""

SURE = 0.95
"""Share of those sets whose means lie within the interval that is told."""


@dataclass(frozen=True)
class Mean:
    """The mean of a figure over rooms.

    Attributes:
        count: Rooms that have the figure.
        mean: Its mean.
        low: Lower end of the interval.
        high: Upper end.
    """

    count: int
    mean: float
    low: float
    high: float


def means(table: NDArray[np.float64], seed: int = 0) -> list[Mean]:
    """Return the mean of each column with its interval, by percentiles of the bootstrap; rooms are drawn whole.

    Args:
        table: (rooms, figures); NaN where a room lacks a figure.
        seed: Settles which rooms are drawn.
    """
    rng = np.random.default_rng(seed)
    there = ~np.isnan(table)
    values = np.where(there, table, 0.0)
    drawn = np.full((RESAMPLES, table.shape[1]), np.nan)
    for turn in range(RESAMPLES):
        times = np.bincount(rng.integers(0, len(table), len(table)), minlength=len(table)).astype(float)
        count = times @ there
        drawn[turn] = np.divide(times @ values, count, out=np.full(len(count), np.nan), where=count > 0)
    found: list[Mean] = []
    for column in range(table.shape[1]):
        count = int(there[:, column].sum())
        if not count:
            found.append(Mean(0, math.nan, math.nan, math.nan))
            continue
        low, high = np.nanpercentile(drawn[:, column], [50 * (1 - SURE), 50 * (1 + SURE)])
        found.append(Mean(count, float(values[:, column].sum() / count), float(low), float(high)))
    return found


def sign_test(better: int, worse: int) -> float:
    """Return the probability that, of so many rooms that differ, the better ones are so few or so many by chance.

    Twice the smaller tail of the binomial distribution with p = 1/2, at most 1; rooms that are equal do not count.
    """
    count = better + worse
    tail = sum(math.comb(count, k) for k in range(min(better, worse) + 1)) / 2**count
    return min(1.0, 2.0 * tail)
