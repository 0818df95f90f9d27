"""What every exporter must obey, whatever its format."""

from __future__ import annotations

import errno
import math
import os
import random
import subprocess
import sys
from importlib import import_module
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from robolayout._errors import InputError, LayoutError, MissingExtraError, OutputError, UnknownNameError
from robolayout.export import EXPORTERS, Exporter, Options, export, exporters, find_exporter, to_bytes
from robolayout.scene import DEFAULT_AGENT, Asset, Layout, Opening, Pose, Room, Scene
from running import slow

package = import_module("robolayout.export")
"""The folder; `import robolayout.export as ...` gives the function of that name."""

ROOM = Room(
    ((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)), 2.5, (Opening(0, 2.8, 0.9, 2.0),), (Opening(2, 1, 1.2, 1.2, 0.9),)
)
ASSETS = (
    Asset("desk-0", "desk", (0.65, 1.2, 0.74), "a desk"),
    Asset("desk_lamp-0", "desk lamp", (0.2, 0.2, 0.4), on_floor=False, on_object=True),
    Asset("mystery_thing-0", "mystery thing", (0.3, 0.4, 0.5)),
    Asset("mirror-0", "mirror", (0.03, 0.6, 0.8), on_floor=False, on_wall=True),
)
SCENE = Scene(ROOM, ASSETS, name="study")
LAYOUT = Layout(
    {
        "desk-0": Pose(0.335, 1.5, 0.37, 0.0),
        "desk_lamp-0": Pose(0.25, 1.9, 0.94, 0.4),
        "mystery_thing-0": Pose(3.0, 2.0, 0.25, -2.5),
        "mirror-0": Pose(3.984, 1.2, 1.5, math.pi),
    }
)
OPTIONS = Options(agent=DEFAULT_AGENT, routes={"desk-0": [(3.2, 0.4), (2.0, 1.0), (1.1, 1.5)]})

every = pytest.mark.parametrize("exporter", EXPORTERS.values(), ids=EXPORTERS.keys())
reading = pytest.mark.parametrize("exporter", [e for e in EXPORTERS.values() if e.read], ids=lambda e: e.name)


def poses_differ(one: Pose, other: Pose) -> float:
    return max(
        abs(one.x - other.x),
        abs(one.y - other.y),
        abs(one.z - other.z),
        abs(math.remainder(one.yaw - other.yaw, 2 * math.pi)),
    )


@every
def test_the_number_of_objects_names_and_poses_survive(exporter: Exporter) -> None:
    assert exporter.read is not None, f"{exporter.name} has no reader: give it one, or say why not"
    back = exporter.read(exporter.write(SCENE, LAYOUT, OPTIONS))
    assert set(back.layout) == set(LAYOUT)
    assert max(poses_differ(LAYOUT[name], back.layout[name]) for name in LAYOUT) < 1e-6


@every
def test_sizes_survive_where_the_format_has_a_place(exporter: Exporter) -> None:
    sizes = exporter.read(exporter.write(SCENE, LAYOUT, OPTIONS)).sizes
    assert exporter.name == "layout" or set(sizes) == set(LAYOUT)
    for name, size in sizes.items():
        assert max(abs(a - b) for a, b in zip(size, SCENE.by_name[name].size, strict=True)) < 1e-6


POSITION = st.floats(0.4, 2.6)


