"""What simulators are told of a room, whatever their format: bodies of links, with colliders, masses, inertias, friction and joints.

The room comes first. A link's frame lies in its joint; the first link of a thing is what of it stays, in the thing's own frame. Every
collider is convex: a box or a part; meshes of users collide as their prisms.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from robolayout.assets import Joint, Material, Part, category_of, prisms_of, room_parts, turned
from robolayout.assets.mass import part_masses
from robolayout.assets.shapes import prism
from robolayout.constraints import covers
from robolayout.export._exporter import (
    Options,
    free_name,
    is_movable,
    kind_name,
    mass,
    placed,
)
from robolayout.export._mesh import Box, FloatArray, as_box, numbers, obj, roll_pitch_yaw, volume
from robolayout.export._rugs import laid_parts
from robolayout.scene import Asset, Layout, Pose, Scene, vertical_span


@dataclass(frozen=True)
class BodyConfig:
    """What simulators need beside the shapes."""

    foot: float = 0.08  # share of a mesh's height that is pressed flat where it stands: pots have round bottoms
    smallest_volume: float = 1e-8  # volume in cubic metres below which a part collides as its box
    smallest_moment: float = 1e-7  # kg m2 that are added to every link's inertia, so that forks do not tremble
    leaf_mass: float = 600.0  # kilograms per cubic metre of the leaf of a door: wood
    slab: float = 0.1  # thickness of the floor that is stood on in metres, and how far it reaches beyond the room
    floor_friction: float = 0.6  # friction of the floor
    on_rug: float = 0.003  # largest gap in metres between a rug's top and what stands on it
    # metres of half thickness that a collider has at least; thinner parts become boxes of that thickness
    thinnest: float = 5e-4
    # least kilograms of a link (kg m2 of a hinge's inertia) that count: fingers weigh next to nothing
    lightest: float = 1e-4


BODIES = BodyConfig()


STICTION = {"hinge": 1.0, "slide": 5.0}
"""Friction of a joint of furniture in N m or N: what it takes to move a cabinet's door or drawer (judgement); a flap stays shut."""
DRAG = {"hinge": 0.5, "slide": 10.0}  # damping of such a joint in N m s/rad or N s/m
Free = Callable[[Asset, Scene, Layout], bool]  # says whether an asset may move as a whole


@dataclass(frozen=True, eq=False)
class BodyShape:
    """One part as a simulator knows it."""

    name: str  # unique in its thing ("leg/3")
    part: Part  # what is seen, in the frame of its link
    box: Box | None = None  # the box that it is or collides as; None for its part
    mass: float = 0.0  # kilograms; 0 for what never moves
    seen: bool = True  # whether it is seen
    touched: bool = True  # whether it collides

    @cached_property
    def data(self) -> bytes:
        """Its mesh as a file."""
        return obj(self.part.vertices, self.part.faces)

    @cached_property
    def mesh(self) -> str:
        """Where its mesh lies in the folder of its thing; other meshes have other names, since MuJoCo overlooks folders in memory."""
        return f"meshes/{hashlib.sha256(self.data).hexdigest()[:16]}.obj"

    @property
    def kinds(self) -> tuple[str, ...]:
        """What URDF and SDF say of it."""
        return ("visual",) * self.seen + ("collision",) * self.touched

    def place(self) -> tuple[str, str, str]:
        """Return place, roll, pitch and yaw, and size of its box as text; no size where it has none."""
        if self.box is None:
            return "0 0 0", "0 0 0", ""
        return (
            numbers(self.box.center.tolist()),
            numbers(roll_pitch_yaw(self.box.rotation)),
            numbers((2 * self.box.half).tolist()),
        )

    def inertia(self) -> tuple[FloatArray, FloatArray]:
        """Return the centre of mass (3,) in metres and the inertia (3, 3) about it in kg m2, of a solid."""
        if self.box is not None:
            square = self.box.half**2
            moments = np.diag(self.mass / 3 * (square.sum() - square))
            return self.box.center, self.box.rotation @ moments @ self.box.rotation.T
        from trimesh.convex import convex_hull
        from trimesh.triangles import mass_properties

        solid = self.part if self.part.convex else convex_hull(self.part.vertices)
        found = mass_properties(np.asarray(solid.vertices)[np.asarray(solid.faces)])
        return np.array(found.center_mass), np.array(found.inertia) * (self.mass / found.mass)


