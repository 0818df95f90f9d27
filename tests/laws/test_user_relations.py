"""The page on new constraints: its code runs, its relation obeys the laws and is solved; the table of statements is current."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import test_constraints as laws

from robolayout.constraints import RELATIONS, Relation, _registry, register
from robolayout.run.result import Result
from running import slow

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "how-to" / "constraint.md"
NAME = "viewing_distance"


@pytest.fixture(scope="module")
def page() -> dict[str, Any]:
    """Run the page's code as a reader would, and return its names."""
    known = dict(_registry._KNOWN)
    names: dict[str, Any] = {"__name__": "page"}
    for number, code in enumerate(re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)):
        place = f"{PAGE.name}:{number}"
        exec(compile(code, place, "exec", dont_inherit=True), names)  # noqa: S102 - our own documentation
    forget(known)
    return names


def forget(known: dict[str, type[Relation]]) -> None:
    _registry._KNOWN.clear()
    _registry._KNOWN.update(known)


@pytest.fixture
def result(page: dict[str, Any]) -> Iterator[Result]:
    """Return what the page's code made, while its relation is known."""
    known = dict(_registry._KNOWN)
    register(page["ViewingDistance"])
    yield page["result"]
    forget(known)


def test_the_relation_of_the_page_is_solved_and_reported(result: Result) -> None:
    assert result.report.violations == ()
    wanted = [
        row for row in result.report.to_dict()["statements"] if row["source"].startswith("solver.viewing_distance")
    ]
    assert [row["met"] for row in wanted] == [True]
    seat, screen = result.layout["sofa-0"], result.layout["tv-0"]
    assert np.hypot(seat.x - screen.x, seat.y - screen.y) == pytest.approx(1.8 * 1.4, abs=0.05)


@pytest.mark.parametrize(
    "law",
    [
        slow(laws.test_the_gradient_is_that_of_finite_differences),
        laws.test_no_residual_means_that_the_check_passes,
        laws.test_a_passed_check_means_little_residual,
        laws.test_nothing_changes_when_the_whole_scene_moves,
        laws.test_a_batch_is_as_good_as_one_at_a_time,
        laws.test_its_example_can_be_read_and_written,
        laws.test_its_words_explain_it,
    ],
    ids=lambda law: law.__name__,
)
def test_the_relation_of_the_page_obeys_the_laws(result: Result, law) -> None:
    law(NAME)


def test_its_awkward_points(result: Result) -> None:
    laws.test_value_and_gradient_are_finite_at_awkward_points(NAME, np.float64)


@pytest.mark.parametrize("name", ["constraints.md", "how-to/constraint.md"])
def test_the_tables_are_current(name: str) -> None:
    spec = spec_from_file_location("docs_generate", ROOT / "docs" / "generate.py")
    assert spec is not None and spec.loader is not None
    generate = module_from_spec(spec)
    spec.loader.exec_module(generate)
    text = (ROOT / "docs" / name).read_text(encoding="utf-8")
    assert generate.filled(text) == text, "run make docs"


def test_the_table_names_every_statement() -> None:
    text = (ROOT / "docs" / "constraints.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| `(\w+)\(", text, re.MULTILINE) == [
        name for name in RELATIONS if RELATIONS[name].__module__.startswith("robolayout.")
    ]
