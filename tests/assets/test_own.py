"""Own meshes: units, axes, colours, bounds; broken and hostile files are refused in clear words."""

import json
import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh

from robolayout._errors import AssetError
from robolayout._reading import LIMITS
from robolayout.assets import CATALOGUE, find_category, import_folder, load_mesh_parts, parts
from robolayout.scene import Asset

SIZE = (0.6, 0.9, 0.8)


def _mesh(size=(0.6, 0.9, 0.8), color=(200, 40, 40, 255)) -> trimesh.Trimesh:
    mesh = trimesh.creation.box(size)
    mesh.visual.face_colors = color
    return mesh


def _bounds(built) -> np.ndarray:
    points = np.concatenate([part.vertices for part in built])
    return np.array([points.min(axis=0), points.max(axis=0)])


@pytest.mark.parametrize("suffix", [".glb", ".obj", ".stl", ".ply"])
def test_every_format_fills_the_box_exactly(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"sofa{suffix}"
    _mesh().export(path)
    built = load_mesh_parts(path, SIZE)
    assert np.abs(_bounds(built) - np.array([[-0.3, -0.45, -0.4], [0.3, 0.45, 0.4]])).max() < 1e-9


def test_the_colour_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "sofa.glb"
    _mesh().export(path)
    red, green, blue = load_mesh_parts(path, SIZE)[0].material.color
    assert red > 0.6 and green < 0.3 and blue < 0.3


def test_a_glb_faces_plus_z_and_its_y_is_up(tmp_path: Path) -> None:
    nose = trimesh.creation.box((0.1, 0.1, 0.1))
    nose.apply_translation((0.0, 0.3, 0.6))
    path = tmp_path / "thing.glb"
    trimesh.util.concatenate([trimesh.creation.box((1.0, 1.0, 1.0)), nose]).export(path)
    points = np.concatenate([part.vertices for part in load_mesh_parts(path, (1.0, 1.0, 1.0))])
    front = points[points[:, 0] > 0.499]
    assert front[:, 2].mean() > 0.2
    assert abs(front[:, 1].mean()) < 1e-6


def test_front_and_up_can_be_given_and_are_checked(tmp_path: Path) -> None:
    path = tmp_path / "thing.stl"
    _mesh((1.0, 2.0, 3.0)).export(path)
    load_mesh_parts(path, (2.0, 1.0, 3.0), up="+z", front="-y")
    with pytest.raises(AssetError, match="no axis"):
        load_mesh_parts(path, SIZE, up="sideways")
    with pytest.raises(AssetError, match="different axes"):
        load_mesh_parts(path, SIZE, up="+z", front="-z")


def test_parts_uses_the_path_of_an_asset(tmp_path: Path) -> None:
    path = tmp_path / "x.glb"
    _mesh().export(path)
    built = parts(Asset("sofa-0", "sofa", SIZE, path=path))
    assert len(built) == 1 and not built[0].convex


@pytest.mark.slow
def test_a_million_triangles_are_thinned(tmp_path: Path) -> None:
    path = tmp_path / "statue.stl"
    grid = np.linspace(-1, 1, 711)
    x, y = np.meshgrid(grid, grid)
    points = np.stack([x.ravel(), y.ravel(), 0.3 * np.cos(5 * x * y).ravel()], axis=1)
    i = np.arange(710 * 711).reshape(710, 711)[:, :-1].ravel()
    faces = np.concatenate([np.stack([i, i + 1, i + 711], 1), np.stack([i + 1, i + 712, i + 711], 1)])
    assert len(faces) > 1_000_000
    trimesh.Trimesh(points, faces, process=False).export(path)
    built = load_mesh_parts(path, SIZE)
    assert 1000 < sum(len(part.faces) for part in built) <= LIMITS.drawn_triangles
    assert np.abs(_bounds(built)[1] - np.array(SIZE) / 2).max() < 1e-9


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("a.glb", b"", "broken"),
        ("a.glb", b"glTF\x02\x00\x00\x00" + b"\xff" * 60, "broken"),
        ("a.glb", b"not a mesh at all, but long enough to be looked at", "no binary glTF"),
        ("a.obj", b"v 1 2\nf 1 2 3\n", "broken|no triangles"),
        ("a.obj", b"# nothing\n", "broken|no triangles"),
        ("a.stl", b"solid x\nendsolid x\n", "broken|no triangles"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 999999999999\nend_header\n", "promises"),
        ("a.fbx", b"Kaydara", "is not read; use one of"),
    ],
)
def test_broken_files_are_explained(tmp_path: Path, name: str, data: bytes, words: str) -> None:
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(AssetError, match=words):
        load_mesh_parts(path, SIZE)


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(AssetError, match=r"gone\.glb cannot be read"):
        load_mesh_parts(tmp_path / "gone.glb", SIZE)


def test_a_file_that_is_too_large_is_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "huge.stl"
    with path.open("wb") as file:
        file.truncate(LIMITS.mesh_bytes + 1)
    with pytest.raises(AssetError, match="100 MB"):
        load_mesh_parts(path, SIZE)


