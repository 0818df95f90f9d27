"""Laws of bodies among real furniture: low ones pass under it, the solver's grid and the judge agree, claims hold."""

from __future__ import annotations

import itertools
import math
import random
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from robolayout._grid import components
from robolayout.assets import category_of
from robolayout.assets.meshes import parts
from robolayout.floor.ground import FloorObstacles, clearance, make_ground
from robolayout.floor.routes import _rows as demand_rows
from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene, load_agent
from robolayout.solve import compile_problem
from robolayout.verify import Drive, Navigation, judge_agent, navigation, verify
from robolayout.verify._obstacles import part_rectangles
from robolayout.verify.heading import rectangle as footprint_of
from robolayout.verify.proofs import impossible, remedies

SEEDS = st.integers(min_value=0, max_value=10**6)
LOW = Agent("low", 0.16, 0.09, step=0.02)
BODIES = (
    LOW,
    Agent("crawler", 0.12, 0.45, reach_distance=0.4),
    Agent("walker", 0.22, 1.2, reach_distance=0.6),
    load_agent("cat"),
    load_agent("child_6"),
)
KINDS = (
    ("bed", (2.1, 1.4, 0.9)),
    ("dining table", (0.9, 1.5, 0.75)),
    ("chair", (0.5, 0.45, 0.9)),
    ("coffee table", (0.6, 1.1, 0.42)),
    ("sofa", (0.9, 1.9, 0.85)),
    ("wardrobe", (0.6, 1.2, 2.0)),
    ("floor lamp", (0.4, 0.4, 1.6)),
    ("loft bed", (2.05, 1.05, 1.9)),
    ("desk", (0.6, 1.3, 0.75)),
    ("night stand", (0.4, 0.45, 0.55)),
)
ROOMS = (
    Room(((0, 0), (4.6, 0), (4.6, 3.8), (0, 3.8)), 2.6, (Opening(0, 0.7, 0.9, 2.05),)),
    Room(((0, 0), (5, 0), (5, 2.6), (2.9, 2.6), (2.9, 4.6), (0, 4.6)), 2.6, (Opening(4, 0.8, 0.9, 2.05),)),
    Room(((0, 0), (3.4, 0), (4.4, 2.0), (3.0, 4.0), (0, 3.6)), 2.6),
)


def furnished_room(seed: int, most: int = 6) -> tuple[Scene, Layout]:
    """Real furniture anywhere on the floor, here and there overlapping."""
    rng = random.Random(seed)
    room = rng.choice(ROOMS)
    _, _, width, depth = room.bounds
    assets: list[Asset] = []
    poses: dict[str, Pose] = {}
    for i in range(rng.randint(2, most)):
        kind, size = rng.choice(KINDS)
        asset = Asset(f"{kind.replace(' ', '_')}-{i}", kind, size)
        assets.append(asset)
        x, y = rng.uniform(0.3, width - 0.3), rng.uniform(0.3, depth - 0.3)
        poses[asset.name] = Pose(x, y, size[2] / 2, rng.choice((0.0, math.pi / 2, rng.uniform(-3, 3))))
    return Scene(room, tuple(assets), agents=(BODIES[0],)), Layout(poses)


def body(seed: int) -> Agent:
    return BODIES[seed % len(BODIES)]


def solid(scene: Scene, layout: Layout, agent: Agent) -> shapely.Geometry:
    """The material at the body's heights, from the meshes alone: hulls of the parts that meet them."""
    found: list[shapely.Geometry] = []
    for name, pose in layout.items():
        asset = scene.by_name[name]
        c, s = math.cos(pose.yaw), math.sin(pose.yaw)
        for part in parts(asset):
            x, y, z = part.vertices.T
            if z.max() + pose.z > agent.step + 1e-6 and z.min() + pose.z < agent.height - 1e-6:
                points = np.stack([pose.x + c * x - s * y, pose.y + s * x + c * y], axis=1)
                found.append(shapely.MultiPoint(points).convex_hull)
    return shapely.union_all(found)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS)
