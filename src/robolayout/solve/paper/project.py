"""Hard corrections of a layout, as the paper makes them: back into the room, and onto what carries a thing.

The out-of-bounds correction has two cases (section "Out-of-Bounds Placement Constraint"). With P the room, P_eps the room grown
by the tolerance eps, c_P its centroid and delta the margin, a point p that is out is answered by the move

    tau(p) = v (|p_proj - p| + eps + delta),   p_proj = nearest point of the outline,   v = (c_P - p_proj) / |c_P - p_proj|

Case 1, all corners out: the thing moves by tau of its centre. Case 2, some out: by the mean of tau over those corners. This
is repeated until no corner is out, at most `MOST_ROUNDS` times.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from robolayout.scene import Room
from robolayout.solve.compile import Floats, Problem

MARGIN = 0.15
"""delta of the paper: metres that a thing is put further in than it must."""

MOST_ROUNDS = 10
"""M of the paper."""

TOLERANCE = 0.01
"""eps of the paper, which gives no figure: metres that count as inside, as in the exact check (DESIGN section 4)."""


def footprint(pose: Floats, half: Floats) -> Floats:
    """Return the corners (4, 2) of a box at a pose (x, y, cos, sin)."""
    x, y, c, s = pose
    signs = np.array([[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]]) * half
    return signs @ np.array([[c, s], [-s, c]]) + (x, y)


def outside(room: Room, corners: Floats) -> NDArray[np.bool_]:
    """Return which points (n, 2) lie outside the room grown by the tolerance."""
    return np.asarray(shapely.distance(Polygon(room.vertices), shapely.points(corners))) > TOLERANCE


def correction(room: Room, corners: Floats, centre: Floats) -> Floats:
    """Return the move (2,) in metres that one round of the correction makes; zero if no corner is out."""
    out = outside(room, corners)
    if not out.any():
        return np.zeros(2)
    targets, polygon = centre[None] if out.all() else corners[out], Polygon(room.vertices)
    along = shapely.line_locate_point(polygon.exterior, shapely.points(targets))
    nearest = shapely.get_coordinates(shapely.line_interpolate_point(polygon.exterior, along))
    inward = shapely.get_coordinates(polygon.centroid) - nearest
    length, depth = (np.sqrt(np.vecdot(way, way))[:, None] for way in (inward, nearest - targets))
    # The centroid of a concave room may lie on its outline.
    return np.mean(inward / np.where(length > 0.0, length, 1.0) * (depth + TOLERANCE + MARGIN), axis=0)


def into_room(room: Room, pose: Floats, half: Floats) -> Floats:
    """Return a pose (x, y, cos, sin) moved into the room by the two-case correction."""
    pose = pose.copy()
    for _ in range(MOST_ROUNDS):
        move = correction(room, footprint(pose, half), pose[:2])
        if not move.any():
            break
        pose[:2] += move
    return pose


def onto_carrier(pose: Floats, carrier: Floats, half: Floats) -> Floats:
    """Return a pose with its centre moved to the nearest point over its carrier's top of half sizes `half`."""
    pose = pose.copy()
    c, s = carrier[2:]
    frame = np.array([[c, s], [-s, c]])
    pose[:2] = carrier[:2] + np.clip(frame @ (pose[:2] - carrier[:2]), -half, half) @ frame
    return pose


def projected(problem: Problem, world: Floats) -> Floats:
    """Return world poses (n, 4) with every free thing in the room and, lower ones first, on what carries it."""
    world = world.copy()
    for slot in sorted(range(len(world)), key=problem.stage.__getitem__):
        if problem.names[slot] in problem.pinned:
            continue
        world[slot] = into_room(problem.scene.room, world[slot], problem.half[slot])
        parent = problem.parent[slot]
        if parent >= 0:
            world[slot] = onto_carrier(world[slot], world[parent], problem.half[parent])
    return world
