"""The statistics against known answers."""

from __future__ import annotations

import numpy as np
import pytest

from robolayout.many.evaluation import mean, sign_test


@pytest.mark.parametrize(("better", "worse", "chance"), [(0, 0, 1.0), (5, 5, 1.0), (9, 1, 22 / 1024), (0, 7, 2 / 128)])
def test_the_sign_test_counts_coins(better: int, worse: int, chance: float) -> None:
    assert sign_test(better, worse) == sign_test(worse, better) == pytest.approx(chance)


def test_intervals_are_those_of_the_normal_law_where_it_holds() -> None:
    values = np.random.default_rng(0).normal(3.0, 2.0, 400)
    found = mean(values)
    half = 1.96 * values.std(ddof=1) / 20
    assert found.mean == pytest.approx(values.mean())
    assert (found.low, found.high) == pytest.approx((found.mean - half, found.mean + half), abs=0.03)


def test_rooms_without_a_figure_do_not_count() -> None:
    nan = float("nan")
    first, second, third = (mean(np.array(column)) for column in ([1.0, 3.0], [nan, 2.0], [nan, nan]))
    assert (first.count, first.mean, first.low, first.high) == (2, 2.0, 1.0, 3.0)
    assert (second.count, second.mean, second.low, second.high) == (1, 2.0, 2.0, 2.0)
    assert third.count == 0 and np.isnan(third.mean)
    assert mean(np.array([1.0, 3.0])) == first
