"""Both common protocols, models good, clumsy and hostile: always a room, a budget that holds, a sentence for every fault, no key."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from vlm_rooms import BED, GROUPING, PICTURE, small_room
from vlm_server import Loopback, Reply, Seen, serving

import robolayout as rl
from robolayout.planners import ModelPlanner
from robolayout.scene import scene_to_dict
from running import run_command, slow

pytestmark = pytest.mark.usefixtures("ask_loopback")

KEY = "sk-very-secret-0123456789"
MODELS = {"openai": "openai:gpt-4o", "anthropic": "anthropic:claude-sonnet-5-5"}
HARD = ("placed_share", "collision_free_share", "in_boundary_share", "supported_share", "door_clear")
Play = Callable[[Seen, int], Reply | str]


@pytest.fixture(params=MODELS)
def protocol(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY"):
        monkeypatch.setenv(name, KEY)
    return request.param


def is_group(seen: Seen) -> bool:
    return "sort the furniture" in seen.system


def is_picture(seen: Seen) -> bool:
    return '"picture[0]"' in seen.user.partition("# What to place now")[2].partition("#")[0]


def good(seen: Seen, number: int) -> str:
    return GROUPING if is_group(seen) else PICTURE if is_picture(seen) else BED


def planner(protocol: str, server: Loopback, **options: Any) -> ModelPlanner:
    url = server.root if protocol == "anthropic" else server.url
    return ModelPlanner(MODELS[protocol], base_url=url, **{"mode": "no_image", "retries": 1, **options})


def made(asked: ModelPlanner) -> dict[str, Any]:
    """Lay the small room out and return its report: a valid room whoever planned it."""
    report = rl.generate(small_room(), planner=asked).report.to_dict()
    assert {name: float(report[name]) for name in HARD} == dict.fromkeys(HARD, 1.0), report["violations"]
    return report


def test_a_good_model_furnishes_the_room(protocol: str) -> None:
    with serving(good) as server:
        report = made(planner(protocol, server, mode="grouped", thinking="low"))
    assert report["planner"]["taken_over"] == {} and report["planner"]["usage"]["requests"] == 3
    assert report["planner"]["usage"]["cost"] > 0
    assert [len(seen.images) for seen in server.seen] == [0, 6, 4]
    assert [label.split(",")[0].split(":")[0] for label in server.seen[2].labels[:3]] == [
        "The plan of the room",
        "The room from above",
        "The room from the side",
    ]
    body = server.seen[1].body
    if protocol == "anthropic":
        assert body["thinking"]["type"] in ("enabled", "adaptive")
        assert body["system"][-1]["cache_control"], "what all questions share is kept by the provider"


FAULTS: dict[str, tuple[Play, str]] = {
    "a refusal": (lambda *_: "I am sorry, I cannot help with that.", "none of its programs could be read"),
    "filtered": (lambda *_: Reply("", finish="content_filter"), "gave no usable answer"),
    "cut off": (lambda *_: Reply("bed[0].position = [1.0, 1.", finish="length"), "none of its programs could be read"),
    "a page": (lambda *_: Reply(body=b"<html><body>502 Bad Gateway</body></html>"), ""),
    "half of it": (lambda *_: Reply(body=b'{"id": "1", "choices": [{"mess'), ""),
    "nothing": (lambda *_: "", ""),
    "numbers": (lambda *_: "42", ""),
    "prose": (lambda *_: "Put the bed where it is nice.", "none of its programs could be read"),
    "busy": (lambda *_: Reply("busy", 429, {"retry-after-ms": "5"}), "still busy"),
    "broken": (lambda *_: Reply(f"oops {KEY}", 500, {"retry-after-ms": "5"}), "failed after several tries (500)"),
    "too much": (lambda *_: Reply("x" * 5_000_000), "more than 4 MB"),
    "leaky": (lambda seen, _: f"# {seen.headers.get('authorization') or seen.headers.get('x-api-key')}\n{BED}", ""),
    "escaping": (lambda *_: "import os\nos.system('touch /tmp/escaped')", ""),
    "without end": (lambda *_: "while True:\n    pass", "none of its programs could be read"),
}


@pytest.mark.parametrize("fault", [slow(fault) if fault == "without end" else fault for fault in FAULTS])
@pytest.mark.parametrize("from_the_start", [False, slow(True)], ids=["programs", "everything"])
def test_each_kind_of_fault_ends_in_a_room_and_a_sentence(
    protocol: str, fault: str, from_the_start: bool, tmp_path: Path
) -> None:
    play, words = FAULTS[fault]

    def spoiled(seen: Seen, number: int) -> Reply | str:
        return GROUPING if is_group(seen) and not from_the_start else play(seen, number)

    with serving(spoiled) as server:
        report = made(planner(protocol, server, timeout=20.0, exchanges=tmp_path))
    told = " ".join(report["planner"]["sentences"])
    assert fault == "leaky" or report["planner"]["taken_over"], told
    assert words in told and not {"<html", '{"'} & {word for word in ("<html", '{"') if word in told}
    assert KEY not in json.dumps(report)
    assert not [path for path in tmp_path.iterdir() if KEY in path.read_text()]
    assert len(server.seen) <= 30, "bounded retries"


@pytest.mark.parametrize(
    ("status", "words"), [(401, "refused the key (401)"), (404, "there is no model"), (402, "has no credit left")]
)
def test_what_only_the_user_can_mend_is_said_at_once(protocol: str, status: int, words: str) -> None:
    with (
        serving(lambda *_: Reply(f"your key {KEY} is odd", status)) as server,
        pytest.raises(rl.RoboLayoutError) as said,
    ):
        made(planner(protocol, server))
    assert (words in str(said.value) or status == 402) and KEY not in str(said.value)


@pytest.mark.parametrize("tokens", [(1000, 200), (1000, 20_000)], ids=["usual", "long"])
@pytest.mark.parametrize("most", [0.0001, 0.012, 0.1, *(slow(size) for size in (0.003, 0.006, 0.03, 2.0))])
def test_budgets_of_every_size_hold_and_end_in_a_room(protocol: str, most: float, tokens: tuple[int, int]) -> None:
    with serving(lambda seen, n: Reply(good(seen, n), tokens=tokens)) as server:
        asked = planner(protocol, server, samples=3, max_cost=most)
        report = made(asked)
    spent = asked.usage.cost or 0.0
    one = spent / max(asked.usage.requests, 1)
    assert spent <= most + one + 1e-9, "at most one answer beyond the budget"
    assert report["planner"]["taken_over"] or spent > 0


def test_a_fallback_is_asked_where_the_first_model_fails(protocol: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(seen: Seen, number: int) -> Reply | str:
        return Reply("out", 500, {"retry-after-ms": "5"}) if "mini" not in seen.body["model"] else good(seen, number)

    with serving(broken) as server:
        monkeypatch.setenv("OPENAI_BASE_URL", server.url)
        report = made(planner(protocol, server, fallback=("openai:gpt-4o-mini",)))
    assert report["planner"]["taken_over"] == {}
    assert any("The next model was asked." in warning for warning in report["planner"]["warnings"])


def test_no_more_questions_at_once_than_allowed(protocol: str) -> None:
    with serving(lambda seen, n: Reply(good(seen, n), wait=0.05)) as server:
        made(planner(protocol, server, samples=4, at_once=2))
    assert server.most_at_once == 2


def test_the_command_line_knows_the_options(protocol: str, tmp_path: Path) -> None:
    room = tmp_path / "room.json"
    room.write_text(json.dumps(scene_to_dict(small_room(), base=tmp_path)), encoding="utf-8")
    with serving(good) as server:
        url = server.root if protocol == "anthropic" else server.url
        words = (
            "--model",
            MODELS[protocol],
            "--base-url",
            url,
            "--mode",
            "no_image",
            "--thinking",
            "low",
            "--no-cache",
        )
        more = ("--at-once", "1", "--fallback", "ollama:llava", "--no-pictures", "--json", "--out", tmp_path / "out")
        ran = run_command("generate", room, *words, *more)
    assert ran.code == 0, ran
    assert "cache_control" not in json.dumps(server.seen[1].body)
    assert KEY not in ran.out + ran.err
    assert not [p for p in (tmp_path / "out").rglob("*") if p.is_file() and KEY.encode() in p.read_bytes()]


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ({"thinking": "lots"}, "unknown level of thinking 'lots'"),
        ({"at_once": 0}, "0 questions at once; give a number from 1 to 64."),
        ({"timeout": -1.0}, "the timeout is -1 s; give more than 0 and at most 3600."),
    ],
)
def test_options_that_cannot_be_meant_are_one_sentence(option: dict[str, Any], words: str) -> None:
    with pytest.raises(rl.RoboLayoutError, match=words.replace("(", r"\(")):
        ModelPlanner("openai:gpt-4o", **option)
