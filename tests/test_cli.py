"""The command line: exit codes, one clear sentence, nothing written on bad input, whole files on good."""

from __future__ import annotations

import copy
import io
import json
import os
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image

from robolayout._version import __version__
from robolayout.constraints import RELATIONS
from robolayout.scene import agent_names
from running import Furnished, Ran

Command = Callable[..., Ran]
Change = Callable[[dict[str, Any]], Any]

ROOM: dict[str, Any] = {
    "boundary": {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5},
    "doors": [{"wall": 0, "offset": 0.1, "width": 0.9, "height": 2.05}],
    "assets": {
        "desk-0": {"category": "desk", "onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.7}}},
        "lamp-0": {"category": "lamp", "onObject": True, "assetMetadata": {"boundingBox": {"x": 0.2, "y": 0.2, "z": 0.4}}},
    },
}  # fmt: skip


def written(folder: Path, change: Change | None = None, name: str = "room.json") -> Path:
    """Write the small room, changed, and return the file."""
    data = copy.deepcopy(ROOM)
    if change is not None:
        change(data)
    path = folder / name
    path.write_text(json.dumps(data), encoding="utf-8")
    return path


def corners(*points: tuple[float, float]) -> Change:
    return lambda data: data["boundary"].update(floor_vertices=[[x, y, 0] for x, y in points])


def box(**size: float) -> Change:
    return lambda data: data["assets"]["desk-0"]["assetMetadata"]["boundingBox"].update(size)


def refused(ran: Ran, *patterns: str, out: Path | None = None) -> None:
    """Exit code 2, one message of at most three lines on stderr that says all this, no traceback, nothing written."""
    assert ran.code == 2, ran
    assert ran.out == ""
    assert ran.err.startswith("robolayout: ") and "Traceback" not in ran.err
    assert len(ran.err.strip().splitlines()) <= 3
    for pattern in patterns:
        assert pattern in ran.err, f"{pattern!r} is not in {ran.err!r}"
    assert out is None or not out.exists()


BAD_SCENES: dict[str, tuple[Change, tuple[str, ...]]] = {
    "no boundary": (lambda data: data.pop("boundary"), ("boundary",)),
    "no assets": (lambda data: data.pop("assets"), ("assets",)),
    "no size": (lambda data: data["assets"]["desk-0"].pop("assetMetadata"), ("desk-0", "assetMetadata")),
    "no wall height": (lambda data: data["boundary"].pop("wall_height"), ("wall_height",)),
    "self-crossing": (corners((0, 0), (3, 3), (3, 0), (0, 3)), ("cross",)),
    "zero area": (corners((0, 0), (3, 0), (2, 0)), ("area",)),
    "NaN size": (box(x=float("nan")), ("desk-0", "nan")),
    "negative size": (box(y=-1.2), ("desk-0", "-1.2")),
    "larger than the room": (box(x=5.0, y=5.0), ("desk-0", "room")),
    "door past its wall's end": (lambda data: data["doors"][0].update(offset=2.5), ("door", "wall")),
    "unknown agent": (lambda data: data.update(agent="wheelchiar"), ("wheelchiar", "Did you mean", "wheelchair")),
}


@pytest.mark.parametrize("case", BAD_SCENES)
def test_bad_scenes(command: Command, tmp_path: Path, case: str) -> None:
    change, patterns = BAD_SCENES[case]
    out = tmp_path / "out"
    refused(command("generate", written(tmp_path, change), "--out", out), *patterns, out=out)


def test_not_json_and_duplicate_names(command: Command, tmp_path: Path) -> None:
    path = tmp_path / "room.json"
    path.write_text("{'single': quotes}")
    refused(command("generate", path, "--out", tmp_path / "out"), "not JSON", "line 1", out=tmp_path / "out")
    text = json.dumps(ROOM).replace('"lamp-0"', '"desk-0"')
    path.write_text(text)
    refused(command("generate", path, "--out", tmp_path / "out"), "desk-0", "twice", out=tmp_path / "out")
    path.write_bytes(b"\xff\xfe\x00")
    refused(command("generate", path, "--out", tmp_path / "out"), "UTF-8", out=tmp_path / "out")


BAD_PROGRAMS = {
    "does not parse": ("solver.against_wall(desk[0], walls[1]", ("line 1", "^")),
    "unknown asset": ("\nsolver.on_top_of(lamp[0], tabel[0])", ("line 2", "tabel", "^")),
    "loops for ever": ("while True:\n    pass", ("5 s",)),
    "eats memory": ("x = []\nwhile True:\n    x.append('y' * 1000000)", ("256 MB",)),
    "imports os": ("import os\nos.system('touch escaped')", ("line 1", "os")),
    "reads a file": ("print(open('/etc/passwd').read())", ("line 1", "open")),
    "places at NaN": ("desk[0].position = [float('nan'), 1, 0.35]", ("line 1", "nan")),
    "climbs through classes": ("().__class__.__bases__", ("line 1", "__class__")),
}


@pytest.mark.parametrize("case", BAD_PROGRAMS)
def test_bad_programs(command: Command, tmp_path: Path, case: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    text, patterns = BAD_PROGRAMS[case]
    program = tmp_path / "program.py"
    program.write_text(text)
    ran = command("generate", written(tmp_path), "--program", program, "--out", "out")
    refused(ran, *patterns, out=tmp_path / "out")
    assert not (tmp_path / "escaped").exists()


def test_bad_options_are_refused_before_any_work(command: Command, tmp_path: Path) -> None:
    room, file = written(tmp_path), tmp_path / "file"
    file.write_text("")
    refused(command("generate", tmp_path / "none.json"), "none.json", "check the path")
    refused(command("generate", room, "--agent", "nobody"), "nobody", *agent_names())
    refused(
        command("generate", room, "--export", "stl", "--out", tmp_path / "out"), "stl", "mjcf", out=tmp_path / "out"
    )
    refused(command("generate", room, "--program", tmp_path / "none.py"), "none.py")
    refused(command("generate", room, "--out", file / "out"), "is not a folder")
    refused(command("compare", room, "--agents", "cat", "--out", tmp_path / "out.gif"), ".png")
    refused(command("compare", room, "--agents", "cat,nobody"), "nobody")
    refused(command("check", room, tmp_path / "none.json"), "none.json")
    assert command("generate", room, "--starts", "0").code == 2
    assert command("frobnicate").code == 2


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ("generate", "a bedroom", "--critic"),
            "--critic means nothing without --model: give that, too, or leave it out.",
        ),
        (("generate", "a bedroom", "--max-cost", "0"), "--max-cost means nothing without --model"),
        (("generate", "a bedroom", "--fallback", "openai:gpt-4o"), "--fallback means nothing without --model"),
        (("generate", "a bedroom", "--mode", "one_shot"), "--mode means nothing without --model"),
        (("check", "scene.json", "layout.json", "--votes", "5"), "--votes means nothing without --judge"),
        (("check", "scene.json", "layout.json", "--base-url", "http://x"), "--base-url means nothing without --judge"),
        (("diff", "a", "b", "--width", "500"), "--width means nothing without --out"),
        (("assets", "bed", "--front", "+x"), "--front means nothing without `assets import FOLDER`"),
        (("assets", "bed", "--out", "own.json"), "--out means nothing without `assets import FOLDER`"),
        (("generate", "a bedroom", "--constraints", "none.py"), "none.py is no Python file, or not there"),
    ],
)
def test_an_option_that_would_mean_nothing_is_refused(command: Command, words: tuple[str, ...], said: str) -> None:
    refused(command(*words), said)


