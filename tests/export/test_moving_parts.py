"""What moves in MuJoCo: doors and drawers by their handles, room doors as asked for, and nothing by itself."""

from __future__ import annotations

import math

import mujoco
import numpy as np
import pytest

from robolayout.assets import CATALOGUE, parts
from robolayout.export import LEAVES, Options, pull_open, settle
from robolayout.export._exporter import is_movable
from robolayout.export._mujoco import load
from robolayout.export.mjcf import build
from robolayout.scene import DEFAULT_AGENT, Asset, Hold, Layout, Opening, Pose, Room, Scene, load_agent
from robolayout.verify import judge_agent, usage

PULL = 160.0
"""Newtons at a handle at the most: heavy lids are lifted with two hands."""


def thing(kind: str) -> Asset:
    category = CATALOGUE[kind]
    flags = {"on_floor": category.on_floor, "on_wall": category.on_wall, "on_object": category.on_object}
    return Asset(f"{kind.replace(' ', '_')}-0", kind, category.size, **flags)


OPENING = [kind for kind in CATALOGUE if any(part.joint for part in parts(thing(kind)))]


def room(*things: Asset, doors: tuple[Opening, ...] = ()) -> tuple[Scene, Layout]:
    scene = Scene(Room(((-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)), 2.6, doors), things)
    return scene, Layout({asset.name: Pose(0.0, 0.0, asset.size[2] / 2, 0.0) for asset in things})


def loaded(scene: Scene, layout: Layout, options: Options) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model, data = load(build(scene, layout, options, free=is_movable))
    mujoco.mj_resetDataKeyframe(model, data, model.key("home").id)
    mujoco.mj_forward(model, data)
    return model, data


def pulled(model: mujoco.MjModel, data: mujoco.MjData, joint: int) -> float:
    """Pull a joint open by its handle; return how far it opened, as a share of its span."""
    name = model.joint(joint).name
    site, body = model.site(f"{name}/handle").id, int(model.jnt_bodyid[joint])
    low, high = model.jnt_range[joint]
    slides = model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_SLIDE
    at = int(model.jnt_qposadr[joint])
    for _ in range(int(4.0 / model.opt.timestep)):
        point, axis = data.site_xpos[site], data.xaxis[joint]
        along = axis if slides else np.cross(axis, point - data.xanchor[joint])
        force = PULL * along / max(float(np.linalg.norm(along)), 1e-9)
        data.qfrc_applied[:] = 0.0
        mujoco.mj_applyFT(model, data, force, np.zeros(3), point, body, data.qfrc_applied)
        mujoco.mj_step(model, data)
    data.qfrc_applied[:] = 0.0
    return float((data.qpos[at] - low) / (high - low))


@pytest.mark.parametrize("kind", OPENING)
def test_everything_opens_by_its_handle_and_touches_nothing(kind: str) -> None:
    asset = thing(kind)
    model, data = load(build(*room(asset), Options(), free=lambda *_: False))
    names = {part.joint.name for part in parts(asset) if part.joint is not None}
    for name in sorted(names):
        mujoco.mj_resetDataKeyframe(model, data, 0)
        mujoco.mj_forward(model, data)
        joint = model.joint(f"{asset.name}/{name}").id
        low, high = model.jnt_range[joint]
        if high - low < math.pi:  # a swivel chair has no end
            assert pulled(model, data, joint) > 0.9, name
        moving = model.body(f"{asset.name}/{name}").id
        touching = data.contact.geom[: data.ncon]
        assert not (model.geom_bodyid[touching] == moving).any(), name