@dataclass(frozen=True, eq=False)
class BodyLink:
    """What of a thing moves as one."""

    shapes: tuple[BodyShape, ...]  # what it is made of
    joint: Joint | None = None  # with what it moves against the thing's first link; None for that one

    @property
    def at(self) -> FloatArray:
        """Where its frame is in that of its thing."""
        return np.zeros(3) if self.joint is None else np.array(self.joint.at)

    def inertia(self) -> tuple[float, FloatArray, FloatArray]:
        """Return mass, centre of mass and the inertia about it; a mass of 0 where nothing has one."""
        solids = [(shape.mass, *shape.inertia()) for shape in self.shapes if shape.mass]
        total = sum(weight for weight, _, _ in solids)
        middle = sum((weight * at for weight, at, _ in solids), np.zeros(3)) / max(total, 1e-12)
        moments = BODIES.smallest_moment * np.eye(3)
        for weight, at, own in solids:
            apart = at - middle
            moments = moments + own + weight * (apart @ apart * np.eye(3) - np.outer(apart, apart))
        return total, middle, moments


@dataclass(frozen=True, eq=False)
class BodyTree:
    """The room or an asset."""

    name: str  # that of the asset, or one for the room
    pose: Pose  # where its frame is
    links: tuple[BodyLink, ...]  # what of it stays, then what moves
    friction: float = BODIES.floor_friction  # coefficient of all that it touches with
    free: bool = False  # whether it may move as a whole; else it is welded to the world
    asset: Asset | None = None  # None for the room

    @property
    def kind(self) -> str:
        """A name for all things that are alike: what they are and a digest."""
        shapes = [shape for link in self.links for shape in link.shapes]
        hidden = [(box.center.tolist(), box.half.tolist()) for s in shapes if not s.seen and (box := s.box) is not None]
        facts = (self.friction, self.free, [shape.mass for shape in shapes], hidden)
        name, said = "room", ()
        if self.asset is not None:
            name, said = category_of(self.asset).name, (self.asset.category, self.asset.size)
        return kind_name(name, [shape.part for shape in shapes], *said, *facts)

    @property
    def folder(self) -> str:
        """The path of the folder of its kind, for SDF and URDF."""
        return f"models/{self.kind}"

    def meshes(self) -> dict[str, bytes]:
        """Return the meshes that its model refers to, by their paths from its folder."""
        return {s.mesh: s.data for link in self.links for s in link.shapes if s.box is None and s.kinds}


def things(scene: Scene, layout: Layout, options: Options, *, free: Free | None = is_movable) -> Iterator[BodyTree]:
    """Yield the room, its doors as the options say, and every placed asset in order; where `free` is None nothing moves, doors neither."""
    shown = [
        part for part in room_parts(scene.room, seed=options.seed) if np.ptp(part.vertices[:, 2]) > BODIES.thinnest
    ]
    shapes = [  # skirting boards are seen but never touched: furniture is cut around them
        _shape(
            number, _stood(part, options.leaves), touched=part.name != "floor" and not part.name.startswith("skirting")
        )
        for number, part in enumerate(shown)
    ]
    leaves = (replace(s, mass=BODIES.leaf_mass * volume(s.part)) if s.part.joint is not None else s for s in shapes)
    x0, y0, x1, y1 = scene.room.bounds  # what everything stands on is a slab under the whole room, its top at zero
    low, high = (x0 - BODIES.slab, y0 - BODIES.slab, -BODIES.slab), (x1 + BODIES.slab, y1 + BODIES.slab, 0.0)
    ground = BodyShape("floor", shown[0], _around(np.array(low), np.array(high)), seen=False)
    yield BodyTree(free_name("room", scene), Pose(0.0, 0.0, 0.0, 0.0), _links((ground, *leaves)))
    for asset, pose in placed(scene, layout):
        pieces = tuple(
            _footed(part, -asset.size[2] / 2) for part in laid_parts(asset, scene, layout, seed=options.seed)
        )
        if free is None:
            pieces = tuple(replace(part, joint=None) for part in pieces)
        weights = part_masses(pieces)[0]
        shares = (mass(asset) * weights / weights.sum()).tolist()
        shapes = [
            replace(_shape(number, part, touched=part.convex and not asset.is_flat), mass=share)
            for number, (part, share) in enumerate(zip(pieces, shares, strict=True))
        ]
        if asset.is_flat:
            patches = enumerate(_patches(asset, scene, layout))
            shapes += [BodyShape(f"patch/{number}", pieces[0], box, seen=False) for number, box in patches]
        elif not all(part.convex for part in pieces):
            solids = enumerate(_solids(asset), len(pieces))
            shapes += [replace(_shape(number, solid, touched=True), seen=False) for number, solid in solids]
        friction = category_of(asset).friction
        loose = free is not None and free(asset, scene, layout)
        yield BodyTree(asset.name, pose, _links(shapes), friction, loose, asset)


