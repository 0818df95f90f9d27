"""The planner without a model: knowledge about rooms as data, program text as the answer."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from robolayout.assets import CATALOGUE
from robolayout.planners._asked import asked_lines, join_as_asked
from robolayout.planners._knowledge import SLOTS, Knowledge, load_knowledge
from robolayout.planners._roles import Cast, cast_scene, chain, passage
from robolayout.planners._said import seated_in_rows
from robolayout.planners._types import Group, PlanRequest
from robolayout.planners._write import Writer
from robolayout.scene import Asset, Room, Scene, Wall


class OfflinePlanner:
    """Plans rooms from the knowledge files, without a model, a key or a network.

    Args:
        knowledge: Files of your own, read after the built-in ones; their roles replace those of the same name.
    """

    def __init__(self, knowledge: Iterable[str | Path] = ()) -> None:
        self.knowledge: Knowledge = load_knowledge(Path(path) for path in knowledge)

    def __repr__(self) -> str:
        return f"<offline planner with {len(self.knowledge.roles)} roles in {len(self.knowledge.groups)} groups>"

    def recognised(self, scene: Scene) -> Scene:
        """Return a scene whose assets of the user's own kinds say what they are like and from where they are used."""
        return replace(scene, assets=tuple(self._recognised(asset) for asset in scene.assets))

    def _recognised(self, asset: Asset) -> Asset:
        found = None if asset.like else self.knowledge.recognised(asset)
        if found is None:
            return asset
        sides = asset.use_sides
        if sides is None and found.use_sides != CATALOGUE[found.like].use_sides:
            sides = found.use_sides
        return replace(asset, like=found.like, use_sides=sides, parts=asset.parts or found.parts)

    def group(self, scene: Scene) -> tuple[Group, ...]:
        """Return all assets in groups, structural first, decorative last.

        What joins another thing belongs to that thing's group, so that a night stand is never planned before its bed.
        """
        cast = cast_scene(scene, self.knowledge)
        roles = {name: _owner(name, cast).role for name in cast}
        heads = {self.knowledge.groups[role.group] for role in roles.values()}
        order = sorted(cast, key=lambda n: (len(chain(n, cast)), cast[n].role.rank, roles[n].rank))
        found: list[Group] = []
        for head in sorted(heads, key=lambda head: (head.order, head.label)):
            items = tuple(name for name in order if roles[name].group == head.label)
            joined = (cast[name] for name in items if cast[name].anchor)
            relations = tuple(f"{one.name} {SLOTS[one.join.slot]} {one.anchor}" for one in joined)
            found.append(Group(head.label, head.why, items, relations))
        return tuple(found)

    def plan(self, request: PlanRequest) -> str:
        """Return program text for the request: statements and wishes; where things stand is left to the solver."""
        scene, known = request.scene, set(request.placed or ())
        cast = seated_in_rows(cast_scene(scene, self.knowledge), request.asked, self.knowledge.roles["audience seat"])
        cast = join_as_asked(cast, request.asked, passage(scene))
        about = set(request.group.items) if request.group else set(cast)
        writer = Writer(scene, cast, request.asked)
        names = {written: name for name, written in scene.expressions.items()}
        text = ["# Walls: " + "; ".join(_wall(wall, scene.room) for wall in scene.room.walls)]
        asked = asked_lines(scene, request.asked, about | known)
        user = [(f"{line}  # asked by the user", subject) for line, subject in asked.items()]
        label, told, topics = "", set[str](), set(map(_topic, asked))
        for name in (name for name in writer.order() if name in about - known):
            group = self.knowledge.groups[_owner(name, cast).role.group]
            if group.label != label:
                label = group.label
                said = [label] if label in told else [label, group.why]
                text += ["", f"# {': '.join(' '.join(one.split()) for one in said)}"]  # nothing leaves its comment line
                told.add(label)
            text += [line for line, subject in user if subject == name]
            for line in writer.lines(name):
                there = {names[written] for written in re.findall(r"\w+\[\d+\]", line) if written in names}
                if line not in asked and about & there and there <= about | known:
                    # what the user asks for in other figures is only wished for
                    text.append(line.replace("solver.", "solver.wish.", 1) if _topic(line) in topics else line)
        if request.group is None:  # of what has its place already only what the user asks for is said
            text += [line for line, subject in user if subject in known]
        return "\n".join(text) + "\n"


def _owner(name: str, cast: Mapping[str, Cast]) -> Cast:
    """Return what an asset stands at in the end: itself, or the last of the things that it joins."""
    return cast[chain(name, cast)[-1]]


def _wall(wall: Wall, room: Room) -> str:
    """Return a wall in words for a comment: its number, length and openings."""
    openings = (("door", room.doors), ("window", room.windows))
    extras = [word for word, there in openings if any(one.wall == wall.index for one in there)]
    return f"walls[{wall.index}], {wall.length:.2f} m" + (f", with {' and '.join(extras)}" if extras else "")


def _topic(line: str) -> str:
    """Return relation and first two arguments of a line: what a program may demand once."""
    return ",".join(line.split(",")[:2]).rstrip(")")
