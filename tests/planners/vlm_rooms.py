"""A small room for tests of the model planner, as a scene and as what models answer about it."""

from __future__ import annotations

import json

from robolayout.scene import Scene, scene_from_dict


def asset(category: str, x: float, y: float, z: float, description: str = "", **flags: bool) -> dict[str, object]:
    places = {"onFloor": not flags, "onWall": False, "onCeiling": False, "onObject": False} | flags
    return {
        "category": category,
        "description": description,
        **places,
        "assetMetadata": {"boundingBox": {"x": x, "y": y, "z": z}},
    }


def small_room(description: str = "a plain oak bed") -> Scene:
    return scene_from_dict(
        {
            "task_description": "A bedroom for one.",
            "layout_criteria": "The bed at a wall, a lamp beside it.",
            "boundary": {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 3.5, 0], [0, 3.5, 0]], "wall_height": 2.6},
            "doors": [{"wall": 0, "offset": 2.9, "width": 0.9, "height": 2.05}],
            "agent": {"name": "walker", "radius": 0.3, "height": 1.7, "reach_distance": 0.7},
            "assets": {
                "bed-0": asset("bed", 2.0, 1.4, 0.5, description),
                "night_stand-0": asset("night stand", 0.4, 0.45, 0.5),
                "lamp-0": asset("lamp", 0.25, 0.25, 0.4, onObject=True),
                "picture-0": asset("picture", 0.03, 0.8, 0.6, onWall=True),
            },
        }
    )


GROUPING = json.dumps(
    {
        "groups": [
            {
                "label": "sleeping",
                "rationale": "The bed rules the room.",
                "items": ["bed-0", "night_stand-0", "lamp-0"],
                "relations": ["night_stand-0 left of bed-0"],
            },
            {"label": "decoration", "rationale": "Comes last.", "items": ["picture-0"], "relations": []},
        ]
    }
)

BED = """bed[0].position = [1.0, 1.6, 0.25]
bed[0].rotation = [0]
night_stand[0].position = [0.2, 2.6, 0.25]
night_stand[0].rotation = [0]
solver.against_wall(bed[0], walls[3])
solver.next_to(night_stand[0], bed[0], "left")
solver.align_with(night_stand[0], bed[0])
solver.on_top_of(lamp[0], night_stand[0])
"""

PICTURE = """picture[0].position = [0.02, 1.6, 1.5]
solver.mounted_on(picture[0], walls[3], height=1.5)
"""
