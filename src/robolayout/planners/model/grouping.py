"""The grouping that a model answers: its form, what may be wrong with it, and how it is mended.

A scene has `bed-0`, `lamp-0`, `lamp-1`. A model that answers [bed-0], [lamp[0], lamp-7] names one thing in the program's way
(mended), one that does not exist (dropped) and forgets one (asked again with the reason, at last put into a group of its own).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
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
    name_of = _names(scene)
    written = [item for group in grouping.groups for item in group.items]
    named = Counter(filter(None, map(name_of, written)))
    faults = {
        "These things are in no group": [asset.name for asset in scene.assets if asset.name not in named],
        "These things are in more than one group": [name for name, times in named.items() if times > 1],
        "These names do not exist": list(dict.fromkeys(item for item in written if not name_of(item))),
    }
    parts = [
        f"{words}: {', '.join(names[:30])}" + (f" and {len(names) - 30} more." if len(names) > 30 else ".")
        for words, names in faults.items()
        if names
    ]
    again = "Answer again with every thing in exactly one group, under its own name."
    return " ".join([*parts, again]) if parts else None


def groups_of(scene: Scene, grouping: Grouping) -> tuple[Group, ...]:
    """Return the groups with every asset exactly once: first mention counts, unknown names go, leftovers come last."""
    name_of, groups, taken = _names(scene), list[Group](), set[str]()
    everything = [asset.name for asset in scene.assets]
    rest = AnsweredGroup(label=LEFT_OVER, rationale="The model put these into no group.", items=everything)
    for answered in (*grouping.groups, rest):
        known = dict.fromkeys(filter(None, map(name_of, answered.items)))
        items = tuple(name for name in known if name not in taken)
        if items:
            taken.update(items)
            label = _words(answered.label) or "group"
            labels = chain([label], (f"{label} {number}" for number in count(2)))
            fresh = next(one for one in labels if all(one != group.label for group in groups))
            phrases = tuple(map(_words, answered.relations[:40]))
            groups.append(Group(fresh, _words(answered.rationale), items, phrases))
    return tuple(groups)


def _names(scene: Scene) -> Callable[[str], str | None]:
    """Return what reads an asset's name in every way in which it may be written: `bed-0`, `bed[0]`, and `bed` if there is one."""
    names = {written: name for name, written in scene.expressions.items()}
    names |= {variable: assets[0].name for variable, assets in scene.variables.items() if len(assets) == 1}
    names |= {asset.name: asset.name for asset in scene.assets}
    return lambda written: names.get(written) or names.get(written.strip())


def _words(text: str) -> str:
    return " ".join(text.split())[:LONGEST_WORDS]
