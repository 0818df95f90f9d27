"""`settle`, `drive` and `generate --settle`: figures on the terminal, in a file and in the report."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import pytest

from robolayout.export import settle
from robolayout.scene import Asset, Layout, Pose, Room, Scene
from robolayout.verify import verify
from running import Furnished, Ran

Command = Callable[..., Ran]

ARMED = """<robot name="armed"><link name="base"><collision><origin xyz="0 0 0.2"/><geometry><box size="0.5 0.4 0.4"/></geometry>
</collision></link><link name="hand"><collision><origin xyz="0.3 0 0"/><geometry><box size="0.6 0.05 0.05"/></geometry></collision>
</link><joint name="shoulder" type="revolute"><parent link="base"/><child link="hand"/><origin xyz="0 0 0.6"/>
<axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="5" velocity="1"/></joint></robot>"""


@pytest.fixture(scope="module")
def given(furnished: Furnished) -> tuple[Path, Path]:
    return (furnished.folder / "scene.json", furnished.folder / "layout.json")


def test_settle_prints_and_writes_every_asset(command: Command, given: tuple[Path, Path], tmp_path: Path) -> None:
    report = tmp_path / "settled.json"
    ran = command("settle", *given, "--seconds", 1, "--report", report)
    assert ran.code == 0, ran
    assert "1.00 of the assets stay" in ran.out and "wardrobe-0" in ran.out and " mm" in ran.out
    found = json.loads(report.read_text())
    assert found["stable_share"] == 1.0 and found["seconds"] == 1.0 and found["violations"] == []
    assert found["assets"]["double_bed-0"]["stable"] is True
    assert set(found["assets"]["double_bed-0"]) == {"displacement", "tilt", "stable"}


def test_what_does_not_stay_is_exit_code_1(command: Command, given: tuple[Path, Path], tmp_path: Path) -> None:
    layout = json.loads(given[1].read_text())
    layout["wardrobe-0"]["position"][2] += 0.4
    moved = tmp_path / "layout.json"
    moved.write_text(json.dumps(layout))
    ran = command("settle", given[0], moved, "--seconds", 1, "--json")
    found = json.loads(ran.out)
    assert ran.code == 1 and found["stable_share"] < 1.0
    assert found["violations"][0].startswith("wardrobe-0 does not stay: it moved")
    assert command("settle", given[0], moved, "--seconds", 1, "--quiet") == Ran(1, "", "")


def test_drive_writes_every_route(command: Command, given: tuple[Path, Path], tmp_path: Path) -> None:
    report = tmp_path / "driven.json"
    ran = command("drive", *given, "--report", report)
    assert ran.code == 0 and ran.out.startswith("0 contacts"), ran
    routes = json.loads(report.read_text())["routes"]
    assert routes["double_bed-0"]["length"] > 0.05
    assert not any(way["contacts"] for way in routes.values())


def test_the_report_says_what_gravity_does_when_asked(command: Command, furnished: Furnished, tmp_path: Path) -> None:
    program = furnished.folder / "program.py"
    words = ("--program", program, "--starts", 1, "--no-pictures", "--quiet", "--settle", "--out", tmp_path)
    assert command("generate", furnished.scene, *words).code in (0, 1)
    report = json.loads((tmp_path / "report.json").read_text())
    assert 0.9 <= report["stability"]["stable_share"] <= 1.0
    assert "## In a simulator" in (tmp_path / "report.md").read_text()
    assert "stability" not in json.loads((furnished.folder / "report.json").read_text())


@pytest.mark.parametrize("name", ["settle", "drive"])
def test_a_report_that_cannot_be_written_is_refused_first(
    command: Command, given: tuple[Path, Path], tmp_path: Path, name: str
) -> None:
    ran = command(name, *given, "--report", tmp_path / "report.txt")
    assert ran.code == 2 and "name a file that ends in .json" in ran.err
    (tmp_path / "file").write_text("")
    ran = command(name, *given, "--report", tmp_path / "file" / "report.json")
    assert ran.code == 2 and "is not a folder" in ran.err


@pytest.mark.parametrize("words", [("settle",), ("drive",), ("generate", "--settle")])
def test_without_mujoco_the_extra_is_named_before_any_work(
    command: Command, given: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]
) -> None:
    monkeypatch.setattr(import_module("robolayout.export._mujoco"), "find_spec", lambda name: None)
    out = ("--out", tmp_path / "out") if words[0] == "generate" else (given[1],)
    ran = command(words[0], given[0], *words[1:], *out)
    assert ran.code == 2 and "needs the extra 'sim': pip install 'robolayout[sim]'" in ran.err, ran
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("drive", "--doors", "ajar"), "unknown way for doors to stand 'ajar'. Known: open, shut, swinging."),
        (("export", "--to", "mjcf", "--doors", "ajar"), "unknown way for doors to stand 'ajar'"),
        (("export", "--to", "mjcf", "--body", "arm"), "unknown body to export 'arm'. Known: base, full, none."),
    ],
)
def test_unknown_ways_are_refused(
    words: tuple[str, ...], said: str, command: Command, given: tuple[Path, Path]
) -> None:
    ran = command(words[0], *given, *words[1:])
    assert ran.code == 2 and said in ran.err


def test_a_model_is_written_without_the_body_and_with_open_doors(
    command: Command, given: tuple[Path, Path], tmp_path: Path
) -> None:
    ran = command("export", *given, "--to", "mjcf", "--body", "none", "--doors", "open", "--out", tmp_path)
    text = (tmp_path / "scene.xml").read_text()
    assert ran.code == 0 and 'name="agent"' not in text and '<key name="home"' in text
    assert 'joint name="room/door-0"' not in text and 'name="wardrobe-0/door 0"' in text


@pytest.mark.slow
def test_the_whole_model_of_a_robot_is_written_and_no_file_of_a_run_says_where_it_lies(
    command: Command, furnished: Furnished, tmp_path: Path
) -> None:
    robot, out = tmp_path / "mine" / "armed.urdf", tmp_path / "run"
    robot.parent.mkdir()
    robot.write_text(ARMED)
    program = furnished.folder / "program.py"
    assert command("generate", furnished.scene, "--agent", robot, "--program", program, "--out", out).code in (0, 1)
    given = (out / "scene.json", out / "layout.json")
    assert command("export", *given, "--agent", robot, "--to", "mjcf", "--body", "full", "--out", out).code == 0
    text = (out / "scene.xml").read_text()
    assert 'name="agent/shoulder"' in text and 'name="agent/yaw"' in text
    ran = command("export", *given, "--to", "mjcf", "--body", "full", "--out", out / "base")
    assert ran.code == 0 and "shoulder" not in (out / "base" / "scene.xml").read_text(), "figures alone have no model"
    assert json.loads(given[0].read_text())["agent"]["height"]
    for file in out.rglob("*"):
        assert file.is_dir() or str(robot.parent).encode() not in file.read_bytes(), file


def test_what_falls_makes_the_verdict_short() -> None:
    room = Room(((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)), 2.6)
    scene = Scene(room, (Asset("stool-0", "stool", (0.4, 0.4, 0.45)),))
    for height, short in ((0.225, False), (0.3, True)):
        layout = Layout({"stool-0": Pose(2.0, 2.0, height, 0.0)})
        found = settle(scene, layout, 1.0)
        assert settle(scene, layout, 1.0).to_dict() == found.to_dict()
        report = replace(verify(scene, layout), stability=found.to_dict())
        assert ("stable_share" in report.unmet) == short and not (short and report.ok)
        assert any("stool-0 does not stay" in sentence for sentence in report.violations) == short
