"""Recorded exchanges: complete, without secrets, replayed byte for byte, and only for the job that they were given for."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from vlm_rooms import BED, GROUPING, PICTURE, small_room
from vlm_server import Reply, Seen, png, serving

from robolayout._errors import InputError, ModelError
from robolayout.planners import Group, ModelPlanner, PlanRequest
from robolayout.planners.model.exchange import NAME, read_exchanges, secrets
from robolayout.scene import Layout, Pose

pytestmark = pytest.mark.usefixtures("ask_loopback")

SCENE = small_room()
SLEEPING = Group("Sleeping & more", "The bed rules the room.", ("bed-0", "night_stand-0", "lamp-0"))
SECRET = "sk-this-is-a-secret-0123456789"


def model(seen: Seen, number: int) -> str:
    if "sort the furniture" in seen.system:
        return GROUPING if number > 1 else GROUPING.replace('"lamp-0"', '"throne-0"')
    again = "# again\n" if "Your program before" in seen.user else ""
    return f"```python\n{again}{PICTURE if 'picture' in seen.user.rsplit('# What to place now')[1][:400] else BED}```"


def job(planner: ModelPlanner) -> list[object]:
    """Run a whole job as the pipeline would: groups, samples, a second attempt, a rating."""
    groups = planner.group(SCENE)
    first = planner.plan_many(PlanRequest(SCENE, SLEEPING, images={"top": png("red")}), 3)
    second = planner.plan(PlanRequest(SCENE, SLEEPING, feedback="bed-0 is outside.", previous=first[0]))
    return [groups, first, second, planner.usage]


@pytest.fixture
def recorded(tmp_path: Path) -> tuple[Path, list[object]]:
    with serving(model) as server:
        return tmp_path / "exchanges", job(
            ModelPlanner("openai:gpt-4o", base_url=server.url, exchanges=tmp_path / "exchanges")
        )


def test_a_replay_gives_the_same_answers_without_a_network(recorded: tuple[Path, list[object]]) -> None:
    folder, live = recorded
    replay = ModelPlanner(replay=folder)
    assert job(replay) == live
    assert replay.model == "openai:gpt-4o"
    assert replay.warnings == ()
    assert live[3].requests == 6


def test_a_replay_writes_the_same_bytes(recorded: tuple[Path, list[object]], tmp_path: Path) -> None:
    folder, _ = recorded
    job(ModelPlanner(replay=folder, exchanges=tmp_path / "again"))
    first = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert first == {path.name: path.read_bytes() for path in (tmp_path / "again").iterdir()}
    assert len(first) == 6
    assert all(NAME.fullmatch(name) for name in first)


def test_an_exchange_tells_everything_that_was_said(recorded: tuple[Path, list[object]]) -> None:
    entries = read_exchanges(recorded[0])
    turn = entries["group", "everything", 1, 1, 2]
    assert "These things are in no group: lamp-0." in turn["request"]["feedback"]
    plan = entries["plan", "Sleeping & more", 1, 3, 1]
    assert plan["request"]["images"][0]["label"].startswith("The room from above")
    assert plan["request"]["images"][0]["bytes"] == len(png("red"))
    assert "bed[0]" in plan["request"]["texts"][0]
    assert "solver.against_wall(" in plan["request"]["instructions"]
    assert plan["prompt_version"] and plan["model"] == "openai:gpt-4o"
    assert plan["answer"]["usage"] == {"input_tokens": 1000, "output_tokens": 200, "cost": "0.0045"}
    again = entries["plan", "Sleeping & more", 2, 1, 1]
    assert "bed-0 is outside." in again["request"]["texts"][2]
    assert again["answer"]["parts"][0]["content"].startswith("```python\n# again")


def test_no_key_is_ever_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", SECRET)

    def leaky(seen: Seen, number: int) -> Reply:
        assert seen.headers["authorization"] == f"Bearer {SECRET}"
        return Reply(f"```python\n# {seen.headers['authorization']}\n{BED}```")

    with serving(leaky) as server:
        planner = ModelPlanner("openai:gpt-4o", base_url=server.url, exchanges=tmp_path)
        text = planner.plan(PlanRequest(SCENE, SLEEPING, feedback=f"echo {SECRET}"))
    written = b"".join(path.read_bytes() for path in tmp_path.rglob("*") if path.is_file())
    assert SECRET.encode() not in written and b"Bearer [secret]" in written
    assert SECRET not in text
    assert server.url.encode() not in written
    assert ModelPlanner(replay=tmp_path).plan(PlanRequest(SCENE, SLEEPING, feedback="echo")) == text


def test_what_counts_as_a_secret() -> None:
    found = secrets({"A_API_KEY": "123456", "GH_TOKEN": "longer-secret", "SHORT_KEY": "abc", "HOME": "/home/somebody"})
    assert found == ("longer-secret", "123456")


@pytest.mark.parametrize(
    "request_of",
    [
        lambda: PlanRequest(dataclasses.replace(SCENE, task_description="A shop."), SLEEPING),
        lambda: PlanRequest(small_room("a golden bed"), SLEEPING),
        lambda: PlanRequest(SCENE, dataclasses.replace(SLEEPING, items=("bed-0",))),
        lambda: PlanRequest(SCENE.with_agents(dataclasses.replace(SCENE.agent, radius=0.5)), SLEEPING),
    ],
    ids=["task", "asset", "group", "agent"],
)
def test_an_answer_to_another_job_is_refused(
    recorded: tuple[Path, list[object]], request_of: Callable[[], PlanRequest]
) -> None:
    with pytest.raises(
        InputError, match=r"was given for another room, instruction, body, group or mode\. Record again"
    ):
        ModelPlanner(replay=recorded[0]).plan(request_of())


def test_another_mode_is_another_job(recorded: tuple[Path, list[object]]) -> None:
    with pytest.raises(InputError, match="another room, instruction, body, group or mode"):
        ModelPlanner(replay=recorded[0], mode="no_image").plan(PlanRequest(SCENE, SLEEPING))


def test_another_state_of_the_room_is_noted(recorded: tuple[Path, list[object]]) -> None:
    replay = ModelPlanner(replay=recorded[0])
    moved = Layout({"picture-0": Pose(0.0, 1.0, 1.5, 0.0)})
    assert BED in replay.plan(PlanRequest(SCENE, SLEEPING, moved))
    assert replay.warnings == (
        "the replayed answer to 'plan' for group 'Sleeping & more' was given to another wording or another state of the room.",
    )


def test_a_question_without_an_answer_is_told(recorded: tuple[Path, list[object]]) -> None:
    replay = ModelPlanner(replay=recorded[0])
    for _ in range(2):
        replay.plan(PlanRequest(SCENE, SLEEPING))
    with pytest.raises(ModelError, match=r"no answer to 'plan' for group 'Sleeping & more', attempt 3; recorded are 6"):
        replay.plan(PlanRequest(SCENE, SLEEPING))


def test_an_earlier_recording_gives_way_and_other_files_stay(recorded: tuple[Path, list[object]]) -> None:
    folder, _ = recorded
    (folder / "notes.json").write_text("{}")
    with serving(model) as server:
        ModelPlanner("openai:gpt-4o", base_url=server.url, exchanges=folder).plan(PlanRequest(SCENE, SLEEPING))
    assert len(list(folder.iterdir())) == 2


def test_a_recording_is_not_replaced_while_it_is_read(recorded: tuple[Path, list[object]]) -> None:
    with pytest.raises(InputError, match="Give another folder to record to"):
        ModelPlanner(replay=recorded[0], exchanges=recorded[0])


@pytest.mark.parametrize(
    "content",
    ["", "[]", "{}", '{"kind": "plan"}', "[" * 100_000, '{"format": 9}'],
)
def test_a_folder_of_other_files_is_refused(tmp_path: Path, content: str) -> None:
    (tmp_path / "a.json").write_text(content)
    with pytest.raises(InputError, match="is no recorded exchange of format 1"):
        ModelPlanner(replay=tmp_path)


def test_a_tampered_exchange_is_refused(recorded: tuple[Path, list[object]]) -> None:
    path = next(recorded[0].glob("plan*"))
    entry = json.loads(path.read_text())
    for answer in ({"parts": [{"kind": "text", "content": 1}]}, {"parts": 1}, {}, None):
        path.write_text(json.dumps({**entry, "answer": answer}))
        with pytest.raises(InputError, match="is no recorded exchange"):
            ModelPlanner(replay=recorded[0])


def test_an_empty_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="holds no recorded exchanges"):
        ModelPlanner(replay=tmp_path / "nowhere")
