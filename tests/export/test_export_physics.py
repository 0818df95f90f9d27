"""Settling and driving: stable rooms stay, unstable things are named, bases follow their lines."""

from __future__ import annotations

import math
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st

from robolayout._errors import LayoutError, MissingExtraError
from robolayout.assets import prisms_of
from robolayout.export.physics import Motion, drive, settle, timeline
from robolayout.scene import DEFAULT_AGENT, Agent, Asset, Layout, Pose, Room, Scene

ROOM = Room(((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)), 2.6)
TABLE = Asset("dining_table-0", "dining table", (0.9, 1.6, 0.75))


def test_a_sensible_room_stays_as_it_is(scene: Scene, layout: Layout) -> None:
    settled = settle(scene, layout)
    assert settled.violations == ()
    assert settled.stable_share == 1.0
    assert set(settled.motions) == set(layout)
    assert max(motion.displacement for motion in settled.motions.values()) < 0.003


def test_a_laid_table_stays_laid() -> None:
    things = [
        ("plate", (0.26, 0.26, 0.02), 0.0),
        ("fork", (0.2, 0.025, 0.015), -0.2),
        ("knife", (0.23, 0.02, 0.012), 0.2),
    ]
    things += [
        ("glass", (0.07, 0.07, 0.13), 0.35),
        ("fruit bowl", (0.28, 0.28, 0.12), 0.55),
        ("vase", (0.16, 0.16, 0.32), -0.5),
    ]
    assets, poses = [TABLE], {"dining_table-0": Pose(2.5, 2.0, 0.375, math.pi / 2)}
    for category, size, along in things:
        name = f"{category.replace(' ', '_')}-0"
        assets.append(Asset(name, category, size, on_floor=False, on_object=True))
        poses[name] = Pose(2.5 + along, 2.0 + 0.1 * along, 0.75 + size[2] / 2, math.pi / 2 + 0.1 * along)
    settled = settle(Scene(ROOM, tuple(assets)), Layout(poses))
    assert settled.violations == ()


def test_things_stacked_three_high_stay() -> None:
    book = Asset("book_stack-0", "book stack", (0.25, 0.2, 0.12), on_floor=False, on_object=True)
    mug = Asset("cup-0", "cup", (0.09, 0.09, 0.1), on_floor=False, on_object=True)
    layout = Layout({TABLE.name: Pose(2, 2, 0.375, 0), book.name: Pose(2, 2, 0.81, 0.3), mug.name: Pose(2, 2, 0.92, 1)})
    assert settle(Scene(ROOM, (TABLE, book, mug)), layout).stable_share == 1.0


def test_things_stand_in_a_shelf_of_ones_own(tmp_path: Path) -> None:
    boards = [trimesh.creation.box(bounds=[(0.0, 0.0, z), (0.3, 0.8, z + 0.02)]) for z in (0.0, 0.4, 0.8)] + [
        trimesh.creation.box(bounds=[(0.0, y, 0.0), (0.3, y + 0.02, 0.82)]) for y in (-0.02, 0.8)
    ]
    trimesh.util.concatenate(boards).export(tmp_path / "shelf.stl")
    shelf = Asset("shelf-0", "bookshelf", (0.3, 0.84, 0.82), path=tmp_path / "shelf.stl")
    mug = Asset("cup-0", "cup", (0.09, 0.09, 0.1), on_floor=False, on_object=True)
    layout = Layout({"shelf-0": Pose(2, 2, 0.41, 0), "cup-0": Pose(2, 2, 0.47, 0)})
    assert settle(Scene(ROOM, (shelf, mug)), layout, 1.0).stable_share == 1.0


def test_furniture_stands_through_rugs_and_on_them() -> None:
    rug = Asset("rug-0", "rug", (2.0, 3.0, 0.012))
    lamp = Asset("vase-0", "vase", (0.2, 0.2, 0.3), on_object=True)
    poses = {"rug-0": Pose(2.5, 2, 0.006, 0), TABLE.name: Pose(2.5, 2, 0.375, 0.2), "vase-0": Pose(3.3, 3, 0.162, 0)}
    settled = settle(Scene(ROOM, (rug, TABLE, lamp)), Layout(poses))
    assert settled.violations == ()
    assert settled.motions["vase-0"].displacement < 0.01


