"""Planned routes as the arrays that the compiled search takes."""

from __future__ import annotations

import numpy as np

from robolayout.floor import Plan
from robolayout.solve.arrays import Routes


def pack(plans: list[Plan], size: int) -> Routes:
    """Return the demands of all starts as padded arrays of `size` rows; the most pressing ones come first."""
    point = np.full((len(plans), size, 2), 1.0e4, np.float32)
    slot = np.zeros((len(plans), size), np.int32)
    need = np.full((len(plans), size), -1.0e4, np.float32)
    for k, plan in enumerate(plans):
        rows = plan.demands
        if len(rows) > size:
            rows = rows[np.linspace(0, len(rows) - 1, size).astype(int)]
        point[k, : len(rows)] = rows[:, :2]
        slot[k, : len(rows)] = rows[:, 2]
        need[k, : len(rows)] = rows[:, 3]
    return Routes(point, slot, need)
