"""The error tree: complete, drawn as it is, and its messages."""

from __future__ import annotations

import inspect
import pickle
import re

import pytest

from robolayout import _errors
from robolayout._errors import (
    InputError,
    MissingExtraError,
    ModelError,
    ProgramError,
    ProgramLimitError,
    RoboLayoutError,
    UnknownNameError,
)

CLASSES = {
    name: value
    for name, value in vars(_errors).items()
    if inspect.isclass(value) and issubclass(value, Exception) and value.__module__ == _errors.__name__
}


def test_the_tree_at_the_top_of_the_file_is_the_tree() -> None:
    drawn: dict[str, str] = {}
    path: list[tuple[int, str]] = []
    for line in (_errors.__doc__ or "").splitlines():
        if match := re.match(r"^([│├└─ ]*)(\w+Error)\b", line):
            depth = len(match[1])
            while path and path[-1][0] >= depth:
                path.pop()
            drawn[match[2]] = path[-1][1] if path else "Exception"
            path.append((depth, match[2]))
    assert drawn == {name: cls.__bases__[0].__name__ for name, cls in CLASSES.items()}


@pytest.mark.parametrize("cls", CLASSES.values(), ids=CLASSES)
def test_every_error_is_ours_and_says_whose_it_is(cls: type[Exception]) -> None:
    assert issubclass(cls, RoboLayoutError)
    assert cls is RoboLayoutError or issubclass(cls, InputError) != issubclass(cls, ModelError)
    assert inspect.getdoc(cls)


def test_unknown_name_lists_the_known_in_order() -> None:
    error = UnknownNameError("exporter", "glv", {"usd", "glb", "mjcf"})
    assert str(error) == "unknown exporter 'glv'. Did you mean 'glb'? Known: glb, mjcf, usd."
    assert (error.kind, error.name, error.known) == ("exporter", "glv", ["glb", "mjcf", "usd"])
    assert str(UnknownNameError("agent", "xyz", ["cat"])) == "unknown agent 'xyz'. Known: cat."


def test_program_errors_show_line_and_caret() -> None:
    error = ProgramError("unknown asset 'bde'.", line=3, source="against_wall(bde[0])", column=13)
    assert str(error) == "line 3: unknown asset 'bde'.\n    against_wall(bde[0])\n                 ^"
    assert (error.line, error.column) == (3, 13)
    assert str(ProgramLimitError("it took more than 5 s.")) == "it took more than 5 s."
    assert str(ProgramError("no.", line=2, source="x")) == "line 2: no.\n    x"


def test_a_missing_extra_says_how_to_get_it() -> None:
    error = MissingExtraError("the VLM planner", "vlm")
    assert str(error) == "the VLM planner needs the extra 'vlm': pip install 'robolayout[vlm]'."
    assert error.extra == "vlm"


@pytest.mark.parametrize(
    "error",
    [
        InputError("no"),
        ProgramError("no such name", line=3, source="solver.x()", column=7),
        ProgramLimitError("too long"),
        UnknownNameError("agent", "robbot", ["robot", "cat"]),
        MissingExtraError("USD", "usd"),
        ModelError("refused"),
    ],
    ids=lambda error: type(error).__name__,
)
def test_an_error_comes_back_whole_from_another_process(error: RoboLayoutError) -> None:
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error)
    assert (str(again), vars(again)) == (str(error), vars(error))


def test_a_long_name_and_a_long_list_are_shortened() -> None:
    text = str(UnknownNameError("category", "x" * 5000, [f"thing {i:03}" for i in range(500)]))
    assert text.startswith(f"unknown category '{'x' * 100}...'. Known: thing 000, ")
    assert text.endswith("thing 099, ... (500 in all).")
