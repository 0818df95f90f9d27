"""DXF, opened with an independent reader."""

from __future__ import annotations

import io
import math

import ezdxf
import pytest
from ezdxf.document import Drawing

from robolayout.export import EXPORTERS, Options
from robolayout.scene import Asset, Layout, Pose, Room, Scene


def opened(data: bytes) -> Drawing:
    return ezdxf.read(io.StringIO(data.decode("ascii").replace("\r\n", "\n")))


@pytest.fixture(scope="module")
def plan(scene: Scene, layout: Layout) -> Drawing:
    options = Options(routes={"wardrobe-0": [(4.0, 0.5), (4.0, 2.0)], "rug-0": [(1.0, 1.0)]})
    return opened(EXPORTERS["dxf"].write(scene, layout, options))


def test_it_is_sound_metric_and_release_12(plan: Drawing) -> None:
    audit = plan.audit()
    assert (audit.errors, audit.fixes) == ([], [])
    assert plan.dxfversion == "AC1009"
    assert plan.units == 6


def test_each_asset_is_a_block_of_its_size_at_its_pose(plan: Drawing, scene: Scene, layout: Layout) -> None:
    inserts = {insert.get_xdata("ROBOLAYOUT")[0].value: insert for insert in plan.modelspace().query("INSERT")}
    assert set(inserts) == set(layout)
    for name, insert in inserts.items():
        assert tuple(insert.dxf.insert)[:2] == pytest.approx((layout[name].x, layout[name].y))
        assert math.cos(math.radians(insert.dxf.rotation) - layout[name].yaw) == pytest.approx(1)
        footprint = next(iter(plan.blocks[insert.dxf.name].query("POLYLINE")))
        xs, ys = zip(*[tuple(vertex.dxf.location)[:2] for vertex in footprint.vertices], strict=True)
        assert (max(xs) - min(xs), max(ys) - min(ys)) == pytest.approx(scene.by_name[name].size[:2])


def test_walls_leave_gaps_for_openings_and_meet_at_corners(plan: Drawing, scene: Scene) -> None:
    outlines = [
        [tuple(v.dxf.location)[:2] for v in p.vertices] for p in plan.modelspace().query('POLYLINE[layer=="WALLS"]')
    ]
    assert len(outlines) == len(scene.room.walls) + 3
    south = [outline for outline in outlines if outline[0][1] == outline[1][1] == 0.0]
    assert [(round(o[0][0], 6), round(o[1][0], 6)) for o in south] == [(0.0, 1.0), (2.2, 3.6), (4.5, 5.0)]
    outer = {corner for outline in outlines for corner in outline[2:]}
    assert any(corner == pytest.approx((-0.1, -0.1)) for corner in outer)
    assert any(corner == pytest.approx((2.9, 3.6)) for corner in outer)


def test_the_door_hangs_left_and_swings_out(plan: Drawing) -> None:
    (arc,) = plan.modelspace().query("ARC")
    assert (arc.dxf.radius, arc.dxf.start_angle, arc.dxf.end_angle) == (0.9, 180.0, 270.0)
    assert tuple(arc.dxf.center)[:2] == (4.5, -0.1)
    assert plan.header["$EXTMIN"][1] < -1.0, "its leaf is on the drawing"


def test_names_are_never_upside_down_and_routes_are_lines(plan: Drawing, layout: Layout) -> None:
    names = plan.modelspace().query("TEXT")
    assert {text.dxf.text for text in names} == set(layout)
    assert all(-90.001 <= text.dxf.rotation <= 90.001 for text in names)
    assert len(plan.modelspace().query('POLYLINE[layer=="ROUTES"]')) == 1


def test_layers_tell_kinds_apart(plan: Drawing) -> None:
    layers = {i.get_xdata("ROBOLAYOUT")[0].value: i.dxf.layer for i in plan.modelspace().query("INSERT")}
    assert layers["rug-0"] == "RUGS"
    assert layers["table_lamp-0"] == "TOPS"
    assert layers["picture-0"] == "WALL_MOUNTED"
    assert layers["ceiling_lamp-0"] == "CEILING"
    assert layers["double_bed-0"] == "FURNITURE"


def test_a_name_with_line_breaks_or_letters_beyond_ascii_does_no_harm() -> None:
    room = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5)
    names = ["möbel-0", "a\n0\nEOF-1", "日本-2"]
    scene = Scene(room, tuple(Asset(name, "chair", (0.5, 0.5, 0.9)) for name in names))
    data = EXPORTERS["dxf"].write(scene, Layout({name: Pose(1, 1, 0.45, 0) for name in names}), Options())
    assert opened(data).audit().errors == []
    assert {"möbel-0", "日本-2", "a 0 EOF-1"} == set(EXPORTERS["dxf"].read(data).layout)
