"""Names that users give their things, and a room of them."""

from __future__ import annotations

from typing import Any

NAMES = (
    "桌子-0",
    "map-0",
    "class-0",
    "None-0",
    "ValueError-0",
    "room",
    "agent/x",
    "bed",
    "bed-0",
    'it\'s "quoted" <b>&</b>-0',
    "\U0001f6cf\ufe0f-0",
    "cafe\u0301-0",
    "caf\u00e9-0",
    "כיסא-1",
    "  spaced  -0",
    "[/red]-0",
    "a/b",
    "../up",
    "..",
    "</script>-0",
    "\\U+0041 back\\slash",
    "_rl_log-0",
)
"""Words of Python and of our own files, quotes, markup, other scripts, two spellings of one word, paths."""
CATEGORIES = ("chair", "桌子", "bed", "плафон", "plant")


def hostile_scene() -> dict[str, Any]:
    """Return a scene file whose things have these names; some categories have no Latin letter."""
    box = {"boundingBox": {"x": 0.4, "y": 0.5, "z": 0.6}}
    return {
        "task_description": "一个房间",
        "boundary": {"floor_vertices": [[0, 0, 0], [8, 0, 0], [8, 7, 0], [0, 7, 0]], "wall_height": 2.6},
        "doors": [{"wall": 0, "offset": 1, "width": 1.0}],
        "assets": {
            name: {"category": CATEGORIES[i % len(CATEGORIES)], "onFloor": True, "assetMetadata": box}
            for i, name in enumerate(NAMES)
        },
    }
