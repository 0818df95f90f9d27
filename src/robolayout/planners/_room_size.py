"""How large a room is: as said, else as large as what is wished needs, with its rows, blocks and circles."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass

from robolayout._errors import SceneError
from robolayout.constraints.in_shape import shape_slots
from robolayout.planners._wishes import RoomWishes
from robolayout.scene import FLAT_HEIGHT
from robolayout.words import (
    AISLE,
    BETWEEN_BEDS,
    CROWD,
    MIDDLE_AISLE,
    SHAPES,
    Link,
    Mention,
    NamedThing,
    Place,
    mentions,
    named,
    place_in,
    places,
    rows_of,
    usual_rows,
)


@dataclass(frozen=True)
class Sizes:
    """How large a room is made, and how full."""

    fullest: float = 0.55  # share of the floor that wished things may take before the wish is called impossible
    roomy: float = 0.22
    aisled: float = 0.18
    """Share of the floor that wished things take where no size is given, and where some are told to stand in so many rows."""
    stretch: float = 0.25
    """Logarithm of the factor by which variants of a room are longer or shorter than usual at the most."""
    for_two: float = 1.2  # metres of a table's longer side up to which two sit at it, if nobody says how many
    between: float = 1.25
    aisle: float = 0.75
    around: float = 0.7
    before: float = 2.0
    """Metres between rows of desks, between other rows, beside and behind a block of rows, and before it."""
    apart: tuple[float, float] = (0.35, 0.85)
    """Metres between neighbours in a half circle, and in a circle, which one enters."""
    walkway: float = 0.6
    seated: float = 1.2
    """Metres by which a room is longer and wider than the longest thing in it, where no size is given; more at ends of tables."""
    low: float = 1.2  # metres of height up to which a row of things hides no window
    way: float = 0.9  # metres that ways may be wide in a room of the usual size
    parted: float = 0.12  # metres that what is between two things of a row takes beside its own


SIZES = Sizes()


def room_size(wishes: RoomWishes, wished: Mapping[str, int], stretch: float) -> tuple[float, float]:
    """Return width and depth in metres: as asked, else usual ones, enlarged for what is wished, one side stretched."""
    if wishes.reading.size is not None:
        return wishes.reading.size
    width, depth = wishes.room.size
    standing = [kind for name in wished if (kind := wishes.kinds[name]).on_floor]
    sides = (max(kind.size[:2]) + SIZES.seated * kind.name.endswith("table") for kind in standing)
    longest = max(sides, default=0.0)
    given = wishes.reading.measure("area")
    usual = width * depth * wishes.reading.scale
    share = SIZES.aisled if any(link.rows for link in wishes.reading.parsed.links) else SIZES.roomy
    share /= min(wishes.reading.scale, 1.0)
    instead = {*map(wishes.head, wished)}  # a bunk bed stands there in place of a bed
    base = {name: count for name, count in wishes.room.base.items() if wishes.head(name) not in instead}
    area = given[0] if given else max(usual, wishes.floor_area({**base, **wished}) / share)
    if wishes.reading.shape == "L-shaped":
        area *= 1 / 0.75 if given else 1.2  # a quarter of what is around it is cut out
    area *= max(1.0, wishes.reading.way / SIZES.way)
    ratio = wishes.reading.ratio or stretch * width / depth
    if wishes.reading.ratio and any(len(named(k.subjects)) > 2 and _sideways(k) for k in wishes.reading.parsed.links):
        ratio = 1 / ratio  # "a narrow kitchen with everything along the left wall"
    width = max(math.sqrt(area * ratio), longest + SIZES.walkway)
    depth = area / width if given else max(area / width, longest + SIZES.walkway)
    if given is not None:
        width, depth = (depth, width) if depth < _along_a_side(wishes) <= width else (width, depth)
        return (round(width, 2), round(depth, 2))
    short, long = sorted((width, depth))
    for across, ahead in _blocks(wishes):  # the longer side of a room holds the longer side of a block
        short, long = (max(pair) for pair in zip((short, long), sorted((across, ahead)), strict=True))
    width, depth = (short, long) if width <= depth or _along_a_side(wishes) > short else (long, short)
    return (round(width, 2), round(depth, 2))


def _along_a_side(wishes: RoomWishes) -> float:
    """Return how many metres what stands along the left or the right wall takes there, at the most."""
    links = (k for k in wishes.reading.parsed.links if k.relation == "wall" and _sideways(k))
    rows = (sum(one.count * wishes.kinds[wishes.kind(one.thing)].size[1] for one in k.subjects) for k in links)
    return max(rows, default=-SIZES.around) + SIZES.around


def _sideways(link: Link) -> bool:
    """Return whether things stand along the left or the right wall."""
    at = place_in(link.objects, "wall")
    return at is not None and not {"left", "right", "east", "west"}.isdisjoint(at.words)


def _blocks(wishes: RoomWishes) -> Iterator[tuple[float, float]]:
    """Yield how wide and how deep rows and blocks that are told are in metres, with what stands before them and ways around."""
    links = wishes.reading.parsed.links
    told = {thing for link in links if link.relation == "rows" for thing in named(link.subjects)}
    for link in links:
        line = [mention for mention in link.subjects if mention.thing.category.on_floor]
        ends = mentions(link.objects) if link.relation == "amid" else []
        ends = ends * (sum(m.count for m in ends) == 2)
        flanked = [m for m in ends if (m.count == 2 and m.opens) or m.thing.category.built_in]
        line = flanked if line and flanked else line  # "a bench between two cabinets"
        at = place_in(link.objects, "wall") if link.relation == "wall" else None
        if line and (link.relation in ("row", "abreast") or flanked or (at is not None and at.at_one_wall)):
            sizes = [(one.count, *wishes.kinds[wishes.kind(one.thing)].size) for one in line]
            own = named(line)  # and what is between them
            parted = _amid(wishes, own)
            told_gaps = (k for k in links if k.relation == "apart" and not k.objects and named(k.subjects) == own)
            many = sum(count for count, *_ in sizes)
            parted += max((k.metres[0] for k in told_gaps), default=0.0) * (many - 1)
            wide = sum(count * width for count, _, width, _ in sizes) + parted + SIZES.around
            seated = sum(m.count for k in links if own & named(k.objects) for m in k.subjects if m.sat_on)
            wide += SIZES.walkway * (seated >= 2 * many)  # to who sits on its other side
            over = any(k.relation == "above" and named(k.objects) & (own | named(link.subjects)) for k in links)
            tall = over or max(height for *_, height in sizes) > SIZES.low
            yield wide, wide if tall else 0.0  # a wall without a window
        if link.relation == "wall" and place_in(link.objects, "window"):  # "five tables along the window"
            tables = [m for m in line if m.several and m.thing.head == "table"]
            sizes = (one.count * (wishes.kinds[wishes.kind(one.thing)].size[1] + 2 * SIZES.walkway) for one in tables)
            yield sum(sizes), 0.0
        if line and at is not None and at.plural and (at.number or 0) > 1:  # "twenty lockers along two walls"
            wide = sum(one.count * wishes.kinds[wishes.kind(one.thing)].size[1] for one in line)
            share = wide / (at.number or 1) + SIZES.around
            yield share, share
        yield from _amid_others(wishes, link)
        yield from _beside_a_sofa(wishes, link)
        yield from _clusters(wishes, link)
        yield from _gathered(wishes, link)
        for thing in named(link.subjects) if link.relation in SHAPES else ():
            wide, deep = _around(wishes, thing, SHAPES[link.relation], thing.count)
            before = any(k.relation in ("facing", "front") and thing in named(k.subjects) for k in links)
            yield wide, deep + SIZES.before * before
            yield wide * before, wide * before  # what is before it may be at any wall
        if link.relation == "turning" and place_in(link.objects, "middle", "room"):  # what is at the walls is beyond
            sizes = ((min(kind.size[:2]), kind) for kind in wishes.asked.values() if kind.on_floor)
            deep = max((size + 2 * SIZES.walkway * kind.name.endswith("table") for size, kind in sizes), default=0.0)
            yield link.metres[0] + 2 * deep, link.metres[0] + 2 * deep
        for ring in wishes.rings([link]):
            yield ring + 2 * SIZES.around, ring + 2 * SIZES.around
        for thing in named(link.subjects) if link.relation == "cleared" else ():
            depth, width, _ = wishes.kinds[wishes.kind(thing)].size
            at = [side for place in places(link.objects) for side in place.words]
            across, ahead = (sum(side in at for side in two) for two in (("left", "right"), ("front", "back")))
            wide, deep = width + across * link.metres[0], depth + ahead * link.metres[0]
            beside = (0.0, SIZES.around, SIZES.before)  # what stands beyond, at no side, one or two
            yield wide + beside[across], deep + beside[ahead]
        yield from _in_rows(wishes, link, line, told)


def _amid_others(wishes: RoomWishes, link: Link) -> Iterator[tuple[float, float]]:
    """Yield how wide and deep what is in the middle of the room is with what is before and behind it."""
    for thing in named(link.subjects) if place_in(link.objects, "middle") else ():
        links = (k for k in wishes.reading.parsed.links if k.relation in ("front", "behind") and k.subjects)
        about = {k.relation: k.subjects for k in links if thing in named(k.objects)}
        depths = {how: max(wishes.kinds[wishes.kind(m.thing)].size[0] for m in who) for how, who in about.items()}
        depth, width, _ = wishes.kinds[wishes.kind(thing)].size
        if depths:
            yield width + 2 * SIZES.around, depth + sum(depths.values()) + (len(depths) + 2) * SIZES.around


def _beside_a_sofa(wishes: RoomWishes, link: Link) -> Iterator[tuple[float, float]]:
    """Yield how wide a sofa is with what is so far beside it, and as much on the other side: it is centred before a television."""
    for sofa in named(link.objects) if link.relation == "apart" else ():
        sizes = [wishes.kinds[wishes.kind(thing)].size[1] for thing in named(link.subjects) if thing.category.on_floor]
        if sofa.head == "sofa" and sizes:
            yield wishes.kinds[wishes.kind(sofa)].size[1] + 2 * (link.metres[0] + max(sizes)), 0.0


def _clusters(wishes: RoomWishes, link: Link) -> Iterator[tuple[float, float]]:
    """Yield how wide and deep groups that stand apart in two rows are, with what is between them: circles of seats, islands of desks."""
    for thing in named(link.subjects) if link.relation in ("groups", "shares") and link.rows else ():
        each = link.rows if link.relation == "groups" else math.ceil(thing.count / link.rows)
        if each <= 2:
            continue
        wide, deep = _around(wishes, thing, "circle", each)
        if thing.head == "desk":  # with their backs to each other
            depth, width, _ = wishes.kinds[wishes.kind(thing)].size
            wide, deep = math.ceil(each / 2) * width + 2 * SIZES.around + SIZES.walkway, 2 * (depth + SIZES.between)
        amid = _amid(wishes, {thing})
        yield math.ceil(thing.count / each / 2) * wide + amid, min(2, thing.count // each) * deep + amid


def _gathered(wishes: RoomWishes, link: Link) -> Iterator[tuple[float, float]]:
    """Yield how wide and deep coffee tables are, side by side, with more than two armchairs around each."""
    for low in named(link.objects) if link.relation == "around" else ():
        chairs = [m for m in link.subjects if m.thing.head == "armchair"]
        if (
            low.noun.kind == "coffee table"
            and len(chairs) == len(link.subjects)
            and sum(m.count for m in chairs) > 2 * low.count
        ):
            deep, wide, _ = wishes.kinds[wishes.kind(low)].size
            seat = wishes.kinds[wishes.kind(chairs[0].thing)].size[0]
            beyond = 2 * (seat + SIZES.around)
            yield low.count * (max(wide, deep) + beyond), max(wide, deep) + beyond + SIZES.around


def _amid(wishes: RoomWishes, ends: Set[NamedThing]) -> float:
    """Return how many metres what is between some things takes, with what it takes beside its own."""
    links = wishes.reading.parsed.links
    amid = {m for k in links if k.relation == "amid" and ends & named(k.objects) for m in k.subjects}
    return sum(m.count * (min(wishes.kinds[wishes.kind(m.thing)].size[:2]) + SIZES.parted) for m in amid)


def _around(wishes: RoomWishes, thing: NamedThing, shape: str, count: int) -> tuple[float, float]:
    """Return how wide and deep a shape of some things is, with ways around it."""
    kind = wishes.kind(thing)
    depth, width, _ = wishes.kinds[kind].size
    slots = shape_slots(shape, max(count, 3), depth, width, SIZES.apart[shape == "circle"])
    round_it = max(depth, width) + 2 * SIZES.around + SIZES.walkway * kind.endswith(("desk", "table"))
    wide, deep = (max(at[k] for at in slots) - min(at[k] for at in slots) + round_it for k in (1, 0))
    return wide, deep


def _in_rows(
    wishes: RoomWishes, link: Link, line: Sequence[Mention], told: set[NamedThing]
) -> Iterator[tuple[float, float]]:
    """Yield how wide and how deep straight rows are, of things spaced evenly and of an audience, too."""
    links = wishes.reading.parsed.links
    spaced = link.relation == "apart" and not link.objects and len(line) == 1 and line[0].thing.count >= CROWD
    lines = link.relation in ("rows", "columns")
    crowd = lines and line and (link.rows > 1 or (not link.rows and line[0].thing.count >= CROWD))
    looking = link.relation == "facing" and bool(wishes.audience & named(line) - told)
    for thing in [one.thing for one in link.subjects if spaced or crowd or looking][:1]:
        kind, rows = wishes.kind(thing), thing.rows if spaced else link.rows
        depth, width, height = wishes.kinds[kind].size
        rows = rows_of(thing.count) if looking else rows
        facing = not rows and lines and any(k.relation == "facing" and thing in named(k.subjects) for k in links)
        rows = usual_rows(thing.count) if facing else rows
        rows = math.ceil(thing.count / rows) if link.relation == "columns" and rows else rows
        rows, gap = (rows, 0.0) if rows > 0 else (math.ceil(math.sqrt(thing.count)), link.metres[0])
        each = math.ceil(thing.count / rows)
        before = any(k.relation == "front" and thing in named(k.objects) for k in links)
        wide = 1.0 if height >= FLAT_HEIGHT else before / 2
        aisle = SIZES.between if kind.endswith(("desk", "table")) else SIZES.aisle * wide
        aisle = AISLE if rows > 1 and _amid(wishes, {thing}) else aisle + link.metres[0] * spaced
        width += _beside_a_bed(wishes, thing) if thing.head == "bed" else 0.0
        ahead = rows_ahead(rows, depth, aisle)
        seen = [item for k in links if k.relation == "facing" and thing in named(k.subjects) for item in k.objects]
        hung = any(isinstance(item, Place) or not item.thing.category.on_floor for item in seen)
        roles = {name: wishes.role(name) for name in map(wishes.kind, named(seen))}
        walled = [wishes.kinds[name] for name, role in roles.items() if role is not None and role.stands == ("wall",)]
        ahead += max((kind.size[0] for kind in walled if kind.on_floor), default=0.0)  # a stage
        hung |= bool(walled)
        ends = SIZES.seated if thing.head == "bed" else 0.0  # a door beside their heads
        yield each * (width + gap) + 2 * SIZES.around + ends + MIDDLE_AISLE * (link.sided == "aisle"), ahead
        yield ahead * hung * bool(link.rows or looking), ahead  # what they watch may be at any wall


def _beside_a_bed(wishes: RoomWishes, bed: NamedThing) -> float:
    """Return metres of a row that lie between one bed and the next: what each has or is said to have beside it, and a way."""
    links = (k for k in wishes.reading.parsed.links if k.relation in ("next", "with", "left", "right", "flank"))
    own = {wishes.kind(m.thing) for k in links if bed in named(k.objects) for m in k.subjects}
    kinds = [wishes.kinds[name] for name in {*own, *wishes.room.person} - {wishes.kind(bed)}]
    return BETWEEN_BEDS + sum(
        kind.size[1] for kind in kinds if kind.on_floor and not kind.name.endswith(("bed", "desk"))
    )


def possible(wishes: RoomWishes, wished: Mapping[str, int], size: tuple[float, float]) -> None:
    """Refuse wishes that no arrangement can meet."""
    there, need = wishes.floor(size), wishes.floor_area(wished)
    if need > SIZES.fullest * there:
        things = ", ".join(f"{count} x {name}" for name, count in wished.items())
        raise SceneError(
            f"{things} need {need:.1f} m2 of floor, and a room of {size[0]:g} x {size[1]:g} m has {there:.1f} m2, of which "
            f"{SIZES.fullest:.0%} can be furnished; ask for a room of at least {math.ceil(need / SIZES.fullest)} m2 or for fewer things."
        )
    for name in wished:
        kind = wishes.kinds[name]
        if kind.on_floor and (max(kind.size[:2]) > max(size) or min(kind.size[:2]) > min(size)):
            raise SceneError(
                f"a {name} of {kind.size[0]:g} x {kind.size[1]:g} m does not fit into a room of {size[0]:g} x {size[1]:g} m; "
                "ask for a larger room or leave it out."
            )


def rows_ahead(rows: int, depth: float, aisle: float = SIZES.between) -> float:
    """Return how many metres so many rows of things of a depth take with the floor before and behind them."""
    return rows * (depth + aisle) + SIZES.around + SIZES.before


def depth_before_a_board(wishes: RoomWishes, link: Link) -> float:
    """Return how many metres deep told rows are that look at a board, with the floor before and behind them; 0 for others."""
    line = [mention for mention in link.subjects if mention.thing.category.on_floor]
    roles = [wishes.role(wishes.kind(mention.thing)) for mention in line]
    looking = any(role is not None and "board" in role.face.roles for role in roles)
    return max((ahead for _, ahead in _in_rows(wishes, link, line, set())), default=0.0) if looking else 0.0