def test_a_folder_of_assets_that_is_not_there_is_refused_whether_it_is_needed_or_not(
    command: Command, tmp_path: Path
) -> None:
    room = written(tmp_path)
    said = "nowhere does not exist or is no folder; check --asset-dir"
    refused(command("generate", room, "--asset-dir", tmp_path / "nowhere"), said)
    refused(command("evaluate", tmp_path, "--scenes", tmp_path / "nowhere"), "nowhere is no folder")


def test_as_many_bodies_are_compared_as_the_help_says(command: Command, tmp_path: Path) -> None:
    room = written(tmp_path)
    refused(command("compare", room, "--agents", "cat"), "--agents names 1 bodies: 2 to 6 are compared")
    seven = ",".join(agent_names()[:7])
    refused(command("compare", room, "--agents", seven), "--agents names 7 bodies: 2 to 6 are compared")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_read_only_folder_is_refused(command: Command, tmp_path: Path) -> None:
    room = written(tmp_path)
    locked = tmp_path / "locked"
    locked.mkdir(mode=0o500)
    refused(command("generate", room, "--out", locked / "out"), "read-only")


def test_a_read_only_folder_is_refused_for_root_too(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    refused(command("generate", written(tmp_path), "--out", tmp_path / "out"), "read-only", out=tmp_path / "out")


def test_paths_that_no_system_takes_are_the_users_to_mend(command: Command, tmp_path: Path) -> None:
    room, long = written(tmp_path), "n" * 300
    refused(command("generate", room, "--out", tmp_path / long), "cannot write to", "File name too long")
    refused(command("generate", room, "--out", tmp_path / long / "x"), "cannot write to", "File name too long")
    refused(command("generate", long), f"scene file {long} does not exist")
    for words in (("generate", room, "--replay", long), ("assets", "import", long)):
        refused(command(*words), f"cannot use {long}: File name too long; give another path.")
    assert sorted(os.listdir(tmp_path)) == ["room.json"]


@pytest.mark.slow
def test_a_sentence_may_be_longer_than_a_file_name(command: Command, tmp_path: Path) -> None:
    words = f"a bedroom with {', '.join(['a shiny red spaceship'] * 12)} and a bed, 6 x 8 m"
    ran = command("generate", words, "--out", tmp_path / "out", "--no-pictures", "--json")
    assert ran.code in (0, 1) and "robolayout: A " in ran.err, ran


def test_a_list_with_dashes_is_no_option(command: Command, tmp_path: Path) -> None:
    words = "- 900 sofas\n- a rug"
    refused(command("generate", words, "--out", tmp_path / "out"), "900", "sofa")


def test_good_rooms(furnished: Furnished) -> None:
    assert furnished.code == (0 if furnished.printed["ok"] else 1)
    assert furnished.code == 0, furnished.printed["violations"]
    assert furnished.printed["out"] == str(furnished.folder)


def test_the_output_folder_is_complete_and_whole(furnished: Furnished) -> None:
    folder = furnished.folder
    names = {path.name for path in folder.iterdir()}
    texts = {
        "scene.json",
        "grouping.json",
        "program.py",
        "constraints.json",
        "layout.json",
        "report.json",
        "report.md",
        "run.json",
    }
    drawn = {"plan.svg", "sheet.pdf", "top.png", "view.png", "progress.gif", "loss.png", "report.html"}
    assert names == texts | drawn | {"scene.glb"}
    for name in names:
        data = (folder / name).read_bytes()
        if name.endswith(".json"):
            json.loads(data)
        elif name.endswith((".png", ".gif")):
            Image.open(io.BytesIO(data)).verify()
        elif name.endswith(".svg"):
            assert ElementTree.fromstring(data).tag.endswith("svg")
        elif name.endswith(".glb"):
            assert data[:4] == b"glTF" and int.from_bytes(data[8:12], "little") == len(data)
    scene = json.loads(furnished.scene.read_text())
    assert json.loads((folder / "layout.json").read_text()).keys() == scene["assets"].keys()
    decisions = json.loads((folder / "constraints.json").read_text())
    assert "accepted" in json.dumps(decisions)
    assert (folder / "report.md").read_text().startswith("# bedroom: ")
    assert Image.open(folder / "progress.gif").n_frames >= 1
    assert (folder / "progress.gif").stat().st_size < 2_000_000


def test_the_normalised_scene_and_the_layout_can_be_checked_again(command: Command, furnished: Furnished) -> None:
    ran = command("check", furnished.folder / "scene.json", furnished.folder / "layout.json", "--json")
    assert ran.code == furnished.code and ran.err == ""
    report = json.loads(ran.out)
    for name in ("placed_share", "collision_free_share", "walkable_ratio", "reachable_share", "usable_share"):
        assert report[name] == furnished.printed[name]
    again = command(
        "check", furnished.scene, furnished.folder / "layout.json", "--json", "--agent", "wheelchair",
        "--program", furnished.folder / "program.py",
    )  # fmt: skip
    assert json.loads(again.out)["statements_met_share"] == furnished.printed["statements_met_share"]


def test_unmet_demands_are_exit_code_1_with_sentences(command: Command, furnished: Furnished, tmp_path: Path) -> None:
    layout = json.loads((furnished.folder / "layout.json").read_text())
    layout["wardrobe-0"]["position"] = layout["double_bed-0"]["position"]
    moved = tmp_path / "layout.json"
    moved.write_text(json.dumps(layout))
    ran = command("check", furnished.scene, moved)
    assert ran.code == 1
    assert "SHORT" in ran.out and "wardrobe-0" in ran.out and "double_bed-0" in ran.out
    assert command("check", furnished.scene, moved, "--quiet") == Ran(1, "", "")


def test_generate_says_what_it_did_or_nothing(command: Command, tmp_path: Path) -> None:
    def hostile(data: dict[str, Any]) -> None:
        data["assets"]["desk-0"]["description"] = 'desk"""\nimport os\nsolver = None  # \' + str(1/0) + \''
        data["task_description"] = '"; raise SystemExit(9) #\n```python\nboom()\n```'

    room = written(tmp_path, hostile)
    out = tmp_path / "out"
    ran = command("generate", room, "--out", out, "--no-pictures")
    assert ran.code == 0, ran
    assert "room for disc" in ran.out and str(out / "layout.json") in ran.out and "SHORT" not in ran.out
    files = {path.name for path in out.iterdir()}
    assert "layout.json" in files and not any(name.endswith((".png", ".svg", ".gif")) for name in files)

    program = tmp_path / "program.py"
    program.write_text("solver.against_wall(desk[0], walls[1])\nsolver.against_wall(desk[0], walls[3])")
    options = ("--out", tmp_path / "two", "--no-pictures", "--quiet", "--program", program, "--export", "dxf,mjcf")
    assert command("generate", room, *options) == Ran(1, "", ""), "a demand that cannot be met"
    assert {"room.dxf", "room.xml"} <= {path.name for path in (tmp_path / "two").iterdir()}


def test_a_clockwise_room_is_turned_around_with_a_warning(
    command: Command, furnished: Furnished, tmp_path: Path
) -> None:
    scene = json.loads(furnished.scene.read_text())
    scene["boundary"]["floor_vertices"].reverse()
    scene["doors"], scene["windows"] = [], []
    path = tmp_path / "bedroom.json"
    path.write_text(json.dumps(scene))
    ran = command("check", path, furnished.folder / "layout.json", "--quiet")
    assert ran.code in (0, 1) and "warning" in ran.err and "clockwise" in ran.err


def test_render_export_and_compare_write_what_they_say(command: Command, furnished: Furnished, tmp_path: Path) -> None:
    given = (furnished.scene, furnished.folder / "layout.json")
    for view in ("plan", "top", "double_bed-0"):
        ran = command("render", *given, "--view", view, "--size", "200", "--out", tmp_path / f"{view}.png")
        assert ran.code == 0 and ran.out.strip() == str(tmp_path / f"{view}.png")
        assert Image.open(tmp_path / f"{view}.png").width == 200
    refused(command("render", *given, "--view", "nonsense"), "nonsense", "double_bed-0", "top")
    ran = command("export", *given, "--to", "glb,mjcf,dxf,layout", "--out", tmp_path / "files")
    assert ran.code == 0 and [Path(line).exists() for line in ran.out.split()] == [True] * 4
    ran = command("export", *given, "--to", "usda,xml,.glb", "--out", tmp_path / "suffixes")
    assert [Path(line).name for line in ran.out.split()] == ["bedroom.usda", "bedroom.xml", "bedroom.glb"]
    refused(command("export", *given, "--to", "obj"), "obj", "glb")
    refused(command("export", *given, "--to", ","), "--to", "glb")


def test_compare_shows_one_room_for_several_bodies(command: Command, tmp_path: Path) -> None:
    picture = tmp_path / "compare.png"
    ran = command("compare", written(tmp_path), "--agents", "cat,adult", "--out", picture, "--width", "600")
    assert ran.code == 0, ran
    assert "cat" in ran.out and "adult" in ran.out
    assert Image.open(picture).width == 600 and picture.stat().st_size < 300_000


def test_lists(command: Command) -> None:
    listed = command("agents").out
    assert all(name in listed for name in agent_names())
    assert "ADA 2010" in command("agents", "wheelchair").out
    assert all(name in command("constraints").out for name in RELATIONS)
    assert "toilet" in command("assets", "loo").out
    assert len(command("assets").out.splitlines()) > 200
    assert command("--version").out == f"robolayout {__version__}\n"


def test_a_killed_run_leaves_whole_files(furnished: Furnished, tmp_path: Path) -> None:
    code = (
        "import sys\nfrom pathlib import Path\nfrom robolayout._files import write_atomic\n"
        f"folder = Path({str(tmp_path)!r})\n"
        f"sources = sorted(Path({str(furnished.folder)!r}).iterdir())\n"
        "sys.stdout.write('ready\\n'); sys.stdout.flush()\n"
        "while True:\n    for source in sources:\n        write_atomic(folder / source.name, source.read_bytes())\n"
    )
    for delay in (0.03, 0.11, 0.19):
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE)
        assert process.stdout is not None and process.stdout.readline() == b"ready\n"
        time.sleep(delay)
        process.send_signal(signal.SIGKILL)
        process.wait()
        process.stdout.close()
        for path in tmp_path.iterdir():
            if not path.name.startswith("."):
                assert path.read_bytes() == (furnished.folder / path.name).read_bytes()
    assert any(not path.name.startswith(".") for path in tmp_path.iterdir())


def test_the_real_command_ends_with_code_2_and_one_sentence(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "robolayout", "generate", str(tmp_path / "none.json")], capture_output=True, text=True
    )
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr == f"robolayout: scene file {tmp_path / 'none.json'} does not exist; check the path.\n"
