"""Solvers by name: the default one, the paper's, and two of SciPy's on the paper's loss."""

from __future__ import annotations

from dataclasses import replace

from robolayout._errors import UnknownNameError
from robolayout.scene import Layout, Trace
from robolayout.solve.compile import Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.judge import Judge
from robolayout.solve.solution import Progress, Solution, conclude, silent

DEFAULT = "default"
"""The solver that is meant when nobody names one."""

PAPER = "paper"
"""The solver that is the paper's algorithm; programs are filtered for it as the paper does."""

UNREFINED = "paper-unrefined"
"""The same without its last step, to see what that is worth."""

ANNEALING, TRUST = "dual-annealing", "trust-constr"
"""SciPy's optimisers."""


def solver_names() -> tuple[str, ...]:
    """Return the names of all solvers, the default one first."""
    return (DEFAULT, PAPER, UNREFINED, TRUST, ANNEALING)


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
    if name not in solver_names():
        raise UnknownNameError("solver", name, solver_names())
    if not problem.names:
        nothing = Layout({})
        return conclude(nothing, judge(nothing), Trace())
    say = progress or silent
    if name == DEFAULT:
        from robolayout.solve.refine import Solver

        return Solver(problem, judge, config or SolverConfig(), seed=seed, progress=say).solve()
    if name in (ANNEALING, TRUST):
        from robolayout.solve.paper.scipy_solvers import ScipySolver

        scipy = ScipySolver(problem, judge, seed=seed, progress=say)
        return scipy.dual_annealing() if name == ANNEALING else scipy.trust_constr()
    from robolayout.solve.paper import solver as paper

    constants = replace(paper.PAPER, refine_steps=0) if name == UNREFINED else paper.PAPER
    return paper.PaperSolver(problem, judge, seed=seed, config=constants, progress=say).solve()
