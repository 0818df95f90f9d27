"""The planner that reads a file."""

from pathlib import Path

import pytest

from robolayout._errors import ProgramError
from robolayout.planners import FilePlanner, PlanRequest
from robolayout.scene import load_scene

SCENE = load_scene(Path(__file__).parents[2] / "examples" / "bedroom.json")


def test_it_answers_with_the_file(tmp_path: Path) -> None:
    path = tmp_path / "program.py"
    path.write_text("solver.against_wall(double_bed[0], walls[2])\n")
    planner = FilePlanner(path)
    assert planner.plan(PlanRequest(SCENE)) == path.read_text()
    assert set(planner.group(SCENE)[0].items) == set(SCENE.by_name)


def test_missing_binary_and_huge_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ProgramError, match=r"the program .*nothing\.py does not exist; check the path"):
        FilePlanner(tmp_path / "nothing.py").plan(PlanRequest(SCENE))
    path = tmp_path / "program.py"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ProgramError, match="not UTF-8"):
        FilePlanner(path).plan(PlanRequest(SCENE))
    path.write_bytes(b"#" * 2_000_001)
    with pytest.raises(ProgramError, match="larger than 2 MB"):
        FilePlanner(path).plan(PlanRequest(SCENE))
