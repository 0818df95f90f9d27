"""How sure a mean is, and whether one set of rooms is better than another: no assumption about how figures are spread."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

RESAMPLES = 2000  # sets drawn with replacement from the rooms
SURE = 0.95  # share of those sets whose means lie within the interval that is told


@dataclass(frozen=True)
class Mean:
    """The mean of a figure over rooms."""

    count: int  # rooms that have the figure
    mean: float
    low: float  # lower end of the interval
    high: float  # upper end


def mean(values: NDArray[np.float64], seed: int = 0) -> Mean:
    """Return the mean of a figure (NaN where a room lacks it) with its interval, by percentiles of the bootstrap."""
    found = values[~np.isnan(values)]
    if found.size == 0:
        return Mean(0, math.nan, math.nan, math.nan)
    rng = np.random.default_rng(seed)
    drawn = [found[rng.integers(0, found.size, found.size)].mean() for _ in range(RESAMPLES)]
    low, high = np.percentile(drawn, [50 * (1 - SURE), 50 * (1 + SURE)])
    return Mean(found.size, float(found.mean()), float(low), float(high))


def sign_test(better: int, worse: int) -> float:
    """Return the probability that, of so many rooms that differ, the better ones are so few or so many by chance.

    Twice the smaller tail of the binomial distribution with p = 1/2, at most 1; rooms that are equal do not count.
    """
    from scipy.stats import binomtest

    return float(binomtest(better, better + worse).pvalue) if better + worse else 1.0
