"""What the program language can say, and what it answers to mistakes."""

import math
import re
from dataclasses import replace

import pytest
from furnished_room import furnished
from hypothesis import given, settings
from hypothesis import strategies as st

from robolayout._errors import ProgramError
from robolayout.constraints import RELATIONS, AssetRef, PointRef, WallRef
from robolayout.program import Guess, Statement, read_program
from robolayout.program._source import strip_fences
from robolayout.scene import Asset, Opening, Scene

RICH = '''\
import math
from math import sqrt

"""Bedroom."""
bed[0].position = [2, 1, 0.25]
bed[0].rotation = [90]
night_stand.placements[1].rotation = [0, 0, radians(90)]
night_stand.placements[0].position = [bed[0].position[0] - 1, 1, .25]
night_stand[0].position[0] += 0.1
solver.against_wall(bed[0], walls[0])
for i, n in enumerate(night_stand):
    solver.next_to(n, bed[0],
                   side="left" if i else "right")
    print(f"placed {n}", i)

def seat(c, t=table):
    """Keep a chair near."""
    solver.distance_constraint(c, t, 0.3, max_distance=1 / 2 + sqrt(4))

[seat(c) for c in chair]
near = min([abs(-3), max(1, 2)], key=lambda v: v)
while near > 2:
    near -= 1
pairs = list(zip(chair[:2], chair[2:]))
for (a, b) in pairs: solver.align_with(a, b, angle=round(90.4))
solver.around(chair + [night_stand[0]], table[0], gap=sum([0.1, 0.1]))
solver.distance_constraint(rug, AssetInstance(position=[2, 2, 0]), 0, 0.1, weight=10)
solver.distance_constraint(rug[0], (2, 2), None, 0.1)
solver.zone(rug[0], [(0, 0), (2, 0), (2, 2), (0, 2)])
solver.centered_on(rug[0], room)
solver.symmetric_pair(*night_stand, ref=bed[0])
s = solver
s.point_towards(chair[-1], walls[len(walls) - 1])
'''


def relation(text: str, scene: Scene) -> Statement:
    """Return the only statement of a program."""
    (statement,) = read_program(text, scene).statements
    return statement


def test_everything_the_language_offers(scene):
    program = read_program(RICH, scene)
    said = [(s.line, s.relation.sentence()) for s in program.statements]
    assert said == [
        (10, "against_wall(bed-0, walls[0])"),
        (12, "next_to(night_stand-0, bed-0, right)"),
        (12, "next_to(night_stand-1, bed-0, left)"),
        *[(18, f"distance_constraint(chair-{i}, table-0, min_distance=0.3, max_distance=2.5)") for i in range(4)],
        (25, "align_with(chair-0, chair-2, angle=90)"),
        (25, "align_with(chair-1, chair-3, angle=90)"),
        (26, "around([chair-0, chair-1, chair-2, chair-3, night_stand-0], table-0, gap=0.2)"),
        (27, "distance_constraint(rug-0, (2, 2, 0), min_distance=0, max_distance=0.1, weight=10)"),
        (28, "distance_constraint(rug-0, (2, 2, 0), max_distance=0.1)"),
        (29, "zone(rug-0, [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)])"),
        (30, "centered_on(rug-0)"),
        (31, "symmetric_pair(night_stand-0, night_stand-1, bed-0)"),
        (33, "point_towards(chair-3, walls[3])"),
    ]
    assert [s.number for s in program.statements] == list(range(1, len(said) + 1))
    assert program.statements[1].source == 'solver.next_to(n, bed[0], side="left" if i else "right")'
    assert program.guesses == {
        "bed-0": Guess((2.0, 1.0, 0.25), math.radians(90)),
        "night_stand-0": Guess((1.1, 1.0, 0.25), None),
        "night_stand-1": Guess(None, math.radians(90)),
    }
    assert program.notes == ("placed night_stand[0] 0", "placed night_stand[1] 1")
    assert program.text == RICH


def test_a_program_in_the_manner_of_layoutvlm(scene):
    text = """\
```python
# Bed against the wall, chairs at the table
from math import cos, sin, radians
bed[0].position = [1.0, 4.0, bed[0].size[2] / 2]
bed[0].rotation = [0, 0, radians(0)]
chair.placements[0].position = (3 + 0.5 * cos(radians(90)), 2, 0.45)
chair[1].rotation[2] = radians(180)
solver.against_wall(bed[0], walls[3])
solver.distance_constraint(chair.placements[0], table[0], min_distance=0.5, max_distance=1.0)
solver.distance_constraint(rug[0], AssetInstance(position=[2, 2, 0]), 0, 0.1, weight=10)
solver.point_towards(asset1=chair[1], asset2=table[0])
solver.align_with(assets[0], walls[0], angle=90)
```
"""
    program = read_program(text, scene)
    assert [s.relation.sentence() for s in program.statements] == [
        "against_wall(bed-0, walls[3])",
        "distance_constraint(chair-0, table-0, min_distance=0.5, max_distance=1)",
        "distance_constraint(rug-0, (2, 2, 0), min_distance=0, max_distance=0.1, weight=10)",
        "point_towards(chair-1, table-0)",
        "align_with(bed-0, walls[0], angle=90)",
    ]
    assert program.guesses["bed-0"] == Guess((1.0, 4.0, 0.25), 0.0)
    assert program.guesses["chair-1"] == Guess(None, math.pi)


