"""The plan: to scale, complete, harmless, the same in all its forms."""

import re
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

from robolayout._errors import InputError
from robolayout.render import PlanMarks, draw_comparison, draw_plan, plan_svg
from robolayout.render._drawing import Drawing, Shape, Text
from robolayout.render._labels import Tag, place_labels
from robolayout.render._marked import passage_spots
from robolayout.render.palette import BLOCKED, FREE, NARROW, ROUTE, TIGHT
from robolayout.render.plan import plan_scale
from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene

SVG = "{http://www.w3.org/2000/svg}"


def shapes(drawing, **style):
    found = [item for item in drawing.items if isinstance(item, Shape)]
    return [s for s in found if all(getattr(s, name) == value for name, value in style.items())]


def words(drawing):
    return [item.text for item in drawing.items if isinstance(item, Text)]


def test_footprints_are_to_scale_and_in_place(bedroom, layout):
    drawing = draw_plan(bedroom, layout, scale=50)
    bed, night_stand = (shapes(drawing, title=name)[0].rings[0] for name in ("bed-0", "night_stand-0"))
    assert np.ptp(np.array(bed), axis=0) == pytest.approx((2.1 * 20, 1.6 * 20))
    step = np.mean(bed, axis=0) - np.mean(night_stand, axis=0)
    assert step == pytest.approx(((1.1 - 0.25) * 20, -(3.0 - 1.9) * 20))


def test_svg_is_well_formed_and_measured_in_millimetres(bedroom, layout, marks):
    root = ElementTree.fromstring(plan_svg(bedroom, layout, navigation=marks, agent=bedroom.agent, title="Bedroom"))
    width, height = float(root.get("width")[:-2]), float(root.get("height")[:-2])
    assert root.get("width").endswith("mm") and root.get("viewBox") == f"0 0 {width:g} {height:g}"
    assert width > 4.0 * 20
    titles = {element.text for element in root.iter(f"{SVG}title")}
    assert titles == set(layout)
    assert "Bedroom" in {element.text for element in root.iter(f"{SVG}text")}


def test_names_scale_and_agent_are_written(bedroom, layout, marks):
    texts = words(draw_plan(bedroom, layout, navigation=marks, agent=bedroom.agent))
    assert {"bed", "wardrobe", "1 : 50", "adult with a walker", "1.23 m", "out of reach", "cut off"} <= set(texts)
    joined = " ".join(texts)
    assert "night stand 0" in joined or "stand 0" in joined


@pytest.mark.parametrize(("side", "scale"), [(2.0, 25), (5.0, 50), (15.0, 100), (30.0, 200), (80.0, 500)])
def test_the_scale_fits_the_sheet(side, scale):
    assert plan_scale(Scene(Room(((0, 0), (side, 0), (side, side), (0, side)), 2.6), ())) == scale


def test_marks_have_their_colours(bedroom, layout, marks):
    drawing = draw_plan(bedroom, layout, navigation=marks, agent=bedroom.agent)
    free = shapes(drawing, fill=FREE)[0]
    assert len(free.rings) == 2
    assert len(shapes(drawing, stroke=ROUTE, closed=False)) >= 2
    assert shapes(drawing, stroke=NARROW) and shapes(drawing, stroke=BLOCKED)
    assert shapes(drawing, title="night_stand-1")[0].stroke == BLOCKED
    tight = draw_plan(bedroom, layout, navigation=marks, agent=Agent("wide", 0.7, 1.5))
    assert "1.23 m" in [t.text for t in tight.items if isinstance(t, Text) and t.color == TIGHT]


def test_walls_leave_gaps_for_doors_and_windows(bedroom):
    from robolayout.render.palette import WALL

    drawing = draw_plan(bedroom, Layout({}), scale=50)
    solid = shapely.union_all([shapely.Polygon(s.rings[0], s.rings[1:]) for s in shapes(drawing, fill=WALL)])
    ring = (4.24 * 5.24 - 4 * 5) - (0.9 + 1.4) * 0.12
    assert solid.area == pytest.approx(ring * 400, rel=0.01)


@pytest.mark.parametrize(
    "title", ['<script>alert("x")</script>', "a & b ]]> c", "tab\there\x00\x1b[31m", "雪の部屋 ☃", "\ud800"]
)
def test_hostile_titles_do_no_harm(bedroom, layout, title):
    svg = plan_svg(bedroom, layout, title=title)
    root = ElementTree.fromstring(svg.encode())
    assert not list(root.iter(f"{SVG}script"))
    assert draw_plan(bedroom, layout, title=title).image(200).width == 200
    assert draw_plan(bedroom, layout, title=title).pdf().startswith(b"%PDF-1.4")


