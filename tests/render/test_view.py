"""Views: what is seen where, from both renderers, and what happens without EGL."""

import math

import numpy as np
import pytest

from robolayout import generate
from robolayout._errors import InputError, LayoutError, UnknownNameError
from robolayout.assets import Material, Part
from robolayout.render import Studio, _gl, render_asset, render_view
from robolayout.render._mesh import parts_mesh
from robolayout.render.camera import fitted_camera, room_points
from robolayout.render.view import GHOST, hidden_parts, make_renderer, near_walls
from robolayout.scene import Asset, Layout, Pose, Room, Scene

needs_egl = pytest.mark.skipif(_gl.why_unavailable() is not None, reason="no EGL on this machine")
both = pytest.mark.parametrize("renderer", [pytest.param("gl", marks=needs_egl), "rays"])


@pytest.fixture(scope="module")
def studios(bedroom, layout):
    made = {}

    def make(renderer):
        if renderer not in made:
            made[renderer] = Studio(bedroom, layout, renderer=renderer)
        return made[renderer]

    return make


@both
def test_assets_are_seen_where_the_camera_projects_them(bedroom, layout, studios, renderer):
    studio = studios(renderer)
    buffers = studio.buffers(studio.camera("top", (256, 256)))
    for name in ("bed-0", "wardrobe-0", "night_stand-1", "ceiling_lamp-0", "table_lamp-0"):
        pose, asset = layout[name], bedroom.by_name[name]
        pixel, _ = buffers.camera.project((pose.x, pose.y, pose.z))
        seen = buffers.ids[int(pixel[1]), int(pixel[0])]
        assert buffers.names[seen] == asset.name
    assert buffers.ids[0, 0] == -1 and np.isinf(buffers.depth[0, 0])


@both
def test_depth_is_metres_along_the_line_of_sight(studios, renderer):
    studio = studios(renderer)
    buffers = studio.buffers(studio.camera("top", (256, 256)))
    pixel, depth = buffers.camera.project((2.6, 0.8, 0.0))
    assert buffers.depth[int(pixel[1]), int(pixel[0])] == pytest.approx(float(depth), abs=0.01)


@needs_egl
@pytest.mark.parametrize("view", ["top", "side", "eye:bed-0"])
def test_both_renderers_draw_the_same_picture(studios, view):
    size = (200, 150)
    fast, slow = (np.asarray(studios(r).view(view, size=size), dtype=int) for r in ("gl", "rays"))
    difference = np.abs(fast - slow)
    assert difference.mean() < 2.5
    assert (difference.max(axis=2) > 40).mean() < 0.03


@needs_egl
def test_both_renderers_agree_on_ids(studios):
    camera = studios("gl").camera("side", (200, 150))
    fast, slow = studios("gl").buffers(camera), studios("rays").buffers(camera)
    assert (fast.ids != slow.ids).mean() < 0.01
    both_hit = np.isfinite(fast.depth) & np.isfinite(slow.depth)
    assert np.median(np.abs(fast.depth[both_hit] - slow.depth[both_hit])) < 1e-3


@both
def test_same_bytes_twice(bedroom, layout, renderer):
    first, second = (render_view(bedroom, layout, view="side", size=96, renderer=renderer) for _ in range(2))
    assert first.tobytes() == second.tobytes()


def test_without_egl_auto_falls_back_to_ray_casting(bedroom, layout, monkeypatch):
    def refuse(*_):
        raise Exception("(eglGetDisplay) no display")

    expected = render_view(bedroom, layout, size=64, renderer="rays")
    monkeypatch.setattr(_gl, "_context", refuse)
    assert render_view(bedroom, layout, size=64).tobytes() == expected.tobytes()
    with pytest.raises(InputError, match=r"renderer 'gl' does not work on this machine: \(eglGetDisplay\) no display"):
        render_view(bedroom, layout, size=64, renderer="gl")


