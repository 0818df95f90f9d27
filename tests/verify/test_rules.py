"""Named rules of accessibility: each met and not met in rooms whose figures can be worked out on paper."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from shapely import LineString, Polygon
from verify_rooms import DOOR, furnished, on_floor, square, thing

from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene, load_agent
from robolayout.verify import verify
from robolayout.verify.routes import Triangulation
from robolayout.verify.rules import RULES, RuleResult
from robolayout.verify.rules._measures import _narrow

CHAIR_USER = load_agent("wheelchair")
Placed = tuple[Asset, Pose | None]


def judged(room: Room, *placed: Placed, body: Agent = CHAIR_USER) -> dict[str, RuleResult]:
    report = verify(*furnished(room, *placed, agents=(body,)))
    return {result.rule.name: result for result in report.rules}


def wall_with_gap(gap: float, thick: float = 0.4, goal: bool = True) -> list[Placed]:
    """A barrier across the room at y = 2 with a gap at the right wall, and something to reach behind it."""
    shelf, box = thing("shelf-0", (4.0 - gap, thick, 1.8), use_sides=()), thing("box-0", (0.5, 1.0, 0.8))
    barrier = (shelf, on_floor(shelf, (4.0 - gap) / 2, 2.0))
    return [barrier, (box, on_floor(box, 0.3, 3.4))] if goal else [barrier]


@pytest.mark.parametrize(
    ("gap", "thick", "met"),
    [
        (1.0, 0.4, True),
        (0.92, 1.5, True),
        (0.85, 0.4, True),
        (0.85, 0.5, True),
        (0.85, 0.75, False),
        (0.8, 0.1, False),
    ],
)
def test_routes_are_wide_enough_or_narrow_for_a_short_way(gap: float, thick: float, met: bool):
    found = judged(square(), *wall_with_gap(gap, thick))["route_width"]
    assert found.met is met
    assert found.measured.value == pytest.approx(gap, abs=0.015)


@pytest.mark.parametrize(
    ("gap", "deep", "met", "text"),
    [
        (0.83, 0.6, True, "0.83 m just inside door 0, over 0.60 m only"),
        (0.83, 0.65, False, "0.83 m just inside door 0, less than 0.915 m over 0.65 m"),
        (0.81, 0.3, False, "0.81 m just inside door 0"),
        (0.95, 0.65, True, "0.95 m or more to everything"),
    ],
)
def test_what_flanks_the_door_narrows_the_way_in(gap: float, deep: float, met: bool, text: str):
    """The first place at which the disc of a wheelchair can stand lies behind it: no way to anything leads through there."""
    left, right = (thing(f"{side}-0", (deep, 1.2, 2.0), use_sides=()) for side in ("left", "right"))
    box, beside = thing("box-0", (0.5, 1.0, 0.8)), gap / 2 + 0.6
    found = judged(
        square(doors=(Opening(0, 1.6, 0.8, 2.05),)),
        *((one, on_floor(one, 2.0 + side * beside, deep / 2, 90.0)) for one, side in ((left, -1), (right, 1))),
        (box, on_floor(box, 2.0, 3.6)),
    )["route_width"]
    assert (found.met, found.measured.text) == (met, text)


def test_two_narrow_parts_close_together_count_as_one():
    room = Room(((0, 0), (4, 0), (4, 6), (0, 6)), 2.6, (DOOR,))
    box = thing("box-0", (0.5, 1.0, 0.8))
    for apart, met in ((1.5, True), (0.5, False)):
        shelves = [thing(f"shelf-{i}", (3.15, 0.3, 1.8), use_sides=()) for i in range(2)]
        placed = [(s, on_floor(s, 3.15 / 2, y)) for s, y in zip(shelves, (2.0, 2.3 + apart), strict=True)]
        assert judged(room, *placed, (box, on_floor(box, 0.3, 5.4)))["route_width"].met is met


def test_a_way_is_wide_to_what_a_wider_disc_touches():
    """A disc of 0.915 m comes to 0.555 m of the box behind the ledge, and the walker's arm is 0.55 m long."""
    ledge, box = thing("ledge-0", (0.0975, 4.0, 0.5), use_sides=()), thing("box-0", (0.3, 0.5, 0.8))
    placed = ((ledge, on_floor(ledge, 2.0, 3.04875, 90)), (box, on_floor(box, 2.0, 3.2475, 90)))
    found = judged(square(), *placed, body=load_agent("elder_walker"))["route_width"]
    assert (found.met, found.measured.text) == (True, "1.50 m or more to everything")


def test_a_way_that_is_wide_all_along_has_no_narrow_part():
    """Such is the way to what only a slimmer body gets to once a chair is moved: up to the chair it is wide."""
    floor = Polygon(square().vertices)
    way = LineString(((1.0, 1.0), (3.0, 1.0)))
    assert _narrow(way, np.array([floor]), Triangulation(floor), floor.exterior) == []


