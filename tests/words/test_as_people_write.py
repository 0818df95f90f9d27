"""What people write besides demands, and demands that they put otherwise: nothing is made of the one, nothing of the other is lost."""

from __future__ import annotations

import pytest

from robolayout import generate
from robolayout.assets.beneath import clearance
from robolayout.planners.sentence import scene_from_sentence
from robolayout.scene import Layout, Pose
from robolayout.words import read_words


def rows(text: str) -> list[tuple[str, str, str]]:
    """Return the kinds, words and meanings of the rows of a text."""
    return [(row.kind, row.words, row.understanding) for row in read_words(scene_from_sentence(text)[0]).rows]


@pytest.mark.parametrize(
    ("word", "never"),
    [("planner", "milling"), ("ledger", "wall shelf"), ("boulder", "shoulder"), ("sofas", "milling")],
)
def test_no_known_word_is_a_slip_of_spelling(word: str, never: str) -> None:
    """One letter lies between "planner" and "planer", a milling machine; a dictionary knows both."""
    scene, _ = scene_from_sentence(f"A study. A {word} lies next to the desk.")
    assert not [asset.name for asset in scene.assets if never in asset.category]


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("A bedroom. A bed stands at least a metre and a half from the desk.", "bed-0 at least 1.5 m from desk-0"),
        ("A bedroom. A desk one metre twenty wide stands by the window.", "wide 1.2 m"),
        ("A store. Two shop shelves stand 90 cm or more apart.", "at least 0.9 m"),
    ],
)
def test_lengths_of_several_words(text: str, meaning: str) -> None:
    assert any(meaning in understanding for _, _, understanding in rows(text))


@pytest.mark.parametrize(
    "text",
    [
        "A study. A desk stands by the window. My brother works at night, and he hates the noise.",
        "A living room with a sofa. We have just moved in, and the landlord finally agreed.",
        "A bedroom with a bed. I have been dreaming of this for years.",
        "A cafe with two round tables. Last year we had no space for anything.",
    ],
)
def test_what_somebody_tells_is_no_thing_and_no_demand(text: str) -> None:
    told = rows(text)
    assert not [row for row in told if row[0] == "not understood"]
    assert len([row for row in told if row[0] == "count"]) == 1


@pytest.mark.parametrize(
    ("text", "refused"),
    [
        ("A study. Absolutely no piano.", "piano"),
        ("A study. Under no circumstances a piano.", "piano"),
        ("A study. Definitely not a piano.", "piano"),
        ("A study. Please a piano.", None),
        ("A study. Certainly a piano.", None),
    ],
)
def test_what_is_only_stressed_is_not_refused(text: str, refused: str | None) -> None:
    assert [words for kind, words, _ in rows(text) if kind == "refusal"] == ([refused] if refused else [])


def test_furniture_told_along_one_wall_is_made_narrower_to_fit_there() -> None:
    scene, _ = scene_from_sentence(
        "A bedroom of 3 by 3 m. Along the north wall stand a wardrobe, a desk and a dresser."
    )
    wide = {name: scene.by_name[name].size[1] for name in ("wardrobe-0", "desk-0", "dresser-0")}
    assert sum(wide.values()) < 3.0
    assert min(wide.values()) > 0.6


def test_things_below_others_that_reach_to_the_floor_are_no_error() -> None:
    """Height below a guitar that hangs was the square root of a negative number."""
    scene, _ = scene_from_sentence("A music room. Three guitars hang on the wall, and below them are two music stands.")
    assert clearance(scene.by_name["guitar-0"], (0.3, 0.3)) == 0.0


@pytest.mark.parametrize(
    "text",
    [
        "A study. The desk has nothing on it.",
        "A study. Keep the desk clear.",
        "A study with an empty desk by the window.",
        "A study. A desk stands in the corner; nothing stands on it.",
        "A study with a desk by the window with nothing on it.",
    ],
)
def test_nothing_is_put_on_what_is_to_stay_clear(text: str) -> None:
    scene, _ = scene_from_sentence(text)
    assert not [asset.name for asset in scene.assets if asset.category in ("monitor", "keyboard", "laptop")]
    (row,) = [row for row in read_words(scene).rows if row.kind == "refusal"]
    assert (row.understanding, row.things) == ("nothing on top", ("desk-0",))


def test_what_is_on_a_top_that_is_to_stay_clear_is_named() -> None:
    result = generate(scene_from_sentence("A study of 5 by 4 m. Keep the desk clear. A vase is on the sideboard.")[0])
    (row,) = [row for row in result.report.asked if row.kind == "refusal"]
    assert (row.verdict, row.value) == ("met", "nothing there")
    desk, vase = result.scene.by_name["desk-0"], result.scene.by_name["vase-0"]
    at = result.layout["desk-0"]
    poses = dict(result.layout.items()) | {"vase-0": Pose(at.x, at.y, desk.size[2] + vase.size[2] / 2, 0.0)}
    (row,) = [one for one in read_words(result.scene).judged(result.scene, Layout(poses)) if one.kind == "refusal"]
    assert (row.verdict, row.value) == ("unmet", "vase-0 there")


@pytest.mark.parametrize(
    ("text", "agent"),
    [
        ("A kitchen in which a Fetch can drive around.", "fetch"),
        ("We test a Stretch 3 in this living room.", "stretch3"),
        ("An office for navigation runs with a TurtleBot4.", "turtlebot4"),
    ],
)
def test_robots_by_the_names_of_their_makers(text: str, agent: str) -> None:
    scene, understood = scene_from_sentence(text)
    assert understood.agent == agent
    assert not [row for row in read_words(scene).rows if row.kind == "not understood"]


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("A salon with four vanity tables in a row, each a chair in front of a mirror.", {"chair": 4, "mirror": 4}),
        ("A study. A lamp, a monitor and a printer stand on the desk.", {"printer": 1, "desk": 1}),
        ("A bedroom. A bed and a night stand are in the corner.", {"night stand": 1}),
        ("A music room. A piano and a music stand are by the window.", {"music stand": 1}),
    ],
)
def test_what_is_counted_without_a_verb(text: str, counts: dict[str, int]) -> None:
    """Two chairs and one mirror were at the four tables, and a "printer stand" on the desk."""
    _, said = scene_from_sentence(text)
    assert {kind: said.wished.get(kind, 0) for kind in counts} == counts


def test_what_stands_opposite_another_is_not_on_what_was_said_before() -> None:
    """ "A desk with a chair, TV opposite the bed": the television stood on the desk."""
    told = rows("A hotel room with a bed, a desk with a chair, TV opposite the bed, a minibar and two armchairs.")
    assert [words for kind, words, _ in told if kind == "relation" and "tv" in words.lower()] == ["tv opposite bed"]


def test_small_things_stand_on_a_top_in_the_order_that_is_told() -> None:
    result = generate("A study. On the desk, from left to right: a lamp, a monitor and a vase.", dress="none")
    assert [row.verdict for row in result.report.asked if "left to right" in row.words] == ["met"]
    desk = result.layout["desk-0"]
    across = [desk.seen(result.layout[name].at)[1] for name in ("table_lamp-0", "monitor-0", "vase-0")]
    assert across in (sorted(across), sorted(across, reverse=True))


def test_as_you_enter_your_left_is_a_half_of_the_room() -> None:
    told = rows("A room. As you enter, a wardrobe is on your left and a fridge is on your right.")
    assert [meaning.split("(")[0] for kind, _, meaning in told if kind == "relation"] == ["zone", "zone"]
