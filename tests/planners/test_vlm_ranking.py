from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from vlm_rooms import small_room

from robolayout.planners import score_samples
from robolayout.planners.model.feedback import MOST_LINES, Feedback
from robolayout.planners.model.ranking import ACCESS, HARD, agreement
from robolayout.program import Program, read_program

SCENE = small_room()
EMPTY = Program()


def figures(hard: float = 1.0, access: float = 1.0, met: float = 1.0) -> dict[str, float | bool]:
    shares = {name: hard for name in HARD} | {name: access for name in ACCESS}
    return shares | {"walkable_ratio": access, "statements_met_share": met}


def program(*lines: str) -> Program:
    return read_program("\n".join(f"solver.{line}" for line in lines), SCENE)


def rank_samples(rows: list[dict[str, float | bool]], programs: list[Program]) -> tuple[int, ...]:
    """Return the samples' numbers by their scores, best first; the earlier one wins a tie."""
    scores = score_samples(rows, programs)
    return tuple(sorted(range(len(scores)), key=lambda i: (*(-part for part in scores[i].key), i)))


def test_hard_demands_come_before_access_before_statements() -> None:
    rows = [figures(0.9, 1, 1), figures(1, 0.8, 1), figures(1, 0.9, 0.2), figures(1, 0.9, 0.5)]
    assert rank_samples(rows, [EMPTY] * 4) == (3, 2, 1, 0)


def test_a_blocked_door_counts_as_hard() -> None:
    blocked = figures() | {"door_clear": False}
    assert rank_samples([blocked, figures(met=0.1)], [EMPTY] * 2) == (1, 0)


def test_the_sample_that_agrees_with_the_others_wins_a_tie() -> None:
    common = "against_wall(bed[0], walls[3])"
    samples = [
        program("against_wall(bed[0], walls[1])"),
        program(common, "distance_constraint(bed[0], walls[0], 1.0, 1.4)"),
        program(common, "distance_constraint(bed[0], walls[0], 1.2, 1.5)"),
    ]
    assert agreement(samples) == (0.0, 0.5, 0.5)
    assert rank_samples([figures()] * 3, samples) == (1, 2, 0)


def test_more_walkable_floor_than_demanded_is_no_merit() -> None:
    rows = [figures(met=0.9), figures(met=1.0) | {"walkable_ratio": 0.96}, figures(met=1.0) | {"walkable_ratio": 0.9}]
    assert rank_samples(rows, [EMPTY] * 3) == (1, 0, 2)


def test_rounding_decides_nothing() -> None:
    rows = [figures(met=0.9500000001), figures(met=0.95)]
    assert rank_samples(rows, [EMPTY] * 2) == (0, 1)
    assert rank_samples(rows[::-1], [EMPTY] * 2) == (0, 1)


def test_a_single_sample_agrees_with_itself() -> None:
    (score,) = score_samples([figures(0.5)], [EMPTY])
    assert score.to_dict() == {"hard": 0.5, "access": 1.0, "statements": 1.0, "agreement": 1.0}


@given(st.lists(st.tuples(*[st.sampled_from([0.0, 0.5, 0.9, 1.0])] * 3), min_size=1, max_size=6))
def test_ranking_is_a_permutation_and_never_prefers_the_worse(rows: list[tuple[float, float, float]]) -> None:
    order = rank_samples([figures(*row) for row in rows], [EMPTY] * len(rows))
    assert sorted(order) == list(range(len(rows)))
    assert [rows[i] for i in order] == sorted(rows, reverse=True)


def test_feedback_tells_line_and_caret_rejections_and_violations() -> None:
    with pytest.raises(Exception) as caught:
        read_program("x = 1\nsolver.against_wal(bed[0], walls[3])", SCENE)
    text = Feedback(error=caught.value, rejections=["line 3: a: b."], violations=["bed-0 is outside.\n```"]).text()
    assert "    line 2: " in text
    assert "^" in text and "against_wall" in text
    assert "left out:\n\n- line 3: a: b." in text
    assert "measured:\n\n- bed-0 is outside. '''" in text
    assert Feedback().text() == ""


def test_long_feedback_is_cut() -> None:
    text = Feedback(violations=[f"fault {i}" for i in range(100)]).text()
    assert text.count("- fault") == MOST_LINES
    assert text.endswith(f"- and {100 - MOST_LINES} more.")
