"""What a notebook shows: well-formed HTML, every text escaped, and pandas tables."""

from __future__ import annotations

import copy
import math
import pickle
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from importlib import import_module

import pytest

import robolayout as rl
from robolayout._errors import MissingExtraError
from robolayout._text import bullets
from robolayout.scene import load_agent

HOSTILE = "<script>alert('x')</script> & \"quotes\""

ROOM = {
    "boundary": {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5},
    "doors": [{"wall": 0, "offset": 0.1, "width": 0.9, "height": 2.05}],
    "assets": {
        "desk-0": {"onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.7}}},
        "lamp-0": {"onObject": True, "assetMetadata": {"boundingBox": {"x": 0.2, "y": 0.2, "z": 0.4}}},
    },
}


@pytest.fixture(scope="module")
def result() -> rl.Result:
    scene = rl.scene_from_dict(ROOM, name=HOSTILE)
    body = replace(load_agent("wheelchair"), title=HOSTILE)
    return rl.generate(replace(scene, agents=(body,)), config=rl.SolverConfig(starts=1))


def texts(html: str) -> str:
    """Return the texts of HTML that is well-formed XML, and see that no element came out of a text."""
    root = ElementTree.fromstring(f"<x>{html}</x>")
    assert not [e for e in root.iter() if e.tag.rpartition("}")[2] in ("script", "img", "iframe")]
    return " ".join(root.itertext())


@pytest.mark.slow
def test_a_result_shows_its_plan_and_its_report(result: rl.Result) -> None:
    html = result._repr_html_()
    assert "<svg" in html and "<table" in html
    said = texts(html)
    assert said.count(HOSTILE) >= 2, "as text: the scene's and the body's name"
    assert "desk" in said and "walkable ratio" in said and "1 m" in said


def test_a_result_is_short_at_a_prompt(result: rl.Result) -> None:
    assert repr(result).startswith("Result(layout=Layout(desk-0: (") and len(repr(result)) < 600


def test_a_report_lists_what_is_wrong_up_to_a_bound(result: rl.Result) -> None:
    said = texts(rl.verify(result.scene, rl.Layout({}))._repr_html_())
    assert "not all demands are met" in said and "desk-0 is not placed." in said
    assert texts(bullets([f"{k} < {k + 1}" for k in range(20)], 3)) == "0 < 1 1 < 2 2 < 3 and 17 more"
    assert bullets([], 3) == ""


def test_a_layout_is_a_table_of_poses(result: rl.Result) -> None:
    layout = rl.Layout({"desk-0": rl.Pose(1.0, 2.0, 0.35, -math.pi / 2), "<b>-0": rl.Pose(0, 0, 0, 0)})
    html = layout._repr_html_()
    assert "270.0" in texts(html) and "<b>-0" in texts(html)


def test_a_frame_has_a_row_per_asset(result: rl.Result) -> None:
    frame = result.to_frame()
    assert list(frame.index) == ["desk-0", "lamp-0"]
    assert frame.loc["desk-0", "x"] == result.layout["desk-0"].x
    assert frame.loc["lamp-0", "height"] == 0.4
    assert frame["placed"].all() and frame["collision_free"].dtype == bool
    assert frame.loc["desk-0", "reached"] == result.report.agents[0].navigation.reached["desk-0"]
    route = result.report.agents[0].navigation.routes["desk-0"]
    assert frame.loc["desk-0", "route"] == pytest.approx(route.length)


def test_a_frame_of_an_empty_layout_and_several_agents(result: rl.Result) -> None:
    report = rl.verify(result.scene, rl.Layout({}), agent="cat,adult")
    frame = report.to_frame()
    assert frame["x"].isna().all() and not frame["placed"].any()
    assert {"cat: reached", "adult: reached", "adult: passage"} <= set(frame.columns)


def test_without_pandas_the_package_is_named(result: rl.Result, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(import_module("robolayout.verify.report"), "find_spec", lambda name: None)
    with pytest.raises(MissingExtraError, match=r"to_frame\(\) needs the package 'pandas': pip install pandas\."):
        result.to_frame()


def test_a_result_goes_to_another_process_and_is_copied_with_all_that_was_worked_out(result: rl.Result) -> None:
    said = result.report.to_dict()
    for found in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result)):
        assert found.layout == result.layout and found.report.to_dict() == said
        assert found.report.agents[0].drives == result.report.agents[0].drives
