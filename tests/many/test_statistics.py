"""The statistics against known answers."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import binomtest

from robolayout.many.statistics import means, sign_test


@pytest.mark.parametrize(("better", "worse"), [(0, 0), (5, 5), (9, 1), (1, 9), (30, 12), (0, 7)])
def test_the_sign_test_is_the_binomial_one(better: int, worse: int) -> None:
    expected = binomtest(better, better + worse).pvalue if better + worse else 1.0
    assert sign_test(better, worse) == pytest.approx(expected)


def test_intervals_are_those_of_the_normal_law_where_it_holds() -> None:
    values = np.random.default_rng(0).normal(3.0, 2.0, (400, 1))
    (found,) = means(values)
    half = 1.96 * values.std(ddof=1) / 20
    assert found.mean == pytest.approx(values.mean())
    assert (found.low, found.high) == pytest.approx((found.mean - half, found.mean + half), abs=0.03)


def test_rooms_without_a_figure_do_not_count() -> None:
    nan = float("nan")
    first, second, third = means(np.array([[1.0, nan, nan], [3.0, 2.0, nan]]))
    assert (first.count, first.mean, first.low, first.high) == (2, 2.0, 1.0, 3.0)
    assert (second.count, second.mean, second.low, second.high) == (1, 2.0, 2.0, 2.0)
    assert third.count == 0 and np.isnan(third.mean)
    assert means(np.array([[1.0], [3.0]])) == means(np.array([[1.0], [3.0]]))