def test_same_bytes_twice(bedroom, layout, marks):
    one, other = (draw_plan(bedroom, layout, navigation=marks) for _ in range(2))
    for suffix in (".svg", ".pdf", ".png"):
        assert one.file(suffix, 200) == other.file(suffix, 200)


def test_order_of_routes_and_poses_does_not_matter(bedroom, layout, marks):
    turned = Layout(dict(reversed(list(layout.poses.items()))))
    routes = dict(reversed(list(marks.routes.items())))
    again = PlanMarks(marks.free, marks.islands, routes, marks.passages, marks.blocked, marks.agent_at)
    assert plan_svg(bedroom, turned, navigation=again) == plan_svg(bedroom, layout, navigation=marks)


def test_plan_looks_as_it_did(bedroom, layout, marks, golden):
    golden(
        draw_plan(bedroom, layout, navigation=marks, agent=bedroom.agent, title="Bedroom").image(420),
        "plan-bedroom-420",
    )


def test_comparison_looks_as_it_did(bedroom, layout, marks, golden):
    image = draw_comparison([("with a walker", bedroom, layout, marks), ("on foot", bedroom, layout, None)]).image(640)
    golden(image, "compare-bedroom-640")


def test_comparison_keeps_one_scale(bedroom, layout):
    big = Scene(Room(((0, 0), (12, 0), (12, 4), (0, 4)), 2.6), ())
    svg = draw_comparison([("small", bedroom, layout, None), ("big", big, Layout({}), None)]).svg()
    assert svg.count("1 : 100") == 2
    with pytest.raises(InputError, match="give at least one"):
        draw_comparison([])


def test_pdf_has_a_sound_table_of_objects(bedroom, layout, marks):
    data = draw_plan(bedroom, layout, navigation=marks, agent=bedroom.agent, title="a (b) \\ ü").pdf()
    start = int(re.search(rb"startxref\n(\d+)", data)[1])
    assert data[start : start + 4] == b"xref"
    offsets = [int(row) for row in re.findall(rb"(\d{10}) 00000 n", data)]
    assert all(data[at:].startswith(b"%d 0 obj" % number) for number, at in enumerate(offsets, start=1))
    length = int(re.search(rb"/Length (\d+)", data)[1])
    body = data.index(b"stream\n") + 7
    assert data[body + length :].startswith(b"\nendstream")
    assert written(data) >= {"a (b) \\ ü", "bed", "wardrobe"}


def test_pdf_writes_what_its_fonts_lack_in_the_readers_own():
    drawing = Drawing(20, 10)
    drawing.words((10, 5), "стол 桌子", 3)
    data = drawing.pdf()
    codes = "桌子".encode("utf-16-be").hex().encode()
    assert written(data) == {"стол "} and b"<" + codes + b"> Tj" in streams(data)[0]
    assert b"/STSong-Light" in data and b"/HYSMyeongJo" not in data


def streams(data):
    """Return the contents of all streams of a PDF."""
    found = re.finditer(rb"/Length (\d+) /Filter /FlateDecode >>\nstream\n", data)
    return [zlib.decompress(data[m.end() : m.end() + int(m[1])]) for m in found]


def written(data):
    """Return all texts of a PDF, decoded by the maps of its own fonts."""
    content = streams(data)[0]
    names = re.findall(rb"/(\w+) (\d+) 0 R", re.search(rb"/Font << (.*?) >>", data)[1])
    objects = dict(re.findall(rb"(\d+) 0 obj\n(.*?)\nendobj", data, re.DOTALL))
    maps = {}
    for name, number in names:
        found = re.search(rb"/ToUnicode (\d+) 0 R", objects[number])
        if found:
            text = streams(objects[found[1]])[0]
            maps[name] = {
                a: bytes.fromhex(b.decode()).decode("utf-16-be") for a, b in re.findall(rb"<(\w{4})> <(\w+)>", text)
            }
    runs = re.findall(rb"/(\w+) [\d.]+ Tf <(\w+)> Tj", content)
    return {"".join(maps[n].get(code[k : k + 4], "?") for k in range(0, len(code), 4)) for n, code in runs if n in maps}


def test_the_three_forms_draw_the_same_lines():
    drawing = Drawing(20, 10)
    drawing.polygon([[(2, 2), (8, 2), (8, 8), (2, 8)], [(4, 4), (6, 4), (6, 6), (4, 6)]], "#ff0000")
    drawing.line([(10, 5), (20, 5)], "#0000ff", width=1.0, dash=(2.0, 2.0))
    image = np.asarray(drawing.image(200))
    assert tuple(image[30, 30]) == (255, 0, 0) and tuple(image[50, 50]) == (255, 255, 255)
    assert tuple(image[50, 110]) == (0, 0, 255) and tuple(image[50, 132]) == (255, 255, 255)
    svg = drawing.svg()
    assert 'fill-rule="evenodd"' in svg and 'stroke-dasharray="2 2"' in svg and "M2 2L8 2L8 8L2 8Z" in svg


