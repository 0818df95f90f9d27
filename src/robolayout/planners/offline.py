"""The planner without a model: knowledge about rooms as data, geometry as code, program text as the answer."""

from __future__ import annotations

import zlib
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from robolayout.planners._asked import Asked, join_as_asked
from robolayout.planners._furnish import furnish
from robolayout.planners._knowledge import Knowledge, load_knowledge
from robolayout.planners._own import own_sides
from robolayout.planners._roles import cast_scene
from robolayout.planners._site import Site
from robolayout.planners._types import Group, PlanRequest
from robolayout.planners._write import StatementWriter, asked_lines, guess_lines, mentioned, wall_words
from robolayout.planners.grouping import group_cast
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
        """Return program text for the request; other feedback leads to another room."""
        scene = request.scene
        seed = request.seed if not request.feedback else zlib.crc32(f"{request.seed} {request.feedback}".encode())
        asked = Asked.of(scene, request.asked)
        cast = join_as_asked(cast_scene(scene, self.knowledge), request.asked)
        placed = request.placed
        site = furnish(scene, cast, placed, seed, asked if request.asked else None)
        groups = (request.group,) if request.group else group_cast(cast, self.knowledge)
        return _text(site, groups, set(placed or ()), asked)


def _text(site: Site, groups: Iterable[Group], known: set[str], asked: Asked) -> str:
    """Write the program: what the user asks; per group a heading, the guesses, then the statements."""
    scene = site.scene
    text = ["# Walls: " + "; ".join(wall_words(wall, scene) for wall in scene.room.walls)]
    ways = asked.written({name: spot.member for name, spot in site.spots.items()})
    wishes = asked_lines(scene, ways)
    moved = {way[0].asset_names()[0] for way, holds in ways if not holds}
    lines = [line for line in StatementWriter(site).lines() if line.text not in wishes and line.names[0] not in moved]
    text += ["", "# What the user asks", *wishes] if wishes else []
    for group in groups:
        names = [name for name in site.spots if name in set(group.items) and name not in known]
        text += ["", f"# {_one_line(group.label)}: {_one_line(group.rationale)}"]
        for name in names:
            text += guess_lines(site, name)
        text += [line.text for line in mentioned(lines, names, known)]
        known |= set(names)
    return "\n".join(text) + "\n"


def _one_line(text: str) -> str:
    """Return text that cannot leave its comment line."""
    return " ".join(text.split())
