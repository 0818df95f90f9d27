"""The plan for a model: coordinates stand where they are, every thing is named as in a program, nothing covers a name."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from PIL import Image

from robolayout.render import PlanMarks, annotation_camera, annotation_marks, model_plan
from robolayout.render._drawing import Text, text_width
from robolayout.render._model_plan import _sheet
from robolayout.render._style import MODEL_PLAN
from robolayout.render.annotation import draw_marks
from robolayout.scene import Layout, Pose, Scene, scene_from_dict


def full_room(count: int = 42) -> tuple[Scene, Layout]:
    """A hall with rows of chairs, a lamp above and a wardrobe at the wall."""
    box = {"x": 0.5, "y": 0.5, "z": 0.9}
    chair = {"category": "chair", "description": "", "onFloor": True, "assetMetadata": {"boundingBox": box}}
    wardrobe = chair | {"category": "wardrobe", "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 2.0}}}
    scene = scene_from_dict(
        {
            "task_description": "a hall",
            "boundary": {"floor_vertices": [[1, 2, 0], [9, 2, 0], [9, 9, 0], [1, 9, 0]], "wall_height": 2.6},
            "doors": [{"wall": 0, "offset": 6.5, "width": 0.9, "height": 2.05}],
            "windows": [{"wall": 0, "offset": 1.0, "width": 1.2, "height": 1.2, "sill": 0.9}],
            "assets": {"wardrobe-0": wardrobe, **{f"dining_chair-{i}": chair for i in range(count - 1)}},
        }
    )
    poses = {f"dining_chair-{i}": Pose(1.9 + i % 7, 3.6 + i // 7 * 0.9, 0.45, 0.0) for i in range(count - 1)}
    return scene, Layout({"wardrobe-0": Pose(1.3, 2.9, 1.0, 0.0), **poses})


def texts(scene: Scene, layout: Layout, marks: PlanMarks | None = None) -> list[Text]:
    return [item for item in _sheet(scene, layout, marks or PlanMarks(), None).items if isinstance(item, Text)]


def test_every_thing_wall_and_opening_is_named_as_in_a_program() -> None:
    scene, layout = full_room()
    written = " ".join(text.text for text in texts(scene, layout))
    names = [*scene.expressions.values(), *(f"walls[{i}]" for i in range(4)), "door 0", "window 0"]
    assert [name for name in names if name not in written] == []


def test_in_a_full_room_no_name_covers_another() -> None:
    scene, layout = full_room()
    boxes = []
    for text in texts(scene, layout):
        half = text_width(text.text, text.size) / 2
        middle = text.at[0] + (half if text.anchor == "start" else 0.0)
        w, h = (half, 0.35 * text.size) if text.angle == 0 else (0.35 * text.size, half)
        boxes.append((middle - w, text.at[1] - h, middle + w, text.at[1] + h, text.text))
    for a, b in combinations(boxes, 2):
        assert not (a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]), (a, b)
    names = [text for text in texts(scene, layout) if text.text.startswith(("#", "dining"))]
    assert min(text.size for text in names) >= min(MODEL_PLAN.sizes)


def test_ticks_stand_at_whole_metres() -> None:
    scene, layout = full_room()
    found = texts(scene, layout)
    columns = {int(t.text): t.at[0] for t in found if t.text.isdigit() and t.at[1] < 12}
    rows = {int(t.text): t.at[1] for t in found if t.text.isdigit() and t.at[0] < 12 and t.at[1] > 12}
    assert sorted(columns) == list(range(1, 10)) and sorted(rows) == list(range(2, 10))
    metre = MODEL_PLAN.longest / 8
    assert [columns[x + 1] - columns[x] for x in range(1, 9)] == pytest.approx([metre] * 8)
    assert [rows[y] - rows[y + 1] for y in range(2, 9)] == pytest.approx([metre] * 7)


def test_square_rooms_have_lines_both_ways() -> None:
    chair = {"category": "chair", "onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.5, "y": 0.5, "z": 0.9}}}
    floor = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]
    scene = scene_from_dict({"boundary": {"floor_vertices": floor, "wall_height": 2.6}, "assets": {"chair-0": chair}})
    found = texts(scene, Layout({"chair-0": Pose(2.5, 2.5, 0.45, 0.0)}))
    assert {t.text for t in found if t.text.isdigit() and t.at[0] < 12 and t.at[1] > 12} >= {"1", "2", "3"}


def test_what_must_stay_free_is_hatched_and_the_picture_is_as_large_as_asked() -> None:
    scene, layout = full_room()
    plain = model_plan(scene, Layout({}), size=640)
    assert max(plain.size) == 640
    hatched = (213, 94, 0)
    few, more = (_pixels(model_plan(scene, shown), hatched) for shown in (Layout({}), layout))
    assert few > 100, "the landing"
    assert more > few + 100, "where the wardrobe opens"


def _pixels(image: Image.Image, color: tuple[int, int, int]) -> int:
    return sum(
        n for n, c in image.getcolors(1 << 20) or () if max(abs(a - b) for a, b in zip(c, color, strict=True)) < 90
    )


def test_coordinates_stay_readable_under_many_names() -> None:
    """The blue numbers of the grid are drawn last: nearly as much of them is seen with 42 names as with none."""
    scene, layout = full_room()
    camera = annotation_camera(scene.room, "top", (768, 768))
    blank, far = np.full((768, 768, 3), 200, np.uint8), np.full((768, 768), np.inf, np.float32)
    marks = annotation_marks(scene, layout)
    few, all_ = (draw_marks(blank, far, camera, shown) for shown in ([m for m in marks if m.kind == "grid"], marks))
    assert _pixels(all_, (0, 114, 178)) > 0.9 * _pixels(few, (0, 114, 178))
