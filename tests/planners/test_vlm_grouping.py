from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from vlm_rooms import small_room

from robolayout.planners.model.grouping import LEFT_OVER, AnsweredGroup, Grouping, complaint, groups_of

SCENE = small_room()
NAMES = [asset.name for asset in SCENE.assets]


def answer(*groups: tuple[str, list[str]]) -> Grouping:
    return Grouping(groups=[AnsweredGroup(label=label, items=items) for label, items in groups])


def test_a_sound_answer_is_kept_in_its_order() -> None:
    given_answer = answer(("b", ["lamp-0", "bed-0"]), ("a", ["night_stand-0", "picture-0"]))
    assert complaint(SCENE, given_answer) is None
    groups = groups_of(SCENE, given_answer)
    assert [group.label for group in groups] == ["b", "a"]
    assert groups[0].items == ("lamp-0", "bed-0")


def test_names_of_the_program_are_understood() -> None:
    given_answer = answer(("all", ["bed[0]", " night_stand ", "lamp-0", "picture"]))
    assert complaint(SCENE, given_answer) is None
    assert groups_of(SCENE, given_answer)[0].items == ("bed-0", "night_stand-0", "lamp-0", "picture-0")


def test_the_complaint_names_what_is_missing_twice_and_unknown() -> None:
    text = complaint(SCENE, answer(("one", ["bed-0", "lamp-0"]), ("two", ["lamp-0", "throne-0"])))
    assert text == (
        "These things are in no group: night_stand-0, picture-0. These things are in more than one group: lamp-0. "
        "These names do not exist: throne-0. Answer again with every thing in exactly one group, under its own name."
    )


def test_leftovers_come_last() -> None:
    groups = groups_of(SCENE, answer((LEFT_OVER, ["bed-0", "bed-0", "ghost-3"]), ("empty", ["ghost-1"])))
    assert [group.label for group in groups] == [LEFT_OVER, f"{LEFT_OVER} 2"]
    assert groups[0].items == ("bed-0",)
    assert groups[1].items == ("night_stand-0", "lamp-0", "picture-0")


def test_a_thing_in_two_groups_stays_in_the_first() -> None:
    groups = groups_of(SCENE, answer(("x", ["bed-0"]), ("y", ["bed-0", "lamp-0"])))
    assert groups[0].items == ("bed-0",)
    assert groups[1].items == ("lamp-0",)


def test_words_become_one_short_line() -> None:
    group = AnsweredGroup(label="a\n# b" + "x" * 999, rationale="\t\n", items=NAMES, relations=["p\nq"] * 99)
    (kept,) = groups_of(SCENE, Grouping(groups=[group]))
    assert kept.label.startswith("a # b") and len(kept.label) == 300
    assert kept.rationale == "" and len(kept.relations) == 40 and kept.relations[0] == "p q"


@given(
    st.lists(st.tuples(st.text(max_size=5), st.lists(st.sampled_from([*NAMES, "ghost-1", "lamp[0]", ""]), max_size=8)))
)
def test_every_asset_is_in_exactly_one_group_whatever_the_answer(groups: list[tuple[str, list[str]]]) -> None:
    made = groups_of(SCENE, answer(*groups))
    assert sorted(name for group in made for name in group.items) == sorted(NAMES)
    assert len({group.label for group in made}) == len(made)
    assert all(group.items for group in made)
