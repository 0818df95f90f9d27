"""`check --out` and `diff`: what anybody's layout is worth, as files, and what differs between two of them."""

from __future__ import annotations

import io
import json
import math
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

import robolayout as rl
from robolayout.scene import Layout, Pose
from running import ROOT, Furnished, Ran

Command = Callable[..., Ran]
SCENE = ROOT / "examples" / "bedroom.json"
TEXTS = {"scene.json", "layout.json", "report.json", "report.md", "run.json", "scene.glb"}
DRAWN = {"report.html", "plan.svg", "sheet.pdf", "top.png", "view.png"}


def changed(furnished: Furnished, folder: Path, change: Callable[[dict[str, Any]], object]) -> Path:
    """Write the furnished room with a changed layout, as a folder of its own, and return it."""
    folder.mkdir()
    for name in ("scene.json", "program.py"):
        (folder / name).write_bytes((furnished.folder / name).read_bytes())
    layout = json.loads((furnished.folder / "layout.json").read_text())
    change(layout)
    (folder / "layout.json").write_text(json.dumps(layout))
    return folder


def shifted(name: str, x: float = 0.0, y: float = 0.0, turn: float = 0.0) -> Callable[[dict[str, Any]], object]:
    def change(layout: dict[str, Any]) -> None:
        position, rotation = layout[name]["position"], layout[name]["rotation"]
        layout[name] = {
            "position": [position[0] + x, position[1] + y, position[2]],
            "rotation": [0, 0, rotation[2] + turn],
        }

    return change


def test_check_writes_what_a_run_writes_without_the_search(
    command: Command, furnished: Furnished, tmp_path: Path
) -> None:
    out = tmp_path / "checked"
    words = ("check", SCENE, furnished.folder / "layout.json", "--agent", "wheelchair,cat", "--out", out)
    ran = command(*words, "--date", "1 May 2031", "--json")
    assert ran.code == 0, ran
    assert {path.name for path in out.iterdir()} == TEXTS | DRAWN | {"plan_2_cat.svg"}
    report = json.loads((out / "report.json").read_text())
    assert report["ok"] is json.loads(ran.out)["ok"] is True and report["statements"] == []
    assert (out / "scene.json").read_bytes() != b"" and Image.open(out / "top.png").size == (900, 900)
    assert b"report" in (out / "report.html").read_bytes()
    again = command("check", out / "scene.json", out / "layout.json", "--quiet")
    assert again.code == 0 and again.out == "", "its own output fits"


def test_check_writes_the_program_that_it_measured_and_draws_nothing_if_asked(
    command: Command, furnished: Furnished, tmp_path: Path
) -> None:
    given = (
        furnished.folder / "scene.json",
        furnished.folder / "layout.json",
        "--program",
        furnished.folder / "program.py",
    )
    ran = command("check", *given, "--no-pictures", "--out", tmp_path)
    assert ran.code == 0 and str(tmp_path / "report.md") in ran.out, ran
    assert {path.name for path in tmp_path.iterdir()} == TEXTS | {"program.py", "constraints.json"}
    statements = json.loads((tmp_path / "report.json").read_text())["statements"]
    assert statements and all(item["met"] for item in statements)
    assert (tmp_path / "program.py").read_text() == (furnished.folder / "program.py").read_text()


def test_a_date_without_a_sheet_is_refused(command: Command, furnished: Furnished) -> None:
    ran = command("check", SCENE, furnished.folder / "layout.json", "--date", "today")
    assert ran.code == 2 and "give --out" in ran.err


def test_nothing_differs_from_itself(command: Command, furnished: Furnished) -> None:
    ran = command("diff", furnished.folder, furnished.folder)
    assert (ran.code, ran.out) == (0, "Nothing differs.\n")


def test_diff_says_how_far_things_moved_and_turned_farthest_first(
    command: Command, furnished: Furnished, tmp_path: Path
) -> None:
    def change(layout: dict[str, Any]) -> None:
        shifted("armchair-0", turn=-350)(layout)
        shifted("rug-0", x=0.03, y=0.04)(layout)
        shifted("dresser-0", x=-0.4)(layout)

    other = changed(furnished, tmp_path / "other", change)
    ran = command("diff", furnished.folder, other, "--json")
    things = [row for row in json.loads(ran.out)["changes"] if row["kind"] == "thing"]
    assert [row["name"] for row in things] == ["dresser-0", "rug-0", "armchair-0"]
    assert [row["metres"] for row in things] == pytest.approx([0.4, 0.05, 0.0])
    assert [row["degrees"] for row in things] == pytest.approx([0.0, 0.0, 10.0])
    assert things[0]["text"] == "moved 0.40 m" and things[2]["text"] == "turned 10 degrees"


