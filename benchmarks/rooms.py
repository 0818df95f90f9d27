"""Crowded rooms made by rule: so many assets, so much of the floor filled, with a program as a hasty model writes it."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from typing import Any

KINDS: tuple[tuple[str, float, float, float], ...] = (
    ("wardrobe", 0.60, 1.50, 2.10),
    ("bookshelf", 0.30, 0.90, 1.90),
    ("dresser", 0.45, 1.00, 0.80),
    ("desk", 0.65, 1.30, 0.74),
    ("armchair", 0.80, 0.75, 0.85),
    ("cabinet", 0.40, 0.80, 0.90),
    ("round table", 0.80, 0.80, 0.74),
    ("chair", 0.50, 0.48, 0.85),
    ("storage box", 0.40, 0.60, 0.40),
    ("floor plant", 0.40, 0.40, 1.10),
)
"""Category, depth, width and height in metres of what fills the rooms."""

AT_WALLS = ("wardrobe", "bookshelf", "dresser", "cabinet", "desk")


@dataclass(frozen=True)
class Crowd:
    """What is asked of the generator.

    Attributes:
        count: Number of assets.
        fill: Share of the floor that they take.
        seed: Settles sizes and program.
        concave: Whether a quarter of the room's rectangle is missing.
        contradictions: Number of statements that contradict another.
    """

    count: int
    fill: float
    seed: int
    concave: bool = False
    contradictions: int = 0

    @property
    def key(self) -> str:
        """Name of the case."""
        extras = ("/concave" if self.concave else "") + (
            f"/contra {self.contradictions}" if self.contradictions else ""
        )
        return f"{self.count} assets/{self.fill:.0%}{extras}/{self.seed}"


def crowd(asked: Crowd) -> tuple[dict[str, Any], str]:
    """Return a scene (as its file's content) and a program whose guesses are drawn blindly."""
    rng = random.Random(f"{asked.count} {asked.fill} {asked.seed} {asked.concave}")
    assets: dict[str, Any] = {}
    counts: dict[str, int] = {}
    area = 0.0
    for i in range(asked.count):
        kind, *size = KINDS[i % len(KINDS)]
        depth, width, height = (round(value * rng.uniform(0.85, 1.15), 2) for value in size)
        number = counts[kind] = counts.get(kind, -1) + 1
        box = {"x": depth, "y": width, "z": height}
        name = f"{kind.replace(' ', '_')}-{number}"
        assets[name] = {"category": kind, "onFloor": True, "assetMetadata": {"boundingBox": box}}
        area += depth * width
    floor = area / asked.fill
    length = math.sqrt(1.25 * floor / (0.75 if asked.concave else 1.0))
    width = length / 1.25
    corners = [[0, 0], [length, 0], [length, width], [0, width]]
    if asked.concave:
        corners[2:3] = [[length, width / 2], [length / 2, width / 2], [length / 2, width]]
    scene = {
        "task_description": "Put everything in.",
        "boundary": {"floor_vertices": [[round(x, 3), round(y, 3), 0] for x, y in corners], "wall_height": 2.6},
        "doors": [{"wall": 0, "offset": round(0.15 * length, 3), "width": 0.9, "height": 2.05}],
        "assets": assets,
    }
    return scene, "\n".join([*_guesses(assets, length, width, rng), *_statements(assets, asked, rng)]) + "\n"


def _guesses(assets: dict[str, Any], length: float, width: float, rng: random.Random) -> list[str]:
    lines: list[str] = []
    for name, asset in assets.items():
        x, y = rng.uniform(0.5, length - 0.5), rng.uniform(0.5, width - 0.5)
        z = asset["assetMetadata"]["boundingBox"]["z"] / 2
        lines.append(f"{_variable(name)}.position = [{x:.2f}, {y:.2f}, {z:.2f}]")
        lines.append(f"{_variable(name)}.rotation = [{rng.choice((0, 90, 180, 270))}]")
    return lines


def _statements(assets: dict[str, Any], asked: Crowd, rng: random.Random) -> list[str]:
    """Return walls for half of what stands at walls, chairs near tables and desks, distances, contradictions."""
    names = list(assets)
    lines: list[str] = []
    for i, name in enumerate(n for n in names if n.rpartition("-")[0] in AT_WALLS):
        if i % 2 == 0:
            lines.append(f"solver.against_wall({_variable(name)}, walls[{rng.randrange(4)}])")
    seats = [n for n in names if n.startswith("chair")]
    tables = [n for n in names if n.startswith(("round_table", "desk"))]
    for chair, table in zip(seats, tables, strict=False):
        lines.append(f"solver.distance_constraint({_variable(chair)}, {_variable(table)}, None, 1.3)")
        lines.append(f"solver.point_towards({_variable(chair)}, {_variable(table)})")
    for _ in range(asked.contradictions):
        a, b = rng.sample(names, 2)
        lines.append(f"solver.distance_constraint({_variable(a)}, {_variable(b)}, None, 0.9)")
        lines.append(f"solver.distance_constraint({_variable(b)}, {_variable(a)}, 2.5, None)")
    return lines


def _variable(name: str) -> str:
    kind, _, number = name.rpartition("-")
    return f"{kind}[{number}]"
