"""`--model` with a sentence: the model says the room and its things, the reader of scene files checks, the ledger judges."""

from __future__ import annotations

import json
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from test_vlm_protocols import KEY, MODELS
from vlm_server import Loopback, Reply, Seen, serving

from robolayout.assets import CATALOGUE
from robolayout.planners import ModelPlanner
from robolayout.planners.model.rooms import choices
from running import Ran, run_command

pytestmark = pytest.mark.usefixtures("ask_loopback")

WORDS = "A bedroom of 4 x 3.5 m with a double bed and two night stands."
ROOM: dict[str, Any] = {
    "room_type": "bedroom",
    "corners": [[0, 0], [4, 0], [4, 3.5], [0, 3.5]],
    "wall_height": 2.6,
    "doors": [{"wall": 0, "offset": 2.9, "width": 0.9, "height": 2.05}],
    "windows": [{"wall": 2, "offset": 1.0, "width": 1.2, "height": 1.2, "sill": 0.9}],
    "things": [
        {"kind": "double bed", "count": 1},
        {"kind": "night stand", "count": 2, "size": [0.35, 0.4, 0.5]},
        {"kind": "wardrobe", "count": 1, "asked": False},
    ],
    "assumed": ["No height was given: 2.6 m was chosen."],
}


@pytest.fixture(params=MODELS)
def protocol(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY"):
        monkeypatch.setenv(name, KEY)
    return request.param


def changed(**parts: object) -> dict[str, Any]:
    return deepcopy(ROOM) | parts


def furnishing(server: Loopback, protocol: str, text: str = WORDS, **options: Any) -> tuple[Any, Any, ModelPlanner]:
    url = server.root if protocol == "anthropic" else server.url
    planner = ModelPlanner(MODELS[protocol], base_url=url, mode="no_image", **options)
    return *planner.furnish(text), planner


def test_the_model_says_the_room_and_the_command_lays_it_out(protocol: str, tmp_path: Path) -> None:
    def model(seen: Seen, number: int) -> str:
        return json.dumps(ROOM) if "what room they want" in seen.system else "I cannot."

    with serving(model) as server:
        url = server.root if protocol == "anthropic" else server.url
        words = ("--model", MODELS[protocol], "--base-url", url, "--mode", "one_shot", "--retries", "0")
        ran: Ran = run_command("generate", WORDS, *words, "--no-pictures", "--json", "--out", tmp_path / "out")
    assert ran.code in (0, 1), ran
    scene = json.loads((tmp_path / "out" / "scene.json").read_text())
    assert scene["task_description"] == WORDS
    assert list(scene["assets"]) == ["double_bed-0", "night_stand-0", "night_stand-1", "wardrobe-0"]
    assert scene["assets"]["night_stand-1"]["assetMetadata"]["boundingBox"] == {"x": 0.35, "y": 0.4, "z": 0.5}
    report = json.loads(ran.out)
    rows = {(row["kind"], row["verdict"]) for row in report["asked"]}
    assert {("count", "met"), ("room size", "met")} <= rows, "the ledger judges the sentence"
    understood = json.loads((tmp_path / "out" / "understood.json").read_text())
    assert understood["wished"] == {"double bed": 1, "night stand": 2} and understood["added"] == {"wardrobe": 1}
    assert "No height was given: 2.6 m was chosen." in ran.err
    asked = server.seen[0].user
    assert all(f"{name}: " in asked for name in CATALOGUE)
    assert len(list((tmp_path / "out" / "exchanges").glob("room-*.json"))) == 1
    again = (
        "--replay",
        tmp_path / "out" / "exchanges",
        "--mode",
        "one_shot",
        "--retries",
        "0",
        "--no-pictures",
        "--json",
    )
    run_command("generate", WORDS, *again, "--out", tmp_path / "again")
    for name in ("scene.json", "understood.json", "layout.json"):
        assert (tmp_path / "again" / name).read_bytes() == (tmp_path / "out" / name).read_bytes()


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (changed(things=[{"kind": "double bed", "count": 1}]), "night stands"),
        (changed(corners=[[0, 0], [5, 0], [5, 3.5], [0, 3.5]]), "4 x 3.5 m"),
        (changed(doors=[{"wall": 7, "offset": 1, "width": 0.9, "height": 2}]), "The room cannot be read: "),
        (changed(body="giraffe"), "there is no body 'giraffe'; known are "),
        (changed(things=[*ROOM["things"], {"kind": "flux capacitor", "count": 1}]), "is no kind of the list"),
        (changed(things=[*ROOM["things"], {"kind": "double bed", "count": 9}]), "at most 55% may be"),
    ],
    ids=["count", "size", "door", "body", "kind", "too full"],
)
def test_what_is_wrong_goes_back_and_is_mended(protocol: str, wrong: dict[str, Any], words: str) -> None:
    with serving(lambda seen, n: json.dumps(wrong if n == 1 else ROOM)) as server:
        scene, understood, planner = furnishing(server, protocol)
    assert len(scene.assets) == 4 and understood.room_type == "bedroom" and planner.warnings == ()
    assert len(server.seen) == 2
    assert words in server.seen[1].user + json.dumps(server.seen[1].body, ensure_ascii=False)


