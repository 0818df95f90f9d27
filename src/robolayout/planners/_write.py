"""From places to program text: guesses, and the statements that the knowledge says follow from them.

Only names from the scene's variables, numbers and the templates of the knowledge files enter the text; descriptions never do.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

from robolayout.constraints import Relation
from robolayout.planners._member import GridPlan, Member, Size, box_of
from robolayout.planners._roles import Cast
from robolayout.planners._site import Site, Spot, along_wall
from robolayout.program import Program
from robolayout.scene import Scene, Wall


@dataclass(frozen=True)
class Line:
    """One statement of the program and the assets that it is about, its subject first."""

    text: str
    names: tuple[str, ...]


def guess_lines(site: Site, name: str) -> list[str]:
    """Return the two lines that set an asset's initial place and heading."""
    member, height = site.spots[name].member, site.size(name)[2]
    label = site.scene.expressions[name]
    degrees = round(math.degrees(member.yaw) % 360.0, 1) % 360.0
    position = ", ".join(f"{round(value, 3):g}" for value in (member.x, member.y, member.bottom + height / 2))
    return [f"{label}.position = [{position}]", f"{label}.rotation = [{degrees:g}]"]


def asked_lines(scene: Scene, ways: Sequence[tuple[Sequence[Relation], bool]]) -> list[str]:
    """Return what the user's words ask as statements, each once."""
    program = Program(expressions=scene.expressions)
    return list(dict.fromkeys(f"solver.{program.call(relation)}" for way, _ in ways for relation in way))