def test_a_glb_that_promises_too_much_is_refused_before_it_is_unpacked(tmp_path: Path) -> None:
    header = json.dumps(
        {"asset": {"version": "2.0"}, "accessors": [{"componentType": 5126, "type": "VEC3", "count": 10**9}]}
    ).encode()
    header += b" " * (-len(header) % 4)
    path = tmp_path / "bomb.glb"
    path.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(header), len(header), 0x4E4F534A) + header)
    with pytest.raises(AssetError, match="promises"):
        load_mesh_parts(path, SIZE)


def test_numbers_that_are_not_finite_are_dropped(tmp_path: Path) -> None:
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n")
    built = load_mesh_parts(path, SIZE)
    assert sum(len(part.faces) for part in built) == 2


def test_a_folder_becomes_a_catalogue(tmp_path: Path) -> None:
    _mesh((930.0, 2100.0, 850.0)).export(tmp_path / "grey_sofa_millimetres.stl")
    _mesh((47.0, 52.0, 88.0)).export(tmp_path / "DiningChair.ply")
    _mesh((1.6, 0.75, 0.9)).export(tmp_path / "dining_table_02.glb")
    (tmp_path / "broken_lamp.glb").write_bytes(b"glTF")
    found = import_folder(tmp_path)
    assets = found["assets"]
    assert [row["path"] for row in found["skipped"]] == ["broken_lamp.glb"]
    assert "broken" in found["skipped"][0]["reason"]
    sofa = assets["grey_sofa_millimetres-0"]
    assert (sofa["category"], sofa["unit"]) == ("sofa", "mm")
    assert sofa["assetMetadata"]["boundingBox"] == {"x": 0.93, "y": 2.1, "z": 0.85}
    assert assets["Dining_Chair-0".lower()]["unit"] == "cm"
    table = assets["dining_table-0"]
    assert table["up"] == "+y"
    assert table["assetMetadata"]["boundingBox"] == {"x": 0.9, "y": 1.6, "z": 0.75}
    assert table["onFloor"] and not table["onWall"]


def test_what_no_word_explains_keeps_its_word_and_is_asked_about(tmp_path: Path) -> None:
    _mesh((0.6, 0.9, 0.6)).export(tmp_path / "mycart.glb")
    found = import_folder(tmp_path)
    entry = found["assets"]["mycart-0"]
    assert entry["category"] == "mycart"
    box = entry["assetMetadata"]["boundingBox"]
    taken = find_category(entry["category"], description=entry["description"], size=(box["x"], box["y"], box["z"]))
    assert taken.group == "unknown"  # and no chair, as "unknown seat" was
    assert "mycart-0 (mycart.glb): what it is" in found["unsure"][0]


def test_files_of_kinds_that_are_not_read_are_named(tmp_path: Path) -> None:
    _mesh().export(tmp_path / "sofa.glb")
    (tmp_path / "armchair.gltf").write_text("{}")
    (tmp_path / "notes.txt").write_text("no mesh")
    found = import_folder(tmp_path)
    assert list(found["assets"]) == ["sofa-0"]
    (skipped,) = found["skipped"]
    assert skipped["path"] == "armchair.gltf"
    assert "format '.gltf' is not read; use one of .glb, .obj, .ply, .stl" in skipped["reason"]


def test_layoutvlm_folders_are_read_as_they_are(tmp_path: Path) -> None:
    uid = "0a1b2c3d4e5f60718293"
    (tmp_path / uid).mkdir()
    _mesh((1.5, 0.8, 0.45)).export(tmp_path / uid / f"{uid}.glb")
    data = {
        "annotations": {"category": "desk", "description": "An oak desk.", "onFloor": True, "onWall": False},
        "assetMetadata": {"boundingBox": {"x": 1.5, "y": 0.6, "z": 0.75}},
    }
    (tmp_path / uid / "data.json").write_text(json.dumps(data))
    entry = import_folder(tmp_path)["assets"]["desk-0"]
    assert entry["assetMetadata"]["boundingBox"] == {"x": 0.6, "y": 1.5, "z": 0.75}
    assert entry["description"] == "An oak desk."
    data["annotations"]["frontView"] = 1
    (tmp_path / uid / "data.json").write_text(json.dumps(data))
    turned = import_folder(tmp_path)["assets"]["desk-0"]
    assert (turned["front"], turned["assetMetadata"]["boundingBox"]) == ("+x", {"x": 1.5, "y": 0.6, "z": 0.75})


AXES = {
    "+z/+x": np.eye(3),
    "+y/+z": np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]]),
    "-x/-y": np.array([[0, 0, -1], [-1, 0, 0], [0, 1, 0]]),
}
"""From depth, width, height to a file's axes, by the file's up and front."""


@pytest.mark.parametrize("way", AXES)
@pytest.mark.parametrize("kind", ["sofa", "office chair", "toilet", "desk"])
def test_axes_are_found_by_likeness(kind: str, way: str, tmp_path: Path) -> None:
    size = tuple(1.1 * edge for edge in CATALOGUE[kind].size)
    pieces = parts(Asset(f"{kind}-0", kind, size), seed=77)  # another variant than those that are compared with
    joined = trimesh.util.concatenate([trimesh.Trimesh(p.vertices @ AXES[way].T, p.faces) for p in pieces])
    joined.export(tmp_path / f"{kind.replace(' ', '_')}.ply")
    (entry,) = import_folder(tmp_path)["assets"].values()
    assert f"{entry['up']}/{entry['front']}" == way
    assert entry["assetMetadata"]["boundingBox"] == pytest.approx(dict(zip("xyz", size, strict=True)), abs=1e-3)


