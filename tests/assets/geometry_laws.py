"""What every parametric mesh must obey; shared by the tests of furniture and rooms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from shapely import Polygon, STRtree

from robolayout.assets import Part

NEAR = 5e-4
"""Two parallel faces closer than this flicker (metres)."""


def triangles(part: Part) -> np.ndarray:
    """Corners of all faces, (m, 3, 3)."""
    return part.vertices[part.faces]


def normals(part: Part) -> np.ndarray:
    """Face normals times twice their areas, (m, 3)."""
    t = triangles(part)
    return np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])


def is_closed(part: Part) -> bool:
    """Whether every edge is walked once in each direction."""
    f = part.faces
    edges = np.concatenate([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]])
    forward = {(int(a), int(b)) for a, b in edges}
    return len(forward) == len(edges) and all((b, a) in forward for a, b in forward)


def dent(part: Part) -> float:
    """How far a vertex sticks out of another face's plane, in metres; zero for a convex, outward-facing part."""
    n = normals(part)
    length = np.linalg.norm(n, axis=1)
    keep = length > 1e-12
    unit = n[keep] / length[keep, None]
    origin = triangles(part)[keep, 0]
    return float(np.max((part.vertices[None] - origin[:, None]).transpose(0, 2, 1).swapaxes(1, 2) @ unit[:, :, None]))


def flicker(parts: Sequence[Part]) -> list[tuple[str, str, float]]:
    """Pairs of parts whose outer faces lie in one plane, look the same way and overlap, with the area in m2."""
    rows = [(i, n, t) for i, p in enumerate(parts) for n, t in zip(normals(p), triangles(p), strict=True)]
    found: dict[tuple[int, int], float] = {}
    groups: dict[tuple[float, ...], list[tuple[int, float, np.ndarray]]] = {}
    for i, n, t in rows:
        length = np.linalg.norm(n)
        if length > 1e-9:
            unit = n / length
            groups.setdefault(tuple(np.round(unit, 3) + 0.0), []).append((i, float(unit @ t[0]), t))
    for direction, faces in groups.items():
        found |= _overlaps(np.array(direction), faces)
    return [(parts[a].name, parts[b].name, area) for (a, b), area in found.items()]


def _overlaps(direction: np.ndarray, faces: list[tuple[int, float, np.ndarray]]) -> dict[tuple[int, int], float]:
    """Overlap areas of nearly coplanar faces of different parts, seen along one direction."""
    axes = [a for a in range(3) if a != int(np.argmax(np.abs(direction)))]
    shapes = [Polygon(t[:, axes]) for _, _, t in faces]
    tree = STRtree(shapes)
    found: dict[tuple[int, int], float] = {}
    for k, (i, depth, _) in enumerate(faces):
        for other in tree.query(shapes[k]):
            j, far, _ = faces[other]
            if j > i and abs(far - depth) < NEAR:
                area = shapes[k].intersection(shapes[other]).area
                if area > 1e-6:
                    found[(i, j)] = found.get((i, j), 0.0) + area
    return found


def bounds(parts: Iterable[Part]) -> np.ndarray:
    """Low and high corner of all parts, (2, 3)."""
    points = np.concatenate([p.vertices for p in parts])
    return np.array([points.min(axis=0), points.max(axis=0)])
