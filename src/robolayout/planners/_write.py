"""From roles to program text: what is demanded of each thing, and what it would like. Where things stand is not said.

Only names from the scene's variables, numbers and the templates of the knowledge files enter the text; descriptions never do.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from robolayout.assets import surfaces_of
from robolayout.planners import _said as asked
from robolayout.planners._knowledge import DATA, Face
from robolayout.planners._roles import Cast, chain, passage
from robolayout.scene import Scene
from robolayout.words import Demand, rows_of


@dataclass(frozen=True)
class Saying:
    """What is demanded and what is wished, and how much."""

    shallow: float = -4.0  # weight of a board's wall before which not as many rows fit as are asked
    first: float = 0.6
    only: float = 8.0
    """Weights of the first of several ways of standing, where the middle of the room is as good and where it is a last resort."""
    straight: float = 2.0
    apart: float = 4.0
    """Weights of two groups of like things that are told: of standing straight to the other one, and apart from it."""
    joined: float = 1.0  # weight of standing at what a thing joins, where it may stand elsewhere
    middle: float = 3.0  # weight of standing right in the middle of the room, where the words ask something to be there
    before: tuple[float, float] = (1.2, 4.0)  # metres between who speaks and the middle of the first row that listens
    within: float = 0.06
    beyond: float = 0.15
    """Metres by which a gap may be smaller and larger than what is usual."""
    walls: float = 0.45  # share of the length of all walls up to which places at them are demanded; what comes later only wishes for one
    under: float = 0.2  # metres by which a seat may be left under what it stands at
    knees: float = 0.4  # metres that stay clear before a seat at a wall
    large: float = 40.0
    along_walls: float = 1.6
    """Square metres from which on a room is furnished through its middle, and metres along its walls that are not its middle."""
    small: int = 44  # rank from which on things are placed after those of which the user says where they stand


SAYING = Saying()


class Writer:
    """Writes what the knowledge says of a cast, with what the user's words ask of it."""

    def __init__(self, scene: Scene, cast: Mapping[str, Cast], words: Sequence[Demand]) -> None:
        self.scene, self.cast = scene, cast
        self.asked = asked.subjects(words)  # of these roles only wish where they stand
        self.ringed, self.audience = asked.ringed(cast, words), asked.audience(cast, words)
        self.rowed, self.groups = asked.rowed(words), asked.in_blocks(words)
        # before their corner, the wall for all of a row or the floor of a ring is taken
        self.first = asked.needing_room(cast, words) | self.ringed.keys()
        self.walled, self.formed = asked.held_by_walls(words), asked.formed(words)
        places = [(one.name, one.asset_names()[0]) for one in asked.said(words)]
        self.cornered, self.leaned = ({n for how, n in places if how == at} for at in ("corner", "against_wall"))
        self.looked, self.watching = asked.looked_at(words), asked.watching(cast, words)
        self.below = asked.hung_over(scene, words)  # nothing else hangs there
        self.hung = asked.hung(words)
        self.over = {high for high, _ in self.hung}  # they hang nowhere else
        self.middle, self.lain, self.beside = asked.in_the_middle(words), asked.lain_at(words), asked.open_beside(words)
        self.shallow = asked.too_shallow(scene, words)

    def order(self) -> list[str]:
        """Return all assets, what is placed first first: low ranks, big things, and what joins a thing right after it."""
        seen = {name for one in self.cast.values() for name in self._faces(one)}
        return sorted(self.cast, key=lambda name: self._turn(name, seen))

    def _turn(self, name: str, seen: Collection[str]) -> tuple[object, ...]:
        top = self.cast[chain(name, self.cast)[-1]]
        hung = top.asset.on_wall and not top.asset.on_floor
        before = [one.role.rank for one in self.cast.values() if hung and one.anchor == top.name and one.asset.on_floor]
        rank = min([top.role.rank, *before])  # a mirror is hung when its chair has its turn
        hangs = bool(self.asked) and hung and not before and top.name not in seen
        late = (hangs or rank >= SAYING.small) and top.name not in self.asked
        turn = (rank, top.name not in self.asked, -top.asset.size[0] * top.asset.size[1], top.name)
        return (top.name not in self.first, late, *turn, name != top.name, self.cast[name].role.rank)

    def lines(self, name: str) -> Iterator[str]:
        """Yield what is said of one asset; sets of assets speak with their last one."""
        item = self.cast[name]
        if item.anchor:
            yield from self._joined(item)
        if not item.anchor or (item.join.loose and item.asset.on_floor):
            yield from self._standing(item)
            yield from () if name in self.ringed or name in self.watching else self._wishes(item)
        yield from self._cleared(item)
        yield from self._faced(item)

    # at something else

    def _joined(self, item: Cast) -> Iterator[str]:
        join, weight = item.join, SAYING.joined if item.join.loose else None
        values = self._values(item) | self._about(item)
        yield from self._fill(join.say, values, weight)
        yield from self._fill(DATA["at"].get(join.slot, {}).get(join.at, ()), values, 1.0)
        # a chair that is told to be at an end is none of those around
        peers = [name for name in self._peers(item) if self.cast[name].join.slot == join.slot]
        if peers[-1] == item.name:
            yield from self._fill(join.all, values | {"items": self._list(peers)}, weight)
            for first, second in zip(peers[::2], peers[1::2], strict=False):
                if self.scene.by_name[first].size == self.scene.by_name[second].size:
                    pair = values | {"a": self._name(first), "a2": self._name(second)}
                    yield from self._fill(join.pair, pair, weight)

    def _peers(self, item: Cast) -> list[str]:
        """Return what joins the same thing in the same role, in order."""
        return [n for n, one in self.cast.items() if one.anchor == item.anchor and one.role is item.role]

    def _about(self, item: Cast) -> dict[str, str]:
        """Return what a template may say about an asset and the one that it joins."""
        join, anchor = item.join, self.cast[item.anchor]
        number = self._peers(item).index(item.name)
        tucked = item.category.movable and join.slot in ("front", "behind")
        values = {
            "b": self._name(anchor.name),
            "side": f'"{self.beside.get(anchor.name, "beside")}"',
            "gap": f"{join.gap:g}",
            "least": f"{-SAYING.under if tucked else max(0.0, join.gap - SAYING.within):g}",
            "most": f"{join.gap + SAYING.beyond + self._taken(item):.2f}",
        }
        turned = {"front": 180.0, "behind": 0.0, "beside": 0.0}.get(join.slot)
        if turned is not None:
            away = 180.0 if join.faces == "away" else 0.0
            values["angle"] = f"{0.0 if join.faces == 'same' else (turned + away) % 360.0:g}"
        guests = [one for one in self.cast.values() if one.anchor == anchor.name]
        seats = [one.name for one in guests if one.role.name.endswith("seat")]
        plates = [one.name for one in guests if one.join.at == "plate"]
        found = {key: self._name(n) for key, names in (("seat", seats), ("p", plates)) for n in names[number:][:1]}
        return values | found

    def _taken(self, item: Cast) -> float:
        """Return metres that others may take between a thing and what it stands beside."""
        guests = (one for one in self.cast.values() if one.anchor == item.anchor)
        others = [one for one in guests if one.join.slot == item.join.slot == "beside"]
        rank = others.index(item) if others else 0
        return sum((o.asset.size[1] + o.join.gap for o in others[: rank // 2 * 2 : 2]), 0.0)

    # by itself

    def _standing(self, item: Cast) -> Iterator[str]:
        """Yield how a thing stands by itself: demanded where its role leaves no other way, else wished."""
        modes, name = _modes(item), item.name
        values, say = self._values(item), item.role.say
        bound = SAYING.joined if self._leans(item) or name in self.asked else None
        if name in self.ringed:
            yield from self._in_a_ring(name)
        elif name in self.watching or name in self.audience:
            if name in self.looked and name in self.watching:
                at = f"{self._name(name)}, {self._name(self.watching[name])}"
                yield f"solver.distance_constraint({at}, {SAYING.before[0]:g}, {SAYING.before[1]:g})"
                yield _wish(f'centered_on({at}, "side")')
            if name in self.audience[-1:]:
                rows = rows_of(len(self.audience))
                yield f"solver.in_rows({self._list(self.audience)}, aisle=0, rows={rows})"
        elif modes[0] in ("hang", "ceiling", "rug"):
            yield from self._off_the_floor(item, modes[0])
        elif modes == ["corner"]:
            yield from self._fill(say["corner"], values, bound)
        elif modes[0] == "wall" and self._behind_a_seat(item):
            yield from self._fill(say["wall"], values)
        elif set(modes) <= {"wall", "corner"}:
            free = bound is not None and (self._leans(item) or name not in self.walled)
            held = item.role.name == "toilet" or (name in self._held and not free)  # its drain is there
            yield from self._fill(say["wall"], values, None if held else SAYING.only)
        else:
            yield from self._fill(say["middle"], values, bound)
            open_floor = {"middle", "facing"} & set(modes) and "grid" not in modes
            weight = (SAYING.first if open_floor else SAYING.only) + item.role.prefer.get("first", 0.0)
            equal = self._in_the_middle(item) if "grid" in modes else []
            if "wall" in modes:
                few = len(self._equal(item)) < item.role.prefer.get("block", math.inf)
                first = modes[0] == "wall" and (name not in equal or (few and len(equal) == len(self._equal(item))))
                first = first and name not in self.rowed
                yield from self._fill(say["wall"], values, weight if first else -weight)
            yield from self._in_rows(item, equal)

    def _in_a_ring(self, name: str) -> Iterator[str]:
        """Yield that seats stand in a ring on their rug, with the last of them; where the rug is asked into the middle, there."""
        rug, ring = self.ringed[name]
        if rug in self.middle:
            yield _wish(f"centered_on({self._name(name)}, room)", SAYING.middle)
        if ring.asset_names()[-1] == name:
            yield _wish(f"in_shape({self._list(ring.asset_names())})", SAYING.first)

    @cached_property
    def _held(self) -> frozenset[str]:
        """What the walls hold for certain, in the order of placing."""
        left = SAYING.walls * sum(wall.length for wall in self.scene.room.walls)
        found = list[str]()
        for name in self.order():
            item = self.cast[name]
            if item.asset.on_floor and not item.asset.is_flat and set(_modes(item)) <= {"wall", "corner"}:
                left -= item.asset.size[1]
                found += [name] if left >= 0.0 and not self._leans(item) and _modes(item) == ["wall"] else []
        return frozenset(found)

    def _behind_a_seat(self, item: Cast) -> bool:
        """Return whether a thing is asked behind who sits: at the wall there, as people mean it."""
        behind = item.join.slot == "behind" and item.name in self.asked
        return behind and any(top.is_seat for top in surfaces_of(self.cast[item.anchor].asset))

    def _leans(self, item: Cast) -> bool:
        """Return whether a thing has its place from what it joins: all but what is asked beside a thing that it never stands beside."""
        beside = item.join.slot == "beside" and not item.role.stands_beside(self.cast[item.anchor].role.name)
        return bool(item.anchor) and not beside

    def _playing(self, *roles: str) -> list[str]:
        """Return what plays some roles, in their order."""
        return [n for role in roles for n, one in self.cast.items() if one.role.name == role]

    def _equal(self, item: Cast) -> list[str]:
        """Return what stands by itself in the same role."""
        return [n for n, one in self.cast.items() if one.role is item.role and not one.anchor]

    def _in_the_middle(self, item: Cast) -> list[str]:
        """Return which of some equal things stand in rows: all; in large rooms only those that the walls leave to the middle."""
        equal = self._equal(item)
        if len(equal) >= item.role.prefer.get("block", math.inf):
            return equal
        x0, y0, x1, y1 = self.scene.room.bounds
        inner = (x1 - x0 - 2 * SAYING.along_walls) * (y1 - y0 - 2 * SAYING.along_walls) / ((x1 - x0) * (y1 - y0))
        count = 2 * round(len(equal) * inner / 2)
        large = self.scene.room.area >= SAYING.large and min(count, len(equal) - count) > 3
        return equal[-count:] if large and _modes(item)[0] == "wall" else equal

    def _in_rows(self, item: Cast, equal: Sequence[str]) -> Iterator[str]:
        """Yield that equal things stand in rows, with the last of them; two groups that are told stand straight to each other."""
        alike = {*self._equal(item)}
        groups = [group for group in self.groups if {*group} <= alike]
        two = len(groups) == 2 and not {*groups[0]} & {*groups[1]}
        if two and any(item.name in group for group in groups):
            other = next(group for group in groups if item.name not in group)[0]
            yield _wish(f"align_with({self._name(item.name)}, {self._name(other)})", SAYING.straight)
            yield _wish(f"grouped({self._name(item.name)}, {self._list([other])})", -SAYING.apart)
        if not two and len(equal) > 1 and equal[-1] == item.name:
            prefer, open_way = item.role.prefer, passage(self.scene)
            aisle, gap = prefer.get("aisle", open_way), prefer.get("gap", open_way)
            backs = ', backs="paired"' if prefer.get("paired", 0) > 0 else ""
            yield _wish(f"in_rows({self._list(equal)}, {aisle:g}, {gap:g}{backs})", SAYING.first)

    def _off_the_floor(self, item: Cast, mode: str) -> Iterator[str]:
        """Yield where a thing hangs or lies."""
        a, values, over = self._name(item.name), self._values(item), self._under(item)
        owner = self._owners.get(item.name)
        if mode == "ceiling" and item.name in self.over:
            return  # the lamps over a bar are none of the tables'
        told = item.name in {*self.asked, *self.below, *(rug for rug, _ in self.ringed.values())}
        if told and not (mode == "rug" and owner and self._lies_below(item, owner)):
            owner = None
        if owner is not None:
            values["b"] = self._name(owner)
            alike = (n for n, one in self.cast.items() if one.role is item.role and n != item.name)
            if mode == "ceiling" and any(self._owners.get(n) == owner for n in alike):
                yield f"solver.above({a}, {values['b']})"
                return
            if mode == "rug":
                yield from self._fill(DATA["at"]["rug"].get(self.cast[owner].role.name, ()), values, 1.0)
                values["b"] = ", ".join(map(self._name, (owner, *self._opposite(owner))))
        yield from self._fill(item.role.say[mode], values, SAYING.joined if item.name in self.formed else None)
        if mode == "hang" and (high := item.role.hung(item.asset.size[2])):
            yield _wish(f"mounted_on({a}, None, {high:g})")
        if mode == "hang" and over and item.name not in self.over:
            yield _wish(_either([f"above({a}, {self._name(n)})" for n in over]))
        alone = [low for high, low in self.hung if high == item.name and [one for _, one in self.hung].count(low) == 1]
        yield from (_wish(f'centered_on({a}, {self._name(low)}, "side")') for low in alone if mode == "hang")
        if mode == "ceiling" and owner is None:
            yield _wish(f"centered_on({a}, room)")

    def _lies_below(self, rug: Cast, owner: str) -> bool:
        """Return whether a rug whose place is told lies below its owner: at what that joins, or in the middle of the room with it."""
        stands = _modes(self.cast[owner])[0] != "wall" and owner not in self.asked
        middle = stands and rug.name in self.middle - {name for name, _ in self.ringed.values()}
        return middle or self.cast[owner].anchor == self.lain.get(rug.name)

    def _opposite(self, name: str) -> list[str]:
        """Return what is joined to a thing of its own kind to face it."""
        alike = [one for one in self.cast.values() if one.role is self.cast[name].role]
        facing = [{one.name, one.anchor} for one in alike if one.join.faces == "anchor"]
        return [one.name for one in alike if one.name != name and {one.name, name} in facing]

    def _under(self, item: Cast) -> list[str]:
        """Return what a thing may hang over or lie under."""
        taken = self.below if _modes(item)[0] == "hang" else {}
        return [n for n in self._playing(*item.role.above) if taken.get(n, item.name) == item.name]

    @cached_property
    def _owners(self) -> Mapping[str, str]:
        """What things hang over or lie under: of the first with as few others as any, each rug another one."""
        taken, found = Counter[tuple[str, str]](), dict[str, str]()
        for name, one in self.cast.items():
            mode = _modes(one)[0]
            if mode == "ceiling" and name in self.over:
                continue
            free = [n for n in self._under(one) if not (mode == "rug" and taken[mode, n])]
            if free:
                found[name] = min(free, key=lambda n: taken[mode, n])
                taken[mode, found[name]] += 1
        return found

    # what it would like

    def _wishes(self, item: Cast) -> Iterator[str]:
        """Yield what a role prefers about the place of a thing."""
        prefer, room = dict(item.role.prefer), self.scene.room
        if _modes(item)[0] == "corner":
            prefer["corner"] = prefer.get("corner", 0.0) + SAYING.first
        if item.name in self.middle:
            prefer["middle"] = SAYING.middle
        if item.name in self.leaned and item.role.name.endswith("seat") and len(self._equal(item)) > 1:
            prefer.pop("corner", None)  # where two walls meet, the knees of one seat are before the next
        if len(self._equal(item)) > 1 and any(key.startswith("straight") for key in prefer):
            prefer.pop("centre", None)  # two beds share their wall
        longest = max(room.walls, key=lambda w: (round(w.length, 3), -w.index))
        values = {
            "a": self._name(item.name),
            "at_wall": "mounted_on" if _modes(item)[0] == "hang" else "against_wall",
            "longest": f"walls[{longest.index}]",
            "door": self._door,
        }
        for index in self.shallow if item.role.name == "board" else ():
            yield _wish(f"mounted_on({values['a']}, walls[{index}])", SAYING.shallow)
        there = {"window": bool(room.windows), "door": bool(room.doors), "straight": item.name not in self.asked}
        for key, weight in prefer.items():
            word, _, role = key.partition(" ")
            others = [n for n in self._playing(role) if n != item.name]
            if (others or not role) and there.get(word, True):
                away = word in ("door", "far")
                wished = DATA["prefer"].get(word, ())
                meant = {"others": self._list(others), "other": "".join(map(self._name, others[:1]))}
                yield from self._fill(wished, values | meant, -weight if away else weight)

    @cached_property
    def _door(self) -> str:
        """The first door, as a program says where it is."""
        at = [self.scene.room.walls[door.wall].point(door.center) for door in self.scene.room.doors[:1]]
        return "".join(f"AssetInstance(position=[{x:g}, {y:g}, 0.0])" for x, y in at)

    def _cleared(self, item: Cast) -> Iterator[str]:
        """Yield the sides that a thing wants clear, where its kind does not say it.

        A seat beside a thing is not pushed back, nor one that stands at a wall by itself: that has room for knees before it.
        """
        aside, seat = item.join.slot == "beside", item.role.name.endswith("seat") and not item.anchor
        at_a_wall = seat and (
            item.name in self.leaned or (item.name not in self.asked and item.role.stands[0] == "wall")
        )
        in_a_block = len(self._equal(item)) >= item.role.prefer.get("block", math.inf)
        for side, depth in item.role.clear.items() if item.asset.on_floor else ():
            if side == "back" and aside:
                continue
            if side == "back" and at_a_wall:
                side, depth = "front", SAYING.knees
            for one in (("left", "right") if not in_a_block else ()) if side == "side" else (side,):
                wide = depth if depth > 0 else passage(self.scene)
                yield _wish(f'keep_clear({self._name(item.name)}, "{one}", {wide:g})')

    def _faced(self, item: Cast) -> Iterator[str]:
        """Yield what a thing looks at."""
        face, a = item.role.face, self._name(item.name)
        names = [] if item.anchor and item.role.name == "seat" else self._faces(item)  # a chair looks at its table
        there = self.looked.get(item.name, "")
        elsewhere = there and not {there, self.cast[there].anchor} & {*names}  # a sofa that faces the piano
        if not names or elsewhere:
            return
        angle = "" if face.how == "toward" else ", 180"
        looks = [f"point_towards({a}, {self._name(n)}{angle})" for n in names]
        yield _wish(_either(looks), face.weight)
        before = [one for one in self.cast.values() if one.role.face.say and names[0] in self._faces(one)]
        if face.say and item.name not in self.asked and len(names) == 1 == len(before):
            told = [name for name, one in self.cast.items() if names[0] in (name, one.anchor) and name in self.cornered]
            yield from self._fill(face.say, self._values(item), SAYING.joined if told else None)  # "a TV in the corner"
        elif face.distance != Face.distance:
            yield from self._fill(["in_front_of({a}, {b}, {ahead low}, {ahead high})"], self._values(item), 1.0)

    def _faces(self, item: Cast) -> list[str]:
        """Return what a thing should face: all of the first role that is there, one each where it stands before them."""
        face, equal = item.role.face, self._equal(item)
        playing = ([n for n in self._playing(role) if n != item.name] for role in face.roles)
        found = next(filter(None, playing), [])
        if found and face.say and item.name in equal:
            return [found[equal.index(item.name) % len(found)]]
        return found

    # templates

    def _name(self, name: str) -> str:
        return self.scene.expressions[name]

    def _list(self, names: Iterable[str]) -> str:
        return f"[{', '.join(map(self._name, names))}]"

    def _values(self, item: Cast) -> dict[str, str]:
        """Return everything that a template may name for an asset by itself."""
        values = {
            "a": self._name(item.name),
            "wall": "None",
            "vertex": "None",
            "straight": "room",
            "height": f"{high:g}" if (high := item.role.hung(item.asset.size[2])) else "None",
            "depth": f"{max(item.category.open_depth, 0.5):g}",
        }
        for name in self._faces(item)[:1]:
            near, far = item.role.face.distance
            apart = (item.asset.size[0] + self.scene.by_name[name].size[0]) / 2
            low, high = round(max(0.0, near - apart), 2), round(max(0.1, far - apart), 2)
            ends = {"near": near, "far": far, "ahead low": low, "ahead high": high}
            values |= {"b": self._name(name)} | {k: f"{v:g}" for k, v in ends.items()}
        return values

    def _fill(self, templates: Iterable[str], values: Mapping[str, str], weight: float | None = None) -> Iterator[str]:
        """Yield the filled templates; one that needs a missing value is left out, "else" follows a left-out one."""
        skipped = False
        for template in templates:
            text = template.removeprefix("else ")
            if text == template or skipped:
                skipped = not all(values.get(key) for key in re.findall(r"\{(.*?)\}", text))
                if not skipped:
                    filled = text.format_map(values)
                    yield f"solver.{filled}" if weight is None else _wish(filled, weight)


def _wish(call: str, weight: float = 1.0) -> str:
    """Return a call as a wish, with its weight if it is not 1."""
    return f"solver.wish.{call[:-1]}{'' if weight == 1.0 else f', weight={weight:g}'})"


def _either(calls: Sequence[str]) -> str:
    """Return the call that says that one of several holds."""
    return calls[0] if len(calls) == 1 else f"any_of([{', '.join(f'solver.{call}' for call in calls)}])"


def _modes(item: Cast) -> list[str]:
    """Return the ways of standing that role and flags allow, best first."""
    asset, stands = item.asset, item.role.stands
    if asset.is_flat and "rug" in stands:
        return ["rug"]
    if asset.on_wall and ("hang" in stands or not asset.on_floor):
        return ["hang"]
    if asset.on_ceiling and not asset.on_floor:
        return ["ceiling"]
    return [mode for mode in stands if mode in ("wall", "corner", "middle", "facing", "grid")] or ["wall", "middle"]
