"""The sign of every published angle, settled by numbers from the formulas alone.

The published functions turn the front of the first asset by *minus* the angle before they compare it: `point_towards` with the
direction to the second asset, `align_with` with its front, `against_wall` (by 90 degrees) with the wall's direction. The formulas
are written out here with complex numbers; nothing of the package's geometry is used for what is expected.
"""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest
from shapely import LineString, Polygon

from robolayout._geometry import Body, FrameRow, frame_residual
from robolayout.constraints import AssetRef, FrameTerm, WallRef
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.point_towards import PointTowards
from robolayout.scene import Asset, Layout, Pose, Room, Scene

A, B = AssetRef("a-0"), AssetRef("b-0")
SCENE = Scene(
    Room(((0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)), 2.6),
    (Asset("a-0", "box", (0.6, 0.6, 0.8)), Asset("b-0", "table", (0.8, 1.6, 0.75))),
)
ANGLES = (-135.0, -90.0, -30.0, 0.0, 30.0, 90.0, 180.0)


def poses(seed: int) -> tuple[Pose, Pose]:
    """Return two poses far enough from each other that no centre lies in the other's footprint."""
    rng = np.random.default_rng(seed)
    a, b = (complex(*rng.uniform(1.0, 8.0, 2)) for _ in range(2))
    if abs(a - b) < 2.0:
        b = a + 2.5
    yaws = rng.uniform(-math.pi, math.pi, 2)
    return Pose(a.real, a.imag, 0.4, yaws[0]), Pose(b.real, b.imag, 0.375, yaws[1])


def turned(pose: Pose, angle: float) -> complex:
    """Return the front of a pose, turned by an angle in degrees."""
    return cmath.exp(1j * pose.yaw) * cmath.exp(1j * math.radians(angle))


def between(first: complex, second: complex) -> float:
    """Return cos of the angle between two directions."""
    return (first * second.conjugate()).real / abs(first) / abs(second)


def published_point_towards(a: Pose, b: Pose, angle: float) -> float:
    """Return 0 if the ray along the front of a, turned by -angle, hits b's footprint, else 1 - cos to b's centre."""
    front, centre, ahead = complex(a.x, a.y), complex(b.x, b.y), turned(a, -angle)
    corners = [
        centre + cmath.exp(1j * b.yaw) * complex(x, y) for x, y in ((-0.4, -0.8), (0.4, -0.8), (0.4, 0.8), (-0.4, 0.8))
    ]
    far = front + 50.0 * ahead
    ray = LineString([(front.real, front.imag), (far.real, far.imag)])
    return 0.0 if ray.intersects(Polygon([(p.real, p.imag) for p in corners])) else 1.0 - between(ahead, centre - front)


def residual(term: FrameTerm, a: Pose, b: Pose) -> float:
    """Return what the solver's kernel makes of a term between the two assets of the scene."""
    half = {"a-0": (0.3, 0.3), "b-0": (0.4, 0.8)}
    first, second = (
        Body(*(np.float64(v) for v in (p.x, p.y, math.cos(p.yaw), math.sin(p.yaw), *half[name], 0.0)))
        for name, p in (("a-0", a), ("b-0", b))
    )
    return float(frame_residual(first, second, FrameRow(*(np.float64(v) for v in term.row()))))


@pytest.mark.parametrize("angle", ANGLES)
def test_point_towards_turns_the_front_by_minus_the_angle(angle: float) -> None:
    relation, decided = PointTowards(A, B, angle), 0
    for seed in range(40):
        a, b = poses(seed)
        expected = published_point_towards(a, b, angle)
        (term,) = relation.terms(SCENE, Layout({}))
        assert residual(term, a, b) == pytest.approx(expected, abs=1e-4)
        off = math.degrees(math.acos(max(-1.0, 1.0 - expected)))
        outcome = relation.check(SCENE, Layout({"a-0": a, "b-0": b}))
        assert outcome.value == pytest.approx(off, abs=1e-4)
        assert outcome.met == (off <= 10.0)
        decided += outcome.met
        exact = Pose(a.x, a.y, a.z, cmath.phase(complex(b.x - a.x, b.y - a.y)) + math.radians(angle))
        assert relation.check(SCENE, Layout({"a-0": exact, "b-0": b})).met
    assert 0 < decided < 40


@pytest.mark.parametrize("angle", ANGLES)
def test_align_with_turns_the_front_by_minus_the_angle(angle: float) -> None:
    relation = AlignWith(A, B, angle)
    for seed in range(40):
        a, b = poses(seed)
        (term,) = relation.terms(SCENE, Layout({}))
        expected = 1.0 - between(turned(a, -angle), turned(b, 0.0))
        assert residual(term, a, b) == pytest.approx(expected, abs=1e-4)
        off = math.degrees(math.acos(max(-1.0, min(1.0, 1.0 - expected))))
        assert relation.check(SCENE, Layout({"a-0": a, "b-0": b})).value == pytest.approx(off, abs=1e-3)


@pytest.mark.parametrize("index", range(4))
def test_at_a_wall_the_front_turned_by_minus_90_degrees_runs_along_it(index: int) -> None:
    """Walls run counter-clockwise around the room, so this is the front that looks into the room: one convention for all."""
    start, end = (complex(*SCENE.room.vertices[i % 4]) for i in (index, index + 1))
    along = (end - start) / abs(end - start)
    place = (start + end) / 2 + 0.3 * along * 1j
    for yaw in (cmath.phase(along * 1j), cmath.phase(along * -1j)):
        pose = Pose(place.real, place.imag, 0.4, yaw)
        expected = between(turned(pose, -90.0), along) > 0
        assert AgainstWall(A, WallRef(index)).check(SCENE, Layout({"a-0": pose})).met is expected
