"""`--knowledge FILE`: kinds of things, roles and room types of the user's own, for scenes, sentences and comparisons."""

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from robolayout.assets import CATALOGUE, category_of, find_category
from robolayout.planners import OfflinePlanner, scene_from_sentence
from robolayout.scene import Asset, Layout, Pose, Room, Scene, scene_from_dict, scene_to_dict
from robolayout.words import read_words
from running import Ran

MUSIC = """
label = "music"
order = 24
why = "The harp stands in the light."

[[role]]
name = "harp"
names = ["concert harp"]
stands = ["corner"]

[[thing]]
name = "concert harp"
words = ["harp", "pedal harp"]
like = "music stand"
size = [0.95, 0.55, 1.85]
use_sides = ["back"]

[[thing]]
name = "harp stool"
like = "stool"

[rooms."harp room"]
words = ["music room"]
size = [4.5, 4.0]
base = { "concert harp" = 1, "ceiling lamp" = 1 }
"""
ROOM = Room(((0, 0), (4.5, 0), (4.5, 4), (0, 4)), 2.5)


NAMED = """
["Прялка"]
like = "easel"
synonyms = ["Saxony-Wheel"]
"""


def test_own_words_are_known_however_they_are_written_and_to_the_judge(tmp_path: Path) -> None:
    (tmp_path / "crafts.toml").write_text(NAMED, "utf-8")
    words = "a living room with a saxony wheel by the window, a прялка, and an armchair facing the saxony wheel"
    scene, understood = scene_from_sentence(words, knowledge=[tmp_path / "crafts.toml"])
    assert (understood.wished, understood.ignored) == ({"Прялка": 2, "armchair": 1}, ())
    assert scene_from_dict(scene_to_dict(scene)).by_name["u43f_u440_u44f_u43b_u43a_u430-0"].synonyms == (
        "Saxony-Wheel",
    )
    placed = Layout({asset.name: Pose(1.0, 1.0, 1.0, 0.0) for asset in scene.assets})
    rows = {row.words: row.verdict for row in read_words(scene).judged(scene, placed)}
    assert (rows["a saxony wheel"], rows["a прялка"]) == ("met", "met")
    assert "not understood" not in rows.values(), rows


@pytest.fixture
def music(tmp_path: Path) -> Path:
    path = tmp_path / "music.toml"
    path.write_text(MUSIC, "utf-8")
    return path


def test_own_words_name_own_things_in_a_scene(music: Path) -> None:
    given = (
        Asset("x-0", "my old pedal harp", (0.9, 0.5, 1.8)),
        Asset("x-1", "harp", (0.9, 0.5, 1.8), use_sides=("left",)),
        Asset("x-2", "harp stool", (0.4, 0.4, 0.5)),
        Asset("x-3", "desk", (0.7, 1.4, 0.75)),
    )
    planner = OfflinePlanner([music])
    found = planner.recognised(Scene(ROOM, given))
    assert [asset.like for asset in found.assets] == ["music stand", "music stand", "stool", ""]
    assert [asset.use_sides for asset in found.assets] == [("back",), ("left",), None, None]
    assert category_of(found.assets[0]) is CATALOGUE["music stand"]
    assert planner.recognised(found) == found
    assert next(group for group in planner.group(found) if group.label == "music").items == ("x-0", "x-1")
    assert scene_from_dict(scene_to_dict(found)).assets == found.assets


def test_own_words_are_forgotten_without_the_file(music: Path) -> None:
    before = find_category("pedal harp")
    own = OfflinePlanner([music]).knowledge.things
    assert find_category("pedal harps", own=tuple(own.values())).name == "concert harp"
    assert find_category("a picture of a harp", own=tuple(own.values())).name == "picture"
    assert find_category("pedal harp") is before


def test_a_sentence_knows_own_rooms_and_things(music: Path) -> None:
    scene, found = scene_from_sentence("a music room with two harps and a settee", knowledge=[music])
    assert found.room_type == "harp room"
    assert found.wished == {"concert harp": 2, "sofa": 1}
    harp = scene.by_name["concert_harp-0"]
    assert harp.like == "music stand"
    assert harp.use_sides == ("back",)
    assert harp.size == pytest.approx((0.95, 0.55, 1.85), rel=0.061)


@pytest.mark.slow
def test_the_command_line_takes_files_of_ones_own(music: Path, tmp_path: Path, command: Callable[..., Ran]) -> None:
    out = tmp_path / "out"
    words = ("generate", "a harp room with a harp", "--no-pictures", "--out", out)
    ran = command(*words, "--knowledge", music)
    assert ran.code in (0, 1), ran.err
    assert "1 concert harp" in ran.err
    assert "solver.corner(concert_harp[0])" in (out / "program.py").read_text("utf-8")
    scene = out / "scene.json"
    shown = tmp_path / "both.svg"
    again = command("compare", scene, "--agents", "cat,child_6", "--knowledge", music, "--out", shown, "--quiet")
    assert again.code in (0, 1), again.err
    assert shown.stat().st_size > 1000
    unknown = command(*words)
    assert "'harp room' is no room type that is known: room was taken." in unknown.err


