"""A data set: the same bytes however it is made, whole rooms only, nothing of others touched."""

from __future__ import annotations

import csv
import errno
import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest
import trimesh
from PIL import Image

import robolayout as rl
from robolayout import InputError
from robolayout._files import locked
from robolayout.assets import import_folder
from robolayout.many import read_spec
from robolayout.many.dataset import LOCK, room_path
from robolayout.many.room import Made, make
from robolayout.many.workers import Task, WorkerConfig
from running import Ran
from tiny_sets import tiny_spec, tree

Command = Callable[..., Ran]


class Here:
    """Makes rooms in this process, and remembers which."""

    slots = 3

    def __init__(self, ready: Any, meshes: Path, *_: Any) -> None:
        self.ready, self.meshes, self.tasks, self.made = ready, meshes, list[Task](), list[Task]()

    def send(self, task: Task) -> None:
        self.tasks.append(task)

    def done(self) -> Any:
        task = self.tasks.pop()  # the last one first: rooms come in another order than they are sent in
        self.made.append(task)
        yield task, self.one(task)

    def one(self, task: Task) -> Made | None:
        return make(self.ready, task.index, task.attempt, self.meshes)

    def close(self) -> None: ...


@pytest.fixture
def here(monkeypatch: pytest.MonkeyPatch) -> list[Here]:
    """Rooms are made in this process; what did it is listed."""
    used: list[Here] = []

    def start(*given: Any) -> Here:
        used.append(Here(*given))
        return used[-1]

    monkeypatch.setattr("robolayout.many.dataset.Local", start)
    return used


def rows(folder: Path) -> list[dict[str, str]]:
    return list(csv.DictReader((folder / "index.csv").open(encoding="utf-8")))


@pytest.mark.slow
def test_two_processes_make_the_set_that_one_makes(tmp_path: Path, here: list[Here]) -> None:
    table = tiny_spec(tmp_path, 3, formats=["mjcf"])
    rl.batch(table, tmp_path / "one")
    assert len(here) == 1
    from robolayout.many.workers import Local

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("robolayout.many.dataset.Local", Local)
        patch.setattr("robolayout.many.workers.WORKERS", WorkerConfig(renewed=2))  # one of them makes way for a new one
        told: list[str] = []
        found = rl.batch(table, tmp_path / "two", workers=2, progress=lambda now: told.append(str(now)))
    assert found.ok and found.met == 3 and len(told) == 3 and told[-1].startswith("3 of 3 rooms, 3 met")
    assert tree(tmp_path / "one") == tree(tmp_path / "two")


def test_what_a_set_holds(tmp_path: Path, here: list[Here]) -> None:
    table = {"rooms": ["bathroom"], "count": 4, "formats": ["mjcf"], "bodies": ["adult", "cat"], "test": 0.25}
    found = rl.batch(table, tmp_path / "set")
    folder = tmp_path / "set"
    listed = rows(folder)
    assert found.ok and [row["status"] for row in listed] == ["met"] * 4
    assert pyarrow.parquet.read_table(folder / "index.parquet").column_names == list(listed[0])
    for row in listed:
        room = folder / row["path"]
        report = json.loads((room / "report.json").read_text())
        assert {"scene.glb", "report.md", "program.py", "scene.xml", "thumb.png", "room.json"} <= set(os.listdir(room))
        assert float(row["walkable_ratio"]) == report["walkable_ratio"] and report["timing"].keys() == set()
        assert row["layout_hash"] == report["hashes"]["layout"]
        assert float(row["SceneEval_COL"]) == report["metrics"]["SceneEval"]["COL"]
    splits = [(folder / f"{name}.txt").read_text().split() for name in ("train", "test")]
    assert [len(split) for split in splits] == [3, 1] and sorted([*splits[0], *splits[1]]) == [
        row["path"] for row in listed
    ]
    assert Image.open(folder / "contact.png").size[0] >= 160
    card = (folder / "README.md").read_text()
    assert "- 4 rooms meet all their demands" in card and "- 0 near-duplicates" in card
    page = (folder / "index.html").read_text()
    assert '"thumbs":true' in page and "rooms/00000/00000003" in page