class StatementWriter:
    """Fills the statement templates of the knowledge for a furnished site.

    Args:
        site: Where everything is.
    """

    def __init__(self, site: Site) -> None:
        self.site = site
        self.cast: Mapping[str, Cast] = site.cast

    def lines(self) -> list[Line]:
        """Return all statements, asset by asset in the order of placing; sets of assets speak with their last one."""
        found: list[Line] = []
        for name in self.site.spots:
            found += self._alone(name)
            found += self._together(name)
        return found

    def _alone(self, name: str) -> Iterator[Line]:
        """Yield what is said about one asset."""
        spot, item = self.site.spots[name], self.cast[name]
        if spot.mode == "given":
            return
        templates = item.joined.say if spot.mode == "join" and item.join else item.role.say.get(spot.mode, ())
        yield from self._fill(templates, self._values(name), name)
        face = item.role.face
        target = spot.anchor or self._faced(name)
        if face and target and spot.mode != "join" and self.cast[target].role.name in face.roles:
            yield from self._fill(face.say, {**self._values(name), **self._about(name, target)}, name)

    def _faced(self, name: str) -> str | None:
        """Return what an asset ended up facing (or turning its back to), if anything near its axis."""
        face, here = self.cast[name].role.face, self.site.spots[name].member
        for role in face.roles if face else ():
            for other, spot in self.site.spots.items():
                if self.cast[other].role.name == role and other != name:
                    dx, dy = spot.member.x - here.x, spot.member.y - here.y
                    turn = here.yaw + (0.0 if face and face.how == "toward" else math.pi)
                    away = math.hypot(dx, dy)
                    low, high = face.distance if face else (0.0, 0.0)
                    ahead = dx * math.cos(turn) + dy * math.sin(turn)
                    if ahead > 0.9 * away and low - 0.3 <= away <= high + 0.3:
                        return other
        return None

    def _together(self, name: str) -> Iterator[Line]:
        """Yield what is said about a set of assets, once its last one is placed."""
        spot, item = self.site.spots[name], self.cast[name]
        if spot.grid is not None and spot.grid.names[-1] == name:
            yield from self._grid(spot.grid)
        if spot.mode != "join" or item.join is None or item.anchor is None:
            return
        peers = [
            other
            for other, s in self.site.spots.items()
            if s.mode == "join" and self.cast[other].anchor == item.anchor and self.cast[other].role is item.role
        ]
        if peers[-1] != name:
            return
        values = self._values(peers[0]) | {"items": self._list(peers)}
        yield from self._fill(item.join.all, values, *peers)
        for first, second in self._pairs(peers):
            values = self._values(first) | {"a2": self.site.scene.expressions[second]}
            yield from self._fill(item.join.pair, values, first, second)

    def _pairs(self, peers: Sequence[str]) -> Iterator[tuple[str, str]]:
        """Yield pairs on opposite sides of their anchor and of the same size."""
        left = [n for n in peers if self.site.spots[n].member.side == "left"]
        right = [n for n in peers if self.site.spots[n].member.side == "right"]
        for first, second in zip(left, right, strict=False):
            if self.site.size(first) == self.site.size(second):
                yield first, second

    def _grid(self, plan: GridPlan) -> Iterator[Line]:
        """Yield the statements of a block: one grid, or rows that stand back to back; its first thing has a heading."""
        yield Line(f"solver.align_with({self._name(plan.names[0])}, {self._straight(plan.names[0])})", (plan.names[0],))
        if not plan.paired:
            items = self._list(plan.names)
            text = f"solver.grid({items}, {plan.rows}, {plan.columns}, aisle={plan.aisle:g}, gap={plan.gap:g})"
            yield Line(text, plan.names)
            return
        rows = [plan.names[i : i + plan.columns] for i in range(0, len(plan.names), plan.columns)]
        for number, names in enumerate(rows):
            if number:
                yield from self._next_row(plan, number, names[0], rows[number - 1][0])
            if len(names) > 1:
                in_order = names[::-1] if number % 2 else names
                yield Line(f"solver.row({self._list(in_order)}, gap={plan.gap:g})", in_order)

    def _next_row(self, plan: GridPlan, number: int, head: str, before: str) -> Iterator[Line]:
        """Yield how the first thing of a row stands to the first thing of the row before, to which it is turned round."""
        here, there, names = self._name(head), self._name(before), (head, before)
        yield Line(f"solver.align_with({here}, {there}, 180)", names)
        if number % 2:
            yield Line(f"solver.behind({here}, {there}, 0, 0.1)", names)
        else:
            yield Line(f"solver.in_front_of({here}, {there}, {plan.aisle - 0.1:g}, {plan.aisle + 1:g})", names)

    def _name(self, name: str) -> str:
        return self.site.scene.expressions[name]

    def _straight(self, name: str) -> str:
        """Return the longest wall and the angle to it, as the last two arguments of `align_with`."""
        wall = max(self.site.room.walls, key=lambda w: (round(w.length, 3), -w.index))
        angle = math.degrees(self.site.spots[name].member.yaw - math.atan2(wall.direction[1], wall.direction[0]))
        return f"walls[{wall.index}], {round(angle % 360.0, 1) % 360.0:g}"

    def _list(self, names: Sequence[str]) -> str:
        return "[" + ", ".join(self.site.scene.expressions[name] for name in names) + "]"

    def _fill(self, templates: Sequence[str], values: Mapping[str, str], *names: str) -> Iterator[Line]:
        """Yield the filled templates; one that needs a missing value is left out, "else" follows a left-out one."""
        skipped = False
        for template in templates:
            otherwise = template.startswith("else ")
            if otherwise and not skipped:
                continue
            text = template.removeprefix("else ")
            needed = [key for key in _keys(text) if not values.get(key)]
            skipped = bool(needed)
            if not needed:
                about = [values[f"{key} name"] for key in ("b", "seat") if f"{{{key}}}" in text]
                yield Line(f"solver.{text.format_map(values)}", tuple(dict.fromkeys((*names, *about))))

    def _values(self, name: str) -> dict[str, str]:
        """Return everything that a template may name for an asset."""
        spot, item = self.site.spots[name], self.cast[name]
        values = {
            "a": self.site.scene.expressions[name],
            "wall": "" if spot.wall is None else f"walls[{spot.wall}]",
            "side": f'"{spot.member.side}"' if spot.member.side in ("left", "right", "front", "back") else "",
            "height": f"{spot.member.bottom + self.site.size(name)[2] / 2:.2f}",
            "straight": self._straight(name),
            "vertex": str(self._vertex(spot)),
            "depth": f"{max(item.category.open_depth, 0.5):g}",
        }
        anchor = spot.anchor or (item.anchor if spot.mode == "join" else None)
        if anchor is not None:
            values |= self._about(name, anchor)
        seat = spot.member.side
        if seat in self.site.spots:
            values |= {"seat": self.site.scene.expressions[seat], "seat name": seat}
        return values

    def _about(self, name: str, other: str) -> dict[str, str]:
        """Return what a template may say about an asset and the one it stands at."""
        here, there, join = self.site.spots[name], self.site.spots[other], self.cast[name].join
        distance = math.hypot(here.member.x - there.member.x, here.member.y - there.member.y)
        angle = math.degrees(here.member.yaw - there.member.yaw) % 360.0
        gap = _edge_gap(here.member, self.site.size(name), there.member, self.site.size(other))
        tucked = join is not None and join.slot in ("front", "around") and gap < -0.01
        ahead = distance - (self.site.size(name)[0] + self.site.size(other)[0]) / 2
        return {
            "b": self.site.scene.expressions[other],
            "b name": other,
            "bwall": "" if there.wall is None or not self._reaches(here, there.wall) else f"walls[{there.wall}]",
            "near": f"{max(0.0, distance - 0.15):.2f}",
            "far": f"{distance + 0.15:.2f}",
            "gap": f"{gap if tucked else join.gap if join else 0.05:.3g}",
            "least": f"{gap - 0.1 if tucked else max(0.0, gap - 0.1):.2f}",
            "most": f"{max(gap, 0.0) + 0.15:.2f}",
            "angle": f"{round(angle, 1) % 360.0:g}",
            "ahead low": f"{max(0.0, ahead - 0.3):.1f}",
            "ahead high": f"{ahead + 0.3:.1f}",
        }

    def _reaches(self, spot: Spot, wall: int) -> bool:
        """Whether a thing stands before a wall, not past its end."""
        segment = self.site.room.walls[wall]
        span = along_wall(spot.member, self.site.size(spot.member.name), segment)
        return span is not None and span[0] < segment.length - 0.05 and span[1] > 0.05

    def _vertex(self, spot: Spot) -> int:
        """Return the room corner nearest to a spot."""
        here = (spot.member.x, spot.member.y)
        return min(range(len(self.site.room.vertices)), key=lambda i: math.dist(self.site.room.vertices[i], here))


