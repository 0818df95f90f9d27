"""Scene and program to poses: compile, search, routes in the loop, repair."""

from robolayout.solve.compile import Problem, compile_problem
from robolayout.solve.config import EFFORTS, Effort, SearchConfig, SolverConfig, Weights
from robolayout.solve.dress import DressConfig, Dressed, dress
from robolayout.solve.judge import Enough, Judge, Verdict, never
from robolayout.solve.profiles import PAPER, UNREFINED, solve_with, solver_names
from robolayout.solve.proposals import Proposals, carry
from robolayout.solve.refine import Solver
from robolayout.solve.runner import warm_up
from robolayout.solve.samples import solve_samples
from robolayout.solve.solution import Solution, silent

__all__ = [
    "EFFORTS",
    "PAPER",
    "UNREFINED",
    "DressConfig",
    "Dressed",
    "Effort",
    "Enough",
    "Judge",
    "Problem",
    "Proposals",
    "SearchConfig",
    "Solution",
    "Solver",
    "SolverConfig",
    "Verdict",
    "Weights",
    "carry",
    "compile_problem",
    "dress",
    "never",
    "silent",
    "solve_samples",
    "solve_with",
    "solver_names",
    "warm_up",
]
