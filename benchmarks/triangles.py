"""Exactly: how deep the parts that are drawn and exported go into each other, by python-fcl, whatever shapes say."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.assets import Part, parts
from robolayout.scene import Layout, Scene

ALLOWED = 0.002
"""Metres that a part may go into another thing's: what is rounded when things are stood on each other."""


@dataclass(frozen=True)
class Penetration:
    """Two things whose parts go into each other.

    Attributes:
        a: A thing.
        b: Another one.
        depth: Metres by which one part would have to move to leave the other.
        parts: Names of the two parts.
    """

    a: str
    b: str
    depth: float
    parts: tuple[str, str]


def penetrations(scene: Scene, layout: Layout, allowed: float = ALLOWED) -> list[Penetration]:
    """Return what goes deeper into another thing than allowed, the deepest first; rugs, through which things stand, aside."""
    made = {a.name: _placed(parts(a), layout, a.name) for a in scene.assets if a.name in layout and not a.is_flat}
    bounds = {name: _bounds([vertices for _, vertices, _ in pieces]) for name, pieces in made.items()}
    found: list[Penetration] = []
    for a, b in combinations(made, 2):
        if _near(bounds[a], bounds[b]):
            worst = max(_depths(made[a], made[b]), default=(0.0, ("", "")))
            if worst[0] > allowed:
                found.append(Penetration(a, b, *worst))
    return sorted(found, key=lambda item: -item.depth)


Piece = tuple[Part, NDArray[np.float64], Any]


def _placed(made: tuple[Part, ...], layout: Layout, name: str) -> list[Piece]:
    """Return parts, their corners in the room, and what fcl makes of them."""
    import fcl

    pose = layout[name]
    c, s = math.cos(pose.yaw), math.sin(pose.yaw)
    turn = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    pieces: list[Piece] = []
    for part in made:
        vertices = part.vertices @ turn + (pose.x, pose.y, pose.z)
        if part.convex:
            faces = np.column_stack([np.full(len(part.faces), 3), part.faces]).ravel()
            shape = fcl.Convex(vertices, len(part.faces), faces)
        else:
            shape = fcl.BVHModel()
            shape.beginModel(len(vertices), len(part.faces))
            shape.addSubModel(vertices, part.faces)
            shape.endModel()
        pieces.append((part, vertices, fcl.CollisionObject(shape)))
    return pieces


def _depths(first: list[Piece], second: list[Piece]) -> Iterator[tuple[float, tuple[str, str]]]:
    """Yield how deep parts of two things go into each other."""
    import fcl

    for one, corners, shape in first:
        for other, more, against in second:
            if _near(_bounds([corners]), _bounds([more])):
                result = fcl.CollisionResult()
                fcl.collide(shape, against, fcl.CollisionRequest(num_max_contacts=16, enable_contact=True), result)
                for contact in result.contacts:
                    yield abs(contact.penetration_depth), (one.name, other.name)


def _bounds(points: list[NDArray[np.float64]]) -> NDArray[np.float64]:
    every = np.concatenate(points)
    return np.stack([every.min(axis=0), every.max(axis=0)])


def _near(a: NDArray[np.float64], b: NDArray[np.float64]) -> bool:
    """Return whether two bounds share more than is allowed along every axis."""
    return bool((np.minimum(a[1], b[1]) - np.maximum(a[0], b[0]) > ALLOWED).all())