def test_unknown_names_and_bad_poses_are_refused(bedroom, layout):
    with pytest.raises(UnknownNameError, match=r"unknown view 'sid'\. Did you mean 'side'"):
        render_view(bedroom, layout, view="sid", renderer="rays")
    with pytest.raises(UnknownNameError, match="unknown renderer 'vtk'"):
        render_view(bedroom, layout, renderer="vtk")
    with pytest.raises(LayoutError, match="places 'sofa-0', which is not in the scene"):
        render_view(bedroom, Layout({"sofa-0": Pose(1, 1, 0.4, 0)}))
    with pytest.raises(LayoutError, match="pose of 'bed-0' is not finite"):
        render_view(bedroom, Layout({"bed-0": Pose(1, math.nan, 0.4, 0)}))
    with pytest.raises(InputError, match="picture size 4 x 4 is not possible"):
        render_view(bedroom, layout, size=4)


def test_an_empty_layout_shows_the_empty_room(bedroom):
    buffers = Studio(bedroom, Layout({}), renderer="rays").buffers
    camera = fitted_camera(room_points(bedroom.room), 0.0, -math.pi / 2, (64, 64))
    assert set(np.unique(buffers(camera).ids)) == {-1, 0}


def test_walls_towards_the_camera_are_cut_away(room):
    camera = fitted_camera(room_points(room), math.radians(45), math.radians(-60), (64, 64))
    assert near_walls(room, camera) == {0, 1}
    above = fitted_camera(room_points(room), 0.0, -math.pi / 2, (64, 64))
    assert near_walls(room, above) == set()


def test_an_inner_wall_of_an_l_shaped_room_is_cut_only_if_it_hides_the_floor():
    room = Room(((0, 0), (6, 0), (6, 3), (3, 3), (3, 6), (0, 6)), 2.6)
    camera = fitted_camera(room_points(room), math.radians(45), math.radians(-120), (64, 64))
    assert {0, 5} <= near_walls(room, camera)
    assert near_walls(room, camera).isdisjoint({1, 2, 4})
    from_behind = fitted_camera(room_points(room), math.radians(45), math.radians(45), (64, 64))
    assert {2, 3} <= near_walls(room, from_behind)


def test_what_hangs_on_a_cut_wall_goes_with_it(bedroom, layout):
    behind = fitted_camera(room_points(bedroom.room), math.radians(45), math.radians(180), (64, 64))
    assert {"picture-0", "wall-3"} <= hidden_parts(bedroom, layout, behind)
    front = fitted_camera(room_points(bedroom.room), math.radians(45), math.radians(-30), (64, 64))
    assert "picture-0" not in hidden_parts(bedroom, layout, front)
    assert {"wall-0", "door-0"} <= hidden_parts(bedroom, layout, front)


def test_what_stands_before_a_cut_wall_stays_and_flush_lamps_are_ghosts():
    """A television on its stand was left out with the wall, and ceiling lamps were discs in the air."""
    result = generate("A living room with a television on a tv stand and a ceiling lamp", dress="none")
    scene, layout = result.scene, result.layout
    for azimuth in range(0, 360, 45):
        camera = fitted_camera(room_points(scene.room), math.radians(45), math.radians(azimuth), (64, 64))
        assert "television-0" not in hidden_parts(scene, layout, camera)
    shown = Studio(scene, layout).shown(camera)
    drawn = {shown.names[group] for group in np.unique(shown.groups)}
    assert "ceiling_lamp-0" not in drawn
    assert f"{GHOST}ceiling_lamp-0" in drawn


def test_the_side_view_looks_at_fronts(bedroom, layout):
    studio = Studio(bedroom, layout, renderer="rays")
    to_wardrobe = Layout({"wardrobe-0": layout["wardrobe-0"]})
    azimuth = Studio(bedroom, to_wardrobe, renderer="rays").side_azimuth
    assert math.cos(azimuth) < 0
    assert studio.side_azimuth == studio.side_azimuth