def test_normalised_text_reads_back_to_the_same(scene):
    program = read_program(RICH, scene)
    again = read_program(program.to_text(), scene)
    assert [s.relation for s in again.statements] == [s.relation for s in program.statements]
    assert again.guesses == program.guesses
    assert again.to_text() == program.to_text()


def test_example_of_every_relation_reads(scene):
    """Whatever nouns an example uses, a scene that has them can state it, and it survives normalising."""
    for name, kind in RELATIONS.items():
        words = sorted(set(re.findall(r"(\w+)\[", kind.example)) - {"walls"})
        size = (0.5, 0.5, 1.5)  # high enough for a second shelf
        assets = tuple(Asset(f"{word}-{i}", word, size) for word in words for i in range(6))
        here = Scene(replace(scene.room, windows=(Opening(2, 0.5, 1.0, 1.0, 0.9),)), assets)
        statement = relation(kind.example, here)
        assert statement.relation.name == name
        again = read_program(read_program(kind.example, here).to_text(), here)
        assert again.statements[0].relation == statement.relation


def test_three_numbers_that_no_radians_are_were_meant_as_degrees(scene):
    """Models write [0, 0, -90]; 12.5 are still radians. What was made of it is remarked with its line."""
    text = "chair[0].rotation = [0, 0, -90]\nchair[1].rotation = [0, 0, 12.5]\nchair[2].rotation = [0, 0, 270]\n"
    program = read_program(text, scene)
    assert [math.degrees(guess.yaw) for guess in program.guesses.values()] == [-90, pytest.approx(716.2, abs=0.1), 270]
    assert program.remarks == (
        "Rotations of line 1, 3 were read as degrees: three numbers are radians, and -90 radians are more than two turns; "
        "write [-90] or [0, 0, radians(-90)].",
    )


def test_a_class_of_ones_own_has_what_it_is_given(scene):
    text = "class Zone:\n    def __init__(self, x):\n        self.x = x\n        self.x += 1\n"
    program = read_program(text + "zone = Zone(1)\nzone.bed = bed[0]\nzone.bed.position = [zone.x, 2, 0.5]\n", scene)
    assert program.guesses == {"bed-0": Guess((2.0, 2.0, 0.5))}


@settings(max_examples=25, deadline=None)
@given(st.floats(-1e4, 1e4), st.floats(-12.5, 12.5), st.floats(0, 1e6), st.integers(0, 3), st.integers(0, 3))
def test_numbers_survive_exactly(x, yaw, weight, chair, wall):
    room = furnished()
    text = (
        f"chair[{chair}].position = [{x!r}, 0, 0]\nchair[{chair}].rotation = [0, 0, {yaw!r}]\n"
        f"solver.against_wall(chair[{chair}], walls[{wall}], weight={weight!r})\n"
        f"solver.distance_constraint(chair[{chair}], [{x!r}, 1.5])"
    )
    program = read_program(text, room)
    again = read_program(program.to_text(), room)
    assert program.guesses[f"chair-{chair}"] == Guess((x, 0.0, 0.0), yaw) == again.guesses[f"chair-{chair}"]
    wanted = (AssetRef(f"chair-{chair}"), WallRef(wall), weight)
    first, second = (s.relation for s in program.statements)
    assert (first.a, first.wall, first.weight) == wanted
    assert second.b == PointRef(x, 1.5)
    assert [s.relation for s in again.statements] == [first, second]


def test_fences_and_prose_are_dropped_and_lines_still_fit(scene):
    answer = "Here you are:\n```json\n{}\n```\n1. Then\n   ```python\n   solver.corner(bed[0])\n   ```\nBye `x`."
    statement = relation(answer, scene)
    assert (statement.line, statement.source) == (7, "solver.corner(bed[0])")
    assert relation("```\nsolver.corner(bed[0])\n```", scene).line == 2
    assert relation("```python\nsolver.corner(bed[0])", scene).line == 2
    assert strip_fences("```python\na\n```\nx\n```python\nb\n```") == "\na\n\n\n\nb\n"
    assert read_program("", scene).statements == ()


