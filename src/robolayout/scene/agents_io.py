"""Reads agents: built-in profiles, TOML and JSON files, dictionaries and robots' URDF and MJCF models.

A profile gives each figure either as a number or as `{ value = 0.45, source = "where it is from", verified = true }`; with
`model = "robot.urdf"`, and `[pose]` for joints in which it drives about, it takes from that model what it does not say.
Lengths are in metres. `radius` may be left out where `length` and `width` are given: it is then half the width and
3 cm.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import fields, replace
from functools import cache
from pathlib import Path
from typing import Any

from robolayout._errors import AgentError, UnknownNameError
from robolayout._reading import LIMITS, Checker, show
from robolayout._reading.plugins import loaded
from robolayout.scene.agent import BODY, Agent, Source
from robolayout.scene.room import Room

FIGURES = tuple(one.name for one in fields(Agent) if one.type in ("float", "float | None"))
"""Figures of a profile, in metres; `reach` is short for `reach_distance`."""
ENTRY_POINTS = "robolayout.agents"
"""Entry-point group through which other packages add agents: each loads to a dictionary or the path of a profile."""

_CHECK = Checker(AgentError)
_FOLDER = Path(__file__).parent / "agents"  # the built-in profiles, a file each
_MAY_BE_ZERO = ("turning_radius", "reach_low", "reach_high", "shoulder_height", "step")
_ALLOWED = ("name", "title", *FIGURES, "reach", "reach_bands")


def agent_names() -> tuple[str, ...]:
    """Return the names of all agents that can be given by name."""
    return (*_orders(), *sorted(_outside()))


def load_agent(spec: str | Path | Mapping[str, object] | Agent) -> Agent:
    """Return one agent: by name, from a .toml, .json, .urdf or .xml file, from a dictionary of figures, or as it is."""
    if isinstance(spec, Agent):
        return checked(spec)
    if not isinstance(spec, (str, Path)):
        return agent_from_dict(spec)
    path = Path(spec)
    if path.suffix.lower() in (".urdf", ".xml"):
        from robolayout.scene.robot import load_robot

        return checked(load_robot(path))
    return _load_profile(path) if path.suffix.lower() in (".toml", ".json") else built_in_agent(str(spec))


def load_agents(spec: str | Path | Mapping[str, object] | Agent | Iterable[object]) -> tuple[Agent, ...]:
    """Return one or more agents: "wheelchair,child_6", anything that `load_agent` takes, or a list of that."""
    if isinstance(spec, str):
        parts: list[object] = [part.strip() for part in spec.split(",") if part.strip()]
    elif isinstance(spec, Iterable) and not isinstance(spec, Mapping):
        parts = list(spec)
    else:
        parts = [spec]
    if not parts:
        raise AgentError(f"no agent is named in {show(spec)}. Known: {', '.join(agent_names())}.")
    return check_names([load_agent(part) for part in parts])  # pyright: ignore[reportArgumentType]


def built_in_agent(name: str) -> Agent:
    """Return an agent by its name: a built-in one, or one that an installed package brings."""
    if name in _orders():
        return _built_in(name)
    outside = _outside()
    if name not in outside:
        raise UnknownNameError("agent", name[:100], agent_names())
    found = loaded(
        outside[name], "agent: a dictionary or a path", lambda found: isinstance(found, (Mapping, str, Path))
    )
    return agent_from_dict(found, name=name) if isinstance(found, Mapping) else _load_profile(Path(found))


def agent_from_dict(data: object, name: str = "agent") -> Agent:
    """Return the agent that a dictionary describes; `name` is its name if it gives none.

    The keys are those of `Agent` (`reach` is short for `reach_distance`), each figure a number or {"value", "source", "verified"}.
    """
    content = dict(_CHECK.mapping(data, "the agent"))
    label = _CHECK.text(content.pop("name", name), "the agent's name", most=100)
    title = _CHECK.text(content.pop("title", ""), f"agent {label!r}: title", most=200)
    unknown = [key for key in content if key not in _ALLOWED]
    if unknown:
        raise AgentError(f"agent {label!r} has the unknown key {show(unknown[0])}. Allowed: {', '.join(_ALLOWED)}.")
    if "reach" in content:
        content["reach_distance"] = content.pop("reach")
    bands = _bands(content.pop("reach_bands", ()), f"agent {label!r}: reach_bands")
    figures: dict[str, float] = {}
    sources: dict[str, Source] = {}
    for key, value in content.items():
        if value is not None:
            figures[key], source = _figure(value, f"agent {label!r}: {key}", key)
            sources |= {key: source} if source else {}
    if "radius" not in figures:
        if "width" not in figures:
            raise AgentError(f"agent {label!r} has no radius; give it in metres, or length and width for a rectangle.")
        figures["radius"] = figures["width"] / 2 + BODY.clearance
    if "height" not in figures:
        raise AgentError(f"agent {label!r} has no height; give it in metres.")
    return checked(Agent(name=label, title=title, sources=sources, reach_bands=bands, figure=None, **figures))


def agent_to_dict(agent: Agent) -> str | dict[str, object]:
    """Return an agent as a scene file gives it: its name if it is built in, else its figures."""
    if agent.name in _orders() and agent == _built_in(agent.name):
        return agent.name
    data: dict[str, object] = {"name": agent.name, "title": agent.title}
    for key in FIGURES:
        value, source = getattr(agent, key), agent.sources.get(key)
        if value is not None:
            full = source and {"value": value, "source": source.text, "verified": source.verified}
            data[key] = full or value
    return {**data, "reach_bands": [list(band) for band in agent.reach_bands]} if agent.reach_bands else data


def checked(agent: Agent) -> Agent:
    """Return the agent if its figures make sense together."""
    name = f"agent {agent.name!r}"
    for key in FIGURES:
        if (value := getattr(agent, key)) is not None:
            _positive(value, f"{name}: {key}", key)
    if (agent.length is None) != (agent.width is None):
        raise AgentError(f"{name} has only one of length and width; give both for a rectangle, none for a disc.")
    if agent.width is not None and agent.radius < agent.width / 2 - 1e-9:
        raise AgentError(
            f"{name}: radius {agent.radius:g} is less than half its width {agent.width:g}; the radius is that of "
            "the disc that must pass, half the corridor it needs."
        )
    if agent.height <= agent.step:
        raise AgentError(f"{name}: height {agent.height:g} must be above its step {agent.step:g}.")
    if agent.reach_low > agent.reach_high:
        raise AgentError(f"{name}: reach_low {agent.reach_low:g} is above reach_high {agent.reach_high:g}.")
    return agent


def check_names(agents: Iterable[Agent]) -> tuple[Agent, ...]:
    """Return the agents if no two share a name."""
    by_name: dict[str, Agent] = {}
    for agent in agents:
        if agent.name in by_name:
            raise AgentError(f"two agents are called {agent.name!r}; give each its own name.")
        by_name[agent.name] = agent
    return tuple(by_name.values())


def check_headroom(agents: Iterable[Agent], room: Room) -> None:
    """Raise an AgentError for the first agent that is higher than the room."""
    for agent in agents:
        if agent.height > room.wall_height:
            raise AgentError(
                f"agent {agent.name!r} is {agent.height:.2f} m high, but the room only {room.wall_height:.2f} m; "
                "choose a lower agent or raise wall_height."
            )


@cache
def _orders() -> Mapping[str, float]:
    """Return the names of the built-in agents with their places in lists; those that say none come last."""
    texts = {path.stem: path.read_text(encoding="utf-8") for path in sorted(_FOLDER.glob("*.toml"))}
    found = {name: tomllib.loads(text).get("order", math.inf) for name, text in texts.items()}
    return dict(sorted(found.items(), key=lambda item: item[1]))


@cache
def _built_in(name: str) -> Agent:
    return _load_profile(_FOLDER / f"{name}.toml")


def _outside() -> dict[str, Any]:
    """Return the agents of installed packages by name."""
    from importlib.metadata import entry_points

    return {point.name: point for point in entry_points(group=ENTRY_POINTS)}


def _load_profile(path: Path) -> Agent:
    if path.suffix.lower() == ".json":
        content = _CHECK.mapping(_CHECK.read_json(path, "agent file"), f"agent file {path}")
    else:
        content = _CHECK.read_toml(path, "agent file")
    content = {key: value for key, value in content.items() if key != "order"}  # its place among the built-in ones
    return _with_model(content, path) if "model" in content else agent_from_dict(content, name=path.stem)


def _with_model(content: dict[str, object], path: Path) -> Agent:
    """Return the agent of a profile, with the figures of the robot model that it names, in its pose, where it gives none itself."""
    from robolayout.scene.robot import load_robot

    where = f"agent file {path}"
    file = Path(_CHECK.text(content.pop("model"), f"{where}: model", most=1000))
    given = content.pop("pose", None)
    values: dict[str, float] | None = None
    if given is not None:
        pose = _CHECK.mapping(given, f"{where}: pose")
        values = {name: _CHECK.number(value, f"{where}: pose.{name}") for name, value in pose.items()}
    robot = load_robot(path.parent / file, values)
    known = agent_to_dict(robot)
    if isinstance(known, dict) and content.keys() & {"reach", "reach_distance", "shoulder_height"}:
        known.pop("reach_bands", None)
    whole = {**known, **content} if isinstance(known, dict) else content
    return replace(agent_from_dict(whole, name=path.stem), figure=robot.figure)


def _figure(value: object, where: str, key: str) -> tuple[float, Source | None]:
    """Return a figure and its source; the value stands alone or in a table."""
    if not isinstance(value, Mapping):
        return _positive(value, where, key), None
    table = _CHECK.mapping(value, where)
    odd = [name for name in table if name not in ("value", "source", "verified")]
    if odd:
        raise AgentError(f"{where} has the unknown key {show(odd[0])}. Allowed: value, source, verified.")
    text = _CHECK.text(table.get("source", ""), f"{where}.source", most=500)
    verified = _CHECK.flag(table.get("verified", False), f"{where}.verified")
    number = _positive(_CHECK.required(table, "value", where), where, key)
    return number, Source(text, verified) if text else None


def _bands(value: object, where: str) -> tuple[tuple[float, float, float], ...]:
    """Return how far a hand gets by height: (from, to, reach) in metres."""
    rows = [_CHECK.numbers(row, where, (3,)) for row in _CHECK.sequence(value, where, 1000)]
    if any(low > high or min(row) < 0 or max(row) > LIMITS.body for row in rows for low, high in [row[:2]]):
        raise AgentError(
            f"{where}: each is [from, to, reach] in metres, from 0 to {LIMITS.body:g}, the lower height first."
        )
    return tuple((low, high, far) for low, high, far in rows)


def _positive(value: object, where: str, key: str) -> float:
    if key in _MAY_BE_ZERO:
        return _CHECK.number(value, f"{where} (metres)", least=0.0, most=LIMITS.body)
    if key == "radius" and value == 0 and not isinstance(value, bool):
        raise AgentError(f"{where} is 0: a point has no body to get through the room; give a radius above 0 m.")
    return _CHECK.number(value, f"{where} (metres)", above=0.0, most=LIMITS.body)
