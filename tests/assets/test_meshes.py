"""Parametric furniture: fills its box, convex, closed, no flickering faces, deterministic, whatever the category and size."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from geometry_laws import bounds, dent, flicker, is_closed
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import Polygon, unary_union

from robolayout.assets import CATALOGUE, Material, parts
from robolayout.assets.category import Category
from robolayout.assets.meshes import builder_for, fit
from robolayout.assets.palette import CLOTHS, COLORS, PALETTES, STYLED, WOODS, make_piece
from robolayout.scene import Asset

FLICKER = 4e-4
"""Largest overlap of coplanar faces that may hide inside joints, m2."""
MAX_TRIANGLES = 200
SRC = Path(__file__).parents[2] / "src"


def _built(category: Category, size: tuple[float, float, float], seed: int):
    piece = make_piece(category.name, category.name, f"{category.name}-0", size, seed)
    return fit(builder_for(category)(piece), size)


@pytest.mark.parametrize("name", CATALOGUE)
def test_every_category_obeys_the_laws_of_meshes(name: str) -> None:
    category = CATALOGUE[name]
    built = _built(category, category.size, seed=len(name))
    half = np.array(category.size) / 2
    assert np.abs(bounds(built) - np.array([-half, half])).max() < 1e-9
    for part in built:
        assert part.convex
        assert is_closed(part), part.name
        assert dent(part) < 1e-6, part.name
        assert len(part.faces) <= MAX_TRIANGLES, part.name
    assert [row for row in flicker(built) if row[2] > FLICKER] == []


@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(sorted(CATALOGUE)),
    st.tuples(*[st.floats(0.25, 4.0)] * 3),
    st.integers(0, 40),
)
def test_odd_sizes_still_fill_the_box_with_finite_convex_parts(name, factors, seed) -> None:
    category = CATALOGUE[name]
    size = tuple(edge * factor for edge, factor in zip(category.size, factors, strict=True))
    built = _built(category, size, seed)
    half = np.array(size) / 2
    assert np.abs(bounds(built) - np.array([-half, half])).max() < 1e-9
    for part in built:
        assert np.isfinite(part.vertices).all()
        assert part.faces.min() >= 0 and part.faces.max() < len(part.vertices)


@pytest.mark.slow
def test_same_asset_and_seed_give_the_same_bytes_in_another_process() -> None:
    script = (
        "import hashlib\n"
        "from robolayout.assets import parts\n"
        "from robolayout.scene import Asset\n"
        "h = hashlib.sha256()\n"
        "for n, s in (('bookshelf', (.3, .9, 1.8)), ('plant', (.5, .5, 1.1)), ('sofa', (.9, 2., .8))):\n"
        "    for p in parts(Asset(n + '-0', n, s), 7):\n"
        "        h.update(p.vertices.tobytes() + p.faces.tobytes() + repr(p.material).encode())\n"
        "print(h.hexdigest())\n"
    )
    outputs = {
        subprocess.run(
            [sys.executable, "-c", script],
            env={"PYTHONPATH": str(SRC), "PYTHONHASHSEED": salt, "PATH": ""},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for salt in ("1", "2")
    }
    assert len(outputs) == 1


def test_the_seed_changes_the_look_and_chairs_of_one_list_match() -> None:
    chairs = [Asset(f"chair-{i}", "chair", (0.5, 0.5, 0.9)) for i in range(2)]
    first, second = (parts(chair, 3) for chair in chairs)
    assert [p.material for p in first] == [p.material for p in second]
    looks = {tuple(p.material.name for p in parts(chairs[0], seed)) for seed in range(8)}
    assert len(looks) > 2


def test_a_bed_has_its_head_at_the_back_and_a_sofa_its_back() -> None:
    bed = {p.name: p.vertices for p in parts(Asset("bed-0", "bed", (2.1, 1.6, 1.0)), 0)}
    assert bed["headboard"][:, 0].max() < bed["duvet"][:, 0].min()
    assert bed["pillow"][:, 0].mean() < -0.5
    sofa = {p.name: p.vertices for p in parts(Asset("sofa-0", "sofa", (0.9, 2.0, 0.8)), 0)}
    assert sofa["backrest"][:, 0].mean() < -0.3


def test_a_table_top_is_at_the_top_so_that_plates_stand_on_it() -> None:
    for seed in range(12):
        table = parts(Asset("dining_table-0", "dining table", (0.9, 1.6, 0.75)), seed)
        top = [p for p in table if abs(p.vertices[:, 2].max() - 0.375) < 1e-9]
        assert [p.name for p in top] == ["top"]


SUPPORTS = (
    "night stand", "dresser", "dining table", "round table", "coffee table", "side table", "console table", "sideboard",
    "bar cart", "desk", "standing desk", "corner desk", "conference table", "filing cabinet", "tv stand", "cabinet",
    "kitchen counter", "kitchen island", "student desk", "lab bench", "display table", "display case",
    "checkout counter", "wrapping table", "prep table", "buffet table", "bar counter", "overbed table", "medical cart",
    "workbench", "tool chest", "kids table", "chess table", "shelving unit", "bookshelf",
)  # fmt: skip


@pytest.mark.parametrize("name", SUPPORTS)
def test_what_stands_on_it_does_not_float(name: str) -> None:
    category = CATALOGUE[name]
    depth, width, height = category.size
    for seed in range(6):
        built = _built(category, category.size, seed)
        corners = [t for part in built for t in part.vertices[part.faces]]
        top = [Polygon(t[:, :2]) for t in corners if (t[:, 2] > height / 2 - 0.004).all()]
        assert unary_union([t for t in top if t.area > 1e-9]).area > 0.6 * depth * width


def test_an_unknown_thing_is_a_plain_neat_box() -> None:
    built = parts(Asset("zorblax-0", "zorblax", (0.7, 0.6, 0.5)), 0)
    assert 1 <= len(built) < 20


def test_materials_are_in_range() -> None:
    for palette in PALETTES:
        for material in (palette.wood, palette.wood_dark, palette.front, *palette.fabrics, *palette.accents):
            assert all(0.0 <= channel <= 1.0 for channel in material.color)


@pytest.mark.parametrize(
    ("kind", "look", "color"),
    [
        ("armchair", "bohemian, blue", COLORS["blue"]),
        ("wardrobe", "industrial, white", COLORS["white"]),
        ("coffee table", "oak, walnut", WOODS["walnut"]),
        ("sofa", "scandinavian, leather", CLOTHS["leather"]),
        ("bookshelf", "scandinavian", STYLED["scandinavian"].wood),
    ],
)
def test_a_look_settles_what_a_thing_is_made_of(kind: str, look: str, color: Material) -> None:
    depth, width, height = CATALOGUE[kind].size
    asset = Asset("x-0", kind, (depth, width, height), metadata={"look": look})
    one, other = ({part.material.color for part in parts(asset, seed)} for seed in (0, 3))
    assert color.color in one and color.color in other


def test_a_look_that_says_nothing_changes_nothing() -> None:
    plain, odd = (Asset("sofa-0", "sofa", (0.9, 2.0, 0.8), metadata=look) for look in ({}, {"look": "made of cheese"}))
    assert [part.material for part in parts(plain, 2)] == [part.material for part in parts(odd, 2)]
