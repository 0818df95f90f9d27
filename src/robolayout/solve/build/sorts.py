"""Clusters sorted before they are placed: into sets of the same make, and what keeps them from being one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import reduce
from operator import and_

from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.site import Site


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