@pytest.mark.parametrize(
    "reply",
    [
        json.dumps(changed(corners=[[0, 0], [1, 1]])),
        "A lovely room.",
        Reply("oops", 500, {"retry-after-ms": "5"}),
        json.dumps(changed(things=[])),
        json.dumps(changed(wall_height=-1)),
    ],
    ids=["no room", "prose", "500", "empty", "below the floor"],
)
def test_rules_read_the_words_where_the_model_cannot(protocol: str, reply: Reply | str) -> None:
    with serving(lambda *_: reply) as server:
        scene, understood, planner = furnishing(server, protocol)
    assert {asset.category for asset in scene.assets} >= {"bed", "night stand"}
    assert understood.wished == {"bed": 1, "night stand": 2}
    (warning,) = planner.warnings
    assert warning.startswith("The words were read by rules instead of by ")
    assert len(server.seen) <= 3, "bounded retries"


def test_a_budget_too_small_for_the_words_ends_in_rules(protocol: str) -> None:
    with serving(lambda *_: json.dumps(ROOM)) as server:
        scene, _, planner = furnishing(server, protocol, max_cost=0.0001)
    assert not server.seen and len(scene.assets) >= 3
    assert "stopped at the budget" in planner.warnings[0]


def test_an_own_catalogue_is_offered(tmp_path: Path) -> None:
    box = {"boundingBox": {"x": 2.1, "y": 1.7, "z": 0.9}}
    entry = {"category": "double bed", "description": "oak", "onFloor": True, "assetMetadata": box}
    (tmp_path / "catalogue.json").write_text(json.dumps({"assets": {"oak bed": entry}}))
    known = choices(tmp_path)
    assert known["oak bed"].size == (2.1, 1.7, 0.9) and known["oak bed"].entry == {"from": "oak bed"}
    answer = changed(things=[{"kind": "oak bed", "count": 1}, {"kind": "night stand", "count": 2}])
    from robolayout.planners.model.rooms import Furnisher, Furnishing

    scene = Furnisher(WORDS, tmp_path).scene(Furnishing.model_validate(answer))
    assert scene.by_name["oak_bed-0"].size == (2.1, 1.7, 0.9) and scene.by_name["oak_bed-0"].description == "oak"


@pytest.mark.slow
def test_variants_and_seeds_are_asked_for_one_by_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", KEY)
    with serving(lambda *_: json.dumps(ROOM)) as server:
        words = ("--model", "openai:gpt-4o", "--base-url", server.url, "--mode", "one_shot", "--retries", "0")
        run_command("generate", WORDS, *words, "--variants", "2", "--no-pictures", "--quiet", "--out", tmp_path / "out")
    rooms = [seen.body["seed"] for seen in server.seen if "what room they want" in seen.system]
    assert rooms == [0, 1]
