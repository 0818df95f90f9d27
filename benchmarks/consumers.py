"""`python -m benchmarks.consumers [ROOM ...]`: what programs make of exported rooms, and the table of it in docs/exports.md.

Each room is saved when it is measured; what is not installed is left out and named in the table. Drake, PyBullet and Blender are
`pip install drake pybullet bpy`; none of them is needed for anything else. SceneEval's own code runs where ROBOLAYOUT_SCENEEVAL
(its folder) and ROBOLAYOUT_BLENDER_PYTHON (a Python with bpy, python-fcl, omegaconf and mapbox_earcut) say where they are.
"""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

import robolayout as rl
from benchmarks import browser
from benchmarks.examples import ROOMS, ROOT
from benchmarks.exports import validated
from benchmarks.page import RESULTS
from benchmarks.simulators import SIMULATORS, Rested, Spot, in_drake
from benchmarks.store import Row, Store
from benchmarks.tables import table
from robolayout._files import write_atomic
from robolayout.export import Options, export_all, settle
from robolayout.export._bodies import things
from robolayout.export._exporter import mass

TASKS = ("bathroom", "kitchen", "office", "meeting_room", "hospital_room", "care_home_room", "cafe", "gym")
SECONDS = 5.0
FORMATS = ("mjcf", "sdf", "urdf", "usd", "usdz", "glb", "plan.dxf")
PAGE, START, END = ROOT / "docs" / "exports.md", "<!-- consumers -->\n", "<!-- /consumers -->\n"
JUDGE = ROOT / "tests" / "export" / "sceneeval_judge.py"

BLENDER = """
import json, sys, bpy, mathutils
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=sys.argv[1])
rows = {}
for thing in bpy.data.objects:
    if thing.get("kind") == "asset":
        place = thing.matrix_world
        turned = mathutils.Matrix.Rotation(-place.to_euler()[2], 3, "Z")
        meshes = [child for child in thing.children if child.type == "MESH"]
        corners = [turned @ (mesh.matrix_world @ mathutils.Vector(c)) for mesh in meshes for c in mesh.bound_box]
        sides = [max(axis) - min(axis) for axis in zip(*corners)]
        rows[thing.name] = [*place.translation, place.to_euler()[2], *sides]
print(json.dumps(rows), file=open(sys.argv[2], "w"))
"""

NOT_RUN = (
    ("AI2-THOR", "the Unity program does not run here; the tests check ProcTHOR-10k's schema"),
    ("Gazebo", "it has no package in a registry of Python's"),
    ("Isaac Sim", "it needs its own installation; USD's validators are run"),
)

CONSUMERS: Mapping[str, str] = {
    "MuJoCo": "MJCF",
    "Drake, MJCF": "MJCF",
    "Drake, SDF": "world and model folders",
    "Drake, URDF": "the room and its robots",
    "PyBullet, SDF": "model folders, put where the world says",
    "PyBullet, URDF": "the room and its robots",
    "Blender": "GLB",
    "trimesh": "GLB",
    "three.js": "GLB, in Chromium",
    "gltf-validator": "GLB",
    "usd-core": "USDA and USDZ, all validators",
    "ezdxf": "DXF",
    "SceneEval": "scene state and meshes, in Blender and trimesh",
}


def measured(room: Path) -> Row:
    """Return the figures of every consumer on one room, as `consumer/figure`."""
    result = rl.generate(room, seed=0)
    row: Row = {"assets": len(result.layout)}
    with tempfile.TemporaryDirectory() as folder:
        files = export_all(result.scene, result.layout, FORMATS, folder=folder, options=Options())
        mjcf, sdf, urdf, _, _, glb, dxf = files
        for simulator, (package, load) in SIMULATORS.items():
            for kind, path in (("SDF", sdf), ("URDF", urdf)):
                if find_spec(package):
                    row |= _named(f"{simulator}, {kind}", _rested(result, load(path, SECONDS)))
        if find_spec("pydrake"):
            row |= _named("Drake, MJCF", _rested(result, in_drake(mjcf, SECONDS)))
        row |= _named("MuJoCo", _rested(result, _mujoco(result, mjcf)))
        row |= _named("trimesh", _spots(result, _trimesh(glb)))
        if find_spec("bpy"):
            row |= _named("Blender", _blender(result, glb))
        if not browser.missing():
            row |= _named("three.js", _three(result, glb))
        row |= _named("SceneEval", sceneeval(result, Path(folder)))
        row |= _named("ezdxf", _dxf(result, dxf))
    found = validated(result, Options())
    if "glb_errors" in found:
        row["gltf-validator/complaints"] = found["glb_errors"] + found["glb_warnings"]
    if "usd_complaints" in found:
        row["usd-core/complaints"] = found["usd_complaints"]
    return row


