"""From one sentence to a scene: "a bedroom for two children with a bunk bed, 4 x 5 m, for a wheelchair user".

Room type, size, shape, body, wished things and their counts are read from the words; the list is completed from the
catalogue with seeded variety. What was understood, what was assumed and what was ignored is part of the answer.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path

import numpy as np

from robolayout._reading import whole
from robolayout.assets import CATALOGUE, Category, own_assets, own_kinds
from robolayout.assets.beneath import low_enough, with_room_below
from robolayout.assets.catalogue import Entry
from robolayout.assets.palette import PALETTES
from robolayout.assets.surfaces import bearing, emptied, open_shelves
from robolayout.planners._added import COMFORT, SPARE, Added, both
from robolayout.planners._knowledge import load_knowledge
from robolayout.planners._openings import with_openings
from robolayout.planners._people import usual_people, wished_things
from robolayout.planners._room_size import SIZES, possible, room_size
from robolayout.planners._wishes import RoomWishes, Size, read_wishes
from robolayout.scene import (
    DEFAULT_AGENT,
    FLAT_HEIGHT,
    Agent,
    Asset,
    Room,
    Scene,
    load_agent,
    scene_from_dict,
    variable_name,
)
from robolayout.words import Mention, NamedThing, dressing, mentions, named, place_in, places, walls_meant

LOW_ENOUGH, LEAST_SHARE = 0.95, 0.6
"""How much of the height of a shelf what goes there takes at the most, and by how much it is made smaller at the most for that."""


BESIDE = 0.08
"""Metres left beside each of the things that stand along one wall, if they have to be made narrower for it."""
NARROWED = ("bench", "cabinet", "counter", "desk", "dresser", "rack", "shelf", "table", "unit", "wardrobe")
"""Last words of what may be."""


LEVEL = ("counter", "stove")
"""Roles of what has its top at the height of the worktops beside it."""
GATE = 0.6
"""Metres by which a door is wider than what is driven in."""


@dataclass(frozen=True)
class Understanding:
    """What was read from a sentence."""

    text: str  # the sentence
    room_type: str  # name of the room type
    size: tuple[float, float]  # width and depth of the room in metres
    shape: str  # "rectangular" or "L-shaped"
    height: float  # wall height in metres
    agent: str | None  # name of the body, or None for the default disc
    wished: Mapping[str, int]  # categories asked for and how many
    added: Mapping[str, int]  # categories added and how many
    assumed: tuple[str, ...]  # what was not said and therefore chosen, one sentence each
    ignored: tuple[str, ...]  # words that meant nothing to the reader

    def to_dict(self) -> dict[str, object]:
        """Return everything as plain values for a file."""
        return {key: list(value) if isinstance(value, tuple) else value for key, value in vars(self).items()}

    def sentences(self) -> tuple[str, ...]:
        """Return what was understood, in words."""
        width, depth = self.size
        lines = [f"A {self.shape} {self.room_type}, {width:g} x {depth:g} m, {self.height:g} m high."]
        lines.append(f"For: {self.agent or 'a disc of 0.30 m radius'}.")
        for label, things in (("Wished", self.wished), ("Added", self.added)):
            if things:
                lines.append(f"{label}: {', '.join(f'{n} {name}' for name, n in things.items())}.")
        lines += self.assumed
        if self.ignored:
            lines.append(f"Ignored: {', '.join(self.ignored)}.")
        return tuple(lines)


def scene_from_sentence(
    text: str,
    *,
    seed: int = 0,
    variant: int = 0,
    knowledge: Iterable[str | Path] = (),
    fill: float = COMFORT,
    agents: Sequence[Agent] = (),
    assets: str | Path | None = None,
) -> tuple[Scene, Understanding]:
    """Return a scene for a sentence, and what was understood of it.

    Args:
        text: One or a few sentences; lengths in metres, centimetres or feet.
        seed: Settles every choice.
        variant: Number of the variant; different ones have other doors, windows and additions.
        knowledge: Files of your own, whose things and rooms are known besides the built-in ones.
        fill: Share of the floor up to which further things are added.
        agents: The bodies of the room; else the one that the sentence names, or that is usual there.
        assets: Folder of meshes of your own, with a `catalogue.json` or without: named by their own words, and taken
            wherever something of their kind stands.

    Raises:
        SceneError: The sentence is empty, names no room, or wishes more than the room can hold.
    """
    whole(seed, "seed")
    whole(variant, "variant")
    rng = np.random.default_rng((seed, variant))
    own, picks = own_kinds(own_assets(Path(assets))) if assets else {}, np.random.default_rng((seed, variant))
    meshes = {name: made[int(picks.integers(len(made)))] for name, made in own.items()}
    known = load_knowledge(Path(path) for path in knowledge)
    wishes = read_wishes(text, known, {name: kind for name, (kind, _) in meshes.items()})
    wished = wished_things(wishes)
    stretch = float(np.exp(rng.uniform(-SIZES.stretch, SIZES.stretch))) if variant else 1.0
    size = room_size(wishes, wished, stretch)
    possible(wishes, wished, size)
    bodies = _widened(agents or ([load_agent(wishes.agent)] if wishes.agent else []), wishes.reading.way)
    added = Added(wishes, wished, wishes.floor(size), fill, bodies).things(rng)
    heights = (wishes.kinds[name].size[2] for name in (*wished, *added))
    tallest = max([*heights, *(body.height for body in bodies)], default=0.0)
    enough, given = math.ceil(10 * (1.07 * tallest + 0.2)) / 10, wishes.reading.measure("height")
    height = given[0] if given else max(wishes.room.height, enough)
    told = wishes.reading.agent is not None or bool(agents)
    assumed = (*wishes.guesses, *_assumed(wishes, size, height, [wishes.kinds[name] for name in wished], told=told))
    kind = wishes.room.of or wishes.room.name
    who = ", ".join(body.name for body in bodies) or None
    found = Understanding(
        text.strip(), kind, size, wishes.reading.shape, height, who, wished, added, assumed, wishes.ignored
    )
    entries = {name: entry for name, (_, entry) in meshes.items() if name in wishes.meshes}
    scene = scene_from_dict(_scene(found, wishes, rng, entries, bodies, varied=variant > 0), asset_dir=assets)
    scene = scene.with_agents(*bodies) if bodies else scene
    return _bearing(scene, wishes), found


def _widened(bodies: Sequence[Agent], way: float) -> Sequence[Agent]:
    """Return the bodies of a room with as wide a corridor as its words ask of ways: "a path 90 cm wide"."""
    return [_in_a_corridor(body, way) for body in bodies or [DEFAULT_AGENT] * (way > 2 * DEFAULT_AGENT.radius)]


def _in_a_corridor(body: Agent, wide: float) -> Agent:
    """Return a body for which ways are so many metres wide at least, and that reaches as far from their edges as from its own."""
    further = max(0.0, wide / 2 - body.radius)
    reach = None if body.reach_distance is None else body.reach_distance + further
    return replace(body, radius=body.radius + further, reach_distance=reach) if further else body


def _bearing(scene: Scene, wishes: RoomWishes) -> Scene:
    """Return a scene in which that on which words put something has room for it: nothing drawn in its way, and wide enough."""
    laid: dict[str, list[Size]] = {}
    held: dict[str, dict[NamedThing, int]] = {}  # of how many of a kind the shelves
    onto: dict[str, str] = {}  # of which kind the shelves are onto which a kind is put
    for link in (link for link in wishes.reading.parsed.links if link.relation in ("on", "in", "with", "stacked")):
        piled = link.relation == "stacked"  # each bears the next
        for one, bearer in product(link.subjects, mentions(link.subjects if piled else link.objects)):
            kind, other = (_as_asked(mention, wishes) for mention in (one, bearer))
            if piled or kind.on_object:
                each = 1 if piled else math.ceil(one.count / max(bearer.count, 1))
                laid.setdefault(other.name, []).extend([kind.size] * each)
                many = held.setdefault(other.name, {})
                many[bearer.thing] = max(many.get(bearer.thing, 0), min(bearer.count, one.count) * link.shelves)
                onto |= {kind.name: other.name} if link.shelves else {}
    shelves = Counter({name: sum(many.values()) for name, many in held.items()})
    grown, assets = dict[str, list[float]](), list[Asset]()  # by how much; like things stay alike
    for asset in scene.assets:
        sizes, within = laid.get(asset.category, []), shelves[asset.category] > 0
        bare = emptied(asset, sizes, shelves=within)
        if sizes and asset.path is None and not any(thing.sizes for thing in wishes.told(asset.category)):
            times = [new / old for new, old in zip(bearing(bare, sizes, shelves=within), bare.size, strict=True)]
            times = grown.setdefault(asset.category, times)
            d, w, h = (round(side * by, 3) for side, by in zip(bare.size, times, strict=True))
            bare = replace(bare, size=(d, w, h))
        shelves[asset.category] -= 1
        assets.append(bare)
    assets = [*_narrow_enough([*_low_enough(assets, onto, wishes)], wishes, scene.room)]
    return replace(scene, assets=tuple(_with_room_below(assets, wishes)))


def _as_asked(mention: Mention, wishes: RoomWishes) -> Category:
    """Return what somebody asks for, by its own words."""
    return wishes.asked.get(mention.thing) or wishes.kinds[wishes.kind(mention.thing)]


def _low_enough(assets: Sequence[Asset], onto: Mapping[str, str], wishes: RoomWishes) -> Iterator[Asset]:
    """Yield things, of which those that go onto the shelves of a kind are low enough for these: a vase there is one that fits."""
    free = dict[str, float]()
    for asset in assets:
        for shelf in open_shelves(asset) if asset.category in onto.values() else ():
            free[asset.category] = max(free.get(asset.category, 0.0), shelf.free)
    for asset in assets:
        by = LOW_ENOUGH * free.get(onto.get(asset.category, ""), math.inf) / asset.size[2]
        d, w, h = (
            (round(side * by, 3) for side in asset.size)
            if LEAST_SHARE < by < 1.0 and not _is_sized(asset, wishes)
            else asset.size
        )
        yield replace(asset, size=(d, w, h))


def _is_sized(asset: Asset, wishes: RoomWishes) -> bool:
    """Return whether the size of a thing is told, or that of a mesh of the user's own."""
    return asset.path is not None or any(thing.sizes for thing in wishes.told(asset.category))


