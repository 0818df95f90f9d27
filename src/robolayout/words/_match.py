"""Which assets of a scene stand for a thing that is named."""

from __future__ import annotations

from collections.abc import Sequence

from robolayout.assets import category_of
from robolayout.assets.lexicon import singular
from robolayout.scene import Asset, Scene
from robolayout.words._lexicon import grammar, plain
from robolayout.words._said import Thing

_KIN = "crib bed, cot bed, cradle bed, loveseat sofa, couch sofa, settee sofa, recliner armchair, chandelier lamp"
KIN = {thing: other for thing, other in (pair.split() for pair in _KIN.split(", "))}
"""Things that stand for another that they are not named after."""


def stand_ins(scene: Scene, things: Sequence[Thing]) -> dict[Thing, tuple[str, ...]]:
    """Return the names of the assets that stand for each thing; one asset stands for one thing only.

    The same words come first, then the same kind, then the same last word ("bed" for a single bed). A plural without a number
    takes all that are left.
    """
    free = [asset for asset in scene.assets]
    found: dict[Thing, tuple[str, ...]] = {}
    for tier in (_same_words, _same_kind, _same_head):
        for thing in things:
            have = found.get(thing, ())
            short = thing.count - len(have)
            if short <= 0 or (have and tier is _same_head):
                continue
            fits = [asset for asset in free if tier(asset, thing)]
            greedy = thing.plural and thing.number is None and thing.times == 1
            taken = fits if greedy else fits[:short]
            free = [asset for asset in free if asset not in taken]
            found[thing] = (*have, *(asset.name for asset in taken))
    return found


def fits(asset: Asset, thing: Thing) -> bool:
    """Return whether an asset is such a thing."""
    return _same_words(asset, thing) or _same_kind(asset, thing) or _same_head(asset, thing)


def _same_words(asset: Asset, thing: Thing) -> bool:
    category = singular(plain(asset.category))
    return category in (thing.noun.words, thing.noun.said)


def _same_kind(asset: Asset, thing: Thing) -> bool:
    if thing.noun.kind.startswith("unknown"):
        return thing.noun.said in singular(plain(asset.description))
    return category_of(asset).name == thing.noun.kind


def _same_head(asset: Asset, thing: Thing) -> bool:
    category = singular(plain(asset.category)).split()
    said = [word for word in thing.noun.said.split() if word not in grammar().sizes]
    if not category or len(said) != 1:
        return bool(category) and thing.head == category[-1] and len(category) == 1
    return category[-1] == said[0] or KIN.get(category[-1]) == said[0]
