"""What a small table is in each room and at each place, and that the ledger says what is made."""

from __future__ import annotations

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words


@pytest.mark.parametrize(
    ("text", "made"),
    [
        ("A bedroom with a small table.", "side table"),
        ("A game room with a small table.", "coffee table"),
        ("A nursery with a small table.", "side table"),
        ("A meeting room with a small wooden table.", "side table"),
        ("A lounge with a sofa and a small table next to it.", "side table"),
        ("A lounge with a sofa and a small table in front of it.", "coffee table"),
        ("A kitchen with a small table.", "dining table"),
        ("A playroom with a small table.", "kids table"),
        ("A bedroom with a small table and two chairs.", "round table"),
    ],
)
def test_a_small_table_is_small_and_the_ledger_names_it(text: str, made: str) -> None:
    scene, understood = scene_from_sentence(text)
    table = next(name for name in understood.wished if name.endswith("table"))
    size = next(asset.size for asset in scene.assets if asset.category == table)
    assert table == made and max(size[:2]) < 1.4
    rows = read_words(scene).rows
    assert any(made in row.understanding for row in rows if row.kind == "count")


@pytest.mark.parametrize("text", ["A dining room with a square table.", "A cafe with a small round table."])
def test_what_is_square_or_round_is_as_wide_as_deep(text: str) -> None:
    scene, understood = scene_from_sentence(text)
    (size,) = {
        asset.size[:2] for asset in scene.assets if asset.category in understood.wished and "table" in asset.category
    }
    assert size[0] == size[1]