def _named(consumer: str, figures: Row) -> Row:
    return {f"{consumer}/{name}": value for name, value in figures.items()}


def _spots(result: rl.Result, poses: Mapping[str, Spot]) -> Row:
    """Return how far poses are from the layout's at most (metres and radians)."""
    gaps = [
        max(math.dist((p.x, p.y, p.z), poses[n][:3]), abs(math.remainder(p.yaw - poses[n][3], 2 * math.pi)))
        for n, p in result.layout.items()
    ]
    return {"poses": max(gaps)}


def _rested(result: rl.Result, found: Rested) -> Row:
    """Return what a simulator's poses, masses, joints and rest differ from ours by."""
    known = list(things(result.scene, result.layout, Options()))
    weights = {thing.name: mass(thing.asset) for thing in known if thing.free and thing.asset is not None}
    heavier = [abs(found.masses.get(name, 0.0) / weight - 1) for name, weight in weights.items()]
    rest: Row = {"masses": max(heavier, default=0.0), "free": len(weights)}
    rest["joints"] = found.joints
    rest["joints_missing"] = sum(len(thing.links) - 1 for thing in known) - found.joints
    free = {name: found.moved[name] for name in weights}
    rest["moved"] = max(free.values(), default=0.0)
    rest["fallen"] = sum(moved > 0.01 for moved in free.values())
    return _spots(result, found.poses) | rest


def _mujoco(result: rl.Result, path: Path) -> Rested:
    """Return what MuJoCo makes of an MJCF file; everything that stands is free while it rests."""
    mujoco: Any = import_module("mujoco")
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    bodies = {name: data.body(name) for name in result.layout}
    poses = {n: (*b.xpos, math.atan2(b.xmat[3], b.xmat[0])) for n, b in bodies.items()}
    moved = {n: motion.displacement for n, motion in settle(result.scene, result.layout, SECONDS).motions.items()}
    masses = {name: float(model.body(name).subtreemass[0]) for name in result.layout}
    hinges = int(np.isin(model.jnt_type, (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE)).sum())
    return Rested(poses, moved, masses, hinges)


def _trimesh(path: Path) -> dict[str, Spot]:
    """Return the poses that trimesh reads; glTF is y up."""
    loaded: Any = import_module("trimesh").load(path)
    upright = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
    places = {str(node): upright @ loaded.graph[node][0] for node in loaded.graph.nodes}
    return {name: (*m[:3, 3], math.atan2(m[1, 0], m[0, 0])) for name, m in places.items()}


def _blender(result: rl.Result, path: Path) -> Row:
    """Return what Blender's poses and sizes differ from ours by; it runs by itself, since it brings its own USD."""
    answer = path.with_name("blender.json")
    words = [sys.executable, "-c", BLENDER, str(path), str(answer)]
    subprocess.run(words, check=True, capture_output=True)
    return _boxes(result, json.loads(answer.read_text()))


def _three(result: rl.Result, path: Path) -> Row:
    """Return what three.js's poses and sizes differ from ours by; counts that differ from the file's are complaints."""
    found = browser.in_three(path)
    wrong = sum(found[what] != count for what, count in browser.held(path).items())
    return _boxes(result, found["things"]) | {"complaints": wrong + len(found["said"])}


def _boxes(result: rl.Result, rows: Mapping[str, Any]) -> Row:
    """Return how far poses and sizes, seven figures for each thing, are from ours."""
    sizes = {a.name: a.size for a in result.scene.assets if a.name in result.layout}
    gaps = [abs(side - own) for name, size in sizes.items() for side, own in zip(rows[name][4:], size, strict=True)]
    return _spots(result, {name: tuple(row[:4]) for name, row in rows.items()}) | {"sizes": max(gaps)}


