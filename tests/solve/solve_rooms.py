"""A small search and small rooms: all of them of one size of compiled program (8 slots)."""

from __future__ import annotations

import math

import numpy as np

from robolayout.program import read_program, reconcile
from robolayout.run.flow import solve
from robolayout.scene import Agent, Asset, Opening, Pose, Room, Scene
from robolayout.solve import Effort, Problem, SearchConfig, Solution, SolverConfig, compile_problem

QUICK = SolverConfig(
    starts=8,
    kept=8,
    polish=SearchConfig(steps=60, rate=0.02, final_rate=0.0005),
    reroute=SearchConfig(steps=60, rate=0.03, final_rate=0.001),
    route_rounds=3,
    effort=Effort(mendings=16),
)

DOOR = Opening(0, 2.9, 0.9, 2.05)
SQUARE = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.2, doors=(DOOR,))
L_SHAPED = Room(((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)), 2.2, doors=(DOOR,))
TRIANGLE = Room(((0, 0), (5, 0), (0, 5)), 2.4)
DISC = Agent("disc", 0.25, 1.5, reach_distance=0.8)

BED = Asset("bed-0", "bed", (2.0, 1.6, 0.5))
STANDS = tuple(Asset(f"night_stand-{i}", "night stand", (0.4, 0.45, 0.5)) for i in range(2))
TABLE = Asset("table-0", "dining table", (0.8, 1.4, 0.75))
RUG = Asset("rug-0", "rug", (2.0, 2.6, 0.01))
LAMP = Asset("lamp-0", "table lamp", (0.2, 0.2, 0.4), on_floor=False, on_object=True)
PICTURE = Asset("picture-0", "picture", (0.03, 0.8, 0.6), on_floor=False, on_wall=True)
PENDANT = Asset("pendant-0", "pendant lamp", (0.4, 0.4, 0.5), on_floor=False, on_ceiling=True)


FURNISHED = """
solver.against_wall(bed[0], walls[5])
solver.symmetric_pair(night_stand[0], night_stand[1], bed[0])
solver.next_to(night_stand[0], bed[0], "left")
solver.on_top_of(lamp[0], night_stand[0])
solver.point_towards(night_stand[1], bed[0])
solver.distance_constraint(night_stand[1], [1, 3], 0.2, 0.4)
solver.keep_clear(bed[0], "left", 0.5)
solver.under(rug[0], [bed[0]])
solver.mounted_on(picture[0], walls[5])
"""
"""A bedroom in which something of every kind of row is asked for, in the L-shaped room."""


def room_of(*assets: Asset, room: Room = SQUARE, agent: Agent = DISC) -> Scene:
    return Scene(room, assets, agents=(agent,))


def problem_of(scene: Scene, text: str = "", *, seed: int = 0, **options: object) -> Problem:
    """Return the problem that a program text states."""
    return compile_problem(scene, reconcile(read_program(text, scene), scene).program, seed=seed, **options)


def solved(scene: Scene, text: str = "", *, seed: int = 0, pinned: dict[str, Pose] | None = None) -> Solution:
    return solve(scene, text, seed=seed, config=QUICK, pinned=pinned)


def scattered(problem: Problem, rng: np.random.Generator) -> np.ndarray:
    """Return random poses (n, 4) anywhere in the room."""
    x0, y0, x1, y1 = problem.scene.room.bounds
    world = np.empty((len(problem.names), 4))
    for row in world:
        yaw = rng.uniform(-math.pi, math.pi)
        row[:] = rng.uniform(x0, x1), rng.uniform(y0, y1), math.cos(yaw), math.sin(yaw)
    return world
