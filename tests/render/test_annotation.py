"""Marks land on the pixels where the camera sends them, and say what programs say."""

import numpy as np
import pytest
import shapely

from robolayout._errors import UnknownNameError
from robolayout.render import Studio, annotate, annotation_camera, annotation_marks
from robolayout.render.annotation import (
    DOOR_COLOR,
    FRONT_COLOR,
    GRID_COLOR,
    WALL_COLOR,
    draw_marks,
    grid_points,
    grid_spacing,
)
from robolayout.scene import Layout, Room

COLORS = {"grid": GRID_COLOR, "front": FRONT_COLOR, "wall": WALL_COLOR, "door": DOOR_COLOR, "window": DOOR_COLOR}


def rgb(color):
    return np.array([int(color[k : k + 2], 16) for k in (1, 3, 5)])


@pytest.mark.parametrize("view", ["top", "side"])
def test_every_mark_is_on_its_pixel(bedroom, layout, view):
    """Each kind is drawn alone, so that no label may cover another's mark; hidden grid points are faint."""
    studio = Studio(bedroom, layout, renderer="rays")
    camera = annotation_camera(bedroom.room, view, (320, 320))
    buffers = studio.buffers(camera)
    blank = np.full((320, 320, 3), 200, np.uint8)
    for mark in annotation_marks(bedroom, layout):
        image = np.asarray(draw_marks(blank, np.full((320, 320), np.inf, np.float32), camera, [mark]), dtype=int)
        (u, v), _ = camera.project(mark.place)
        assert 0 <= u < 320 and 0 <= v < 320, mark
        assert np.abs(image[int(v), int(u)] - rgb(COLORS[mark.kind])).max() < 30, mark
        if mark.tip is not None:
            (u, v), (a, b) = camera.project(mark.tip)[0], camera.project(mark.place)[0]
            inward = np.array([a - u, b - v]) / np.hypot(a - u, b - v) * 3
            at = (np.array([u, v]) + inward).astype(int)
            assert np.abs(image[at[1], at[0]] - rgb(FRONT_COLOR)).max() < 40, mark
    assert buffers.color.shape == (320, 320, 3)


def test_hidden_grid_points_are_faint(bedroom, layout):
    camera = annotation_camera(bedroom.room, "top", (320, 320))
    buffers = Studio(bedroom, layout, renderer="rays").buffers(camera)
    grid = [mark for mark in annotation_marks(bedroom, layout) if mark.kind == "grid"]
    under_bed = next(mark for mark in grid if mark.place == (1.0, 3.0, 0.0))
    image = np.asarray(draw_marks(buffers.color, buffers.depth, camera, [under_bed]), dtype=int)
    (u, v), _ = camera.project(under_bed.place)
    assert np.abs(image[int(v), int(u)] - rgb(GRID_COLOR)).max() > 40


def test_wall_labels_are_outside_the_room(room, bedroom, layout):
    polygon = shapely.Polygon(room.vertices)
    walls = [mark for mark in annotation_marks(bedroom, layout) if mark.kind == "wall"]
    assert [mark.text for mark in walls] == ["walls[0]", "walls[1]", "walls[2]", "walls[3]"]
    for mark in walls:
        assert polygon.distance(shapely.Point(mark.place[:2])) == pytest.approx(0.2)


def test_names_are_those_of_programs_and_arrows_follow_the_front(bedroom, layout):
    fronts = {mark.text: mark for mark in annotation_marks(bedroom, layout) if mark.kind == "front"}
    assert "night_stand[1]" in fronts
    wardrobe = fronts["wardrobe[0]"]
    assert np.subtract(wardrobe.tip, wardrobe.place) == pytest.approx((-0.75, 0, 0), abs=1e-9)


def test_grid_spacing_and_points():
    l_shape = Room(((0, 0), (3, 0), (3, 1.5), (1.5, 1.5), (1.5, 3), (0, 3)), 2.6)
    assert grid_spacing(l_shape) == 1.0
    assert (2.0, 2.0) not in grid_points(l_shape) and (1.0, 2.0) in grid_points(l_shape)
    vast = Room(((0, 0), (1200, 0), (1200, 600), (0, 600)), 5)
    assert grid_spacing(vast) == 3.0


def test_pictures_are_repeatable_and_unknown_views_refused(bedroom, layout):
    first, second = (annotate(bedroom, layout, view="side", size=200, renderer="rays") for _ in range(2))
    assert first.tobytes() == second.tobytes()
    with pytest.raises(UnknownNameError, match="unknown annotated view 'bed-0'"):
        annotate(bedroom, layout, view="bed-0", size=200, renderer="rays")


def test_an_empty_room_is_annotated_too(bedroom):
    assert annotate(bedroom, Layout({}), size=(200, 160), renderer="rays").size == (200, 160)