@pytest.mark.parametrize(
    ("pose", "moved"),
    [(Pose(2.5, 2.0, 1.2, 0.0), 0.2), (Pose(2.5, 2.0 + 0.84, 0.95, 0.0), 0.5)],
    ids=["in mid-air", "over the edge"],
)
def test_what_cannot_stay_is_named(pose: Pose, moved: float) -> None:
    vase = Asset("vase-0", "vase", (0.2, 0.2, 0.4), on_floor=False, on_object=True)
    layout = Layout({TABLE.name: Pose(2.5, 2.0, 0.375, 0.0), "vase-0": pose})
    settled = settle(Scene(ROOM, (TABLE, vase)), layout, 2.0)
    assert settled.motions["vase-0"].displacement > moved
    assert settled.stable_share == 0.5
    assert settled.violations[0].startswith("vase-0 does not stay: it moved ")
    assert settled.violations[0].endswith("degrees after 2 s of gravity.")


def test_overlapping_things_push_each_other_apart() -> None:
    boxes = tuple(Asset(f"storage_box-{i}", "storage box", (0.4, 0.4, 0.4)) for i in range(2))
    layout = Layout({"storage_box-0": Pose(2, 2, 0.2, 0), "storage_box-1": Pose(2.3, 2, 0.2, 0)})
    assert settle(Scene(ROOM, boxes), layout, 1.0).stable_share == 0.0


def test_unplaced_assets_are_not_stable(scene: Scene, layout: Layout) -> None:
    settled = settle(scene, Layout({"wardrobe-0": layout["wardrobe-0"]}), 0.2)
    assert settled.stable_share == pytest.approx(1 / 9)
    assert settled.to_dict()["unplaced"] == [asset.name for asset in scene.assets if asset.name != "wardrobe-0"]


def test_limits_are_one_centimetre_and_two_degrees() -> None:
    assert Motion(0.0099, math.radians(1.9)).stable
    assert not Motion(0.0101, 0.0).stable
    assert not Motion(0.0, math.radians(2.1)).stable
    assert not Motion(math.inf, math.pi).stable


def test_settling_is_repeatable(scene: Scene, layout: Layout) -> None:
    assert settle(scene, layout, 0.5) == settle(scene, layout, 0.5)


def test_a_layout_of_another_scene_is_refused(scene: Scene) -> None:
    with pytest.raises(LayoutError, match="ghost-0"):
        settle(scene, Layout({"ghost-0": Pose(0, 0, 0, 0)}))
    with pytest.raises(LayoutError, match="ghost-0"):
        drive(scene, Layout({"ghost-0": Pose(0, 0, 0, 0)}), DEFAULT_AGENT, {})


