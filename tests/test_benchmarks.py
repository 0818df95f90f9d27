"""The benchmark command: its rooms are what they claim, its results are kept, its page follows from them."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from benchmarks import __main__ as command
from benchmarks import bodies, demands, page, words
from benchmarks.measures import SHARES
from benchmarks.rooms import Crowd, crowd
from benchmarks.seen import Room
from benchmarks.store import Row, Store

import robolayout as rl
from robolayout.words import AskedRow


@pytest.mark.parametrize(
    "asked", [Crowd(10, 0.30, 0), Crowd(40, 0.60, 3, concave=True), Crowd(20, 0.45, 1, contradictions=6)]
)
def test_rooms_are_as_full_as_they_claim_and_their_programs_read(asked: Crowd) -> None:
    scene = rl.scene_from_dict(crowd(asked)[0])
    corners = scene.room.vertices
    area = (
        abs(sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in zip(corners, (*corners[1:], corners[0]), strict=True))) / 2
    )
    taken = sum(asset.size[0] * asset.size[1] for asset in scene.assets)
    assert len(scene.assets) == asked.count and scene.warnings == ()
    assert taken / area == pytest.approx(asked.fill, abs=0.005)
    assert len(corners) == (6 if asked.concave else 4)
    program = rl.read_program(crowd(asked)[1], scene)
    assert len(program.guesses) == asked.count
    assert len(program.statements) >= asked.count // 5 + 2 * asked.contradictions
    assert crowd(asked) == crowd(asked)


def test_every_section_has_cases_with_names_of_their_own() -> None:
    for name in set(command.SECTIONS) - {"fuzz", "lists", "tasks", "words"}:
        for quick in (True, False):
            keys = [key for key, _ in command.SECTIONS[name].cases(quick)]
            assert keys and len(set(keys)) == len(keys)


def test_a_demand_is_dropped_where_no_row_is_about_it() -> None:
    row = AskedRow("plant in corner", "relation", "", ("plant-0",), "unmet", "")
    asked = [
        demands.Demand("corner", ("plant",)),
        demands.Demand("wall", ("plant",)),
        demands.Demand("near", ("plant", "bed")),
    ]
    prompt = demands.Prompt("", tuple(asked))
    square = {"boundary": {"floor_vertices": [[0, 0], [4, 0], [4, 4], [0, 4]], "wall_height": 2.6}, "assets": {}}
    room = Room(square, {})
    assert words.dropped(prompt, [False] * 3, room, [row]) == asked[1:]
    assert words.dropped(prompt, [False, True, True], room, [row]) == []


@pytest.mark.parametrize(
    ("kind", "turn", "met"), [("desk", 180, True), ("desk", 0, False), ("sofa", 0, True), ("sofa", 180, False)]
)
def test_who_sits_at_two_desks_that_face_each_other_looks_over_their_backs(kind: str, turn: int, met: bool) -> None:
    """Sofas look where their fronts do."""
    things = {
        name: {"category": kind, "assetMetadata": {"boundingBox": {"x": 0.7, "y": 1.4, "z": 0.7}}} for name in "ab"
    }
    square = {"boundary": {"floor_vertices": [[0, 0], [4, 0], [4, 4], [0, 4]], "wall_height": 2.6}, "assets": things}
    layout = {
        "a": {"position": [1.0, 2.0, 0.35], "rotation": [0, 0, turn]},
        "b": {"position": [3.0, 2.0, 0.35], "rotation": [0, 0, turn + 180]},
    }
    prompt = demands.Demand("facing", (kind, kind))
    assert demands.related(Room(square, layout), prompt, 2) is met


def test_what_is_measured_is_kept_and_not_measured_again(tmp_path: Path) -> None:
    measured: list[str] = []

    def case(key: str) -> Row:
        measured.append(key)
        return {"wall": 0.123456789}

    keys = ["a", "b"]

    def cases() -> dict[str, Callable[[], Row]]:
        return {key: lambda key=key: case(key) for key in keys}

    file = tmp_path / "speed.json"
    command.measure("speed", cases(), Store(file), fresh=False)
    keys.append("c")
    command.measure("speed", cases(), Store(file), fresh=False)
    assert measured == ["a", "b", "c"]
    assert json.loads(file.read_text())["rows"]["a"] == {"wall": 0.12346}
    command.measure("speed", cases(), Store(file), fresh=True)
    assert measured == ["a", "b", "c"] * 2 or measured[3:] == ["a", "b", "c"]


def test_the_page_follows_from_the_results(tmp_path: Path) -> None:
    row: Row = dict.fromkeys(SHARES, 1.0) | {"ok": True, "hard_ok": True, "exempt": 0, "wall": 1.5, "cpu": 2.5}
    poor: Row = row | {"reachable_share": 0.999, "ok": False}
    store = Store(tmp_path / "examples.json")
    store.save("bedroom/wheelchair/0", row)
    store.save("bedroom/wheelchair/1", poor)
    store = Store(tmp_path / "crowded.json")
    for fill in ("30%", "45%"):
        store.save(f"program/default/10 assets/{fill}/0", row)
    page.write(tmp_path, tmp_path / "page.md", {name: module.section for name, module in command.SECTIONS.items()})
    text = (tmp_path / "page.md").read_text()
    assert "| bedroom, wheelchair | 1 of 2 |" in text
    assert "| 0.99 |" in text, "1.00 is only written where every run has it"
    assert "Section 'ablation' has not been measured" in text
    assert (tmp_path / "images" / "benchmark-crowded.png").read_bytes().startswith(b"\x89PNG")


def test_pictures_and_exports_without_a_tool_still_have_a_page(tmp_path: Path) -> None:
    row: Row = {"assets": 3, "plan.svg_cpu": 0.051, "plan.svg_kb": 38.2, "rays_load": 0.1, "rays_top": 0.55}
    Store(tmp_path / "pictures.json").save("bedroom", row)
    row = {
        "assets": 3,
        "read_back": 5e-7,
        "stable_share": 1.0,
        "moved_mm": 0.2,
        "tilt": 0.01,
        "contacts": 0,
        "routes": 2,
    }
    Store(tmp_path / "exports.json").save("bedroom", row | {"off_mm": 1.5})
    page.write(tmp_path, tmp_path / "page.md", {name: module.section for name, module in command.SECTIONS.items()})
    text = (tmp_path / "page.md").read_text()
    assert "| plan.svg | 0.05 s, 38 kB |" in text
    assert "| OpenGL in software, top view, 512 x 512 | - |" in text and "512 x 512 | 0.55 s |" in text
    assert "| bedroom | 3 | 5e-07 | - | - | 1.00 | 0.2 mm, 0.01 degrees | 0 on 2 routes | 1.5 mm |" in text


def test_the_page_says_what_minding_reach_is_worth_for_each_body() -> None:
    poor: Row = dict.fromkeys(SHARES, 0.5) | {"ok": False, "hard_ok": False, "wall": 1.0}
    rich: Row = dict.fromkeys(SHARES, 1.0) | {"ok": True, "hard_ok": True, "wall": 1.0}
    ways = list(bodies.WAYS)
    text = bodies.section({f"reach/{ways[1]}/spot/bedroom/0": poor, f"reach/{ways[3]}/spot/bedroom/0": rich}, Path())
    assert f"| body | {ways[1]} | {ways[3]} |" in text
    assert "| spot | 0.50 / 0.50 / 0.50 | 1.00 / 1.00 / 1.00 |" in text


def _placed(**things: tuple[str, float, float, float]) -> Room:
    """A room of 6 by 4 m whose door is in the south wall, and things of 0.6 by 1.2 by 0.8 m by kind, place and yaw."""
    box = {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.8}}
    scene = {
        "boundary": {"floor_vertices": [[0, 0], [6, 0], [6, 4], [0, 4]], "wall_height": 2.6},
        "assets": {name: {"category": kind, "assetMetadata": box} for name, (kind, *_) in things.items()},
        "doors": [{"wall": 0, "offset": 0.3, "width": 0.9}],
    }
    layout = {name: {"position": [x, y, 0.4], "rotation": [0, 0, yaw]} for name, (_, x, y, yaw) in things.items()}
    return Room(scene, layout)


@pytest.mark.parametrize(
    ("asked", "met"),
    [
        ("atwall north desk", True),
        ("atwall south desk", False),
        ("wallmiddle desk", True),
        ("wallmiddle bookcase", False),
        ("longwall desk", True),
        ("shortwall desk", False),
        ("incorner north-east bookcase", True),
        ("incorner southwest bookcase", False),
        ("cornerfar bookcase", True),
        ("doorside desk", False),
        ("samewall bookcase, desk", True),
        ("samewall bookcase, bench", False),
        ("otherwall bench, desk", True),
        ("apart >=1 desk, bench", True),
        ("apart <=1 desk, bench", False),
        ("apart 2.8 desk, bench", True),
        ("wide 1.2 desk", True),
        ("wide 2 desk", False),
        ("high 0.8 desk", True),
        ("free front 2 desk", True),
        ("free front 3.5 desk", False),
        ("free right 1 bookcase", False),
        ("rows 1 locker", True),
        ("rows 3 locker", False),
        ("back locker", True),
        ("back bench", False),
        ("each samewall 1 bookcase, desk", True),
        ("each samewall 2 bookcase, desk", False),
        ("next 1 locker, bench", False),
        ("desk 1", True),
        ("desk >=2", False),
        ("high chair 0", True),
        ("left bench, door", True),
        ("right bench, door", False),
        ("left locker, door", False),
        ("opposite desk, door", True),
        ("apart >=3 desk, door", True),
        ("wide 0.9 door", True),
        ("wallmiddle door", False),
        ("half west door", True),
        ("shortwall door", False),
        ("facing desk, door", False),
        ("doorwall south", True),
        ("doorwall north", False),
    ],
)
def test_demands_are_judged_by_plain_geometry(asked: str, met: bool) -> None:
    room = _placed(
        desk=("desk", 3.0, 3.7, 270),
        bookcase=("bookcase", 5.7, 3.4, 180),
        bench=("bench", 3.0, 0.3, 90),
        one=("locker", 1.0, 2.0, 0),
        two=("locker", 0.4, 2.0, 180),
    )
    assert demands.verdicts(demands.Prompt("", (demands.demand(asked),)), room, "office") == [met]


@pytest.mark.parametrize("text", ["wide desk", "upon lamp, desk", "each on lamp, desk", "apart desk, bed"])
def test_what_is_no_demand_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"is no demand|has no number"):
        demands.demand(text)
