"""Assets sorted before they are placed: by manner of standing, into sets of the same make, and what a cluster gives up first."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import reduce
from operator import and_

from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.member import Member
from robolayout.solve.build.site import Site

SIDES = (("front",), ("left",), ("left", "front"), ("left", "right"))
"""Sides whose things a cluster gives up, the fewest first; it is tried mirrored, too."""


def alike(site: Site, clusters: Sequence[Cluster]) -> list[list[Cluster]]:
    """Return clusters in sets of the same make: anchors and followers of the same sizes, where rows are told anchors alone.

    The one with the most followers is first.
    """
    sets: dict[tuple[object, ...], list[Cluster]] = {}
    for cluster in clusters:
        key = tuple(
            (site.wants[m.name].kind, *(round(v, 1) for v in site.size(m.name)[:2]))
            for m in cluster.members
            if site.on_floor(m) and (m.name == cluster.anchor or not site.wants[cluster.anchor].block)
        )
        sets.setdefault(key, []).append(cluster)
    return [sorted(found, key=lambda one: -len(one.members)) for found in sets.values()]


def uncommon(site: Site, clusters: Sequence[Cluster]) -> list[str]:
    """Return what may stand alone of what clusters have on the floor, where not each of them has as many of its kind."""
    floor = [[m.name for m in cluster.members[1:] if site.on_floor(m)] for cluster in clusters]
    common = reduce(and_, (Counter(site.wants[name].kind for name in names) for names in floor))
    found: list[str] = []
    for names in floor:
        seen = Counter[str]()
        for want in (site.wants[name] for name in names):
            seen[want.kind] += 1
            found += [want.name] if want.loose and seen[want.kind] > common[want.kind] else []
    return found


def given_up(loose: Sequence[Member]) -> Iterator[list[str]]:
    """Yield which things a cluster gives up that fits nowhere as a whole: those at some sides, at last all."""
    for sides in SIDES:
        names = [member.name for member in loose if member.side in sides]
        if 0 < len(names) < len(loose):
            yield names
    if loose:
        yield [member.name for member in loose]
