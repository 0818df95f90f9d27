"""What the tests of many rooms share: a room that is made in a moment, and how two sets are compared."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

TINY: dict[str, Any] = {
    "boundary": {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5},
    "assets": {
        name: {"category": kind, "onFloor": True, "assetMetadata": {"boundingBox": dict(zip("xyz", size, strict=True))}}
        for name, kind, size in (("desk-0", "desk", (0.6, 1.2, 0.7)), ("shelf-0", "bookshelf", (0.3, 0.8, 1.8)))
    },
}


def tiny_spec(folder: Path, each: int = 4, **keys: Any) -> dict[str, Any]:
    """Write the room and return a SPEC of so many of it, which may be alike; with `count` they may not."""
    scene = folder / "tiny.json"
    scene.write_text(json.dumps(TINY))
    return {"rooms": [str(scene)], **({} if "count" in keys else {"each": each}), "files": "formats", **keys}


def tree(folder: Path) -> dict[str, bytes]:
    """Return what a set is: every file but those about how long it took, and nothing hidden."""
    files = {path.relative_to(folder).as_posix(): path for path in folder.rglob("*") if path.is_file()}
    return {name: path.read_bytes() for name, path in sorted(files.items()) if name != "timing.csv"}