def _narrow_enough(assets: Sequence[Asset], wishes: RoomWishes, room: Room) -> Iterator[Asset]:
    """Yield things, of which those that words put at one wall are narrow enough to stand there side by side."""
    there: dict[int, set[str]] = {}
    at = [k for k in wishes.reading.parsed.links if k.relation in ("wall", "on") and wishes.reading.size is not None]
    for link, place in ((k, place) for k in at for place in places(k.objects[:1], "wall")):
        if len(walls := walls_meant(room, place)) == 1:
            names = (_as_asked(mention, wishes).name for mention in link.subjects)
            there.setdefault(walls[0].index, set()).update(name for name in names if name.endswith(NARROWED))
    shares = dict[str, float]()
    for wall, kinds in there.items():
        widths = [a.size[1] for a in assets if a.category in kinds and a.on_floor]
        long = room.walls[wall].length - sum(door.width for door in room.doors if door.wall == wall)
        share = (long - BESIDE * (len(widths) + 1)) / max(sum(widths), 0.01)
        shares |= {kind: min(share, shares.get(kind, 1.0)) for kind in kinds if LEAST_SHARE < share < 1.0}
    for asset in assets:
        by = 1.0 if _is_sized(asset, wishes) else shares.get(asset.category, 1.0)
        yield replace(asset, size=(asset.size[0], round(asset.size[1] * by, 3), asset.size[2]))


