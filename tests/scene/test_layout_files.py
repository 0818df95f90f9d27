"""Layout files: degrees and names in, poses out, and back."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robolayout._errors import LayoutError
from robolayout.scene import Asset, Layout, Pose, Room, Scene, layout_from_dict, load_layout

ROOM = Room(((0, 0), (4, 0), (4, 5), (0, 5)), 2.6)
SCENE = Scene(ROOM, (Asset("bed-0", "bed", (2, 1.6, 0.5)), Asset("lamp-0", "lamp", (0.2, 0.2, 0.4), on_object=True)))


def entry(x: float = 1, y: float = 2, z: float = 0.25, degrees: float = 0) -> dict[str, list[float]]:
    return {"position": [x, y, z], "rotation": [0, 0, degrees]}


def test_degrees_become_radians() -> None:
    layout = layout_from_dict({"bed-0": entry(degrees=90)}, SCENE)
    assert layout["bed-0"] == Pose(1, 2, 0.25, math.pi / 2)
    assert layout["bed-0"].forward == pytest.approx((0, 1))


def test_missing_assets_are_unplaced_and_the_order_is_that_of_the_scene() -> None:
    assert list(layout_from_dict({"lamp-0": entry(), "bed-0": entry()}, SCENE)) == ["bed-0", "lamp-0"]
    assert list(layout_from_dict({"lamp-0": entry()}, SCENE)) == ["lamp-0"]
    assert len(layout_from_dict({}, SCENE)) == 0


def test_one_number_is_a_rotation_too() -> None:
    data: dict[str, dict[str, object]] = {"bed-0": {"position": [1, 2, 0.25], "rotation": [-90], "scale": 1}}
    assert layout_from_dict(data)["bed-0"].yaw == pytest.approx(math.radians(270))
    data["bed-0"]["rotation"] = 0
    assert layout_from_dict(data)["bed-0"].yaw == 0.0


@given(
    st.lists(st.tuples(*[st.floats(-100, 100)] * 3, st.floats(-10, 10)), min_size=2, max_size=2),
)
def test_written_layouts_read_back(poses: list[tuple[float, float, float, float]]) -> None:
    layout = Layout(dict(zip(("bed-0", "lamp-0"), (Pose(*pose) for pose in poses), strict=True)))
    back = layout_from_dict(json.loads(json.dumps(layout.to_dict())), SCENE)
    for name, pose in layout.items():
        assert math.dist((pose.x, pose.y, pose.z), (back[name].x, back[name].y, back[name].z)) < 2e-6
        assert math.dist(pose.forward, back[name].forward) < 1e-7
    assert layout_from_dict(back.to_dict(), SCENE).to_dict() == back.to_dict()


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ([], "the layout must be an object with named values, but is []."),
        (
            {"bde-0": entry()},
            "the layout places 'bde-0', which is not in the scene. Did you mean 'bed-0'? Known: bed-0, lamp-0.",
        ),
        (
            {"walls": entry()},
            "the layout places 'walls', which is not in the scene. Known: bed-0, lamp-0. "
            "Take it out, or give the scene.json of the run, which has what lies about.",
        ),
        ({"bed-0": None}, "layout['bed-0'] must be an object with named values, but is None."),
        ({"bed-0": {"rotation": [0]}}, "layout['bed-0'] has no \"position\"; add it."),
        ({"bed-0": {"position": [0, 0, 0]}}, "layout['bed-0'] has no \"rotation\"; add it."),
        ({"bed-0": entry(math.nan)}, "layout['bed-0'].position[0] must be a finite number, but is nan."),
        ({"bed-0": entry(degrees=math.inf)}, "layout['bed-0'].rotation[2] must be a finite number, but is inf."),
        ({"bed-0": {"position": [0, 0], "rotation": [0]}}, "layout['bed-0'].position must have 3 numbers, but has 2."),
        (
            {"bed-0": {"position": [0, 0, 0], "rotation": [0, 90, 0]}},
            "layout['bed-0'].rotation is [0.0, 90.0, 0.0]: only the last number may differ from 0, degrees about the "
            "vertical.",
        ),
        ({str(i): entry() for i in range(2001)}, "the layout has 2001 entries; at most 2000 are allowed."),
    ],
    ids=lambda value: value[:40] if isinstance(value, str) else "",
)
def test_wrong_layouts(data: object, message: str) -> None:
    with pytest.raises(LayoutError) as caught:
        layout_from_dict(data, SCENE)
    assert str(caught.value) == message


def test_layout_files(tmp_path: Path) -> None:
    path = tmp_path / "layout.json"
    with pytest.raises(LayoutError, match=r"layout file .*layout\.json does not exist; check the path\."):
        load_layout(path, SCENE)
    path.write_text('{"bed-0": }')
    with pytest.raises(LayoutError, match=r"is not JSON: Expecting value at line 1, column 11\."):
        load_layout(path, SCENE)
    path.write_text(json.dumps({"bed-0": entry()}))
    assert load_layout(path, SCENE)["bed-0"] == Pose(1, 2, 0.25, 0)
