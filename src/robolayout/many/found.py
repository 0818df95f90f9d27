"""Rooms found in a folder, whoever made them: a scene and a layout each, in the forms that docs/many.md lists."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast

from robolayout._errors import InputError
from robolayout._reading import Checker
from robolayout.many.room import NOTE
from robolayout.many.states import FORMAT, read_state
from robolayout.run.result import Result, judge, load_judged
from robolayout.scene import Agent, Scene, load_layout, load_scene

_CHECK = Checker(InputError)


@dataclass(frozen=True)
class Found:
    """A room that was found."""

    name: str  # where, from the folder that was looked through; rooms of two folders are paired by it
    layout: Path  # its layout file, scene state or run folder
    scene: Path | None = None  # its scene file; None where the layout brings the scene along
    facts: dict[str, Any] = field(default_factory=dict[str, Any])  # what a batch says of it

    def judged(self, agents: Sequence[Agent], asset_dir: Path | None) -> Result:
        """Return the room judged, for other bodies than its own if any are given."""

        def read(file: str | Path) -> Scene:
            scene = load_scene(file, asset_dir)
            return scene.with_agents(*agents) if agents else scene

        if self.layout.is_dir():
            return load_judged(self.layout, None, read)
        if self.scene is not None:
            scene = read(self.scene)
            return judge(scene, load_layout(self.layout, scene))
        state = _CHECK.mapping(_CHECK.read_json(self.layout, "scene state"), f"scene state {self.layout}")
        scene, layout = read_state(state, self.layout.stem, asset_dir)
        return judge(scene.with_agents(*agents) if agents else scene, layout)


def find_rooms(folder: Path, scenes: Path | None = None) -> list[Found]:
    """Return all rooms below a folder, by name; `scenes` is a folder of scene files whose layouts are in folders of their names."""
    if not folder.is_dir():
        raise InputError(f"{folder} is no folder; name one with scenes and layouts in it.")
    found = [room for here, names, files in os.walk(folder) for room in _here(Path(here), names, files, scenes)]
    named = [Found(_name(room, folder), room.layout, room.scene, room.facts) for room in found]
    if not named:
        raise InputError(
            f"{folder} holds no room: neither scene.json with layout.json, nor X.json with X.layout.json, nor a scene state"
            + ("." if scenes else "; name the folder of the scene files with --scenes if they are elsewhere.")
        )
    return sorted(named, key=lambda room: room.name)


def _name(room: Found, folder: Path) -> str:
    path = room.layout if room.layout.name != "layout.json" else room.layout.parent
    name = path.relative_to(folder).as_posix()
    for end in (".sceneeval.json", ".layout.json", "_layout.json", ".json"):
        name = name.removesuffix(end)
    return name if name != "." else folder.resolve().name


def _here(here: Path, names: list[str], files: Sequence[str], scenes: Path | None) -> Iterator[Found]:
    """Yield the rooms of one folder."""
    if "scene.json" in files and "layout.json" in files:
        yield Found("", here, None, _facts(here / NOTE))
        return
    if scenes is not None and "layout.json" in files and os.path.isfile(scenes / f"{here.name}.json"):
        yield Found("", here / "layout.json", scenes / f"{here.name}.json")
    for file in sorted(files):
        path = here / file
        if not file.endswith(".json") or file.endswith("layout.json"):
            continue
        places = (f"{path.stem}.layout.json", f"{path.stem}_layout.json", f"{path.stem}/layout.json")
        layout = next((here / place for place in places if os.path.isfile(here / place)), None)
        if layout is not None:
            yield Found("", layout, path)
            names[:] = [name for name in names if here / name != layout.parent]
        elif _is_state(path):
            yield Found("", path)


def _is_state(path: Path) -> bool:
    """Return whether a file says near its start that it is a scene state."""
    with path.open("rb") as file:
        return f'"{FORMAT}"'.encode() in file.read(200)


def _facts(note: Path) -> dict[str, Any]:
    """Return what a batch drew for a room."""
    if not os.path.isfile(note):
        return {}
    row = cast("dict[str, Any]", _CHECK.mapping(_CHECK.read_json(note, "room"), f"room {note}").get("row", {}))
    return {
        key: row[key]
        for key in ("source", "style", "dress", "solver", "reach", "seed")
        if row.get(key) not in (None, "")
    }
