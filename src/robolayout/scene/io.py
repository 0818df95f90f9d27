"""Reads and writes scene files and layout files (the formats of `docs/conventions.md`), and their digests.

Degrees and dictionaries live here, at the edge; inside there are radians and frozen nouns. Whatever can be mended
without guessing is mended with a warning in `Scene.warnings`; everything else is an error of one sentence.
"""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping
from pathlib import Path, PurePath
from typing import Any

from robolayout._errors import LayoutError, SceneError, did_you_mean
from robolayout._reading import LIMITS, Checker, misspelt, show
from robolayout.scene._asset_io import read_assets, write_asset
from robolayout.scene._room_io import read_room, write_room
from robolayout.scene.agent import DEFAULT_AGENT, Agent
from robolayout.scene.agents_io import agent_from_dict, agent_to_dict, built_in_agent, check_headroom, check_names
from robolayout.scene.layout import Layout, Pose
from robolayout.scene.scene import DRESSINGS, Scene

_SCENE = Checker(SceneError)
_LAYOUT = Checker(LayoutError)
_KEYS = ("task_description", "layout_criteria", "boundary", "doors", "windows", "agent", "catalogue", "assets", "dress")
_LEVEL = 1e-3  # degrees of roll or pitch that count as none


def load_scene(path: str | Path, asset_dir: str | Path | None = None) -> Scene:
    """Return the scene of a JSON file; `asset_dir` is the folder in which assets given as `<uid>-<n>`, and meshes, are looked up."""
    file = Path(path)
    data = _SCENE.read_json(file, "scene file")
    return scene_from_dict(data, name=file.stem, base=file.parent, asset_dir=asset_dir)


def scene_from_dict(
    data: object, *, name: str = "scene", base: str | Path | None = None, asset_dir: str | Path | None = None
) -> Scene:
    """Return the scene that a scene file's content describes; meshes lie in the folder `base` or in `asset_dir`, nowhere else."""
    content = _SCENE.mapping(data, "the scene")
    warnings = misspelt(content, _KEYS, "the scene")
    room = read_room(content, warnings)
    home, other = (None if place is None else Path(place) for place in (base, asset_dir))
    assets = read_assets(content, home, other, warnings)
    from robolayout.scene._fit import check_fit

    check_fit(room, assets)
    agents = _agents(content.get("agent"))
    check_headroom(agents, room)
    return Scene(
        room=room,
        assets=assets,
        task_description=_SCENE.text(content.get("task_description", ""), "task_description"),
        layout_criteria=_SCENE.text(content.get("layout_criteria", ""), "layout_criteria"),
        agents=agents,
        dress=check_dress(content.get("dress", "none")),
        name=name,
        warnings=tuple(warnings),
    )


def check_dress(value: object) -> str:
    """Return how much is to lie about, if it is known."""
    if value not in DRESSINGS:
        raise SceneError(f"dress must be {', '.join(map(repr, DRESSINGS))}, but is {value!r:.60}.")
    return str(value)


def scene_to_dict(scene: Scene, base: str | Path | None = None) -> dict[str, object]:
    """Return the content of a scene file that reads back as an equal scene; meshes in the folder `base` are written relative to it."""
    folder = None if base is None else Path(base)
    data: dict[str, object] = {"task_description": scene.task_description, "layout_criteria": scene.layout_criteria}
    data |= write_room(scene.room)
    if scene.agents != (DEFAULT_AGENT,):
        agents = [agent_to_dict(agent) for agent in scene.agents]
        data["agent"] = agents[0] if len(agents) == 1 else agents
    if scene.dress != DRESSINGS[0]:
        data["dress"] = scene.dress
    data["assets"] = {asset.name: write_asset(asset, folder) for asset in scene.assets}
    return data


def load_layout(path: str | Path, scene: Scene) -> Layout:
    """Return the layout of a file, checked against its scene."""
    return layout_from_dict(_LAYOUT.read_json(Path(path), "layout file"), scene)