@reading
@settings(max_examples=5, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(x=POSITION, y=POSITION, yaw=st.floats(-20.0, 20.0), size=st.tuples(*[st.floats(0.05, 2.0)] * 3))
def test_any_pose_and_size_survive(exporter: Exporter, x: float, y: float, yaw: float, size: tuple[float, ...]) -> None:
    scene = Scene(ROOM, (Asset("stool-0", "stool", (size[0], size[1], size[2])),))
    pose = Pose(x, y, size[2] / 2, yaw)
    back = exporter.read(exporter.write(scene, Layout({"stool-0": pose}), Options()))
    assert poses_differ(pose, back.layout["stool-0"]) < 1e-6


STOOLS = tuple(Asset(f"stool-{i}", "stool", (0.4, 0.4, 0.45)) for i in range(3))


def shuffled(number: int) -> Layout:
    """The stools anywhere in the room."""
    draw = random.Random(number)
    ranges = ((0.0, 4.0), (0.0, 3.0), (0.3, 2.0), (-20.0, 20.0))
    return Layout({asset.name: Pose(*(draw.uniform(*ends) for ends in ranges)) for asset in STOOLS})


@reading
@pytest.mark.parametrize("count", [3, slow(1000)])
def test_random_layouts_come_back(exporter: Exporter, count: int) -> None:
    scene = Scene(Room(ROOM.vertices, 2.5), STOOLS)
    for number in range(count):
        layout = shuffled(number)
        back = exporter.read(exporter.write(scene, layout, Options()))
        assert set(back.layout) == set(layout)
        assert max(poses_differ(layout[name], back.layout[name]) for name in layout) < 1e-5, number


@every
def test_the_same_scene_gives_the_same_bytes(exporter: Exporter) -> None:
    assert exporter.write(SCENE, LAYOUT, OPTIONS) == exporter.write(SCENE, LAYOUT, OPTIONS)


@every
def test_the_order_of_the_layout_does_not_matter(exporter: Exporter) -> None:
    turned = Layout(dict(sorted(LAYOUT.items(), reverse=True)))
    assert exporter.write(SCENE, LAYOUT, OPTIONS) == exporter.write(SCENE, turned, OPTIONS)


@pytest.mark.slow
def test_bytes_do_not_depend_on_the_hash_seed(tmp_path: Path) -> None:
    program = (
        "import sys, hashlib; sys.path[:0] = sys.argv[1:]; import test_exporters as t; "
        "print([hashlib.sha256(e.write(t.SCENE, t.LAYOUT, t.OPTIONS)).hexdigest() for e in t.EXPORTERS.values()])"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", program, *map(str, Path(__file__).parents[:2])],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONDONTWRITEBYTECODE": "1"},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(outputs) == 1


@every
def test_an_empty_layout_of_an_empty_scene_can_be_written(exporter: Exporter) -> None:
    back = exporter.read(to_bytes(Scene(ROOM, ()), Layout({}), exporter.name))
    assert len(back.layout) == 0


@every
def test_an_unknown_asset_is_refused_by_name(exporter: Exporter, tmp_path: Path) -> None:
    wrong = Layout({**LAYOUT, "ghost-0": Pose(1, 1, 1, 0)})
    with pytest.raises(LayoutError, match=r"the layout places 'ghost-0', which is not in the scene. Known: desk-0"):
        export(SCENE, wrong, exporter.name, folder=tmp_path)
    assert list(tmp_path.iterdir()) == []


@every
def test_a_missing_asset_is_refused_unless_the_layout_may_be_partial(exporter: Exporter, tmp_path: Path) -> None:
    short = Layout({name: pose for name, pose in LAYOUT.items() if name != "desk-0"})
    with pytest.raises(LayoutError, match=r"no pose for 'desk-0' \(1 of 4 assets\).*partial=True"):
        export(SCENE, short, exporter.name, folder=tmp_path)
    assert list(tmp_path.iterdir()) == []
    path = export(SCENE, short, exporter.name, folder=tmp_path, partial=True)
    assert len(exporter.read(path.read_bytes()).layout) == 3


@every
@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_a_pose_that_is_no_number_is_refused(exporter: Exporter, value: float) -> None:
    broken = Layout({**LAYOUT, "desk-0": Pose(0.3, value, 0.3, 0.0)})
    with pytest.raises(LayoutError, match=r"the pose of 'desk-0' is not finite"):
        to_bytes(SCENE, broken, exporter.name)


@every
def test_it_is_found_by_name_and_by_suffix(exporter: Exporter) -> None:
    assert find_exporter(exporter.name) is exporter
    assert find_exporter(Path("out") / f"Room.One{exporter.suffix.upper()}") is exporter
    assert find_exporter(exporter.suffix.removeprefix(".")) is exporter


def test_names_and_suffixes_are_unique() -> None:
    assert len({exporter.suffix for exporter in EXPORTERS.values()}) == len(EXPORTERS)
    assert all(name == exporter.name and exporter.summary for name, exporter in EXPORTERS.items())


def test_every_format_file_is_listed() -> None:
    folder = Path(package.__file__).parent
    found = {
        name
        for path in folder.glob("[a-z]*.py")
        for name, value in vars(import_module(f"robolayout.export.{path.stem}")).items()
        if isinstance(value, Exporter) and value not in EXPORTERS.values()
    }
    assert found == set(), f"add {found} to EXPORTERS in robolayout/export/__init__.py"


@pytest.mark.parametrize("target", ["gbl", "room.obj", "room", "", "room.json"])
def test_an_unknown_format_lists_the_known(target: str, tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match=r"unknown export format .*Known: .*glb.*mjcf.*usd"):
        export(SCENE, LAYOUT, target, folder=tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_typo_is_answered_with_the_nearest_name() -> None:
    with pytest.raises(UnknownNameError, match=r"unknown export format 'mjfc'. Did you mean 'mjcf'\?"):
        find_exporter("mjfc")


@every
def test_export_writes_what_write_returns(exporter: Exporter, tmp_path: Path) -> None:
    path = export(SCENE, LAYOUT, exporter.name, folder=tmp_path / "new", options=OPTIONS)
    assert path == tmp_path / "new" / f"study{exporter.suffix}"
    assert path.read_bytes() == exporter.write(SCENE, LAYOUT, OPTIONS)
    beside = exporter.files(SCENE, LAYOUT, OPTIONS)[1]
    found = {file.relative_to(path.parent).as_posix(): file for file in path.parent.rglob("*") if file.is_file()}
    assert set(found) == {path.name, *beside}
    assert all(found[name].read_bytes() == data for name, data in beside.items())


def test_a_name_cannot_lead_out_of_the_folder(tmp_path: Path) -> None:
    sly = Scene(ROOM, (Asset("../../desk-0", "desk", (0.65, 1.2, 0.74)),), name="../../../study")
    inside = tmp_path / "a" / "b"
    path = export(sly, Layout({"../../desk-0": LAYOUT["desk-0"]}), "glb", folder=inside)
    assert path.parent == inside and path.name.endswith("study.glb")
    beside = export(sly, Layout({"../../desk-0": LAYOUT["desk-0"]}), "sceneeval", folder=inside).parent / "sceneeval"
    assert all(file.is_relative_to(beside) for file in tmp_path.rglob("data.json"))


@every
def test_a_full_disk_leaves_the_old_file_and_no_other(
    exporter: Exporter, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / f"room{exporter.suffix}"
    path.write_bytes(b"old")

    def full(descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OutputError, match=rf"cannot write {tmp_path}/.*: No space left on device. Nothing was left"):
        export(SCENE, LAYOUT, path)
    assert path.read_bytes() == b"old"
    assert [file.name for file in tmp_path.rglob("*") if file.is_file()] == [path.name]


@pytest.mark.parametrize("exporter", [e for e in EXPORTERS.values() if e.extra], ids=lambda e: e.name)
def test_a_missing_extra_is_named(exporter: Exporter, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(import_module("robolayout.export.usd"), "find_spec", lambda name: None)
    with pytest.raises(
        MissingExtraError, match=rf"needs the extra '{exporter.extra}': pip install 'robolayout\[usd\]'"
    ):
        export(SCENE, LAYOUT, exporter.name, folder=tmp_path)
    assert list(tmp_path.iterdir()) == []


@reading
@pytest.mark.parametrize("data", [b"", b"\x00\xff\xfe", b"{", b"[1, 2]", b"PK\x03\x04 broken", b"<a", b"<b/>"])
def test_a_reader_refuses_other_bytes_with_a_sentence(exporter: Exporter, data: bytes) -> None:
    with pytest.raises(LayoutError, match=r"\w+ .*\."):
        exporter.read(data)


def test_other_packages_register_formats(monkeypatch: pytest.MonkeyPatch) -> None:
    outside = Exporter("names", ".names", "one name a line", None, lambda s, layout, o: "\n".join(layout).encode())
    point = EntryPoint("names", "somewhere:NAMES", package.GROUP)
    monkeypatch.setattr(EntryPoint, "load", lambda self: outside)
    monkeypatch.setattr(package, "entry_points", lambda group: [point] if group == "robolayout.exporters" else [])
    exporters.cache_clear()
    try:
        assert to_bytes(SCENE, LAYOUT, "names").decode().split() == list(LAYOUT)
        assert set(exporters()) == {*EXPORTERS, "names"}
    finally:
        exporters.cache_clear()


def test_what_another_package_registers_wrongly_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    odd = EntryPoint("odd", "json:dumps", package.GROUP)
    monkeypatch.setattr(package, "entry_points", lambda group: [odd])
    exporters.cache_clear()
    try:
        with pytest.raises(InputError, match=r"the entry point 'odd' \(json:dumps\) .* is no Exporter"):
            to_bytes(SCENE, LAYOUT, "odd")
    finally:
        exporters.cache_clear()


def test_importing_the_package_loads_no_heavy_library() -> None:
    program = (
        "import sys, robolayout.export; "
        "print(sorted({'jax', 'mujoco', 'pxr', 'trimesh', 'matplotlib', 'scipy', 'moderngl'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
