"""The paper's total loss (its section "Reachability Constraint", last equations) and its gradient, in double precision.

    L_total = 1000 sum IoU(i, j) - sum IoU(upper, lower) + sum w r(statement) + 0.01 sum max(0, R_ij - D_ij)

over the pairs that must not overlap, the stacks, the rows of the statements, and the pairs that must let the agent pass.

What a statement refers to does not come to meet it: in the paper's solver the gradient of a statement goes to what it moves, that
is its first argument, of `symmetric_pair` both things. Without `table.held` it is the plain gradient of L, as SciPy needs it.
"""

from __future__ import annotations

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from robolayout._geometry import Body, intersection_over_union
from robolayout.solve.arrays import statement_residuals, yielding
from robolayout.solve.paper.solver import Table

OVERLAP = 1000.0
"""Scale of the overlap loss (the paper's table of constraints)."""

REACH = 0.01
"""Scale of the loss of pairwise reach (section "Reachability Constraint")."""

SHRINK = 0.1
"""L = 0.1 L_total (section "Objective Function")."""

TINY = 1.0e-24
"""Below the root of a heading's length, so that it has a slope everywhere."""


def value_and_gradient(
    poses: Float[Array, "slots 4"], table: Table
) -> tuple[Float[Array, ""], Float[Array, "slots 4"], Float[Array, " terms"]]:
    """Return L, its gradient along (x, y, cos, sin), and its terms before scaling: overlap, statements, reach."""

    def loss(value: Array) -> tuple[Array, Array]:
        terms = loss_terms(value, table)
        return SHRINK * jnp.sum(terms), terms

    (value, terms), gradient = jax.value_and_grad(loss, has_aux=True)(poses)
    return value, gradient, terms


def loss_terms(poses: Float[Array, "slots 4"], table: Table) -> Float[Array, " terms"]:
    """Return the overlap, statement and reach terms of L_total.

    Headings are normalised first, so that of (cos, sin) only what turns a thing has a slope.
    """
    norm = jnp.sqrt(poses[:, 2] ** 2 + poses[:, 3] ** 2 + TINY)
    moving = jnp.stack([*poses[:, :2].T, poses[:, 2] / norm, poses[:, 3] / norm, *table.half.T, 0.0 * norm], axis=-1)
    bodies = jnp.concatenate([moving, table.fixed])

    def take(index: Array) -> Body:
        return Body(*bodies[index].T)

    first, second = take(table.pairs[:, 0]), take(table.pairs[:, 1])
    overlap = OVERLAP * jnp.sum(table.pair_weight * intersection_over_union(first, second))
    squared = (first.x - second.x) ** 2 + (first.y - second.y) ** 2
    reach = REACH * jnp.sum(jnp.maximum(table.required**2 - squared, 0.0))
    loose = 1.0 - table.held
    covered = intersection_over_union(take(table.stacks[:, 0]), yielding(take(table.stacks[:, 1]), loose))
    framed, mirrored = statement_residuals(take, table, loose)
    said = jnp.sum(table.frame_row[:, -1] * framed) + jnp.sum(table.mirror_weight * mirrored)
    statements = said - jnp.sum(table.stack_weight * covered)
    return jnp.stack([overlap, statements, reach])
