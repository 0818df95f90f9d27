"""Agents: the laws of the built-in profiles, and the sentence for every wrong one."""

from __future__ import annotations

import json
import math
import shutil
import tomllib
from collections.abc import Mapping
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any

import pytest

import robolayout.scene.agents_io as agents_io
from robolayout._errors import AgentError, UnknownNameError
from robolayout.scene import Agent, agent_names, agent_to_dict, load_agent, load_agents
from robolayout.scene.agents_io import FIGURES

FOLDER = Path(agents_io.__file__).parent / "agents"
LISTED = (
    "turtlebot4, stretch3, fetch, tiago, spot, unitree_g1, robot_vacuum, amr, forklift, adult, child_6, elder_walker, "
    "wheelchair, dog_medium, cat"
)
NAMES = LISTED.split(", ")

each_agent = pytest.mark.parametrize("name", agent_names())


def test_the_fifteen_are_there() -> None:
    assert agent_names() == tuple(NAMES)


def test_a_body_is_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for path in FOLDER.glob("*.toml"):
        shutil.copy(path, tmp_path)
    (tmp_path / "goat.toml").write_text("radius = 0.3\nheight = 0.9\n", "utf-8")
    monkeypatch.setattr(agents_io, "_FOLDER", tmp_path)
    monkeypatch.setattr(agents_io, "_orders", vars(agents_io)["_orders"].__wrapped__)
    assert agent_names() == (*NAMES, "goat")
    assert load_agent("goat").height == 0.9


@each_agent
def test_a_built_in_agent_makes_sense(name: str) -> None:
    agent = load_agent(name)
    assert agent.name == name
    assert agent.title
    assert 0 < agent.radius < 2
    assert agent.height > agent.step >= 0
    assert agent.reach_low <= agent.reach_high
    assert (agent.length is None) == (agent.width is None)
    if agent.width is not None and agent.length is not None:
        assert agent.radius >= agent.width / 2
        assert agent.turning_diameter is None or agent.turning_diameter >= math.hypot(agent.width, agent.length)


@each_agent
def test_every_figure_of_a_profile_has_its_source(name: str) -> None:
    data = tomllib.loads((FOLDER / f"{name}.toml").read_text())
    figures = {key: value for key, value in data.items() if key in FIGURES}
    assert {"radius", "height", "step"} <= set(figures)
    for figure in figures.values():
        assert set(figure) == {"value", "source", "verified"}
        assert len(figure["source"]) > 8
    agent = load_agent(name)
    assert set(agent.sources) == set(figures)


@each_agent
def test_what_has_no_source_is_not_verified(name: str) -> None:
    for source in load_agent(name).sources.values():
        unsure = any(word in source.text for word in ("no primary source", "no source", "judgement", "typical"))
        assert not (unsure and source.verified), source.text


def test_figures_of_the_wheelchair() -> None:
    agent = load_agent("wheelchair")
    assert (agent.radius, agent.length, agent.width, agent.turning_diameter) == (0.4575, 1.22, 0.76, 1.525)
    assert (agent.reach_low, agent.reach_high, agent.reach_distance) == (0.38, 1.22, 0.99)
    assert agent.sources["radius"].verified
    assert not agent.sources["height"].verified
    assert load_agent("child_6").radius == 0.25


@each_agent
def test_an_agent_reads_back(name: str) -> None:
    agent = load_agent(name)
    assert agent_to_dict(agent) == name
    other = load_agent(dict(_figures(agent), name="other"))
    back = load_agent(json.loads(json.dumps(agent_to_dict(other))))
    assert back == other
    assert back.sources == agent.sources


def _figures(agent: Agent) -> dict[str, Any]:
    return {
        key: {"value": value, "source": agent.sources[key].text, "verified": agent.sources[key].verified}
        for key in FIGURES
        if (value := getattr(agent, key)) is not None and key in agent.sources
    }


# Ways to give an agent.


def test_short_dictionary() -> None:
    agent = load_agent({"radius": 0.45, "height": 1.4, "reach": 0.75})
    assert (agent.name, agent.radius, agent.height, agent.reach_distance) == ("agent", 0.45, 1.4, 0.75)
    assert agent.sources == {}


def test_a_rectangle_needs_no_radius() -> None:
    agent = load_agent({"length": 0.8, "width": 0.5, "height": 1})
    assert agent.radius == pytest.approx(0.28)


def test_an_agent_object_is_checked_too() -> None:
    agent = Agent("x", radius=0.3, height=1.0)
    assert load_agent(agent) is agent
    with pytest.raises(AgentError, match="is 0: a point has no body"):
        load_agent(Agent("x", radius=0.0, height=1.0))


def test_toml_and_json_files(tmp_path: Path) -> None:
    toml, plain = tmp_path / "cart.toml", tmp_path / "cart2.json"
    toml.write_text('title = "my cart"\nradius = 0.3\nheight = { value = 1.1, source = "measured", verified = true }\n')
    plain.write_text('{"radius": 0.3, "height": 1.1}')
    agent = load_agent(str(toml))
    assert (agent.name, agent.title, agent.radius, agent.height) == ("cart", "my cart", 0.3, 1.1)
    assert agent.sources["height"].verified
    assert load_agent(plain).name == "cart2"


