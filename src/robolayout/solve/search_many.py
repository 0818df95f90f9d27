"""The search for several programs of one scene at once: the compiled search, batched over problems as well as starts."""

from __future__ import annotations

import jax
from jaxtyping import Array

from robolayout.solve.arrays import Arrays, Found, Routes, Schedule
from robolayout.solve.config import Weights
from robolayout.solve.search import advance


def advance_many(
    local: Array, arrays: Arrays, routes: Routes, schedule: Schedule, noise: Array, *, weights: Weights
) -> Found:
    """Run the search of several problems of one size.

    Args:
        local: (P, K, A, 4) variables to start from, P problems with K starts each.
        arrays: The problems, each field with a leading P.
        routes: What must not stand in the way, each field with a leading P.
        schedule: Steps, rates, noise and ramp, the same for all.
        noise: (P, N, K, A, 2) standard normal numbers, used cyclically.
        weights: Factors of the terms.

    Returns:
        What `advance` returns for each problem, each field with a leading P.
    """

    def one(local: Array, arrays: Arrays, routes: Routes, noise: Array) -> Found:
        return advance(local, arrays, routes, schedule, noise, weights=weights)

    return jax.vmap(one)(local, arrays, routes, noise)