def test_routes_meet_no_part_of_any_mesh_at_any_centimetre(seed: int):
    scene, layout = furnished_room(seed)
    agent = body(seed)
    nav = navigation(scene, layout, agent)
    material, walls = solid(scene, layout, agent), shapely.Polygon(scene.room.vertices).exterior
    least = agent.radius * math.cos(math.pi / 64) - 1e-6
    for route in nav.routes.values():
        places = shapely.line_interpolate_point(route.line, np.arange(0.0, route.length + 0.01, 0.01))
        assert shapely.distance(places, walls).min() >= least
        assert material.is_empty or shapely.distance(places, material).min() >= least


LONG = (
    Agent("cart", 0.3, 1.0, length=0.8, width=0.5, reach_distance=0.6),
    Agent("sled", 0.2, 0.09, step=0.02, length=0.7, width=0.3, turning_diameter=0.9),
    load_agent("dog_medium"),
)
DRIVEN = (
    Agent("van", 0.4, 1.0, length=0.9, width=0.5, turning_diameter=1.6, turning_radius=0.4, reach_distance=0.6),
    Agent("chair", 0.4, 1.2, length=0.8, width=0.5, turning_radius=0.0, reach_distance=0.7),
    load_agent("wheelchair"),
)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS)
def test_a_long_body_driven_to_where_it_uses_a_thing_meets_nothing_on_the_way(seed: int):
    """The swept rectangle, every centimetre and every degree, against the meshes and the walls; and it turns in its circle."""
    scene, layout = furnished_room(seed, most=4)
    agent = LONG[seed % len(LONG)]
    report = judge_agent(scene, layout, agent)
    assert report.headings is not None
    free = shapely.Polygon(scene.room.vertices).buffer(1e-6).difference(solid(scene, layout, agent).buffer(-1e-6))
    shapely.prepare(free)
    uses = report.usage.uses.items()
    stands = {name: use.stand for name, use in uses if use.stand is not None and not use.moved}
    assert set(report.drives) == set(stands) and not report.usage.undriven
    for name, drive in report.drives.items():
        assert math.dist(drive.poses[-1][:2], stands[name]) < 1e-6
        assert_swept_free(free, agent, drive)
        for a, b in itertools.pairwise(drive.poses):
            if agent.turning_diameter is not None and a[2] != b[2]:
                assert free.covers(shapely.Point(a[:2]).buffer(agent.turning_diameter / 2 - 2e-3))


def assert_swept_free(free: shapely.Geometry, agent: Agent, drive: Drive) -> None:
    """The rectangle stays in a region on its whole way, looked at every centimetre and every degree."""
    corners = footprint_of(agent, 0.0)
    for a, b in itertools.pairwise(drive.poses):
        count = 2 + int(max(math.dist(a[:2], b[:2]) / 0.01, abs(b[2] - a[2]) / math.radians(1)))
        for share in np.linspace(0, 1, count):
            x, y, turn = (1 - share) * np.array(a) + share * np.array(b)
            c, s = math.cos(turn), math.sin(turn)
            body_now = shapely.Polygon(corners @ np.array([(c, s), (-s, c)]) * (1 - 1e-5) + (x, y))
            assert free.covers(body_now), (drive.asset, x, y, math.degrees(turn))


@settings(max_examples=12, deadline=None, derandomize=True)
@given(SEEDS)
def test_a_body_that_cannot_slide_drives_ahead_and_back_on_arcs_no_tighter_than_its_own(seed: int):
    scene, layout = furnished_room(seed, most=4)
    agent = DRIVEN[seed % len(DRIVEN)]
    report = judge_agent(scene, layout, agent)
    free = shapely.Polygon(scene.room.vertices).buffer(1e-6).difference(solid(scene, layout, agent).buffer(-1e-6))
    shapely.prepare(free)
    assert set(report.drives).isdisjoint(report.usage.undriven)
    for name, drive in report.drives.items():
        assert_swept_free(free, agent, drive)
        x, y, _ = drive.poses[-1]
        box = report.navigation.boxes.footprints[report.navigation.boxes.names.index(name)]
        assert box.distance(shapely.Point(x, y)) <= agent.reach + 1e-6
        gears: list[bool] = []
        for (ax, ay, a), (bx, by, b) in itertools.pairwise(drive.poses):
            length, middle = math.dist((ax, ay), (bx, by)), (a + b) / 2
            assert length > 1e-9 or agent.turning_radius == 0.0
            assert abs(b - a) * (agent.turning_radius or 0.0) <= length * 1.001
            if length > 1e-9:
                ahead = ((bx - ax) * math.cos(middle) + (by - ay) * math.sin(middle)) / length
                assert abs(ahead) > 1 - 1e-6
                gears.append(ahead > 0)
        assert sum(a != b for a, b in itertools.pairwise(gears)) <= drive.reversals