def test_several_agents() -> None:
    assert [agent.name for agent in load_agents("wheelchair, child_6")] == ["wheelchair", "child_6"]
    assert [agent.name for agent in load_agents(["cat", {"radius": 0.1, "height": 0.3}])] == ["cat", "agent"]
    assert load_agents("cat") == (load_agent("cat"),)
    assert load_agents({"radius": 0.1, "height": 0.3})[0].radius == 0.1
    with pytest.raises(AgentError, match="two agents are called 'cat'; give each its own name"):
        load_agents("cat,cat")
    with pytest.raises(AgentError, match="no agent is named in ' , '"):
        load_agents(" , ")


def test_installed_packages_add_agents(monkeypatch: pytest.MonkeyPatch) -> None:
    def found() -> Mapping[str, EntryPoint]:
        return {"string": EntryPoint("string", "string:ascii_letters", "robolayout.agents"), "mine": _Mine()}

    monkeypatch.setattr(agents_io, "_outside", found)
    assert agent_names() == (*NAMES, "mine", "string")
    assert load_agent("mine").radius == 0.4


class _Mine(EntryPoint):
    """An entry point that loads to a dictionary."""

    def __new__(cls) -> _Mine:
        return EntryPoint.__new__(cls)

    def __init__(self) -> None:
        super().__init__("mine", "mine:profile", "robolayout.agents")

    def load(self) -> dict[str, float]:
        return {"radius": 0.4, "height": 1.0}


# What is wrong, each with its sentence.


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ({"height": 1}, "agent 'agent' has no radius; give it in metres, or length and width for a rectangle."),
        ({"radius": 0.3}, "agent 'agent' has no height; give it in metres."),
        (
            {"radius": 0, "height": 1},
            "agent 'agent': radius is 0: a point has no body to get through the room; give a radius above 0 m.",
        ),
        ({"radius": -0.3, "height": 1}, "agent 'agent': radius (metres) must be above 0, but is -0.3."),
        ({"radius": math.nan, "height": 1}, "agent 'agent': radius (metres) must be a finite number, but is nan."),
        ({"radius": "wide", "height": 1}, "agent 'agent': radius (metres) must be a finite number, but is 'wide'."),
        (
            {"radius": 30, "height": 170},
            "agent 'agent': radius (metres) must be at most 20, but is 30. Lengths are in metres: is it in centimetres? Then write 0.3.",
        ),
        ({"radius": 0.3, "height": 0.02}, "agent 'agent': height 0.02 must be above its step 0.03."),
        (
            {"radius": 0.3, "height": 1, "reach_low": 1.2, "reach_high": 0.5},
            "agent 'agent': reach_low 1.2 is above reach_high 0.5.",
        ),
        (
            {"radius": 0.3, "height": 1, "length": 1},
            "agent 'agent' has only one of length and width; give both for a rectangle, none for a disc.",
        ),
        (
            {"radius": 0.2, "height": 1, "length": 1, "width": 0.5},
            "agent 'agent': radius 0.2 is less than half its width 0.5; the radius is that of the disc that must pass, half "
            "the corridor it needs.",
        ),
        (
            {"name": "x", "radius": 0.3, "height": 1, "raduis": 1},
            "agent 'x' has the unknown key 'raduis'. Allowed: name, title, radius, height, length, width, turning_diameter, "
            "turning_radius, reach_distance, reach_low, reach_high, shoulder_height, knee_height, step, reach, reach_bands.",
        ),
        (
            {"radius": {"value": 0.3, "from": "x"}, "height": 1},
            "agent 'agent': radius has the unknown key 'from'. Allowed: value, source, verified.",
        ),
        ({"radius": {"source": "x"}, "height": 1}, "agent 'agent': radius has no \"value\"; add it."),
        ({"name": 4, "radius": 0.3, "height": 1}, "the agent's name must be a text, but is 4."),
        (5, "the agent must be an object with named values, but is 5."),
    ],
)
def test_wrong_agents(data: Any, message: str) -> None:
    with pytest.raises(AgentError) as caught:
        load_agent(data)
    assert str(caught.value) == message


def test_unknown_names_list_the_known() -> None:
    with pytest.raises(UnknownNameError) as caught:
        load_agent("wheel chair")
    assert str(caught.value) == (
        "unknown agent 'wheel chair'. Did you mean 'wheelchair'? Known: adult, amr, cat, child_6, dog_medium, elder_walker, "
        "fetch, forklift, robot_vacuum, spot, stretch3, tiago, turtlebot4, unitree_g1, wheelchair."
    )


def test_wrong_files(tmp_path: Path) -> None:
    path = tmp_path / "x.toml"
    with pytest.raises(AgentError, match=r"agent file .*x\.toml does not exist; check the path\."):
        load_agent(path)
    path.write_text("radius = \n")
    with pytest.raises(AgentError, match=r"agent file .*x\.toml is not TOML: Invalid value \(at line 1, column 10\)\."):
        load_agent(path)
    path.write_text("radius = 0.3\nheight = 1.0\nwidht = 0.5\n")
    with pytest.raises(AgentError, match=r"agent 'x' has the unknown key 'widht'\. Allowed: name, title, radius"):
        load_agent(path)
    path.write_text("a = " + "[" * 100_000)
    with pytest.raises(AgentError, match="is nested too deeply"):
        load_agent(path)
