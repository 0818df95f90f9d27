"""Scene files: what is read, what is mended with a warning, and the sentence for everything that is wrong."""

from __future__ import annotations

import json
import keyword
import math
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robolayout._errors import AgentError, InputError, SceneError, UnknownNameError
from robolayout.scene import (
    DEFAULT_AGENT,
    Scene,
    load_agent,
    load_scene,
    program_variable,
    scene_from_dict,
    scene_to_dict,
)

Data = dict[str, Any]

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.json"))


def box(x: float, y: float, z: float) -> Data:
    return {"boundingBox": {"x": x, "y": y, "z": z}}


def bedroom() -> Data:
    """Return a good scene file: 4 x 5 m, a door in wall 0, a window in wall 2."""
    return {
        "task_description": "a bedroom",
        "layout_criteria": "calm",
        "boundary": {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 5, 0], [0, 5, 0]], "wall_height": 2.6},
        "doors": [{"wall": 0, "offset": 2.9, "width": 0.9, "height": 2.05}],
        "windows": [{"wall": 2, "offset": 1.0, "width": 1.2, "height": 1.2, "sill": 0.9}],
        "agent": "wheelchair",
        "assets": {
            "bed-0": {"category": "bed", "description": "oak", "onFloor": True, "assetMetadata": box(2.0, 1.6, 0.5)},
            "lamp-0": {"category": "lamp", "onObject": True, "assetMetadata": box(0.2, 0.2, 0.4)},
        },
    }


def changed(*path: str | int, to: object) -> Data:
    """Return the bedroom with one value changed."""
    data: Any = deepcopy(bedroom())
    inner = data
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = to
    return data


def without(*path: str | int) -> Data:
    data: Any = changed(*path, to=None)
    inner = data
    for key in path[:-1]:
        inner = inner[key]
    del inner[path[-1]]
    return data


def corners(*points: tuple[float, float]) -> Data:
    data = changed("boundary", "floor_vertices", to=[[x, y, 0] for x, y in points])
    data["doors"] = data["windows"] = []
    return data


def test_everything_is_read() -> None:
    scene = scene_from_dict(bedroom(), name="bedroom")
    assert (scene.name, scene.task_description, scene.layout_criteria) == ("bedroom", "a bedroom", "calm")
    assert scene.room.vertices == ((0, 0), (4, 0), (4, 5), (0, 5))
    assert scene.room.doors[0].center == pytest.approx(3.35)
    assert scene.room.windows[0].sill == 0.9
    assert scene.agents == (load_agent("wheelchair"),)
    bed, lamp = scene.assets
    assert (bed.name, bed.category, bed.description, bed.size) == ("bed-0", "bed", "oak", (2.0, 1.6, 0.5))
    assert (bed.on_floor, bed.on_object, lamp.on_floor, lamp.on_object) == (True, False, False, True)
    assert scene.warnings == ()


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_read_without_a_warning_and_back(path: Path) -> None:
    scene = load_scene(path)
    assert scene.warnings == ()
    assert scene_from_dict(json.loads(json.dumps(scene_to_dict(scene))), name=path.stem) == scene


def test_examples_exist() -> None:
    assert len(EXAMPLES) >= 4


def test_optional_keys() -> None:
    data = bedroom()
    for key in ("doors", "windows", "agent", "task_description", "layout_criteria"):
        del data[key]
    scene = scene_from_dict(data)
    assert scene.agents == (DEFAULT_AGENT,)
    assert scene.room.doors == scene.room.windows == ()
    assert "agent" not in scene_to_dict(scene)


def test_further_keys_of_an_asset_are_kept() -> None:
    data = bedroom()
    data["assets"]["bed-0"] |= {"useSides": ["left", "right"], "frontView": 2, "colour": {"frame": "oak"}}
    scene = scene_from_dict(data)
    assert scene.assets[0].use_sides == ("left", "right")
    assert scene.assets[0].metadata == {"frontView": 2, "colour": {"frame": "oak"}}
    entry: Any = scene_to_dict(scene)["assets"]
    assert entry["bed-0"]["colour"] == {"frame": "oak"}
    assert entry["bed-0"]["useSides"] == ["left", "right"]


# What is mended, with a warning.


