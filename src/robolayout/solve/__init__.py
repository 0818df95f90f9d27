"""Scene and program to poses: compile, search, routes in the loop, repair."""

from robolayout.solve.compile import Problem as Problem
from robolayout.solve.compile import carrier_rank as carrier_rank
from robolayout.solve.compile import carries as carries
from robolayout.solve.compile import compile_problem as compile_problem
from robolayout.solve.config import EFFORTS as EFFORTS
from robolayout.solve.config import Effort as Effort
from robolayout.solve.config import SearchConfig as SearchConfig
from robolayout.solve.config import SolverConfig as SolverConfig
from robolayout.solve.config import Weights as Weights
from robolayout.solve.dress import dress as dress
from robolayout.solve.profiles import PAPER as PAPER
from robolayout.solve.profiles import UNREFINED as UNREFINED
from robolayout.solve.profiles import solve_samples as solve_samples
from robolayout.solve.profiles import solve_with as solve_with
from robolayout.solve.profiles import solver_names as solver_names
from robolayout.solve.proposals import Proposals as Proposals
from robolayout.solve.proposals import carry as carry
from robolayout.solve.refine import Solver as Solver
from robolayout.solve.restore import askew as askew
from robolayout.solve.runner import warm_up as warm_up
from robolayout.solve.solution import Enough as Enough
from robolayout.solve.solution import Judge as Judge
from robolayout.solve.solution import Solution as Solution
from robolayout.solve.solution import Verdict as Verdict
from robolayout.solve.solution import never as never
from robolayout.solve.solution import silent as silent
