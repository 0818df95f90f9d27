"""Records draw what they say: the frozen look of every category, and errors that name record, part and field."""

import zlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from robolayout._errors import AssetError
from robolayout.assets import CATALOGUE, Category, Part
from robolayout.assets.meshes import builder_for, fit
from robolayout.assets.palette import GROUPS, MATERIALS, make_piece, material_of
from robolayout.assets.rows import check_rows, read_rows

LOOKS = (((1.0, 1.0, 1.0), 0), ((1.13, 0.91, 1.07), 4), ((0.8, 1.3, 1.2), 7))
"""Factors of the typical size, and the seed that picks palette and style."""


def _built(category: Category, factors: tuple[float, ...], seed: int) -> tuple[Part, ...]:
    size = tuple(edge * factor for edge, factor in zip(category.size, factors, strict=True))
    piece = make_piece(category.name, f"{category.name} {seed}", f"{category.name}-{seed}", size, seed)
    return fit(builder_for(category)(piece), size)


def _looks() -> Iterator[tuple[str, tuple[int, int, float]]]:
    """Yield what is drawn; one line a category and size. Most are from when the furniture was written as functions."""
    for line in (Path(__file__).parent / "looks.txt").read_text("utf-8").splitlines()[1:]:
        name, _, figures = line.rpartition(": ")
        parts, triangles, total = figures.split()
        yield name, (int(parts), int(triangles), float(total))


def _total(built: tuple[Part, ...]) -> float:
    """Return a sum over all corners that no order changes and that every part's name and material weighs."""
    total = 0.0
    for part in built:
        weight = 1 + zlib.crc32(f"{part.name}/{part.material.name}".encode()) % 97
        total += weight * float((part.vertices @ [1.0, 1.7, 2.9] + part.vertices**2 @ [0.3, 0.7, 1.1]).sum())
    return total


def test_everything_looks_as_it_always_did() -> None:
    looks: dict[str, list[tuple[int, int, float]]] = {}
    for name, look in _looks():
        looks.setdefault(name, []).append(look)
    for name, frozen in looks.items():
        for (factors, seed), (parts, triangles, total) in zip(LOOKS, frozen, strict=True):
            built = _built(CATALOGUE[name], factors, seed)
            assert (len(built), sum(len(part.faces) for part in built)) == (parts, triangles), name
            assert _total(built) == pytest.approx(total, rel=1e-7, abs=1e-4), name


def test_every_category_is_drawn_by_rows() -> None:
    assert [name for name, category in CATALOGUE.items() if not category.parts] == []


def _drawn(rows: str, size: tuple[float, float, float] = (1.0, 2.0, 1.0), variable: str = "x") -> list[Part]:
    return list(read_rows(rows, "'x'")(make_piece("x", variable, "x-0", size, 0)))


def _ends(part: Part) -> list[float]:
    return np.round([*part.vertices.min(axis=0), *part.vertices.max(axis=0)], 9).tolist()


def test_a_number_is_a_share_and_m_are_metres() -> None:
    (top,) = _drawn("top: box wood x 0:1 y .25:1-.1m z 1-.2m:1")
    assert _ends(top) == [-0.5, -0.5, 0.8, 0.5, 0.9, 1.0]
    (middle,) = _drawn("bar: box oak-x x .5~.1m y .1d:.5 z 0:.5w".replace("oak-x", "pine"))
    assert _ends(middle) == [-0.1, -0.9, 0.0, 0.1, 0.0, 1.0]


def test_a_let_names_a_length_or_a_number() -> None:
    parts = _drawn(
        "let n = max(1, round(w / .5m))\nlet step = w / n\nslat: box wood x 0:1 y 0:.5step z 0:1 repeat n y step"
    )
    assert [_ends(part)[1] for part in parts] == [-1.0, -0.5, 0.0, 0.5]


def test_mirror_and_repeat_draw_a_row_again() -> None:
    legs = _drawn("leg: box wood x 0:.1m y 0:.1m z 0:1 mirror xy")
    assert sorted(_ends(leg)[:2] for leg in legs) == [[-0.5, -1.0], [-0.5, 0.9], [0.4, -1.0], [0.4, 0.9]]
    arms = _drawn("arm: box wood x .6:1 y .5~.1m z 0:1 repeat 4 turn 90")
    assert {(round(float(a.vertices[:, 0].max()), 6), round(float(a.vertices[:, 1].max()), 6)) for a in arms} == {
        (0.5, 0.1), (0.1, 0.5), (-0.1, 0.1), (0.1, -0.1),
    }  # fmt: skip


def test_a_part_leans_as_it_rises() -> None:
    (back,) = _drawn("back: box wood x 0:.1m y 0:1 z 0:1 x/z 0:-.05m")
    high = back.vertices[back.vertices[:, 2] > 0.5]
    assert high[:, 0].min() == pytest.approx(-0.55) and back.vertices[:, 0].max() == pytest.approx(-0.4)


def test_chance_moves_leaves_out_and_colours_what_varies_and_rows_of_one_thing_fare_alike() -> None:
    rows = (
        "note: box spines x 0:1 y 0:.01 z 0:.1 repeat 90 y .01w vary z .5h skip .5\n"
        "pin: box red x 0:1 y 0:.01 z .1:.2 repeat 90 y .01w vary z .5h skip .5"
    )
    drawn = _drawn(rows)
    notes, pins = ([part for part in drawn if part.name == name] for name in ("note", "pin"))
    lows = [_ends(note)[2] for note in notes]
    assert 25 < len(notes) < 65 and 0.0 < min(lows) < 0.1 and 0.4 < max(lows) < 0.5
    assert [_ends(pin)[2] for pin in pins] == [_ends(note)[5] for note in notes]
    assert {note.material.name for note in notes} == {name.replace("-", " ") for name in GROUPS["spines"]}
    assert [_ends(part) for part in _drawn(rows)] == [_ends(part) for part in drawn]