def reversed_bedroom() -> Data:
    """Return the same room with its corners clockwise from another start; openings at the same physical places."""
    data = bedroom()
    data["boundary"]["floor_vertices"] = [[4, 0, 0], [0, 0, 0], [0, 5, 0], [4, 5, 0]]
    data["doors"] = [{"wall": 0, "offset": 0.2, "width": 0.9, "height": 2.05}]
    data["windows"] = [{"wall": 2, "offset": 1.8, "width": 1.2, "height": 1.2, "sill": 0.9}]
    return data


def places(scene: Scene) -> list[tuple[float, ...]]:
    """Return the ends of every opening in the world, each ordered."""
    ends: list[tuple[float, ...]] = []
    for opening in (*scene.room.doors, *scene.room.windows):
        wall = scene.room.walls[opening.wall]
        a, b = wall.point(opening.offset), wall.point(opening.offset + opening.width)
        ends.append(tuple(round(number, 9) + 0.0 for number in (*min(a, b), *max(a, b))))
    return ends


def test_a_clockwise_room_is_turned_around_and_its_door_stays() -> None:
    right, wrong = scene_from_dict(bedroom()), scene_from_dict(reversed_bedroom())
    assert wrong.room.area == right.room.area == 20
    assert places(wrong) == places(right)
    (warning,) = wrong.warnings
    assert "clockwise" in warning
    assert "turned around" in warning


@given(
    st.integers(3, 12),
    st.floats(0, 6),
    st.lists(st.tuples(st.integers(0, 11), st.floats(0, 0.6)), max_size=1),
    st.data(),
)
def test_turning_any_room_around_moves_no_opening(
    count: int, phase: float, openings: list[tuple[int, float]], data: st.DataObject
) -> None:
    radii = data.draw(st.lists(st.floats(3.0, 9.0), min_size=count, max_size=count))
    ring = [
        (r * math.cos(phase + 2 * math.pi * i / count), r * math.sin(phase + 2 * math.pi * i / count))
        for i, r in enumerate(radii)
    ]
    content = corners(*ring[::-1])
    content["doors"] = [{"wall": w % count, "offset": o, "width": 0.3, "height": 2.0} for w, o in openings]
    scene = scene_from_dict(content)
    assert scene.room.area > 0
    for (wall, offset), door in zip(openings, scene.room.doors, strict=True):
        old_start, old_end = ring[::-1][wall % count], ring[::-1][(wall + 1) % count]
        share = (offset + 0.15) / math.dist(old_start, old_end)
        middle = tuple(a + share * (b - a) for a, b in zip(old_start, old_end, strict=True))
        assert math.dist(scene.room.walls[door.wall].point(door.center), middle) < 1e-9


def test_a_repeated_last_corner_is_dropped() -> None:
    data = bedroom()
    data["boundary"]["floor_vertices"].append([0, 0, 0])
    assert scene_from_dict(data) == scene_from_dict(bedroom())


def test_the_unit_of_a_vast_room_is_asked_about() -> None:
    assert scene_from_dict(corners((0, 0), (420, 0), (420, 310), (0, 310))).warnings[0] == (
        "the room is 420 x 310 m: was it drawn in centimetres? Lengths are in metres; divide them by 100 for one of "
        "4.2 x 3.1 m, or leave them if it is that large."
    )
    assert scene_from_dict(corners((0, 0), (90, 0), (90, 40), (0, 40))).warnings == ()


@pytest.mark.parametrize(
    ("key", "field", "value", "left"), [("doors", "height", 2.7, "2.6"), ("windows", "sill", 1.5, "1.1")]
)
def test_a_door_or_window_higher_than_its_wall_ends_with_it(key: str, field: str, value: float, left: str) -> None:
    scene = scene_from_dict(changed(key, 0, field, to=value))
    (opening,) = getattr(scene.room, key)
    assert opening.sill + opening.height == pytest.approx(2.6)
    above = f"{key}[0] ends 2.700 m above the floor; the walls are 2.6 m high"
    assert scene.warnings == (f"{above}, so it was made {left} m high.",)


