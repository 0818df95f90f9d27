"""Physics: is everything placed, apart, inside, held, and are the doors clear?

The exact checks of what belongs to every program, measured with Shapely on the finished layout. Two assets collide when
prisms of theirs share more than 1e-4 m2 in plan and more than 1 cm of height; rugs below 3 cm never collide. What
stands on a thing lies on one of its surfaces with its centre of mass over that.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from robolayout.scene import OPENINGS, Asset, Layout, Room, Scene
from robolayout.verify._boxes import Boxes, Place, boxes, landings, prisms_at, room_polygon, share, shared_area
from robolayout.verify.limits import JUDGE

CHECKS = ("placed", "collision_free", "in_boundary", "supported")  # the verdicts on an asset


@dataclass(frozen=True)
class Collision:
    """Two assets that share space."""

    a: str  # first asset, in the order of the scene
    b: str  # second asset
    area: float  # shared footprint in m2
    height: float  # shared height in metres


@dataclass(frozen=True)
class Obstruction:
    """An asset in a door's landing."""

    door: int  # index of the door
    asset: str  # name of the asset
    area: float  # how much of the landing it takes, m2


@dataclass(frozen=True)
class Physics:
    """What the physical checks found; the mappings hold one verdict per asset of the scene."""

    placed: Mapping[str, bool]  # has a pose
    collision_free: Mapping[str, bool]  # shares no space with another asset
    in_boundary: Mapping[str, bool]  # lies inside the room
    supported: Mapping[str, bool]  # stands on, touches or hangs from what it should
    collisions: tuple[Collision, ...]  # colliding pairs
    boxes_apart: Mapping[str, bool]  # its box shares no space with another asset's: the published rule
    obstructions: tuple[Obstruction, ...]  # what stands in door landings
    reasons: tuple[str, ...]  # for each failing asset, sentences with numbers; in the order of the scene

    @property
    def door_clear(self) -> bool:
        """Whether nothing stands in a landing."""
        return not self.obstructions

    @cached_property
    def shares(self) -> dict[str, float]:
        """The shares over all assets, by the names of DESIGN section 8."""
        return {f"{check}_share": share(list(getattr(self, check).values())) for check in CHECKS}

    @cached_property
    def failing(self) -> tuple[str, ...]:
        """Names of assets that fail any check or block a door, in the order of the scene."""
        blocking = {item.asset for item in self.obstructions}
        checks = [getattr(self, check) for check in CHECKS]
        return tuple(name for name in self.placed if name in blocking or not all(check[name] for check in checks))

    @property
    def ok(self) -> bool:
        """Whether every asset passes every check and the doors are clear."""
        return not self.failing

    def __repr__(self) -> str:
        shares = ", ".join(f"{name.removesuffix('_share')} {value:.2f}" for name, value in self.shares.items())
        return f"Physics({shares}, door_clear {self.door_clear})"


def physics(scene: Scene, layout: Layout) -> Physics:
    """Check a layout's physics; about 2 ms for 40 assets."""
    found = boxes(scene, layout)
    meeting = found.overlapping(np.flatnonzero(found.placed & ~found.flat), JUDGE.area, JUDGE.height + 1e-9)
    hits = [pair for pair in meeting.tolist() if _collides(found, *pair)]
    pairs = tuple(Collision(found.names[a], found.names[b], *_deepest(found.where(a), found.where(b))) for a, b in hits)
    blocked, every = _obstructions(scene, found), np.arange(len(found.names))
    inside, held = _inside(scene, found), _held(scene, found)
    checks = {
        "placed": found.placed,
        "collision_free": found.placed & ~np.isin(every, hits),
        "in_boundary": inside,
        "supported": held,
        "boxes_apart": found.placed & ~np.isin(every, meeting),
    }
    sentences = [f"{found.names[row]} is not placed." for row in np.flatnonzero(~found.placed)]
    sentences += [f"{c.a} and {c.b} overlap by {c.area:.3f} m2 in plan and {c.height:.2f} m in height." for c in pairs]
    sentences += [_outside_sentence(scene, found, int(row)) for row in np.flatnonzero(found.placed & ~inside)]
    sentences += [_floating_sentence(scene, found, int(row)) for row in np.flatnonzero(found.placed & ~held)]
    sentences += [f"{o.asset} takes {o.area:.2f} m2 of the landing of door {o.door}." for o in blocked]
    verdicts = {name: found.by_name(flags) for name, flags in checks.items()}
    return Physics(collisions=pairs, obstructions=blocked, reasons=tuple(sentences), **verdicts)


def _collides(found: Boxes, a: int, b: int) -> bool:
    """Return whether two assets whose boxes meet share more of plan and height by their prisms than allowed, neither in the other."""
    if _deepest(found.where(a), found.where(b))[0] <= JUDGE.area:
        return False
    return not (found.lies_in(a, b, JUDGE.height) or found.lies_in(b, a, JUDGE.height))


