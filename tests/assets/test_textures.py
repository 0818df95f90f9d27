"""Textures: seamless tiles of one brightness, laid on in metres; pictures of own meshes stay."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image

from robolayout.assets import Material, Part, load_mesh_parts
from robolayout.assets.palette import PALETTES, PLAIN
from robolayout.assets.rooms import STYLES
from robolayout.assets.shapes import box
from robolayout.assets.textures import TILE, TILES, coordinates, media_type, picture, pixels


def linear(srgb: np.ndarray) -> np.ndarray:
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


@pytest.mark.parametrize("name", TILES)
def test_a_tile_has_the_mean_that_colours_make_up_for(name: str) -> None:
    assert linear(pixels(name) / 255).mean() == pytest.approx(TILE.mean, rel=0.02)


@pytest.mark.parametrize("name", TILES)
@pytest.mark.parametrize("axis", [0, 1])
def test_a_tile_has_no_seam(name: str, axis: int) -> None:
    values = pixels(name)[..., 0].astype(float)
    steps = np.abs(np.diff(np.concatenate([values, values.take([0], axis)], axis), axis=axis)).mean(axis=1 - axis)
    assert steps[-1] <= 1.5 * steps.max() or steps[-1] <= steps.mean() + 3 * steps.std()
    assert steps[-1] <= max(2.0, 1.25 * np.sort(steps)[-len(steps) // 8 :].mean())


@pytest.mark.parametrize("name", TILES)
def test_a_tile_is_small_in_a_file(name: str) -> None:
    assert media_type(picture(name)) == "image/jpeg"
    assert len(picture(name)) < 40_000


def test_every_material_names_a_tile_that_there_is() -> None:
    looks = [*PLAIN.values(), *(m for style in STYLES for m in (*style.tones, style.wall, style.trim, style.door))]
    looks += [m for p in PALETTES for m in (p.wood, p.wood_dark, p.front, p.metal, *p.fabrics, *p.accents, *p.bedding)]
    assert {look.texture for look in looks} - {None} <= set(TILES)


def test_tiles_lie_in_metres_with_the_grain_along_the_board() -> None:
    board = box("board", Material("oak", (0.8, 0.6, 0.4), texture="wood"), (0, 0.2), (0, 1.6), (0, 0.02))
    places, corners = coordinates(board).astype(float), board.vertices[board.faces]
    one, two = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]
    flat = np.abs(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]) / 2 * TILES["wood"].metres ** 2
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    assert flat == pytest.approx(area, rel=1e-4)
    upper = (corners[:, :, 2] > 0.019).all(axis=1)
    assert np.ptp(places[upper][..., 0]) == pytest.approx(1.6 / TILES["wood"].metres, rel=1e-4)


@pytest.fixture
def checkered(tmp_path: Path) -> Path:
    """A box in a GLB file, red on its top and blue below by one picture."""
    image = Image.fromarray(np.repeat([[[200, 20, 20]], [[20, 20, 200]]], 8, axis=1).repeat(8, axis=0).astype(np.uint8))
    mesh = trimesh.creation.box((1, 1, 1))
    mesh.unmerge_vertices()
    up = mesh.face_normals[:, 1].repeat(3) > 0.5  # glTF counts y upwards
    uv = np.column_stack([np.full(len(up), 0.5), np.where(up, 0.75, 0.25)])
    look = trimesh.visual.material.PBRMaterial(baseColorTexture=image, roughnessFactor=0.3, metallicFactor=0.0)
    mesh.visual = trimesh.visual.TextureVisuals(uv=uv, material=look)
    path = tmp_path / "box.glb"
    path.write_bytes(trimesh.Scene(mesh).export(file_type="glb"))
    return path


def test_an_own_mesh_keeps_its_picture_and_where_it_lies(checkered: Path) -> None:
    (part,) = load_mesh_parts(checkered, (0.5, 0.6, 0.7))
    assert isinstance(part.material.texture, bytes)
    assert part.material.roughness == pytest.approx(0.3)
    shown = pixels(part.material.texture)
    assert part.material.color == pytest.approx((0.57, 0.08, 0.57), abs=0.03)  # half red, half blue, in linear light
    places = coordinates(part).mean(axis=1)
    row = np.clip((places[:, 1] * shown.shape[0]).astype(int), 0, shown.shape[0] - 1)
    colors = shown[row, shown.shape[1] // 2].astype(int)
    upper = (part.vertices[part.faces][..., 2] > 0.34).all(axis=1)
    assert upper.sum() == 2
    assert (colors[upper, 0] > 150).all()
    assert (colors[~upper, 2] > 150).all()


def test_a_thinned_mesh_keeps_its_picture(tmp_path: Path) -> None:
    ball = trimesh.creation.uv_sphere(count=[180, 180])
    uv = np.column_stack(
        [np.arctan2(ball.vertices[:, 1], ball.vertices[:, 0]) / 6.3 + 0.5, ball.vertices[:, 2] / 2 + 0.5]
    )
    look = trimesh.visual.material.PBRMaterial(baseColorTexture=Image.new("RGB", (8, 8), (10, 200, 10)))
    ball.visual = trimesh.visual.TextureVisuals(uv=uv, material=look)
    path = tmp_path / "ball.glb"
    path.write_bytes(trimesh.Scene(ball).export(file_type="glb"))
    (part,) = load_mesh_parts(path, (1, 1, 1))
    assert len(part.faces) <= 20_000
    assert part.uv is not None
    assert len(part.uv) == len(part.vertices)


@pytest.mark.slow
def test_a_large_picture_is_made_smaller(tmp_path: Path) -> None:
    mesh = trimesh.creation.box((1, 1, 1))
    look = trimesh.visual.material.PBRMaterial(baseColorTexture=Image.new("RGB", (3000, 1500), (9, 9, 9)))
    mesh.visual = trimesh.visual.TextureVisuals(uv=np.zeros((8, 2)), material=look)
    path = tmp_path / "box.glb"
    path.write_bytes(trimesh.Scene(mesh).export(file_type="glb"))
    (part,) = load_mesh_parts(path, (1, 1, 1))
    assert isinstance(part.material.texture, bytes)
    with Image.open(io.BytesIO(part.material.texture)) as found:
        assert found.size == (1024, 512)


def test_plain_parts_have_no_places() -> None:
    part = Part("p", np.eye(3), np.array([[0, 1, 2]], np.int32), Material("red", (1, 0, 0)))
    assert not coordinates(part).any()