def test_no_placement_flag_means_floor() -> None:
    scene = scene_from_dict(without("assets", "lamp-0", "onObject"))
    assert scene.by_name["lamp-0"].on_floor
    assert scene.warnings == ("asset 'lamp-0' says nowhere where it may stand; it goes on the floor (onFloor).",)


@pytest.mark.parametrize(
    ("name", "expression"),
    [
        ("night stand-0", "night_stand[0]"),
        ("Night-Stand-0", "night_stand[0]"),
        ("bed", "bed[0]"),
        ("bed-000", "bed[0]"),
        ("2 seater-0", "asset_2_seater[0]"),
        ("class-0", "asset_class[0]"),
        ("map-0", "asset_map[0]"),
        ("None-0", "none[0]"),
        ("walls-0", "asset_walls[0]"),
        ("Range-0", "asset_range[0]"),
        ("Bücherregal-0", "bucherregal[0]"),
        ("桌子-0", "u684c_u5b50[0]"),
        ("desk'; import os #-0", "desk_import_os[0]"),
        ("-0", "asset[0]"),
        ("_rl_log-0", "rl_log[0]"),
    ],
)
def test_names_stay_and_get_a_program_variable(name: str, expression: str) -> None:
    data = bedroom()
    data["assets"] = {name: data["assets"]["bed-0"]}
    scene = scene_from_dict(data)
    assert [asset.name for asset in scene.assets] == [name]
    assert scene.expressions == {name: expression}
    assert scene.assets[0].variable.isidentifier()
    assert scene.warnings == ()


def test_names_that_come_to_one_variable_share_its_list_whatever_their_order() -> None:
    names = ["bed", "bed-1", "bed-0", "BED-0", "Bed-0"]
    for order in (names, names[::-1]):
        data = bedroom()
        data["assets"] = {name: data["assets"]["bed-0"] for name in order}
        scene = scene_from_dict(data)
        assert scene.expressions["bed-0"] == "bed[0]"
        assert scene.expressions["bed"] == "bed[1]"
        assert scene.expressions["bed-1"] == "bed[2]"
        assert len(set(scene.expressions.values())) == 5
        assert "bed stands for several names: in a program, bed[1] is bed." in scene.warnings


@given(st.text(st.characters(exclude_categories=("Cs", "Cc", "Zl", "Zp")), min_size=1, max_size=200))
def test_any_text_on_one_line_is_a_name(name: str) -> None:
    variable = program_variable(name)
    assert variable.isidentifier() and variable.isascii() and not keyword.iskeyword(variable)
    assert not variable.startswith("_")
    if name.strip() and not set(name) & {"\ufffe", "\uffff"}:
        data = bedroom()
        data["assets"] = {name: data["assets"]["bed-0"]}
        scene = scene_from_dict(data)
        assert [asset.name for asset in scene.assets] == [name]
        assert scene_from_dict(json.loads(json.dumps(scene_to_dict(scene)))) == scene


def test_capital_letters_of_a_variable_stay() -> None:
    data = bedroom()
    data["assets"] = {"chair_A-0": data["assets"]["bed-0"]}
    scene = scene_from_dict(data)
    assert (scene.assets[0].name, scene.warnings) == ("chair_A-0", ())


def test_a_gap_in_the_numbers_is_told() -> None:
    data = bedroom()
    data["assets"]["bed-2"] = data["assets"]["bed-0"]
    assert scene_from_dict(data).warnings == ("there is no bed-1: in a program, bed[1] is bed-2.",)


def test_misspelt_keys_are_told() -> None:
    data = changed("door", to=[])
    data["assets"]["bed-0"]["onfloor"] = True
    data["doors"][0]["swnig"] = "in"
    warnings = scene_from_dict(data).warnings
    assert warnings == (
        "the scene: 'door' is not known; did you mean 'doors'?",
        "doors[0]: 'swnig' is not known; did you mean 'swing'?",
        "asset 'bed-0': 'onfloor' is not known; did you mean 'onFloor'?",
    )


def test_a_category_is_one_line_and_may_come_from_the_name() -> None:
    data = changed("assets", "bed-0", "category", to="double\nbed\0 # x")
    assert scene_from_dict(data).assets[0].category == "double bed # x"
    data["assets"]["night_stand-0"] = {"onFloor": True, "assetMetadata": box(0.4, 0.4, 0.5)}
    assert scene_from_dict(data).by_name["night_stand-0"].category == "night stand"


