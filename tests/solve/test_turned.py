"""Laws of the solver: a room with a rough program, turned or with its things in another order, ends in the same verdict."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import pytest
from benchmarks.rough import rough

import robolayout as rl

GIVEN = rough("deli_small", 0)
NUMBERS = re.compile(r"(.*)\.(position|rotation) = \[(.*)\]")


def turned(degrees: float) -> tuple[rl.Scene, str]:
    """Return the scene and its program, turned about the origin."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    room = GIVEN.scene.room
    corners = tuple((c * x - s * y, s * x + c * y) for x, y in room.vertices)
    lines = []
    for line in GIVEN.text.splitlines():
        if found := NUMBERS.match(line):
            name, what, (x, *rest) = found[1], found[2], [float(number) for number in found[3].split(",")]
            numbers = [x + degrees] if what == "rotation" else [c * x - s * rest[0], s * x + c * rest[0], rest[1]]
            line = f"{name}.{what} = {[round(number, 5) for number in numbers]}"
        lines.append(line)
    return replace(GIVEN.scene, room=replace(room, vertices=corners)), "\n".join(lines)


@pytest.mark.parametrize("degrees", [30.0, 90.0])
def test_a_room_that_is_turned_ends_in_the_same_verdict(degrees: float) -> None:
    scene, text = turned(degrees)
    assert rl.generate(scene, program=text).solution.verdict.ok


def test_the_order_of_things_does_not_change_the_verdict() -> None:
    scene = replace(GIVEN.scene, assets=tuple(reversed(GIVEN.scene.assets)))
    assert rl.generate(scene, program=GIVEN.text).solution.verdict.ok
