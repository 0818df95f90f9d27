"""Dressing: what lies about lies where it should, judged, and the room is as it was."""

from __future__ import annotations

import math
import tomllib
from collections import Counter
from dataclasses import replace
from importlib import import_module

import pytest

from robolayout._errors import SceneError
from robolayout.assets import CATALOGUE, surfaces_of
from robolayout.assets.category import DATA
from robolayout.export import settle
from robolayout.run.flow import dressed, generate
from robolayout.run.result import judge
from robolayout.scene import DRESSINGS, Asset, Layout, Opening, Pose, Room, Scene, scene_from_dict, scene_to_dict
from robolayout.solve import dress
from robolayout.solve.dress import DressConfig
from robolayout.verify import physics, verify

ROOM = Room(((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)), 2.6, (Opening(0, 3.8, 0.9, 2.05),))


def on_floor(kind: str, x: float, y: float, degrees: float, number: int = 0) -> tuple[Asset, Pose]:
    category = CATALOGUE[kind]
    asset = Asset(f"{kind.replace(' ', '_')}-{number}", kind, category.size)
    return asset, Pose(x, y, category.size[2] / 2, math.radians(degrees))


def furnished(*placed: tuple[Asset, Pose], name: str = "living room") -> tuple[Scene, Layout]:
    scene = Scene(ROOM, tuple(asset for asset, _ in placed), name=name)
    return scene, Layout({asset.name: pose for asset, pose in placed})


def living_room() -> tuple[Scene, Layout]:
    return furnished(
        on_floor("bookshelf", 0.2, 1.0, 0),
        on_floor("dining table", 2.5, 2.2, 0),
        on_floor("chair", 3.35, 2.2, 180),
        on_floor("chair", 1.65, 2.2, 0, 1),
        on_floor("sideboard", 2.5, 3.75, 270),
        on_floor("coffee table", 4.2, 3.2, 0),
    )


def test_names_of_the_rules_are_in_the_catalogue() -> None:
    data = tomllib.loads((DATA / "dressing.toml").read_text("utf-8"))
    for rule in data["rule"]:
        assert set(rule["on"]) <= set(CATALOGUE), rule
        assert rule["where"] in ("any", "top", "seat", "shelf", "drawer", "hook")
        for part in (rule, *rule.get("also", ())):
            assert set(part.get("things", ())) <= set(CATALOGUE), rule
            assert set(part.get("stack", ())) <= set(part.get("things", ())), rule
            assert ("set" in part and part["set"] in data["sets"]) == (part["put"] == "places")
    for entries in data["sets"].values():
        assert {kind for kind, *_ in entries} <= set(CATALOGUE)
    assert set(data["once"]) <= set(CATALOGUE)


def test_every_small_thing_passes_the_judge_and_the_room_is_not_touched() -> None:
    scene, layout = living_room()
    found = dress(scene, layout)
    assert len(found.names) > 20
    assert physics(found.scene, found.layout).failing == ()
    assert {name: found.layout[name] for name in layout} == dict(layout)
    assert [replace(a, without=()) for a in found.scene.assets[: len(scene.assets)]] == list(scene.assets)
    assert all(found.scene.by_name[name].lies_about for name in found.names)


@pytest.mark.slow
def test_it_stays_where_it_lies_for_five_seconds() -> None:
    found = dress(*living_room(), seed=3)
    assert settle(found.scene, found.layout).violations == ()


def hall() -> tuple[Scene, Layout]:
    hooks = Asset("wall_hooks-0", "wall hooks", CATALOGUE["wall hooks"].size, on_floor=False, on_wall=True)
    return furnished(
        (hooks, Pose(1.5, 3.96, 1.7, math.radians(270))),
        on_floor("coat rack", 3.0, 2.0, 30),
        on_floor("hall tree", 0.2, 2.0, 0),
        on_floor("dresser", 4.75, 2.0, 180),
        name="hall",
    )


@pytest.mark.slow
def test_coats_hang_from_hooks_and_clothes_lie_in_drawers_and_stay_there() -> None:
    found = dress(*hall())
    kinds = Counter(found.scene.by_name[name].category for name in found.names)
    assert kinds["hanging coat"] >= 3 and kinds["clothes"] >= 3
    assert physics(found.scene, found.layout).failing == ()
    assert settle(found.scene, found.layout).violations == ()
    name = next(name for name in found.names if name.startswith("hanging_coat"))
    for moved in (0.03, -0.05):
        pose = found.layout[name]
        off = Layout({**found.layout, name: replace(pose, z=pose.z + moved)})
        assert name in physics(found.scene, off).failing, "beside its hook it falls"


@pytest.mark.slow
def test_cupboards_are_full_behind_their_doors_and_stay_so() -> None:
    scene, layout = furnished(on_floor("wardrobe", 0.31, 1.5, 0), on_floor("kitchen cabinet", 2.5, 3.7, 270))
    found = dress(scene, layout)
    wardrobe, cabinet = (found.scene.by_name[name] for name in ("wardrobe-0", "kitchen_cabinet-0"))
    insides = {
        asset.name: [
            name
            for name in found.names
            if math.dist((found.layout[name].x, found.layout[name].y), (layout[asset.name].x, layout[asset.name].y))
            < 0.7
            and found.layout[name].z < asset.size[2] - 0.05
        ]
        for asset in (wardrobe, cabinet)
    }
    assert all(len(names) > 10 for names in insides.values())
    stacked = Counter((round(p.x, 3), round(p.y, 3)) for p in (found.layout[name] for name in found.names))
    assert max(stacked.values()) >= 3, "clothes and plates lie in stacks"
    assert physics(found.scene, found.layout).failing == ()
    assert settle(found.scene, found.layout).violations == ()


