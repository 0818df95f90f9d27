"""The file of a robot that is being read: what it may still use, and points on its shapes.

The file is hostile: entities and document types are refused, and other files are read only from its own folder or package.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from robolayout._errors import AgentError, MissingExtraError
from robolayout._reading import LIMITS, Checker, inside, regular_bytes, show
from robolayout._reading.mesh import mesh_pieces
from robolayout._reading.syntax import xml_root

Matrix = NDArray[np.float64]

MESH_SUFFIXES = (".stl", ".obj", ".ply", ".dae")  # kinds of mesh that are read
CHECK = Checker(AgentError)
_CIRCLE, _BETWEEN = 64, 300


@dataclass
class Model:
    """The file that is being read, and what it may still use."""

    path: Path  # the file
    bytes_left: int = LIMITS.model_bytes  # bytes of other files that may still be read
    points_left: int = LIMITS.model_points  # points that its shapes may still have
    parts_left: dict[str, int] = field(default_factory=dict[str, int])  # parts of each kind that it may still have
    # vertices of the meshes read so far, in their own unit
    meshes: dict[Path, Matrix] = field(default_factory=dict[Path, Matrix])

    def fail(self, message: str) -> AgentError:
        """Return an error about this file."""
        return AgentError(f"agent file {self.path}: {message}")

    def count(self, what: str, number: int = 1) -> None:
        """Note further parts of a kind; too many are an error."""
        left = self.parts_left.get(what, LIMITS.model_parts) - number
        if left < 0:
            raise self.fail(
                f"has {LIMITS.model_parts - left} <{what}> elements; at most {LIMITS.model_parts} are allowed."
            )
        self.parts_left[what] = left

    def root(self, path: Path) -> tuple[Element, str]:
        """Return the root element of an XML file, and its text."""
        text = CHECK.read_text(path, "agent file")
        self.take(len(text))
        return CHECK.parse(xml_root, text, f"agent file {path}"), text

    def take(self, size: int) -> None:
        """Note that so many bytes were read."""
        self.bytes_left -= size
        if self.bytes_left < 0:
            raise self.fail(f"its meshes are larger than {LIMITS.model_bytes // 1_000_000} MB together; simplify them.")

    def numbers(self, text: str | None, where: str, count: int) -> list[float]:
        """Return the numbers of an attribute; zeros if it is not there."""
        parts = ["0"] * count if text is None else text.split()
        place = f"agent file {self.path}: {where}"
        try:
            values = [float(part) for part in parts]
        except ValueError:
            raise AgentError(f"{place} must be {count} numbers, but is {show(text)}.") from None
        return list(CHECK.numbers(values, place, (count,)))

    def sizes(self, text: str | None, where: str, count: int) -> list[float]:
        """Return the lengths in metres of an attribute, all above 0."""
        place = f"agent file {self.path}: {where}"
        return [CHECK.number(v, f"{place} (metres)", above=0.0) for v in self.numbers(text or "nothing", where, count)]

    def placed(self, points: Matrix, pose: Matrix) -> Matrix:
        """Return points (n, 3) of a shape at its pose (4, 4)."""
        self.points_left -= len(points)
        if self.points_left < 0:
            raise self.fail(f"its collision shapes have more than {LIMITS.model_points} points; simplify its meshes.")
        found = points @ pose[:3, :3].T + pose[:3, 3]
        if not np.isfinite(found).all():
            raise self.fail("its collision geometry has coordinates that are not finite.")
        return found

    def find(self, filename: str, what: str, kinds: Sequence[str]) -> Path:
        """Return a file that the model names: relative to it, or `package://<package>/...` in a folder of that name above."""
        if Path(filename).suffix.lower() not in kinds or "\0" in filename:
            raise self.fail(f"{what} {show(filename)} is of no kind that is read ({', '.join(kinds)}); convert it.")
        home = self.path.resolve().parent
        folders, where = [home, home.parent], "the model's folder or package"
        rest = filename.removeprefix("file://")
        if filename.startswith("package://"):
            package, _, rest = filename.removeprefix("package://").partition("/")
            folders = [folder for folder in (home, *home.parents[:4]) if folder.name == package] or folders
            where = f"a folder {show(package)} around the model"
        for folder in folders:
            if inside(folder / rest, folders) and os.path.isfile(folder / rest):
                return (folder / rest).resolve()
        raise self.fail(f"{what} {show(filename)} is not in {where}; put it there.")

    def mesh(self, filename: str) -> Matrix:
        """Return the vertices (n, 3) of a mesh file of the model's package."""
        path = self.find(filename, "mesh", MESH_SUFFIXES)
        if path in self.meshes:
            return self.meshes[path]
        what, suffix = f"agent file {self.path}: mesh {path.name}", path.suffix.lower()
        if suffix == ".dae" and find_spec("collada") is None:
            raise MissingExtraError(f"{what}, a COLLADA file,", "sim")
        content = CHECK.parse(lambda file: regular_bytes(file, LIMITS.model_bytes), path, what)
        self.take(len(content))
        pieces = CHECK.parse(lambda data: mesh_pieces(data, suffix), content, what)
        self.meshes[path] = np.concatenate([piece.vertices for piece in pieces])
        return self.meshes[path]


def transform(at: Sequence[float] | Matrix, turn: Rotation | None = None) -> Matrix:
    """Return the 4 x 4 transform of a place and a rotation about it."""
    pose = np.eye(4)
    pose[:3, 3] = at
    if turn is not None:
        pose[:3, :3] = turn.as_matrix()
    return pose


def box(half: Sequence[float]) -> Matrix:
    """Return the corners of a box with these half sides."""
    return np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.asarray(half)


def cylinder(radius: float, half: float) -> Matrix:
    """Return points around both ends of a cylinder along z."""
    return _both(ball((radius, radius, radius))[:_CIRCLE], half)


def capsule(radius: float, half: float) -> Matrix:
    """Return points on both ends of a cylinder along z with round ends; `half` is the length of its straight half."""
    return _both(ball((radius, radius, radius)), half)


def ball(radii: Sequence[float]) -> Matrix:
    """Return points on an ellipsoid: on its three great circles, that in plan first, and between them."""
    turns = np.arange(_CIRCLE) * (2 * math.pi / _CIRCLE)
    ring = np.stack([np.cos(turns), np.sin(turns), np.zeros(_CIRCLE)], axis=1)
    around = np.concatenate([ring, np.roll(ring, 1, axis=1), np.roll(ring, 2, axis=1), spread(_BETWEEN)])
    return around * np.asarray(radii)


def spread(count: int) -> Matrix:
    """Return directions (count, 3) spread evenly on a sphere, along a spiral by the golden ratio."""
    k = np.arange(count) + 0.5
    z, turn = 1 - 2 * k / count, math.pi * (1 + math.sqrt(5)) * k
    return np.column_stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z])


def _both(points: Matrix, half: float) -> Matrix:
    """Return points moved up and down by so many metres."""
    rise = np.array([0.0, 0.0, half])
    return np.concatenate([points + rise, points - rise])
