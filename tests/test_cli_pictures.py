"""`robolayout render` and the plan as a file: every view, what a machine reads from it, and options that do not go together."""

from __future__ import annotations

import io
import json
import math
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from robolayout.cli.pictures import viewpoint
from robolayout.render.camera import Camera
from robolayout.scene import Pose, load_layout, load_scene
from running import Furnished, Ran

Command = Callable[..., Ran]


@pytest.fixture(scope="module")
def given(furnished: Furnished) -> tuple[Path, Path]:
    return (furnished.folder / "scene.json", furnished.folder / "layout.json")


@pytest.mark.parametrize("renderer", ["gl", "ray"])
def test_ids_and_depths_lie_pixel_on_pixel(
    command: Command, given: tuple[Path, Path], tmp_path: Path, renderer: str
) -> None:
    out = tmp_path / "top.png"
    ran = command(
        "render", *given, "--view", "top", "--ids", "--depth", "--renderer", renderer, "--size", 160, "--out", out
    )
    if renderer == "gl" and ran.code == 2:
        pytest.skip(ran.err)
    assert ran.code == 0, ran
    assert [Path(line).name for line in ran.out.split()] == ["top.png", "top-ids.png", "top-depth.png", "top.json"]
    ids = np.asarray(Image.open(tmp_path / "top-ids.png"))
    depth = np.asarray(Image.open(tmp_path / "top-depth.png"))
    notes = json.loads((tmp_path / "top.json").read_text())
    assert ids.shape == depth.shape == Image.open(out).size == (160, 160)
    assert (depth == 0).sum() == (ids == 0).sum() > 0
    scene = load_scene(given[0])
    pose = load_layout(given[1], scene)["double_bed-0"]
    facts = notes["camera"]
    camera = Camera(
        tuple(facts["position"]), tuple(facts["target"]), tuple(facts["up"]),
        math.radians(facts["vertical_field_of_view"]), facts["width"], facts["height"],
    )  # fmt: skip
    (x, y), far = camera.project((pose.x, pose.y, pose.z))
    seen = notes["ids"][str(ids[int(y), int(x)])]
    assert seen == "double_bed-0"
    assert 0 <= far * 1000 - int(depth[int(y), int(x)]) < 600, "the top of the bed is above its middle"


def test_annotated_and_eye_level_views(command: Command, given: tuple[Path, Path], tmp_path: Path) -> None:
    options = ("--size", 200, "--renderer", "ray")
    for name, words in {
        "plain": ("--view", "side"),
        "marked": ("--view", "side", "--annotated"),
        "eye": ("--view", "eye:wardrobe-0"),
    }.items():
        ran = command("render", *given, *words, *options, "--out", tmp_path / f"{name}.png")
        assert ran.code == 0, ran
    plain, marked = (np.asarray(Image.open(tmp_path / f"{name}.png"), dtype=int) for name in ("plain", "marked"))
    assert np.abs(plain - marked).mean() > 2


def test_an_eye_level_picture_is_taken_on_the_way() -> None:
    route = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0)]
    pose = Pose(4.0, 4.0, 0.5, 0.0)
    assert viewpoint(route, pose, 2.0) == pytest.approx((4.0, 1.95))
    assert viewpoint(route, pose, 0.1) == pytest.approx((4.0, 2.7)), "never nearer than 1.2 m"
    assert viewpoint(route, pose, 50.0) == (0.0, 0.0), "as far as the way goes"
    assert viewpoint([(4.0, 3.9)], pose, 1.0) == (4.0, 3.9)