def test_windows_lines_and_non_ascii_text(scene):
    text = "# Möbel\r\nprint('ä'); solver.corner(bed[0])\rsolver.corner(lampe[0])"
    with pytest.raises(ProgramError) as caught:
        read_program(text, scene)
    assert (caught.value.line, caught.value.column) == (3, text.split("\r")[2].index("lampe"))
    assert relation("grüße = 'ü'; solver.corner(bed[0])", scene).source == "solver.corner(bed[0])"


def test_what_a_program_may_look_at(scene):
    text = (
        "print(bed[0].width, bed[0].depth, bed[0].height, bed[0].size, bed[0].category, bed[0].name, len(walls))\n"
        "print(walls[1].corner1, walls[1].corner2, walls[1].midpoint, walls[1].normal, walls[1].length)\n"
        "print(room.max_x, room.max_y, room.center, room.wall_height, degrees(pi))"
    )
    assert read_program(text, scene).notes == (
        "1.6 2.0 0.5 [2.0, 1.6, 0.5] bed bed-0 4",
        "[4, 0] [4, 5] [4.0, 2.5] [-1.0, 0.0] 5.0",
        "4 5 [2.0, 2.5] 2.6 180.0",
    )


def test_variables_named_like_builtins_do_no_harm(scene):
    text = "max = 3\nlen = 4\nlist = 5\nstr = 6\nisinstance = 7\nAssetInstance = 8\nsolver.corner(bed[0])\nbed[0].position=[1,1,1]"
    program = read_program(text, scene)
    assert program.statements[0].relation.sentence() == "corner(bed-0)"
    assert program.guesses["bed-0"].position == (1.0, 1.0, 1.0)


MISTAKES = {
    "solver.against_wal(bed[0], walls[0])": ("Did you mean 'against_wall'? Known: against_wall, distance", 7),
    "solver.against_wall(lmp[0], walls[0])": (
        "unknown asset or variable 'lmp'. Did you mean 'lamp'? Known variables: bed,",
        20,
    ),
    "against_wall(bed[0], walls[0])": ("'against_wall' is a relation: write solver.against_wall(...)", 0),
    "solver.corner(bed[3])": ("bed[3]: bed has 1 item (bed[0])", 14),
    "ä = 1; solver.against_wall(bed[0], walls[7])": ("walls[7]: walls has 4 items (walls[0] to walls[3])", 35),
    "i = 4\nsolver.corner(chair[i])": ("chair[i]: chair has 4 items (chair[0] to chair[3])", 14),
    "solver.facing_pair(bed[0])": ("facing_pair needs b: an asset such as bed[0]. Example: solver.facing", 0),
    "solver.against_wall(bed[0], bed[0])": (
        "wall of against_wall takes a wall such as walls[0] or None, not bed[0]",
        28,
    ),
    "solver.corner(walls[0])": ("a of corner takes an asset such as bed[0], not walls[0]", 14),
    "solver.corner(chair)": ("a of corner takes an asset such as bed[0], not a list of 4", 14),
    "solver.corner('bed')": ("a of corner takes an asset such as bed[0], not 'bed'", 14),
    "solver.corner(None)": ("a of corner takes an asset such as bed[0], not None", 14),
    "solver.corner(bed[0], True)": ("vertex of corner takes a whole number or None, not True", 22),
    "solver.corner(bed[0], 1.5)": ("vertex of corner takes a whole number, not 1.5", 22),
    "solver.against_wall(bed[0], wal=walls[0])": (
        "has no argument 'wal'. Did you mean 'wall'? It takes a, wall, weight.",
        32,
    ),
    "solver.facing_pair(bed[0], bed[0], 1)": ("facing_pair takes 2 arguments (a, b), not 3", 35),
    "solver.corner(bed[0], a=bed[0])": ("corner gets 'a' twice", 24),
    "solver.distance_constraint(bed[0], table[0], 3, 1)": ("min_distance = 3 is above max_distance = 1", 0),
    "solver.distance_constraint(bed[0], table[0],\n  float('nan'))": ("is not finite (NaN or infinite)", 2),
    "solver.distance_constraint(bed[0], table[0], 1e400)": ("is not finite (NaN or infinite)", 45),
    "solver.distance_constraint(bed[0], table[0], 10**400)": ("is not finite (NaN or infinite)", 45),
    "solver.distance_constraint(bed[0], table[0], 1e7)": ("is 1e+07; numbers go up to 1e+06", 45),
    "solver.against_wall(bed[0], walls[0], weight=-1)": ("weight of against_wall is -1; a weight is 0 or more", 45),
    "solver.distance_constraint(bed[0], [1])": ("takes a point of two or three numbers, such as [1.5, 2.0]", 35),
    "solver.next_to(bed[0], table[0], 'above')": ("side of next_to is 'above', which is not one of 'front', ", 33),
    "solver.zone(bed[0], [(0, 0), (1, 1)])": ("polygon of zone takes at least 3 points, not 2", 20),
    "solver.row([])": ("items of row is an empty list", 11),
    "solver.row([[[[[bed[0]]]]]])": ("items of row takes a list, each item of it an asset", 11),
    "chair.position = [1, 2, 3]": ("chair is a list of 4; write chair[0].position", 0),
    "x = bed[0].position[0]": ("bed[0] has no position yet; assign bed[0].position first", 4),
    "bed[0].position = [1, 2]": ("bed[0].position is three numbers, x, y, z in metres", 0),
    "bed[0].position = 'here'": ("bed[0].position takes a list of numbers", 0),
    "bed[0].position = [float('nan'), 0, 0]": ("bed[0].position = [nan, 0, 0]: every number must be finite", 0),
    "bed[0].position = [1e9, 0, 0]": ("every number must be finite and within 10000", 0),
    "bed[0].rotation = [0, 90]": ("bed[0].rotation is [degrees] or [0, 0, radians(degrees)]", 0),
    "bed[0].position = [1, 2, 0.5, 0]": ("three numbers, x, y, z in metres, not 4", 0),
    "bed[0].name = 'gold'": ("bed[0] has no 'name' to set; of a thing position and rotation can be set", 0),
    "for thing in assets:\n    thing.posiiton = [1, 2, 0.5]": ("bed[0] has no 'posiiton' to set", 4),
    "walls[0].position = [1, 2]": ("walls[0] has no 'position' to set", 0),
    "x = bed[0].dimensions": ("a thing has no 'dimensions'; it has position, rotation, depth, width, height", 4),
    "x = walls[1].angle": ("a wall has no 'angle'; it has start, end, midpoint, normal, length and index", 4),
    "x = room.width": ("the room has no 'width'; it has center, min_x, max_x, min_y, max_y and wall_height", 4),
    "solver.any_of(solver.corner(bed[0], 0), solver.corner(bed[0], 1))": (
        "any_of takes 1 argument (choices), not 2",
        40,
    ),
    "x = chair.size": ("a list of assets has no 'size'; pick one of it, such as bed[0]", 4),
    "x = {}['a']": ("there is no key 'a'", 4),
    "x = walls[bed[0]]": ("list indices must be integers or slices, not asset", 4),
    "x = 1 / 0": ("division by zero", 4),
    "class A(list): pass": ("programs cannot use class inheritance", 0),
    "def f():\n  yield 1": ("generators and async code do not exist in programs; use a list", 2),
    "raise ValueError('my own')": ("my own", 6),
    "def (": ("this is not Python: ", 4),
    "x = (1,\n": ("this is not Python: '(' was never closed", 4),
}


