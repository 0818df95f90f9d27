"""A room is a function of the SPEC, its number and its try."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh

import robolayout as rl
from robolayout import InputError
from robolayout.many import read_spec
from robolayout.many.room import draw, make
from tiny_sets import tiny_spec

MIXED = {"rooms": ["bedroom", "a bathroom of 3 x 3 m with one window"], "bodies": ["adult", "cat"], "count": 40}


def test_rooms_differ_in_size_shape_list_and_body_and_stay_the_same() -> None:
    ready = read_spec(MIXED)
    drawn = [draw(ready, index) for index in range(40)]
    assert drawn == [draw(ready, index) for index in range(40)]
    bedrooms, bathrooms = drawn[::2], drawn[1::2]
    assert len({one.scene.room.bounds for one in bedrooms}) > 15
    assert {len(one.scene.room.vertices) for one in bedrooms} == {4, 6}
    assert {one.scene.room.bounds for one in bathrooms} == {(0.0, 0.0, 3.0, 3.0)}, "a size that is said is kept"
    assert {len(one.scene.room.windows) for one in bathrooms} == {1}
    assert len({one.scene.room.windows for one in bedrooms}) > 10
    assert len({tuple(a.category for a in one.scene.assets) for one in bedrooms}) > 5
    assert {one.facts["bodies"] for one in drawn} == {"adult", "cat"}
    assert draw(ready, 3, 1) != draw(ready, 3), "another try is another room"
    assert draw(read_spec(MIXED, seed=1), 3) != draw(ready, 3)


def test_ranges_are_kept() -> None:
    table = {
        "rooms": ["office"],
        "area": [1.5, 2],
        "height": 2.8,
        "doors": 2,
        "windows": [2, 3],
        "l_shaped": 0,
        "count": 12,
    }
    usual = read_spec(table).sources[0].size
    for index in range(12):
        room = draw(read_spec(table), index).scene.room
        assert 1.45 <= room.area / (usual[0] * usual[1]) <= 2.05
        assert (room.wall_height, len(room.doors), len(room.vertices)) == (2.8, 2, 4)
        assert 2 <= len(room.windows) <= 3
    dense, bare = (draw(read_spec({**table, "density": d}), 0).scene for d in (0.4, 0.0))
    assert len(dense.assets) > len(bare.assets)


def test_combinations_are_compared_on_the_same_rooms() -> None:
    ready = read_spec(
        {"rooms": ["bedroom", "office"], "solvers": ["default", "paper"], "reach": [True, False], "each": 3}
    )
    assert ready.count == 24
    drawn = [draw(ready, index) for index in range(24)]
    ways = {(one.facts["source"], one.solver, one.reach) for one in drawn}
    assert len(ways) == 8
    for source in ("bedroom", "office"):
        scenes = [one.scene for one in drawn if one.facts["source"] == source]
        assert len({json.dumps(rl.scene.scene_to_dict(scene)) for scene in scenes}) == 3


def test_the_sequence_gives_the_rooms_that_a_batch_makes(tmp_path: Path) -> None:
    table = tiny_spec(tmp_path, 3)
    rooms = rl.rooms(table, seed=2)
    made = make(read_spec(table, seed=2), 1, 0)
    assert len(rooms) == 3 and rooms[1].layout.to_dict() == json.loads(made.files["layout.json"])
    assert rooms[-2].layout == rooms[1].layout
    assert [room.layout for room in rooms] == [room.layout for room in rooms[0:3]]
    assert rooms[0].layout != rl.rooms(table, seed=3)[0].layout
    with pytest.raises(IndexError):
        rooms[3]


def test_a_search_that_knows_no_body_is_judged_for_it(tmp_path: Path) -> None:
    (room,) = rl.rooms(tiny_spec(tmp_path, 1, reach=False, bodies=["wheelchair"], keep_unmet=True))
    assert [body.agent.name for body in room.report.agents] == ["wheelchair"]
    assert [agent.name for agent in room.scene.agents] == ["wheelchair"]


def test_a_room_that_cannot_be_met_is_refused_with_its_reason(tmp_path: Path) -> None:
    table = tiny_spec(tmp_path, 1, bodies=["forklift"], tries=2)
    with pytest.raises(InputError, match=r"room 0 does not meet its demands in 2 tries \(.*impossible"):
        rl.rooms(table)[0]
    assert not rl.rooms({**table, "keep_unmet": True})[0].report.ok


def test_own_meshes_stand_for_their_kind_in_rooms_of_words(tmp_path: Path) -> None:
    meshes = tmp_path / "meshes"
    meshes.mkdir()
    for name, size in (("bed", (1.6, 0.5, 2.1)), ("night stand", (0.4, 0.5, 0.4))):
        trimesh.creation.box(size).export(meshes / f"{name}.glb")
    from robolayout.assets import import_folder

    (meshes / "own.json").write_text(json.dumps(import_folder(meshes)))
    table = {"rooms": ["bedroom"], "count": 4, "catalogues": [str(meshes / "own.json")], "area": 1.2}
    room = rl.rooms(table)[0]
    own = {asset.category: asset for asset in room.scene.assets if asset.path is not None}
    assert set(own) == {"bed", "night stand"}
    assert np.allclose(own["bed"].size, sorted((2.1, 1.6, 0.5), reverse=True), atol=0.01) or own["bed"].size[2] == 0.5
    assert room.report.ok