def test_a_description_with_quotes_and_code_is_data() -> None:
    text = 'a "bed"\n"""; __import__("os").system("x")  # \\'
    scene = scene_from_dict(changed("assets", "bed-0", "description", to=text))
    assert scene.assets[0].description == text
    assert scene_from_dict(json.loads(json.dumps(scene_to_dict(scene)))) == scene


# What is wrong, each with its sentence.

WRONG: list[tuple[Data | list[int], str]] = [
    ([1], "the scene must be an object with named values, but is [1]."),
    (without("boundary"), 'the scene has no "boundary"; add it.'),
    (without("assets"), 'the scene has no "assets"; add it.'),
    (without("boundary", "wall_height"), 'boundary has no "wall_height"; add it.'),
    (without("boundary", "floor_vertices"), 'boundary has no "floor_vertices"; add it.'),
    (changed("boundary", "wall_height", to=0), "boundary.wall_height must be above 0, but is 0."),
    (changed("boundary", "wall_height", to="2"), "boundary.wall_height must be a finite number, but is '2'."),
    (
        changed("boundary", "floor_vertices", 1, to=[1]),
        "boundary.floor_vertices[1] must have 2 or 3 numbers, but has 1.",
    ),
    (
        changed("boundary", "floor_vertices", 1, 0, to=math.nan),
        "boundary.floor_vertices[1][0] must be a finite number, but is nan.",
    ),
    (
        changed("boundary", "floor_vertices", 1, 2, to=1),
        "boundary.floor_vertices[1] has height 1; the floor lies at z = 0.",
    ),
    (
        changed("boundary", "floor_vertices", 1, 0, to=4000),
        "boundary.floor_vertices[1] lies more than 1000 m from the origin; coordinates are in metres.",
    ),
    (
        corners((0, 0), (620, 0), (620, 410), (0, 410)),
        "the room is 620 x 410 m: was it drawn in centimetres? Lengths are in metres; divide them by 100 for one of "
        "6.2 x 4.1 m. At most 500 m are read.",
    ),
    (corners((0, 0), (4, 0)), "boundary.floor_vertices has 2 different corners; a room needs at least 3."),
    (corners((0, 0), (4, 0), (0, 0)), "boundary.floor_vertices has 2 different corners; a room needs at least 3."),
    (corners((0, 0), (2, 0), (4, 0)), "the room has no area: all its corners lie on one line."),
    (
        corners((0, 0), (4, 0), (4, 0), (0, 4)),
        "boundary.floor_vertices 1 and 2 are the same point; drop one.",
    ),
    (
        corners((0, 0), (4, 4), (4, 0), (0, 4)),
        "the room's walls 0 and 2 cross or touch; list the corners in order around the room.",
    ),
    (
        corners((0, 0), (4, 0), (4, 4), (2, 0), (0, 4)),
        "the room's walls 0 and 2 cross or touch; list the corners in order around the room.",
    ),
    (
        corners((0, 0), (4, 0), (4, 4), (4, 2), (0, 4)),
        "the room's walls 1 and 2 cross or touch; list the corners in order around the room.",
    ),
    (
        corners((0, 0), (0.05, 0), (0.05, 0.05), (0, 0.05)),
        "the room's area is 0.0025 m2; at least 0.01 m2 are needed (in metres).",
    ),
    (changed("doors", 0, "wall", to=4), "doors[0].wall must be a whole number from 0 to 3, but is 4."),
    (changed("doors", 0, "wall", to=-1), "doors[0].wall must be a whole number from 0 to 3, but is -1."),
    (changed("doors", 0, "wall", to=True), "doors[0].wall must be a whole number from 0 to 3, but is True."),
    (without("doors", 0, "width"), 'doors[0] has no "width"; add it.'),
    (changed("doors", 0, "offset", to=3.2), "doors[0] ends at 4.100 m, past the end of wall 0, which is 4.000 m long."),
    (changed("doors", 0, "offset", to=-0.1), "doors[0].offset must be at least -1e-06, but is -0.1."),
    (changed("doors", 0, "width", to=0), "doors[0].width must be above 0, but is 0."),
    (
        changed("windows", 0, "sill", to=2.55),
        "windows[0] ends 3.750 m above the floor; the walls are 2.6 m high: lower its sill, which is at 2.55 m, "
        "or raise boundary.wall_height.",
    ),
    (
        changed("windows", 0, to={"wall": 0, "offset": 2.0, "width": 1.0, "height": 1.2, "sill": 0.9}),
        "doors[0] and windows[0] overlap by 0.100 m on wall 0; move one of them.",
    ),
    (changed("doors", to={}), "doors must be a list, but is {}."),
    (changed("assets", to={}), "the scene has 0 assets; from 1 to 2000 are allowed."),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(math.nan, 1, 1)),
        "asset 'bed-0': depth (boundingBox.x) must be a finite number, but is nan.",
    ),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(1, math.inf, 1)),
        "asset 'bed-0': width (boundingBox.y) must be a finite number, but is inf.",
    ),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(1, 10**400, 1)),
        "asset 'bed-0': width (boundingBox.y) must be a finite number",
    ),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(1, 1, -0.5)),
        "asset 'bed-0': height (boundingBox.z) must be above 0, but is -0.5.",
    ),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(0, 1, 1)),
        "asset 'bed-0': depth (boundingBox.x) must be above 0, but is 0.",
    ),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(True, 1, 1)),
        "asset 'bed-0': depth (boundingBox.x) must be a finite number, but is True.",
    ),
    (
        without("assets", "bed-0", "assetMetadata", "boundingBox", "y"),
        "asset 'bed-0': assetMetadata.boundingBox has no \"y\"; add it.",
    ),
    (
        without("assets", "bed-0", "assetMetadata"),
        "asset 'bed-0' has no assetMetadata: give its boundingBox (x: depth, y: width, z: height, in metres; `robolayout "
        "assets` lists usual ones), or name the catalogue (catalogue, from) or the folder (--asset-dir) in which to look it up.",
    ),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(4.1, 5.2, 1)),
        "asset 'bed-0' (4.10 x 5.20 m) is larger than the room: it fits at no heading; make it smaller or the room larger "
        "(sizes are in metres).",
    ),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(1, 1, 2.7)),
        "asset 'bed-0' is 2.70 m high, but the walls are 2.60 m high; make it lower or the walls higher (sizes are in "
        "metres).",
    ),
    (changed("assets", "bed-0", "onFloor", to="yes"), "asset 'bed-0': onFloor must be true or false, but is 'yes'."),
    (
        changed("assets", "bed-0", "category", to=" "),
        "asset 'bed-0': category is empty; say in a word or two what it is.",
    ),
    (changed("assets", "bed-0", "category", to="x" * 201), "asset 'bed-0': category has 201 characters; at most 200"),
    (
        changed("assets", "bed-0", "useSides", to=["top"]),
        "asset 'bed-0': useSides names 'top'; allowed are front, back, left, right.",
    ),
    (changed("assets", "bed-0", to=3), "asset 'bed-0' must be an object with named values, but is 3."),
    (
        changed("assets", "bed\n-0", to=bedroom()["assets"]["bed-0"]),
        "the asset name 'bed\\n-0' has the control character U+000A; any other text on one line is allowed.",
    ),
    (changed("assets", " ", to=bedroom()["assets"]["bed-0"]), "the asset name ' ' is empty; call the asset something."),
    (
        changed("assets", "bed\ud800", to=bedroom()["assets"]["bed-0"]),
        "the asset name 'bed\\ud800' contains characters that are no text (a lone surrogate at 3).",
    ),
    (
        changed("assets", "bed-0", "note", to={"a": [1, math.nan]}),
        "asset 'bed-0': note has nan where only finite numbers are allowed at a[1].",
    ),
    (
        changed("assets", "bed-0", "note", to={"\ud800": 1}),
        "asset 'bed-0': note has a name with characters that are no text (a lone surrogate at 0).",
    ),
    (
        changed("boundary", "wall_height", to=250),
        "boundary.wall_height must be at most 100, but is 250. Lengths are in metres: is it in centimetres? Then write 2.5.",
    ),
    (changed("assets", "x" * 201, to=bedroom()["assets"]["bed-0"]), "has 201 characters; at most 200 are allowed."),
    (
        changed("assets", "bed-0", "assetMetadata", to=box(1, 10**9999, 1)),
        "asset 'bed-0': width (boundingBox.y) must be a finite number, but is a whole number of 33216 bits.",
    ),
    (
        changed("assets", "bed-0", "description", to="\ud800"),
        "asset 'bed-0': description contains characters that are no text (a lone surrogate at 0).",
    ),
    (changed("task_description", to=5), "task_description must be a text, but is 5."),
    (changed("agent", to=[]), "agent is an empty list; name at least one agent or leave it out."),
]


