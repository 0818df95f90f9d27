"""The planner without a model: knowledge about rooms as data, program text as the answer."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from robolayout.planners._asked import asked_lines, cornered, join_as_asked, subjects
from robolayout.planners._knowledge import Knowledge, load_knowledge
from robolayout.planners._own import own_sides
from robolayout.planners._roles import cast_scene, passage
from robolayout.planners._types import Group, PlanRequest
from robolayout.planners._write import Writer, mentioned, wall_words
from robolayout.planners.grouping import group_cast, root
from robolayout.scene import Asset, Scene


class OfflinePlanner:
    """Plans rooms from the knowledge files, without a model, a key or a network.

    Args:
        knowledge: Files of your own, read after the built-in ones; their roles replace those of the same name.
    """

    def __init__(self, knowledge: Iterable[str | Path] = ()) -> None:
        self.knowledge: Knowledge = load_knowledge(Path(path) for path in knowledge)

    def __repr__(self) -> str:
        return f"<offline planner with {len(self.knowledge.roles)} roles in {len(self.knowledge.orders)} groups>"

    def recognised(self, scene: Scene) -> Scene:
        """Return a scene whose assets of the user's own kinds say what they are like and from where they are used."""
        return replace(scene, assets=tuple(self._recognised(asset) for asset in scene.assets))

    def _recognised(self, asset: Asset) -> Asset:
        found = None if asset.like else self.knowledge.recognised(asset)
        if found is None:
            return asset
        sides = own_sides(found) if asset.use_sides is None else asset.use_sides
        return replace(asset, like=found.like, use_sides=sides, parts=asset.parts or found.parts)

    def group(self, scene: Scene) -> tuple[Group, ...]:
        """Return all assets in groups, structural first, decorative last."""
        return group_cast(cast_scene(scene, self.knowledge), self.knowledge)

    def plan(self, request: PlanRequest) -> str:
        """Return program text for the request: statements and wishes; where things stand is left to the solver."""
        scene, known = request.scene, set(request.placed or ())
        cast = join_as_asked(cast_scene(scene, self.knowledge), request.asked, passage(scene))
        about = set(request.group.items) if request.group else set(cast)
        writer = Writer(
            scene,
            cast,
            frozenset(name for demand in request.asked for name in subjects(demand)),
            frozenset(name for demand in request.asked for name in cornered(demand)),
        )
        text = ["# Walls: " + "; ".join(wall_words(wall, scene) for wall in scene.room.walls)]
        asked = asked_lines(scene, request.asked, about | known)
        label, told, topics = "", set[str](), set(map(_topic, asked))
        for name in (name for name in writer.order() if name in about - known):
            role = cast[root(cast, name)].role
            if role.group != label:
                label = role.group
                why = "" if label in told else f": {_one_line(self.knowledge.reasons[label])}"
                text += ["", f"# {_one_line(label)}{why}"]
                told.add(label)
            text += [f"{line}  # asked by the user" for line, subject in asked.items() if subject == name]
            own = (line.text for line in mentioned(list(writer.lines(name)), about, known))
            text += [_wished(line) if _topic(line) in topics else line for line in own if line not in asked]
        return "\n".join(text) + "\n"


def _topic(line: str) -> str:
    """Return relation and first two arguments of a line: what a program may demand once."""
    return ",".join(line.split(",")[:2]).rstrip(")")


def _wished(line: str) -> str:
    """Return as a wish what the user asks for in other figures."""
    return line.replace("solver.", "solver.wish.", 1)


def _one_line(text: str) -> str:
    """Return text that cannot leave its comment line."""
    return " ".join(text.split())