@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS, st.floats(0.01, 0.6), st.floats(0.0, 0.1))
def test_a_taller_or_wider_body_never_reaches_more(seed: int, taller: float, wider: float):
    scene, layout = furnished_room(seed)
    agent = body(seed)
    small = navigation(scene, layout, agent)
    big = navigation(scene, layout, replace(agent, height=agent.height + taller, radius=agent.radius + wider))
    assert big.free.difference(small.free.buffer(1e-6)).area < 1e-6
    if small.main.buffer(1e-3).covers(big.main) and agent.reach_distance is not None and wider + agent.radius < 0.3:
        assert all(small.reached[name] for name, reached in big.reached.items() if reached)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS)
def test_removing_furniture_never_reduces_what_is_reached(seed: int):
    scene, layout = furnished_room(seed)
    agent = body(seed)
    before = navigation(scene, layout, agent)
    for gone in layout:
        after = navigation(scene, Layout({n: p for n, p in layout.items() if n != gone}), agent)
        assert before.free.difference(after.free.buffer(1e-6)).area < 1e-6
        if after.main.buffer(1e-6).covers(before.main):
            assert all(after.reached[n] for n, reached in before.reached.items() if reached and n != gone)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS, st.floats(-3.1, 3.1), st.floats(-20, 20))
def test_verdicts_do_not_change_when_room_and_furniture_are_turned_and_moved(seed: int, angle: float, shift: float):
    scene, layout = furnished_room(seed)
    agent = body(seed)
    c, s = math.cos(angle), math.sin(angle)

    def moved(x: float, y: float) -> tuple[float, float]:
        return (c * x - s * y + shift, s * x + c * y - shift)

    room = replace(scene.room, vertices=tuple(moved(*vertex) for vertex in scene.room.vertices))
    poses = {name: Pose(*moved(p.x, p.y), p.z, p.yaw + angle) for name, p in layout.items()}
    first = verify(scene, layout, agent=agent).agents[0]
    second = verify(replace(scene, room=room), Layout(poses), agent=agent).agents[0]
    assert dict(first.navigation.reached) == dict(second.navigation.reached)
    assert dict(first.usage.usable) == dict(second.usage.usable)
    for name, value in first.figures.items():
        assert second.figures[name] == pytest.approx(value, abs=1e-3), name


@settings(max_examples=15, deadline=None, derandomize=True)
@given(SEEDS)
def test_verdicts_do_not_change_when_room_and_furniture_are_mirrored(seed: int):
    """Furniture that is its own mirror image: tables and chairs on four legs."""
    rng = random.Random(seed)
    room = ROOMS[0]
    kinds = {
        k: size for k, size in KINDS if k in ("chair", "coffee table", "desk", "dining table") and mirrors(k, size)
    }
    assert len(kinds) >= 2
    assets = [Asset(f"{k.replace(' ', '_')}-{i}", k, kinds[k]) for i, k in enumerate(rng.choices(sorted(kinds), k=4))]
    poses = {
        a.name: Pose(rng.uniform(0.4, 4.2), rng.uniform(0.4, 3.4), a.size[2] / 2, rng.uniform(-3, 3)) for a in assets
    }
    (door,) = room.doors
    length = room.walls[door.wall].length
    flipped = replace(
        room,
        vertices=tuple((-x, y) for x, y in reversed(room.vertices)),
        doors=(replace(door, wall=2 - door.wall, offset=length - door.offset - door.width),),
    )
    other = {name: Pose(-p.x, p.y, p.z, math.pi - p.yaw) for name, p in poses.items()}
    turn = {"left": "right", "right": "left"}
    swapped = [replace(a, use_sides=tuple(turn.get(s, s) for s in sides_of(a))) for a in assets]
    for agent in (LOW, BODIES[3], LONG[0]):
        first = verify(Scene(room, tuple(assets)), Layout(poses), agent=agent).agents[0]
        second = verify(Scene(flipped, tuple(swapped)), Layout(other), agent=agent).agents[0]
        assert dict(first.navigation.reached) == dict(second.navigation.reached)
        assert dict(first.usage.usable) == dict(second.usage.usable)
        assert second.navigation.free.area == pytest.approx(first.navigation.free.area, abs=1e-6)