def layout_from_dict(data: object, scene: Scene | None = None) -> Layout:
    """Return the layout that a layout file's content describes: position in metres, rotation in degrees, by asset name."""
    content = _LAYOUT.mapping(data, "the layout")
    if len(content) > LIMITS.assets:
        raise LayoutError(f"the layout has {len(content)} entries; at most {LIMITS.assets} are allowed.")
    layout = Layout({name: _pose(entry, name) for name, entry in content.items()})
    if scene is None:
        return layout
    check_layout(scene, layout, partial=True)
    return Layout({asset.name: layout[asset.name] for asset in scene.assets if asset.name in layout})


def check_layout(scene: Scene, layout: Layout, *, partial: bool) -> None:
    """Refuse a layout with a thing that its scene does not have, a pose that is not finite, or unless `partial` too few poses."""
    for name, pose in layout.items():
        if name not in scene.by_name:
            hint = did_you_mean(name[:200], scene.by_name)
            known = ", ".join(sorted(scene.by_name)) or "none"
            more = "" if hint else " Take it out, or give the scene.json of the run, which has what lies about."
            raise LayoutError(f"the layout places {show(name)}, which is not in the scene.{hint} Known: {known}.{more}")
        if not pose.is_finite:
            raise LayoutError(
                f"the pose of {name!r} is not finite or too far: {pose}; coordinates are at most {LIMITS.farthest:g} m."
            )
    missing = [asset.name for asset in scene.assets if asset.name not in layout]
    if missing and not partial:
        raise LayoutError(
            f"the layout has no pose for {', '.join(map(repr, missing[:5]))} ({len(missing)} of {len(scene.assets)} "
            "assets); place them first, or leave them out (--partial, partial=True)."
        )


def _pose(value: object, name: str) -> Pose:
    where = f"layout[{show(name)}]"
    data: Mapping[str, object] = _LAYOUT.mapping(value, where)
    x, y, z = _LAYOUT.numbers(_LAYOUT.required(data, "position", where), f"{where}.position", (3,))
    given = _LAYOUT.required(data, "rotation", where)
    turns = _LAYOUT.numbers(given if isinstance(given, (list, tuple)) else [given], f"{where}.rotation", (1, 3))
    if any(abs(turn) > _LEVEL for turn in turns[:-1]):
        raise LayoutError(
            f"{where}.rotation is {[*turns]}: only the last number may differ from 0, degrees about the vertical."
        )
    return Pose(x, y, z, math.radians(turns[-1] % 360.0))


def _agents(value: object) -> tuple[Agent, ...]:
    """Return the agents of a scene file: none, one, or a list; names of built-in agents only, never paths."""
    if value is None:
        return (DEFAULT_AGENT,)
    entries = _SCENE.sequence(value, "agent", most=LIMITS.agents) if isinstance(value, (list, tuple)) else [value]
    if not entries:
        raise SceneError("agent is an empty list; name at least one agent or leave it out.")
    agents = [built_in_agent(entry) if isinstance(entry, str) else agent_from_dict(entry) for entry in entries]
    return check_names(agents)


def digest(content: object) -> str:
    """Return the SHA-256, in hexadecimal, of plain data in canonical JSON: sorted keys, no spaces, ASCII."""
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), default=str)
    return hashlib.sha256(text.encode()).hexdigest()


def layout_digest(layout: Layout) -> str:
    """Return the digest of the content of `layout.json`."""
    return digest(layout.to_dict())


def scene_digest(scene: Scene) -> str:
    """Return the digest of the content of a scene file; of a mesh only the file's name counts, not the folder it is in."""
    content: dict[str, Any] = scene_to_dict(scene)
    for entry in content["assets"].values():
        if isinstance(entry.get("path"), str):
            entry["path"] = PurePath(entry["path"]).name
    return digest(content)
