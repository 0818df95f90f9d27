"""The output folder is one run: old or new, never a mixture, whatever stops it; nobody else's files are touched."""

from __future__ import annotations

import errno
import hashlib
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest

import robolayout as rl
from robolayout import InputError
from robolayout.many.variety import VARIETY, Plan, things
from robolayout.run.folder import open_folder
from running import ROOT, Ran, slow
from stopped import MINE, NEW, OLD, prepare, write

Command = Callable[..., Ran]

ROOM: dict[str, Any] = {
    "boundary": {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5},
    "assets": {
        "desk-0": {
            "category": "desk",
            "onFloor": True,
            "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.7}},
        }
    },
}


def files(home: Path) -> dict[str, str]:
    """Return the texts of all files below a folder but the list of a run and our hidden places, by their names."""
    found = {path.relative_to(home).as_posix(): path for path in home.rglob("*") if path.is_file()}
    return {n: p.read_text() for n, p in found.items() if n != "run.json" and ".robolayout-" not in n}


def hidden(base: Path) -> list[str]:
    return [path.name for path in base.rglob("*") if ".robolayout-" in path.name]


EXCHANGED = 48
"""The first of the steps of a run without pictures at which the new folder has the place of the old one."""

AFTER = {"layout.json": "third", "report.json": "third", "exchanges/c.json": "third"}


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system cannot fork")
@pytest.mark.parametrize("how", ["kill", "interrupt", "full"])
@pytest.mark.parametrize("way", ["whole", "twice", "inside"])
def test_a_run_that_is_stopped_anywhere_leaves_the_old_set_or_the_new_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str, how: str
) -> None:
    monkeypatch.setattr(os, "fsync", lambda descriptor: None)
    script = [sys.executable, str(ROOT / "tests" / "stopped.py"), str(tmp_path), way, how]
    done = subprocess.run(script, capture_output=True, text=True)
    assert done.stderr == ""
    steps = int(done.stdout)
    assert steps > 25
    seen: set[str] = set()
    for step in range(1, steps):
        home = tmp_path / str(step) / "room"
        left = files(home) if home.exists() else {}
        ours = {name: text for name, text in left.items() if text != "mine"}
        versions = {text for name, text in ours.items()}
        assert len(versions) <= 1, f"a mixture after step {step}: {ours}"
        complete = ours in (OLD, NEW)
        if way == "whole" or (way == "twice" and how != "kill"):
            assert complete, (step, ours)
        if not complete:  # moved file by file: a claim is there with all that it is about, or not at all
            assert "report.json" not in ours, (step, ours)
        seen |= versions
        write(home, AFTER)
        kept = files(home)
        assert {name: text for name, text in kept.items() if text == "third"} == AFTER
        assert sorted(text for text in kept.values() if text != "third") == ["mine"] * len(MINE), (step, kept)
        assert hidden(tmp_path / str(step)) == []
    assert seen == {"old", "new"}


def test_somebody_elses_files_stay_and_are_named(tmp_path: Path) -> None:
    home = tmp_path / "room"
    prepare(home)
    assert write(home, NEW) == ["exchanges/mine.txt", "mine.txt.kept", "notes"]
    assert files(home) == {**NEW, "mine.txt.kept": "mine", "exchanges/mine.txt": "mine", "notes/x/y.txt": "mine"}
    assert write(home, OLD) == ["exchanges/mine.txt", "mine.txt.kept", "notes"]
    assert write(home, {"notes": "a file now"}) == ["exchanges/mine.txt", "mine.txt.kept", "notes.kept"]
    listed = json.loads((home / "run.json").read_text())["files"]
    assert listed == ["notes"]
    assert sorted(os.listdir(tmp_path)) == ["room"]


@pytest.mark.parametrize("way", ["current", "read-only", "linked", "mounted"])
def test_folders_that_must_stay_the_ones_they_are(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str) -> None:
    home = tmp_path / "room"
    prepare(home)
    number, target = home.stat().st_ino, home
    access = os.access
    if way == "current":
        monkeypatch.chdir(home)
        target = Path()
    elif way == "read-only":
        monkeypatch.setattr(os, "access", lambda path, mode: Path(path) != tmp_path and access(path, mode))
    elif way == "mounted":
        monkeypatch.setattr(os.path, "ismount", lambda path: True)
    else:
        target = tmp_path / "link"
        target.symlink_to(home)
    assert write(target, NEW) == ["exchanges/mine.txt", "mine.txt.kept", "notes"]
    assert files(home) == {**NEW, "mine.txt.kept": "mine", "exchanges/mine.txt": "mine", "notes/x/y.txt": "mine"}
    assert hidden(tmp_path) == []
    assert (home.stat().st_ino == number) == (way != "linked")
    assert way != "linked" or target.is_symlink()


