"""Solvers by name: the default one, the paper's, and two of SciPy's on the paper's loss; and several programs at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from robolayout._errors import among
from robolayout.scene import Layout
from robolayout.solve.compile import Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.refine import Solver
from robolayout.solve.solution import Judge, Progress, Solution, silent

PAPER, UNREFINED = "paper", "paper-unrefined"
"""The paper's algorithm, for which programs are filtered as the paper does; and without its last step, to see what that is worth."""

WHOLE = 2
"""Programs that are solved in full, at most: the best, and the next one if the best still breaks a hard demand."""


def solver_names() -> tuple[str, ...]:
    """Return the names of all solvers, the default one first."""
    return ("default", PAPER, UNREFINED, "trust-constr", "dual-annealing")


def solve_with(
    name: str,
    problem: Problem,
    judge: Judge,
    *,
    seed: int = 0,
    config: SolverConfig | None = None,
    progress: Progress | None = None,
) -> Solution:
    """Solve a problem with the solver of that name.

    Args:
        name: One of `solver_names()`.
        problem: The problem.
        judge: The exact verifier, as an order on layouts.
        seed: Settles every choice.
        config: Constants of the default search; the others have their own.
        progress: Called with the name of each phase.

    Raises:
        UnknownNameError: There is no solver of that name.
    """
    among("solver", [name], solver_names())
    if not problem.names:
        nothing = Layout({})
        return Solution(nothing, judge(nothing))
    say = progress or silent
    if name == "default":
        return Solver(problem, judge, config or SolverConfig(), seed=seed, progress=say).solve()
    if name in (PAPER, UNREFINED):
        from robolayout.solve.paper import solver as paper

        constants = replace(paper.PAPER, refine_steps=0) if name == UNREFINED else paper.PAPER
        return paper.PaperSolver(problem, judge, seed=seed, config=constants, progress=say).solve()
    from robolayout.solve.paper.scipy_solvers import ScipySolver

    scipy = ScipySolver(problem, judge, seed=seed, progress=say)
    return scipy.trust_constr() if name == "trust-constr" else scipy.dual_annealing()


def solve_samples(
    problems: Sequence[Problem],
    judges: Sequence[Judge],
    *,
    seed: int = 0,
    config: SolverConfig | None = None,
    progress: Progress | None = None,
) -> list[Solution]:
    """Solve several programs of one scene, each with its judge; no effort is spent once one of them is met entirely.

    Each is polished, the most promising first; what takes long - building, mending - is for the best alone. Else as `solve_with`.
    """
    config = config or SolverConfig()
    guesses = [problem.guess for problem in problems]
    found = [Solution(guess, judge(guess)) for guess, judge in zip(guesses, judges, strict=True)]
    brief = replace(config, starts=0, effort=replace(config.effort, nearby=0, mendings=0))
    for how, most in ((brief, len(found)), (config, WHOLE)):
        for i in sorted(range(len(found)), key=lambda i: found[i].verdict.merit)[:most]:
            if any(one.verdict.ok for one in found):
                return found
            more = solve_with("default", problems[i], judges[i], seed=seed + 1009 * i, config=how, progress=progress)
            found[i] = min(found[i], more, key=lambda one: one.verdict.merit)
            if how is config and not found[i].verdict.hard:
                return found
    return found
