"""What independent readers, validators and a simulator say about the files of the four examples and two shops."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import robolayout as rl
from benchmarks.examples import ROOMS, ROOT
from benchmarks.measures import watch
from benchmarks.pictures import SHOPS, furnished
from benchmarks.store import Row
from benchmarks.tables import Rows, figure, table
from robolayout.export import EXPORTERS, Options, drive, export_all, settle
from robolayout.run.outputs import export_options

TOOLS = ROOT / "tests" / "tools"


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room."""
    for room in ROOMS[:1] if quick else (*ROOMS, *SHOPS):
        yield room.rpartition("/")[2], partial(measured, room)


def measured(room: str) -> Row:
    """Return what comes back from every format, what validators find, and what moves and touches in MuJoCo."""
    result = furnished(room)
    options = export_options(result.report)
    row: Row = {"assets": len(result.scene.assets)} | _read_back(result, options) | validated(result, options)
    with watch() as spent:
        settled = settle(result.scene, result.layout)
    row |= {
        "stable_share": settled.stable_share,
        "moved_mm": 1000 * max(motion.displacement for motion in settled.motions.values()),
        "tilt": math.degrees(max(motion.tilt for motion in settled.motions.values())),
        "settle_cpu": spent.cpu,
    }
    with watch() as spent:
        driven = drive(result.scene, result.layout, result.report.agents[0].agent, options.routes)
    return row | {
        "routes": len(driven.drives),
        "contacts": len(driven.contacts),
        "off_mm": 1000 * max((way.error for way in driven.drives.values()), default=0.0),
        "drive_cpu": spent.cpu,
    }


def _read_back(result: rl.Result, options: Options) -> Row:
    """Return the largest difference of any pose and size after writing and reading, over all formats."""
    apart = 0.0
    for exporter in EXPORTERS.values():
        assert exporter.read is not None
        back = exporter.read(exporter.write(result.scene, result.layout, options))
        for name, pose in result.layout.items():
            other = back.layout[name]
            turned = math.remainder(pose.yaw - other.yaw, 2 * math.pi)
            gaps = [pose.x - other.x, pose.y - other.y, pose.z - other.z, turned]
            if name in back.sizes:
                gaps += [a - b for a, b in zip(back.sizes[name], result.scene.by_name[name].size, strict=True)]
            apart = max(apart, *map(abs, gaps))
    return {"formats": len(EXPORTERS), "read_back": apart}


def validated(result: rl.Result, options: Options) -> Row:
    """Return how many errors and warnings validators find; what is not installed is left out."""
    row: Row = {}
    with tempfile.TemporaryDirectory() as folder:
        glb, usda, usdz, urdf, mjcf = export_all(
            result.scene, result.layout, ["glb", "usd", "usdz", "urdf", "mjcf"], folder=folder, options=options
        )
        node = shutil.which("node")
        if node and (TOOLS / "node_modules" / "gltf-validator").is_dir():
            words = [node, str(TOOLS / "validate_gltf.mjs"), str(glb)]
            found = json.loads(subprocess.run(words, capture_output=True, text=True, check=False).stdout)[str(glb)]
            row |= {"glb_errors": found["errors"], "glb_warnings": found["warnings"]}
        if find_spec("pxr"):
            row["usd_complaints"] = sum(len(_usd_complaints(path)) for path in (usda, usdz))
        if find_spec("mujoco"):
            model: Any = import_module("mujoco").MjModel
            row["mujoco_loads"] = all(model.from_xml_path(str(path)).nbody > 1 for path in (urdf, mjcf))
    return row


def _usd_complaints(path: Path) -> list[str]:
    """Return what every validator of the USD library says."""
    usd: Any = import_module("pxr.Usd")
    validation: Any = import_module("pxr.UsdValidation")
    context = validation.ValidationContext(validation.ValidationRegistry().GetOrLoadAllValidators())
    return [error.GetMessage() for error in context.Validate(usd.Stage.Open(str(path)))]


def section(rows: Rows, images: Path) -> str:
    """Return the table of what validators and the simulator say."""
    rooms = sorted(rows, key=lambda room: rows[room]["assets"])
    lines: list[list[str]] = []
    for room in rooms:
        row = rows[room]
        glb = f"{row['glb_errors']} / {row['glb_warnings']}" if "glb_errors" in row else "-"
        lines.append([room.replace("_", " "), str(row["assets"]), f"{row['read_back']:.0e}", glb])
        lines[-1] += [figure(row, "usd_complaints", "{}"), figure(row, "stable_share", "{:.2f}")]
        lines[-1] += [f"{row['moved_mm']:.1f} mm, {row['tilt']:.2f} degrees"]
        lines[-1] += [f"{row['contacts']} on {row['routes']} routes", f"{row['off_mm']:.1f} mm"]
    heads = ["room", "assets", "read back, largest difference", "GLB errors / warnings", "USD complaints"]
    heads += ["stable share", "moves, tilts at most", "contacts of the driven base", "off its route at most"]
    intro = (
        "Every format written and read back (metres, radians); Khronos' gltf-validator; all validators of the USD library; "
        "URDF and MJCF loaded by MuJoCo; five seconds of gravity, in which a stable asset moves by less than 1 cm and "
        "tilts by less than 2 degrees; the base driven along every route.\n"
    )
    return f"## Exports\n\n{intro}\n{table(heads, lines)}"
