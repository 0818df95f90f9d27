"""How a mesh of unknown axes stands: turned each of 24 ways and compared with the things of this catalogue that it is said to be.

Points drawn evenly on both surfaces, each fitted into a unit box, are compared by their mean distance to the nearest point of
the other (Chamfer distance); how unevenly the box would have to be stretched counts, too. The difference between the best way
and the best one with another axis says how sure that axis is.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from robolayout.assets.category import Category
from robolayout.assets.meshes import builder_for
from robolayout.assets.own import AXES
from robolayout.assets.palette import make_piece
from robolayout.assets.part import fit

if TYPE_CHECKING:
    from scipy.spatial import KDTree

Array = NDArray[np.float64]
Faces = Iterable[tuple[Array, NDArray[np.integer]]]


@dataclass(frozen=True)
class LikenessConfig:
    """How two shapes are compared."""

    samples: int = 500  # points on a surface
    stretch: float = 0.08  # what an edge too long by a factor of e counts, in edges of the unit box
    # what it counts if the axis that points up, or forward, is not where the format puts it: the second is often wrong
    standard: tuple[float, float] = (0.1, 0.03)
    certain: float = 0.05  # difference in edges of the unit box from which on an axis is certain


LIKENESS = LikenessConfig()

SEEDS = range(4)  # seeds whose variants of a thing are compared with
WAYS = tuple((up, front) for up, front in product(AXES, AXES) if up[1] != front[1])
"""The 24 ways to stand: the axis that points up and the one that points forward."""


def sampled(surfaces: Faces) -> Array:
    """Return SAMPLES points (n, 3) spread evenly over triangles."""
    corners = np.concatenate([points[np.asarray(faces)] for points, faces in surfaces])
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    rng = np.random.default_rng(0)
    if not area.sum() > 0:
        return corners.reshape(-1, 3)[: LIKENESS.samples]
    chosen = corners[rng.choice(len(corners), LIKENESS.samples, p=area / area.sum())]
    a, b = np.sort(rng.random((2, LIKENESS.samples)), axis=0)
    return np.einsum("kn,nkd->nd", np.array([a, b - a, 1 - b]), chosen)


def stands(
    points: Array, category: Category, standard: tuple[str, str] | None, allowed: Sequence[tuple[str, str]]
) -> tuple[str, str, float, float]:
    """Return which axis of a mesh most likely points up and which forward, and how sure each is, 0 to 1, if those before it are.

    Its points (n, 3) are in its own axes; `standard` are up and front as its format has them, `allowed` are some of `WAYS`.
    """
    misfits = {way: _misfit(points, way, category, standard) for way in allowed}
    up, front = best = min(misfits, key=lambda way: misfits[way])
    rivals = ([way for way in misfits if way[0] != up], [way for way in misfits if way[0] == up and way != best])
    up_sure, front_sure = (
        round(min((min((misfits[way] for way in ways), default=math.inf) - misfits[best]) / LIKENESS.certain, 1.0), 2)
        for ways in rivals
    )
    return up, front, up_sure, front_sure


def _misfit(points: Array, way: tuple[str, str], category: Category, standard: tuple[str, str] | None) -> float:
    """Return how unlike a mesh that stands in one way is to its category."""
    up, front = (np.array(AXES[name]) for name in way)
    turned = points @ np.array([front, np.cross(up, front), up]).T
    edges = np.maximum(np.ptp(turned, axis=0), 1e-9)
    stretch = np.log(edges / np.array(category.size))
    here = _unit(turned)
    tree = _tree(here)
    apart = min(
        (float(other.query(here)[0].mean()) + float(tree.query(there)[0].mean())) / 2
        for there, other in _models(category)
    )
    off = sum(cost for cost, a, b in zip(LIKENESS.standard, way, standard or way, strict=True) if a != b)
    return apart + LIKENESS.stretch * float(np.ptp(stretch)) + off


def _tree(points: Array) -> KDTree:
    from scipy.spatial import KDTree  # takes half a second to import, and most rooms have no meshes of their own

    return KDTree(points)


def _unit(points: Array) -> Array:
    """Return points fitted into a unit box about the origin."""
    low, high = points.min(axis=0), points.max(axis=0)
    return (points - (low + high) / 2) / np.maximum(high - low, 1e-9)


@lru_cache(maxsize=32)
def _models(category: Category) -> tuple[tuple[Array, KDTree], ...]:
    """Return points on variants of a category's own thing, and a tree to find the nearest of them."""
    found: list[tuple[Array, KDTree]] = []
    for seed in SEEDS:
        piece = make_piece(category.name, category.name, category.name, category.size, seed)
        built = fit(builder_for(category)(piece), category.size)
        points = _unit(sampled((part.vertices, part.faces) for part in built))
        found.append((points, _tree(points)))
    return tuple(found)
