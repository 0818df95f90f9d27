"""A model as judge: votes with their spread, recorded and replayed, beside the report and never in its verdict."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from benchmarks import against
from test_vlm_protocols import KEY, MODELS, good
from vlm_rooms import small_room
from vlm_server import Loopback, Reply, Seen, serving

import robolayout as rl
from robolayout.scene import scene_to_dict
from running import Ran, run_command

pytestmark = pytest.mark.usefixtures("ask_loopback")


@pytest.fixture(params=MODELS)
def protocol(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    for name in ("OPENAI_API_KEY", "ANTHROPIC_API_KEY"):
        monkeypatch.setenv(name, KEY)
    return request.param


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("room")
    result = rl.generate(small_room())
    (folder / "room.json").write_text(json.dumps(scene_to_dict(small_room(), base=folder)))
    (folder / "layout.json").write_text(json.dumps(result.layout.to_dict()))
    return folder


def voting(seen: Seen, number: int) -> str:
    return json.dumps({"positional": 60 + 10 * number, "rotational": 90, "reasons": ["lamp[0] is far."]})


def check(server: Loopback | None, protocol: str, folder: Path, *words: object) -> Ran:
    given: tuple[object, ...] = ()
    if server is not None:
        given = ("--judge", MODELS[protocol], "--base-url", server.root if protocol == "anthropic" else server.url)
    return run_command("check", folder / "room.json", folder / "layout.json", *given, *words, "--no-pictures")


def test_votes_with_their_spread_are_in_the_report(protocol: str, laid_out: Path, tmp_path: Path) -> None:
    with serving(voting) as server:
        ran = check(server, protocol, laid_out, "--json", "--out", tmp_path / "out", "--max-cost", "1")
    assert ran.code == 0, ran
    found = json.loads(ran.out)["opinion"]
    assert found["positional"] == {
        "mean": 80.0,
        "lowest": 70,
        "highest": 90,
        "deviation": pytest.approx(8.165, abs=1e-3),
    }
    assert found["rotational"]["deviation"] == 0.0 and found["psa"] == pytest.approx(85.0)
    assert len(found["votes"]) == 3 and "positional coherence 80 of 100 (70 to 90" in found["sentences"][0]
    for seen in server.seen:
        assert seen.labels == ["The finished room from above.", "The finished room from the side."]
        assert seen.images[0].size == (768, 768)
        assert "A bedroom for one." in seen.user and "collision" not in seen.user, "it judges by itself"
    report = (tmp_path / "out" / "report.md").read_text()
    assert "## What a model thinks" in report and "lamp[0] is far." in report
    again = check(None, protocol, laid_out, "--json", "--replay", tmp_path / "out" / "judged")
    assert json.loads(again.out)["opinion"] == found
    assert not [p for p in tmp_path.rglob("*") if p.is_file() and KEY.encode() in p.read_bytes()]


@pytest.mark.slow
def test_a_recorded_vote_belongs_to_its_layout(laid_out: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", KEY)
    with serving(voting) as server:
        check(server, "openai", laid_out, "--out", tmp_path / "out", "--votes", "1", "--quiet")
    moved = json.loads((laid_out / "layout.json").read_text())
    moved["picture-0"]["position"][2] += 0.1
    (tmp_path / "room.json").write_text((laid_out / "room.json").read_text())
    (tmp_path / "layout.json").write_text(json.dumps(moved))
    ran = check(None, "openai", tmp_path, "--votes", "1", "--replay", tmp_path / "out" / "judged")
    assert ran.code == 2 and "was given for another room" in ran.err


def test_a_room_that_is_not_plausible_has_no_psa(
    laid_out: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", KEY)
    layout = json.loads((laid_out / "layout.json").read_text())
    layout["night_stand-0"]["position"][:2] = layout["bed-0"]["position"][:2]
    (tmp_path / "room.json").write_text((laid_out / "room.json").read_text())
    (tmp_path / "layout.json").write_text(json.dumps(layout))
    with serving(voting) as server:
        ran = check(server, "openai", tmp_path, "--json", "--votes", "1")
    assert ran.code == 1 and json.loads(ran.out)["opinion"]["psa"] == 0.0


@pytest.mark.parametrize(
    "reply",
    [
        Reply(f"oops {KEY}", 500, {"retry-after-ms": "5"}),
        "I like it.",
        json.dumps({"positional": 400, "rotational": 90}),
        Reply(f"who are you, {KEY}?", 401),
    ],
    ids=["500", "prose", "beyond the scale", "wrong key"],
)
def test_without_a_vote_the_report_says_why(protocol: str, laid_out: Path, reply: Reply | str) -> None:
    with serving(lambda *_: reply) as server:
        ran = check(server, protocol, laid_out, "--votes", "1")
    assert ran.code == 0 and "No model scored the room: " in ran.out
    assert KEY not in ran.out + ran.err


@pytest.mark.slow
def test_one_command_measures_a_model_against_the_rules(
    protocol: str, laid_out: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def model(seen: Seen, number: int) -> str:
        return voting(seen, 1) if "You judge how furniture" in seen.system else good(seen, number)

    room, out = str(laid_out / "room.json"), str(tmp_path / "against")
    with serving(model) as server:
        url = server.root if protocol == "anthropic" else server.url
        judged = ["--judge", MODELS[protocol]]
        against.main(
            ["--model", MODELS[protocol], "--base-url", url, "--out", out, "--mode", "no_image", *judged, room]
        )
    told = capsys.readouterr().out
    heads, _, *rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in told.splitlines()]
    assert heads == against.HEADS
    found: dict[str, dict[str, Any]] = {row[0]: dict(zip(heads, row, strict=True)) for row in rows}
    assert list(found) == [
        *(f"room, {who}" for who in (against.RULES, MODELS[protocol])),
        *(f"**all, {who}**" for who in (against.RULES, MODELS[protocol])),
    ]
    by_model = found[f"**all, {MODELS[protocol]}**"]
    assert by_model["right"] == "1 of 1" and by_model["PSA"] == "80" and float(by_model["$"]) > 0
    assert by_model["planned by rules"] == "0 of 2 groups" and found["**all, by rules**"]["$"] == "0.0000"
    again = ["--model", MODELS[protocol], "--out", out, "--mode", "no_image", *judged, "--replay", room]
    against.main(again)
    without_seconds = [[c for i, c in enumerate(row) if heads[i] != "s"] for row in rows]
    replayed = [[c.strip() for c in line.split("|")[1:-1]] for line in capsys.readouterr().out.splitlines()][2:]
    assert [[c for i, c in enumerate(row) if heads[i] != "s"] for row in replayed] == without_seconds