def test_a_folder_that_cannot_be_renamed_is_filled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home, rename = tmp_path / "room", os.rename
    prepare(home)

    def busy(source: Path, target: Path) -> None:
        if Path(source) == home:
            raise OSError(errno.EBUSY, os.strerror(errno.EBUSY))
        rename(source, target)

    monkeypatch.setattr(os, "rename", busy)
    monkeypatch.setattr("robolayout.run.folder.exchange", lambda one, other: False)
    assert write(home, NEW) == ["exchanges/mine.txt", "mine.txt.kept", "notes"]
    assert {name: text for name, text in files(home).items() if text == "new"} == NEW and hidden(tmp_path) == []


def test_a_run_that_fails_changes_nothing_but_keeps_what_was_paid_for(tmp_path: Path) -> None:
    home = tmp_path / "a" / "room"
    for answers in ({}, {"exchanges/b.json": '{"answer": null}'}, {"exchanges/b.json": '{"answer": 1}'}):
        with pytest.raises(ZeroDivisionError), open_folder(home) as run:
            for name, text in {"layout.json": "new", **answers}.items():
                (run.path / name).parent.mkdir(exist_ok=True)
                (run.path / name).write_text(text)
            raise ZeroDivisionError
        paid = "1" in "".join(answers.values())
        assert not home.exists() and (run.answers is not None) == paid
        assert (tmp_path / "a").exists() == paid
    assert files(tmp_path) == {"a/room-exchanges/b.json": '{"answer": 1}'}


def test_the_modes_of_a_folder_stay(tmp_path: Path) -> None:
    home = tmp_path / "room"
    home.mkdir(mode=0o750)
    write(home, NEW)
    assert home.stat().st_mode & 0o777 == 0o750


@pytest.mark.parametrize(
    "listed",
    ['{"files": ["../victim"]}', '{"files": ["/victim"]}', "[1]", '{"files": {"link/victim": ""}}', "{", "null"],
)
def test_a_list_that_somebody_wrote_takes_nothing_elsewhere(tmp_path: Path, listed: str) -> None:
    home, victim = tmp_path / "room", tmp_path / "victim"
    home.mkdir()
    victim.write_text("mine")
    (home / "link").symlink_to(tmp_path)
    (home / "run.json").write_text(listed.replace("/victim", str(victim)) if '"/v' in listed else listed)
    write(home, NEW)
    assert victim.read_text() == "mine" and (home / "link").is_symlink()


def test_two_runs_never_write_to_one_folder(command: Command, tmp_path: Path) -> None:
    home, scene = tmp_path / "room", tmp_path / "scene.json"
    scene.write_text(json.dumps(ROOM))
    said = f"robolayout: another run (process {os.getpid()}) is writing to {home}; wait until it has ended, or choose another folder.\n"
    with open_folder(home):
        assert command("generate", scene, "--out", home) == Ran(2, "", said)
        with open_folder(tmp_path / "other"):
            pass
    assert sorted(os.listdir(tmp_path)) == ["other", "room", "scene.json"]


