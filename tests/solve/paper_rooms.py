"""The two boxes of docs/derivations.md, and rooms for the laws; all of one size of compiled program (8 slots)."""

from __future__ import annotations

from robolayout.program import read_program, reconcile
from robolayout.scene import Agent, Asset, Room, Scene
from robolayout.solve import Problem, Verdict, compile_problem

SQUARE = Room(((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)), 2.5)
L_SHAPED = Room(((0.0, 0.0), (5.0, 0.0), (5.0, 2.0), (2.0, 2.0), (2.0, 5.0), (0.0, 5.0)), 2.5)
TRIANGLE = Room(((0.0, 0.0), (5.0, 0.0), (0.0, 5.0)), 2.5)
DISC = Agent("disc", radius=0.30, height=1.5)
BOXES = (Asset("box-0", "box", (1.0, 1.0, 1.0)), Asset("box-1", "box", (1.0, 1.0, 1.0)))
PROGRAM = """
box[0].position = [1, 1, 0.5]
box[0].rotation = [0, 0, 0]
box[1].position = [1.5, 1.25, 0.5]
box[1].rotation = [0, 0, 0]
solver.distance_constraint(box[1], box[0], 1, 2)
"""


def problem(
    text: str = PROGRAM, assets: tuple[Asset, ...] = BOXES, room: Room = SQUARE, agent: Agent = DISC
) -> Problem:
    """Return a small problem; its program is read and filtered as everywhere."""
    scene = Scene(room, assets, agents=(agent,))
    return compile_problem(scene, reconcile(read_program(text, scene), scene).program)


def overlap_judge(of: Problem):
    """Return a judge that only looks at the area that footprints share."""
    from itertools import combinations

    from shapely import Polygon

    def judge(layout) -> Verdict:
        shapes = {a.name: Polygon(layout[a.name].corners(a.size)) for a in of.scene.assets if a.name in layout}
        area = sum(shapes[a].intersection(shapes[b]).area for a, b in combinations(sorted(shapes), 2))
        return Verdict(0.0, 0.0, area if area > 1e-9 else 0.0)

    return judge
