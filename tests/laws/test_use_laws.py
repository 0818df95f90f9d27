"""Laws of use among tables and chairs: quick verdicts equal explained ones, moving chairs keeps the laws of reach."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene, load_agent
from robolayout.verify import judge_agent, navigation, usage
from robolayout.verify.heading import heading_space
from robolayout.verify.limits import FINE

SEEDS = st.integers(min_value=0, max_value=10**6)
BODIES = (
    Agent("disc", 0.25, 1.5, reach_distance=0.5),
    load_agent("elder_walker"),
    load_agent("unitree_g1"),
    load_agent("wheelchair"),
    load_agent("dog_medium"),
)
ROOM = Room(((0, 0), (4.6, 0), (4.6, 3.8), (0, 3.8)), 2.6, (Opening(0, 0.7, 0.9, 2.05),))
L_ROOM = Room(((0, 0), (5, 0), (5, 2.6), (2.9, 2.6), (2.9, 4.6), (0, 4.6)), 2.6, (Opening(4, 0.8, 0.9, 2.05),))


def dining(seed: int) -> tuple[Scene, Layout]:
    """One or two tables with chairs about them and plates on them, a rug, a box, a cabinet; here and there overlapping."""
    rng = random.Random(seed)
    room = rng.choice((ROOM, L_ROOM))
    assets: list[Asset] = []
    poses: dict[str, Pose] = {}

    def put(kind: str, size: tuple[float, float, float], x: float, y: float, yaw: float, bottom: float = 0.0) -> None:
        asset = Asset(
            f"{kind.replace(' ', '_')}-{len(assets)}", kind, size, on_floor=bottom == 0.0, on_object=bottom > 0.0
        )
        assets.append(asset)
        poses[asset.name] = Pose(x, y, bottom + size[2] / 2, yaw)

    put("rug", (2.0, 2.0, 0.02), 2.0, 2.0, 0.0)
    for _ in range(rng.randint(1, 2)):
        x, y, yaw = rng.uniform(1, 3.6), rng.uniform(1, 2.8), rng.choice((0.0, math.pi / 2, rng.uniform(-3, 3)))
        put("dining table", (0.9, 1.4, 0.75), x, y, yaw)
        for side in (-1, 1):
            for along in (-0.35, 0.35):
                away = side * (0.45 + 0.25 + rng.uniform(0.0, 0.4))
                cx, cy = (
                    x + math.cos(yaw) * away - math.sin(yaw) * along,
                    y + math.sin(yaw) * away + math.cos(yaw) * along,
                )
                put("dining chair", (0.5, 0.48, 0.9), cx, cy, yaw + (math.pi if side > 0 else 0))
                px, py = (
                    x + math.cos(yaw) * side * 0.25 - math.sin(yaw) * along,
                    y + math.sin(yaw) * side * 0.25 + math.cos(yaw) * along,
                )
                put("plate", (0.22, 0.22, 0.03), px, py, yaw, 0.75)
    for kind, size in (("storage box", (0.5, 0.7, 0.4)), ("cabinet", (0.4, 0.9, 1.0)), ("armchair", (0.8, 0.8, 0.9))):
        put(kind, size, rng.uniform(0.5, 4.1), rng.uniform(0.5, 3.3), rng.uniform(-3, 3))
    return Scene(room, tuple(assets)), Layout(poses)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(SEEDS)
def test_a_verdict_found_in_little_time_is_the_explained_one(seed: int):
    """The judge stops at the first proof; the explanation looks at every heading. Where it stands, only what it moves is in the way."""
    scene, layout = dining(seed)
    agent = BODIES[seed % len(BODIES)]
    nav = navigation(scene, layout, agent)
    judged = usage(scene, layout, agent, nav=nav)
    assert dict(judged.usable) == {name: use.usable for name, use in judged.uses.items()}
    chairs = {name for name in layout if name.startswith(("dining_chair", "storage_box"))}
    for name, use in judged.uses.items():
        assert set(use.moved) <= chairs and (agent.reach_distance is not None or not use.moved)
        if use.stand is not None and agent.length is None:
            spot = shapely.Point(use.stand)
            kept = [
                row for row in range(len(nav.blocking.rows)) if nav.boxes.names[nav.blocking.rows[row]] not in use.moved
            ]
            assert (
                shapely.distance(nav.blocking.shapes[kept], spot).min() >= agent.radius * math.cos(math.pi / 64) - 1e-5
            )
            assert bool(use.moved) or nav.main.distance(spot) < 1e-6, name


@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS, st.floats(0.01, 0.25))
def test_a_bigger_body_never_reaches_more_whatever_it_moves(seed: int, wider: float):
    scene, layout = dining(seed)
    agent = replace(BODIES[0], radius=0.15)
    small, big = (navigation(scene, layout, replace(agent, radius=r)) for r in (0.15, 0.15 + wider))
    if small.main.buffer(1e-3).covers(big.main):
        assert all(small.reached[name] for name, reached in big.reached.items() if reached)


@pytest.mark.slow
@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS)
def test_removing_a_thing_and_what_it_carries_never_reduces_what_is_reached_or_used(seed: int):
    scene, layout = dining(seed)
    agent = BODIES[seed % 4]
    before = judge_agent(scene, layout, agent)
    found = before.navigation.boxes
    for gone in layout:
        row = found.names.index(gone)
        with_it = {gone, *(name for i, name in enumerate(found.names) if found.carriers[i] == row)}
        after = judge_agent(scene, Layout({n: p for n, p in layout.items() if n not in with_it}), agent)
        if after.navigation.main.buffer(1e-6).covers(before.navigation.main):
            assert all(
                after.navigation.reached[n] for n, met in before.navigation.reached.items() if met and n not in with_it
            )
            entered = before.headings is None or _covers(after.headings, before.headings)
            assert not entered or all(
                after.usage.usable[n]
                for n, met in before.usage.usable.items()
                if met and n not in with_it and not (agent.turning_radius is not None and before.usage.uses[n].moved)
            )


def _covers(after, before) -> bool:
    return all(a.buffer(1e-6).covers(b) for a, b in zip(after.standing, before.standing, strict=True))


@pytest.mark.slow
@settings(max_examples=20, deadline=None, derandomize=True)
@given(SEEDS, st.floats(-3.1, 3.1), st.floats(-20, 20))
def test_what_is_moved_and_used_does_not_change_when_the_room_is_turned_and_moved(
    seed: int, angle: float, shift: float
):
    scene, layout = dining(seed)
    agent = BODIES[seed % len(BODIES)]
    c, s = math.cos(angle), math.sin(angle)

    def moved(x: float, y: float) -> tuple[float, float]:
        return (c * x - s * y + shift, s * x + c * y - shift)

    room = replace(scene.room, vertices=tuple(moved(*vertex) for vertex in scene.room.vertices))
    poses = {name: Pose(*moved(p.x, p.y), p.z, p.yaw + angle) for name, p in layout.items()}
    first, second = judge_agent(scene, layout, agent), judge_agent(replace(scene, room=room), Layout(poses), agent)
    assert dict(first.navigation.reached) == dict(second.navigation.reached)
    assert dict(first.usage.usable) == dict(second.usage.usable)


def test_no_heading_is_worked_out_where_the_first_ones_do(monkeypatch: pytest.MonkeyPatch):
    """A wheelchair in a roomy room: two of eight headings prove that it uses everything."""
    from robolayout.verify import heading

    desk = Asset("desk-0", "desk", (0.6, 1.2, 0.75))
    scene, layout = Scene(ROOM, (desk,)), Layout({"desk-0": Pose(0.31, 2.0, 0.375, 0.0)})
    asked: list[int] = []
    whole = heading.convex_places
    monkeypatch.setattr(heading, "convex_places", lambda *given: asked.append(1) or whole(*given))
    report = judge_agent(scene, layout, load_agent("wheelchair"))
    assert report.usage.usable["desk-0"] and len(asked) == 2
    assert report.headings is not None and len(asked) == FINE.headings
    assert report.headings.standing == heading_space(scene, layout, load_agent("wheelchair")).standing
