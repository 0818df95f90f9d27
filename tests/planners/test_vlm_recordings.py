"""Six rooms planned by recorded programs: every answer is read, and the rooms end valid."""

from __future__ import annotations

import pytest
import vlm_recordings as recordings

from robolayout._errors import ProgramError
from robolayout.pipeline import generate
from robolayout.planners import ModelPlanner, PlanRequest
from robolayout.program import read_program, reconcile

QUICK = ("game_room",)
"""Rooms that solve within seconds."""

HARD = ("placed_share", "collision_free_share", "in_boundary_share", "supported_share", "door_clear")
ACCESS = ("walkable_ratio", "reachable_share", "usable_share")


def planner(room: str, mode: str) -> ModelPlanner:
    return ModelPlanner(replay=recordings.FOLDER / room / mode, mode=mode)


def test_there_are_six_rooms() -> None:
    assert len(recordings.ROOMS) == 6


@pytest.mark.parametrize("room", recordings.ROOMS)
def test_every_recorded_answer_is_found_and_read(room: str) -> None:
    scene, asked = recordings.scene_of(room), planner(room, "grouped")
    groups = asked.group(scene)
    assert sorted(name for group in groups for name in group.items) == sorted(scene.by_name)
    known: set[str] = set()
    for group in groups:
        known |= set(group.items)
        text = asked.plan(PlanRequest(scene, group))
        try:
            program = read_program(text, scene)
        except ProgramError as error:
            again = PlanRequest(scene, group, feedback=str(error), previous=text)
            program = read_program(asked.plan(again), scene)
        assert {name for s in program.statements for name in s.relation.asset_names()} <= known


@pytest.mark.parametrize("room", recordings.ROOMS)
def test_four_samples_are_four_opinions(room: str) -> None:
    scene, asked = recordings.scene_of(room), planner(room, "one_shot")
    (group,) = asked.group(scene)
    texts = asked.plan_many(PlanRequest(scene, group), 4)
    assert len(set(texts)) == 4
    for text in texts:
        assert read_program(text, scene).statements


def test_the_recordings_have_the_faults_of_models() -> None:
    rejected = 0
    for room in recordings.ROOMS:
        scene, asked = recordings.scene_of(room), planner(room, "one_shot")
        for text in asked.plan_many(PlanRequest(scene, asked.group(scene)[0]), 4):
            rejected += len(reconcile(read_program(text, scene), scene).rejections)
    assert rejected >= 6


@pytest.mark.parametrize(
    "room", [room if room in QUICK else pytest.param(room, marks=pytest.mark.slow) for room in recordings.ROOMS]
)
def test_a_recorded_room_ends_valid(room: str) -> None:
    result = generate(recordings.scene_of(room), planner=planner(room, "one_shot"), attempts=2)
    figures = result.report.figures
    assert {name: figures[name] for name in HARD} == dict.fromkeys(HARD, 1.0)
    assert all(figures[name] >= 0.98 for name in ACCESS), figures
    assert figures["statements_met_share"] >= 0.93


@pytest.mark.parametrize("room", QUICK)
def test_the_same_recording_gives_the_same_layout(room: str) -> None:
    scene = recordings.scene_of(room)
    first, second = (generate(scene, planner=planner(room, "one_shot"), attempts=1) for _ in range(2))
    assert first.layout.to_dict() == second.layout.to_dict()
    assert first.program.text == second.program.text
