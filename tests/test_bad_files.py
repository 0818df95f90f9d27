"""Files that do not fit, break or cannot be written: one clear sentence, exit code 2, and nothing half-written."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from running import Furnished, Ran

Command = Callable[..., Ran]

ROOM: dict[str, Any] = {
    "boundary": {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5},
    "doors": [{"wall": 0, "offset": 0.1, "width": 0.9, "height": 2.05}],
    "assets": {
        "desk-0": {"onFloor": True, "path": "desk.glb", "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.7}}},
    },
}  # fmt: skip
DESK = {"desk-0": {"position": [1.5, 2.6, 0.35], "rotation": [0, 0, 270]}}

EVERYTHING = [
    ("check",),
    ("render", "--view", "plan"),
    ("render", "--view", "top", "--renderer", "ray"),
    ("export", "--to", "glb,dxf"),
    ("settle",),
    ("drive",),
]
"""Every command that reads a layout, with what it needs."""


def refused(ran: Ran, *said: str) -> None:
    assert ran.code == 2, ran
    assert ran.err.startswith("robolayout: ") and "Traceback" not in ran.err
    assert all(words in ran.err for words in said), ran.err


@pytest.fixture
def given(furnished: Furnished, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[Path, Path]:
    """The furnished bedroom, copied; commands write to the folder they are called in."""
    here = tmp_path / "here"
    here.mkdir()
    monkeypatch.chdir(here)
    layout = tmp_path / "layout.json"
    layout.write_bytes((furnished.folder / "layout.json").read_bytes())
    return (furnished.folder / "scene.json", layout)


def change(layout: Path, edit: Callable[[dict[str, Any]], Any]) -> None:
    data = json.loads(layout.read_text())
    edit(data)
    layout.write_text(json.dumps(data))


@pytest.mark.parametrize("words", EVERYTHING, ids=lambda words: "-".join(words))
def test_a_layout_with_an_unknown_asset(
    command: Command, given: tuple[Path, Path], tmp_path: Path, words: tuple[str, ...]
) -> None:
    change(given[1], lambda data: data.update({"double_bedd-0": data["double_bed-0"]}))
    ran = command(words[0], *given, *words[1:])
    refused(ran, "'double_bedd-0', which is not in the scene", "Did you mean 'double_bed-0'?", "Known: armchair-0")
    assert list((tmp_path / "here").iterdir()) == []


def test_a_layout_that_lacks_assets(command: Command, given: tuple[Path, Path], tmp_path: Path) -> None:
    change(given[1], lambda data: (data.pop("wardrobe-0"), data.pop("rug-0")))
    ran = command("check", *given)
    assert ran.code == 1 and "wardrobe-0 is not placed" in ran.out
    for view in ("plan", "top"):
        ran = command("render", *given, "--view", view, "--size", 200)
        assert ran.code == 0, ran
    refused(command("render", *given, "--view", "eye:wardrobe-0"), "unknown view 'eye:wardrobe-0'", "eye:dresser-0")
    for path in (tmp_path / "here").iterdir():
        path.unlink()
    ran = command("export", *given, "--to", "glb,dxf")
    refused(ran, "no pose for 'wardrobe-0', 'rug-0' (2 of 14 assets)", "--partial")
    assert list((tmp_path / "here").iterdir()) == []
    ran = command("export", *given, "--to", "glb,pdf", "--partial")
    assert ran.code == 0 and len(list((tmp_path / "here").iterdir())) == 2


WRITERS = [
    ("render", "--view", "plan"),
    ("render", "--view", "top", "--ids", "--renderer", "ray", "--size", "100"),
    ("export", "--to", "glb,usd"),
    ("settle", "--report", "settled.json"),
]


@pytest.mark.parametrize("words", WRITERS, ids=lambda words: "-".join(words[:3]))
def test_a_full_disk(
    command: Command, given: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]
) -> None:
    def full(descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    ran = command(words[0], *given, *words[1:])
    refused(ran, "cannot write", "No space left on device. Nothing was left half-written; free some space")
    assert list((tmp_path / "here").iterdir()) == []


@pytest.mark.parametrize("words", WRITERS, ids=lambda words: "-".join(words[:3]))
def test_a_read_only_folder(
    command: Command, given: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]
) -> None:
    monkeypatch.setattr(os, "access", lambda path, mode, **how: not mode & os.W_OK)
    refused(command(words[0], *given, *words[1:]), "is read-only; choose a folder that you may write to")
    assert list((tmp_path / "here").iterdir()) == []


def test_a_disk_that_fills_up_during_generate_leaves_nothing(
    command: Command, furnished: Furnished, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done, write = [], os.fsync

    def fills(descriptor: int) -> None:
        done.append(descriptor)
        if len(done) > 4:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        write(descriptor)

    monkeypatch.setattr(os, "fsync", fills)
    words = ("--program", furnished.folder / "program.py", "--starts", 1, "--no-pictures", "--out", tmp_path / "out")
    refused(command("generate", furnished.scene, *words), "No space left on device")
    assert len(done) == 5 and list(tmp_path.iterdir()) == []


def mesh_room(folder: Path, data: bytes | int) -> tuple[Path, Path]:
    """Write a room whose desk is a mesh file of these bytes, or of so many zeros."""
    with (folder / "desk.glb").open("wb") as file:
        file.truncate(data) if isinstance(data, int) else file.write(data)
    scene, layout = folder / "room.json", folder / "layout.json"
    scene.write_text(json.dumps(ROOM))
    layout.write_text(json.dumps(DESK))
    return scene, layout


BROKEN = {
    "no GLB": b"not a mesh at all",
    "cut off": b"glTF\x02\x00\x00\x00\x00\x10\x00\x00",
    "empty": b"",
}


@pytest.mark.parametrize("case", BROKEN)
def test_a_broken_mesh_is_refused_before_any_work(command: Command, tmp_path: Path, case: str) -> None:
    scene, layout = mesh_room(tmp_path, BROKEN[case])
    out = tmp_path / "out"
    refused(command("generate", scene, "--out", out), "asset 'desk-0': mesh desk.glb is broken", "leave path out")
    refused(command("export", scene, layout, "--to", "glb", "--out", out), "mesh desk.glb is broken")
    picture = out / "top.png"
    refused(command("render", scene, layout, "--view", "top", "--out", picture), "mesh desk.glb is broken")
    assert not out.exists()


def test_a_mesh_of_200_megabytes_is_refused_by_every_command(command: Command, tmp_path: Path) -> None:
    scene, layout = mesh_room(tmp_path, 200_000_000)
    out = tmp_path / "out"
    said = ("asset 'desk-0': path 'desk.glb' has 200 MB; at most 100 MB are read",)
    refused(command("generate", scene, "--out", out), *said)
    for name in ("check", "render", "settle"):
        refused(command(name, scene, layout), *said)
    assert not out.exists()


@pytest.mark.parametrize("suffix", ["glb", "obj", "stl", "ply"])
def test_a_mesh_of_every_format_is_drawn_and_exported(command: Command, tmp_path: Path, suffix: str) -> None:
    trimesh = import_module("trimesh")
    scene, layout = mesh_room(tmp_path, b"")
    trimesh.creation.box((0.6, 1.2, 0.7)).export(tmp_path / f"desk.{suffix}")
    data = json.loads(scene.read_text())
    data["assets"]["desk-0"]["path"] = f"desk.{suffix}"
    scene.write_text(json.dumps(data))
    ran = command("render", scene, layout, "--view", "top", "--size", 64, "--out", tmp_path / "top.png")
    assert ran.code == 0, ran
    assert command("export", scene, layout, "--to", "glb,mjcf", "--out", tmp_path).code == 0


def test_missing_extras_are_named(
    command: Command, given: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def missing(name: str) -> None:
        raise ImportError(name)

    monkeypatch.setattr(import_module("robolayout.render.beauty").importlib, "import_module", missing)
    refused(command("render", *given, "--beauty"), "needs the extra 'beauty': pip install 'robolayout[beauty]'")
    monkeypatch.undo()
    monkeypatch.setattr(import_module("robolayout.export.usd"), "find_spec", lambda name: None)
    out = tmp_path / "out"
    refused(command("export", *given, "--to", "glb,usd", "--out", out), "needs the extra 'usd'")
    assert not out.exists()
