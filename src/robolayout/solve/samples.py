"""Several programs for one scene: each is polished, and what takes long - building, mending - is for the best alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from robolayout.scene import Trace
from robolayout.solve.compile import Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.judge import Judge
from robolayout.solve.profiles import DEFAULT, solve_with
from robolayout.solve.solution import Progress, Solution, conclude

WHOLE = 2
"""Programs that are solved in full, at most: the best, and the next one if the best still breaks a hard demand."""


def solve_samples(
    problems: Sequence[Problem],
    judges: Sequence[Judge],
    *,
    seed: int = 0,
    config: SolverConfig | None = None,
    progress: Progress | None = None,
) -> list[Solution]:
    """Solve several programs of one scene, the most promising first; no effort is spent once one of them is met entirely.

    Args:
        problems: One problem per program, all of one scene.
        judges: The exact verifier for each, as an order on layouts.
        seed: Settles every choice.
        config: Constants of the search.
        progress: Called with the name of each phase.
    """
    config = config or SolverConfig()

    guesses = [(problem.guess, judge(problem.guess)) for problem, judge in zip(problems, judges, strict=True)]
    found = [conclude(*guess, Trace()) for guess in guesses]

    def improve(i: int, how: SolverConfig) -> None:
        more = solve_with(DEFAULT, problems[i], judges[i], seed=seed + 1009 * i, config=how, progress=progress)
        found[i] = min(found[i], more, key=lambda one: one.verdict.merit)

    def ranked() -> list[int]:
        return sorted(range(len(found)), key=lambda i: found[i].verdict.merit)

    brief = replace(config, starts=0, effort=replace(config.effort, nearby=0, mendings=0))
    for i in ranked():
        if any(one.verdict.ok for one in found):
            return found
        improve(i, brief)
    for i in ranked()[:WHOLE]:
        if any(one.verdict.ok for one in found):
            break
        improve(i, config)
        if not found[i].verdict.hard:
            break
    return found
