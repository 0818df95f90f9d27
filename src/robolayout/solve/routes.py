"""Planned routes as the arrays that the compiled search takes."""

from __future__ import annotations

import numpy as np

from robolayout.floor import Plan
from robolayout.solve.arrays import Routes
from robolayout.solve.stage import no_routes


def pack(plans: list[Plan], size: int) -> Routes:
    """Return the demands of all starts as padded arrays of `size` rows; the most pressing ones come first."""
    packed = no_routes(len(plans), size)
    for k, plan in enumerate(plans):
        rows = plan.demands
        if len(rows) > size:
            rows = rows[np.linspace(0, len(rows) - 1, size).astype(int)]
        packed.point[k, : len(rows)] = rows[:, :2]
        packed.slot[k, : len(rows)] = rows[:, 2]
        packed.need[k, : len(rows)] = rows[:, 3]
    return packed
