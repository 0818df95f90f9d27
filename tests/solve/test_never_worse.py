"""DESIGN section 6: refinement and repair are accepted only if better; a law over a thousand layouts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from solve_rooms import BED, L_SHAPED, STANDS, TABLE, problem_of, room_of, scattered

from robolayout.program import read_program, reconcile
from robolayout.run.flow import make_judge
from robolayout.scene import Room
from robolayout.solve import Effort, Solver, SolverConfig
from robolayout.solve.config import SearchConfig

HASTY = replace(
    SolverConfig(),
    kept=4,
    effort=Effort(mendings=8),
    polish=SearchConfig(steps=20, rate=0.03, final_rate=0.001),
)
PROGRAM = """
solver.against_wall(bed[0], walls[0])
solver.next_to(night_stand[0], bed[0], "left")
solver.next_to(night_stand[1], bed[0], "right")
solver.distance_constraint(table[0], bed[0], 1.0, 2.0)
"""


@pytest.mark.slow
@pytest.mark.parametrize("room", [Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5), L_SHAPED], ids=["square", "L"])
def test_no_layout_of_a_thousand_gets_worse(room: Room) -> None:
    scene = room_of(BED, TABLE, *STANDS, room=room)
    problem, program = problem_of(scene, PROGRAM), reconcile(read_program(PROGRAM, scene), scene).program
    judge, rng = make_judge(scene, program), np.random.default_rng(11)
    better = 0
    for seed in range(500):
        solver = Solver(problem, judge, HASTY, seed=seed)
        world = scattered(problem, rng)
        before = judge(problem.layout(world))
        for step in (solver._near, solver._repair, solver._restore):
            solver.hold(world, before, "guess")
            step()
            assert solver.verdict.worth[:3] <= before.worth[:3]
            assert solver.verdict == judge(problem.layout(solver.world)), "the verdict is that of these poses"
        better += solver.verdict.merit < before.merit
    assert better > 400
