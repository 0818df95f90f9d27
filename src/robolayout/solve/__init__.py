"""Scene and program to poses: compile, search, routes in the loop, repair."""

from robolayout.solve.compile import Problem, compile_problem
from robolayout.solve.config import SearchConfig, SolverConfig, Weights
from robolayout.solve.judge import Judge, Verdict
from robolayout.solve.refine import Solution, Solver
from robolayout.solve.runner import warm_up

__all__ = [
    "Judge",
    "Problem",
    "SearchConfig",
    "Solution",
    "Solver",
    "SolverConfig",
    "Verdict",
    "Weights",
    "compile_problem",
    "warm_up",
]
