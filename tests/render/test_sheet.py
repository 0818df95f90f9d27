"""The sheet to print: true to scale, within its paper, nothing on top of anything else, its list fitting its drawing."""

from __future__ import annotations

import math
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from itertools import combinations

import pytest
import shapely
from PIL import Image

from robolayout.page.marks import sheet_marks, sheet_notes
from robolayout.render import PlanMarks, SheetNotes, draw_sheet
from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene
from robolayout.verify import verify
from running import slow

SIZES = {(210.0, 297.0), (297.0, 210.0), (297.0, 420.0), (420.0, 297.0)}
STANDARD = {20, 25, 50, 100, 200, 500, 1000, 2000, 5000}
FLOOR = "#fbfaf7"
WHEELS = Agent("wheels", 0.46, 1.35, title="wheelchair user", turning_diameter=1.52)


def furnished(
    room: Room, rows: list[tuple[str, float, float, float, float]], name: str = "room"
) -> tuple[Scene, Layout]:
    """Return a scene of things (category, depth, width, x, y) and their layout, all 0.8 m high."""
    assets = tuple(Asset(f"thing-{k}", row[0], (row[1], row[2], 0.8)) for k, row in enumerate(rows))
    layout = Layout({f"thing-{k}": Pose(row[3], row[4], 0.4, 0.0) for k, row in enumerate(rows)})
    return Scene(room, assets, agents=(WHEELS,), name=name, task_description="What the room is for. " * 12), layout


LONG = Room(
    ((0, 0), (22, 0), (22, 3), (0, 3)),
    2.6,
    doors=(Opening(3, 1.0, 0.9, 2.05), Opening(1, 1.1, 1.5, 2.05)),
    windows=tuple(Opening(2, 1 + 3 * k, 1.5, 1.2, 0.9) for k in range(6)),
)
L_SHAPED = Room(
    ((0, 0), (6.4, 0), (6.4, 3.2), (3.4, 3.2), (3.4, 6), (0, 6)),
    2.6,
    doors=(Opening(1, 0.35, 0.95, 2.05),),
    windows=(Opening(0, 0.8, 1.8, 1.4, 0.85), Opening(4, 0.7, 1.5, 1.3, 0.85)),
)
SQUARE = Room(((0, 0), (4.6, 0), (4.6, 4.8), (0, 4.8)), 2.6, doors=(Opening(1, 3.8, 0.9, 2.05),))
SKEW = Room(((0, 0), (5, 0), (6, 3), (3, 5.5), (0, 4)), 2.6, doors=(Opening(0, 0.3, 0.9, 2.05),))
DOORS_OUT = Room(
    ((0, 0), (6, 0), (6, 4.5), (0, 4.5)),
    2.6,
    doors=(
        Opening(0, 0.5, 1.0, 2.05),
        Opening(0, 4.0, 0.9, 2.05, hinge="right"),
        Opening(1, 1.0, 0.9, 2.05, swing="in"),
        Opening(3, 1.0, 1.8, 2.05),
    ),
    windows=(Opening(2, 2.2, 1.5, 1.2, 0.9),),
)
UNICODE = ["桌子", "Donaudampfschifffahrtsgesellschaftskapitänsmützenablage" * 2, "письменный стол", "x</text><b>&"]

