"""Who takes which place: as good as SciPy's answer, for square and wide tables, with and without ties."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import linear_sum_assignment

from robolayout.constraints.around import assignment


@pytest.mark.parametrize("ties", [False, True])
@pytest.mark.parametrize("spare", [0, 3])
def test_nobody_finds_a_shorter_way(ties, spare):
    rng = np.random.default_rng(spare)
    for rows in range(1, 9):
        for _ in range(20):
            costs = rng.integers(0, 4, (rows, rows + spare)) if ties else rng.random((rows, rows + spare))
            chosen = assignment(costs.astype(float).tolist())
            assert len(set(chosen)) == rows
            assert costs[range(rows), chosen].sum() == pytest.approx(costs[linear_sum_assignment(costs)].sum())


def test_nobody_takes_nothing():
    assert assignment([]) == []