def sceneeval(result: rl.Result, folder: Path) -> Row:
    """Return how far apart things are in SceneEval's two worlds, and how many it says collide or are not held."""
    home, python = os.environ.get("ROBOLAYOUT_SCENEEVAL", ""), os.environ.get("ROBOLAYOUT_BLENDER_PYTHON", "")
    if not (home and python):
        return {}
    (state,) = export_all(result.scene, result.layout, ["sceneeval"], folder=folder)
    words = [python, str(JUDGE), str(folder / "sceneeval"), str(folder / "judged.json"), str(state)]
    subprocess.run(words, cwd=home, env={**os.environ, "PYTHONPATH": home}, check=True, capture_output=True)
    found = json.loads((folder / "judged.json").read_text())[state.name]
    apart = [np.abs(np.subtract(box, found["blender"][name])).max() for name, box in found["trimesh"].items()]
    wrong = sum(map(bool, found["collisions"].values())) + sum(not held for held in found["supported"].values())
    return {"poses": float(max(apart)), "complaints": wrong}


def _dxf(result: rl.Result, path: Path) -> Row:
    """Return how many complaints ezdxf has, and how far things stand from where they should."""
    plan: Any = import_module("ezdxf").readfile(path)  # pyright: ignore
    spots = np.array([tuple(insert.dxf.insert)[:2] for insert in plan.modelspace().query("INSERT")])
    own = np.array([(pose.x, pose.y) for pose in result.layout.values()])
    apart = np.linalg.norm(own[:, None] - spots[None], axis=2).min(axis=1).max()
    return {"complaints": len(plan.audit().errors), "poses": float(apart)}


CELLS: Mapping[str, Callable[[float], str]] = {
    "poses": lambda value: f"{value:.0e}",
    "sizes": lambda value: f"{1000 * value:.1f} mm",
    "masses": lambda value: f"{value:.0e}",
    "joints_missing": lambda value: f"{value:.0f} missing",
    "moved": lambda value: f"{1000 * value:.1f} mm",
    "fallen": lambda value: f"{value:.0f}",
    "complaints": lambda value: f"{value:.0f}",
}


def page(rows: Mapping[str, Row]) -> str:
    """Return the table, the worst of all rooms in each cell."""
    lines: list[list[str]] = []
    for consumer, loaded in CONSUMERS.items():
        mine = {room: row for room, row in rows.items() if any(key.startswith(f"{consumer}/") for key in row)}
        line = [consumer, loaded, str(len(mine))]
        for figure, cell in CELLS.items():
            values = [row[f"{consumer}/{figure}"] for row in mine.values() if f"{consumer}/{figure}" in row]
            line.append(cell(max(values, key=abs)) if values else "-")
        lines.append(line)
    heads = ["program", "what it loaded", "rooms", "poses off", "sizes off", "masses off", "joints", "moves in 5 s"]
    assets, joints = (sum(row.get(key, 0) for row in rows.values()) for key in ("assets", "MuJoCo/joints"))
    free = sum(row.get("MuJoCo/free", 0) for row in rows.values())
    names = ", ".join(sorted(rows)).replace("_", " ")
    note = (
        f"Written by `python -m benchmarks.consumers` from {len(rows)} rooms: {names}; {assets} things, "
        f"{free} of them free, {joints} hinges and slides. Each cell is the worst of all rooms: metres or radians, "
        "the share of a mass, how far a free thing moves in five seconds of gravity, how many move more than 1 cm, "
        "and what the program complains of.\n"
    )
    skipped = "".join(f"- {name}: {why}.\n" for name, why in NOT_RUN)
    return f"{note}\n{table([*heads, 'fall', 'complaints'], lines)}\nNot run:\n\n{skipped}"


def main() -> None:
    """Measure the rooms that are not measured yet and write the table."""
    store = Store(RESULTS / "consumers.json")
    rooms = [*(ROOT / "examples" / f"{r}.json" for r in ROOMS), *(ROOT / "examples/tasks" / f"{t}.json" for t in TASKS)]
    for room in rooms:
        if room.stem in sys.argv[1:] or (len(sys.argv) == 1 and room.stem not in store.rows):
            store.save(room.stem, measured(room))
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(START)
    write_atomic(PAGE, f"{before}{START}\n{page(store.rows)}\n{END}{rest.partition(END)[2]}")


if __name__ == "__main__":
    os.environ.setdefault("JAX_PLATFORMS", "cpu")
    main()
