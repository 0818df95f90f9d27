"""Every reader with good files of its kind, and how it is asked to read one."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from fuzz_mutations import as_glb, as_json, as_toml, glb_parts
from PIL import Image

from hostile_names import hostile_scene
from robolayout._errors import AssetError
from robolayout.export import EXPORTERS, to_bytes
from robolayout.scene import Layout, Pose, load_agent, load_layout, load_scene, scene_from_dict, scene_to_dict
from running import ROOT

Read = Callable[[Path], object]


@dataclass(frozen=True)
class Reader:
    """One reader.

    Attributes:
        name: What it reads.
        suffix: End of the file's name.
        seeds: Good files: trees, header and chunk of a GLB, or bytes.
        write: What makes bytes of a tree; None where the seeds are bytes.
        read: Reads the file; whatever is not a RoboLayoutError is a defect.
        cost: How many times as long as the others it takes; it gets so many fewer inputs.
    """

    name: str
    suffix: str
    seeds: Callable[[], list[Any]]
    write: Callable[[Any], bytes] | None
    read: Read
    cost: int = 1


def _json_file(*parts: str) -> Any:
    return json.loads(ROOT.joinpath(*parts).read_text(encoding="utf-8"))


def _scenes() -> list[Any]:
    small = hostile_scene()
    small["assets"] = dict(list(small["assets"].items())[:4])
    bedroom = _json_file("examples", "bedroom.json")
    bedroom["assets"] = dict(list(bedroom["assets"].items())[:5])
    agent = {"name": "cart", "radius": 0.3, "height": 1.0, "reach": {"value": 0.5, "source": "mine", "verified": True}}
    window = [{"wall": 2, "offset": 1.0, "width": 1.2, "height": 1.2, "sill": 0.9}]
    return [bedroom, small | {"agent": agent, "windows": window, "doors": [{"wall": 0, "offset": 0.1, "width": 0.9}]}]


def _read_scene(path: Path) -> object:
    scene = load_scene(path)
    return json.dumps(scene_to_dict(scene), ensure_ascii=False, allow_nan=False).encode()


@cache
def _room() -> tuple[Any, Layout]:
    scene = scene_from_dict(_scenes()[0])
    return scene, Layout(
        {asset.name: Pose(1.0 + i, 2.0, asset.size[2] / 2, 0.5) for i, asset in enumerate(scene.assets)}
    )


def _read_layout(path: Path) -> object:
    return json.dumps(load_layout(path, _room()[0]).to_dict(), allow_nan=False)


def _tomls(*parts: str, count: int = 4) -> list[Any]:
    files = sorted(ROOT.joinpath("src", "robolayout", *parts).glob("[a-z]*.toml"))
    return [tomllib.loads(path.read_text(encoding="utf-8")) for path in files[:: max(1, len(files) // count)]]


def _knowledge() -> list[Any]:
    thing = {"name": "harp", "like": "stool", "words": ["lyre"], "size": [0.5, 0.9, 1.7], "place": ["floor"]}
    role = {
        "name": "harp", "names": ["harp"], "stands": ["corner", "wall"],
        "prefer": {"window": 1.0, "near bed": 2.0}, "clear": {"front": 0.9},
        "joins": [{"slot": "beside", "of": ["armchair"], "gap": 0.3, "say": ["next_to({a}, {b})"]}],
        "say": {"wall": ["against_wall({a}, {wall})"]}, "face": {"roles": ["bed"], "distance": [1.0, 4.0]},
    }  # fmt: skip
    rooms = {"music room": {"size": [4.0, 5.0], "base": {"harp": 1, "chair": 2}, "words": ["music"]}}
    own = {
        "label": "music",
        "order": 40,
        "why": "sound",
        "thing": [thing],
        "role": [role],
        "rooms": rooms,
    }
    return [own, {"label": "x", "thing": [thing]}]


def _read_knowledge(path: Path) -> object:
    from robolayout.planners import OfflinePlanner

    return OfflinePlanner([path])


def _catalogue() -> list[Any]:
    box = {"boundingBox": {"x": 0.5, "y": 0.5, "z": 0.9}}
    return [{"assets": {"oak_chair-0": {"category": "chair", "onFloor": True, "assetMetadata": box}}, "skipped": []}]


def _read_catalogue(path: Path) -> object:
    data = {**_scenes()[0], "catalogue": path.name, "assets": {"chair-0": {"from": "oak_chair-0"}}}
    return scene_to_dict(scene_from_dict(data, base=path.parent))


def _metadata() -> list[Any]:
    box = {"boundingBox": {"x": 1.5, "y": 0.6, "z": 0.75}}
    notes = {"category": "desk", "description": "An oak desk.", "onFloor": True, "onWall": False, "frontView": 1}
    return [{"annotations": notes, "assetMetadata": box}]


def _read_metadata(path: Path) -> object:
    from robolayout.scene._asset_io import look_up

    path.rename(path.with_name("data.json"))
    return look_up([f"{path.parent.name}-0"], path.parent.parent)


def _read_folder(path: Path) -> object:
    from robolayout.assets import import_folder

    (path.parent / f"{path.parent.name}.stl").write_bytes(_mesh_bytes("stl"))
    path.rename(path.with_name("data.json"))
    found = import_folder(path.parent)
    if found["skipped"]:
        raise AssetError(found["skipped"][0]["reason"])
    return json.dumps(found, allow_nan=False).encode()


def _exchanges() -> list[Any]:
    folder = ROOT / "tests" / "planners" / "recordings"
    first = json.loads(next(iter(sorted(folder.rglob("plan*.json")))).read_text(encoding="utf-8"))
    tool = {"kind": "tool-call", "content": "{}", "tool": "final_result"}
    usage = {"input_tokens": 10, "output_tokens": 20, "cost": "0.0045"}
    answer = {"parts": [tool], "model": "m", "finish_reason": "stop", "usage": usage}
    request = {"instructions": "", "texts": [], "images": [], "feedback": ""}
    return [first, first | {"answer": answer, "request": request}, first | {"answer": None, "failure": "no answer"}]


def _read_exchange(path: Path) -> object:
    from robolayout.planners.model.client import from_answer
    from robolayout.planners.model.exchange import read_exchanges

    entries = read_exchanges(path.parent)
    return [from_answer(entry["answer"]) for entry in entries.values() if entry["answer"]]


def _urdfs() -> list[Any]:
    box = '<collision><origin xyz="0 0 0.1" rpy="0 0 0"/><geometry><box size="0.5 0.4 0.2"/></geometry></collision>'
    can = '<collision><geometry><cylinder radius="0.2" length="0.5"/></geometry></collision>'
    mesh = '<collision><geometry><mesh filename="part.stl" scale="1 1 1"/></geometry></collision>'
    joint = '<joint name="j" type="fixed"><origin xyz="0 0 0.3"/><parent link="base"/><child link="arm"/></joint>'
    text = f'<robot name="r"><link name="base">{box}{can}</link><link name="arm">{mesh}</link>{joint}</robot>'
    return [text.encode()]


def _read_urdf(path: Path) -> object:
    (path.parent / "part.stl").write_bytes(_mesh_bytes("stl"))
    return load_agent(path)


@cache
def _mesh_bytes(kind: str) -> bytes:
    box = trimesh.creation.box((0.6, 1.2, 0.7))
    data = box.export(file_type=kind)
    return data.encode() if isinstance(data, str) else data


def _glbs() -> list[Any]:
    plain = trimesh.creation.box((0.6, 1.2, 0.7))
    plain.visual.face_colors = (200, 40, 40, 255)
    picture = Image.fromarray(np.arange(192, dtype=np.uint8).reshape(8, 8, 3))
    textured = trimesh.creation.box((0.3, 0.2, 0.1))
    uv = np.zeros((len(textured.vertices), 2))
    material = trimesh.visual.material.PBRMaterial(baseColorTexture=picture, baseColorFactor=[255, 200, 100, 255])
    textured.visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    scene = trimesh.Scene({"a": plain, "b": textured})
    return [glb_parts(scene.export(file_type="glb")), glb_parts(_mesh_bytes("glb"))]


def _meshes(kind: str) -> list[Any]:
    seeds = [_mesh_bytes(kind)]
    if kind == "ply":
        seeds.append(trimesh.creation.box((1, 1, 1)).export(file_type="ply", encoding="ascii"))
    if kind == "stl":
        seeds.append(trimesh.creation.box((1, 1, 1)).export(file_type="stl_ascii").encode())
    if kind == "obj":
        seeds.append(b"mtllib /etc/x.mtl\no a\nv 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl m\ng x\nf 1/1/1 2/1/1 3/1/1\nf -1 -2 -3\n")  # fmt: skip  # noqa: E501
    return seeds


def _read_mesh(path: Path) -> object:
    from robolayout.assets import load_mesh_parts

    return load_mesh_parts(path, (0.6, 0.9, 0.8))


def _programs() -> list[Any]:
    text = (
        "for i in range(3):\n    x = [i * 0.5, math.sin(i), len(walls)]\n"
        "double_bed[0].position = [2, 1, 0.3]\ndouble_bed[0].rotation = [90]\n"
        'solver.against_wall(double_bed[0], walls[2])\nsolver.next_to(night_stand[0], double_bed[0], "left")\n'
    )
    answer = f"Here it is:\n```python\n{text}```\nThat is all."
    return [text.encode(), answer.encode()]


def _read_program(path: Path) -> object:
    from robolayout.program import read_program, reconcile
    from robolayout.run.given import as_text

    scene = _room()[0]
    return reconcile(read_program(as_text(path), scene), scene).to_dict()


def _exported(name: str) -> Callable[[], list[Any]]:
    def seeds() -> list[Any]:
        scene, layout = _room()
        data = to_bytes(scene, layout, name, partial=True)
        return (
            [glb_parts(data)]
            if name == "glb"
            else [json.loads(data)]
            if EXPORTERS[name].suffix.endswith("json")
            else [data]
        )

    return seeds


def _read_export(name: str) -> Read:
    read = EXPORTERS[name].read
    assert read is not None
    return lambda path: read(path.read_bytes())


def _completions() -> list[Any]:
    message = {"role": "assistant", "content": "```python\nsolver.corner(double_bed[0])\n```"}
    usage = {"prompt_tokens": 1000, "completion_tokens": 200, "total_tokens": 1200}
    choice = {"index": 0, "message": message, "finish_reason": "stop"}
    head = {"id": "chatcmpl-1", "object": "chat.completion", "created": 1, "model": "m"}
    return [head | {"choices": [choice], "usage": usage}]


def _ask_server(path: Path) -> object:
    """Ask a planner for a program whose server answers with the file."""
    import httpx2

    from robolayout.planners.model import provider
    from robolayout.planners.model.exchange import Question
    from robolayout.planners.model.options import ModelOptions

    body, made = path.read_bytes(), provider.create_async_httpx2_client

    def answered(request: Any) -> Any:
        return httpx2.Response(200, content=body, headers={"Content-Type": "application/json"}, request=request)

    provider.create_async_httpx2_client = lambda *_, **__: httpx2.AsyncClient(transport=httpx2.MockTransport(answered))  # type: ignore[assignment]
    try:
        question = Question("plan", "all", 1, 1, "say", ("what",), "key")
        client = ModelOptions(base_url="http://127.0.0.1:9/v1", exchanges=path.parent / "tape").open("openai:m")
        (answer,), _ = client.ask(question, str)
    finally:
        provider.create_async_httpx2_client = made
    return answer.encode()


READERS = {
    reader.name: reader
    for reader in (
        Reader("scene", ".json", _scenes, as_json, _read_scene),
        Reader("layout", ".json", lambda: [_room()[1].to_dict()], as_json, _read_layout),
        Reader("agent JSON", ".json", lambda: _tomls("scene", "agents"), as_json, load_agent),
        Reader("agent TOML", ".toml", lambda: _tomls("scene", "agents"), as_toml, load_agent),
        Reader("knowledge", ".toml", _knowledge, as_toml, _read_knowledge, 2),
        Reader("catalogue", ".json", _catalogue, as_json, _read_catalogue),
        Reader("reference asset", ".json", _metadata, as_json, _read_metadata),
        Reader("asset folder", ".json", _metadata, as_json, _read_folder),
        Reader("recording", ".json", _exchanges, as_json, _read_exchange),
        Reader("server answer", ".json", _completions, as_json, _ask_server, 20),
        Reader("program", ".py", _programs, None, _read_program, 10),
        Reader("URDF", ".urdf", _urdfs, None, _read_urdf),
        Reader("GLB", ".glb", _glbs, as_glb, _read_mesh),
        Reader("OBJ", ".obj", lambda: _meshes("obj"), None, _read_mesh),
        Reader("PLY", ".ply", lambda: _meshes("ply"), None, _read_mesh),
        Reader("STL", ".stl", lambda: _meshes("stl"), None, _read_mesh),
        Reader("export layout", ".json", _exported("layout"), as_json, _read_export("layout")),
        Reader("export sceneeval", ".json", _exported("sceneeval"), as_json, _read_export("sceneeval")),
        Reader("export procthor", ".json", _exported("procthor"), as_json, _read_export("procthor")),
        Reader("export glb", ".glb", _exported("glb"), as_glb, _read_export("glb")),
        Reader("export mjcf", ".xml", _exported("mjcf"), None, _read_export("mjcf")),
        Reader("export urdf", ".urdf", _exported("urdf"), None, _read_export("urdf")),
        Reader("export sdf", ".sdf", _exported("sdf"), None, _read_export("sdf")),
        Reader("export dxf", ".dxf", _exported("dxf"), None, _read_export("dxf")),
    )
}
"""All readers by name."""