@pytest.mark.parametrize(
    ("width", "ada", "iso"), [(0.9, True, True), (0.815, True, True), (0.81, False, True), (0.79, False, False)]
)
def test_every_door_is_wide_enough(width: float, ada: bool, iso: bool):
    found = judged(square(doors=(DOOR, Opening(2, 1.0, width, 2.05))))
    assert (found["door_width"].met, found["door_width_iso"].met) == (ada, iso)
    assert found["door_width"].measured.text == (f"door {1 if width < 0.9 else 0} is {width:.2f} m wide")
    assert found["door_width"].to_dict()["verified"] is True
    assert found["door_width_iso"].to_dict()["verified"] is False


@pytest.mark.parametrize(("deep", "met", "iso"), [(1.6, True, True), (1.51, False, True), (1.3, False, False)])
def test_there_is_a_circle_to_turn_in(deep: float, met: bool, iso: bool):
    """A corridor: the widest circle is as wide as the corridor, and a T needs 1.525 m across it."""
    corridor = Room(((0, 0), (5, 0), (5, deep), (0, deep)), 2.6, (DOOR,))
    found = judged(corridor)
    assert (found["turning_space"].met, found["turning_space_iso"].met) == (met, iso)
    assert found["turning_space"].measured.value == pytest.approx(min(deep, 1.525), abs=0.01)


@pytest.mark.parametrize(("branch", "met"), [(0.63, True), (0.5, False)])
def test_a_t_will_do_instead(branch: float, met: bool):
    """A corridor 0.95 m wide with a niche 0.95 m wide on its side, so deep."""
    deep = 0.95 + branch
    niche = ((2.475, 0.95), (2.475, deep), (1.525, deep), (1.525, 0.95))
    room = Room(((0, 0), (4, 0), (4, 0.95), *niche, (0, 0.95)), 2.6, (DOOR,))
    found = judged(room)["turning_space"]
    assert found.met is met
    assert ("T-shaped space in a square" in found.measured.text) is met


@pytest.mark.parametrize(("side", "wide", "met"), [(40.0, 1.2, True), (75.0, 1.2, False), (75.0, 2.0, True)])
def test_long_narrow_routes_need_passing_spaces(side: float, wide: float, met: bool):
    room = Room(((0, 0), (side, 0), (side, wide), (0, wide)), 2.6, (DOOR,))
    box = thing("box-0", (0.3, 0.3, 0.8))
    found = judged(room, (box, on_floor(box, side - 0.3, wide / 2)))["passing_space"]
    assert found.met is met
    assert found.measured.value == pytest.approx(side - 0.3 - 1.45, abs=2.0)


def desk_in_niche(width: float) -> list[Placed]:
    """A box at the back wall between two blocks so far apart."""
    box = thing("box-0", (0.4, 0.5, 0.8), "dresser", use_sides=("front",))
    blocks = [thing(f"block-{i}", (1.6, (4 - width) / 2, 1.0), "dresser", use_sides=()) for i in range(2)]
    middle = (4 - width) / 4
    spots = (middle, 4 - middle)
    return [
        (box, on_floor(box, 2.0, 3.8, 270)),
        *((b, on_floor(b, x, 3.2, 270)) for b, x in zip(blocks, spots, strict=True)),
    ]


@pytest.mark.parametrize(("width", "met"), [(0.9, True), (0.7, False)])
def test_clear_floor_adjoins_what_is_used(width: float, met: bool):
    found = judged(square(), *desk_in_niche(width))["floor_space"]
    assert found.met is met
    assert found.measured.text == ("at the one thing" if met else "none at box-0")


@pytest.mark.parametrize(("x", "sides"), [(2.0, 2), (0.75, 1)])
def test_a_bed_has_clear_floor_along_both_sides(x: float, sides: int):
    bed = thing("bed-0", (2.0, 1.4, 0.6), "bed")
    found = judged(square(), (bed, on_floor(bed, x, 2.9, 270)))["bed_transfer"]
    assert (found.met, found.measured.value) == (sides == 2, sides)
    assert found.measured.text == f"bed-0 has it on {sides} of 2 sides"


@pytest.mark.parametrize(("gap", "met"), [(1.0, True), (0.7, False)])
def test_one_clear_floor_between_two_beds_is_enough(gap: float, met: bool):
    beds = [thing(f"bed-{i}", (2.0, 1.4, 0.6), "bed") for i in range(2)]
    room = Room(((0, 0), (2.8 + gap, 0), (2.8 + gap, 4), (0, 4)), 2.6, (DOOR,))
    placed = [(b, on_floor(b, x, 3.0, 270)) for b, x in zip(beds, (0.7, 2.1 + gap), strict=True)]
    assert judged(room, *placed)["bed_transfer"].met is met