@pytest.mark.slow
def test_own_meshes_are_shared_and_named_from_the_set(tmp_path: Path, here: list[Here], command: Command) -> None:
    meshes, out = tmp_path / "own", tmp_path / "set"
    meshes.mkdir()
    trimesh.creation.box((1.6, 0.5, 2.1)).export(meshes / "bed.glb")
    (meshes / "own.json").write_text(json.dumps(import_folder(meshes)))
    found = rl.batch({"rooms": ["bedroom"], "count": 2, "catalogues": [str(meshes / "own.json")]}, out)
    assert found.ok and os.listdir(out / "meshes" / "0") == ["bed.glb"]
    assert "| 0/bed.glb | none stated |" in (out / "README.md").read_text()
    room = out / room_path(1)
    assert '"path": "0/bed.glb"' in (room / "scene.json").read_text()
    words = ["check", room / "scene.json", room / "layout.json", "--asset-dir", out / "meshes", "--quiet"]
    assert command(*words).code == 0
    (meshes / "bed.glb").unlink()
    assert all(row["ok"] for row in rl.evaluate(out).rows)


def test_a_finished_set_is_not_made_again_and_a_hole_is_filled(tmp_path: Path, here: list[Here]) -> None:
    table, out = tiny_spec(tmp_path, 4), tmp_path / "set"
    rl.batch(table, out)
    whole = tree(out)
    rl.batch(table, out)
    assert len(here) == 1, "nothing was left to do"
    for path in sorted((out / room_path(2)).iterdir()):
        path.unlink()
    (out / room_path(2)).rmdir()
    rl.batch(table, out)
    assert here[1].made == [Task(2, 0)] and tree(out) == whole


def test_near_duplicates_are_replaced_or_given_up_and_named(
    tmp_path: Path, here: list[Here], monkeypatch: pytest.MonkeyPatch
) -> None:
    def alike(self: Here, task: Task) -> Made:
        found = make(self.ready, task.index, task.attempt)
        stands = {(0, 0): 0.0, (1, 0): 0.0, (1, 1): 0.1, (1, 2): 1.0}.get((task.index, task.attempt), 0.0)
        return Made("", found.row, (("desk", stands, stands / 3, 0.0), ("shelf", -1.0, 1.0, 0.0)), found.files)

    monkeypatch.setattr(Here, "one", alike)
    found = rl.batch(tiny_spec(tmp_path, count=3, tries=3), tmp_path / "set")
    first, second, third = rows(tmp_path / "set")
    assert (first["replaced"], second["replaced"], second["attempt"]) == ("0", "2", "2")
    assert (third["status"], third["why"]) == ("missing", "near-duplicate of room 0")
    assert found.missing == {2: "near-duplicate of room 0"} and found.replaced == {"near-duplicate of room #": 5}
    assert sorted(os.listdir(tmp_path / "set" / room_path(2))) == ["room.json", "run.json"]
    assert not found.ok


def test_rooms_that_are_not_met_are_named_or_kept(tmp_path: Path, here: list[Here]) -> None:
    table = tiny_spec(tmp_path, 2, bodies=["forklift"], tries=2)
    found = rl.batch(table, tmp_path / "set")
    assert (found.met, found.unmet, len(found.missing)) == (0, 0, 2)
    assert all("impossible for the body" in why for why in found.missing.values())
    kept = rl.batch(tiny_spec(tmp_path, 2, bodies=["forklift"], keep_unmet=True), tmp_path / "kept")
    assert (kept.met, kept.unmet, kept.missing) == (0, 2, {})
    assert [row["status"] for row in rows(tmp_path / "kept")] == ["unmet", "unmet"]


def test_a_worker_that_ends_costs_its_room_at_most(
    tmp_path: Path, here: list[Here], monkeypatch: pytest.MonkeyPatch
) -> None:
    ends = {Task(1, 0): 4, Task(2, 0): 99, Task(2, 1): 99}

    def dies(self: Here, task: Task) -> Made | None:
        ends[task] = ends.get(task, 0) - 1
        return make(self.ready, task.index, task.attempt) if ends[task] < 0 else None

    monkeypatch.setattr(Here, "one", dies)
    found = rl.batch(tiny_spec(tmp_path, 4, tries=2), tmp_path / "set")
    assert found.met == 3 and found.missing == {2: "its worker ended 5 times; bounds are 300 s and 8 GB"}
    assert rows(tmp_path / "set")[1]["replaced"] == "0", "somebody else ended its workers"


