"""Which role each asset plays, and what it joins: the hierarchy behind groups and programs."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace

from robolayout.assets import Category, category_of
from robolayout.assets.lexicon import place_of
from robolayout.constraints.around import most_seats
from robolayout.planners._knowledge import ALONE, ON_ANY, Join, Knowledge, Role
from robolayout.scene import Agent, Asset, Scene
from robolayout.scene.agent import horizontal_reach

TOP_HEIGHT = 1.45  # metres above which nothing is put on a top: out of sight and of most hands
BEYOND = 0.03  # metres beyond its own edge that an arm must get to a thing on a top
TOP_SHARE = 0.55  # share of a top that may be covered
FILLED = 0.4  # metres of height from which on a top may be filled by a single thing, as that of a printer stand
STANDS = 0.9  # metres of height from which on what may stand on the floor is put on no top
NARROWEST = 0.6  # metres that people need to get to a side of a thing


@dataclass(frozen=True)
class Cast:
    """An asset in its role."""

    asset: Asset
    role: Role  # what it is for
    category: Category  # what the catalogue knows about it
    anchor: str = ""  # name of the asset it joins; empty if it stands by itself
    join: Join = ALONE  # how it joins that asset

    @property
    def name(self) -> str:
        """The asset's name."""
        return self.asset.name

    @property
    def alone(self) -> Cast:
        """The same by itself."""
        return replace(self, anchor="", join=ALONE)


def cast_scene(scene: Scene, knowledge: Knowledge) -> dict[str, Cast]:
    """Give every asset a role and, where its role asks for it, an asset to join; in the order of the scene."""
    cast: dict[str, Cast] = {}
    for asset in scene.assets:
        category = category_of(asset)
        cast[asset.name] = Cast(asset, _role(knowledge, asset, category), category)
    for name in sorted(cast, key=lambda n: (cast[n].role.rank, -_footprint(cast[n].asset))):
        item = cast[name]
        found = next(filter(None, (_anchor(item, cast, handy) for handy in _handy(item, cast, scene.agents))), None)
        found = found or _any_top(item, cast)
        if found is not None:
            cast[name] = replace(item, anchor=found[0], join=found[1])
    return cast


def _handy(item: Cast, cast: Mapping[str, Cast], agents: Sequence[Agent]) -> Iterator[Set[str]]:
    """Yield the assets on which a thing is in every arm's reach, then in that of arms at narrow sides too, then all."""
    heights = {other.asset.size[2] for other in cast.values()}
    for narrow in (False, True) if any(join.on_top for join in item.role.joins) else ():
        within = {height for height in heights if in_height(agents, item.asset, height, narrow=narrow)}
        yield {other for other, there in cast.items() if there.asset.size[2] in within}
    yield cast.keys()


def _footprint(asset: Asset) -> float:
    return asset.size[0] * asset.size[1]


def _role(knowledge: Knowledge, asset: Asset, category: Category) -> Role:
    """Return an asset's role: by its words, by the catalogue's name for it, by its last words, by its shape."""
    words, own = re.findall(r"[^\W_]+", asset.category.lower()), knowledge.recognised(asset)
    ends = [" ".join(words[i:]) for i in range(len(words))]
    names = (" ".join(words), own.name if own else "", category.name)
    roles = [*map(knowledge.playing.get, names), *map(knowledge.by_word.get, ends)]
    return next((role for role in roles if role and _fits(role, asset)), knowledge.roles[fallback(asset)])


def _fits(role: Role, asset: Asset) -> bool:
    """Whether the asset's flags allow any way of standing that the role knows."""
    allowed = {"hang": asset.on_wall, "ceiling": asset.on_ceiling, "rug": asset.on_floor and asset.size[2] <= 0.1}
    stands = any(allowed.get(mode, asset.on_floor) for mode in role.stands) or (role.rim > 0 and asset.on_wall)
    return stands or any(_join_allowed(join, asset) for join in role.joins)


def _join_allowed(join: Join, asset: Asset) -> bool:
    """Whether the asset's flags allow it to join in that way."""
    return asset.on_object if join.on_top else asset.on_floor


def fallback(asset: Asset) -> str:
    """Return the role of an unknown asset: flags first, then size and shape."""
    depth, width, height = asset.size
    if asset.is_flat:
        return "covering"
    if asset.on_floor:
        if depth * width > 0.9 and height < 1.2 and min(depth, width) > 0.6:
            return "big thing"
        return "tall thing" if height >= 0.6 and depth * width > 0.2 else "small thing"
    if asset.on_object:
        return "thing on a top"
    return "thing on the ceiling" if asset.on_ceiling else "thing on a wall"