def test_the_plan_and_the_walk_by_the_ending_of_the_file(
    command: Command, given: tuple[Path, Path], tmp_path: Path
) -> None:
    for name, view in {"a.svg": "plan", "a.pdf": "plan", "a.png": "plan", "a.gif": "walk"}.items():
        ran = command("render", *given, "--view", view, "--out", tmp_path / name, "--size", 300)
        assert ran.code == 0 and ran.out.strip() == str(tmp_path / name), ran
    assert ElementTree.fromstring((tmp_path / "a.svg").read_bytes()).tag.endswith("svg")
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF-1.4")
    walk = Image.open(tmp_path / "a.gif")
    assert walk.n_frames > 20 and max(walk.size) == 300


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--view", "plan", "--ids"), "--ids does not go with --view plan"),
        (("--view", "walk", "--renderer", "ray"), "--renderer does not go with --view walk"),
        (("--view", "double_bed-0", "--annotated"), "--annotated does not go with --view double_bed-0"),
        (("--beauty", "--depth"), "--beauty and --depth exclude each other"),
        (("--beauty", "--renderer", "gl"), "--renderer and --beauty exclude each other"),
        (("--annotated", "--ids"), "--annotated and --ids exclude each other"),
        (("--renderer", "vulkan"), "--renderer 'vulkan' is not known: choose auto, gl or ray."),
        (("--view", "walk", "--out", "walk.png"), "name a file that ends in .gif"),
        (("--view", "top", "--out", "top.jpg"), "name a file that ends in .png"),
        (("--view", "eye:sofa-9"), "unknown view 'eye:sofa-9'. Known: eye:armchair-0, "),
        (("--view", "shet"), "Did you mean 'sheet'?"),
        (("--view", "eye:wardrob-0"), "Did you mean 'eye:wardrobe-0'?"),
        (("--view", "front"), "plan, potted_plant-0, rug-0, sheet, side, "),
        (("--view", "plan", "--date", "today"), "--date does not go with --view plan: use it with sheet."),
        (("--view", "sheet", "--out", "sheet.gif"), "name a file that ends in .pdf or .svg or .png"),
    ],
)
def test_options_that_do_not_go_together(
    command: Command, given: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: Any, said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = command("render", *given, *words)
    assert ran.code == 2 and said in ran.err and "Traceback" not in ran.err, ran
    assert list(tmp_path.iterdir()) == []


def test_the_sheet_to_print_has_the_users_date(command: Command, given: tuple[Path, Path], tmp_path: Path) -> None:
    for name in ("a.pdf", "a.svg", "a.png"):
        words = ("--view", "sheet", "--date", "1 May 2031", "--size", 400, "--out", tmp_path / name)
        ran = command("render", *given, *words)
        assert ran.code == 0 and ran.out.strip() == str(tmp_path / name), ran
    sheet = ElementTree.fromstring((tmp_path / "a.svg").read_bytes())
    assert sheet.get("width") in ("210mm", "297mm")
    assert {"Date", "1 May 2031", "1 : 50"} <= set(sheet.itertext())
    assert command("render", *given, "--view", "sheet", "--out", tmp_path / "b.pdf").code == 0
    assert (tmp_path / "b.pdf").read_bytes() != (tmp_path / "a.pdf").read_bytes()
    helped = " ".join(command("render", "--help").out.split())
    assert all(f"{view}" in helped for view in ("top", "side", "plan", "sheet", "walk", "eye:ASSET"))


def test_the_plan_is_a_format_like_others(command: Command, given: tuple[Path, Path], tmp_path: Path) -> None:
    ran = command("export", *given, "--to", "pdf,svg,dxf", "--out", tmp_path)
    assert ran.code == 0, ran
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".dxf", ".pdf", ".svg"]
    picture = ElementTree.parse(tmp_path / "scene.svg").getroot()
    text = "".join(picture.itertext())
    assert "double bed" in text and "route" in text and "free to move" in text
    assert (tmp_path / "scene.pdf").read_bytes().rstrip().endswith(b"%%EOF")


def test_a_plan_without_an_agent_shows_the_room(given: tuple[Path, Path]) -> None:
    from robolayout.export import to_bytes

    scene = load_scene(given[0])
    data = to_bytes(scene, load_layout(given[1], scene), "svg")
    assert b"double bed" in data and b"route" not in data
    assert data == to_bytes(scene, load_layout(given[1], scene), "svg")


@pytest.mark.slow
def test_generate_draws_the_walk_when_asked(command: Command, furnished: Furnished, tmp_path: Path) -> None:
    program = furnished.folder / "program.py"
    words = ("--program", program, "--starts", 1, "--no-pictures", "--quiet", "--walk", "--out", tmp_path)
    assert command("generate", furnished.scene, *words).code in (0, 1)
    assert Image.open(io.BytesIO((tmp_path / "walk.gif").read_bytes())).n_frames > 20