def test_what_is_unsure_is_said_and_corrected_in_one_file(tmp_path: Path) -> None:
    _mesh((4.0, 4.0, 4.0)).export(tmp_path / "blue_armchair.ply")
    found = import_folder(tmp_path)
    (sentence,) = found["unsure"]
    assert "blue_armchair-0 (blue_armchair.ply)" in sentence
    assert "front" in sentence
    assert "corrections.json" in sentence
    said = {
        "blue_armchair.ply": {"up": "+z", "front": "-y", "unit": "m", "size": [0.8, 0.9, 1.0], "category": "armchair"}
    }
    (tmp_path / "corrections.json").write_text(json.dumps(said))
    found = import_folder(tmp_path)
    (entry,) = found["assets"].values()
    assert not found["unsure"]
    assert (entry["up"], entry["front"], entry["unit"]) == ("+z", "-y", "m")
    assert entry["assetMetadata"]["boundingBox"] == {"x": 0.8, "y": 0.9, "z": 1.0}


def test_a_mesh_in_no_unit_is_scaled_to_its_kind(tmp_path: Path) -> None:
    _mesh((2.0, 2.0, 2.0)).export(tmp_path / "mug.ply")
    (entry,) = import_folder(tmp_path)["assets"].values()
    assert (entry["unit"], entry["sure"]["unit"]) == ("none", 0.0)
    assert max(entry["assetMetadata"]["boundingBox"].values()) < 0.2


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ({"sofa.ply": {"up": "top"}}, "corrections.json: sofa.ply: up 'top' is none of"),
        ({"sofa.ply": {"axis": "+z"}}, "corrections.json: sofa.ply has an unknown field 'axis'; known: category"),
        ({"sofa.ply": {"size": [1, 2]}}, "corrections.json: sofa.ply: size"),
        ({"sofa.ply": {"up": "+z", "front": "-z"}}, "must be different axes"),
        ({"sfa.ply": {}}, "corrects 'sfa.ply', which is no mesh of this folder; nearest: 'sofa.ply'"),
    ],
)
def test_corrections_that_cannot_be_are_explained(said: object, message: str, tmp_path: Path) -> None:
    _mesh((0.9, 2.0, 0.8)).export(tmp_path / "sofa.ply")
    (tmp_path / "corrections.json").write_text(json.dumps(said))
    try:
        reasons = [row["reason"] for row in import_folder(tmp_path)["skipped"]]
    except AssetError as error:
        reasons = [str(error)]
    assert any(message in reason for reason in reasons), reasons


def test_bad_metadata_and_bad_folders_are_explained(tmp_path: Path) -> None:
    with pytest.raises(AssetError, match="does not exist"):
        import_folder(tmp_path / "nowhere")
    with pytest.raises(AssetError, match="holds no mesh"):
        import_folder(tmp_path)
    (tmp_path / "u").mkdir()
    _mesh().export(tmp_path / "u" / "u.glb")
    (tmp_path / "u" / "data.json").write_text('{"annotations": {}}')
    assert 'u/data.json has no "assetMetadata"; add it.' in import_folder(tmp_path)["skipped"][0]["reason"]


def test_links_out_of_the_folder_are_not_followed(tmp_path: Path) -> None:
    inside = tmp_path / "in"
    inside.mkdir()
    _mesh().export(tmp_path / "outside.glb")
    (inside / "link.glb").symlink_to(tmp_path / "outside.glb")
    with pytest.raises(AssetError, match="holds no mesh"):
        import_folder(inside)


def test_of_too_many_colours_the_smallest_take_the_nearest_one(tmp_path: Path) -> None:
    scene = trimesh.Scene()
    for number in range(100):  # fifty reds at the left, fifty blues at the right
        shade = 150 + number
        block = _mesh((0.01, 0.01, 0.01), (shade, 0, 0, 255) if number < 50 else (0, 0, shade, 255))
        block.apply_translation((number / 100, 0.0, 0.0))
        scene.add_geometry(block)
    scene.export(tmp_path / "books.glb")
    built = load_mesh_parts(tmp_path / "books.glb", (0.01, 1.0, 0.01))
    assert len(built) <= 64
    for part in built:
        red, _, blue = part.material.color[:3]
        where = part.vertices[:, 1]
        assert where.max() < 1e-6 if red > blue else where.min() > -1e-6


@pytest.mark.parametrize("name", ["диван", "Bücherregal"])
def test_names_of_files_keep_their_letters(tmp_path: Path, name: str) -> None:
    _mesh().export(tmp_path / f"{name}_01.stl")
    ((key, entry),) = import_folder(tmp_path)["assets"].items()
    assert name.lower() in key.lower() or name.lower() in entry["category"].lower()