def _edge_gap(a: Member, a_size: Size, b: Member, b_size: Size) -> float:
    """Return the gap in metres between two boxes along the axis of b on which they are further apart."""
    c, s = math.cos(b.yaw), math.sin(b.yaw)
    dx, dy = a.x - b.x, a.y - b.y
    left, bottom, right, top = box_of(Member("", c * dx + s * dy, c * dy - s * dx, a.yaw - b.yaw), a_size)
    return max(left - b_size[0] / 2, -b_size[0] / 2 - right, bottom - b_size[1] / 2, -b_size[1] / 2 - top)


def _keys(text: str) -> list[str]:
    return [part.split("}")[0] for part in text.split("{")[1:]]


def mentioned(lines: Sequence[Line], subjects: Collection[str], known: Collection[str]) -> list[Line]:
    """Return the statements that are about `subjects` and name nothing but those and `known` assets."""
    fresh, there = set(subjects), set(subjects) | set(known)
    return [line for line in lines if fresh.intersection(line.names) and there.issuperset(line.names)]


def wall_words(wall: Wall, scene: Scene) -> str:
    """Return a wall in words for a comment: its number, length and openings."""
    extras = [
        word
        for word, openings in (("door", scene.room.doors), ("window", scene.room.windows))
        if any(o.wall == wall.index for o in openings)
    ]
    return f"walls[{wall.index}], {wall.length:.2f} m" + (f", with {' and '.join(extras)}" if extras else "")
