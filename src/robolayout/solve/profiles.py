"""Solvers by name: the default one, the paper's, and two of SciPy's on the paper's loss."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

from robolayout._errors import UnknownNameError
from robolayout.scene import Layout, Trace
from robolayout.solve.compile import Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.judge import Judge
from robolayout.solve.solution import Progress, Solution, conclude

DEFAULT = "default"
"""The solver that is meant when nobody names one."""

PAPER = "paper"
"""The solver that is the paper's algorithm; programs are filtered for it as the paper does."""

UNREFINED = "paper-unrefined"
"""The same without its last step, to see what that is worth."""

Profile = Callable[[Problem, Judge, int, SolverConfig | None, Progress | None], Solution]
"""Problem, judge, seed, constants of the default search, progress."""


def _default(
    problem: Problem, judge: Judge, seed: int, config: SolverConfig | None, progress: Progress | None
) -> Solution:
    from robolayout.solve.refine import Solver

    return Solver(problem, judge, config, seed=seed, progress=progress).solve()


def _paper(
    problem: Problem, judge: Judge, seed: int, _config: SolverConfig | None, progress: Progress | None
) -> Solution:
    from robolayout.solve.paper.solver import PaperSolver

    return PaperSolver(problem, judge, seed=seed, progress=progress).solve()


def _paper_unrefined(
    problem: Problem, judge: Judge, seed: int, _config: SolverConfig | None, progress: Progress | None
) -> Solution:
    from robolayout.solve.paper.solver import PAPER as CONSTANTS
    from robolayout.solve.paper.solver import PaperSolver

    return PaperSolver(problem, judge, seed=seed, config=replace(CONSTANTS, refine_steps=0), progress=progress).solve()


def _trust_constr(
    problem: Problem, judge: Judge, seed: int, _config: SolverConfig | None, progress: Progress | None
) -> Solution:
    from robolayout.solve.paper.scipy_solvers import ScipySolver

    return ScipySolver(problem, judge, seed=seed, progress=progress).trust_constr()


def _dual_annealing(
    problem: Problem, judge: Judge, seed: int, _config: SolverConfig | None, progress: Progress | None
) -> Solution:
    from robolayout.solve.paper.scipy_solvers import ScipySolver

    return ScipySolver(problem, judge, seed=seed, progress=progress).dual_annealing()


PROFILES: Mapping[str, Profile] = MappingProxyType(
    {
        DEFAULT: _default,
        PAPER: _paper,
        UNREFINED: _paper_unrefined,
        "trust-constr": _trust_constr,
        "dual-annealing": _dual_annealing,
    }
)
"""All solvers by name."""


def solver_names() -> tuple[str, ...]:
    """Return the names of all solvers, the default one first."""
    return tuple(PROFILES)


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
    if name not in PROFILES:
        raise UnknownNameError("solver", name, PROFILES)
    if not problem.names:
        nothing = Layout({})
        return conclude(nothing, judge(nothing), Trace())
    return PROFILES[name](problem, judge, seed, config, progress)
