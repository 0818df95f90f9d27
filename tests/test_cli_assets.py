"""`robolayout assets`: listing, looking up, drawing, importing, and what is said of bad input."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
import trimesh
from PIL import Image

from running import Ran

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"


def test_a_group_is_listed_with_sizes_and_sources(command: Callable[..., Ran]) -> None:
    lines = command("assets", "structure").out
    assert "sauna" in lines
    assert "typical of common goods" in lines
    assert "sofa" not in lines


def test_what_is_listed_is_drawn(tmp_path: Path, command: Callable[..., Ran]) -> None:
    sheet = tmp_path / "textiles.png"
    assert command("assets", "textiles", "--pictures", sheet).code == 0
    with Image.open(sheet) as picture:
        assert picture.size == (600, 450)
        assert len(picture.convert("RGB").getcolors(200_000) or ()) > 100


def test_an_import_names_what_it_skips(tmp_path: Path, command: Callable[..., Ran]) -> None:
    folder = tmp_path / "meshes"
    folder.mkdir()
    (folder / "desk.obj").write_text(TRIANGLE)
    (folder / "broken.glb").write_bytes(b"glTF")
    ran = command("assets", "import", folder, "--front=-x", "--up=+y", "--out", tmp_path / "own.json")
    assert ran.code == 0
    assert "skipped broken.glb: mesh broken.glb is broken and cannot be used: it ends within" in ran.err
    desk = json.loads((tmp_path / "own.json").read_text())["assets"]["desk-0"]
    assert (desk["front"], desk["up"]) == ("-x", "+y")
    (folder / "desk.obj").unlink()
    nothing = command("assets", "import", folder, "--out", tmp_path / "none.json")
    assert (nothing.code, (tmp_path / "none.json").exists()) == (2, False)
    assert "none of the 1 meshes in 'meshes' can be used" in nothing.err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("import",), "import needs a folder"),
        (("import", "nowhere"), "asset folder 'nowhere' does not exist"),
        (("import", ".", "--front", "up"), "unknown axis 'up'. Known: +x, +y, +z, -x, -y, -z"),
        (("old", "couch"), "put a name of several words in quotes"),
        (("desk", "--pictures", "desk.jpg"), "name a file that ends in .png"),
    ],
)
def test_bad_input_is_refused_in_words(
    words: tuple[str, ...], said: str, command: Callable[..., Ran], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = command("assets", *words)
    assert ran.code == 2
    assert said in ran.err


def test_words_name_meshes_of_ones_own(tmp_path: Path, command: Callable[..., Ran]) -> None:
    own, out = tmp_path / "own", tmp_path / "out"
    own.mkdir()
    trimesh.creation.icosphere(radius=0.3).export(own / "gizmo.ply")
    trimesh.creation.box((0.5, 0.45, 0.9)).export(own / "WoodChair.ply")
    told = {"WoodChair.ply": {"up": "+z", "front": "+x", "unit": "m"}}
    (own / "corrections.json").write_text(json.dumps(told))
    words = "a room with two gizmos in a corner and a wood chair by the door"
    ran = command("generate", words, "--asset-dir", own, "--out", out, "--no-pictures")
    assert ran.code == 0, ran.err
    assert "Wished: 2 gizmo, 1 Wood Chair." in ran.err
    assets = json.loads((out / "scene.json").read_text())["assets"]
    meshes = {
        name: (Path(entry["path"]).name, entry["assetMetadata"]["boundingBox"])
        for name, entry in assets.items()
        if "path" in entry
    }
    ball = ("gizmo.ply", {"x": 0.6, "y": 0.6, "z": 0.6})
    chair = ("WoodChair.ply", {"x": 0.5, "y": 0.45, "z": 0.9})
    assert meshes == {"gizmo-0": ball, "gizmo-1": ball, "wood_chair-0": chair}
    asked = json.loads((out / "report.json").read_text())["asked"]
    assert {row["verdict"] for row in asked} == {"met"} and len(asked) >= 4, asked
    nowhere = command("generate", words, "--asset-dir", tmp_path / "nowhere", "--out", out)
    assert (nowhere.code, "asset folder 'nowhere' does not exist" in nowhere.err) == (2, True)
