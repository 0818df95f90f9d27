"""Tables that are laid: before each seat a plate with what belongs to it, on round tables as on straight ones."""

from __future__ import annotations

import math

import pytest

import robolayout as rl


@pytest.mark.parametrize(
    "text",
    [
        "a dining room with a round table for six and a plate, a fork, a knife and a glass at each place",
        "a dining room with an oval table set for six",
        "a dining room with a table set for eight with plates and glasses",
    ],
)
def test_every_place_is_laid_before_its_seat(text: str) -> None:
    """Around a round table plates stood in a heap in its middle: only a strip of its top held anything."""
    result = rl.generate(text)
    assert result.report.ok
    assert not [row for row in result.report.asked if row.verdict in ("unmet", "not understood")]
    laid = [asset.name for asset in result.scene.assets if asset.category in ("plate", "place setting")]
    seats = [asset.name for asset in result.scene.assets if asset.category == "chair"]
    for plate, seat in zip(laid, seats, strict=True):
        there, sits = result.layout[plate], result.layout[seat]
        ahead, aside = sits.seen((there.x, there.y))
        assert 0.2 < ahead < 0.75, (plate, seat)
        assert abs(aside) < 0.12, (plate, seat)
        assert math.cos(there.yaw - sits.yaw) == pytest.approx(1.0, abs=0.02)


def test_chairs_in_the_middle_stand_at_their_table() -> None:
    """Each was asked near the middle of the room, and none at the table that was there, too."""
    result = rl.generate("a playroom with a low table and four small chairs in the middle")
    table = result.layout["kids_table-0"]
    away = [
        math.dist((table.x, table.y), (result.layout[f"kids_chair-{i}"].x, result.layout[f"kids_chair-{i}"].y))
        for i in range(4)
    ]
    assert max(away) < 0.8