@pytest.mark.parametrize(("text", "answer"), MISTAKES.items())
def test_a_mistake_is_answered_with_line_caret_and_what_would_work(scene, text, answer):
    words, column = answer
    with pytest.raises(ProgramError) as caught:
        read_program(text, scene)
    message, source, caret = str(caught.value).split("\n")
    assert words in message
    assert message.startswith(f"line {caught.value.line}: ")
    assert source == "    " + text.split("\n")[caught.value.line - 1]
    assert caret.index("^") - 4 == caught.value.column == column


def test_an_asset_named_like_a_word_of_the_language_has_a_variable_of_its_own(scene):
    names = (
        "walls-0",
        "lambda-0",
        "_rl_x-0",
        "None-0",
        "ValueError-0",
        "print-0",
        "桌子-0",
        "cafe\u0301-0",
        "caf\u00e9-0",
    )
    odd = Scene(scene.room, tuple(Asset(name, "thing", (1, 1, 1)) for name in names))
    text = "".join(f"solver.corner({expression})\n" for expression in odd.expressions.values())
    program = read_program(text, odd)
    assert [statement.relation.a.name for statement in program.statements] == list(odd.expressions)
    assert program.to_text() == text
    with pytest.raises(ProgramError, match="has no position yet"):
        read_program("x = ValueError[0].position", odd)


def test_indices_need_not_start_at_zero(scene):
    odd = Scene(scene.room, (Asset("cup-3", "cup", (1, 1, 1)), Asset("cup-1", "cup", (1, 1, 1))))
    program = read_program("solver.corner(cup[0])\nsolver.corner(cup[1])", odd)
    assert [s.relation.a.name for s in program.statements] == ["cup-1", "cup-3"]
    assert program.to_text() == "solver.corner(cup[0])\nsolver.corner(cup[1])\n"