def test_only_some_times_of_a_repeat_are_drawn() -> None:
    rows = "a: box red/blue/green x 0:1 y 0:.1w z 0:1 repeat 6 y .1w only 0,2/3".replace("0:.1w", "0:.1")
    assert [(part.material.name, _ends(part)[1]) for part in _drawn(rows)] == [
        ("red", -1.0), ("green", -0.6), ("red", -0.4), ("green", 0.0),
    ]  # fmt: skip


def test_doors_and_drawers_have_handles() -> None:
    names = [
        part.name for part in _drawn("a: doors front y 0:1 z 0:1 count 2\nb: drawers front y 0:1 z 0:1 rows 2 knobs 1")
    ]
    assert names == ["door", "handle"] * 2 + ["drawer", "knob"] * 2
    high, low = (_drawn(f"a: doors front y 0:1 z 0:1 count 1{option}")[1] for option in ("", " low 1"))
    assert low.vertices[:, 2].min() < high.vertices[:, 2].min() - 0.2 and np.ptp(low.vertices, axis=0) == pytest.approx(
        np.ptp(high.vertices, axis=0)
    )


def test_style_and_size_choose_rows_and_materials_take_turns() -> None:
    rows = "a: box red|blue x 0:1 y 0:1 z 0:1 if style=0/2|w>3m\nb: box red/blue/red x 0:1 y 0:.1 z 0:1 repeat 3 y .2w"
    shown = {variable: [part.material.name for part in _drawn(rows, variable=variable)] for variable in "abcdefgh"}
    assert {tuple(names) for names in shown.values()} == {("red", "red", "blue", "red"), ("red", "blue", "red")}
    assert all(len(_drawn(rows, (1.0, 4.0, 1.0), variable)) == 4 for variable in "abcdefgh")


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ("", "there is no row; write one such as 'top: box wood x 0:1 y 0:1 z 0:1'"),
        ("top box wood", "'top box wood' cannot be read; write 'NAME: SHAPE MATERIAL x .. y .. z ..'"),
        ("top: cone wood x 0:1 y 0:1 z 0:1", "part 'top': unknown shape 'cone'; known: box, soft, ball, cylinder, prism"),
        ("top: box wod x 0:1 y 0:1 z 0:1", "part 'top': unknown material 'wod'; known: white,"),
        ("top: box wood x 0:1 y 0:1", "part 'top': z is missing; a box needs x, y, z"),
        ("top: box wood x 0:1 y 0:1 z .5", "part 'top': it has two ends along x, y; a box has them along 3 of x, y, z"),
        ("top: box wood x 0:1 y 0:1 z", "part 'top': 'z' has no value; write a value after each field"),
        ("top: box wood x 0:1 y 0:1 z 0:1 r .1m", "part 'top': unknown field 'r'; known: x, y, z, top,"),
        ("top: box wood x 0:q y 0:1 z 0:1", "part 'top': 'q' cannot be read; write a sum such as 1-.03m+.1w of m, d, w, h"),
        ("rod: cylinder wood x .5 y .5 z 0:1 r .5", "part 'rod': '.5' is no length; write metres (.03m) or"),
        ("top: box wood x 0:1 y 0:1 z 0:1 mirror z", "part 'top': 'mirror z' cannot be read; write mirror x|y|xy"),
        ("top: box wood x 0:1 y 0:1 z 0:1 vary w 1", "part 'top': unknown field 'w'; known: skip, x, y, z, turn"),
        ("top: box wood x 0:1 y 0:1 z 0:1 if big", "part 'top': 'big' cannot be read; write w>1.2m or style=0,2/4"),
        ("let t = print(1)\ntop: box wood x 0:t y 0:1 z 0:1", "'print(1)' holds 'print'; use m, d, w, h, min, max, round"),
        ("let t = (1\ntop: box wood x 0:t y 0:1 z 0:1", "'(1' cannot be read; write sums and products of lengths"),
        ("top: box wood x 0:1 y 0:1 z 0:1 repeat 2 y .1w only odd", "'odd' cannot be read; write remainders and a divisor"),
        ("let w = 1m\ntop: box wood x 0:1 y 0:1 z 0:1", "'let w = 1m' cannot be read; write 'let NAME = EXPRESSION'"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_named(rows: str, said: str) -> None:
    with pytest.raises(AssetError) as error:
        read_rows(rows, "'x' in group 'y'")
    assert str(error.value).startswith("parts of 'x' in group 'y'") and said in str(error.value)


def test_no_part_lies_outside_its_box() -> None:
    for category in CATALOGUE.values():
        if category.parts and category.parts not in CATALOGUE:
            check_rows(category.parts, category.name, category.size)
    with pytest.raises(AssetError) as error:
        check_rows("arm: box wood x 0:1 y 0:1.5 z 0:1", "'x'", (1.0, 2.0, 1.0))
    assert (
        str(error.value)
        == "parts of 'x', part 'arm': y reaches 1.00 m beyond the thing's 2 m; keep it between 0 and 1."
    )


def test_every_material_has_its_own_look() -> None:
    piece = make_piece("x", "x", "x-0", (1.0, 1.0, 1.0), 0)
    assert len({material_of(name, piece).name for name in MATERIALS if name not in ("cloth", "fabric", "accent")}) > 50
