"""Loss curves: linear and logarithmic, with terms that come and go."""

import io
import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from robolayout.render._drawing import Shape, Text
from robolayout.render.curves import draw_losses, loss_terms, nice_ticks
from robolayout.scene import Snapshot, Trace


def test_absent_terms_are_gaps(trace):
    terms = loss_terms(trace)
    assert list(terms) == ["overlap", "boundary", "total"]
    assert np.isfinite(terms["boundary"][:20]).all() and np.isnan(terms["boundary"][20:]).all()


def test_every_term_is_drawn_and_named(trace):
    drawing = draw_losses(trace)
    assert {"overlap", "boundary", "total"} <= {i.text for i in drawing.items if isinstance(i, Text)}
    colors = {i.stroke for i in drawing.items if isinstance(i, Shape) and not i.closed}
    assert {"#0072b2", "#d55e00"} <= colors


def test_negative_and_zero_values_have_a_logarithm_or_a_gap():
    trace = Trace(tuple({"a": v} for v in (1.0, -0.1, 0.0, 0.01, math.inf, math.nan)))
    image = draw_losses(trace).image(300)
    assert image.size == (300, 115)


def test_an_empty_trace_says_so():
    texts = [i.text for i in draw_losses(Trace()).items if isinstance(i, Text)]
    assert texts.count("no losses were recorded") == 2


def test_png_is_readable_and_repeatable(trace):
    data = draw_losses(trace).file(".png", 400)
    assert data == draw_losses(trace).file(".png", 400)
    assert Image.open(io.BytesIO(data)).size == (400, 153)


def test_curves_look_as_they_did(trace, golden):
    golden(draw_losses(trace).image(480), "loss-480")


@given(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6))
def test_ticks_span_the_range(low, span):
    ticks = nice_ticks(low, low + span)
    tolerance = 1e-6 * (abs(low) + span)
    assert ticks[0] <= low + tolerance and ticks[-1] >= low + span - tolerance
    assert 2 <= len(ticks) <= 9
    assert all(b > a for a, b in pairwise(ticks))


def test_long_runs_keep_their_peaks():
    losses = [{"total": 1.0}] * 5000
    losses[1234] = {"total": 9.0}
    ticks = [i.text for i in draw_losses(Trace(tuple(losses))).items if isinstance(i, Text)]
    assert any(text in ticks for text in ("9", "10"))
    assert draw_losses(Trace(tuple(losses))).image(200) is not None


@pytest.mark.parametrize("steps", [1, 2])
def test_short_runs(steps):
    assert draw_losses(Trace(({"total": 0.5},) * steps)).image(200).width == 200


def test_a_room_that_needed_no_search_says_so():
    trace = Trace(({"total": 0.04}, {"total": 0.0}), (Snapshot(0, "guess", {"bed-0": (1.0, 2.0, 0.0)}),) * 2)
    (only,) = draw_losses(trace).items
    assert only.text == "This room needed no search: what was planned was right at once."
    moved = Trace(trace.losses, (*trace.snapshots, Snapshot(1, "search", {"bed-0": (1.0, 2.1, 0.0)})))
    assert "loss" in {i.text for i in draw_losses(moved).items if isinstance(i, Text)}