@pytest.mark.parametrize(("data", "message"), WRONG, ids=[message[:50] for _, message in WRONG])
def test_wrong_scenes(data: object, message: str) -> None:
    with pytest.raises(SceneError) as caught:
        scene_from_dict(data)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


# Agents of a scene.


def test_agents_of_a_scene() -> None:
    scene = scene_from_dict(changed("agent", to=["cat", {"name": "cart", "radius": 0.3, "height": 1, "reach": 0.5}]))
    assert [agent.name for agent in scene.agents] == ["cat", "cart"]
    assert scene.agents[1].reach_distance == 0.5
    assert scene_from_dict(scene_to_dict(scene)) == scene


def test_wrong_agents_of_a_scene() -> None:
    with pytest.raises(
        UnknownNameError, match=r"unknown agent 'weelchair'. Did you mean 'wheelchair'\? Known: adult, "
    ):
        scene_from_dict(changed("agent", to="weelchair"))
    with pytest.raises(AgentError, match="two agents are called 'cat'; give each its own name"):
        scene_from_dict(changed("agent", to=["cat", "cat"]))
    with pytest.raises(
        AgentError,
        match=r"agent 'mast' is 3.00 m high, but the room only 2.60 m; choose a lower agent or raise wall_height.",
    ):
        scene_from_dict(changed("agent", to={"name": "mast", "radius": 0.2, "height": 3}))
    with pytest.raises(AgentError, match=r"agent 'forklift' is 2\.20 m high, but the room only 2.00 m"):
        room = changed("boundary", "wall_height", to=2.0)
        room["doors"] = []
        room["windows"] = []
        scene_from_dict(room).with_agents(load_agent("forklift"))