@pytest.mark.slow
def test_hanging_and_greedy_workers_are_ended(tmp_path: Path) -> None:
    code = (
        "import sys, time\nfrom pathlib import Path\nimport robolayout.many.workers as workers\n"
        "from robolayout.many import read_spec\n"
        "ready = read_spec(sys.argv[2], seconds=int(sys.argv[3]), memory=1)\n"
        "def hang(*given): time.sleep(60)\n"
        "def eat(*given): return len([bytearray(10**8) for _ in range(100)])\n"
        "workers.make = hang if sys.argv[1] == 'hang' else eat\n"
        "print(workers.bounded(ready, workers.Task(0, 0), Path()).why)"
    )
    scene = tiny_spec(tmp_path)["rooms"][0]
    for how, ended, said, seconds in (("hang", 1, "", "1"), ("eat", 0, "took more than 1 GB of memory\n", "300")):
        words = [sys.executable, "-c", code, how, scene, seconds]
        done = subprocess.run(words, capture_output=True, text=True)
        assert (done.returncode, done.stdout) == (ended, said), done.stderr


@pytest.mark.slow
def test_a_full_disk_ends_in_a_sentence_and_the_same_call_goes_on(
    tmp_path: Path, here: list[Here], monkeypatch: pytest.MonkeyPatch
) -> None:
    table = tiny_spec(tmp_path, 3)
    rl.batch(table, tmp_path / "whole")
    sync = os.fsync
    for last in (4, 12, 19):
        written: list[int] = []

        def fills(descriptor: int, written: list[int] = written, last: int = last) -> None:
            written.append(descriptor)
            if len(written) > last:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            sync(descriptor)

        out = tmp_path / f"full-{last}"
        monkeypatch.setattr("robolayout._files.os.fsync", fills)
        with pytest.raises(InputError, match="No space left on device"):
            rl.batch(table, out)
        monkeypatch.setattr("robolayout._files.os.fsync", sync)
        assert all((path / "layout.json").is_file() for path in out.glob("rooms/*/*")), "whole or not at all"
        rl.batch(table, out)
        assert tree(out) == tree(tmp_path / "whole")


def test_folders_that_hold_something_else_are_refused(tmp_path: Path, here: list[Here], command: Command) -> None:
    table, out = tiny_spec(tmp_path, 2), tmp_path / "set"
    out.mkdir()
    (out / "mine.txt").write_text("mine")
    with pytest.raises(InputError, match=r"set holds something else \(mine.txt\); give --out a folder"):
        rl.batch(table, out)
    assert os.listdir(out) == ["mine.txt"]
    rl.batch(table, tmp_path / "other")
    before = tree(tmp_path / "other")
    with pytest.raises(InputError, match="holds rooms of another SPEC: its each, seed changed; choose another folder"):
        rl.batch({**table, "each": 3, "seed": 1}, tmp_path / "other")
    (tmp_path / "tiny.json").write_text((tmp_path / "tiny.json").read_text().replace("1.2", "1.1"))
    with pytest.raises(InputError, match="a file that it names changed"):
        rl.batch(table, tmp_path / "other")
    assert tree(tmp_path / "other") == before


def test_two_runs_never_write_to_one_set(tmp_path: Path, here: list[Here]) -> None:
    table, out = tiny_spec(tmp_path, 2), tmp_path / "set"
    rl.batch(table, out)
    with locked(out / LOCK, out), pytest.raises(InputError, match=rf"another run \(process {os.getpid()}\) is writing"):
        rl.batch(table, out)


def test_the_command(tmp_path: Path, here: list[Here], command: Command) -> None:
    scene, out = tiny_spec(tmp_path)["rooms"][0], tmp_path / "set"
    ran = command("batch", scene, "--out", out, "--set", "each=2", "--set", "files=formats", "--set", 'bodies=["cat"]')
    assert ran.code == 0 and ran.out.splitlines()[0] == "2 of 2 rooms meet all their demands."
    ran = command(
        "batch", scene, "--out", out, "--set", "each=2", "--set", "files=formats", "--set", 'bodies=["cat"]', "--json"
    )
    assert json.loads(ran.out)["met"] == 2 and read_spec(scene).count == 100
    ran = command(
        "batch", scene, "--out", tmp_path / "no", "--set", "each=1", "--set", 'bodies=["forklift"]', "--set", "tries=1"
    )
    assert ran.code == 1 and "- room 0 was given up: " in ran.out
