"""`--constraints FILE`: a constraint of the user's own from the command line, in a process of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from running import ROOT, slow

OWN = '''
from dataclasses import dataclass
from typing import ClassVar

from robolayout.constraints import AssetRef, FrameTerm, Interval, Outcome, PointRef, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class EastOf(Relation):
    """The centre of `a` lies east of `x`."""

    name: ClassVar[str] = "east_of"
    example: ClassVar[str] = "solver.east_of(desk[0], x=2.0)"

    a: AssetRef = argument("asset")
    x: float = argument("number", unit="m", default=1.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row."""
        return (FrameTerm(self.a, PointRef(self.x, 0.0), along=Interval(low=0.0)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Met when the centre's x is at least `x`."""
        x = layout[self.a.name].x
        return Outcome(x >= self.x - 0.01, x, self.x, "m", f"x is {x:.2f} m")
'''


def run(folder: Path, *words: str, command: str = "generate") -> subprocess.CompletedProcess[str]:
    called = [sys.executable, "-m", "robolayout", command, *words, "--out", str(folder / "out"), "--quiet"]
    return subprocess.run(called, cwd=ROOT, capture_output=True, text=True, check=False)


@pytest.mark.slow
def test_a_constraint_from_a_file_is_known_and_met(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(OWN)
    (tmp_path / "program.py").write_text("solver.east_of(potted_plant[0], x=2.5)\n")
    ran = run(
        tmp_path,
        *("examples/bedroom.json", "--no-pictures"),
        *("--constraints", str(tmp_path / "mine.py"), "--program", str(tmp_path / "program.py")),
    )
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert ran.returncode in (0, 1), ran.stderr
    assert report["statements"][0]["sentence"].startswith("east_of(")
    assert report["statements"][0]["met"]


def test_a_file_without_a_constraint_is_refused(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text("X = 1\n")
    ran = run(tmp_path, "examples/bedroom.json", "--constraints", str(tmp_path / "mine.py"))
    assert ran.returncode == 2
    assert "mine.py defines no relation" in ran.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("kind", "names", "command", "said"),
    [
        ("constraints", "no_such_module:X", ("constraints",), "cannot be loaded: ModuleNotFoundError: No module named"),
        ("constraints", "json:dumps", ("constraints",), "is no Relation"),
        ("agents", "no_such_module:X", ("agents", "odd"), "cannot be loaded: ModuleNotFoundError: No module named"),
        ("agents", "json:dumps", ("agents", "odd"), "is no agent: a dictionary or a path"),
    ],
)
def test_what_an_installed_package_registers_wrongly_is_put_down_to_that_package(
    tmp_path: Path, kind: str, names: str, command: tuple[str, ...], said: str
) -> None:
    info = tmp_path / "odd_pack-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: odd-pack\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(f"[robolayout.{kind}]\nodd = {names}\n")
    path = os.pathsep.join([str(tmp_path), *filter(None, sys.path)])
    words = [sys.executable, "-m", "robolayout", *command]
    ran = subprocess.run(words, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, check=False)
    assert ran.returncode == 2, ran.stderr
    where = f"robolayout: the entry point 'odd' ({names}) in robolayout.{kind}, of odd-pack, "
    assert ran.stderr.startswith(where + said), ran.stderr
    assert "Correct or uninstall that package." in ran.stderr


@pytest.mark.slow
def test_a_layout_is_checked_with_constraints_from_a_file(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(OWN)
    (tmp_path / "program.py").write_text("solver.east_of(desk[0], x=2.5)\n")
    asset = {"boundingBox": {"x": 0.7, "y": 1.4, "z": 0.75}, "category": "desk", "onFloor": True}
    room = {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], "wall_height": 2.6}
    scene = {"task_description": "", "boundary": room, "assets": {"desk-0": {"assetMetadata": asset, **asset}}}
    (tmp_path / "scene.json").write_text(json.dumps(scene))
    (tmp_path / "layout.json").write_text(json.dumps({"desk-0": {"position": [1, 2, 0.375], "rotation": [0, 0, 0]}}))
    given = [str(tmp_path / name) for name in ("scene.json", "layout.json")]
    told = ("--no-pictures", "--program", str(tmp_path / "program.py"))
    ran = run(tmp_path, *given, *told, "--constraints", str(tmp_path / "mine.py"), command="check")
    assert ran.returncode == 1, ran.stderr
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert [(one["sentence"].split("(")[0], one["met"]) for one in report["statements"]] == [("east_of", False)]


@pytest.mark.parametrize("method", [slow("check"), "terms"])
def test_a_relation_that_fails_is_named_as_the_users(tmp_path: Path, method: str) -> None:
    line = next(line for line in OWN.splitlines() if f"def {method}(" in line)
    (tmp_path / "mine.py").write_text(OWN.replace(line, f"{line}\n        1 / 0"))
    (tmp_path / "program.py").write_text("solver.east_of(potted_plant[0], x=2.5)\n")
    files = ("--constraints", str(tmp_path / "mine.py"), "--program", str(tmp_path / "program.py"))
    ran = run(tmp_path, "examples/bedroom.json", "--no-pictures", *files)
    at = (tmp_path / "mine.py").read_text().splitlines().index("        1 / 0") + 1
    assert ran.returncode == 2 and not (tmp_path / "out").exists()
    assert f"{tmp_path / 'mine.py'}, line {at}, in {method}: ZeroDivisionError: division by zero" in ran.stderr