def mirrors(kind: str, size: tuple[float, float, float]) -> bool:
    """Whether the low parts of a kind of furniture are their own mirror image."""
    found = [
        part_rectangles(Asset(f"{kind.replace(' ', '_')}-{i}", kind, size), 0.02, h)
        for i in range(4)
        for h in (0.09, 0.3)
    ]
    for rows in found:
        if rows is not None and not np.allclose(
            sorted(rows.tolist()), sorted(np.stack([rows[:, 0], -rows[:, 3], rows[:, 2], -rows[:, 1]], axis=1).tolist())
        ):
            return False
    return True


def sides_of(asset: Asset) -> tuple[str, ...]:
    return tuple(category_of(asset).use_sides)


def grid(scene: Scene, layout: Layout, agent: Agent):
    """The solver's view: its grid, its distance field, its obstacles."""
    problem = compile_problem(scene, built=layout)
    world = np.array([(p.x, p.y, math.cos(p.yaw), math.sin(p.yaw)) for p in (layout[n] for n in problem.names)])
    ground = make_ground(problem.contents, agent, 0.05)
    return problem, ground, world, ground.obstacles


def field_of(ground, world, things: FloorObstacles) -> np.ndarray:
    return np.minimum(clearance(ground, world, things), ground.wall_distance)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(SEEDS)
def test_the_solvers_grid_and_the_judge_agree_within_a_cell(seed: int):
    """They share no code: rectangles, distances and free space are worked out twice."""
    scene, layout = furnished_room(seed)
    agent = body(seed)
    _, ground, world, things = grid(scene, layout, agent)
    field = field_of(ground, world, things)
    nav = navigation(scene, layout, agent)
    xs, ys = np.meshgrid(ground.xs, ground.ys, indexing="ij")
    free = shapely.contains_xy(nav.free, xs, ys)
    hidden = shapely.contains_xy(shapely.union_all(nav.blocking.shelter).buffer(1e-6), xs, ys)
    assert free[(field > agent.radius + ground.cell) & ~hidden].all()
    assert not free[field < agent.radius - ground.cell].any()
    near = shapely.contains_xy(nav.free.buffer(ground.cell), xs, ys)
    assert near[(field >= agent.radius) & ~hidden].all()


@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS)
def test_where_the_solver_walks_with_a_cell_to_spare_the_judge_walks_too(seed: int):
    """Two neighbouring cells with a cell more than the radius around them are joined by a free straight line."""
    scene, layout = furnished_room(seed)
    agent = body(seed)
    _, ground, world, things = grid(scene, layout, agent)
    label, _ = components(field_of(ground, world, things) >= agent.radius + ground.cell)
    nav = navigation(scene, layout, agent)
    if ground.start is None or not label[ground.start] or not scene.room.doors:
        return
    cells = np.argwhere(label == label[ground.start])
    there = shapely.intersects_xy(nav.main.buffer(1e-9), ground.xs[cells[:, 0]], ground.ys[cells[:, 1]])
    assert there.all() or not there.any()


@settings(max_examples=20, deadline=None, derandomize=True)
@given(SEEDS)
def test_what_is_asked_of_a_box_is_what_its_part_lacks(seed: int):
    """The search pushes whole boxes: each asked point is as far from its box as the route's point is from the part."""
    scene, layout = furnished_room(seed)
    agent = body(seed)
    problem, ground, world, things = grid(scene, layout, agent)
    rng = np.random.default_rng(seed)
    count = len(things.slot)
    points = rng.uniform(0, 4, (count, 2))
    asked = demand_rows(ground, world, points, np.arange(count), 0.3)
    for k in range(count):
        part = rectangle(*things.poses(world)[k], *things.half[k])
        whole = rectangle(*world[things.slot[k]], *problem.half[things.slot[k]])
        lacking = part.distance(shapely.Point(points[k]))
        assert whole.distance(shapely.Point(asked[k, :2])) == pytest.approx(lacking, abs=1e-5)


