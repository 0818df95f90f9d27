"""What hangs on the walls makes way for what would else hang out of reach."""

from __future__ import annotations

from robolayout.planners import OfflinePlanner, PlanRequest
from robolayout.planners.sentence import scene_from_sentence
from robolayout.program import read_program, reconcile
from robolayout.run.flow import make_judge
from robolayout.solve import compile_problem

SENTENCE = "a bedroom for two children with a bunk bed, desks and a reading corner, 4 x 5 m, for a wheelchair user"


def test_a_mirror_makes_way_for_a_picture_that_nobody_would_get_to() -> None:
    scene, _ = scene_from_sentence(SENTENCE)
    program = reconcile(read_program(OfflinePlanner().plan(PlanRequest(scene)), scene), scene).program
    verdict = make_judge(scene, program)(compile_problem(scene, program).guess)
    assert verdict.ok, verdict.culprits
