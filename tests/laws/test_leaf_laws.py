"""A door hangs alike everywhere: in pictures and exports in space, on every plan, in DXF."""

from __future__ import annotations

import io
import math
from itertools import product

import ezdxf
import numpy as np
import pytest
import shapely

from robolayout.assets import Joint, room_parts, turned
from robolayout.assets.rooms import SHELL
from robolayout.export import EXPORTERS, Options
from robolayout.render import PlanMarks, SheetNotes, draw_plan, draw_sheet
from robolayout.render._drawing import Drawing, Shape, Text, text_width
from robolayout.render._model_plan import _sheet
from robolayout.render._style import FILM, PLAN
from robolayout.render.animation import FrameSheet
from robolayout.render.contents import swings
from robolayout.render.palette import FLOOR, PAPER
from robolayout.scene import DEFAULT_AGENT, Layout, Opening, Point, Room, Scene

SKEW = ((0.0, 0.0), (5.0, 0.0), (6.0, 3.0), (3.0, 5.5), (0.0, 4.0))
WAYS = list(product(("left", "right"), ("in", "out"), (0.9, 1.4, 1.8), (False, True), (0, 2)))


def room(hinge: str, swing: str, width: float, wall: int, *, stands_open: bool = False) -> Room:
    """Return a room with no right angle and a door nearer to its wall's start."""
    return Room(SKEW, 2.6, (Opening(wall, 0.4, width, 2.05, hinge=hinge, swing=swing, open=stands_open),))


def middle(a: Point, b: Point) -> Point:
    return ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)


@pytest.mark.parametrize(("hinge", "swing", "width", "stands_open", "wall"), WAYS)
def test_the_leaf_of_a_plan_is_that_of_the_pictures(
    hinge: str, swing: str, width: float, stands_open: bool, wall: int
) -> None:
    given = room(hinge, swing, width, wall, stands_open=stands_open)
    joints: dict[Joint, list[np.ndarray]] = {}
    for part in room_parts(given):
        if part.joint is not None:
            joints.setdefault(part.joint, []).append(part.vertices)
    lines = swings(given)
    assert len(lines) == len(joints) == (2 if width == 1.8 else 1)
    for (at, tip, *_, latch), (joint, (board, *_)) in zip(lines, joints.items(), strict=True):
        assert math.dist(at, joint.at[:2]) < PLAN.wall
        for end, far in ((latch, joint.span[0]), (tip, joint.span[1])):
            seen = turned(joint, board, far)[:, :2].mean(axis=0)
            assert math.dist(middle(at, end), seen) < PLAN.wall + SHELL.frame, "shut and open"
        assert shapely.Polygon(SKEW).distance(shapely.Point(middle(at, tip))) > 0.1 or swing == "in"


@pytest.mark.parametrize(("hinge", "swing", "width", "stands_open", "wall"), [way for way in WAYS if not way[3]])
def test_the_leaf_of_a_drawing_program_is_that_of_a_plan(
    hinge: str, swing: str, width: float, stands_open: bool, wall: int
) -> None:
    given = room(hinge, swing, width, wall)
    data = EXPORTERS["dxf"].write(Scene(given, ()), Layout({}), Options()).decode("ascii").replace("\r\n", "\n")
    space = ezdxf.read(io.StringIO(data)).modelspace()
    arcs, boards = space.query("ARC"), space.query('POLYLINE[layer=="DOORS"]')
    for (at, tip, *_, latch), arc, board in zip(swings(given), arcs, boards, strict=True):
        ends = sorted((tuple(arc.start_point)[:2], tuple(arc.end_point)[:2]))
        far = [tuple(vertex.dxf.location)[:2] for vertex in board.vertices]
        found = [tuple(arc.dxf.center)[:2], *ends, *far]
        assert (arc.dxf.end_angle - arc.dxf.start_angle) % 360.0 == pytest.approx(90.0)
        for a, b in zip(found, (at, *sorted((tip, latch)), at, tip), strict=True):
            assert math.dist(a, b) < 0.03, "walls are 2 cm thinner there"


def drawings(scene: Scene) -> dict[str, Drawing]:
    layout, marks = Layout({}), PlanMarks()
    return {
        "plan": draw_plan(scene, layout, title="a room"),
        "sheet": draw_sheet(scene, layout, SheetNotes(), marks=marks, agent=DEFAULT_AGENT),
        "model": _sheet(scene, layout, marks, None),
        "film": FrameSheet(scene.room, FILM.foot).sheet,
    }


@pytest.mark.parametrize("kind", ["plan", "sheet", "model", "film"])
@pytest.mark.parametrize(("swing", "width"), [*product(("in", "out"), (0.9, 1.8))])
def test_a_leaf_is_on_its_side_of_the_wall_and_on_the_paper(kind: str, swing: str, width: float) -> None:
    for floor, wall in ((SKEW, 3), (((0, 0), (4, 0), (4, 3), (0, 3)), 0), (((0, 0), (30, 0), (30, 4), (0, 4)), 1)):
        door = Opening(wall, 0.6, width, 2.05, swing=swing)
        sheet = drawings(Scene(Room(floor, 2.6, (door,)), ()))[kind]
        shapes = [item for item in sheet.items if isinstance(item, Shape)]
        (ground,) = (shapely.Polygon(item.rings[0]) for item in shapes if item.fill == FLOOR)
        leaves = [shapely.Polygon(item.rings[0]) for item in shapes if item.fill == PAPER and item.width == 0.16]
        paper = shapely.box(2.0, 2.0, sheet.width - 2.0, sheet.height - 2.0)
        assert len(leaves) == door.leaves
        for leaf in leaves:
            assert paper.covers(leaf)
            inside = leaf.intersection(ground).area / leaf.area
            assert inside == pytest.approx(1.0 if swing == "in" else 0.0, abs=1e-6)


@pytest.mark.parametrize("width", [0.9, 1.8])
@pytest.mark.parametrize("wall", range(4))
def test_no_length_and_no_name_of_a_sheet_lies_on_a_leaf_or_its_swing(wall: int, width: float) -> None:
    doors = (Opening(wall, 0.2, width, 2.05), Opening(wall, 2.6, 0.8, 2.05, hinge="right"))
    scene = Scene(Room(((0, 0), (4.6, 0), (4.6, 4.8), (0, 4.8)), 2.6, doors), ())
    items = drawings(scene)["sheet"].items
    swept = [
        shapely.LineString(ring)
        for item in items
        if isinstance(item, Shape) and (len(item.rings[0]) == 17 or item.width == 0.16)
        for ring in item.rings
    ]
    assert len(swept) == 2 * sum(door.leaves for door in doors)
    for text in (item for item in items if isinstance(item, Text)):
        half, high = text_width(text.text, text.size) / 2, 0.36 * text.size
        box = shapely.affinity.rotate(shapely.box(-half, -high, half, high), -text.angle, origin=(0, 0))
        box = shapely.affinity.translate(box, *text.at)
        assert text.anchor != "middle" or not any(line.intersects(box) for line in swept), text.text