def test_a_scene_file_cannot_name_files_as_agents(tmp_path: Path) -> None:
    profile = tmp_path / "mine.toml"
    profile.write_text("radius = 0.2\nheight = 1.0\n")
    with pytest.raises(UnknownNameError):
        scene_from_dict(changed("agent", to=str(profile)))


# Does it fit?

L_ROOM = ((0, 0), (4, 0), (4, 1.5), (1.5, 1.5), (1.5, 4), (0, 4))


@pytest.mark.parametrize(
    ("ring", "size", "fits"),
    [
        (((0, 0), (4, 0), (4, 5), (0, 5)), (4.0, 5.0), True),
        (((0, 0), (4, 0), (4, 5), (0, 5)), (5.0, 4.0), True),
        (((0, 0), (4, 0), (4, 5), (0, 5)), (5.03, 4.0), False),
        (((0, 0), (4, 0), (4, 5), (0, 5)), (6.2, 0.1), True),  # only along the diagonal
        (((0, 0), (4, 0), (4, 5), (0, 5)), (6.5, 0.1), False),
        (((0, 0), (4, 0), (4, 5), (0, 5)), (6.0, 0.5), False),
        (L_ROOM, (4.0, 1.5), True),
        (L_ROOM, (1.5, 4.0), True),
        (L_ROOM, (2.0, 2.0), False),
        (L_ROOM, (1.5, 1.5), True),
        (((2, 0), (4, 2), (2, 4), (0, 2)), (2.8, 2.8), True),  # a square room stood on its corner
        (((2, 0), (4, 2), (2, 4), (0, 2)), (3.0, 2.8), False),
        (((0, 0), (4, 0), (0, 4)), (2.0, 2.0), True),
        (((0, 0), (4, 0), (0, 4)), (2.2, 2.2), False),
    ],
)
def test_an_asset_must_fit_at_some_heading(
    ring: tuple[tuple[float, float], ...], size: tuple[float, float], fits: bool
) -> None:
    data = corners(*ring)
    data["assets"]["bed-0"]["assetMetadata"] = box(*size, 0.5)
    data["agent"] = "cat"
    if fits:
        assert scene_from_dict(data).by_name["bed-0"].size[:2] == size
    else:
        with pytest.raises(SceneError, match=r"asset 'bed-0' .* is larger than the room"):
            scene_from_dict(data)