ROOMS = {
    "long": furnished(LONG, [("desk", 0.7, 1.4, 0.5 + 1.7 * k, 0.8) for k in range(12)]),
    "L-shaped": furnished(L_SHAPED, [("sofa", 0.9, 2.0, 0.5, 4.9), ("wardrobe", 0.6, 1.2, 5.6, 2.4)]),
    "forty things": furnished(
        SQUARE,
        [
            (f"kind {k % 9} of thing with a name", 0.35 + 0.001 * k, 0.35, 0.3 + 0.55 * (k % 8), 0.5 + 0.8 * (k // 8))
            for k in range(40)
        ],
    ),
    "long Unicode names": furnished(SQUARE, [(name, 0.8, 1.2, 1.0, 0.7 + 1.1 * k) for k, name in enumerate(UNICODE)]),
    "no right angle": furnished(SKEW, [("sofa", 0.9, 2.0, 3.0, 3.0)]),
    "doors out": furnished(DOORS_OUT, [("sofa", 0.9, 2.0, 2.5, 2.2)]),
    "tiny": furnished(Room(((0, 0), (1.6, 0), (1.6, 2.2), (0, 2.2)), 2.6), [("toilet", 0.7, 0.4, 0.8, 1.8)]),
    "vast": furnished(Room(((0, 0), (500, 0), (500, 500), (0, 500)), 9), [("rack", 20.0, 30.0, 60.0, 60.0)]),
    "empty": (Scene(SQUARE, (), agents=(WHEELS,), name="empty"), Layout({})),
}


@dataclass(frozen=True)
class Words:
    """A text on the sheet and the box that it takes, millimetres."""

    text: str
    box: shapely.Polygon


def printed(case: str, date: str = "") -> ElementTree.Element:
    """Return the sheet of a case as parsed SVG."""
    scene, layout = ROOMS[case]
    report = verify(scene, layout) if case != "vast" else None
    notes = sheet_notes(report, date) if report else SheetNotes(date)
    marks = sheet_marks(report.agents[0]) if report else PlanMarks()
    return ElementTree.fromstring(draw_sheet(scene, layout, notes, marks=marks, agent=WHEELS).svg())


def texts(svg: ElementTree.Element) -> list[Words]:
    """Return all texts; a text of three letters or more says how long it is."""
    found: list[Words] = []
    for node in svg.iter("{http://www.w3.org/2000/svg}text"):
        x, y, size = (float(node.get(key)) for key in ("x", "y", "font-size"))
        length = float(node.get("textLength", 0.62 * size * len(node.text or "")))
        left = {"start": 0.0, "middle": -length / 2, "end": -length}[node.get("text-anchor", "start")]
        box = shapely.box(x + left, y - 0.36 * size, x + left + length, y + 0.36 * size)
        turn = re.match(r"rotate\((\S+) ", node.get("transform", ""))
        box = shapely.affinity.rotate(box, float(turn[1]), origin=(x, y)) if turn else box
        found.append(Words(node.text or "", box))
    return found


def outline(svg: ElementTree.Element, fill: str) -> list[list[tuple[float, float]]]:
    """Return the corners of every path of a colour."""
    paths = [node.get("d", "") for node in svg.iter() if node.get("fill") == fill]
    return [[(float(a), float(b)) for a, b in re.findall(r"[ML]([\d.-]+) ([\d.-]+)", path)] for path in paths]


def scale_of(svg: ElementTree.Element) -> int:
    return next(int(found[1]) for words in texts(svg) if (found := re.fullmatch(r"1 : (\d+)", words.text)))


@pytest.mark.parametrize("case", ROOMS)
def test_a_millimetre_on_paper_is_what_the_scale_says(case):
    svg = printed(case)
    width, height = (float(svg.get(key).removesuffix("mm")) for key in ("width", "height"))
    assert (width, height) in SIZES
    assert svg.get("viewBox") == f"0 0 {width:g} {height:g}"
    scale = scale_of(svg)
    assert scale in STANDARD
    (floor,) = outline(svg, FLOOR)
    for corner, (a, b) in zip(
        ROOMS[case][0].room.vertices, zip(floor, floor[1:] + floor[:1], strict=True), strict=True
    ):
        following = ROOMS[case][0].room.vertices[(ROOMS[case][0].room.vertices.index(corner) + 1) % len(floor)]
        assert math.dist(a, b) * scale / 1000 == pytest.approx(math.dist(corner, following), abs=0.002 * scale / 1000)


@pytest.mark.parametrize("case", ROOMS)
def test_nothing_leaves_the_frame_and_no_text_lies_on_another(case):
    svg = printed(case, "22 November 2026")
    width, height = (float(svg.get(key).removesuffix("mm")) for key in ("width", "height"))
    frame = shapely.box(8, 8, width - 8, height - 8)
    found = texts(svg)
    for words in found:
        assert frame.covers(words.box), f"{words.text!r} runs out of the frame"
    for a, b in combinations(found, 2):
        assert a.box.intersection(b.box).area < 0.02, f"{a.text!r} lies on {b.text!r}"


@pytest.mark.parametrize(
    "case", ["long", "L-shaped", slow("forty things"), "long Unicode names", "no right angle", "tiny"]
)
def test_every_number_of_the_list_is_on_its_thing(case):
    scene, layout = ROOMS[case]
    svg = printed(case)
    (floor,), scale = outline(svg, FLOOR), scale_of(svg)
    x0, y0 = scene.room.vertices[0]
    k = 1000 / scale
    groups: dict[tuple[str, tuple[float, ...]], list[Asset]] = {}
    for asset in scene.assets:
        groups.setdefault((asset.category, asset.size), []).append(asset)
    for number, asset in enumerate((asset for group in groups.values() for asset in group), 1):
        corners = layout[asset.name].corners(asset.size)
        footprint = shapely.Polygon([(floor[0][0] + (x - x0) * k, floor[0][1] - (y - y0) * k) for x, y in corners])
        written = [w for w in texts(svg) if re.match(rf"{number}( |$)", w.text)]
        assert any(footprint.distance(w.box) < 4.1 for w in written), f"{number} is not at {asset.name}"
    listed = " ".join(words.text for words in texts(svg))
    cm = f"{100 * scene.assets[0].size[1]:.0f} x {100 * scene.assets[0].size[0]:.0f} x 80"
    assert cm in listed


@pytest.mark.parametrize("case", ["long", "L-shaped", "no right angle", "doors out"])
def test_walls_doors_and_windows_have_their_lengths(case):
    room = ROOMS[case][0].room
    written = [words.text for words in texts(printed(case))]
    for opening in (*room.doors, *room.windows):
        assert f"{opening.width:.2f}" in written
        assert any(text.startswith(f"{opening.width:.2f} x {opening.height:.2f}") for text in written)
    for wall in room.walls:
        assert f"{wall.length:.2f}" in written


def test_things_on_a_table_are_listed_with_it_and_have_no_number():
    assets = (
        Asset("table-0", "table", (0.8, 1.6, 0.75)),
        Asset("tray-0", "tray", (0.3, 0.4, 0.03), on_floor=False, on_object=True),
        Asset("cup-0", "cup", (0.08, 0.08, 0.1), on_floor=False, on_object=True),
        Asset("cup-1", "cup", (0.08, 0.08, 0.1), on_floor=False, on_object=True),
        Asset("stool-0", "stool", (0.4, 0.4, 0.45)),
    )
    layout = Layout(
        {
            "table-0": Pose(2, 2, 0.375, 0),
            "tray-0": Pose(2, 2, 0.765, 0),
            "cup-0": Pose(2, 2, 0.83, 0),
            "cup-1": Pose(2, 2.5, 0.80, 0),
        }
    )
    scene = Scene(SQUARE, assets, agents=(WHEELS,), name="room")
    notes = SheetNotes(carriers={"tray-0": "table-0", "cup-0": "tray-0", "cup-1": "table-0"})
    svg = ElementTree.fromstring(draw_sheet(scene, layout, notes, marks=PlanMarks(), agent=WHEELS).svg())
    written = [words.text for words in texts(svg)]
    assert "1 table" in written
    assert {"tray, on 1", "2 x cup, on 1", "stool, not placed"} <= set(written)
    assert {"40 x 30 x 3", "8 x 8 x 10"} <= set(written), "centimetres: width, depth, height"


def test_a_covered_thing_among_others_keeps_its_number():
    size = (0.5, 0.5, 0.7)
    tables = {f"table-{k}": Pose(1.0 + 0.5 * (k % 3), 1.0 + 0.5 * (k // 3), 0.35, 0.0) for k in range(9)}
    trays = {f"tray-{k}": Pose(p.x, p.y, 0.72, 0.0) for k, p in enumerate(tables.values())}
    assets = [Asset(name, "table", size) for name in tables]
    assets += [Asset(name, "tray", (0.48, 0.48, 0.04), on_floor=False, on_object=True) for name in trays]
    scene = Scene(SQUARE, tuple(assets), agents=(WHEELS,), name="room")
    layout = Layout(tables | trays)
    notes = SheetNotes(carriers=dict(zip(trays, tables, strict=True)))
    svg = ElementTree.fromstring(draw_sheet(scene, layout, notes, marks=PlanMarks(), agent=WHEELS).svg())
    written = {words.text.split()[0] for words in texts(svg) if words.text}
    assert {str(number) for number in range(1, 10)} <= written


def test_findings_speak_of_the_numbers_on_the_drawing():
    assets = (Asset("sofa-1", "sofa", (0.9, 2.0, 0.8)), Asset("sofa-10", "big sofa", (0.9, 2.2, 0.8)))
    scene = Scene(SQUARE, assets, agents=(WHEELS,), name="room")
    layout = Layout({"sofa-1": Pose(1, 1.2, 0.4, 0), "sofa-10": Pose(3, 3, 0.4, 0)})
    notes = SheetNotes(verdict="not all demands are met", findings=("sofa-10 and sofa-1 block door 0 beside wall 2.",))
    svg = ElementTree.fromstring(draw_sheet(scene, layout, notes, marks=PlanMarks(), agent=WHEELS).svg())
    written = [words.text for words in texts(svg)]
    assert "Findings: not all demands are met" in written
    assert "big sofa (2) and sofa (1) block door D1 beside wall 2." in written
    assert "wall 2" in written and "D1" in written, "what a finding speaks of is named on the drawing"


def test_what_no_layout_can_do_is_said_once():
    box = Asset("box", "box", (0.5, 0.5, 0.5))
    scene = Scene(SQUARE, (box,), agents=(Agent("tank", 0.6, 1.5),), name="room")
    findings = sheet_notes(verify(scene, Layout({"box": Pose(2, 2, 0.25, 0)}))).findings
    assert "Door 0 is 0.90 m wide, tank needs 1.20 m: it cannot come in." in findings
    assert len(findings) == len(set(findings))


def test_names_of_rules_are_no_names_of_things():
    scene = Scene(SQUARE, (Asset("bed", "bed", (2.0, 1.6, 0.5)),), agents=(WHEELS,), name="room")
    notes = SheetNotes(rules=(("bed transfer", "bed has it on 2 of 2 sides", True),))
    layout = Layout({"bed": Pose(2, 2, 0.25, 0)})
    svg = ElementTree.fromstring(draw_sheet(scene, layout, notes, marks=PlanMarks(), agent=WHEELS).svg())
    assert "bed transfer: bed (1) has it on 2 of 2 sides" in [words.text for words in texts(svg)]


@pytest.mark.slow
def test_a_list_that_finds_no_place_says_how_much_is_missing():
    rows = [(f"kind {k}", 0.2 + 0.0001 * k, 0.2, 0.2 + 0.3 * (k % 30), 0.2 + 0.3 * (k // 30)) for k in range(600)]
    scene, layout = furnished(Room(((0, 0), (10, 0), (10, 10), (0, 10)), 3), rows)
    svg = ElementTree.fromstring(draw_sheet(scene, layout, SheetNotes(), marks=PlanMarks(), agent=WHEELS).svg())
    assert any(re.fullmatch(r"\.\.\. and \d+ more lines, .*", words.text) for words in texts(svg))


def test_the_date_is_the_users_and_nobody_elses():
    assert "Date" in [words.text for words in texts(printed("tiny", "22 November 2026"))]
    assert "Date" not in [words.text for words in texts(printed("tiny"))]


def page_of(case: str) -> bytes:
    scene, layout = ROOMS[case]
    report = verify(scene, layout)
    return draw_sheet(scene, layout, sheet_notes(report), marks=sheet_marks(report.agents[0]), agent=WHEELS).pdf()


def test_the_same_room_gives_the_same_bytes():
    assert page_of("L-shaped") == page_of("L-shaped")


@pytest.mark.skipif(shutil.which("pdftoppm") is None, reason="needs pdftoppm: apt-get install poppler-utils")
@pytest.mark.parametrize("case", ["L-shaped", "long Unicode names"])
def test_a_pdf_reader_shows_the_page_at_its_true_size(case, tmp_path):
    file = tmp_path / "sheet.pdf"
    file.write_bytes(page_of(case))
    subprocess.run(["pdftoppm", "-r", "100", "-png", "-singlefile", file, tmp_path / "page"], check=True)
    page = Image.open(tmp_path / "page.png").convert("RGB")
    scene, _ = ROOMS[case]
    svg = printed(case)
    (floor,), width = outline(svg, FLOOR), float(svg.get("width").removesuffix("mm"))
    assert page.width == pytest.approx(width / 25.4 * 100, abs=1.1)
    for (ax, ay), (bx, by), wall in zip(floor, floor[1:] + floor[:1], scene.room.walls, strict=True):
        bare = 0.15 / wall.length  # no room has an opening so near to the start of a wall
        x, y = ax + bare * (bx - ax), ay + bare * (by - ay)
        nx, ny = wall.normal
        outside = page.getpixel((round((x - nx) / 25.4 * 100), round((y + ny) / 25.4 * 100)))
        assert max(outside) < 120, f"the section of wall {wall.index} begins where the floor ends"
    words = subprocess.run(["pdftotext", file, "-"], check=True, capture_output=True).stdout.decode()
    assert "wheelchair user" in words and scene.assets[-1].category.split("<")[0] in words
