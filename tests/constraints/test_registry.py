"""Relations of users: a class in this file, not in the package, goes from program text to a verified layout."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import pytest

from robolayout import InputError
from robolayout.constraints import (
    RELATIONS,
    AssetRef,
    FrameTerm,
    Interval,
    Outcome,
    Relation,
    Term,
    _registry,
    argument,
    register,
    register_file,
)
from robolayout.program import read_program, reconcile
from robolayout.scene import Asset, Layout, Pose, Room, Scene

SCENE = Scene(
    Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5),
    (Asset("sofa-0", "sofa", (0.9, 2.0, 0.8)), Asset("tv-0", "tv", (0.3, 1.2, 0.7))),
)


@pytest.fixture(autouse=True)
def _forget() -> Iterator[None]:
    known = dict(_registry._KNOWN)
    yield
    _registry._KNOWN.clear()
    _registry._KNOWN.update(known)


def make(**parts: object) -> type[Relation]:
    """Return a good relation, or one with other parts."""

    @dataclass(frozen=True)
    class ScreenDistance(Relation):
        """`a` stands straight before `screen`, `times` its width away."""

        name: ClassVar[str] = "screen_distance"
        example: ClassVar[str] = "solver.screen_distance(sofa[0], tv[0], times=2)"

        a: AssetRef = argument("asset")  # noqa: RUF009
        screen: AssetRef = argument("asset")  # noqa: RUF009
        times: float = argument("number", default=1.5)

        def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
            away = self.times * scene.by_name[self.screen.name].size[1]
            return (FrameTerm(self.a, self.screen, along=Interval(away, away), across=Interval(0, 0), heading=math.pi),)

        def check(self, scene: Scene, layout: Layout) -> Outcome:
            a, b = layout[self.a.name], layout[self.screen.name]
            away = self.times * scene.by_name[self.screen.name].size[1]
            off = math.dist((a.x, a.y), (b.x + away * b.forward[0], b.y + away * b.forward[1]))
            return Outcome(off <= 0.1, off, 0.1, "m", f"{off:.2f} m off its place")

    for key, value in parts.items():
        setattr(ScreenDistance, key, value)
    return ScreenDistance


def test_a_registered_relation_is_read_filtered_and_checked() -> None:
    register(make())
    program = read_program("solver.screen_distance(sofa[0], tv[0], times=2)", SCENE)
    (statement,) = reconcile(program, SCENE).program.statements
    assert statement.relation.sentence() == "screen_distance(sofa-0, tv-0, times=2)"
    met = Layout({"tv-0": Pose(0.2, 2, 0.4, 0), "sofa-0": Pose(2.55, 2, 0.4, math.pi)})
    assert statement.relation.check(SCENE, met).met
    assert not statement.relation.check(SCENE, Layout(dict(met) | {"sofa-0": Pose(2, 2, 0.4, 0)})).met


def test_before_that_its_word_is_unknown() -> None:
    with pytest.raises(InputError, match="screen_distance"):
        read_program("solver.screen_distance(sofa[0], tv[0])", SCENE)


@pytest.mark.parametrize(
    ("parts", "message"),
    [
        ({"name": "next_to"}, "the word 'next_to' is taken by robolayout.constraints.next_to.NextTo"),
        ({"name": "two words"}, "its name 'two words' is no word for a program, such as 'next_to'"),
        ({"name": "_hidden"}, "its name '_hidden' is no word for a program"),
        ({"example": ""}, "it has no example, one line of program text"),
        ({"__doc__": "Watches television."}, "the first line of its docstring does not explain `a`"),
        ({"moves": ("b",)}, "moves names 'b', which is no argument"),
        ({"__abstractmethods__": frozenset({"check"})}, r"it has no check\(\)"),
    ],
)
def test_a_relation_with_a_part_missing_is_refused(parts: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=f"the relation ScreenDistance cannot be registered: .*{message}"):
        register(make(**parts))
    assert "screen_distance" not in RELATIONS


def test_a_relation_is_a_frozen_dataclass() -> None:
    class Loose(Relation):
        """Anything."""

    with pytest.raises(InputError, match="Loose cannot be registered: it is not a frozen dataclass"):
        register(Loose)


def test_the_same_relation_may_be_registered_again() -> None:
    assert register(make()) is RELATIONS["screen_distance"]
    assert register(make()) is RELATIONS["screen_distance"]


def test_nobody_else_writes_the_table() -> None:
    with pytest.raises(TypeError):
        RELATIONS["x"] = make()  # type: ignore[index]


FILE = '''"""A relation of mine."""
from __future__ import annotations
from dataclasses import dataclass
from typing import ClassVar
from robolayout.constraints import AssetRef, FrameTerm, Outcome, Relation, argument

@dataclass(frozen=True)
class FarFrom(Relation):
    """`a` keeps 2 m from `b`."""
    name: ClassVar[str] = "far_from"
    example: ClassVar[str] = "solver.far_from(sofa[0], tv[0])"
    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    def terms(self, scene, near):
        return (FrameTerm(self.a, self.b, distance=(2.0, 1e3)),)
    def check(self, scene, layout):
        return Outcome(True, 0.0, 0.0, "m", "")
'''


def test_a_file_of_relations(tmp_path: Path) -> None:
    path = tmp_path / "mine.py"
    path.write_text(FILE)
    (relation,) = register_file(path)
    assert RELATIONS["far_from"] is relation
    (statement,) = read_program("solver.far_from(sofa[0], tv[0])", SCENE).statements
    assert isinstance(statement.relation, relation)
    register_file(path)


def test_a_file_without_relations_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "empty.py"
    path.write_text("from robolayout.constraints import Relation\n")
    with pytest.raises(InputError, match=r"empty\.py defines no relation, that is, no class derived from"):
        register_file(path)
    with pytest.raises(
        InputError, match=r"nowhere\.py is no Python file, or not there; relations are read from a file"
    ):
        register_file(tmp_path / "nowhere.py")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("solver.corner(sofa[0], 7)", "corner: vertex 7 is no corner to stand in; this room has 0, 1, 2, 3"),
        ("solver.corner(sofa[0], -1)", "vertex -1 is no corner"),
        ("solver.grid(sofa, 0, 2)", "grid: a grid has at least 1 row and 1 column, not 0 x 2"),
        ("solver.grid([sofa[0], tv[0]], 1, 1)", "grid: 2 things do not fit into 1 x 1 places"),
        ("solver.zone(sofa[0], [(0, 0), (1, 1), (2, 2)])", "zone: the points of a zone lie on one line"),
    ],
)
def test_arguments_that_make_no_sense_are_refused(text: str, message: str) -> None:
    """Each of these ended in an IndexError or a ZeroDivisionError later on, or in a zone that nothing fits."""
    with pytest.raises(InputError, match=f"line 1: .*{message}"):
        read_program(text, SCENE)


def test_no_relation_stands_in_a_corner_that_points_inwards() -> None:
    room = Room(((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)), 2.5)
    scene = Scene(room, SCENE.assets)
    with pytest.raises(InputError, match="vertex 3 is no corner to stand in; this room has 0, 1, 2, 4, 5"):
        read_program("solver.corner(sofa[0], 3)", scene)
