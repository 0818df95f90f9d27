"""What a model is told: the scene as variables and data, the state of the room, and what was wrong before.

The texts are the Markdown files in `prompts/`; this module fills them. Everything that a scene file brings (names, words,
descriptions) goes in as quoted JSON without back-ticks, so that it cannot end a block or pass for a part of the prompt.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
import math
import tomllib
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.resources import files
from string import Template
from typing import Any

from robolayout.assets.category import PLACES
from robolayout.assets.obstacles import use_sides
from robolayout.constraints import RELATIONS, Relation
from robolayout.planners._types import Group, PlanRequest
from robolayout.planners.sentence import SIZES
from robolayout.scene import Agent, Asset, Layout, Opening, Room, Scene, agent_names

PROMPT_VERSION = "3"  # version of the prompt files; written into every exchange and every report
LONGEST_DESCRIPTION = 400  # characters of a description that a model is shown

WORDS = {"none": "None", "room": "None", "point": "(x, y)"}
"""How kinds of arguments are written, where not by their own name."""

Picture = tuple[str, bytes]  # the line above a picture, and the picture as PNG

WISHES = (
    "Each of these is a demand. As a wish it is only weighed against others, with a weight (below 0: rather not): "
    "`solver.wish.at_window(desk[0], weight=0.8)`"
)
"""What a model must know of wishes."""


@cache
def prompt(name: str) -> str:
    """Return the text of one prompt file."""
    text = files("robolayout.planners.model").joinpath("prompts", f"{name}.md").read_text(encoding="utf-8")
    filled = {"bodies": ", ".join(agent_names()), "fullest": f"{SIZES.fullest:.0%}", "vocabulary": vocabulary()}
    return Template(text).safe_substitute(filled)


def quoted(value: object) -> str:
    """Return data as JSON on one line: no back-tick, no invisible character, nothing that cannot be sent."""
    text = json.dumps(value, ensure_ascii=False).replace("`", "\\u0060")
    return text if text.isprintable() else "".join(c if c.isprintable() else json.dumps(c)[1:-1] for c in text)


def given_data(scene: Scene, group: Group | None, kind: str) -> dict[str, object]:
    """Return what a question rests on, as plain data: a recorded answer belongs to exactly this."""
    items = [scene.by_name[name] for name in group.items] if group else list(scene.assets)
    return {
        "kind": kind,
        "task": scene.task_description,
        "criteria": scene.layout_criteria,
        "room": {"wall_height": round(scene.room.wall_height, 3), **room_data(scene.room)},
        "agents": [agent_text(agent) for agent in scene.agents],
        "things": [asset_data(asset) for asset in items],
        "group": group.to_dict() if group else None,
    }


def digest(data: object) -> str:
    """Return the SHA-256 of data as canonical JSON."""
    text = json.dumps(data, ensure_ascii=False, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def request_text(scene: Scene, group: Group | None, *, names: bool = False) -> str:
    """Return what is asked: the task, the room, the agents, and the things to place, which are all without a group.

    With `names` they are shown under their names ("bed-0") instead of their variables ("bed[0]").
    """
    assets = [scene.by_name[name] for name in group.items] if group else scene.assets
    written = scene.expressions
    lines: list[str] = []
    for asset in assets:
        thing, sides = asset_data(asset), use_sides(asset)
        called = {} if names else {"variable": written[str(thing.pop("name"))]}
        lines.append(quoted(called | thing | ({"used_from": list(sides)} if sides and len(sides) < 4 else {})))
    if group is not None:
        wanted = (f"- wanted: {quoted(phrase)}" for phrase in group.relations)
        lines = [f"The group {quoted(group.label)}: {quoted(group.rationale)}", *wanted, "", *lines]
    return Template(prompt("request")).substitute(
        task=f"{quoted(scene.task_description)}\n{quoted(scene.layout_criteria)}",
        room=room_text(scene.room),
        agents="\n".join(f"- {agent_text(agent)}" for agent in scene.agents),
        things="\n".join(lines),
    )


def state_text(request: PlanRequest) -> str:
    """Return where things are, and what comes later."""
    scene, placed = request.scene, request.placed or {}
    now = set(request.group.items) if request.group else {asset.name for asset in scene.assets}
    there = Layout({name: pose for name, pose in placed.items() if name not in now})
    waiting = (asset for asset in scene.assets if asset.name not in placed and asset.name not in now)
    later = [f"{scene.expressions[one.name]} ({one.size[0]:.2f} x {one.size[1]:.2f})" for one in waiting]
    return Template(prompt("state")).substitute(
        placed=poses_text(scene, there) or "Nothing is placed yet.",
        later=f"Leave space for {', '.join(later)}." if later else "Nothing: this is the last group.",
    )


def retry_text(request: PlanRequest) -> str:
    """Return the program before, what came of it, and which earlier groups may be planned again; empty at first."""
    if not request.feedback:
        return ""
    text = Template(prompt("retry")).substitute(previous=_unfenced(request), feedback=request.feedback)
    if not request.reopen:
        return text
    labels = ", ".join(quoted(label) for label in request.reopen)
    return text + "\n" + Template(prompt("reopen")).substitute(labels=labels)


def amend_text(request: PlanRequest) -> str:
    """Return where everything stands, the program behind it, and what should be otherwise."""
    placed = poses_text(request.scene, request.placed or Layout({}))
    filled = {"placed": placed, "previous": _unfenced(request), "feedback": request.feedback or "Nothing."}
    return Template(prompt("amend")).substitute(filled)


def poses_text(scene: Scene, layout: Layout) -> str:
    """Return where things stand, one line each, to 1 cm and 1 degree."""
    lines: list[str] = []
    for name, pose in layout.items():
        row = {
            "variable": scene.expressions[name],
            "position": [round(value, 2) + 0.0 for value in (pose.x, pose.y, pose.z)],
            "rotation": round(math.degrees(pose.yaw) % 360.0) % 360,
            "size": [round(value, 2) for value in scene.by_name[name].size],
        }
        lines.append(quoted(row))
    return "\n".join(lines)


def _unfenced(request: PlanRequest) -> str:
    """Return the program before, empty where a line could end its block, so that line numbers still fit."""
    return "\n".join("" if "```" in line else line for line in request.previous.splitlines())


def room_data(room: Room) -> dict[str, Sequence[Mapping[str, object]]]:
    """Return walls, doors and windows as plain data, metres and degrees."""
    return {
        "walls": [
            {
                "variable": f"walls[{wall.index}]",
                "from": _point(wall.start),
                "to": _point(wall.end),
                "length": round(wall.length, 3),
                "rotation_of_a_thing_with_its_back_to_it": round(math.degrees(math.atan2(*wall.normal[::-1])) % 360, 1),
            }
            for wall in room.walls
        ],
        "doors": [_opening(room, door) | {"keep_free": list(map(_point, room.landing(door)))} for door in room.doors],
        "windows": [_opening(room, window) | {"sill": round(window.sill, 3)} for window in room.windows],
    }


def room_text(room: Room) -> str:
    """Return the room as lines of data."""
    data = room_data(room)
    low_x, low_y, high_x, high_y = room.bounds
    lines = [
        f"x from {low_x:g} to {high_x:g}, y from {low_y:g} to {high_y:g}, walls {room.wall_height:g} m high, {room.area:.1f} m2."
    ]
    lines += [quoted(wall) for wall in data["walls"]]
    lines += [f"door {i}{'' if i else ' (the way in)'}: {quoted(door)}" for i, door in enumerate(data["doors"])]
    lines += [f"window {i}: {quoted(window)}" for i, window in enumerate(data["windows"])]
    return "\n".join(lines) + ("" if room.doors else "\nThere is no door.")


def agent_text(agent: Agent) -> str:
    """Return what a body needs, in one sentence."""
    parts = [f"needs a clear way {2 * agent.radius:.2f} m wide and {agent.height:.2f} m high to everything"]
    if agent.turning_diameter:
        parts.append(f"turns in a circle of {agent.turning_diameter:.2f} m")
    if agent.reach_distance:
        heights = f"from {agent.reach_low:.2f} to {agent.reach_high:.2f} m high"
        parts.append(f"reaches {agent.reach_distance:.2f} m far, {heights}")
    if agent.step > 0:
        parts.append(f"gets over {agent.step:.2f} m")
    return f"{quoted(agent.title or agent.name)} {', '.join(parts)}."


def asset_data(asset: Asset) -> dict[str, object]:
    """Return an asset as plain data."""
    data: dict[str, object] = {
        "name": asset.name,
        "category": asset.category,
        **{name: round(size, 3) for name, size in zip(("depth", "width", "height"), asset.size, strict=True)},
        "on": ["another thing" if place == "object" else place for place in PLACES if getattr(asset, f"on_{place}")],
    }
    if asset.description:
        more = "..." if len(asset.description) > LONGEST_DESCRIPTION else ""
        data["description"] = asset.description[:LONGEST_DESCRIPTION] + more
    return data


@cache
def _labels() -> dict[str, str]:
    """Return the line above each picture of a room, in the order in which they are shown."""
    text = files("robolayout.planners.model").joinpath("pictures.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def shown(images: Mapping[str, bytes]) -> list[Picture]:
    """Return images with the lines above them, the room first, assets by name."""
    labels = _labels()
    rank = {name: i for i, name in enumerate(labels) if name != "failed"}
    order = sorted(images, key=lambda name: (rank.get(name, len(rank)), name))
    asset = "What {} looks like from its front, a little from its right and from above."
    return [(labels.get(name) or asset.format(quoted(name)), images[name]) for name in order]


def _point(point: tuple[float, float]) -> list[float]:
    return [round(point[0], 3) + 0.0, round(point[1], 3) + 0.0]


def _opening(room: Room, opening: Opening) -> dict[str, object]:
    wall = room.walls[opening.wall]
    return {
        "wall": f"walls[{opening.wall}]",
        "from": _point(wall.point(opening.offset)),
        "to": _point(wall.point(opening.offset + opening.width)),
        "height": round(opening.height, 3),
    }


def vocabulary() -> str:
    """Return signature, meaning and example of every relation that a program may state, and how it becomes a wish."""
    return "\n\n".join([*map(entry, RELATIONS.values()), WISHES])


def entry(relation: type[Relation]) -> str:
    """Return what a model must know of one relation."""
    moving = f" Both `{relation.moves[0]}` and `{relation.moves[1]}` move." if len(relation.moves) == 2 else ""
    heading = " Settles the heading." if relation.orients else ""
    shown = ", ".join(_argument(field) for field in relation.arguments())
    return f"`solver.{relation.name}({shown})`\n{relation.meaning()}{moving}{heading}\nExample: `{relation.example}`"


def _argument(field: dataclasses.Field[Any]) -> str:
    """Return an argument as it is written in a signature: `max_gap: number in m = 0.3`."""
    meta = field.metadata
    takes: tuple[str, ...] = meta["takes"]
    kinds = [f'"{choice}"' for choice in meta["choices"]] or [WORDS.get(kind, kind) for kind in takes]
    text = " | ".join(kinds)
    if meta["many"]:
        text = f"list of {text}"
    if meta["unit"]:
        text = text.replace("number", f"number in {meta['unit']}")
    if field.default is dataclasses.MISSING:
        return f"{field.name}: {text}"
    default = f"{field.default:g}" if isinstance(field.default, float) else repr(field.default)
    return f"{field.name}: {text} = {default}"
