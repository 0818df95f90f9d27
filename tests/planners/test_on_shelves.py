"""What is asked onto shelves stands on them, several on each and one above the other; what is said of a top stands on the top."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from tests.planners.said_rooms import made, of

import robolayout as rl
from robolayout.assets.surfaces import emptied, open_shelves
from robolayout.constraints.inside import Inside
from robolayout.planners import scene_from_sentence
from robolayout.run.result import Result
from robolayout.words import read_words
from running import slow


def raised(result: Result, kind: str, bearer: str) -> list[tuple[float, float]]:
    """Return for each thing of a kind how high above the bottom of the next bearer it stands, and how high that is."""
    found = list[tuple[float, float]]()
    for name in of(result, kind):
        at, size = result.layout[name], result.scene.by_name[name].size
        under = min(
            of(result, bearer),
            key=lambda other, x=at.x, y=at.y: abs(result.layout[other].x - x) + abs(result.layout[other].y - y),
        )
        pose, tall = result.layout[under], result.scene.by_name[under].size[2]
        found.append((at.z - size[2] / 2 - pose.z + tall / 2, tall))
    return found


@pytest.mark.parametrize(
    ("text", "kind", "bearer"),
    [
        slow(
            "A storage room with three shelves along the wall and six cardboard boxes on the shelves.",
            "cardboard_box",
            "shelving_unit",
        ),
        slow("A workshop with a shelf of spare tires to the left.", "tire", "shelving_unit"),
        slow(
            "A sewing room with a sewing machine on a table and a shelf with six boxes.", "storage_box", "shelving_unit"
        ),
        slow("A craft room with a shelf with three baskets.", "basket", "shelving_unit"),
        slow("A bedroom with three books in the bookshelf.", "book", "bookshelf"),
        ("A hallway with a shoe rack with four pairs of shoes and a bench.", "shoes", "shoe_rack"),
        slow("A living room with a bookshelf with three vases on its shelves.", "vase", "bookshelf"),
    ],
)
def test_what_is_on_shelves_stands_below_their_top(text: str, kind: str, bearer: str) -> None:
    result = made(text)
    assert result.report.ok, result.report.violations
    assert all(0.0 < low < tall - 0.1 for low, tall in raised(result, kind, bearer))


@pytest.mark.parametrize(
    ("text", "how"),
    [
        ("A pantry with a shelving unit and four jars on the shelves.", "inside"),
        ("A pantry with a shelving unit and a jar on top of the shelving unit.", "on_top_of"),
        ("A bedroom with a bookshelf and a trophy on the bookshelf.", "on_top_of"),
        ("A bedroom with a dresser and a vase on the dresser.", "on_top_of"),
        ("A living room with a rocking chair and a teddy bear in the rocking chair.", "on_top_of"),
    ],
)
def test_only_shelves_have_things_on_their_shelves(text: str, how: str) -> None:
    wishes = read_words(scene_from_sentence(text)[0])
    stated = [relation for demand in wishes.demands for way in demand.ways for relation in way]
    assert {relation.name for relation in stated if relation.name in ("inside", "on_top_of")} == {how}


def test_one_of_many_shelves_is_emptied_and_all_stay_alike() -> None:
    scene, _ = scene_from_sentence("A toy store with six shelves in rows and three balls on one of the shelves.")
    shelves = [one for one in scene.assets if one.category == "shop shelf"]
    assert [bool(one.without) for one in shelves] == [True] + 5 * [False]
    assert len({one.size for one in shelves}) == 1
    scene, _ = scene_from_sentence(
        "A garage with two shelves with paint cans, a workbench and a third shelf with books."
    )
    assert [bool(one.without) for one in scene.assets if one.category == "shelving unit"] == 3 * [True]


def test_a_shelf_is_as_deep_and_a_top_as_wide_as_it_takes() -> None:
    def size(text: str, kind: str) -> tuple[float, float, float]:
        return next(one.size for one in scene_from_sentence(text)[0].assets if one.category == kind)

    usual, deeper = (
        size(f"A storage room with a shelf{more}.", "shelving unit") for more in ("", " with two cardboard boxes")
    )
    assert usual[0] < 0.4 < deeper[0] < 0.5 and deeper[1] == pytest.approx(usual[1], abs=0.1)
    assert size("A storage room with a shelf 30 cm deep with two cardboard boxes.", "shelving unit")[0] == 0.3
    crowd = "A playroom with a toy shelf full of toys, two teddy bears and a ball on the shelf."
    assert size(crowd, "toy shelf")[1] > 1.3 > size("A playroom with a toy shelf.", "toy shelf")[1]


def test_a_program_puts_more_onto_shelves_than_one_of_them_holds() -> None:
    """The first edition stood all on one shelf, in each other."""
    scene, _ = scene_from_sentence(
        "A storage room of 4 x 4 m with a shelving unit, six cardboard boxes and nothing else."
    )
    lines = [f"solver.inside(cardboard_box[{i}], shelving_unit[0])" for i in range(3)]
    assets = [
        replace(emptied(one, [(0.4, 0.6, 0.4)], shelves=True), size=(0.5, 0.9, 1.5))
        if one.category == "shelving unit"
        else one
        for one in scene.assets
    ]
    scene = replace(
        scene, assets=tuple(one for one in assets if one.name not in [f"cardboard_box-{i}" for i in (3, 4, 5)])
    )
    (shelf,) = (one for one in scene.assets if one.category == "shelving unit")
    levels = [surface.height for surface in open_shelves(shelf)]
    result = rl.generate(replace(scene, task_description=""), program="\n".join(lines))
    assert result.report.ok, result.report.violations
    found = sorted(low for low, _ in raised(result, "cardboard_box", "shelving_unit"))
    assert found == pytest.approx(sorted(levels), abs=0.01)


def test_a_named_shelf_is_the_one_that_is_meant() -> None:
    text = "A bedroom with a bookshelf and a book on the bookshelf."
    scene, _ = scene_from_sentence(text)
    scene = replace(
        scene, assets=tuple(emptied(one, [(0.2, 0.2, 0.2)], shelves=True) for one in scene.assets), task_description=""
    )
    result = rl.generate(scene, program='solver.inside(book[0], bookshelf[0], surface="shelf 2")')
    (shelf,) = (one for one in scene.assets if one.category == "bookshelf")
    (low, _), *_ = raised(result, "book", "bookshelf")
    assert low == pytest.approx(open_shelves(shelf)[1].height, abs=0.01)
    assert not re.search("book-0", " ".join(result.report.violations))


@pytest.mark.slow
def test_several_kinds_on_one_unit_are_in_nobodys_way() -> None:
    result = made("A pantry with one shelving unit and eight jars and six bottles on the shelves.")
    assert result.report.ok, result.report.violations
    heights = {round(low, 3) for kind in ("jar", "bottle") for low, _ in raised(result, kind, "shelving_unit")}
    assert len(heights) > 1


@pytest.mark.parametrize(
    ("text", "kind", "which"),
    [
        ("A bedroom with a bookshelf and three books on the bottom shelf of the bookshelf.", "book", 0),
        ("A study with a bookshelf. A globe stands on its second shelf.", "globe", 1),
        ("A bedroom with a bookshelf with a vase on the top shelf.", "vase", -1),
        ("A home office with a bookshelf with a plant on the top shelf, and an armchair.", "potted_plant", -1),
    ],
)
def test_the_shelf_that_is_said_is_the_one_that_is_taken(text: str, kind: str, which: int) -> None:
    """Things too tall for the shelf, a vase or globe, are ones that stand there."""
    result = made(text)
    assert result.report.ok, result.report.violations
    (name,) = of(result, "bookshelf")
    level = open_shelves(result.scene.by_name[name])[which].height
    assert [low for low, _ in raised(result, kind, "bookshelf")] == pytest.approx(
        [level] * len(of(result, kind)), abs=0.01
    )
    assert result.scene.by_name[name].without, "the shelf is emptied for what stands there"


def test_compartments_side_by_side_are_one_shelf() -> None:
    scene, _ = scene_from_sentence("A children's room with a toy shelf with two balls on the bottom shelf.")
    stated = [relation for demand in read_words(scene).demands for way in demand.ways for relation in way]
    assert [relation.surface for relation in stated if relation.name == "inside"] == ["shelf 1", "shelf 2"]


def test_one_of_several_shelves_is_not_a_level() -> None:
    wishes = read_words(scene_from_sentence("A bathroom with three wall shelves, a plant on the top shelf.")[0])
    stated = [str(relation) for demand in wishes.demands for way in demand.ways for relation in way]
    assert any("potted_plant-0" in one and "wall_shelf-2" in one and "inside" not in one.lower() for one in stated)


def test_a_child_gets_to_the_books_that_fill_a_low_bookshelf() -> None:
    scene, _ = scene_from_sentence("A child's bedroom with a low bookshelf filled with books.")
    (inside, *_) = (one for demand in read_words(scene).demands for one in demand.ways[0] if isinstance(one, Inside))
    agent = scene.agents[0]
    assert inside.places(scene)[0].height < agent.reach_high
    taller = replace(scene, agents=(replace(agent, reach_high=2.0),))
    assert inside.places(taller)[0].height > agent.reach_high
