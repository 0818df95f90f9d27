"""Laws of the solver: a room with a rough program, changed as no demand minds, ends in the same verdict."""

from __future__ import annotations

from functools import partial

import pytest
from benchmarks.laws import Given, mirrored, moved, renamed, reordered, turned
from benchmarks.rough import rough

import robolayout as rl
from robolayout.scene import Scene

GIVEN = rough("deli_small", 0)
CHANGES = {
    "turned by 30": turned, "turned by 90": partial(turned, degrees=90.0), "moved": moved, "mirrored": mirrored,
    "renamed": renamed, "in another order": reordered,
}  # fmt: skip


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_a_room_that_is_changed_ends_in_the_same_verdict(change: partial[Given]) -> None:
    scene, text = change(GIVEN.scene, GIVEN.text)
    assert isinstance(scene, Scene)
    assert (scene, text) != (GIVEN.scene, GIVEN.text)
    assert rl.generate(scene, program=text).solution.verdict.ok
