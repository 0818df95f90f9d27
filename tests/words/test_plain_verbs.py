"""Verbs of plain English: what completes a room, what a wall has, what people say of themselves, and no things made of them."""

from __future__ import annotations

from collections import Counter

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words


def there(text: str) -> Counter[str]:
    """Return how many things of each kind a text is given."""
    return Counter(asset.name.rsplit("-", 1)[0] for asset in scene_from_sentence(text)[0].assets)


def rows(text: str) -> list[tuple[str, str]]:
    """Return the kinds and meanings of the rows of a text."""
    return [(row.kind, row.understanding) for row in read_words(scene_from_sentence(text)[0]).rows]


@pytest.mark.parametrize(
    ("text", "count", "never"),
    [
        ("A living room. A host stand near the entrance completes the room.", {"host_stand": 1}, "entrance"),
        ("A bookstore. Two cubby shelves complete the room.", {"toy_shelf": 2}, "complete"),
        ("A bedroom with a bed and a desk, rounding out the space with a rug.", {"rug": 1}, "round"),
        ("This bedroom comprises a bed and a wardrobe.", {"bed": 1, "wardrobe": 1}, "comprise"),
        ("A science laboratory comprises four benches", {"lab_bench": 4}, "comprise"),
        ("The bunk room accommodates three bunk beds.", {"bunk_bed": 3}, "accommodate"),
        ("The gallery presents five sculptures.", {"floor_sculpture": 5}, "storage_box"),
        ("A hallway. A runner extends down the length of the hallway", {"rug": 1}, "length"),
        ("A bedroom with a bed and the door opens inwards on the south wall", {"bed": 1}, "inward"),
        ("The room I rent is 4 by 3 m. It has a bed.", {"bed": 1}, "rent"),
        ("I teach a class of twelve. A classroom with twelve desks.", {"student_desk": 12}, "class"),
        ("A bedroom with a bed, not near the window and not near the radiator either.", {"radiator": 1}, "either"),
        ("An office with a desk facing the door so that whoever sits there can see it.", {"desk": 1}, "whoever"),
        ("A cafe. Two round tables would fit by the window.", {"round_table": 2}, "fit"),
        ("I'm a painter and need a studio with an easel.", {"easel": 1}, "painter"),
        ("We are a couple renting a small bedroom with a bed.", {"bed": 1}, "couple"),
        ("The room's dimensions are 4 m by 5 m. It is a bedroom with a bed.", {"bed": 1}, "dimension"),
        ("The hotel lobby welcomes guests with a reception desk and two sofas.", {"sofa": 2}, "welcome"),
        ("A library. The reading nook invites you with an armchair and a lamp.", {"armchair": 1}, "invite"),
        ("A living room with two sofas where we watch films in the evening.", {"sofa": 2}, "evening"),
        ("My kids do their homework at a desk under the window.", {"desk": 1}, "homework"),
        ("A living room with a door that opens onto the terrace.", {}, "open"),
        ("I dislike rugs. A bedroom with a bed.", {"rug": 0}, "dislike"),
        ("A dining table takes centre stage in the dining room.", {"dining_table": 1}, "stage"),
        ("A study featuring a desk and housing two bookcases.", {"bookshelf": 2}, "hous"),
        ("The kitchen. The kitchen utensils hang above the counter.", {"knife_block": 2}, "hang"),
    ],
)
def test_no_things_are_made_of_verbs(text: str, count: dict[str, int], never: str) -> None:
    """An unknown word after a noun, in -s or before an article, was the noun of a thing that nobody knows."""
    found = there(text)
    assert {kind: found[kind] for kind in count} == count
    assert not [kind for kind in found if never in kind and kind not in count]
    assert not [kind for kind, _ in rows(text) if kind == "not understood"]


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A bedroom. The east wall features a tall wardrobe.", "against_wall(wardrobe-0, walls[1])"),
        ("A bedroom. The north wall is occupied by a bed.", "against_wall(bed-0, walls[2])"),
        ("A bathroom. The west wall is fitted with a wide mirror.", "mounted_on(mirror-0, walls["),
        (
            "A gym with two treadmills facing the west wall, which is fitted with a wide mirror.",
            "mounted_on(mirror-0, walls[3])",
        ),
        (
            "A library where the north wall is covered by three bookcases standing shoulder to shoulder.",
            "next_to(bookshelf-0, bookshelf-1",
        ),
        ("A bedroom. The wall opposite the door features a wardrobe.", "against_wall(wardrobe-0, walls["),
        ("A bedroom with a bed. The west wall has a window.", "1 west window"),
        ("An office. The wall with the window holds a desk.", "against_wall(desk-0, walls["),
        ("A bedroom with a bed. The corner by the window houses a desk.", "corner(desk-0"),
        ("A game room. The center of the room holds a pool table.", "distance_constraint(pool_table-0, ("),
        ("A bathroom with a bathtub along the full length of the south wall.", "against_wall(bathtub-0, walls["),
        (
            "A waiting room with a row of six chairs along the north wall and another row of four along the south wall.",
            "against_wall(chair-6, walls[",
        ),
    ],
)
def test_a_wall_has_what_is_said_of_it(text: str, meant: str) -> None:
    """A wall that features, is occupied by or is fitted with a thing was not understood, nor a row without its noun."""
    said = rows(text)
    assert any(meant in understanding for _, understanding in said)
    assert not [kind for kind, _ in said if kind == "not understood"]


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("I plan to open a cafe with four tables.", "a cafe"),
        ("A living room with an armchair by the window where I read.", "a living room"),
        ("I'm allergic to cats. A bedroom with a bed.", "a bedroom"),
        ("We are moving into a living room with a sofa.", "a living room"),
        ("A rug by the window completes the living room.", "a living room"),
        ("She'd like an armchair by the window in her living room.", "a living room"),
        ("I've got a bedroom with a bed and a desk.", "a bedroom"),
        ("The bedroom's size is 4 by 3 m. It has a bed.", "a bedroom"),
        ("Two cats live with me in a studio of 5 by 4.2 metres.", "a studio"),
        ("My brother and I share a bedroom of 4 by 4 m with two beds.", "a children's room"),
        ("A living room with a sofa paired with a coffee table.", "a living room"),
        ("A bedroom is depicted with a bed and a desk.", "a bedroom"),
        ("The entryway is narrow. It has a bench and a coat rack.", "the nearest room type to it, hallway"),
        ("Entryway with a bench and a coat rack.", "the nearest room type to it, hallway"),
        ("A lab with two tables for pick-and-place experiments.", "a laboratory"),
        ("Our sitting room has a sofa and a fireplace.", "a living room"),
        ("Woodworking studio with two workbenches and a drill press.", "a workshop"),
    ],
)
def test_what_asks_for_nothing_is_understood(text: str, room: str) -> None:
    """Words about those who ask, and of what a room is for, were not understood, or took the room type with them."""
    said = rows(text)
    assert ("room type", room) in said
    assert not [kind for kind, _ in said if kind == "not understood"]


