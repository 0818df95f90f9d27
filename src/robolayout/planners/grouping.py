"""Groups of assets, structural first and decorative last, from the roles that they play."""

from __future__ import annotations

from collections.abc import Mapping

from robolayout.planners._knowledge import Knowledge
from robolayout.planners._roles import Cast
from robolayout.planners._types import Group

SLOT_WORDS = {
    "beside": "beside",
    "flank": "at the side of",
    "front": "in front of",
    "behind": "behind",
    "around": "around",
    "on": "on top of",
    "setting": "laid out on",
}


def group_cast(cast: Mapping[str, Cast], knowledge: Knowledge) -> tuple[Group, ...]:
    """Return the groups of a scene's assets, in the order in which they should be planned.

    What joins another thing belongs to that thing's group, so that a night stand is never planned before its bed.
    """
    members: dict[str, list[str]] = {}
    for name in sorted(cast, key=lambda n: cast[root(cast, n)].role.rank):
        members.setdefault(cast[root(cast, name)].role.group, []).append(name)
    return tuple(
        Group(label, knowledge.reasons[label], tuple(_in_order(names, cast)), tuple(_phrases(names, cast)))
        for label, names in sorted(members.items(), key=lambda entry: (knowledge.orders[entry[0]], entry[0]))
    )


def root(cast: Mapping[str, Cast], name: str) -> str:
    """Return what an asset stands at in the end: itself, or the last of the things that it joins."""
    anchor = cast[name].anchor
    return name if anchor is None else root(cast, anchor)


def _depth(cast: Mapping[str, Cast], name: str) -> int:
    anchor = cast[name].anchor
    return 0 if anchor is None else 1 + _depth(cast, anchor)


def _in_order(names: list[str], cast: Mapping[str, Cast]) -> list[str]:
    return sorted(names, key=lambda n: (_depth(cast, n), cast[n].role.rank))


def _phrases(names: list[str], cast: Mapping[str, Cast]) -> list[str]:
    return [f"{n} {SLOT_WORDS[cast[n].joined.slot]} {cast[n].anchor}" for n in _in_order(names, cast) if cast[n].join]