def test_a_missing_extra_is_named(scene: Scene, layout: Layout, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(import_module("robolayout.export._mujoco"), "find_spec", lambda name: None)
    with pytest.raises(
        MissingExtraError, match=r"the physics check needs the extra 'sim': pip install 'robolayout\[sim\]'"
    ):
        settle(scene, layout)


def test_the_base_follows_a_free_line_and_touches_nothing(scene: Scene, layout: Layout) -> None:
    lines = {"wardrobe-0": [(4.0, 0.5), (3.6, 1.4), (3.7, 3.2)], "potted_plant-0": [(4.0, 0.5), (3.0, 0.4), (0.8, 0.4)]}
    driven = drive(scene, layout, DEFAULT_AGENT, lines)
    assert driven.violations == ()
    assert max(way.error for way in driven.drives.values()) < 0.01
    assert driven.drives["potted_plant-0"].length == pytest.approx(math.hypot(1, 0.1) + 2.2)
    assert driven.drives["wardrobe-0"].seconds > driven.drives["wardrobe-0"].length / 0.5


def test_what_stands_in_the_way_is_named(scene: Scene, layout: Layout) -> None:
    driven = drive(
        scene,
        layout,
        DEFAULT_AGENT,
        {"night_stand-0": [(4.0, 0.5), (1.0, 1.6)], "wardrobe-0": [(4.0, 0.5), (4.9, 0.5)]},
    )
    assert "double_bed-0" in driven.contacts["night_stand-0"]
    assert driven.contacts["wardrobe-0"] == ("wall-1",)
    assert driven.violations[0].startswith("disc touches double_bed-0")
    assert driven.to_dict()["routes"]["wardrobe-0"]["contacts"] == ["wall-1"]


def test_a_low_body_passes_below_and_over_a_rug(scene: Scene, layout: Layout) -> None:
    hanging = Asset("picture-0", "picture", (0.03, 0.7, 0.5), on_floor=False, on_wall=True)
    room = Scene(ROOM, (hanging, Asset("rug-0", "rug", (1.0, 1.0, 0.01))))
    places = Layout({"picture-0": Pose(2.5, 2.0, 0.6, 0.0), "rug-0": Pose(2.5, 1.0, 0.005, 0.0)})
    line = {"rug-0": [(2.5, 0.5), (2.5, 3.0)]}
    assert drive(room, places, Agent("robot_vacuum", 0.175, 0.09), line).contacts == {}
    assert drive(room, places, DEFAULT_AGENT, line).contacts == {"rug-0": ("picture-0",)}


def test_a_body_passes_over_what_is_as_high_as_its_step() -> None:
    bollard = Asset("safety_bollard-0", "safety bollard", (0.2, 0.2, 1.0))
    plate = prisms_of(bollard)[0].high
    places = Layout({bollard.name: Pose(2.5, 2.0, 0.5, 0.0)})
    line = {bollard.name: [(2.5 - 0.285, 1.0), (2.5 - 0.285, 3.0)]}
    for step, met in ((plate, {}), (plate - 0.005, {bollard.name: (bollard.name,)})):
        body = Agent("amr", 0.2, 0.36, step=step)
        assert drive(Scene(ROOM, (bollard,)), places, body, line).contacts == met


def test_a_long_body_turns_on_the_spot_and_stops_to_drive_back() -> None:
    wheelchair = Agent("wheelchair", 0.45, 1.3, length=1.22, width=0.76)
    turn = {"x-0": [(1.0, 1.0, 0.0), (3.0, 1.0, 0.0), (3.0, 1.0, math.pi / 2), (3.0, 3.0, math.pi / 2)]}
    driven = drive(Scene(ROOM, ()), Layout({}), wheelchair, turn)
    assert driven.contacts == {}
    assert driven.drives["x-0"].seconds > 4.0 / 0.5 + math.pi / 2
    close = {"x-0": [(1.0, 0.5, 0.0), (3.0, 0.5, 0.0), (3.0, 0.5, math.pi / 2), (3.0, 3.0, math.pi / 2)]}
    assert drive(Scene(ROOM, ()), Layout({}), wheelchair, close).contacts == {"x-0": ("wall-0",)}
    assert drive(Scene(ROOM, ()), Layout({}), wheelchair, {"x-0": [way[:2] for way in close["x-0"]]}).contacts == {}
    back = drive(Scene(ROOM, ()), Layout({}), wheelchair, {"x-0": [(1.0, 1.0, 0.0), (3.0, 1.0, 0.0), (1.0, 1.0, 0.0)]})
    assert back.drives["x-0"].length == pytest.approx(4.0) and back.drives["x-0"].error < 0.01


def test_lines_with_nothing_to_drive_are_skipped(scene: Scene, layout: Layout) -> None:
    assert drive(scene, layout, DEFAULT_AGENT, {"rug-0": [], "wardrobe-0": [(1, 1)]}).drives == {}
    still = drive(Scene(ROOM, ()), Layout({}), DEFAULT_AGENT, {"x-0": [(1, 1), (1, 1)]})
    assert still.drives["x-0"].contacts == ()


COORDINATE = st.floats(0.0, 5.0).map(lambda value: round(value, 2))


@settings(max_examples=40, deadline=None)
@given(way=st.lists(st.tuples(COORDINATE, COORDINATE, COORDINATE), min_size=2, max_size=6), turns=st.booleans())
def test_timelines_obey_their_limits(way: list[tuple[float, float, float]], turns: bool) -> None:
    poses = np.array(way) if turns else np.array(way)[:, :2]
    times, path = timeline(poses, 0.5)
    assert (np.diff(times) > 0).all()
    assert path[0, : poses.shape[1]] == pytest.approx(poses[0])
    assert path[-1, : poses.shape[1]] == pytest.approx(poses[-1])
    speed = np.linalg.norm(np.diff(path[:, :2], axis=0), axis=1) / np.diff(times)
    assert speed.max(initial=0.0) <= 0.5 + 1e-9
    if not turns:
        assert np.ptp(path[:, 2]) == 0
    change = np.abs(np.diff(path[:, 2])) / np.diff(times)
    assert change.max(initial=0.0) <= 1.0 + 1e-9
