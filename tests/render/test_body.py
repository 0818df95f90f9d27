"""The drawing of a body: to scale, complete, for every built-in body, in all its forms."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from robolayout.render import body_text
from robolayout.render._drawing import Shape, Text
from robolayout.render._style import BODY
from robolayout.render.body import draw_body
from robolayout.render.palette import REACH, ROUTE, TURN
from robolayout.scene import Agent, agent_names, load_agent


def rings(agent: Agent, **style: object) -> list[np.ndarray]:
    found = [item for item in draw_body(agent).items if isinstance(item, Shape)]
    return [np.array(s.rings[0]) for s in found if all(getattr(s, k) == v for k, v in style.items())]


def words(agent: Agent) -> str:
    return "\n".join(item.text for item in draw_body(agent).items if isinstance(item, Text))


@pytest.mark.parametrize("name", agent_names())
def test_every_body_is_drawn_within_its_sheet(name: str):
    sheet = draw_body(load_agent(name))
    points = np.array([p for item in sheet.items if isinstance(item, Shape) for ring in item.rings for p in ring])
    assert points.min() >= 0.0
    assert (points.max(axis=0) <= (sheet.width, sheet.height)).all()
    assert sheet.width < 260 and sheet.height < 110


def test_the_wheelchair_is_to_scale():
    """1 : 50, so 1.22 x 0.76 m are 24.4 x 15.2 mm, and the turning circle of 1.525 m is 30.5 mm wide."""
    chair = load_agent("wheelchair")
    assert "1 : 50" in words(chair)
    above, side = rings(chair, fill=ROUTE, stroke=ROUTE)
    assert np.ptp(above, axis=0) == pytest.approx((24.4, 15.2))
    assert np.ptp(side, axis=0) == pytest.approx((24.4, (1.35 - 0.013) * 20))
    (circle,) = rings(chair, stroke=TURN)[:1]
    assert np.ptp(circle, axis=0) == pytest.approx((30.5, 30.5), rel=1e-3)
    reach, band = rings(chair, fill=REACH)
    assert np.ptp(reach, axis=0) == pytest.approx((39.6, 39.6), rel=1e-3)
    assert np.ptp(band, axis=0) == pytest.approx((0.99 * 20, (1.22 - 0.38) * 20))
    for said in (
        "1.22 m x 0.76 m",
        "corridor 0.915 m",
        "turning circle 1.525 m",
        "reaches up to 1.22 m",
        "steps over 0.013 m",
    ):
        assert said in words(chair)


def test_the_reach_about_a_shoulder_is_round():
    robot = load_agent("unitree_g1")
    band = rings(robot, fill=REACH)[1]
    k = 20.0
    shoulder = band[:, 1].mean()
    assert np.ptp(band[:, 0]) == pytest.approx(0.45 * k, rel=0.01)
    assert np.ptp(band[:, 1]) < 2 * 0.45 * k + 1e-6 and shoulder > 0


def test_a_body_without_an_arm_shows_no_reach():
    assert not rings(load_agent("robot_vacuum"), fill=REACH)
    assert "reach" not in words(load_agent("robot_vacuum"))


def test_labels_of_heights_do_not_overlap():
    body = Agent("x", 0.2, 1.0, reach_distance=0.5, reach_low=0.98, reach_high=1.02, shoulder_height=1.0, step=0.99)
    texts = [
        item
        for item in draw_body(body).items
        if isinstance(item, Text) and re.search(r"(height|reaches|over|shoulder)", item.text)
    ]
    levels = sorted(item.at[1] for item in texts)
    assert len(levels) == 5 and min(np.diff(levels)) > 2.9


def test_all_forms():
    chair = load_agent("wheelchair")
    svg = draw_body(chair).svg()
    assert ElementTree.fromstring(svg).tag.endswith("svg") and "wheelchair user (ADA)" in svg
    assert draw_body(chair).image(400).width == 400
    assert draw_body(chair).pdf().startswith(b"%PDF-1.4")


def test_on_a_terminal_it_is_lines_of_braille():
    text = body_text(load_agent("cat"), columns=40)
    lines = text.splitlines()
    assert all(0x2800 <= ord(c) <= 0x28FF for line in lines for c in line)
    assert max(map(len, lines)) <= 40 and len(lines) > 5
    assert BODY.labels > 0
