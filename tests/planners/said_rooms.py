"""Rooms of sentences, each laid out once, and their things by kind."""

from __future__ import annotations

from functools import cache

import robolayout as rl
from robolayout.run.result import Result

made = cache(rl.generate)


def of(result: Result, kind: str) -> list[str]:
    return [name for name in result.layout if name.rsplit("-", 1)[0] == kind]


def at_sides(result: Result, kind: str, table: str) -> list[str]:
    """Return at which side of a table each of a kind is, sorted."""
    depth, width, _ = result.scene.by_name[table].size
    found = list[str]()
    for name in of(result, kind):
        x, y = result.layout[table].seen(result.layout[name].at)
        ahead = abs(x) - depth / 2 > abs(y) - width / 2
        found.append(("front" if x > 0 else "back") if ahead else ("left" if y > 0 else "right"))
    return sorted(found)
