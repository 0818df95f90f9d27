"""The report: its keys, what counts as met, worst over agents, sentences."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import pytest
from verify_rooms import DISC, furnished, on_floor, square, thing

from robolayout.constraints import RELATIONS, AssetRef, WallRef
from robolayout.page._content import _figures
from robolayout.program import read_program
from robolayout.scene import Layout, Scene, layout_digest, scene_digest
from robolayout.verify import Demands, Report, verify
from robolayout.verify.present import shown
from robolayout.words.ledger import AskedRow

KEYS = [
    "asked",
    "asked_met_share",
    "placed_share",
    "collision_free_share",
    "collision_free_scene",
    "collision_free_boxes_share",
    "in_boundary_share",
    "supported_share",
    "door_clear",
    "doors_reached",
    "walkable_ratio",
    "reachable_share",
    "reachable_share_chairs_aside",
    "usable_share",
    "statements_met_share",
    "statements",
    "wishes",
    "moved",
    "rules",
    "violations",
    "timing",
    "hashes",
]
SHELF = thing("bookshelf-0", (0.3, 1.0, 1.8), "bookshelf")
ARM = replace(DISC, name="arm", reach_distance=0.6)


@dataclass(frozen=True)
class Said:
    relation: object
    number: int
    line: int
    source: str
    by: str = ""


@dataclass(frozen=True)
class Asked:
    statements: tuple[Said, ...]
    guesses: Mapping[str, Any] = field(default_factory=dict)
    wishes: tuple[Said, ...] = ()


def good() -> tuple[Scene, Layout]:
    return furnished(square(), (SHELF, on_floor(SHELF, 0.15, 2.5)), agents=(ARM,))


def asked(wall: int) -> Asked:
    relation = RELATIONS["against_wall"](AssetRef("bookshelf-0"), WallRef(wall))
    return Asked((Said(relation, 1, 3, f"solver.against_wall(bookshelf[0], walls[{wall}])"),))


def test_a_good_layout_meets_every_demand():
    report = verify(*good(), asked(3))
    assert report.ok
    assert report.violations == ()
    assert report.statements[0].sentence == "against_wall(bookshelf-0, walls[3])"
    data = report.to_dict()
    assert list(data)[: len(KEYS)] == KEYS
    assert [data[key] for key in KEYS[2:14]] == [1.0, 1.0, True, 1.0, 1.0, True, True, 1.0, 1.0, 1.0, 1.0, 1.0]
    assert set(data["timing"]["verify"]) == {"wall", "cpu"}
    assert data["hashes"] == {"scene": scene_digest(report.scene), "layout": layout_digest(report.layout)}
    assert set(data["statements"][0]) == {
        "number",
        "line",
        "source",
        "sentence",
        "by",
        "met",
        "value",
        "limit",
        "unit",
        "text",
        "lost_to",
    }


def test_the_report_is_plain_data():
    report = verify(*good(), asked(3))
    assert json.loads(json.dumps(report.to_dict(), allow_nan=False))["agents"]["arm"]["name"] == "arm"


def test_a_statement_is_judged_as_asked():
    report = verify(*good(), asked(1))
    assert report.figures["statements_met_share"] == 0.0
    assert not report.ok
    assert report.unmet == ("statements_met_share",)
    assert report.violations[0].startswith("against_wall(bookshelf-0, walls[1]) is not met: ")


def test_a_pose_that_is_no_number_counts_as_none():
    other = replace(SHELF, name="bookshelf-1")
    scene, layout = furnished(
        square(), (SHELF, on_floor(SHELF, 0.15, 2.5)), (other, on_floor(other, 0.15, 1.0)), agents=(ARM,)
    )
    nowhere = Layout({**layout, "bookshelf-1": replace(layout["bookshelf-1"], x=math.nan)})
    program = read_program("solver.wish.snug(bookshelf[0])\nsolver.against_wall(bookshelf[1], walls[3])", scene)
    report = verify(scene, nowhere, program)
    assert report.statements[0].text == "bookshelf-1 not placed"
    assert json.dumps(report.to_dict(), allow_nan=False)


def test_a_statement_about_something_unplaced_is_not_met():
    scene, _ = good()
    report = verify(scene, Layout({}), asked(3))
    assert not report.statements[0].met
    assert report.statements[0].text == "bookshelf-0 not placed"
    assert json.dumps(report.to_dict(), allow_nan=False)


def test_top_level_figures_are_the_worst_over_agents():
    shelf, box = thing("shelf-0", (3.2, 0.4, 1.8), "bookshelf"), thing("box-0", (0.5, 1.0, 0.8))
    scene, layout = furnished(square(), (shelf, on_floor(shelf, 1.6, 2.0, 0)), (box, on_floor(box, 2, 3.4)))
    slim, wide = replace(ARM, name="slim"), replace(ARM, name="wide", radius=0.43)
    report = verify(scene, layout, agent=[slim, wide])
    by_name = {item.agent.name: item.figures for item in report.agents}
    assert by_name["slim"]["reachable_share"] == 1.0
    assert by_name["wide"]["reachable_share"] == 0.5
    assert report.figures["reachable_share"] == 0.5
    assert set(report.to_dict()["agents"]) == {"slim", "wide"}
    (sentence,) = [s for s in report.violations if "cannot be reached" in s]
    assert sentence == (
        "box-0 cannot be reached by wide: narrowest passage 0.80 m, needs 0.86 m, between shelf-0 and wall 1."
    ) or sentence == (
        "box-0 cannot be reached by wide: narrowest passage 0.79 m, needs 0.86 m, between shelf-0 and wall 1."
    )
    assert "wide would reach box-0 without shelf-0." in report.to_markdown()


def test_agents_are_named_loaded_or_given():
    scene, layout = good()
    assert [a.agent.name for a in verify(scene, layout, agent="wheelchair,child_6").agents] == ["wheelchair", "child_6"]
    assert verify(scene, layout, agent=DISC).agents[0].agent is DISC
    assert verify(scene, layout).agents[0].agent == ARM


def test_a_rectangular_body_reports_its_turning_places():
    scene, layout = good()
    report = verify(scene, layout, agent="wheelchair")
    (place,) = report.to_dict()["agents"]["wheelchair"]["turning_places"]
    assert place["area"] > 3.0
    assert report.agents[0].usage.usable["bookshelf-0"]


def test_what_is_not_asked_of_a_body_does_not_fail_the_report():
    table = thing("table-0", (1.4, 1.4, 0.7), "dining table")
    cup = thing("cup-0", (0.1, 0.1, 0.1), "cup", on_floor=False, on_object=True)
    scene, layout = furnished(square(), (table, on_floor(table, 2.4, 2.4)), (cup, on_floor(cup, 2.4, 2.4, bottom=0.7)))
    report = verify(scene, layout, agent=DISC)
    assert report.figures["reachable_share"] == 0.5
    assert report.ok
    assert report.violations == ()
    assert "not asked: disc has no arm and cup-0 does not stand on the floor." in report.to_markdown()
    armed = verify(scene, layout, agent=ARM)
    assert not armed.ok
    assert armed.violations == (
        "cup-0 is out of reach of arm: 0.95 m from the nearest place to stand, reach is 0.60 m.",
    )


def test_a_page_names_the_narrowest_way_to_what_is_asked_of_a_body():
    """As report.md does: no disc touches the cup amid the table."""
    table = thing("table-0", (1.4, 1.4, 0.7), "dining table")
    cup = thing("cup-0", (0.1, 0.1, 0.1), "cup", on_floor=False, on_object=True)
    scene, layout = furnished(square(), (table, on_floor(table, 2.4, 2.4)), (cup, on_floor(cup, 2.4, 2.4, bottom=0.7)))
    body = verify(scene, layout, agent=DISC).agents[0]
    assert body.navigation.passages["cup-0"].width == 0
    rows = {name: (value, met) for name, value, met in _figures(body, Demands())}
    assert rows["narrowest way"] == ("1.50 m or more (needs 0.60 m)", True)


def test_the_verdict_counts_the_phrases_that_it_does_not_tell_of():
    kinds = ("met", "not understood", "not judged", "not judged")
    rows = tuple(AskedRow(f"phrase {i}", "relation", "", (), kind, "") for i, kind in enumerate(kinds))
    told = "all demands met, 1 phrase not understood, 2 phrases not judged"
    report = replace(verify(*good()), asked=rows)
    assert report.to_markdown().splitlines()[0].endswith(f": {told}")
    assert told in report.to_html()
    assert verify(*good()).to_markdown().splitlines()[0].endswith(": all demands met")
    lenient = verify(*good(), asked(1), demands=Demands(statements_met_share=0.0))
    assert lenient.ok and lenient.verdict == "all demands met, 1 of 1 statements unmet"


@pytest.mark.parametrize(
    ("share", "text"), [(18 / 19, "0.94"), (0.9999, "0.99"), (0.95, "0.95"), (0.29, "0.29"), (1.0, "1.00")]
)
def test_a_share_that_is_short_does_not_read_as_enough(share: float, text: str):
    assert shown(share) == text


def test_what_is_too_far_and_too_high_is_said_to_be_both_and_no_removal_helps():
    counter = thing("counter-0", (0.8, 1.4, 0.9), "kitchen counter")
    cabinet = thing("cabinet-0", (0.3, 0.8, 0.7), "wall cabinet", on_floor=False, on_wall=True)
    scene, layout = furnished(
        square(),
        (counter, on_floor(counter, 3.6, 2.0, 180.0)),
        (cabinet, on_floor(cabinet, 3.85, 2.0, 180.0, bottom=1.4)),
    )
    report = verify(scene, layout, agent=replace(ARM, reach_distance=0.5, reach_high=1.2))
    assert report.violations == (
        "cabinet-0 is out of reach of arm: 0.60 m from the nearest place to stand, reach is 0.50 m; "
        "it begins 1.40 m high, reach ends at 1.20 m: 0.20 m too high.",
    )
    assert report.agents[0].remedies.removals == {}


def test_a_body_that_cannot_come_in_fails_the_report():
    scene, layout = good()
    report = verify(scene, layout, agent=replace(ARM, radius=0.5))
    assert not report.ok
    assert report.violations == ("Door 0 is 0.90 m wide, arm needs 1.00 m: it cannot come in.",)


def test_the_table_and_the_page():
    report = verify(*good(), asked(1))
    rows = report.rows()
    assert ("statements met", "0.00", False) in rows
    assert ("door clear", "yes", True) in rows
    page = report.to_markdown()
    assert page.startswith("# scene: not all demands are met\n")
    assert "| statements met | 0.00 | **short** |" in page
    assert ("collision free boxes", "1.00", None) in rows and "| collision free boxes | 1.00 | - |" in page
    assert "| bookshelf-0 | yes |" in page


def test_the_repr_is_of_use():
    assert repr(verify(*good())).startswith("Report(ok: placed 1.00, collision free 1.00")
    assert "unreached []" in repr(verify(*good()).agents[0].navigation)


def test_other_stations_add_their_times():
    report = verify(*good()).with_timing({"solve": {"wall": 1.0, "cpu": 2.0}})
    assert isinstance(report, Report)
    assert list(report.to_dict()["timing"]) == ["solve", "verify"]


def test_an_empty_layout_fails_everything():
    scene, _ = good()
    figures = verify(scene, Layout({})).figures
    assert figures["collision_free_scene"] is False
    assert [figures[k] for k in KEYS[2:15] if "share" in k] == pytest.approx([0, 0, 0, 0, 0, 0, 0, 0, 1])


def test_what_blocks_the_door_is_named_once():
    block, box = thing("block-0", (1.6, 1.4, 1.0)), thing("box-0", (0.5, 1.0, 0.8))
    scene, layout = furnished(square(), (block, on_floor(block, 1.45, 0.7)), (box, on_floor(box, 2, 3.4)))
    report = verify(scene, layout, agent=DISC)
    assert report.agents[0].violations == (
        "disc (a disc of 0.60 m) cannot come in: the landing of door 0 is blocked by block-0.",
        "disc reaches none of block-0, box-0.",
    )


def test_psa_style_is_what_is_met_and_nothing_unless_all_is_valid():
    scene, layout = good()
    assert verify(scene, layout, asked(3)).metrics["LayoutVLM"]["PSA_style"] == 100.0
    assert verify(scene, layout, asked(1)).metrics["LayoutVLM"]["PSA_style"] == 0.0
    assert verify(scene, Layout({}), asked(3)).metrics["LayoutVLM"]["PSA_style"] == 0.0
    assert "PSA_style" not in verify(scene, layout).metrics["LayoutVLM"]


def test_the_sentences_ask_for_what_is_demanded_and_no_more():
    shelf = thing("shelf-0", (3.2, 0.4, 1.8), "bookshelf")
    scene, layout = furnished(square(), (shelf, on_floor(shelf, 1.6, 2.0, 0)))
    wide = replace(ARM, radius=0.43)
    ratio = verify(scene, layout, agent=wide).figures["walkable_ratio"]
    assert 0.4 < ratio < 0.6
    strict, lax = (verify(scene, layout, agent=wide, demands=Demands(walkable_ratio=least)) for least in (0.95, 0.4))
    assert [s for s in strict.violations if "free floor" in s]
    assert not [s for s in lax.violations if "free floor" in s]
    assert lax.ok
    assert not strict.ok