@pytest.mark.parametrize(("bottom", "beyond"), [(1.1, 0.0), (1.4, 0.18)])
def test_what_is_used_is_within_reach_in_height(bottom: float, beyond: float):
    cabinet = thing("cabinet-0", (0.3, 0.6, 0.5), "wall cabinet", on_floor=False, on_wall=True, use_sides=("front",))
    found = judged(square(), (cabinet, on_floor(cabinet, 0.15, 2.0, bottom=bottom)))["reach_range"]
    assert found.met is (beyond == 0.0)
    assert found.measured.value == pytest.approx(beyond)


@pytest.mark.parametrize(
    ("x", "height", "met"), [(0.4, 0.75, True), (0.75, 0.75, False), (0.4, 0.95, False), (0.2, 0.95, True)]
)
def test_reaching_over_a_table_ends(x: float, height: float, met: bool):
    """A cup so far from the nearest edge of a big table."""
    table = thing("table-0", (1.8, 1.8, height), "dining table")
    cup = thing("cup-0", (0.1, 0.1, 0.1), "vase", on_floor=False, on_object=True, use_sides=("front",))
    room = square(6.0)
    pose = on_floor(cup, 3.0 - 0.9 + x + 0.05, 3.0, bottom=height)
    found = judged(room, (table, on_floor(table, 3, 3)), (cup, pose))["reach_over"]
    assert found.met is met
    assert found.measured.value == pytest.approx(x)


@pytest.mark.parametrize(("depth", "met"), [(0.7, True), (0.9, False)])
def test_one_reaches_over_a_table_from_where_one_gets_to(depth: float, met: bool):
    """The cup stands at the back of a table whose back is at a wall, between two shelves: the back edge is no edge to reach over."""
    table = thing("table-0", (depth, 1.4, 0.75), "dining table")
    shelves = [thing(f"shelf-{i}", (depth, 1.0, 1.8), use_sides=()) for i in range(2)]
    cup = thing("cup-0", (0.1, 0.1, 0.1), "vase", on_floor=False, on_object=True, use_sides=("front",))
    flank = [(shelf, on_floor(shelf, depth / 2, y)) for shelf, y in zip(shelves, (1.8, 4.2), strict=True)]
    placed = ((table, on_floor(table, depth / 2, 3.0)), (cup, on_floor(cup, 0.06, 3.0, bottom=0.75)))
    found = judged(square(6.0), *placed, *flank)["reach_over"]
    assert found.met is met
    assert found.measured.value == pytest.approx(depth - 0.11)


@pytest.mark.parametrize(("height", "met"), [(0.75, True), (0.6, False)])
def test_a_table_has_room_for_knees(height: float, met: bool):
    table, chair = (
        thing("table-0", (0.9, 1.6, height), "dining table"),
        thing("chair-0", (0.5, 0.5, 0.9), "dining chair"),
    )
    found = judged(square(), (table, on_floor(table, 2, 2.5)), (chair, on_floor(chair, 1.2, 2.5)))["knee_room"]
    assert found.met is met
    assert "under table-0, by its shape" in found.measured.text


def test_rules_concern_some_bodies_only_and_do_not_change_the_verdict():
    scene, layout = furnished(square(doors=(replace(DOOR, width=0.8),)))
    walker, vacuum = load_agent("elder_walker"), load_agent("robot_vacuum")
    report = verify(scene, layout, agent=[walker, vacuum])
    assert report.ok
    assert {result.agent for result in report.rules} == {"elder_walker"}
    assert {"route_width", "door_width"} & {result.rule.name for result in report.rules}
    assert "reach_range" not in {result.rule.name for result in report.rules}
    assert not next(result for result in report.rules if result.rule.name == "door_width").met
    assert verify(scene, layout, agent=vacuum).rules == ()


def test_the_report_shows_the_rules_only_where_a_body_is_there_that_they_concern():
    scene, layout = furnished(square())
    seated, vacuum = verify(scene, layout, agent=CHAIR_USER), verify(scene, layout, agent="robot_vacuum")
    assert "## Rules of accessibility" in seated.to_markdown()
    assert (
        "| door width | doors are 0.815 m wide | door 0 is 0.90 m wide | met | ADA 2010, 404.2.3 |"
        in seated.to_markdown()
    )
    assert "(not checked at its source)" in seated.to_markdown()
    assert "turning space" in seated.to_html()
    assert "Rules of accessibility" not in vacuum.to_markdown()
    first = seated.to_dict()["rules"][0]
    assert list(first) == ["name", "agent", "source", "verified", "asks", "met", "value", "limit", "unit", "text"]


def test_every_rule_has_a_source_with_a_section():
    assert len({rule.name for rule in RULES}) == len(RULES)
    for rule in RULES:
        standard, section = rule.source.split(", ", 1)
        assert standard in ("ADA 2010", "ISO 21542:2011")
        assert section
        assert rule.verified is (standard == "ADA 2010")


def test_an_empty_layout_is_measured_too():
    scene = Scene(square(), (thing("bed-0", (2.0, 1.4, 0.6), "bed"),), agents=(CHAIR_USER,))
    assert {result.rule.name for result in verify(scene, Layout({})).rules} >= {"door_width", "turning_space"}