def test_purposes_bodies_and_tools_are_what_they_are() -> None:
    """A navigation study is no room for one who studies, a robot with two arms no turtlebot, a hammer no large box."""
    assert "desk" not in there("A living room with a sofa for a navigation study.")
    assert ("body", "for tiago") in rows("A lab with a dual-arm robot and a table.")
    assert "shelving_unit" not in there("A laboratory bench with a rack of test tubes on it. Nothing else.")
    assert there("A boutique with three racks of clothing.")["clothes_rack"] == 3
    scene, _ = scene_from_sentence("A workshop with a tool chest holding a hammer, a drill and two screwdrivers.")
    tools = [asset for asset in scene.assets if asset.name.startswith(("hammer", "drill-", "screwdriver"))]
    assert len(tools) == 4
    assert all(max(asset.size) <= 0.3 for asset in tools)


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("An office with a desk. Nothing else.", {"desk": 1}),
        ("A dining room with a table and nothing else.", {"dining_table": 1}),
        ("A dining room with a table for six. Nothing else.", {"dining_table": 1, "chair": 6}),
    ],
)
def test_nothing_else_is_added_where_nothing_else_is_wanted(text: str, things: dict[str, int]) -> None:
    """A chair was added to a desk where nothing else was wanted, and then reported as one too many."""
    assert there(text) == things
