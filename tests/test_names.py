"""Names are the user's: whatever they are, a run's files keep them byte for byte and fit each other."""

from __future__ import annotations

import ast
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from hostile_names import NAMES, hostile_scene
from robolayout.export import EXPORTERS, export, to_bytes
from robolayout.scene import load_layout, load_scene
from running import Ran

Command = Callable[..., Ran]


@pytest.fixture(scope="module")
def made(command: Command, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run on a room of such names."""
    folder = tmp_path_factory.mktemp("names")
    (folder / "given.json").write_text(json.dumps(hostile_scene(), ensure_ascii=False), encoding="utf-8")
    ran = command("generate", folder / "given.json", "--out", folder / "out", "--no-pictures")
    assert ran.code in (0, 1), ran
    return folder


def read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def test_every_file_keeps_the_names(made: Path) -> None:
    out = made / "out"
    assert list(read(out / "scene.json")["assets"]) == list(NAMES)
    assert set(read(out / "layout.json")) == set(NAMES)
    assert sorted(name for group in read(out / "grouping.json") for name in group["items"]) == sorted(NAMES)


def test_each_name_has_an_expression_of_its_own_that_programs_use(made: Path) -> None:
    written = read(made / "out" / "constraints.json")["expressions"]
    assert set(written) == set(NAMES) and len(set(written.values())) == len(NAMES)
    assert (written["map-0"], written["桌子-0"], written["bed-0"]) == ("asset_map[0]", "u684c_u5b50[0]", "bed[0]")
    program = (made / "out" / "program.py").read_text(encoding="utf-8")
    assert all(expression in program for expression in written.values())
    ast.parse("\n".join(written.values()))


def test_a_runs_own_output_is_read_back(command: Command, made: Path) -> None:
    out = made / "out"
    ran = command("check", out / "scene.json", out / "layout.json", "--json")
    assert ran.code in (0, 1) and "not in the scene" not in ran.err, ran
    again = made / "again"
    ran = command("generate", made / "given.json", "--program", out / "program.py", "--out", again, "--no-pictures")
    assert ran.code in (0, 1), ran
    assert (again / "layout.json").read_bytes() == (out / "layout.json").read_bytes()


@pytest.mark.parametrize("name", [name for name, exporter in EXPORTERS.items() if exporter.read])
def test_exports_keep_the_names(made: Path, name: str) -> None:
    scene = load_scene(made / "out" / "scene.json")
    layout = load_layout(made / "out" / "layout.json", scene)
    read_back = EXPORTERS[name].read
    assert read_back is not None
    found = read_back(to_bytes(scene, layout, name)).layout
    assert set(found) == set(NAMES)
    for asset in NAMES:
        assert (found[asset].x, found[asset].y) == pytest.approx((layout[asset].x, layout[asset].y), abs=1e-6)


def test_mujoco_loads_them(made: Path, tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    scene = load_scene(made / "out" / "scene.json")
    path = export(scene, load_layout(made / "out" / "layout.json", scene), "mjcf", folder=tmp_path)
    model = mujoco.MjModel.from_xml_path(str(path))
    assert {model.body(name).name for name in NAMES} == set(NAMES)


def test_meshes_of_any_name_stay_in_their_folder(made: Path, tmp_path: Path) -> None:
    scene = load_scene(made / "given.json")
    export(scene, load_layout(made / "out" / "layout.json", scene), "a.sceneeval.json", folder=tmp_path / "in")
    assert [path.name for path in tmp_path.iterdir()] == ["in"]
    meshes = {path.stem for path in (tmp_path / "in" / "sceneeval").rglob("*.glb")}
    assert meshes and not any("." in name or "/" in name for name in meshes)


def test_a_plan_and_a_view_are_drawn(command: Command, made: Path) -> None:
    files = (made / "out" / "scene.json", made / "out" / "layout.json")
    plan = made / "plan.svg"
    assert command("render", *files, "--view", "plan", "--out", plan).code == 0
    text = plan.read_text(encoding="utf-8")
    assert "桌子" in text and "cafe\u0301-0" in text and "caf\u00e9-0" in text
    assert command("render", *files, "--view", "eye:桌子-0", "--size", 64, "--out", made / "eye.png").code == 0
