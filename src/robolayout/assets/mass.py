"""Where the mass of a thing is: its parts by what they are made of, hollow ones hollow, feet that carry something tall weighted."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from robolayout._errors import AssetError
from robolayout.assets.category import CATALOGUE, read_data
from robolayout.assets.lexicon import category_of
from robolayout.assets.part import Part
from robolayout.assets.prisms import PRISMS
from robolayout.scene import Asset

LOW = (0.2, 0.06)  # share of a thing's height, and metres, below both of which a foot ends that is weighted


@lru_cache(maxsize=2048)
def centre_of_mass(asset: Asset) -> tuple[float, float, float]:
    """Return the centre of mass of a thing in its own frame, metres; the middle of its box where it cannot be drawn."""
    from robolayout.assets.meshes import parts

    kind = category_of(asset)
    known = kind.name in CATALOGUE and not (asset.path or asset.parts)
    if known and max(asset.size) < PRISMS.small and asset.size != kind.size:
        usual = centre_of_mass(Asset(kind.name, kind.name, kind.size))
        x, y, z = (c * a / b for c, a, b in zip(usual, asset.size, kind.size, strict=True))
        return (x, y, z)
    try:
        made = parts(asset)
    except AssetError:
        return (0.0, 0.0, 0.0)
    weights, middles = part_masses(made)
    x, y, z = (weights @ middles / weights.sum()).tolist()
    return (x, y, z)


def part_masses(made: tuple[Part, ...]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the masses (n,) of parts in kg and their centres of mass (n, 3) in metres.

    A part weighs density x min(volume, surface x wall): a board is solid, a cupboard is five boards.
    """
    z = np.concatenate([part.vertices[:, 2] for part in made])
    low, reach = z.min(), np.ptp(z)
    data, weights, middles = read_data("bulk.toml"), np.empty(len(made)), np.empty((len(made), 3))
    for i, part in enumerate(made):
        own, of = part.name, part.material.name
        rows = (row for row in data["bulk"] if own in row.get("parts", ()) or any(word in of for word in row["of"]))
        row = next(rows, data["usual"])  # kg/m3, and metres of wall
        foot = part.vertices[:, 2].max() - low <= min(LOW[0] * reach, LOW[1])
        weighted = any(word in own for word in data["feet"] if foot) or own in data["solid"]
        volume, surface, inner, outer = _measured(part)
        shell = surface * row["wall"]
        hollow = shell < volume and not weighted
        weights[i] = max(row["density"] * (shell if hollow else volume), 1e-9)
        middles[i] = outer if hollow else inner
    return weights, middles


def _measured(part: Part) -> tuple[float, float, NDArray[np.float64], NDArray[np.float64]]:
    """Return volume and surface of a part, and the middles of both."""
    corners = part.vertices[part.faces]
    middle = part.vertices.mean(axis=0)
    a, b, c = (corners[:, i] - middle for i in range(3))
    cross = np.cross(b - a, c - a)
    areas = np.linalg.norm(cross, axis=1) / 2
    sixth = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    volume = float(abs(sixth.sum()))
    outer = middle + areas @ (a + b + c) / (3 * max(areas.sum(), 1e-12))
    inner = middle + sixth @ (a + b + c) / (4 * sixth.sum()) if volume > 1e-12 else outer
    return volume, float(areas.sum()), inner, outer
