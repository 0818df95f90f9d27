"""The arrays that a compiled search takes: everything about a scene is data, padded to a few sizes.

Below, the fields say the shapes: K starts, A asset slots, F fixed bodies, S prisms, P pairs, R frame rows, M mirror rows, G clear
boxes, E room edges, Q inner corners, T route points.
"""

from __future__ import annotations

from typing import NamedTuple

from robolayout._geometry import Array


class Arrays(NamedTuple):
    """One stage of a problem as arrays."""

    half: Array  # (A, 2) half depth and half width in metres; 0 for padding
    anchor: Array  # (A, 4) pose (x, y, cos, sin) that each slot's variables are relative to
    carrier: Array  # (A,) slot whose moving pose a slot is rigidly attached to; -1 for none
    limit: Array  # (A, 2) half sizes in metres of the rectangle around the anchor that a slot's box stays in
    free: Array  # (A, 3) 1 where the slot moves in this stage along x and y, and turns
    fixed: Array  # (F, 7) walls and points as bodies (x, y, cos, sin, half x, half y, core)
    prism_slot: Array  # (S,) slot that each prism belongs to
    prism: Array  # (S, 5) centre and half size in the frame of the slot, and how much its corners are cut, metres
    pairs: Array  # (P, 2) prisms that must not overlap; twice the same for padding
    edges: Array  # (E, 4) room outline
    inner: Array  # (Q, 2) corners of the room that point inwards
    inside: Array  # (A,) weight of staying in the room, where the rectangle alone does not keep a slot in it
    frame_index: Array  # (R, 2) bodies a and b of each frame row (slots first, then fixed bodies)
    frame_row: Array  # (R, 20) numbers of each frame row
    mirror_index: Array  # (M, 3) bodies a, b and axis
    mirror_weight: Array  # (M,) 0 for padding
    mirror_normal: Array  # (M,) 1 where the axis is a wall
    clear_owner: Array  # (G,) body that each clear box belongs to
    clear_box: Array  # (G, 4) centre and half size in the owner's frame, metres
    clear_weight: Array  # (G, A) weight of keeping each slot out of each box


class Near(NamedTuple):
    """What may touch within the next steps."""

    pairs: Array  # (M, 2) prisms, or (K, M, 2) each start's own
    clears: Array  # (C, 2) clear box and slot, or (K, C, 2) each start's own


class Routes(NamedTuple):
    """What must not stand in the way, per start."""

    point: Array  # (K, T, 2) points of routes in metres
    slot: Array  # (K, T) slot that is near the point
    need: Array  # (K, T) metres that the slot must keep from the point; 0 for padding


class Schedule(NamedTuple):
    """How one run of the search goes (all scalars)."""

    steps: Array  # number of steps
    rate: Array  # first step size of positions (metres) and headings
    final_rate: Array  # last step size


class Losses(NamedTuple):
    """The terms of the objective for each start, each (K,)."""

    overlap: Array
    boundary: Array
    clear: Array
    statements: Array
    reachability: Array


SNAPSHOTS = 40
"""Poses that one run records."""

HISTORY = 512
"""Steps whose losses one run records."""


class Found(NamedTuple):
    """What a run returns."""

    local: Array  # (K, A, 4) variables
    world: Array  # (K, A, 4) poses in the room
    losses: Losses  # terms per start, at full weights
    history: Array  # (HISTORY, 5) terms of the start with the lowest final objective, unused rows 0
    shots: Array  # (SNAPSHOTS, A, 4) poses of that start, evenly spaced over the steps