@given(st.floats(0.05, 1.5), st.floats(0.1, 1.0))
def test_what_fits_at_any_odd_heading_is_not_refused(heading: float, width: float) -> None:
    c, s = math.cos(heading), math.sin(heading)
    length = min((4 - width * s) / c, (5 - width * c) / s)
    data = changed("assets", "bed-0", "assetMetadata", to=box(length, width, 0.5))
    assert scene_from_dict(data).by_name["bed-0"].size[0] == length


# Files.


def test_a_file_is_read_by_its_name(tmp_path: Path) -> None:
    path = tmp_path / "my room.json"
    path.write_bytes(b"\xef\xbb\xbf" + json.dumps(bedroom()).encode())
    assert load_scene(str(path)) == scene_from_dict(bedroom(), name="my room")


def large(path: Path) -> None:
    path.write_bytes(b" " * 20_000_001)


@pytest.mark.parametrize(
    ("write", "message"),
    [
        (lambda path: path.write_text('{"boundary": \n nul}'), "is not JSON: Expecting value at line 2, column 2."),
        (lambda path: path.write_text(""), "is not JSON: Expecting value at line 1, column 1."),
        (lambda path: path.write_bytes(b'{"a": "\xff"}'), "is not UTF-8 text (byte 7)."),
        (large, "is larger than 20 MB."),
        (lambda path: path.write_text("[" * 200_000), "is nested too deeply."),
        (
            lambda path: path.write_text("[" + "9" * 5000 + "]"),
            "has a number of 5000 characters (999999999999...); at most 100 are read.",
        ),
        (lambda path: path.mkdir(), "is a folder; name the file in it."),
        (lambda path: None, "does not exist; check the path."),
    ],
)
def test_unreadable_files(tmp_path: Path, write: Callable[[Path], object], message: str) -> None:
    path = tmp_path / "scene.json"
    write(path)
    with pytest.raises(SceneError) as caught:
        load_scene(path)
    assert str(caught.value).startswith(f"scene file {path} ")
    assert message in str(caught.value)


def test_duplicate_names_in_a_file(tmp_path: Path) -> None:
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(bedroom()).replace('"lamp-0"', '"bed-0"'))
    with pytest.raises(SceneError, match=r"the name 'bed-0' stands twice in one object; give each its own name\."):
        load_scene(path)


def test_nan_in_a_file_names_the_asset(tmp_path: Path) -> None:
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(changed("assets", "bed-0", "assetMetadata", to=box(math.nan, 1, 1))))
    with pytest.raises(
        SceneError,
        match=r"has nan where only finite .* at assets\.bed-0\.assetMetadata\.boundingBox\.x\.",
    ):
        load_scene(path)


# Meshes.


@pytest.mark.parametrize(
    "hostile",
    ["../secret.glb", "/etc/secret.glb", "a/../../secret.glb", "link.glb", "bed.glb/../../secret.glb"],
)
def test_a_mesh_outside_the_folder_is_refused(tmp_path: Path, hostile: str) -> None:
    folder = tmp_path / "scenes"
    folder.mkdir()
    (tmp_path / "secret.glb").write_bytes(b"glTF")
    (folder / "link.glb").symlink_to(tmp_path / "secret.glb")
    with pytest.raises(SceneError) as caught:
        scene_from_dict(changed("assets", "bed-0", "path", to=hostile), base=folder)
    assert "lies outside the scene file's folder and the asset folder" in str(caught.value)


def test_a_folder_names_the_file_that_was_meant(tmp_path: Path) -> None:
    (tmp_path / "layout.json").write_text("{}")
    with pytest.raises(SceneError, match=r"scene file .* is a folder; name the file in it, such as .*layout\.json\."):
        load_scene(tmp_path)
    (tmp_path / "scene.json").write_text("{}")
    with pytest.raises(SceneError, match=r"is a folder; name the file in it, such as .*scene\.json\."):
        load_scene(tmp_path)


