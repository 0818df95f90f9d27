"""Digests: which scene and which layout a report speaks of, as SHA-256 of their files' content."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import PurePath
from typing import Any

from robolayout.scene.io import scene_to_dict
from robolayout.scene.layout import Layout
from robolayout.scene.scene import Scene


def digest(content: object) -> str:
    """Return the SHA-256, in hexadecimal, of plain data in canonical JSON: sorted keys, no spaces, ASCII."""
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), default=str)
    return hashlib.sha256(text.encode()).hexdigest()


def layout_digest(layout: Layout) -> str:
    """Return the digest of the content of `layout.json`."""
    return digest(layout.to_dict())


def scene_digest(scene: Scene) -> str:
    """Return the digest of the content of a scene file; of a mesh only the file's name counts, not the folder it is in."""
    content: dict[str, Any] = scene_to_dict(scene)
    return digest(content | {"assets": {name: _without_folder(entry) for name, entry in content["assets"].items()}})


def _without_folder(entry: Mapping[str, Any]) -> dict[str, Any]:
    path = entry.get("path")
    return dict(entry) | ({"path": PurePath(path).name} if isinstance(path, str) else {})