@pytest.mark.parametrize("body", ["wheelchair", "fetch"])
@pytest.mark.parametrize("leaves", LEAVES)
def test_with_all_controls_at_zero_nothing_moves(leaves: str, body: str) -> None:
    door = Opening(0, 3.5, 0.9, 2.05)
    scene, layout = room(thing("wardrobe"), doors=(door,))
    lines = {"wardrobe-0": [(0.05, -3.55), (0.05, -2.0)]}
    model, data = loaded(scene, layout, Options(agent=load_agent(body), leaves=leaves, routes=lines))
    before = data.xpos.copy()
    for _ in range(int(5.0 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert np.abs(data.xpos - before).max() < 1e-3
    assert np.abs(data.qpos - model.key_qpos[0]).max() < 1e-2
    assert model.nkey == 1


def test_a_leaf_hangs_and_swings_as_the_scene_says() -> None:
    for hinge, swing in (("left", "in"), ("right", "in"), ("left", "out"), ("right", "out")):
        scene, layout = room(doors=(Opening(0, 3.5, 0.9, 2.05, hinge=hinge, swing=swing),))
        for leaves, far in (("shut", 0.0), ("open", 0.9)):
            model, data = loaded(scene, layout, Options(leaves=leaves))
            assert model.njnt == 0
            ends = [data.geom_xpos[i] for i in range(model.ngeom) if "door-0" in model.geom(i).name]
            depth = [point[1] + 4.0 for point in ends]
            reach = max(depth) if swing == "in" else -min(depth)
            assert far / 2 - 0.1 < reach < far + 0.1
        model, data = loaded(scene, layout, Options())
        joint = model.joint("room/door-0")
        assert joint.range == pytest.approx((0.0, math.pi / 2))
        data.qpos[joint.qposadr] = math.pi / 2
        mujoco.mj_forward(model, data)
        leaf = data.body("room/door-0").xipos
        assert (leaf[1] > -4.0) == (swing == "in")
        assert (leaf[0] > -0.05) == (hinge == "left")


def test_a_wide_door_has_two_leaves() -> None:
    model, _ = loaded(*room(doors=(Opening(0, 3.0, 1.8, 2.05),)), Options())
    assert model.njnt == 2


def test_a_rectangular_body_starts_clear_of_the_door() -> None:
    scene, layout = room(doors=(Opening(0, 3.5, 0.9, 2.05),))
    chair = load_agent("wheelchair")
    assert chair.length is not None
    for start in (None, judge_agent(scene, layout, chair).start):
        model, data = loaded(scene, layout, Options(agent=chair, leaves="shut", start=start))
        assert data.body("agent").xpos[1] >= -4.0 + chair.length / 2 - 1e-6
        assert data.ncon == 0 or not (model.geom_bodyid[data.contact.geom] == model.body("agent").id).any()


def test_what_opens_stays_shut_under_gravity() -> None:
    things = [thing(kind) for kind in ("dishwasher", "stove", "chest", "fridge", "dresser", "toilet")]
    scene = Scene(Room(((-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)), 2.6), tuple(things))
    spots = {asset.name: Pose(-3.0 + 1.2 * i, 0.0, asset.size[2] / 2, 0.0) for i, asset in enumerate(things)}
    settled = settle(scene, Layout(spots))
    assert settled.violations == ()
    assert max(motion.displacement for motion in settled.motions.values()) < 0.003


def test_the_agent_is_left_out_where_none_is_asked_for() -> None:
    model, _ = loaded(*room(thing("chest")), Options(agent=None))
    assert model.nu == 0
    model, _ = loaded(*room(thing("chest")), Options(agent=DEFAULT_AGENT))
    assert model.nu == 3


def test_a_body_opens_what_it_uses_and_touches_nothing() -> None:
    scene, layout = room(thing("wardrobe"))
    holds = usage(scene, layout, DEFAULT_AGENT).holds
    opened = pull_open(scene, layout, DEFAULT_AGENT, holds)
    assert len(opened.joints) == len(holds) >= 2 and opened.violations == ()
    assert all(pulled.share > 0.999 and 1.0 < pulled.force < PULL for pulled in opened.joints.values())


def test_what_leaf_or_body_meets_is_named() -> None:
    wardrobe, lamp = thing("wardrobe"), thing("floor lamp")
    scene, layout = room(wardrobe, lamp)
    layout = Layout({**layout, lamp.name: Pose(0.6, 0.0, lamp.size[2] / 2, 0.0)})
    first = next(hold for hold in usage(scene, layout, DEFAULT_AGENT).holds if hold.moved == (lamp.name,))
    name = f"{first.asset}/{first.joint}"
    assert pull_open(scene, layout, DEFAULT_AGENT, [first]).violations == ()
    in_the_way = Hold(first.asset, first.joint, first.poses)
    met = pull_open(scene, layout, DEFAULT_AGENT, [in_the_way])
    assert met.joints[name].contacts == (lamp.name,)
    before = Hold(first.asset, first.joint, ((0.55, 0.0, 0.0),), first.moved)
    hit = pull_open(scene, layout, DEFAULT_AGENT, [before])
    assert wardrobe.name in hit.joints[name].contacts
    nowhere = pull_open(scene, layout, DEFAULT_AGENT, [Hold(first.asset, first.joint, ())])
    assert nowhere.violations == (f"disc opens {name} by 0% of its range.",)


@pytest.mark.parametrize("kind", ["wardrobe", "fridge", "safe", "kitchen counter", "locker", "display fridge"])
def test_a_door_beside_a_wall_opens_to_its_stop(kind: str) -> None:
    cupboard = thing(kind)
    depth, width, height = cupboard.size
    for side in (-1, 1):
        scene, _ = room(cupboard)
        layout = Layout({cupboard.name: Pose(-4.0 + depth / 2, side * (4.0 - width / 2), height / 2, 0.0)})
        names = {part.joint.name for part in parts(cupboard) if part.joint is not None and part.joint.kind == "hinge"}
        holds = [Hold(cupboard.name, name, ((3.0, 0.0, 0.0),)) for name in names]
        opened = pull_open(scene, layout, DEFAULT_AGENT, holds)
        assert opened.joints and opened.violations == ()


@pytest.mark.parametrize("width", [0.9, 1.6])
@pytest.mark.parametrize("stands_open", [False, True])
def test_the_doors_of_the_room_are_pulled_too(width: float, stands_open: bool) -> None:
    chair, leaf = thing("chair"), Opening(0, 4.0 - width / 2, width, 2.05, swing="in", open=stands_open)
    scene, layout = room(chair, doors=(leaf,))
    opened = pull_open(scene, layout, DEFAULT_AGENT, [])
    assert len(opened.joints) == leaf.leaves and opened.violations == ()
    before = Layout({chair.name: Pose(0.0, -3.6, chair.size[2] / 2, 0.0)})
    met = pull_open(scene, before, DEFAULT_AGENT, [])
    assert any(pulled.contacts == (chair.name,) for pulled in met.joints.values())
    assert met.violations and opened.joints.keys() == met.joints.keys()
