"""What a model's answer gets right is used to the last statement; the rest is told with line and caret."""

from __future__ import annotations

import pytest

from robolayout._errors import ProgramError, ProgramLimitError
from robolayout.program import Program, ProgramLimits, read_program, read_salvaged
from robolayout.program._program import READING
from robolayout.scene import Scene

GOOD = "solver.against_wall(bed[0], walls[3])"


def said(program: Program) -> list[str]:
    return [statement.source for statement in program.statements]


@pytest.mark.parametrize(
    ("bad", "message"),
    [
        ("solver.against_wall(bad[0], walls[0])", "unknown asset or variable 'bad'"),
        ("solver.agianst_wall(table[0], walls[0])", "unknown relation 'agianst_wall'. Did you mean 'against_wall'?"),
        ("solver.against_wall(table[0], walls[9])", "walls[9]: walls has 4 items"),
        ("solver.next_to(table[0], bed[0], 'above')", "is 'above', which is not one of"),
        ("table[0].position = [1, float('nan'), 0]", "every number must be finite"),
        ("solver.against_wall(table[0], walls[0]", "'(' was never closed"),
        ("import os", "'os' cannot be imported"),
        ("x = 1 / 0", "division by zero"),
        ("for c in chairs:\n    solver.corner(c)\n    solver.corner(c, 1)", "unknown asset or variable 'chairs'"),
        ("def f():\n    return tabel[0]\nsolver.corner(f())", "unknown asset or variable 'tabel'"),
    ],
)
@pytest.mark.parametrize("where", ["before", "after"])
def test_one_bad_statement_costs_that_statement(scene: Scene, bad: str, message: str, where: str) -> None:
    text = f"{bad}\n{GOOD}\n" if where == "before" else f"{GOOD}\n{bad}\n"
    with pytest.raises(ProgramError):
        read_program(text, scene)
    program = read_salvaged(f"Here it is:\n```python\n{text}```\nEnjoy!", scene)
    assert said(program) == [GOOD]
    assert message in program.dropped[0] and program.dropped[0].startswith("line ")
    assert len(program.dropped) <= 2


def test_inside_a_loop_only_the_wrong_statement_goes(scene: Scene) -> None:
    text = "for c in chair:\n    solver.distance_constraint(c, table[0], 0.2, 1.0)\n    solver.facing(c, table[0])\n"
    program = read_salvaged(text, scene)
    assert len(program.statements) == 4
    assert len(program.dropped) == 1 and program.dropped[0].startswith("line 3: unknown relation 'facing'.")


def test_a_cut_answer_is_used_up_to_the_cut(scene: Scene) -> None:
    program = read_salvaged(f"```python\n{GOOD}\nsolver.corner(table[0])\nsolver.next_to(night_sta", scene)
    assert said(program) == [GOOD, "solver.corner(table[0])"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "```python\n```",
        "Sure! I would put the bed in the corner.",
        "{}",
        '{"program": ""}',
        "x = 1",
        "\ufeff",
        "```\n\n```",
    ],
)
def test_what_places_and_states_nothing_is_no_program(scene: Scene, text: str) -> None:
    with pytest.raises(ProgramError, match=r"holds no program|this is not Python"):
        read_salvaged(text, scene)


def test_an_answer_that_is_wrong_everywhere_is_refused_with_its_first_error(scene: Scene) -> None:
    with pytest.raises(ProgramError, match="line 1: unknown relation 'a0'"):
        read_salvaged("\n".join(f"solver.a{i}(bed[0])" for i in range(READING.dropped + 5)) + f"\n{GOOD}", scene)


def test_limits_are_not_salvaged(scene: Scene) -> None:
    with pytest.raises(ProgramLimitError, match="at most 100 are read"):
        read_salvaged(GOOD * 10, scene, ProgramLimits(text=100))


@pytest.mark.parametrize(
    "text",
    [
        f"\ufeff{GOOD}",
        f'{{"program": "{GOOD}"}}',
        f'{{"reasoning": "...", "code": "```python\\n{GOOD}\\n```"}}',
        f'```json\n{{"program": "{GOOD}"}}\n```',
        f'{{"name": "plan", "arguments": {{"program": "{GOOD}"}}}}',
        f'{{"name": "plan", "arguments": "{{\\"code\\": \\"{GOOD}\\"}}"}}',
    ],
)
def test_wrapped_answers_are_read(scene: Scene, text: str) -> None:
    assert said(read_program(text, scene)) == [GOOD]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("bed[0].position = [cos(0) + sqrt(4), 2 * sin(pi / 2), 0.25]", (3.0, 2.0, 0.25)),
        ("from math import cos\nbed[0].position = [cos(0), 2, 0.25]", (1.0, 2.0, 0.25)),
        ("import numpy as np\nbed[0].position = np.array([np.cos(np.deg2rad(0)), np.sqrt(4), 0.25])", (1.0, 2.0, 0.25)),
        ("import numpy\nbed[0].position = [numpy.linspace(0, 2, 3)[1], 2, 0.25]", (1.0, 2.0, 0.25)),
        ("bed[0] = AssetInstance(position=[1, 2, 0.25], rotation=[90])", (1.0, 2.0, 0.25)),
        ("for i in range(1):\n    bed[i] = AssetInstance(position=[1, 2, 0.25])", (1.0, 2.0, 0.25)),
    ],
)
def test_the_dialect_of_layoutvlm_is_read(scene: Scene, text: str, expected: tuple[float, ...]) -> None:
    program = read_program(text + "\nsolver.against_wall(bed[0], walls[3])\nsolver.solve()\n", scene)
    assert program.guesses["bed-0"].position == pytest.approx(expected)
    assert said(program) == [GOOD]
    assert program.notes == ("solver.solve() means nothing here and was ignored",)


def test_a_function_of_numpy_that_is_not_there_is_named(scene: Scene) -> None:
    with pytest.raises(ProgramError, match="'numpy' object has no attribute 'arange'"):
        read_program("import numpy as np\nbed[0].position = np.arange(3)", scene)


def test_ordinary_lists_keep_their_assignments(scene: Scene) -> None:
    text = "x = [1, 2]\nx[0] = 5\nd = {}\nd['a'] = 3\nbed[0].position = [x[0], d['a'], 0.25]"
    assert read_program(text, scene).guesses["bed-0"].position == (5.0, 3.0, 0.25)


def test_what_a_program_forgets_is_named(scene: Scene) -> None:
    forgotten = read_program(GOOD, scene).forgotten()
    assert "bed[0]" not in forgotten and "table[0]" in forgotten and len(forgotten) == 11
