"""What moves: joints of records, and what they say when they are wrong."""

from __future__ import annotations

import math

import numpy as np
import pytest

from robolayout.assets import CATALOGUE, Part, category_of, parts, room_parts, sweeps_of, turned
from robolayout.assets.meshes import joints_of
from robolayout.scene import Asset, Opening, Room


def thing(kind: str, size: tuple[float, float, float] | None = None) -> Asset:
    category = CATALOGUE[kind]
    return Asset(f"{kind.replace(' ', '_')}-0", kind, size or category.size, on_floor=category.on_floor)


def moving(kind: str) -> dict[str, list[Part]]:
    found: dict[str, list[Part]] = {}
    for part in parts(thing(kind)):
        if part.joint is not None:
            found.setdefault(part.joint.name, []).append(part)
    return found


def test_doors_hang_away_from_their_handles_and_take_them_along() -> None:
    for name, group in moving("wardrobe").items():
        assert {part.name for part in group} == {"door", "handle"}, name
        (door,) = (part for part in group if part.name == "door")
        joint = door.joint
        assert joint is not None
        sides = door.vertices[:, 1].min(), door.vertices[:, 1].max()
        assert joint.at[1] == pytest.approx(max(sides, key=lambda y: abs(y - joint.handle[1])))
        assert joint.kind == "hinge" and joint.span[0] == 0.0 and math.radians(84) < joint.span[1] <= math.pi / 2


@pytest.mark.parametrize("kind", ["wardrobe", "fridge", "safe", "kitchen counter", "locker", "shoe cabinet"])
def test_an_open_door_and_its_handle_stay_within_their_things_sides(kind: str) -> None:
    for group in moving(kind).values():
        joint = group[0].joint
        assert joint is not None
        for part in group if joint.kind == "hinge" and abs(joint.axis[2]) == 1.0 else []:
            assert np.abs(turned(joint, part.vertices, joint.span[1])[:, 1]).max() < CATALOGUE[kind].size[1] / 2 + 1e-6


def test_drawers_come_out_by_three_fifths_of_the_depth() -> None:
    for group in moving("dresser").values():
        joint = group[0].joint
        assert joint is not None
        assert (joint.kind, joint.axis) == ("slide", (1.0, 0.0, 0.0))
        assert joint.span[1] == pytest.approx(0.6 * CATALOGUE["dresser"].size[0])
        assert joint.hold[0] < joint.handle[2] < joint.hold[1]


def test_lids_and_flaps_open_upwards_or_forwards() -> None:
    for kind, rises in (("chest", True), ("freezer", True), ("dishwasher", False), ("stove", False)):
        group = next(iter(moving(kind).values()))
        joint = group[0].joint
        assert joint is not None
        points = np.concatenate([part.vertices for part in group])
        moved = turned(joint, points, joint.span[1])
        if rises:
            assert moved[:, 2].max() > points[:, 2].max() + 0.1, kind
        else:
            assert moved[:, 0].max() > points[:, 0].max() + 0.1, kind


def test_every_row_of_every_record_finds_its_parts() -> None:
    for kind, category in CATALOGUE.items():
        if category.joints:
            drawn = {part.name for seed in range(12) for part in parts(thing(kind), seed=seed)}
            for rule in joints_of(category):
                assert rule.names[0] in drawn, f"{kind}: {rule.names[0]}"
                assert rule.kind in ("hinge", "slide"), f"{kind}: {rule.kind}"


@pytest.mark.parametrize("kind", [kind for kind in CATALOGUE if any(part.joint for part in parts(thing(kind)))])
@pytest.mark.parametrize("factor", [0.8, 1.25])
def test_names_are_unique_and_joints_grow_with_the_thing(kind: str, factor: float) -> None:
    depth, width, height = CATALOGUE[kind].size
    made = parts(thing(kind, (depth * factor, width, height)))
    joints = dict.fromkeys(part.joint for part in made if part.joint is not None)
    assert len({joint.name for joint in joints}) == len(joints)
    half = np.array([depth * factor, width, height]) / 2 + 1e-6
    for joint in joints:
        assert (np.abs(joint.at) <= half).all() and (np.abs(joint.handle) <= half).all(), joint
        assert np.linalg.norm(joint.axis) == pytest.approx(1.0)
        assert joint.span[0] <= 0 < joint.span[1]


def test_what_a_door_sweeps_lies_before_the_front_and_within_a_quarter_circle() -> None:
    wardrobe = thing("wardrobe", (0.6, 1.0, 2.0))
    sweeps = sweeps_of(wardrobe)
    assert len(sweeps) == 2
    for sweep in sweeps:
        x0, y0, x1, y1 = sweep.region.bounds
        assert x0 >= 0.3 - 1e-9 and x1 - x0 < 0.5 and y0 >= -0.51 and y1 <= 0.51
        radius = y1 - y0
        assert sweep.region.area == pytest.approx(math.pi * radius**2 / 4, rel=0.2)
        assert sweep.leaf.area < 0.02


def test_where_nothing_moves_the_record_says_how_much_room_is_needed() -> None:
    (sweep,) = sweeps_of(thing("fireplace"))
    assert sweep.joint is None
    assert sweep.region.bounds[2] - sweep.region.bounds[0] == pytest.approx(category_of(thing("fireplace")).open_depth)
    assert sweeps_of(thing("sofa")) == ()


@pytest.mark.parametrize("hinge", ["left", "right"])
@pytest.mark.parametrize("swing", ["in", "out"])
@pytest.mark.parametrize("wide", [0.9, 1.8])
def test_an_open_door_stands_at_a_right_angle_and_turns_shut(hinge: str, swing: str, wide: float) -> None:
    def leaves(is_open: bool) -> list[Part]:
        door = Opening(0, 1.0, wide, 2.0, hinge=hinge, swing=swing, open=is_open)
        room = Room(((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)), 2.5, (door,))
        return [part for part in room_parts(room) if part.joint is not None]

    for shut, wide_open in zip(leaves(False), leaves(True), strict=True):
        assert shut.joint is not None and wide_open.joint is not None
        assert np.allclose(turned(shut.joint, shut.vertices, shut.joint.span[1]), wide_open.vertices)
        assert np.allclose(turned(wide_open.joint, wide_open.vertices, wide_open.joint.span[0]), shut.vertices)
        assert (wide_open.vertices[:, 1].mean() > 0) == (swing == "in")
