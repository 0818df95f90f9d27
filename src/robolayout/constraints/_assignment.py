"""Who takes which place, so that all together have the shortest way."""

from __future__ import annotations

import math
from collections.abc import Sequence


def assignment(costs: Sequence[Sequence[float]]) -> list[int]:
    """Return a column for each row, no column twice, so that the sum of the costs is smallest.

    The shortest augmenting path algorithm: rows come one by one, and each takes the cheapest chain of exchanges. For the few
    seats of a table this is done before SciPy, which has the same, is even imported.

    Args:
        costs: One row per thing and one finite cost per place; at least as many places as things.
    """
    places = len(costs[0]) if costs else 0
    price, worth = [0.0] * places, [0.0] * len(costs)
    taker = [-1] * places
    for row in range(len(costs)):
        best, before, seen = [math.inf] * places, [-1] * places, [False] * places
        here, place = row, -1
        while True:
            for j in range(places):
                extra = costs[here][j] - worth[here] - price[j] + (0.0 if place < 0 else best[place])
                if not seen[j] and extra < best[j]:
                    best[j], before[j] = extra, place
            place = min((j for j in range(places) if not seen[j]), key=best.__getitem__)
            seen[place] = True
            if taker[place] < 0:
                break
            here = taker[place]
        shortest = best[place]
        worth[row] += shortest
        for j in range(places):
            if seen[j] and taker[j] >= 0:
                worth[taker[j]] += shortest - best[j]
            if seen[j]:
                price[j] -= shortest - best[j]
        while place >= 0:
            taker[place] = row if before[place] < 0 else taker[before[place]]
            place = before[place]
    return [taker.index(row) for row in range(len(costs))]
