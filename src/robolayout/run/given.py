"""What is to be laid out, in whichever way it is given: a scene, its dictionary, its file, or words."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from robolayout.planners import ModelPlanner, Planner, Understanding, scene_from_sentence
from robolayout.scene import Agent, Scene, check_dress, load_agents, load_scene, scene_from_dict
from robolayout.verify import AgentSpec

LONGEST_WORD = 45  # letters of the longest word of a dictionary: more of them without a blank are a path


def as_scene(
    given: Scene | Mapping[str, Any] | str | Path,
    planner: Planner,
    agent: AgentSpec | None,
    *,
    seed: int,
    dress: str | None,
) -> Scene:
    """Return a scene from itself, its dictionary, its file or words, for another agent or otherwise dressed if that is said."""
    bodies = () if agent is None else load_agents(agent)
    if isinstance(given, str) and not names_a_file(given):
        scene, _ = furnished(given, planner, seed=seed, agents=bodies)
    elif isinstance(given, str | Path):
        scene = load_scene(given)
    else:
        scene = given if isinstance(given, Scene) else scene_from_dict(given)
    scene = scene if dress is None else replace(scene, dress=check_dress(dress))
    return scene.with_agents(*bodies) if bodies else scene


def furnished(
    text: str,
    planner: Planner,
    *,
    seed: int,
    variant: int = 0,
    agents: Sequence[Agent] = (),
    knowledge: Iterable[str | Path] = (),
    assets: Path | None = None,
) -> tuple[Scene, Understanding]:
    """Return the scene of words, and what was understood: by the planner where it is a model, else by rules."""
    if isinstance(planner, ModelPlanner):
        return planner.furnish(text, assets=assets)
    return scene_from_sentence(text, seed=seed, variant=variant, knowledge=knowledge, agents=agents)


def names_a_file(text: str) -> bool:
    """Return whether a text names a scene file rather than saying what the room should be."""
    name = text.strip()
    if " " in name or "\n" in name:
        return Path(text).suffix == ".json" or os.path.exists(text)
    return bool(name) and (not name.isalpha() or len(name) > LONGEST_WORD or os.path.exists(text))
