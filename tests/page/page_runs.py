"""What the tests of the page share: runs made by hand, so that no solver is needed, and an opened page."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from robolayout.program import Program, reconcile
from robolayout.run.result import Result
from robolayout.scene import Layout, Pose, Scene, Snapshot, Trace
from robolayout.solve import Solution, Verdict
from robolayout.verify import verify

PLACES = {
    "double_bed-0": (1.99, 3.975, 0.5, 270),
    "night_stand-0": (0.9, 4.825, 0.25, 270),
    "night_stand-1": (3.065, 4.825, 0.25, 270),
    "table_lamp-0": (0.81, 4.825, 0.71, 270),
    "table_lamp-1": (2.975, 4.825, 0.71, 270),
    "wardrobe-0": (0.3, 0.783, 1.05, 0),
    "dresser-0": (3.775, 1.61, 0.4, 180),
    "mirror-0": (3.985, 2.5, 1.36, 180),
    "armchair-0": (1.97, 0.39, 0.425, 90),
    "floor_lamp-0": (2.58, 0.175, 0.775, 90),
    "rug-0": (1.99, 3.35, 0.005, 270),
    "potted_plant-0": (0.24, 4.8, 0.55, 270),
    "picture-0": (1.55, 0.015, 1.55, 90),
    "ceiling_lamp-0": (2.0, 2.5, 2.475, 180),
}
PROGRAM = """solver.against_wall(double_bed[0], walls[2])
solver.next_to(night_stand[0], double_bed[0], "right", 0.21)
solver.distance_constraint(armchair[0], double_bed[0], 0.5, 1.0)
solver.against_wall(wardrobe[0], walls[3])
"""
MOMENTS = 12
HOSTILE = "</script><img src=x onerror=\"window.hacked='it'\"><!-- \u2028 {{script}} &lt;"


def run_of(scene: Scene, places: dict[str, tuple[float, float, float, float]], asked: Program) -> Result:
    """Return a run that ends with these places, after a search in which everything came from the middle of the room."""
    layout = Layout({name: Pose(x, y, z, math.radians(turn)) for name, (x, y, z, turn) in places.items()})
    trace = Trace(
        tuple({"total": 100.0 / (step + 1)} for step in range(10 * MOMENTS)),
        tuple(Snapshot(10 * k, "search", _on_the_way(layout, k / MOMENTS)) for k in range(MOMENTS)),
    )
    solution = Solution(layout, Verdict(0.0, 0.0, 0.0), trace=trace)
    report = verify(scene, layout, asked).with_timing({"plan": {"wall": 0.5, "cpu": 0.5}})
    return Result(scene, layout, report, asked, reconcile(asked, scene), (), solution)


def _on_the_way(layout: Layout, share: float) -> dict[str, tuple[float, float, float]]:
    return {name: (2 + share * (p.x - 2), 2.5 + share * (p.y - 2.5), share * p.yaw) for name, p in layout.items()}


@dataclass
class Opened:
    """A page in a browser, with everything that it said and asked for."""

    page: Any
    said: list[str] = field(default_factory=list[str])
    asked: list[str] = field(default_factory=list[str])
