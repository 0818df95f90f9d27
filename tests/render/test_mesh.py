"""The triangle soup behind both renderers."""

import numpy as np
import pytest

from robolayout._color import linear
from robolayout.assets import Material, Part
from robolayout.render._mesh import merge, parts_mesh, refined, scene_mesh, welded
from robolayout.render._rays import encode, sky_directions

PAINT = Material("paint", (0.5, 0.5, 0.5))


def cylinder(sides=24):
    angles = np.arange(sides) * 2 * np.pi / sides
    ring = np.column_stack([np.cos(angles), np.sin(angles)])
    vertices = np.concatenate([np.column_stack([ring, np.full(sides, z)]) for z in (0.0, 1.0)])
    i, j = np.arange(sides), (np.arange(sides) + 1) % sides
    sides_faces = np.concatenate([np.column_stack([i, j, j + sides]), np.column_stack([i, j + sides, i + sides])])
    caps = [(0, k + 1, k) for k in range(1, sides - 1)] + [
        (sides, sides + k, sides + k + 1) for k in range(1, sides - 1)
    ]
    return Part("cylinder", vertices, np.array([*sides_faces, *caps], dtype=np.int32), PAINT)


def test_round_things_are_smooth_and_edges_stay_sharp():
    mesh = parts_mesh([cylinder()], "c")
    normals = mesh.normals.reshape(-1, 3)
    corners = mesh.corners.reshape(-1, 3)
    side = np.abs(normals[:, 2]) < 0.5
    assert np.allclose(normals[side, :2], corners[side, :2], atol=0.06)
    assert np.allclose(np.abs(normals[~side, 2]), 1.0, atol=1e-5)


def test_refining_keeps_area_and_shortens_edges():
    mesh = parts_mesh([cylinder(6)], "c")
    fine = refined(mesh, 0.3)

    def area(m):
        return (
            np.linalg.norm(np.cross(m.corners[:, 1] - m.corners[:, 0], m.corners[:, 2] - m.corners[:, 0]), axis=1).sum()
            / 2
        )

    assert area(fine) == pytest.approx(area(mesh), rel=1e-5)
    edges = np.linalg.norm(np.roll(fine.corners, -1, axis=1) - fine.corners, axis=2)
    assert edges.max() < 0.6 and len(fine) > len(mesh)
    assert len(refined(mesh, 0.001, most=500)) <= 500


def test_welding_finds_every_corner_again():
    mesh = refined(parts_mesh([cylinder()], "c"), 0.3)
    first, place = welded(mesh)
    assert np.allclose(mesh.corners.reshape(-1, 3)[first][place], mesh.corners, atol=1e-4)
    assert len(first) < 3 * len(mesh) / 2


def test_assets_stand_where_the_pose_says(bedroom, layout):
    mesh = scene_mesh(bedroom, layout)
    number = [a.name for a in bedroom.assets].index("wardrobe-0") + 1
    points = mesh.corners[mesh.ids == number].reshape(-1, 3)
    corners = np.array(layout["wardrobe-0"].corners((0.6, 1.6, 2.1)))
    assert np.allclose(points.min(axis=0), [*corners.min(axis=0), 0.0], atol=1e-4)
    assert np.allclose(points.max(axis=0), [*corners.max(axis=0), 2.1], atol=1e-4)


def test_merging_keeps_names_apart():
    both = merge(parts_mesh([cylinder()], "a"), parts_mesh([cylinder()], "b", 2))
    assert both.named(["b"]).sum() == (both.ids == 2).sum() > 0


def test_colours_pass_through_srgb_unchanged():
    values = np.linspace(0, 0.85, 20)
    assert np.allclose(encode(linear(values).astype(np.float32)), values, atol=2e-3)


def test_the_open_sky_lights_a_floor_with_one():
    directions = sky_directions()
    assert np.linalg.norm(directions, axis=1) == pytest.approx(1.0, abs=1e-5)
    assert 2 / len(directions) * directions[:, 2].sum() == pytest.approx(1.0, abs=0.1)
