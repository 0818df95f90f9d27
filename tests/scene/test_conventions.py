"""The examples of docs/conventions.md are read by the real readers."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from robolayout._reading import LIMITS
from robolayout.scene import layout_from_dict, load_agent, scene_from_dict
from robolayout.scene.room import OPENINGS

PAGE = (Path(__file__).parents[2] / "docs" / "conventions.md").read_text(encoding="utf-8")


def block(language: str, number: int = 0) -> str:
    return re.findall(rf"```{language}\n(.*?)```", PAGE, flags=re.DOTALL)[number]


def test_the_scene_and_the_layout_of_the_page() -> None:
    scene = scene_from_dict(json.loads(block("json")))
    assert scene.warnings == ()
    assert scene.by_name["lamp-0"].use_sides == ("front",)
    layout = layout_from_dict(json.loads(block("json", 1)), scene)
    bed = scene.by_name["bed-0"]
    assert (layout["bed-0"].x, layout["bed-0"].z) == (bed.size[0] / 2, bed.size[2] / 2)


def test_the_agents_of_the_page(tmp_path: Path) -> None:
    path = tmp_path / "delivery.toml"
    path.write_text(block("toml"))
    agent = load_agent(path)
    assert (agent.title, agent.radius, agent.turning_diameter) == ("my delivery robot", 0.35, 1.10)
    assert agent.sources["height"].text == "data sheet, page 3"
    short = re.search(r"`(\{\"name\".*?\})`", PAGE)
    assert short is not None
    assert load_agent(json.loads(short[1])).reach_distance == 0.75


@pytest.mark.parametrize(
    "words",
    [
        f"3 to {LIMITS.corners} corners",
        f"1 to {LIMITS.assets} assets",
        f"height ({OPENINGS.door_height:g} for doors, {OPENINGS.window_height:g} for windows) and sill (0, {OPENINGS.window_sill:g})",
    ],
)
def test_the_numbers_of_the_page(words: str) -> None:
    assert words in PAGE