def test_a_scene_file_is_laid_out_with_own_knowledge(music: Path, tmp_path: Path, command: Callable[..., Ran]) -> None:
    scene = tmp_path / "scene.json"
    scene.write_text(json.dumps(scene_to_dict(Scene(ROOM, (Asset("x-0", "old pedal harp", (0.9, 0.5, 1.8)),)))))
    words = ("generate", scene, "--no-pictures", "--quiet", "--out", tmp_path / "out", "--knowledge", music)
    assert command(*words).code in (0, 1)
    assert "solver.corner(x[0])" in (tmp_path / "out" / "program.py").read_text("utf-8")
    refused = command(*words, "--program", tmp_path / "out" / "program.py")
    assert refused.code == 2
    assert "--knowledge is for the offline planner" in refused.err


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (None, "does not exist; check the path"),
        ("label = ", "not TOML"),
        ("", "its top lacks the key .label."),
        ('label = 3\nwhy = ""', "label must be a text in quotes, but is 3"),
        ('label = "x"\nroles = 3', "unknown key .roles.. Did you mean .role."),
        ('label = "x"\nrole = "harp"', "role must be a list of tables"),
        ('label = "x"\n[[role]]\nname = "a"\nstands = ["sky"]', "way of standing in the role .a.: .sky."),
        ('label = "x"\n[[role]]\nname = "a"\njoins = [{ slot = "in", of = [] }]', "unknown slot .* .in."),
        ('label = "x"\n[[role]]\nname = "a"\njoins = [{ slot = "on" }]', "joins lacks the key .of."),
        ('label = "x"\n[[role]]\nname = "a"\ncolour = "red"', "unknown key in the role .a.: .colour."),
        ('label = "x"\n[[role]]\nstands = ["wall"]', "the role .without a name. lacks the key .name."),
        ('label = "x"\n[[role]]\nname = "a"\nnames = "harp"', "names must be a list of texts, but is .harp."),
        (
            'label = "x"\n[[role]]\nname = "a"\nabove = ["sofaa"]',
            "unknown role in the role .a.: .sofaa.. Did you mean .sofa.",
        ),
        ('label = "x"\n[[role]]\nname = "a"\n[role.say]\nwall = ["fly({a})"]', "unknown statement .* .fly."),
        ('label = "x"\n[[role]]\nname = "a"\n[role.say]\nwall = ["corner({a"]', "write it as a call"),
        ('label = "x"\n[[role]]\nname = "a"\n[role.say]\nwall = ["corner({x})"]', "unknown placeholder .* .x."),
        ('label = "x"\n[[thing]]\nname = "harp"', "lacks the key .like."),
        ('label = "x"\n[[thing]]\nname = "harp"\nlike = "stol"', "like .stol.. Did you mean .stool."),
        ('label = "x"\n[[thing]]\nname = "harp"\nlike = "stool"\nsize = [1, 2]', "size must be three numbers"),
        (
            'label = "x"\n[[thing]]\nname = "harp"\nlike = "stool"\nsize = [1, 2, -3]',
            "depth, width and height are metres",
        ),
        ('label = "x"\n[[thing]]\nname = "harp"\nlike = "stool"\nplace = ["sky"]', "unknown place .* .sky."),
        ('label = "x"\n[rooms]\nhall = 3', "the room .hall. must be a table"),
        (
            'label = "x"\n[rooms.hall]\nsize = [4, 4]\nbase = { harp = 1 }',
            "unknown category in the room .hall.: .harp.",
        ),
        ('label = "x"\n[rooms.hall]\nsize = [4, 400]', "width and depth are metres"),
        ('label = "x"\n[rooms.hall]\nsize = [4, 4]\nagent = "elf"', "unknown body .* .elf."),
    ],
)
def test_a_broken_file_is_refused_in_words_with_exit_code_2(
    tmp_path: Path, command: Callable[..., Ran], text: str | None, words: str
) -> None:
    path = tmp_path / "own.toml"
    if text is not None:
        path.write_text(text, "utf-8")
    ran = command("generate", "a bedroom", "--knowledge", path, "--out", tmp_path / "out")
    assert ran.code == 2
    assert re.search(words, ran.err), ran.err
    assert "own.toml" in ran.err or "the role 'a'" in ran.err
    assert "Traceback" not in ran.err


def test_a_name_in_two_files_is_refused_and_both_are_named(tmp_path: Path, command: Callable[..., Ran]) -> None:
    ours, theirs = tmp_path / "ours.toml", tmp_path / "theirs.toml"
    for text, kind in (
        ('[harp]\nlike = "stool"', "thing 'harp'"),
        ('[role.harp]\nstands = ["wall"]', "role 'harp'"),
        ("[rooms.harp]\nsize = [4, 4]", "room type 'harp'"),
    ):
        for path in (ours, theirs):
            path.write_text(f'[group]\nlabel = "{path.stem}"\n{text}\n', "utf-8")
        ran = command("generate", "a bedroom", "--knowledge", ours, "--knowledge", theirs, "--out", tmp_path / "out")
        assert ran.code == 2
        assert f"the {kind} is in" in ran.err and "ours.toml too" in ran.err and "theirs.toml" in ran.err, ran.err


def test_a_record_of_ones_own_takes_the_place_of_the_built_in_one_of_its_name(tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    own.write_text('[group]\nlabel = "a"\n[armchair]\nlike = "sofa"\nsize = [1.1, 1.3, 0.9]\n', "utf-8")
    found = OfflinePlanner([own]).recognised(Scene(ROOM, (Asset("x-0", "armchair", (1.0, 1.0, 0.9)),)))
    assert found.assets[0].like == "sofa"
    assert OfflinePlanner().recognised(Scene(ROOM, (Asset("x-0", "armchair", (1.0, 1.0, 0.9)),))).assets[0].like == ""