def _with_room_below(assets: Sequence[Asset], wishes: RoomWishes) -> Iterator[Asset]:
    """Yield things, of which those that words put under others have room there."""
    links = [link for link in wishes.reading.parsed.links if link.relation == "under"]
    pairs = [
        tuple(_as_asked(mention, wishes) for mention in two)
        for link in links
        for two in product(link.subjects, mentions(link.objects))
        if not two[0].sat_on
    ]
    above = {low.name: high.name for low, high in pairs if low.on_floor and high.on_floor and low.size[2] > FLAT_HEIGHT}
    below: dict[str, list[Asset]] = {}
    for asset in assets:
        below.setdefault(above.get(asset.category, ""), []).append(asset)
    many, opened = Counter(asset.category for asset in assets), dict[str, Asset]()
    for asset in assets:
        held = below.get(asset.category, []) if asset.path is None else []
        opened[asset.name] = with_room_below(asset, held, math.ceil(len(held) / many[asset.category]))
    first = {asset.category: asset for asset in reversed(opened.values())}
    for asset in opened.values():
        upper = first.get(above.get(asset.category, ""))
        yield asset if upper is None or _is_sized(asset, wishes) else low_enough(asset, upper)


def _assumed(
    wishes: RoomWishes, size: tuple[float, float], height: float, wished: Iterable[Category], *, told: bool
) -> Iterator[str]:
    """Yield a sentence for every choice that the reader made, and each thing that is made as low as the walls."""
    room = wishes.room
    if wishes.reading.size is None:
        yield f"No size was given: {size[0]:g} x {size[1]:g} m was chosen."
    if not told:
        body = f"{room.agent} was taken, as usual there" if room.agent else "a disc of 0.30 m radius was taken"
        yield f"No body was named: {body}."
    if not wishes.reading.people and room.people:
        yield f"No number of people was given: {usual_people(wishes)} was chosen."
    for kind in wished:
        if kind.size[2] + SPARE > height:
            yield f"The walls are {height:g} m high, so {kind.name} is {height - SPARE:g} m high, not {kind.size[2]:g} m."