def in_height(agents: Sequence[Agent], asset: Asset, bottom: float, *, narrow: bool = False) -> bool:
    """Return whether every agent with an arm gets past its own edge to a thing that stands `bottom` metres high.

    Its edge is that of its disc, or `narrow` that of its narrow side.
    """
    for agent in (agent for agent in agents if agent.reach_distance is not None):
        far = horizontal_reach(agent, bottom, bottom + asset.size[2])
        edge = min(agent.length, agent.width) / 2 if narrow and agent.length and agent.width else agent.radius
        if far is None or far < edge + BEYOND:
            return False
    return True


def _anchor(item: Cast, cast: Mapping[str, Cast], handy: Set[str]) -> tuple[str, Join] | None:
    """Return what the item joins: of the first fitting kind, the one with fewest like it (or most), and bigger tops first.

    On a top it is put only where `handy` holds that top.
    """
    taken = Counter(one.anchor for one in cast.values() if one.role is item.role)
    for join in item.role.joins:
        for wanted in join.of if _join_allowed(join, item.asset) else ():
            free = [
                (-taken[name] if join.gather else taken[name], -_footprint(other.asset) * other.role.top, order, name)
                for order, (name, other) in enumerate(cast.items())
                if (not join.on_top or (name in handy and "bare" not in other.asset.metadata))
                and (other.role.name == wanted or (wanted == "*" and other.role.top))
                and taken[name] < join.most
                and (join.slot != "around" or taken[name] < _seats(other.asset, item.asset))
                and item.name not in chain(name, cast)
                and _room_for(item.asset, other, join, cast)
            ]
            if free:
                return (min(free)[3], join)
    return None


def _seats(table: Asset, seat: Asset) -> int:
    """Return how many seats go around a table: as many as its words promise ("for two"), as far as there is room."""
    told = table.metadata.get("seats")
    return min(most_seats(table, seat), told if isinstance(told, int) else 99)


def elsewhere(name: str, cast: Mapping[str, Cast], barred: Set[str]) -> Cast:
    """Return an asset as it joins anything but some; by itself where there is nothing for it."""
    left = {other: one for other, one in cast.items() if barred.isdisjoint(chain(other, cast))}
    left[name] = cast[name].alone
    found = _anchor(left[name], left, left.keys())
    return left[name] if found is None else replace(left[name], anchor=found[0], join=found[1])


def _borne(top: str, cast: Mapping[str, Cast]) -> list[Asset]:
    """Return what is put on a top."""
    return [one.asset for one in cast.values() if one.anchor == top and one.join.on_top]


def _any_top(item: Cast, cast: Mapping[str, Cast]) -> tuple[str, Join] | None:
    """Return the best top for what can stand nowhere else, however unlikely that top is."""
    if place_of(item.asset) != "object":
        return None
    best = [
        (
            other.asset.size[2] > TOP_HEIGHT,
            not other.role.top,
            sum(map(_footprint, _borne(name, cast))) - _footprint(other.asset),
            name,
        )
        for name, other in cast.items()
        if other.asset.on_floor and not other.asset.is_flat and item.name not in chain(name, cast)
        if "bare" not in other.asset.metadata
    ]
    return (min(best)[-1], ON_ANY) if best else None


def stands_free(size: Sequence[float], top: Sequence[float], there: Iterable[Sequence[float]]) -> bool:
    """Return whether a thing of a size of depth, width and height stands before or beside each of those on a top."""
    return all(size[0] <= top[0] - one[0] or size[1] <= (top[1] - one[1]) / 2 for one in there)


def _room_for(asset: Asset, other: Cast, join: Join, cast: Mapping[str, Cast]) -> bool:
    """Return whether a thing fits at another, or on it: before each one there or beside it, so that no bowl goes by a wide screen."""
    if not join.on_top:
        return not other.asset.is_flat
    (depth, width, height), there = other.asset.size, _borne(other.name, cast)
    covered, free = sum(map(_footprint, there)), stands_free(asset.size, other.asset.size, [one.size for one in there])
    if asset.on_floor and asset.size[2] > STANDS:
        return False
    fits = max(asset.size[:2]) <= max(depth, width) + 0.02 and min(asset.size[:2]) <= min(depth, width) + 0.02
    alone = covered == 0.0 and height >= FILLED
    shared = alone or covered + _footprint(asset) <= TOP_SHARE * depth * width
    return fits and free and height <= TOP_HEIGHT and shared


def chain(name: str, cast: Mapping[str, Cast]) -> list[str]:
    """Return an asset, what it joins, what that joins, and so on to what stands by itself."""
    found = [name]
    while anchor := cast[found[-1]].anchor:
        found.append(anchor)
    return found


def passage(scene: Scene) -> float:
    """Return the metres that the widest body of a scene, and people, need to pass."""
    return round(max(NARROWEST, 2 * max(agent.radius for agent in scene.agents) + 0.1), 2)
