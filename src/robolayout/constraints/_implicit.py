"""What belongs to every program: things keep apart, doors stay clear, and what has doors or drawers can be opened."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations

import shapely

from robolayout.assets import category_of, sweeps_of
from robolayout.constraints._overlap import meeting_prisms
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import ClearTerm, OverlapTerm, Term
from robolayout.constraints.keep_clear import strip_span
from robolayout.scene import OPENINGS, Layout, Room, Scene


def implicit_terms(scene: Scene, near: Layout) -> tuple[Term, ...]:
    """Return the solver's rows of no statement; that all stays within the walls needs none, the solver keeps every asset there."""
    return (*_apart(scene, near), *_landings(scene.room), *_room_to_open(scene, near))


def _apart(scene: Scene, near: Layout) -> Iterator[Term]:
    """Yield one row per pair of prisms that share a height; flat rugs may lie under furniture."""
    for a, b in combinations(scene.assets, 2):
        for first, second in meeting_prisms(a, b, near):
            yield OverlapTerm(AssetRef(a.name), AssetRef(b.name), first, second)


def _landings(room: Room) -> Iterator[Term]:
    """Yield one strip per door, in the frame of its wall: nothing below 2 m stands in it."""
    for door in room.doors:
        near, _, _, beyond = room.landing(door)
        half = math.dist(near, beyond) / 2
        center = (door.center - room.walls[door.wall].length / 2, half)
        yield ClearTerm(WallRef(door.wall), center, (door.width / 2, half), (0.0, OPENINGS.landing_height))


def _room_to_open(scene: Scene, near: Layout) -> Iterator[Term]:
    """Yield one strip per thing that opens, around all that it sweeps; movable things (chairs) may stand there."""
    movable = frozenset(asset.name for asset in scene.assets if category_of(asset).movable)
    for asset in scene.assets:
        if (sweeps := sweeps_of(asset)) and not asset.on_ceiling:
            me = AssetRef(asset.name)
            x0, y0, x1, y1 = shapely.total_bounds([sweep.region for sweep in sweeps]).tolist()
            center, half = ((x0 + x1) / 2, (y0 + y1) / 2), ((x1 - x0) / 2, (y1 - y0) / 2)
            yield ClearTerm(me, center, half, strip_span(scene, near, me), movable, hard=False)