def test_meshes(tmp_path: Path) -> None:
    scenes, meshes = tmp_path / "scenes", tmp_path / "meshes"
    for folder in (scenes, meshes):
        folder.mkdir()
    (scenes / "bed.glb").write_bytes(b"glTF")
    (meshes / "other.glb").write_bytes(b"glTF")
    data = changed("assets", "bed-0", "path", to="bed.glb")
    data["assets"]["lamp-0"]["path"] = "other.glb"
    scene = scene_from_dict(data, base=scenes, asset_dir=meshes)
    assert [asset.path for asset in scene.assets] == [scenes / "bed.glb", meshes / "other.glb"]
    written: Any = scene_to_dict(scene, base=scenes)
    assert written["assets"]["bed-0"]["path"] == "bed.glb"
    assert scene_from_dict(written, base=scenes, asset_dir=meshes) == scene
    assert scene_from_dict(scene_to_dict(scene), base=scenes, asset_dir=meshes) == scene


@pytest.mark.parametrize(
    ("path", "message"),
    [
        (
            "bed.blend",
            "asset 'bed-0': path 'bed.blend' is no mesh file (.glb, .obj, .ply, .stl); convert the mesh or leave path out.",
        ),
        ("none.glb", "asset 'bed-0': path 'none.glb' does not exist; correct it or leave it out for a built-in shape."),
        (7, "asset 'bed-0': path must be a text, but is 7."),
        ("x\0.glb", "is no mesh file"),
        ("x" * 300 + ".glb", "does not exist; correct it"),
    ],
)
def test_unusable_meshes(tmp_path: Path, path: object, message: str) -> None:
    with pytest.raises(SceneError) as caught:
        scene_from_dict(changed("assets", "bed-0", "path", to=path), base=tmp_path)
    assert message in str(caught.value)


@pytest.mark.parametrize("suffix", ["glb", "OBJ", "ply", "stl"])
def test_every_mesh_format_that_is_imported_may_stand_in_a_scene(tmp_path: Path, suffix: str) -> None:
    (tmp_path / f"bed.{suffix}").write_bytes(b"mesh")
    scene = scene_from_dict(changed("assets", "bed-0", "path", to=f"bed.{suffix}"), base=tmp_path)
    assert scene.by_name["bed-0"].path == tmp_path / f"bed.{suffix}"


def test_a_mesh_of_200_megabytes_is_refused_when_the_scene_is_read(tmp_path: Path) -> None:
    with (tmp_path / "bed.glb").open("wb") as file:
        file.truncate(200_000_000)
    with pytest.raises(SceneError, match=r"asset 'bed-0': path 'bed\.glb' has 200 MB; at most 100 MB are read\. Simpl"):
        scene_from_dict(changed("assets", "bed-0", "path", to="bed.glb"), base=tmp_path)


# Whatever comes in, what comes out is a scene or an InputError.

junk = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=6,
)


def paths(data: object, prefix: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """Return the path of every value inside a JSON value."""
    items: list[tuple[str | int, object]] = []
    if isinstance(data, dict):
        items = list(data.items())
    elif isinstance(data, list):
        items = list(enumerate(data))
    return [path for key, value in items for path in [(*prefix, key), *paths(value, (*prefix, key))]]


@given(st.sampled_from(paths(bedroom())), junk)
def test_any_value_anywhere_gives_a_scene_or_a_sentence(path: tuple[str | int, ...], value: object) -> None:
    try:
        scene = scene_from_dict(changed(*path, to=value))
    except InputError as error:
        assert str(error)
    else:
        assert scene_from_dict(scene_to_dict(scene)) == scene


def test_a_file_name_with_a_slip_leads_to_the_file_that_is_there(tmp_path: Path) -> None:
    (tmp_path / "bedroom.json").write_text("{}")
    with pytest.raises(
        SceneError, match=r"bedrom\.json does not exist; did you mean '.*bedroom\.json'\? Or check the path\."
    ):
        load_scene(tmp_path / "bedrom.json")
