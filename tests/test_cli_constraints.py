"""`--constraints FILE`: a constraint of the user's own from the command line, in a process of its own."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

from running import ROOT

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


def run(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "robolayout", "generate", *words, "--out", str(folder / "out"), "--quiet"]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


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
