"""Sentences about where a body gets: ways, both sides of a bed, room to turn; and what the planner and the judge make of them."""

from __future__ import annotations

import pytest
from shapely import Polygon, affinity, box

import robolayout as rl
from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import Lexicon, read_rooms, read_text, read_words
from robolayout.words._reworded import reworded
from robolayout.words._said import mentions, places
from robolayout.words._tokens import tokens

LEXICON = Lexicon(read_rooms())


def _box(depth: float, width: float) -> Polygon:
    return box(-depth / 2, -width / 2, depth / 2, width / 2)


def asked(text: str) -> list[tuple[str, list[str]]]:
    """Return the things of every relation in a text and the sides that are to stay free."""
    found: list[tuple[str, list[str]]] = []
    for link in read_text(text, LEXICON).parsed.links:
        things = [mention.thing.head for mention in mentions((*link.subjects, *link.objects))]
        found.append((link.relation, [*things, *(" ".join(at.words) or at.name for at in places(link.objects))]))
    return found


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("A bedroom where a wheelchair can reach both sides of the bed.", [("cleared", ["bed", "left", "right"])]),
        ("The bed must be reachable from both sides.", [("cleared", ["bed", "left", "right"])]),
        ("A wheelchair user can get to the bed from both sides.", [("cleared", ["bed", "left", "right"])]),
        ("A dining room where a person can walk behind the chairs.", [("cleared", ["chair", "back"])]),
        ("A bedroom with enough space for a wheelchair on the left of the bed.", [("cleared", ["bed", "left"])]),
        ("Enough room for a wheelchair next to the toilet.", [("cleared", ["toilet", "left or right"])]),
        ("Keep the space in front of the table clear.", [("cleared", ["table", "front"])]),
        ("An office where the robot can get to every desk.", [("way", ["desk"])]),
        ("An office where every desk can be reached by a wheelchair.", [("way", ["desk"])]),
        ("A robot can get from the door to the sofa and to the window.", [("way", ["sofa", "door", "window"])]),
        ("She must be able to reach the bed, the desk and the window.", [("way", ["bed", "desk", "window"])]),
        ("It can reach the desk by the bed.", [("way", ["desk"]), ("by", ["desk", "bed"])]),
        ("A bedroom where I can see the door from the bed.", [("facing", ["bed", "door"])]),
        ("The window should be visible from the desk.", [("facing", ["desk", "window"])]),
        ("a desk I can reach from my bed", [("near", ["desk", "bed"])]),
    ],
)
def test_what_is_said_of_where_bodies_get(text: str, said: list[tuple[str, list[str]]]) -> None:
    assert asked(text) == said


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("Leave 1 m in front of the wardrobe free.", 1.0),
        ("I use a wheelchair, so leave at least 120 cm beside the bed.", 1.2),
        ("There must be a turning circle of 1.4 m in front of the toilet.", 1.4),
        ("A wheelchair user can turn in front of the sink.", 1.5),
        ("A living room with room to walk around the table.", 0.0),  # as much as the body needs
    ],
)
def test_how_much_floor_is_to_stay_free(text: str, metres: float) -> None:
    links = read_text(text, LEXICON).parsed.links
    assert [(link.relation, link.metres[0]) for link in links] == [("cleared", metres)]


@pytest.mark.parametrize(
    "text",
    [
        "A wheelchair can not reach the bed.",
        "A bathroom with a 1.5 m turning circle.",
        "The drawers of the dresser must be accessible.",
    ],
)
def test_what_cannot_be_said_of_where_bodies_get_is_given_back(text: str) -> None:
    scene, _ = scene_from_sentence(f"A bedroom. {text}")
    rows = [row for row in read_words(scene).rows if row.kind == "not understood"]
    assert rows


def test_bodies_that_reach_something_are_who_the_room_is_for() -> None:
    for text in ("a wheelchair can reach both sides of the bed", "every bed can be reached by a wheelchair"):
        scene, _ = scene_from_sentence(f"A bedroom where {text}.")
        assert [agent.name for agent in scene.agents] == ["wheelchair"]
        assert not [asset.name for asset in scene.assets if "wheelchair" in asset.name]


def test_a_wheelchair_gets_to_both_sides_of_a_bed() -> None:
    run = rl.generate("A bedroom where a wheelchair can reach both sides of the bed", seed=0)
    bed, at, free = run.scene.by_name["bed-0"], run.layout["bed-0"], 2 * run.scene.agents[0].radius - 0.05
    strip = affinity.translate(
        affinity.rotate(_box(bed.size[0], bed.size[1] + 2 * free), at.yaw, (0, 0), use_radians=True), at.x, at.y
    )
    assert strip.difference(Polygon(run.scene.room.vertices)).area < 0.01
    for asset in run.scene.assets:
        pose = run.layout.get(asset.name)
        if pose is None or asset is bed or asset.is_flat or pose.z > bed.size[2]:
            continue
        there = affinity.rotate(_box(*asset.size[:2]), pose.yaw, (0, 0), use_radians=True)
        assert strip.intersection(affinity.translate(there, pose.x, pose.y)).area < 0.02, asset.name
    assert {row.verdict for row in run.report.asked} == {"met"}


def test_measures_in_a_kitchen_of_a_name_are_of_what_they_are_said_of() -> None:
    reading = read_text("A galley kitchen with a 120 cm table and a fridge 2 m tall", LEXICON)
    sizes = {thing.noun.words: [size.values for size in thing.sizes] for thing in reading.parsed.things}
    assert sizes["dining table"] == [(1.2,)]
    assert sizes["fridge"] == [(2.0,)]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("The wardrobe doors can open without hitting the bed.", [("cleared", ["wardrobe", "front"])]),
        ("A kitchen where the doors of the fridge can open fully.", [("cleared", ["fridge", "front"])]),
        ("Two people can get out of bed on both sides.", [("cleared", ["bed", "left", "right"])]),
    ],
)
def test_what_has_to_open_has_free_floor_before_it(text: str, said: list[tuple[str, list[str]]]) -> None:
    assert asked(text) == said


def test_without_doing_something_to_a_thing_refuses_no_thing() -> None:
    for text in ("A bedroom with a wardrobe that opens without hitting the bed.", "A room without moving the table."):
        reading = read_text(text, LEXICON)
        assert not reading.parsed.refused
        assert not {thing.noun.kind for thing in reading.parsed.things} & {"bed", "dining table"}
        assert any("without" in reading.span(missed.start, missed.end) for missed in reading.parsed.missed)


def test_a_list_without_an_end_is_read_in_no_time() -> None:
    """Commas inside a repeated group were tried in every order."""
    assert reworded(tokens("; a way to the bed" + " , the bed" * 500)) == tokens(
        "; a way to the bed" + " , the bed" * 500
    )