def test_what_is_worse_one_way_is_better_the_other_way(command: Command, furnished: Furnished, tmp_path: Path) -> None:
    def change(layout: dict[str, Any]) -> None:
        bed = layout["double_bed-0"]["position"]
        layout["wardrobe-0"]["position"][:2] = bed[:2]
        del layout["floor_lamp-0"]

    other = changed(furnished, tmp_path / "other", change)
    worse, better = (
        command("diff", furnished.folder, other, "--json"),
        command("diff", other, furnished.folder, "--json"),
    )
    assert (worse.code, better.code) == (1, 0)
    there, back = (json.loads(ran.out)["changes"] for ran in (worse, better))
    flipped = {"worse": "better", "": ""}
    assert {(row["kind"], row["name"], flipped[row["verdict"]]) for row in there} == {
        (row["kind"], row["name"], row["verdict"]) for row in back
    }
    assert {"collision free", "placed", "floor_lamp-0"} <= {row["name"] for row in there}
    assert any("wardrobe-0" in row["name"] and "overlap" in row["name"] for row in there if row["kind"] == "violation")
    assert [row["text"] for row in there if row["name"] == "floor_lamp-0"] == ["went"]
    assert [row["text"] for row in back if row["name"] == "floor_lamp-0"] == ["came"]
    printed = command("diff", furnished.folder, other).out
    assert "for the worse." in printed and "collision free" in printed


def test_layout_files_of_one_scene(command: Command, furnished: Furnished, tmp_path: Path) -> None:
    other = changed(furnished, tmp_path / "other", shifted("rug-0", x=0.1)) / "layout.json"
    ran = command("diff", furnished.folder / "layout.json", other, "--scene", SCENE, "--json")
    assert ran.code == 0, ran
    assert [row["text"] for row in json.loads(ran.out)["changes"] if row["kind"] == "thing"] == ["moved 0.10 m"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("nothing", "{folder}"), "nothing is not the folder of a run"),
        (("{folder}/layout.json", "{folder}"), "give the scene with --scene"),
        (("{folder}", "{folder}", "--out", "a.gif"), "name a file that ends in .png or .svg"),
        (("{folder}", "{folder}", "--program", "none.py"), "none.py"),
    ],
)
def test_bad_input_of_diff(command: Command, furnished: Furnished, words: tuple[str, ...], said: str) -> None:
    ran = command("diff", *(word.format(folder=furnished.folder) for word in words))
    assert ran.code == 2 and said in ran.err and len(ran.err.strip().splitlines()) == 1, ran


def test_the_picture_shows_where_things_stood(command: Command, furnished: Furnished, tmp_path: Path) -> None:
    def change(layout: dict[str, Any]) -> None:
        shifted("dresser-0", x=-0.6)(layout)
        del layout["floor_lamp-0"]

    other = changed(furnished, tmp_path / "other", change)
    for name in ("a.svg", "a.png"):
        assert command("diff", furnished.folder, other, "--out", tmp_path / name, "--quiet").code == 1
    assert Image.open(io.BytesIO((tmp_path / "a.png").read_bytes())).width == 1400
    svg = ElementTree.fromstring((tmp_path / "a.svg").read_bytes())
    texts = set(svg.itertext())
    assert {"stood before", "moved", "gone"} <= texts and "new" not in texts
    head = next(n for n in svg.iter() if n.get("fill") == "#0072b2" and n.get("d", "").endswith("Z"))
    tip = tuple(map(float, head.get("d").split("L")[0][1:].split()))
    k = 20.0  # millimetres to a metre at 1 : 50
    floor = next(n for n in svg.iter() if n.get("fill") == "#fbfaf7").get("d")
    left, bottom = map(float, floor.split("L")[0][1:].split())
    dresser = json.loads((other / "layout.json").read_text())["dresser-0"]["position"]
    assert tip == pytest.approx((left + k * dresser[0], bottom - k * dresser[1]), abs=0.01)


def test_rooms_that_differ_are_drawn_side_by_side() -> None:
    from robolayout.run.outputs import difference_picture

    scene = rl.load_scene(SCENE)
    room = replace(scene.room, vertices=((0, 0), (5, 0), (5, 5), (0, 5)))
    layout = Layout({"double_bed-0": Pose(2, 2, 0.5, 0)})
    found = rl.diff(rl.judge(scene, layout), rl.judge(replace(scene, room=room), layout))
    svg = difference_picture(found, ".svg").decode()
    assert "before" in svg and "after" in svg


def test_another_size_is_said() -> None:
    scene = rl.load_scene(SCENE)
    layout = Layout({"double_bed-0": Pose(2, 2, 0.5, math.pi)})
    assets = tuple(replace(a, size=(2.0, 1.4, 1.0)) if a.name == "double_bed-0" else a for a in scene.assets)
    found = rl.diff(rl.judge(scene, layout), rl.judge(replace(scene, assets=assets), layout))
    assert found.changes[0].text == "is 2.00 x 1.40 x 1.00 m instead of 2.05 x 1.60 x 1.00 m"
