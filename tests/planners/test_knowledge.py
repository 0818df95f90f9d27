"""The knowledge files are consistent, and a user's own file is read with clear errors."""

from pathlib import Path

import pytest

from robolayout.assets import CATALOGUE, find_category
from robolayout.constraints import RELATIONS
from robolayout.planners import OfflinePlanner, PlanRequest, scene_from_sentence
from robolayout.planners._asked import join_as_asked
from robolayout.planners._knowledge import load_knowledge
from robolayout.planners._roles import cast_scene, fallback
from robolayout.scene import Asset, agent_names, scene_from_dict
from robolayout.words import grammar, read_rooms, read_words
from robolayout.words._function_words import AREAS

KNOWLEDGE = load_knowledge()


def test_every_word_has_one_role() -> None:
    owners: dict[str, str] = {}
    for role in KNOWLEDGE.roles.values():
        for name in role.names:
            assert name not in owners, f"{name!r} plays {owners.get(name)} and {role.name}"
            owners[name] = role.name
    assert {category.name: category.role for category in CATALOGUE.values() if category.role}.items() <= owners.items()
    assert len(owners) > 400


@pytest.mark.parametrize(
    ("text", "anchors"),
    [
        ("a kitchen with the fridge right of the stove", {"kitchen_counter-0": "", "stove-0": "kitchen_counter-0"}),
        ("a kitchen", {"kitchen_counter-0": "fridge-0", "stove-0": "kitchen_counter-0", "range_hood-0": ""}),
        ("a bookstore with only 2 armchairs", {"armchair-0": "armchair-1", "armchair-1": ""}),
        ("a shop with only a counter and 2 stools", {"stool-0": "checkout_counter-0", "stool-1": "checkout_counter-0"}),
    ],
)
def test_what_is_used_together_stands_together(text: str, anchors: dict[str, str]) -> None:
    scene = scene_from_sentence(text)[0]
    cast = join_as_asked(cast_scene(scene, KNOWLEDGE), read_words(scene).demands)
    assert {name: cast[name].anchor for name in anchors} == anchors


def test_what_a_record_says_is_not_said_again_by_its_role() -> None:
    for role in KNOWLEDGE.roles.values():
        again = [name for name in role.names if name not in CATALOGUE and role.name == _role_of(name)]
        assert again == [], f"{role.name}: records say so already"


def _role_of(word: str) -> str:
    """Return the role of the category that has a word as a synonym and is meant by it whatever its size."""
    found = [category for category in CATALOGUE.values() if word in category.synonyms]
    sure = len(found) == 1 and find_category(word, size=(9.0, 9.0, 9.0)) is find_category(word, size=(0.1, 0.1, 0.1))
    return found[0].role if sure else ""


def test_roles_name_only_known_roles() -> None:
    for role in KNOWLEDGE.roles.values():
        wanted = [name for join in role.joins for name in join.of if name != "*"]
        wanted += [*role.above, *role.face.roles]
        wanted += [key.split(" ", 1)[1] for key in role.prefer if key.startswith(("near ", "far "))]
        assert not [name for name in wanted if name not in KNOWLEDGE.roles], role.name


def test_statements_use_known_relations() -> None:
    for role in KNOWLEDGE.roles.values():
        lines = [line for lines in role.say.values() for line in lines]
        lines += [line for join in role.joins for line in (*join.say, *join.pair, *join.all)]
        for line in lines:
            assert line.removeprefix("else ").split("(")[0] in RELATIONS, line


def test_rooms_name_only_catalogue_things_and_known_bodies() -> None:
    rooms = read_rooms()
    things = [n for r in rooms.rooms.values() for part in (r.base, r.extras, r.person) for n in part]
    things += [n for area in AREAS.values() for n in area]
    things += [n for value in rooms.companions.values() for n in value]
    assert not [name for name in things if name not in CATALOGUE]
    assert not [name for name in rooms.companions if name not in CATALOGUE and name not in grammar().kinds]
    bodies = {*rooms.agents.values(), *(room.agent for room in rooms.rooms.values() if room.agent)}
    assert bodies <= set(agent_names())


def test_every_shape_has_a_fallback_role() -> None:
    found = set()
    for size in ((2.0, 1.5, 0.5), (0.5, 0.9, 1.9), (0.2, 0.2, 0.3), (1.5, 2.0, 0.01)):
        for flag in ("on_floor", "on_wall", "on_ceiling", "on_object"):
            flags = {name: name == flag for name in ("on_floor", "on_wall", "on_ceiling", "on_object")}
            found.add(fallback(Asset("x-0", "x", size, **flags)))
    on = {"thing on a wall", "thing on the ceiling", "thing on a top"}
    assert found == on | {"covering", "tall thing", "small thing", "big thing"}
    assert found <= set(KNOWLEDGE.roles)


def test_a_users_file_replaces_a_role(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(
        'label = "shrine"\norder = 5\nwhy = "It is holy."\n[[role]]\nname = "shrine"\nnames = ["zorb"]\nstands = ["corner"]\n'
    )
    planner = OfflinePlanner([path])
    box = {"boundingBox": {"x": 0.5, "y": 0.5, "z": 1.0}}
    scene = scene_from_dict(
        {
            "task_description": "",
            "layout_criteria": "",
            "boundary": {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], "wall_height": 2.6},
            "assets": {"zorb-0": {"category": "zorb", "description": "", "onFloor": True, "assetMetadata": box}},
        }
    )
    assert planner.group(scene)[0].label == "shrine"
    assert "solver.corner(zorb[0])" in planner.plan(PlanRequest(scene))


@pytest.mark.parametrize(("top", "handy"), [(0.30, True), (0.74, True), (1.25, False)])
def test_a_thing_goes_on_a_top_that_the_shortest_arm_gets_to(top: float, handy: bool) -> None:
    from robolayout.planners._roles import in_height
    from robolayout.scene import Asset, load_agent

    book = Asset("book-0", "book", (0.2, 0.15, 0.1), on_floor=False, on_object=True)
    assert in_height((load_agent("wheelchair"), load_agent("robot_vacuum")), book, top) is handy
    humanoid = load_agent("unitree_g1")
    assert in_height((humanoid,), book, top) is (top > 0.5)