def test_a_chair_pushed_under_a_desk_leaves_its_place_free() -> None:
    desk, chair = on_floor("student desk", 2.0, 2.0, 0), on_floor("chair", 2.4, 2.0, 180)
    found = dress(*furnished(desk, chair, name="classroom"))
    assert "book" in {found.scene.by_name[name].category for name in found.names if found.layout[name].z > 0.74}


def test_a_set_table_has_a_plate_before_every_seat() -> None:
    found = dress(*living_room())
    table = found.layout["dining_table-0"]
    plates = [
        found.layout[name]
        for name in found.names
        if name.startswith("plate") and found.layout[name].z > 0.75 and abs(found.layout[name].y - 2.2) < 0.1
    ]
    assert len(plates) == 2
    for chair in ("chair-0", "chair-1"):
        seat = found.layout[chair]
        plate = min(plates, key=lambda pose: math.dist((pose.x, pose.y), (seat.x, seat.y)))
        assert abs(plate.y - seat.y) < 0.01 and abs(plate.x - table.x) < abs(seat.x - table.x)
        assert math.cos(plate.yaw - seat.yaw) == pytest.approx(-1.0), "it faces the one who eats"


def test_books_stand_in_shelves_that_were_cleared_for_them() -> None:
    found = dress(*living_room())
    shelf = found.scene.by_name["bookshelf-0"]
    assert "books" in shelf.without
    levels = [surface.height for surface in surfaces_of(shelf) if surface.covered]
    books = [name for name in found.names if name.startswith("upright_book")]
    assert len(books) > 20 and len({found.scene.by_name[name].size for name in books}) > 20
    for name in books:
        bottom = found.layout[name].z - found.scene.by_name[name].size[2] / 2
        assert min(abs(bottom - level) for level in levels) < 0.002


def test_amounts_differ_and_are_settled_by_the_seed() -> None:
    scene, layout = living_room()
    counts = {amount: len(dress(scene, layout, amount).names) for amount in DRESSINGS}
    assert counts["none"] == 0 < counts["some"] < counts["full"]
    assert dress(scene, layout, seed=1) == dress(scene, layout, seed=1)
    assert dress(scene, layout, seed=1).layout != dress(scene, layout, seed=2).layout


def test_names_and_their_order_settle_nothing() -> None:
    scene, layout = living_room()
    found = dress(scene, layout)
    turned = dress(replace(scene, assets=scene.assets[::-1]), layout)
    assert Counter(found.scene.by_name[name].category for name in found.names) == Counter(
        turned.scene.by_name[name].category for name in turned.names
    )


def test_a_dressed_room_can_be_dressed_again() -> None:
    once = dress(*living_room())
    twice = dress(once.scene, once.layout, seed=5)
    assert len(twice.scene.by_name) == len(twice.scene.assets)
    assert not set(physics(twice.scene, twice.layout).failing)


def test_there_are_never_more_than_wanted_and_what_is_left_keeps_its_drawn_goods(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    shelves = [on_floor("shop shelf", 0.5 + 1.3 * i, 0.4 + 1.5 * j, 90, 3 * j + i) for i in range(3) for j in range(2)]
    scene, layout = furnished(*shelves, name="store")
    monkeypatch.setattr(import_module("robolayout.solve.dress"), "DRESS", DressConfig(most=40))
    found = dress(scene, layout)
    assert len(found.names) <= 40
    assert {bool(asset.without) for asset in found.scene.assets if asset.category == "shop shelf"} == {True, False}


def test_there_is_one_kettle_in_a_kitchen() -> None:
    counters = [on_floor("kitchen counter", 0.35, 0.95 + 1.9 * i, 0, i) for i in range(2)]
    scene, layout = furnished(*counters, name="kitchen")
    for seed in range(6):
        kinds = Counter(asset.category for asset in dress(scene, layout, seed=seed).scene.assets)
        assert max(kinds[kind] for kind in ("kettle", "toaster", "knife block")) <= 1


def test_a_scene_says_how_it_is_dressed_and_reads_back() -> None:
    scene, _ = living_room()
    data = scene_to_dict(replace(scene, dress="some"))
    assert data["dress"] == "some" and scene_from_dict(data).dress == "some"
    assert "dress" not in scene_to_dict(scene)
    found = dress(*living_room())
    again = scene_from_dict(scene_to_dict(found.scene), name=found.scene.name)
    assert again.assets == found.scene.assets
    assert [asset.lies_about for asset in again.assets] == [asset.lies_about for asset in found.scene.assets]
    with pytest.raises(SceneError, match="dress must be 'none', 'some', 'full', but is 'much'"):
        scene_from_dict({**data, "dress": "much"})


def test_what_lies_about_is_counted_and_not_demanded() -> None:
    scene, layout = living_room()
    found = dress(scene, layout)
    report = verify(found.scene, found.layout, agent="adult")
    assert report.dressing["things"] == len(found.names)
    assert 0 < report.dressing["fetched"]["adult"] <= len(found.names)
    assert set(found.names) <= set(report.agents[0].exempt)
    assert not set(found.names) & set(report.agents[0].navigation.routes)
    assert verify(scene, layout).dressing == {}
    assert f"{len(found.names)} small things lie about" in report.to_markdown()


def test_a_run_dresses_its_room_and_says_so() -> None:
    scene, layout = living_room()
    given = judge(replace(scene, dress="full"), layout)
    result = dressed(given, "some", seed=0)
    assert result.report.dressing["things"] == len(result.scene.assets) - len(scene.assets) > 0
    assert result.scene.dress == "none", "it is done"
    assert dressed(given, "none", seed=0) is given
    with pytest.raises(SceneError, match="dress must be"):
        generate(scene, dress="heaps")
