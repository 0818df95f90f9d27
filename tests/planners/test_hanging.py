"""What hangs on the walls makes way for what would else hang out of reach."""

from __future__ import annotations

import robolayout as rl
from robolayout.planners.sentence import scene_from_sentence

SENTENCE = "a bedroom for two children with a bunk bed, desks and a reading corner, 4 x 5 m, for a wheelchair user"


def test_a_mirror_makes_way_for_a_picture_that_nobody_would_get_to() -> None:
    scene, _ = scene_from_sentence(SENTENCE)
    report = rl.generate(scene).report
    assert report.ok, report.violations
