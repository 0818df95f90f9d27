"""What a model sees when it is asked again: what came of its program, only what this group can change, and a way back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from test_vlm_protocols import Play, good, is_group, is_picture
from vlm_rooms import BED, GROUPING, PICTURE, small_room
from vlm_server import Loopback, Reply, Seen, serving

import robolayout as rl
from robolayout.planners import ModelPlanner

pytestmark = pytest.mark.usefixtures("ask_loopback")

FAR = BED + "solver.distance_constraint(night_stand[0], bed[0], 3.4, 3.5)\n"
ELSEWHERE = BED.replace("walls[3]", "walls[1]").replace("[1.0, 1.6", "[3.0, 2.4").replace("= [0]", "= [180]")
APART = PICTURE + "solver.distance_constraint(picture[0], bed[0], 2.6, 4.0)\n"


@pytest.fixture(autouse=True)
def key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", "sk-very-secret-0123456789")


def run(server: Loopback, scene: rl.Scene | None = None, **options: Any) -> rl.Result:
    asked = ModelPlanner("openai:gpt-4o", base_url=server.url, **{"mode": "no_image", "retries": 2, **options})
    return rl.generate(scene or small_room(), planner=asked)


def programs(server: Loopback, *, picture: bool) -> list[Seen]:
    return [seen for seen in server.seen if not is_group(seen) and is_picture(seen) is picture]


def playing(bed: list[str], picture: list[str]) -> Play:
    """Return a model that gives these programs in turn, the last one for ever."""
    told = {True: iter([*picture, *picture[-1:] * 9]), False: iter([*bed, *bed[-1:] * 9])}
    return lambda seen, _: GROUPING if is_group(seen) else next(told[is_picture(seen)])


@pytest.mark.slow
def test_the_retry_sees_what_came_of_the_program() -> None:
    outside = FAR.replace("[1.0, 1.6, 0.25]", "[0.4, -0.5, 0.25]")
    with serving(playing([outside, BED], [PICTURE])) as server:
        result = run(server, mode="grouped")
    assert result.report.ok
    first, again = programs(server, picture=False)
    assert len(again.images) == len(first.images) + 1
    assert again.labels[-1].startswith("What came of your program, as a plan")
    told = again.user.partition("# What came of it")[2]
    assert '{"variable": "bed[0]", "position": [' in told and '"picture[0]"' not in told
    assert "bed[0] was moved by " in told and "Where the program put it: " in told
    assert "night_stand[0]" in told and "night_stand-0" not in told
    start = again.user.index("# Your program before")
    assert again.user[:start].startswith(first.user[: first.user.index("The plan of the room")]), "static parts first"


@pytest.mark.slow
def test_later_groups_are_not_asked_about_earlier_ones() -> None:
    with serving(playing([FAR], [PICTURE])) as server:
        result = run(server)
    assert not result.report.ok, "the statement of the first group cannot hold"
    assert len(programs(server, picture=False)) == 3 and len(programs(server, picture=True)) == 1


@pytest.mark.slow
def test_a_group_may_ask_for_an_earlier_one_to_be_planned_again(tmp_path: Path) -> None:
    wish = "# Reopen: `Sleeping`: the bed stands at walls[1]\n" + APART
    with serving(playing([BED, ELSEWHERE], [APART, wish])) as server:
        result = run(server, exchanges=tmp_path)
    first, second = programs(server, picture=True)
    assert "# reopen: LABEL" not in first.user
    assert 'You may ask for "sleeping".' in second.user
    again = programs(server, picture=False)[1]
    assert "group 'decoration', which comes later, asks for it: the bed stands at walls[1]" in again.user
    assert "solver.against_wall(bed[0], walls[3])" in again.user, "its own program is shown"
    assert len(server.seen) == 5, "what was said of the picture is tried again without asking"
    assert result.report.ok and result.layout["bed-0"].x > 2.5
    assert any("Group 'sleeping' was planned again: group" in s for s in result.report.planner["sentences"])
    kept = [(sample.group, sample.text) for sample in result.samples if sample.kept]
    assert kept == [("sleeping", ELSEWHERE), ("decoration", wish)]
    replayed = rl.generate(small_room(), planner=ModelPlanner(replay=tmp_path, mode="no_image", retries=2))
    assert replayed.layout.to_dict() == result.layout.to_dict()


def test_a_group_is_planned_again_at_most_once_and_its_old_program_is_kept_if_the_model_is_gone() -> None:
    wish = "# reopen: sleeping: away with it\n" + APART

    def play(seen: Seen, number: int) -> Reply | str:
        if is_group(seen):
            return GROUPING
        if is_picture(seen):
            return wish
        return BED if len(programs(server, picture=False)) == 1 else Reply("gone", 500, {"retry-after-ms": "5"})

    with serving(play) as server:
        result = run(server)
    assert result.report.planner["taken_over"] == {} and set(result.layout) == set(small_room().by_name)
    assert [sample.text for sample in result.samples if sample.kept and sample.group == "sleeping"] == [BED]


def test_what_the_words_ask_goes_back_when_everything_is_placed() -> None:
    scene = replace(small_room(), layout_criteria="The picture is opposite the bed.")
    opposite = PICTURE.replace("walls[3]", "walls[1]").replace("[0.02, 1.6", "[3.98, 1.6")
    with serving(playing([BED], [PICTURE, opposite])) as server:
        result = run(server, scene)
    _, again = programs(server, picture=True)
    assert "asked, and not met: " in again.user and result.report.asked_met_share == 1.0


def test_progress_says_group_attempt_and_money() -> None:
    heard: list[str] = []
    with serving(good) as server:
        asked = ModelPlanner("openai:gpt-4o", base_url=server.url, mode="no_image")
        rl.generate(small_room(), planner=asked, progress=heard.append)
    assert "plan decoration, attempt 1, $0.0090 so far" in heard
