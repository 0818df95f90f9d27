"""Circles, half circles and Us: what the check takes for one, whoever laid it out."""

from __future__ import annotations

import math

import pytest
from shapely import Polygon

from robolayout.constraints import AssetRef
from robolayout.constraints.in_shape import InShape
from robolayout.scene import Asset, Layout, Pose, Room, Scene

Places = list[tuple[float, float, float]]
ROOM = Room(((0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)), 2.6)


def ring(count: int, span: float, radius: float = 2.0, turn: float = 0.4) -> Places:
    """Return places on an arc of so many radians, all looking to its middle."""
    step = span / (count if span == math.tau else count - 1)
    turns = [turn + k * step for k in range(count)]
    return [(5 + radius * math.cos(t), 5 + radius * math.sin(t), t + math.pi) for t in turns]


HORSESHOE: Places = [
    (2.0, 4.0, 0.0),
    (2.0, 5.0, 0.0),
    (2.0, 6.0, 0.0),
    (3.0, 3.0, math.pi / 2),
    (4.0, 3.0, math.pi / 2),
    (3.0, 7.0, -math.pi / 2),
    (4.0, 7.0, -math.pi / 2),
]


def chairs(count: int) -> tuple[Asset, ...]:
    return tuple(Asset(f"chair-{i}", "chair", (0.5, 0.5, 0.9)) for i in range(count))


def is_met(places: Places, shape: str, toward: str = "in") -> bool:
    assets = chairs(len(places))
    layout = Layout({asset.name: Pose(x, y, 0.45, yaw) for asset, (x, y, yaw) in zip(assets, places, strict=True)})
    return (
        InShape(tuple(AssetRef(asset.name) for asset in assets), shape, toward).check(Scene(ROOM, assets), layout).met
    )


def moved(places: Places, index: int, x: float = 0.0, y: float = 0.0, yaw: float = 0.0) -> Places:
    a, b, c = places[index]
    return [*places[:index], (a + x, b + y, c + yaw), *places[index + 1 :]]


@pytest.mark.parametrize("count", [3, 4, 7, 12])
@pytest.mark.parametrize("radius", [1.2, 3.0])
def test_what_stands_evenly_on_a_circle_or_half_of_one_is_met_in_any_order(count: int, radius: float) -> None:
    circle, half = ring(count, math.tau, radius), ring(count, math.pi, radius)
    assert is_met(circle, "circle") and is_met(circle[::2] + circle[1::2], "circle")
    assert is_met(half, "half circle") and is_met(half[::2] + half[1::2], "half circle")
    assert not is_met(circle, "half circle") and not is_met(half, "circle")
    assert not is_met(circle, "circle", "out")
    assert is_met([(x, y, yaw + math.pi) for x, y, yaw in circle], "circle", "out")


def test_a_u_has_three_sides_that_look_inward() -> None:
    assert is_met(HORSESHOE, "u") and is_met(HORSESHOE[::-1], "u")
    turned = [(5 - y, x, yaw + math.pi / 2) for x, y, yaw in HORSESHOE]
    assert is_met(turned, "u")
    assert not is_met(HORSESHOE, "u", "out") and not is_met(HORSESHOE, "circle")
    assert not is_met(HORSESHOE[:5], "u")  # an L


@pytest.mark.parametrize(
    ("places", "shape"),
    [
        (moved(ring(8, math.tau), 2, x=0.6), "circle"),
        (moved(ring(8, math.tau), 2, yaw=0.3), "circle"),
        (ring(8, math.tau)[:6], "circle"),  # a gap of a quarter and more
        (ring(8, 1.2 * math.pi)[:4], "half circle"),
        ([(1.0 + k, 5.0, math.pi / 2) for k in range(6)], "circle"),  # a row
        ([(1.0 + k, 5.0, math.pi / 2) for k in range(6)], "half circle"),
        ([(1.0 + k, 5.0, math.pi / 2) for k in range(6)], "u"),
        (moved(HORSESHOE, 4, y=-0.6), "u"),
        ([*HORSESHOE[:3], (3.0, 7.0, math.pi / 2), (3.0, 3.0, -math.pi / 2)], "u"),  # its arms look outward
        (moved(HORSESHOE, 1, yaw=0.3), "u"),
        ([(5.0, 5.0, 0.0)] * 5, "circle"),
        ([(5.0, 5.0, 0.0)] * 5, "u"),
    ],
)
def test_what_is_off_is_no_shape(places: Places, shape: str) -> None:
    assert not is_met(places, shape)


@pytest.mark.parametrize("shape", ["circle", "half circle", "u"])
@pytest.mark.parametrize("toward", ["in", "out"])
@pytest.mark.parametrize("count", [3, 5, 8, 13])
def test_where_the_search_puts_things_they_meet_the_check_and_not_each_other(
    shape: str, toward: str, count: int
) -> None:
    assets = tuple(Asset(f"desk-{i}", "desk", (0.7, 1.4, 0.75)) for i in range(count))
    scene = Scene(ROOM, assets)
    relation = InShape(tuple(AssetRef(asset.name) for asset in assets), shape, toward)
    layout = Layout(relation.slots(scene))
    assert relation.check(scene, layout).met
    plans = [Polygon(layout[asset.name].corners(asset.size)) for asset in assets]
    assert not any(one.distance(other) < 0.05 for k, one in enumerate(plans) for other in plans[:k])


def test_two_things_are_no_circle() -> None:
    assets = chairs(2)
    pair = InShape(tuple(AssetRef(asset.name) for asset in assets))
    assert pair.fault(Scene(ROOM, assets)) == "a circle is of at least 3 things, not of 2"
