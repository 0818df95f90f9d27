"""The grouping that a model answers: its form, what may be wrong with it, and how it is mended.

A scene has `bed-0`, `lamp-0`, `lamp-1`. A model that answers [bed-0], [lamp[0], lamp-7] names one thing in the program's way
(mended), one that does not exist (dropped) and forgets one (asked again with the reason, at last put into a group of its own).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, count

from pydantic import BaseModel, Field

from robolayout.planners._types import Group
from robolayout.scene import Scene

LEFT_OVER = "left over"  # label of the group of things that a model never named
LONGEST_WORDS = 300  # characters of a label, reason or phrase that are kept


class AnsweredGroup(BaseModel):
    """One group of furniture."""

    label: str = Field(description="what the group is, in one to three words")
    rationale: str = Field(default="", description="why these belong together, in one sentence")
    items: list[str] = Field(description="names of its things, the most structural first")
    relations: list[str] = Field(default_factory=list, description="how they stand to each other and to earlier groups")


class Grouping(BaseModel):
    """All groups, from structural to decorative."""

    groups: list[AnsweredGroup]


class Rating(BaseModel):
    """A critic's verdict on a finished room."""

    score: int = Field(ge=0, le=10, description="0 cannot be used, 5 works, 10 would not be touched")
    reasons: list[str] = Field(default_factory=list, description="at most five sentences, the weightiest first")


def complaint(scene: Scene, grouping: Grouping) -> str | None:
    """Return what is wrong with a grouping, for the model to mend; None if every thing is in exactly one group."""
    known = _names(scene)
    written = [item for group in grouping.groups for item in group.items]
    named = [known[item.strip()] for item in written if item.strip() in known]
    unknown = list(dict.fromkeys(item for item in written if item.strip() not in known))
    missing = [asset.name for asset in scene.assets if asset.name not in named]
    twice = list(dict.fromkeys(name for name in named if named.count(name) > 1))
    faults = (
        ("These things are in no group", missing),
        ("These things are in more than one group", twice),
        ("These names do not exist", unknown),
    )
    parts = [f"{words}: {_listed(names)}." for words, names in faults if names]
    again = "Answer again with every thing in exactly one group, under its own name."
    return " ".join([*parts, again]) if parts else None


def groups_of(scene: Scene, grouping: Grouping) -> tuple[Group, ...]:
    """Return the groups with every asset exactly once: first mention counts, unknown names go, leftovers come last."""
    known, taken, labels = _names(scene), set[str](), set[str]()
    groups: list[Group] = []
    for answered in grouping.groups:
        items = [known[item.strip()] for item in answered.items if item.strip() in known]
        items = [name for name in dict.fromkeys(items) if name not in taken]
        if items:
            taken.update(items)
            label = _fresh(_words(answered.label) or "group", labels)
            phrases = tuple(_words(phrase) for phrase in answered.relations[:40])
            groups.append(Group(label, _words(answered.rationale), tuple(items), phrases))
    missing = tuple(asset.name for asset in scene.assets if asset.name not in taken)
    if missing:
        label = _fresh(LEFT_OVER, labels)
        groups.append(Group(label, "The model put these into no group.", missing))
    return tuple(groups)


def _names(scene: Scene) -> dict[str, str]:
    """Return every way in which an asset may be named: `bed-0`, `bed[0]`, and `bed` if there is one."""
    names = {written: name for name, written in scene.expressions.items()}
    names |= {variable: assets[0].name for variable, assets in scene.variables.items() if len(assets) == 1}
    return names | {asset.name: asset.name for asset in scene.assets}


def _words(text: str) -> str:
    return " ".join(text.split())[:LONGEST_WORDS]


def _fresh(label: str, labels: set[str]) -> str:
    """Return a label that no other group has."""
    numbered = (f"{label} {number}" for number in count(2))
    unique = next(one for one in chain([label], numbered) if one not in labels)
    labels.add(unique)
    return unique


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:30]) + (f" and {len(names) - 30} more" if len(names) > 30 else "")