def test_a_killed_run_holds_no_lock(tmp_path: Path) -> None:
    code = (
        "import sys\nfrom pathlib import Path\nfrom robolayout.run.folder import open_folder\n"
        "with open_folder(Path(sys.argv[1])) as run:\n    (run.path / 'x').touch()\n    print('ready', flush=True)\n    sys.stdin.read()"
    )
    home = tmp_path / "room"
    with subprocess.Popen(
        [sys.executable, "-c", code, str(home)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None and process.stdout.readline() == "ready\n"
        with pytest.raises(InputError, match=rf"another run \(process {process.pid}\)"), open_folder(home):
            pass
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert len(hidden(tmp_path)) == 2
    write(home, NEW)
    assert files(home) == NEW and hidden(tmp_path) == []


@pytest.fixture(scope="module")
def result() -> rl.Result:
    return rl.generate(ROOM)  # type: ignore[return-value]


def test_a_disk_that_is_full_at_any_file_leaves_the_old_set(
    result: rl.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    home = tmp_path / "room"
    written = [path.name for path in rl.write_result(result, home, pictures=False, formats=["dxf"])]
    before = {path.name: path.read_bytes() for path in home.iterdir()}
    assert set(before) == {*written, "run.json"} and "scene.dxf" in before
    sync = os.fsync
    for last in range(len(before)):
        done: list[int] = []

        def fills(descriptor: int, done: list[int] = done, last: int = last) -> None:
            done.append(descriptor)
            if len(done) > last:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            sync(descriptor)

        monkeypatch.setattr(os, "fsync", fills)
        with pytest.raises(InputError, match="No space left on device"):
            rl.write_result(result, home, pictures=False, formats=["dxf"])
        assert {path.name: path.read_bytes() for path in home.iterdir()} == before
        assert os.listdir(tmp_path) == ["room"]


def canonical_hash(file: Path) -> str:
    """Return the SHA-256 of a JSON file's content: sorted keys, no blanks, ASCII."""
    content = json.dumps(json.loads(file.read_text(encoding="utf-8")), sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(content.encode()).hexdigest()


def test_reports_carry_the_hashes_of_what_they_are_about(result: rl.Result, tmp_path: Path, command: Command) -> None:
    home = tmp_path / "room"
    rl.write_result(result, home, pictures=False)
    hashes = json.loads((home / "report.json").read_text())["hashes"]
    assert hashes == {name: canonical_hash(home / f"{name}.json") for name in ("scene", "layout")}
    listed = json.loads((home / "run.json").read_text())["files"]
    assert listed == sorted(path.name for path in home.iterdir() if path.name != "run.json")
    assert command("check", home / "scene.json", home / "layout.json", "--quiet").code in (0, 1)


def test_scene_files_have_variants_by_seed(command: Command, tmp_path: Path) -> None:
    scene, out = tmp_path / "room.json", tmp_path / "out"
    scene.write_text(json.dumps(ROOM))
    command("generate", scene, "--out", out, "--variants", 2, "--seed", 3, "--no-pictures", "--quiet")
    command("generate", scene, "--out", tmp_path / "alone", "--seed", 4, "--no-pictures", "--quiet")
    assert sorted(os.listdir(out)) == ["variant-0", "variant-1"]
    assert (out / "variant-1" / "layout.json").read_bytes() == (tmp_path / "alone" / "layout.json").read_bytes()


@pytest.mark.parametrize(
    ("text", "alike"), [slow("a bedroom for two", False), ("a 3 x 3 m room with only a ceiling lamp", True)]
)
def test_variants_of_a_sentence_are_other_plans_or_are_said_to_be_alike(
    command: Command, tmp_path: Path, text: str, alike: bool
) -> None:
    ran = command("generate", text, "--out", tmp_path, "--variants", 3, "--no-pictures", "--quiet")
    plans: list[Plan] = []
    for home in sorted(tmp_path.iterdir()):
        scene = rl.load_scene(home / "scene.json")
        plans.append(Plan(things(scene, rl.load_layout(home / "layout.json", scene))))
    assert (min(a.difference(b) for a, b in combinations(plans, 2)) < VARIETY.least) == alike
    assert ("variant-1 is much like another variant (difference 0.00)" in ran.err) == alike


@pytest.mark.parametrize("step", [2, 25, slow(47), 50])
def test_the_command_killed_while_it_writes(command: Command, tmp_path: Path, step: int) -> None:
    scene, home = tmp_path / "room.json", tmp_path / "out"
    scene.write_text(json.dumps(ROOM))
    words = ["generate", str(scene), "--out", str(home), "--no-pictures", "--quiet"]
    assert command(*words).code == 0
    before = (home / "layout.json").read_bytes()
    changed = json.loads(json.dumps(ROOM))
    changed["assets"]["desk-0"]["assetMetadata"]["boundingBox"]["y"] = 1.0
    scene.write_text(json.dumps(changed))
    code = (
        "import sys\nsys.path.insert(0, sys.argv.pop())\nfrom stopped import Step\n"
        "import robolayout.run.outputs as outputs\nwrite = outputs.write_files\n"
        f"def hooked(*args, **how):\n    sys.addaudithook(Step({step}, 'kill'))\n    return write(*args, **how)\n"
        "outputs.write_files = hooked\nfrom robolayout.cli import main\nmain()"
    )
    done = subprocess.run([sys.executable, "-c", code, *words, str(ROOT / "tests")], capture_output=True, text=True)
    assert done.returncode == -signal.SIGKILL, done.stderr
    report = json.loads((home / "report.json").read_text())
    layout = (home / "layout.json").read_bytes()
    assert report["hashes"]["layout"] == canonical_hash(home / "layout.json")
    assert (layout == before) == (step < EXCHANGED)
    assert command("check", home / "scene.json", home / "layout.json", "--quiet").code == 0
