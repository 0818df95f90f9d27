"""What is to be laid out, in whichever way it is given: a scene, its dictionary, its file, or words."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from robolayout.planners import ModelPlanner, Planner, scene_from_sentence
from robolayout.scene import Agent, Scene, check_dress, load_agents, load_scene, scene_from_dict

AgentSpec = Agent | str | Path | Mapping[str, Any]

LONGEST_WORD = 45
"""Letters of the longest word of a dictionary: more of them without a blank are a path."""


def as_scene(
    given: Scene | Mapping[str, Any] | str | Path,
    planner: Planner,
    agent: AgentSpec | None,
    *,
    seed: int,
    dress: str | None,
) -> Scene:
    """Return a scene from itself, its dictionary, its file or words, for another agent or otherwise dressed if that is said.

    Words are read by the planner where it is a model, else by rules.
    """
    bodies = () if agent is None else load_agents(agent)
    if isinstance(given, str) and not names_a_file(given):
        by_model = isinstance(planner, ModelPlanner)
        scene = planner.furnish(given)[0] if by_model else scene_from_sentence(given, seed=seed, agents=bodies)[0]
    elif isinstance(given, str | Path):
        scene = load_scene(given)
    else:
        scene = given if isinstance(given, Scene) else scene_from_dict(given)
    scene = scene if dress is None else replace(scene, dress=check_dress(dress))
    return scene.with_agents(*bodies) if bodies else scene


def names_a_file(text: str) -> bool:
    """Return whether a text names a scene file rather than saying what the room should be."""
    name = text.strip()
    if " " in name or "\n" in name:
        return Path(text).suffix == ".json" or os.path.exists(text)
    return bool(name) and (not name.isalpha() or len(name) > LONGEST_WORD or os.path.exists(text))