def _scene(
    found: Understanding,
    wishes: RoomWishes,
    rng: np.random.Generator,
    meshes: Mapping[str, Entry],
    bodies: Sequence[Agent],
    *,
    varied: bool,
) -> dict[str, object]:
    """Return the scene file's content for what was understood."""
    width, depth = found.size
    outline = [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)]
    if found.shape == "L-shaped":
        outline[2:3] = [(width, depth / 2), (width / 2, depth / 2), (width / 2, depth)]
    if rng.random() < 0.5:
        outline = [(width - x, y) for x, y in reversed(outline)]
    wide = 3.0 if found.agent == "forklift" else 0.95 if width * depth < 30 else 1.1
    driven = (kind.size[1] + GATE for name in found.wished if (kind := wishes.kinds[name]).role == "vehicle")
    wide = max([wide, *(0.1 + (body.width or 2 * body.radius) for body in bodies), *driven])
    tall = round(max([2.05, *(0.1 + body.height for body in bodies)]), 2)
    room = with_openings(Room(tuple(outline), found.height), wishes, (wide, tall), rng, varied=varied)
    style = wishes.reading.style or str(rng.choice([palette.wood.name for palette in PALETTES]))
    covering = wishes.reading.floor or str(rng.choice(wishes.room.floors))
    return {
        "dress": dressing(found.text),
        "task_description": found.text,
        "boundary": {"floor_vertices": [[*at, 0.0] for at in outline], "wall_height": found.height, "floor": covering},
        "doors": [vars(door) for door in room.doors],
        "windows": [vars(window) for window in room.windows],
        "assets": _assets(found, wishes, style, rng, meshes),
    }


def _assets(
    found: Understanding, wishes: RoomWishes, style: str, rng: np.random.Generator, meshes: Mapping[str, Entry]
) -> dict[str, object]:
    """Return the asset list: sizes and looks as said, or within 6 % of typical ones; what is added of a kind is like the first of it."""
    assets: dict[str, object] = {}
    links = wishes.reading.parsed.links
    hung = {t for k in links if place_in(k.objects, "ceiling") for t in named(k.subjects)}
    bare = {t for k in links if k.relation == "bare" for t in named(k.objects)}  # "nothing on the desk"
    # "a microwave above the stove", with no shelf that is said to bear it
    borne = {t for k in links if k.relation == "on" for t in named(k.subjects)}
    held = {t for k in links if k.relation == "above" for t in named(k.subjects) - borne if t.places == ("object",)}
    for kind, count in ((wishes.kinds[name], count) for name, count in both(found.wished, found.added).items()):
        mesh = meshes.get(kind.name if kind.name in wishes.lexicon.kinds else kind.like, {})
        scale, told = 1.0 + 0.06 * float(rng.uniform(-1, 1)), wishes.told(kind.name)
        for index in range(count):
            thing = told[index if index < len(told) else 0] if told else None
            usual = kind.size if thing is None else wishes.asked[thing].size
            scales = [scale if kind.on_floor and not mesh else 1.0] * 3
            scales[2] = 1.0 if kind.role in LEVEL else scales[2]  # worktops meet at one height
            d, w, h = (round(max(0.01, value * by), 3) for value, by in zip(usual, scales, strict=True))
            for measure in thing.sizes if thing is not None else ():
                d, w, h = measure.on((d, w, h))
            size = (d, w, min(h, round(found.height - SPARE, 3)))
            look = ", ".join((style, *(thing.look if thing is not None else ())))
            entry = {**mesh, **asset_entry(kind, size), "look": look} | ({"bare": True} if thing in bare else {})
            if thing is not None and thing.people:
                entry |= {"seats": thing.people}
            if kind.on_ceiling and thing in hung:  # it stands on nothing
                entry |= {"onCeiling": True, "onObject": False, "onWall": False, "onFloor": False}
            elif thing in held:
                entry |= {"onObject": False, "onWall": True}
            assets[f"{variable_name(kind.name)}-{index}"] = entry
    return assets


def asset_entry(kind: Category, size: Sequence[float]) -> dict[str, object]:
    """Return a thing of a kind as a scene file has it."""
    own: dict[str, object] = {}
    if kind.like:
        usual = CATALOGUE[kind.like]
        own |= {"like": kind.like} if usual.group != "unknown" else {}
        own |= {"synonyms": list(kind.synonyms)} if kind.synonyms not in ((), usual.synonyms) else {}
        own |= {"parts": kind.parts} if kind.parts not in (usual.parts, *CATALOGUE) else {}  # else drawn as that
        own |= {"useSides": list(kind.use_sides)} if kind.use_sides != usual.use_sides else {}
    return {
        "category": kind.name,
        "onFloor": kind.on_floor,
        "onWall": kind.on_wall,
        "onCeiling": kind.on_ceiling and not kind.on_wall,
        "onObject": kind.on_object,
        "assetMetadata": {"boundingBox": dict(zip("xyz", size, strict=True))},
        **own,
    }
