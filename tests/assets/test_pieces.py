"""What the solver takes to stand in a body's way: the same as the judge, worked out by other code, for every category."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely

from robolayout.assets import CATALOGUE
from robolayout.assets.obstacles import blocks, pieces
from robolayout.scene import Agent, Asset, load_agent
from robolayout.verify._obstacles import part_rectangles

BODIES = [load_agent(name) for name in ("robot_vacuum", "cat", "dog_medium", "child_6", "wheelchair", "adult")]
TABLE = Asset("dining_table-0", "dining table", (0.9, 1.6, 0.75))


def shape(rectangles: np.ndarray) -> shapely.Geometry:
    x, y, hx, hy = rectangles.T
    return shapely.union_all(shapely.box(x - hx, y - hy, x + hx, y + hy))


@pytest.mark.parametrize("body", BODIES, ids=lambda body: body.name)
def test_solver_and_judge_see_the_same_of_every_category(body: Agent) -> None:
    for category in CATALOGUE.values():
        asset = Asset(f"{category.name.replace(' ', '_')}-0", category.name, category.size)
        z = category.size[2] / 2
        found, passable = pieces(asset, z, body)
        if not blocks(asset, z, body):
            assert len(found) == 0 and not passable
            continue
        theirs = part_rectangles(asset, body.step, body.height)
        assert passable is (theirs is not None), category.name
        if theirs is None:
            assert found.tolist() == [[0.0, 0.0, category.size[0] / 2, category.size[1] / 2]]
        else:
            assert shape(found).symmetric_difference(shapely.union_all(shapely.box(*theirs.T))).area < 1e-9


def test_what_hangs_lower_than_a_body_by_rounding_alone_is_not_in_its_way() -> None:
    found, _ = pieces(TABLE, BODIES[-1].height + TABLE.size[2] / 2 - 5e-7, BODIES[-1])
    assert found.shape == (0, 4)


@pytest.mark.parametrize("joined", [True, False])
def test_an_own_mesh_is_cut_as_the_judge_cuts_it_to_a_centimetre(tmp_path: Path, joined: bool) -> None:
    import trimesh

    def block(size: tuple[float, ...], at: tuple[float, ...]) -> trimesh.Trimesh:
        return trimesh.creation.box(size, trimesh.transformations.translation_matrix(at))

    legs = [block((0.06, 0.65, 0.08), (x, 0.325, z)) for x in (-0.57, 0.57) for z in (-0.36, 0.36)]
    made = [block((1.2, 0.05, 0.8), (0, 0.675, 0)), *legs, block((1.1, 0.05, 0.05), (0, 0.5, 0))]
    mesh = trimesh.util.concatenate(made) if joined else trimesh.Scene(made)
    mesh.export(tmp_path / "table.glb")
    table = replace(TABLE, size=(0.8, 1.2, 0.7), path=tmp_path / "table.glb")
    for body in (BODIES[0], BODIES[1], Agent("taller", 0.2, 0.6)):
        found, passable = pieces(table, 0.35, body)
        theirs = part_rectangles(table, body.step, body.height)
        assert passable and theirs is not None and len(found) == len(theirs) in (4, 5)
        union = shapely.union_all(shapely.box(*theirs.T))
        assert union.buffer(0.015).covers(shape(found)) and shape(found).buffer(0.015).covers(union)


def test_a_mesh_that_cannot_be_read_stands_as_its_box(tmp_path: Path) -> None:
    found, passable = pieces(replace(TABLE, path=tmp_path / "none.glb"), 0.375, BODIES[1])
    assert not passable and found.tolist() == [[0.0, 0.0, 0.45, 0.8]]