boxes = st.tuples(st.floats(5, 95), st.floats(5, 95), st.floats(2, 30), st.floats(2, 30))


@given(st.lists(boxes, min_size=1, max_size=12))
@settings(max_examples=40, deadline=None)
def test_names_never_lie_on_each_other(rows):
    tags = [
        Tag(f"thing {k}", ((x, y), (x + w, y), (x + w, y + h), (x, y + h)), True) for k, (x, y, w, h) in enumerate(rows)
    ]
    labels = place_labels(tags, [tag.outline for tag in tags], (0, 0, 130, 130))
    areas = [shapely.box(*label.box) for label in labels]
    for k, area in enumerate(areas):
        assert not any(area.intersection(other).area > 1e-9 for other in areas[k + 1 :])


def test_a_name_that_fits_nowhere_is_left_out_and_one_that_fits_is_inside():
    small, large = ((0, 0), (1, 0), (1, 1), (0, 1)), ((10, 10), (40, 10), (40, 20), (10, 20))
    labels = place_labels([Tag("tiny thing", small, False), Tag("large", large, True)], [], (0, 0, 50, 50))
    assert [label.lines for label in labels] == [("large",)]
    assert shapely.Polygon(large).contains(shapely.box(*labels[0].box))


def test_what_hangs_from_the_ceiling_is_an_outline_with_its_cord(bedroom, layout):
    title = "ceiling_lamp-0"
    items = draw_plan(bedroom, layout).items
    at = next(k for k, item in enumerate(items) if isinstance(item, Shape) and item.title == title)
    assert items[at].fill is None and items[at].dash is not None
    middle = [sum(values) / 4 for values in zip(*items[at].rings[0], strict=True)]
    for line in items[at + 1 : at + 3]:
        assert not line.closed and [sum(values) / 2 for values in zip(*line.rings[0], strict=True)] == pytest.approx(
            middle
        )


def test_wide_doors_have_two_leaves():
    room = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.6, doors=(Opening(0, 1.0, 1.6, 2.05),))
    one = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.6, doors=(Opening(0, 1.0, 0.9, 2.05),))
    leaves = [len(shapes(draw_plan(Scene(r, ()), Layout({})), fill="#ffffff", width=0.16)) for r in (room, one)]
    assert leaves == [2, 1]


def test_crowded_tables_stay_drawable():
    room = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.6)
    plates = tuple(Asset(f"plate-{k}", "plate", (0.25, 0.25, 0.03), on_floor=False, on_object=True) for k in range(40))
    scene = Scene(room, (Asset("table-0", "dining table", (1.0, 3.0, 0.75)), *plates))
    poses = {f"plate-{k}": Pose(1.7 + 0.3 * (k % 2), 0.6 + 0.07 * k, 0.77, 0) for k in range(40)}
    image = draw_plan(scene, Layout({"table-0": Pose(2, 2, 0.375, 0), **poses})).image(300)
    assert isinstance(image, Image.Image)


def outline(x, y, w, h):
    return ((x, y), (x + w, y), (x + w, y + h), (x, y + h))


def test_a_name_keeps_off_what_hangs_above_and_off_lines_if_it_can():
    lamp = outline(12, 12, 6, 6)
    (label,) = place_labels([Tag("table", outline(0, 0, 30, 30), True, shuns=(lamp,))], [], (0, 0, 60, 60))
    assert not shapely.Polygon(label.corners).intersects(shapely.LinearRing(lamp))
    route = [(0.0, 15.0), (30.0, 15.0)]
    (label,) = place_labels([Tag("rug", outline(0, 0, 30, 30), True)], [], (0, 0, 60, 60), lines=[route])
    assert not shapely.Polygon(label.corners).intersects(shapely.LineString(route))
    assert not label.halo


def test_a_name_that_must_cross_a_line_has_a_light_edge():
    lines = [[(0.0, y / 2), (12.0, y / 2)] for y in range(12)]
    (label,) = place_labels([Tag("rug", outline(0, 0, 12, 6), False)], [], (0, 0, 60, 60), lines=lines)
    assert label.halo


def test_the_width_of_a_passage_is_written_beside_its_line_and_off_the_routes():
    passages = [((0.0, 20.0), (40.0, 20.0), 2.0)]
    routes = [((0.0, 1.1), (2.0, 1.1)), ((0.0, 0.9), (2.0, 0.9))]
    for route, lower in zip(routes, (True, False), strict=True):
        line = [(20 * x, 20 * y) for x, y in route]
        ((x, y),) = passage_spots(passages, [line], [])
        assert abs(y - 20) > 1.0 and (y < 20) is lower
        assert not shapely.box(x - 3, y - 0.9, x + 3, y + 0.9).intersects(shapely.LineString(line))
