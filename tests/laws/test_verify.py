"""Laws of the judge, on random rooms: bigger discs, fewer assets, turned and mirrored rooms, swept routes."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene
from robolayout.verify import Report, navigation, physics, usage, verify

DISC = Agent("disc", 0.25, 1.5, reach_distance=0.5)
CART = Agent("cart", 0.3, 1.0, length=0.8, width=0.5, reach_distance=0.6)
SEEDS = st.integers(min_value=0, max_value=10**6)
MIRRORED = {"left": "right", "right": "left"}
ROOMS = (
    Room(((0, 0), (4.6, 0), (4.6, 3.8), (0, 3.8)), 2.6, (Opening(0, 0.7, 0.9, 2.05),)),
    Room(((0, 0), (5, 0), (5, 2.6), (2.9, 2.6), (2.9, 4.6), (0, 4.6)), 2.6, (Opening(4, 0.8, 0.9, 2.05),)),
)


def random_room(seed: int) -> tuple[Scene, Layout]:
    """Some things on the floor of a rectangular or L-shaped room, one on another, one not placed."""
    rng = random.Random(seed)
    room = rng.choice(ROOMS)
    assets: list[Asset] = []
    poses: dict[str, Pose] = {}
    for i in range(rng.randint(3, 9)):
        size = (rng.uniform(0.3, 0.9), rng.uniform(0.3, 2.0), rng.uniform(0.4, 1.8))
        asset = Asset(f"thing-{i}", "bookshelf", size, use_sides=(rng.choice(("front", "left", "right", "back")),))
        assets.append(asset)
        _, _, width, depth = room.bounds
        x, y = rng.uniform(0.2, width - 0.2), rng.uniform(0.2, depth - 0.2)
        poses[asset.name] = Pose(x, y, size[2] / 2, rng.uniform(-math.pi, math.pi))
    lamp = Asset("lamp-0", "table lamp", (0.2, 0.2, 0.4), on_floor=False, on_object=True)
    base = poses["thing-0"]
    poses["lamp-0"] = Pose(base.x + 0.05, base.y, assets[0].size[2] + 0.2, base.yaw)
    unplaced = Asset("ghost-0", "chair", (0.5, 0.5, 0.9))
    return Scene(room, (*assets, lamp, unplaced), agents=(DISC,)), Layout(poses)


def verdicts(report: Report) -> list[object]:
    body = report.agents[0]
    judged = report.physics
    checks = (judged.placed, judged.collision_free, judged.in_boundary, judged.supported)
    return [*map(dict, checks), judged.door_clear, dict(body.navigation.reached), dict(body.usage.usable)]


def turned(scene: Scene, layout: Layout, angle: float, shift: tuple[float, float]) -> tuple[Scene, Layout]:
    c, s = math.cos(angle), math.sin(angle)

    def moved(x: float, y: float) -> tuple[float, float]:
        return (c * x - s * y + shift[0], s * x + c * y + shift[1])

    room = replace(scene.room, vertices=tuple(moved(*vertex) for vertex in scene.room.vertices))
    poses = {name: Pose(*moved(p.x, p.y), p.z, p.yaw + angle) for name, p in layout.items()}
    return replace(scene, room=room), Layout(poses)


def mirrored(scene: Scene, layout: Layout) -> tuple[Scene, Layout]:
    room, count = scene.room, len(scene.room.vertices)
    doors = tuple(
        replace(d, wall=(count - 2 - d.wall) % count, offset=room.walls[d.wall].length - d.offset - d.width)
        for d in room.doors
    )
    flipped = replace(room, vertices=tuple((-x, y) for x, y in reversed(room.vertices)), doors=doors)
    assets = tuple(
        a if a.use_sides is None else replace(a, use_sides=tuple(MIRRORED.get(s, s) for s in a.use_sides))
        for a in scene.assets
    )
    poses = {name: Pose(-p.x, p.y, p.z, math.pi - p.yaw) for name, p in layout.items()}
    return replace(scene, room=flipped, assets=assets), Layout(poses)


@pytest.mark.slow
@settings(max_examples=20, deadline=None, derandomize=True)
@given(SEEDS, st.floats(0.01, 0.3))
def test_a_bigger_disc_never_reaches_more(seed: int, more: float):
    """As long as it comes in where the smaller one does: either may be split at the door by what stands there."""
    scene, layout = random_room(seed)
    for agent in (DISC, replace(DISC, reach_distance=None)):
        small = navigation(scene, layout, agent)
        big = navigation(scene, layout, replace(agent, radius=agent.radius + more))
        assert big.free.area <= small.free.area
        if small.main.buffer(1e-3).covers(big.main):
            assert all(small.reached[name] for name, reached in big.reached.items() if reached)
        assert all(small.passages[n].width == big.passages[n].width for n in small.passages if not agent.reach_distance)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(SEEDS, st.integers(0, 2))
def test_removing_an_asset_never_reduces_what_is_reached(seed: int, index: int):
    scene, layout = random_room(seed)
    gone = f"thing-{index}"
    before, after = navigation(scene, layout), navigation(scene, Layout({n: p for n, p in layout.items() if n != gone}))
    assert after.free.area >= before.free.area - 1e-9
    if after.main.buffer(1e-6).covers(before.main):
        assert all(after.reached[name] for name, reached in before.reached.items() if reached and name != gone)


@pytest.mark.slow
@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS, st.floats(-3.1, 3.1), st.floats(-20, 20), st.sampled_from([DISC, CART]))
def test_verdicts_do_not_change_when_the_room_is_turned_moved_or_mirrored(seed, angle, shift, agent):
    scene, layout = random_room(seed)
    expected = verify(scene, layout, agent=agent)
    for other in (turned(scene, layout, angle, (shift, -shift)), mirrored(scene, layout)):
        report = verify(*other, agent=agent)
        assert verdicts(report) == verdicts(expected)
        for name, value in expected.figures.items():
            assert report.figures[name] == pytest.approx(value, abs=1e-3), name


@pytest.mark.slow
@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS)
def test_routes_are_free_for_the_swept_disc_at_every_centimetre(seed: int):
    scene, layout = random_room(seed)
    nav = navigation(scene, layout)
    walls = shapely.Polygon(scene.room.vertices).exterior
    blocks = shapely.union_all([shapely.Polygon(layout[n].corners(scene.by_name[n].size)) for n in nav.obstacles])
    least = DISC.radius * math.cos(math.pi / 64) - 1e-6
    assert set(nav.routes) == {name for name, reached in nav.reached.items() if reached}
    for name, route in nav.routes.items():
        line = route.line
        places = shapely.line_interpolate_point(line, np.arange(0.0, line.length + 0.01, 0.01))
        assert shapely.distance(places, walls).min() >= least
        assert blocks.is_empty or shapely.distance(places, blocks).min() >= least
        assert shapely.covers(shapely.Polygon(scene.room.vertices), places).all()
        footprint = shapely.Polygon(layout[name].corners(scene.by_name[name].size))
        assert shapely.Point(route.points[-1]).distance(footprint) <= DISC.reach + 1e-6
        assert route.points[0] == nav.entry


@pytest.mark.slow
@settings(max_examples=20, deadline=None, derandomize=True)
@given(SEEDS)
def test_a_passage_is_the_widest_disc_that_gets_there(seed: int):
    scene, layout = random_room(seed)
    for name, passage in navigation(scene, layout).passages.items():
        for radius, expected in ((passage.width / 2, True), (passage.width / 2 + 0.005, False)):
            if 0.0 < radius < 0.745:
                again = navigation(scene, layout, replace(DISC, radius=radius))
                assert again.reached[name] is expected


@settings(max_examples=15, deadline=None, derandomize=True)
@given(SEEDS)
def test_every_unplaced_asset_fails_every_share(seed: int):
    scene, layout = random_room(seed)
    report = verify(scene, layout)
    assert not any(check["ghost-0"] for check in verdicts(report) if isinstance(check, dict))
    count = len(scene.assets)
    without = verify(replace(scene, assets=scene.assets[:-1]), layout)
    for name in ("placed_share", "collision_free_share", "supported_share", "reachable_share", "usable_share"):
        assert report.figures[name] == pytest.approx(without.figures[name] * (count - 1) / count)


@settings(max_examples=6, deadline=None, derandomize=True)
@given(SEEDS)
def test_the_same_layout_gets_the_same_report(seed: int):
    scene, layout = random_room(seed)
    reordered = Layout(dict(reversed(list(layout.items()))))
    first, second = verify(scene, layout).to_dict(), verify(scene, reordered).to_dict()
    assert {**first, "timing": None} == {**second, "timing": None}


@settings(max_examples=15, deadline=None, derandomize=True)
@given(SEEDS)
def test_the_order_of_the_assets_changes_no_verdict(seed: int):
    scene, layout = random_room(seed)
    shuffled = replace(scene, assets=tuple(reversed(scene.assets)))
    assert dict(physics(shuffled, layout).collision_free) == dict(physics(scene, layout).collision_free)
    assert dict(navigation(shuffled, layout).reached) == dict(navigation(scene, layout).reached)
    assert dict(usage(shuffled, layout).usable) == dict(usage(scene, layout).usable)
