"""Animations: complete, small, repeatable."""

import numpy as np
import pytest
from film_frames import frames
from PIL import Image

from robolayout._errors import InputError
from robolayout.render import progress_gif
from robolayout.scene import Snapshot, Trace


def test_progress_is_short_and_holds_the_result(bedroom, layout, trace):
    data = progress_gif(bedroom, trace, layout=layout, size=300)
    shown = frames(data)
    assert len(data) < 300_000
    assert 24 <= len(shown) <= 28
    assert shown[-1][1] >= 2000 > shown[0][1]
    assert np.abs(shown[0][0] - shown[-1][0]).mean() > 1
    assert shown[0][0].shape[0] <= 300 and shown[0][0].shape[1] <= 300


def test_progress_is_repeatable(bedroom, layout, trace):
    first, second = (progress_gif(bedroom, trace, layout=layout, size=200, frames=6) for _ in range(2))
    assert first == second


def test_a_trace_without_losses_or_snapshots_still_shows_the_layout(bedroom, layout):
    assert len(frames(progress_gif(bedroom, Trace(), layout=layout, size=200))) == 1
    with pytest.raises(InputError, match="progress_gif has nothing to show"):
        progress_gif(bedroom, Trace())


def test_a_room_that_needed_no_search_is_shown_once_with_a_sentence(bedroom, layout):
    poses = {name: (p.x, p.y, p.yaw) for name, p in layout.items()}
    trace = Trace(({"total": 0.04}, {"total": 0.0}), (Snapshot(0, "guess", poses), Snapshot(1, "guess", poses)))
    (only,) = frames(progress_gif(bedroom, trace, layout=layout, size=300))
    strip = only[0][-40:]
    assert (strip < 128).any(), "the sentence is written below the plan"


def test_the_last_frame_looks_as_it_did(bedroom, layout, trace, golden):
    image = frames(progress_gif(bedroom, trace, layout=layout, size=300))[-1][0]
    golden(Image.fromarray(image.astype(np.uint8)), "progress-last-300", mean=2.0, share=0.02)
