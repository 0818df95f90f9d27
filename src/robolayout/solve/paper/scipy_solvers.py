"""SciPy's optimisers on the paper's loss and gradient: `trust-constr` and `dual-annealing`.

Both keep to the paper's formulation (section "Rotation Constraint"): minimise L over positions in the room's box and headings
(cos, sin) in [-1, 1]^2, subject to cos^2 + sin^2 = 1 as a nonlinear constraint, with gtol = xtol = barrier_tol = 1e-12. They are
bounded by numbers of evaluations, never by the clock, so that the same seed gives the same layout.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy.optimize
from scipy.sparse import csr_matrix, diags_array

from robolayout.solve.compile import Floats
from robolayout.solve.paper.project import projected
from robolayout.solve.paper.solver import Compared, LossAt
from robolayout.solve.solution import Solution

optimize: Any = scipy.optimize


@dataclass(frozen=True)
class ScipyConfig:
    """Bounds of the search."""

    tolerance: float = 1.0e-12  # gtol, xtol and barrier_tol of the paper
    iterations: int = 300  # most iterations of `trust-constr`
    evaluations: int = 4000  # evaluations of the loss after which `dual-annealing` starts no further round
    rounds: int = 100  # most rounds of annealing
    polish: int = 60  # iterations of `trust-constr` that follow annealing, to put headings on the unit circle


@dataclass
class ScipySolver(Compared):
    """Solves one problem with one of SciPy's optimisers."""

    config: ScipyConfig = ScipyConfig()

    def __post_init__(self) -> None:
        super().__post_init__()
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        corners = (x0, y0, -1.0, -1.0), (x1, y1, 1.0, 1.0)
        self.low, self.high = (np.tile(corner, len(self.free)) for corner in corners)
        self.last = (np.empty(0), LossAt(0.0, np.empty(0), np.empty(0)))

    def trust_constr(self) -> Solution:
        """Return the layout that a trust-region interior point method ends with."""
        self.progress("search")
        return self._concluded(self._trust_constr(self.start[self.free].ravel(), self.config.iterations))

    def dual_annealing(self) -> Solution:
        """Return the layout that annealing with gradient descents in between ends with, headings put on the circle last."""
        if not self.free:
            return self._concluded(np.empty(0))
        self.progress("search")
        bounds = list(zip(self.low, self.high, strict=True))
        found = optimize.dual_annealing(
            self._value,
            bounds,
            maxiter=self.config.rounds,
            maxfun=self.config.evaluations,
            x0=np.clip(self.start[self.free].ravel(), self.low, self.high),
            seed=self.seed,
            minimizer_kwargs={"method": "L-BFGS-B", "jac": self._gradient, "bounds": bounds},
            callback=self._record,
        )
        self.progress("polish")
        polished = self._trust_constr(found.x, self.config.polish)
        return self._concluded(min((polished, found.x), key=self._value))

    def _trust_constr(self, x: Floats, iterations: int) -> Floats:
        if not self.free:
            return x
        count = len(self.free)
        rows = np.repeat(np.arange(count), 2)
        columns = (4 * np.arange(count)[:, None] + [2, 3]).ravel()

        def slope(value: Floats) -> Any:
            return csr_matrix((2 * value[columns], (rows, columns)), shape=(count, 4 * count))

        def bend(_value: Floats, multipliers: Floats) -> Any:
            return diags_array(np.outer(2 * multipliers, [0.0, 0.0, 1.0, 1.0]).ravel())

        def length(value: Floats) -> Floats:
            return np.sum(value.reshape(-1, 4)[:, 2:] ** 2, axis=1)

        tolerances = dict.fromkeys(("gtol", "xtol", "barrier_tol"), self.config.tolerance)
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "delta_grad == 0.0")  # where everything is met the loss is flat
            found = optimize.minimize(
                self._value,
                _on_circle(np.clip(x, self.low, self.high)),
                jac=self._gradient,
                method="trust-constr",
                bounds=optimize.Bounds(self.low, self.high),
                constraints=[optimize.NonlinearConstraint(length, 1.0, 1.0, jac=slope, hess=bend)],
                options={**tolerances, "maxiter": iterations},
                callback=self._record,
            )
        return found.x

    def _world(self, x: Floats) -> Floats:
        world = self.start.copy()
        world[self.free] = x.reshape(-1, 4)
        return world

    def _at(self, x: Floats) -> LossAt:
        """Return the loss at x; SciPy asks for its value and its gradient one after the other."""
        if not np.array_equal(x, self.last[0]):
            self.last = (x.copy(), self.loss(self._world(x)))
        return self.last[1]

    def _value(self, x: Floats) -> float:
        return self._at(x).value

    def _gradient(self, x: Floats) -> Floats:
        return self._at(x).gradient[self.free].ravel()

    def _record(self, x: Floats, *_state: object) -> None:
        """Keep a step; SciPy's methods tell more of it, each in its way."""
        self.record("search", self._at(x), self._world(_on_circle(x)))

    def _concluded(self, x: Floats) -> Solution:
        """Return the better of the raw result and of that after the hard corrections."""
        raw = self._world(_on_circle(x))
        return self.best_of(projected(self.problem, raw), raw)


def _on_circle(x: Floats) -> Floats:
    """Return variables with headings of length 1; the zero heading faces +x."""
    poses = x.reshape(-1, 4).copy()
    length = np.linalg.norm(poses[:, 2:], axis=1, keepdims=True)
    poses[:, 2:] = np.where(length > 1e-9, poses[:, 2:] / np.maximum(length, 1e-9), [1.0, 0.0])
    return poses.ravel()