@both
def test_a_lamp_does_not_hide_what_is_below_it_from_above(bedroom, layout, studios, renderer):
    studio = studios(renderer)
    without = Studio(bedroom, Layout({n: p for n, p in layout.items() if n != "ceiling_lamp-0"}), renderer=renderer)
    camera = studio.camera("top", (240, 240))
    buffers, bare = studio.buffers(camera), without.buffers(camera).color.astype(int)
    lamp = buffers.ids == 8
    assert lamp.sum() > 30, "a machine still finds the lamp"
    change = np.abs(buffers.color.astype(int) - bare).max(axis=2)[lamp].mean()
    assert 2 < change < 60, "it is seen, and what is below it too"


@needs_egl
def test_the_layers_of_a_rug_do_not_fight_in_a_hall():
    room = Room(((0, 0), (60, 0), (60, 60), (0, 60)), 3.0)
    scene = Scene(room, (Asset("rug-0", "rug", (8.0, 12.0, 0.01)),))
    layout = Layout({"rug-0": Pose(30, 30, 0.005, 0)})
    fast, slow = (
        np.asarray(Studio(scene, layout, renderer=r).view("top", size=400), dtype=int)[150:250, 150:250]
        for r in ("gl", "rays")
    )
    assert (np.abs(fast - slow).max(axis=2) > 24).mean() < 0.02


def test_a_close_up_looks_around_what_stands_before(bedroom, layout):
    def seen(poses):
        studio = Studio(bedroom, Layout(poses), renderer="rays")
        buffers = studio.buffers(studio.camera("night_stand-0", (96, 96)))
        return (buffers.ids == buffers.names.index("night_stand-0")).mean(), buffers.camera

    stand = layout["night_stand-0"]
    free, usual = seen({"night_stand-0": stand})
    c, s = math.cos(stand.yaw - math.radians(30)), math.sin(stand.yaw - math.radians(30))
    before = Pose(stand.x + 1.2 * c, stand.y + 1.2 * s, 1.05, stand.yaw - math.radians(30))
    moved, chosen = seen({"night_stand-0": stand, "wardrobe-0": before})
    assert free > 0.08 and moved > 0.8 * free
    assert chosen.position != usual.position


@both
def test_an_asset_alone_is_seen_from_its_front(bedroom, renderer):
    image = np.asarray(render_asset(bedroom.by_name["wardrobe-0"], size=96, renderer=renderer), dtype=int)
    assert image[:4].mean() > 225
    assert np.abs(image[48, 48] - image[2, 2]).max() > 20 or image.std() > 10


@both
def test_light_and_shade_of_two_boxes(golden, renderer):
    mesh = parts_mesh(
        [_box((-1, -1, -0.02), (1, 1, 0), (0.8, 0.75, 0.7)), _box((-0.4, -0.3, 0), (0.1, 0.3, 0.6), (0.2, 0.4, 0.7))],
        "boxes",
    )
    points = np.array([(a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (0, 0.6)], dtype=float)
    camera = fitted_camera(points, math.radians(50), math.radians(-60), (160, 120))
    drawn = make_renderer(mesh, mesh.opaque, mesh.opaque, renderer)
    from PIL import Image

    image = Image.fromarray(drawn.color(camera, np.ones(len(mesh.names), bool)))
    golden(image, "view-boxes-160x120", mean=2.5, share=0.03)


def _box(low, high, color):
    (a, b, c), (d, e, f) = low, high
    vertices = np.array([(x, y, z) for z in (c, f) for x, y in ((a, b), (d, b), (d, e), (a, e))], dtype=float)
    faces = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7)]
    faces += [t for i in range(4) for j in [(i + 1) % 4] for t in ((i, j, j + 4), (i, j + 4, i + 4))]
    return Part("box", vertices, np.array(faces, dtype=np.int32), Material("paint", color))