def rectangle(x: float, y: float, c: float, s: float, half_depth: float, half_width: float) -> shapely.Polygon:
    ring = [(a * half_depth, b * half_width) for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    return shapely.Polygon([(x + c * u - s * v, y + s * u + c * v) for u, v in ring])


@settings(max_examples=12, deadline=None, derandomize=True)
@given(SEEDS)
def test_every_set_of_assets_said_to_be_in_the_way_is_confirmed_by_trying_all(seed: int):
    scene, layout = furnished_room(seed, most=5)
    agent = replace(BODIES[seed % 3], radius=0.35)
    nav = navigation(scene, layout, agent)

    def reached_without(name: str, *gone: str) -> bool:
        rest = Layout({n: p for n, p in layout.items() if n == name or n not in gone})
        return bool(navigation(scene, rest, agent).reached[name])

    for name, sets in remedies(nav).removals.items():
        others = [other for other in layout if other != name]
        tried = [[s for s in itertools.combinations(others, size) if reached_without(name, *s)] for size in (1, 2)]
        expected = next((found for found in tried if found), [])
        assert sets == tuple(expected), name


@settings(max_examples=12, deadline=None, derandomize=True)
@given(SEEDS)
def test_the_largest_body_said_to_fit_fits_and_a_larger_one_does_not(seed: int):
    scene, layout = furnished_room(seed, most=5)
    agent = replace(BODIES[1], reach_distance=0.6)
    nav = navigation(scene, layout, agent)
    largest = remedies(nav).largest_disc

    def all_reached(diameter: float) -> bool:
        found: Navigation = navigation(scene, layout, replace(agent, radius=diameter / 2))
        return all(found.reached.values())

    if 0.0 < largest < 0.99:
        assert all_reached(largest) and not all_reached(largest + 0.01)


def test_too_much_furniture_for_the_floor_fits_in_no_layout_of_a_fine_lattice():
    """Three boxes of 0.8 x 0.7 m on 1.3 x 1.2 m: every place on a lattice of 10 cm, both ways round, is tried."""
    room = Room(((0, 0), (1.3, 0), (1.3, 1.2), (0, 1.2)), 2.5)
    boxes = tuple(Asset(f"box-{i}", "box", (0.8, 0.7, 0.5)) for i in range(3))
    assert impossible(Scene(room, boxes), LOW)[0].startswith("The 3 assets that stand on the floor cover 1.68 m2")
    places: list[shapely.Polygon] = []
    for w, d in ((0.8, 0.7), (0.7, 0.8)):
        for x, y in itertools.product(np.arange(0, 1.3 - w + 1e-9, 0.1), np.arange(0, 1.2 - d + 1e-9, 0.1)):
            places.append(shapely.box(x, y, x + w, y + d))
    apart = {(a, b) for a, b in itertools.combinations(range(len(places)), 2) if not places[a].overlaps(places[b])}
    assert not any({(a, b), (a, c), (b, c)} <= apart for a, b, c in itertools.combinations(range(len(places)), 3))


@pytest.mark.slow
@settings(max_examples=15, deadline=None, derandomize=True)
@given(SEEDS, st.floats(0.3, 1.6))
def test_a_body_said_to_fit_nowhere_fits_at_no_point_of_a_fine_lattice(seed: int, radius: float):
    room = replace(ROOMS[seed % 3], doors=())
    said = [s for s in impossible(Scene(room, ()), replace(BODIES[2], radius=radius)) if "empty room" in s]
    x0, y0, x1, y1 = room.bounds
    floor = shapely.Polygon(room.vertices)
    xs, ys = np.meshgrid(np.arange(x0, x1, 0.02), np.arange(y0, y1, 0.02))
    points = shapely.points(xs, ys)
    room_to_spare = shapely.distance(points, floor.exterior)[shapely.contains(floor, points)].max()
    assert bool(said) is bool(room_to_spare < radius) or abs(room_to_spare - radius) < 0.03
