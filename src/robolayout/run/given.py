"""What is given: a scene, its dictionary, its file, or words; a layout to start from, and what of it stays."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from robolayout._errors import InputError, ProgramError, among
from robolayout._reading import Checker, whole
from robolayout.planners import (
    OfflinePlanner,
    Planner,
    PlanRequest,
    RoomPlanner,
    Understanding,
    scene_from_sentence,
)
from robolayout.program import CUSTOM, Guess, Program, Statement, read_program
from robolayout.scene import (
    Agent,
    Layout,
    Pose,
    Scene,
    check_dress,
    layout_from_dict,
    load_agents,
    load_layout,
    load_scene,
    scene_from_dict,
    scene_to_dict,
)
from robolayout.verify import AgentSpec

USUAL = 4.0
"""Weight of what the offline planner states of a thing, where it is only wished for as what is usual."""

MAX_BYTES = 2_000_000  # largest program file in bytes that is read
LONGEST_WORD = 45  # letters of the longest word of a dictionary: more of them without a blank are a path


def as_scene(
    given: Scene | Mapping[str, Any] | str | Path,
    planner: Planner,
    agent: AgentSpec | Iterable[AgentSpec] | None,
    *,
    seed: int,
    dress: str | None,
) -> Scene:
    """Return a scene from itself, its dictionary, its file or words, for another agent or otherwise dressed if that is said."""
    whole(seed, "seed")
    bodies = () if agent is None else load_agents(agent)
    worded = isinstance(given, str) and not names_a_file(given)
    if isinstance(given, str) and worded:
        scene, _ = furnished(given, planner, seed=seed, agents=bodies)
    elif isinstance(given, str | Path):
        scene = load_scene(given)
    else:
        scene = checked(given) if isinstance(given, Scene) else scene_from_dict(given)
    scene = scene if dress is None else replace(scene, dress=check_dress(dress))
    return scene.with_agents(*bodies) if bodies and not worded else scene


def checked(scene: Scene) -> Scene:
    """Return a scene that may have been made by hand as its file would be read: refused, or mended with a warning."""
    read = scene_from_dict(scene_to_dict(scene), name=scene.name, base="/")
    agents = (replace(new, figure=old.figure) for new, old in zip(read.agents, scene.agents, strict=True))
    return replace(read, agents=tuple(agents), warnings=(*scene.warnings, *read.warnings))


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
    if isinstance(planner, RoomPlanner):
        scene, understood = planner.furnish(text, assets=assets)
        return scene.with_agents(*agents) if agents else scene, understood
    return scene_from_sentence(text, seed=seed, variant=variant, knowledge=knowledge, agents=agents, assets=assets)


def names_a_file(text: str) -> bool:
    """Return whether a text names a scene file rather than saying what the room should be."""
    name = text.strip()
    if " " in name or "\n" in name:
        return Path(text).suffix == ".json" or os.path.exists(text)
    return bool(name) and (not name.isalpha() or len(name) > LONGEST_WORD or os.path.exists(text))


def as_text(program: Program | str | Path) -> str:
    """Return the text of a program that is given itself, as text, or as a file."""
    if isinstance(program, Path):
        return Checker(ProgramError).read_text(program, "the program", MAX_BYTES)
    return program.to_text() if isinstance(program, Program) else program


def as_start(scene: Scene, start: Layout | Mapping[str, Any] | str | Path) -> Layout:
    """Return the layout to start from, checked against its scene."""
    if isinstance(start, str | Path):
        return load_layout(start, scene)
    checked = layout_from_dict(start.to_dict() if isinstance(start, Layout) else start, scene)
    return Layout({name: start[name] for name in checked}) if isinstance(start, Layout) else checked


def pinned_poses(scene: Scene, start: Layout | None, keep: Sequence[str], free: Sequence[str]) -> dict[str, Pose]:
    """Return the poses that stay, of what is to be kept or of all that is not free."""
    keep, free = ([names] if isinstance(names, str) else names for names in (keep, free))
    among("asset", (*keep, *free), scene.by_name)
    if keep and free:
        raise InputError("keep and free exclude each other: name what stays, or name all that may move.")
    if start is None:
        if keep or free:
            raise InputError("keep and free need a layout to start from: give one (--from layout.json, start=layout).")
        return {}
    for name in keep:
        if name not in start:
            raise InputError(f"{name!r} cannot be kept: the layout to start from does not place it.")
    staying = set(keep) or (set(start) - set(free) if free else set[str]())
    return {name: start[name] for name in start if name in staying}


def guesses_of(layout: Mapping[str, Pose]) -> dict[str, Guess]:
    """Return the poses of a layout as guesses."""
    return {name: Guess((pose.x, pose.y, pose.z), pose.yaw) for name, pose in layout.items()}


def completed(asked: Program, scene: Scene, *, seed: int) -> Program:
    """Return a program that wishes what is usual of the things it says nothing about; a full one as it is."""
    if not (silent := {*asked.forgotten()}):
        return asked
    usual = usual_wishes(scene, seed)
    return with_wishes(asked, [one for one in usual if asked.expressions[one.relation.asset_names()[0]] in silent])


def usual_wishes(scene: Scene, seed: int) -> list[Statement]:
    """Return what the offline planner states and wishes of a scene, all as wishes for what is usual."""
    found = read_program(OfflinePlanner().plan(PlanRequest(scene, seed=seed)), scene)
    told = (*found.statements, *found.wishes)
    return [replace(one, wish=USUAL if one.wish is None else one.wish, by=CUSTOM, line=0) for one in told]


def with_wishes(asked: Program, wishes: Iterable[Statement]) -> Program:
    """Return a program with so many wishes more, numbered on."""
    more = (replace(one, number=number) for number, one in enumerate(wishes, len(asked.wishes) + 1))
    return replace(asked, wishes=(*asked.wishes, *more))