@lru_cache(maxsize=4096)
def _deepest(a: tuple[Asset, Place], b: tuple[Asset, Place]) -> tuple[float, float]:
    """Return the largest area in m2 that a prism of one placed asset shares with one of another, and the height that these share.

    Only what shares more than 1 cm of height counts; see `prisms_at` for why it is kept.
    """
    (outlines, low, high), (others, bottom, top) = prisms_at(*a), prisms_at(*b)
    height = np.minimum(high[:, None], top) - np.maximum(low[:, None], bottom)
    i, j = np.nonzero(height > JUDGE.height + 1e-9)
    area = shared_area(outlines[i], others[j])
    worst = int(np.argmax(area)) if len(area) else -1
    return (float(area[worst]), float(height[i[worst], j[worst]])) if worst >= 0 else (0.0, 0.0)


def _obstructions(scene: Scene, found: Boxes) -> tuple[Obstruction, ...]:
    """Return what stands in door landings below the door height; rugs aside."""
    rows = np.flatnonzero(found.placed & ~found.flat & (found.bottom < OPENINGS.landing_height - 1e-9))
    area = shared_area(found.footprints[rows], landings(scene.room)[:, None])  # (doors, rows)
    doors, which = np.nonzero(area > JUDGE.area)
    return tuple(
        Obstruction(d, found.names[rows[k]], float(area[d, k])) for d, k in zip(doors.tolist(), which, strict=True)
    )


def _inside(scene: Scene, found: Boxes) -> NDArray[np.bool_]:
    slack = JUDGE.boundary + 1e-9
    height = (found.bottom >= -slack) & (found.top <= scene.room.wall_height + slack)
    return found.placed & height & shapely.covers(_grown(scene.room), found.footprints)


@lru_cache(maxsize=32)
def _grown(room: Room) -> Polygon:
    """Return the floor with the slack that a footprint has at its edge."""
    grown = room_polygon(room).buffer(JUDGE.boundary)
    shapely.prepare(grown)
    return grown


def _held(scene: Scene, found: Boxes) -> NDArray[np.bool_]:
    """Return what is held in a way that its flags allow: at a wall, from the ceiling, on the floor, or on what is held."""
    assets = scene.assets
    tolerance = JUDGE.carried + 1e-9
    on_wall = np.array([asset.on_wall for asset in assets], dtype=bool)
    stands = np.array([a.on_floor or a.on_object or not (a.on_wall or a.on_ceiling) for a in assets], dtype=bool)
    floor = np.abs(found.bottom) <= tolerance
    ceiling = np.abs(found.top - scene.room.wall_height) <= tolerance
    wall = ~shapely.intersects_xy(room_polygon(scene.room), *_behind(found, tolerance).T)
    held = found.placed & ((stands & floor) | (on_wall & wall) | (found.ceiling & ceiling))
    while True:  # a step up the trees that grow from floor, walls and ceiling; what no tree carries is not held
        carried = [row for row in np.flatnonzero(stands & ~held).tolist() if found.carrier(row, held) >= 0]
        if not carried:
            return held
        held[carried] = True


def _behind(found: Boxes, far: float) -> NDArray[np.float64]:
    """Return (n, 2) the points so many metres behind the middle of each back."""
    away = np.array([asset.size[0] for asset in found.assets]) / 2 + far
    yaw = found.poses[:, 3]
    return found.poses[:, :2] - away[:, None] * np.stack([np.cos(yaw), np.sin(yaw)], axis=1)


def _outside_sentence(scene: Scene, found: Boxes, row: int) -> str:
    name, room = found.names[row], room_polygon(scene.room)
    if found.bottom[row] < -0.01:
        return f"{name} reaches {-found.bottom[row]:.2f} m below the floor."
    if found.top[row] > scene.room.wall_height + 0.01:
        return f"{name} reaches {found.top[row] - scene.room.wall_height:.2f} m above the ceiling."
    out: Polygon = found.footprints[row].difference(room)
    depth = float(shapely.distance(shapely.points(shapely.get_coordinates(out)), room).max())
    return f"{name} sticks {depth:.2f} m out of the room ({out.area:.3f} m2 of its footprint)."


def _floating_sentence(scene: Scene, found: Boxes, row: int) -> str:
    asset, name = scene.assets[row], found.names[row]
    if asset.on_ceiling:
        return f"{name} hangs {scene.room.wall_height - found.top[row]:.2f} m below the ceiling instead of from it."
    if asset.on_wall:
        gap = shapely.Point(_behind(found, 0.0)[row]).distance(room_polygon(scene.room).exterior)
        return f"{name} should hang on a wall but its back is {gap:.2f} m from the nearest one."
    contacts = found.contacts.get(row, {})
    under = " and ".join(found.names[lower] for lower in contacts)
    over = found.overhang(row, contacts) if contacts else 0.0
    if over > 0.0:
        return f"{name} is not supported: its centre of mass lies {over:.3f} m too far out over {under}."
    if contacts:
        return f"{name} is not supported: it stands on {under}, which nothing holds."
    below = np.flatnonzero(found.placed & (found.top <= found.bottom[row] + 1e-9))
    under = below[shapely.intersects_xy(found.footprints[below], *found.poses[row, :2])]
    best = under[np.argmax(found.top[under])] if len(under) else None
    base = "the floor at 0.00 m" if best is None else f"the top of {found.names[best]} at {found.top[best]:.2f} m"
    return f"{name} is not supported: its bottom is at {found.bottom[row]:.2f} m, {base}."