def _solids(asset: Asset) -> Iterator[Part]:
    """Yield what an own mesh collides as."""
    material = Material("solid", (0.5, 0.5, 0.5))
    for shape in prisms_of(asset):
        span = (shape.low - asset.size[2] / 2, shape.high - asset.size[2] / 2)
        yield prism("solid", material, [*dict.fromkeys(shape.outline)], span)


def _links(shapes: Sequence[BodyShape]) -> tuple[BodyLink, ...]:
    """Return shapes sorted into what stays and what moves, each in the frame of its joint."""
    links = [BodyLink(tuple(shape for shape in shapes if shape.part.joint is None))]
    for joint in dict.fromkeys(shape.part.joint for shape in shapes):
        if joint is not None:
            links.append(BodyLink(tuple(_moved(s, np.array(joint.at)) for s in shapes if s.part.joint == joint), joint))
    return tuple(links)


def _moved(shape: BodyShape, at: FloatArray) -> BodyShape:
    """Return a shape in a frame at some place."""
    box = None if shape.box is None else replace(shape.box, center=shape.box.center - at)
    return replace(shape, part=replace(shape.part, vertices=shape.part.vertices - at), box=box)


def _shape(number: int, part: Part, *, touched: bool) -> BodyShape:
    """Return a part as a box if it is one or is too thin for a hull, else as its hull."""
    box = as_box(part)
    if box is None and (
        volume(part) < BODIES.smallest_volume or np.ptp(part.vertices, axis=0).min() < 2 * BODIES.thinnest
    ):
        box = _around(part.vertices.min(axis=0), part.vertices.max(axis=0))
    if box is not None:
        box = replace(box, half=np.maximum(box.half, BODIES.thinnest))
    return BodyShape(f"{part.name}/{number}", part, box, touched=touched)


def _around(low: FloatArray, high: FloatArray) -> Box:
    """Return the axis-aligned box between two corners."""
    return Box((low + high) / 2, (high - low) / 2, np.eye(3))


def _stood(part: Part, leaves: str) -> Part:
    """Return a part of the room as its door stands: fixed, open or shut, unless it swings."""
    if part.joint is None or leaves == "swinging":
        return part
    far = part.joint.span[leaves == "open"]
    return replace(part, vertices=turned(part.joint, part.vertices, far), joint=None)


def _footed(part: Part, bottom: float) -> Part:
    """Return a part that stands on the bottom of its asset with a flat foot; any other part as it is."""
    heights = part.vertices[:, 2]
    if heights.min() > bottom + BODIES.thinnest:
        return part
    low = heights < heights.min() + BODIES.foot * np.ptp(heights)
    vertices = part.vertices.copy()
    vertices[low, 2] = heights.min()
    return replace(part, vertices=vertices)


def _patches(rug: Asset, scene: Scene, layout: Layout) -> Iterator[Box]:
    """Yield where a rug is touched, in its frame: under what stands on its top; furniture stands through it."""
    place = layout[rug.name]
    top = vertical_span(rug, place)[1]
    for asset, pose in placed(scene, layout):
        gap = abs(vertical_span(asset, pose)[0] - top)
        if not asset.is_flat and gap < BODIES.on_rug and covers(place, rug, pose):
            half = np.array([asset.size[0] / 2, asset.size[1] / 2, max(rug.size[2] / 2, BODIES.thinnest)])
            a, b = math.cos(pose.yaw - place.yaw), math.sin(pose.yaw - place.yaw)
            axes = np.array([[a, -b, 0.0], [b, a, 0.0], [0.0, 0.0, 1.0]])
            yield Box(np.array([*place.seen(pose.at), 0.0]), half, axes)
