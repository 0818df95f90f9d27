"""The whole flow from Python: same input, same layout; what comes back says how it was made."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import robolayout as rl
from robolayout._errors import ProgramError, SceneError
from robolayout.planners import OfflinePlanner, PlanRequest
from robolayout.run import bettering
from robolayout.run.flow import Run
from robolayout.scene import Layout, Opening, layout_from_dict
from robolayout.verify import Report
from running import ROOT, Furnished

TINY = {
    "boundary": {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5},
    "doors": [{"wall": 0, "offset": 0.1, "width": 0.9, "height": 2.05}],
    "assets": {
        "desk-0": {"category": "desk", "onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.74}}},
        "lamp-0": {"category": "desk lamp", "onObject": True, "assetMetadata": {"boundingBox": {"x": 0.2, "y": 0.2, "z": 0.4}}},
    },
}  # fmt: skip


@pytest.mark.slow
def test_the_layout_is_that_of_the_command_line_with_or_without_pictures(furnished: Furnished) -> None:
    result = rl.generate(furnished.scene, agent="wheelchair", seed=0)
    assert result.layout.to_dict() == json.loads((furnished.folder / "layout.json").read_text())
    assert result.program.text == (furnished.folder / "program.py").read_text()
    assert not result.trace.losses, "no trace unless asked for"
    again = rl.generate(furnished.scene, agent="wheelchair", seed=0, program=result.program.text)
    assert again.layout.to_dict() == result.layout.to_dict(), "a given program is solved as a planned one is"
    assert set(result.report.timing) >= {"scene", "plan", "program", "solve", "verify"}
    assert all(seconds["wall"] >= 0 and seconds["cpu"] >= 0 for seconds in result.report.timing.values())


@pytest.mark.slow
@pytest.mark.parametrize(("hash_seed", "threads"), [("1", "1"), ("77", "2")])
def test_hash_seed_and_threads_do_not_matter(furnished: Furnished, hash_seed: str, threads: str) -> None:
    code = (
        "import json, sys, robolayout as rl\n"
        f"result = rl.generate({str(furnished.scene)!r}, agent='wheelchair', seed=0)\n"
        "sys.stdout.write(json.dumps(result.layout.to_dict(), indent=2) + '\\n')"
    )
    import os

    flags = f"--xla_cpu_multi_thread_eigen={'true' if threads == '2' else 'false'}"
    environment = os.environ | {"PYTHONHASHSEED": hash_seed, "OMP_NUM_THREADS": threads, "XLA_FLAGS": flags}
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True, env=environment)
    assert done.stdout == (furnished.folder / "layout.json").read_text()


def test_a_scene_may_be_a_dictionary_and_an_agent_too() -> None:
    heard: list[str] = []
    body = {"name": "cart", "radius": 0.25, "height": 1.0, "reach": 0.8}
    result = rl.generate(TINY, agent=body, seed=3, progress=heard.append)
    assert set(result.layout) == {"desk-0", "lamp-0"}
    assert result.scene.agent.name == "cart"
    assert result.report.ok, result.report.violations
    assert heard[0] == "plan" and heard[-1] == "verify"
    assert result.report.to_dict()["agents"].keys() == {"cart"}


@pytest.mark.parametrize("seed", [-1, 0.5, "a"])
def test_a_seed_that_is_none_is_refused(seed: int) -> None:
    with pytest.raises(rl.InputError, match=f"seed must be a whole number of at least 0, but is {seed!r}"):
        rl.generate("examples/bedroom.json", seed=seed)


def test_pinned_things_stay() -> None:
    scene = rl.scene_from_dict(TINY)
    there = rl.Pose(2.6, 1.7, 0.37, 3.141592653589793)
    solution = rl.solve(scene, "solver.on_top_of(lamp[0], desk[0])", pinned={"desk-0": there})
    desk = solution.layout["desk-0"]
    assert (desk.x, desk.y) == pytest.approx((there.x, there.y), abs=1e-6)
    assert rl.verify(scene, solution.layout).figures["supported_share"] == 1.0


def test_the_report_measures_what_was_asked_not_what_was_left_of_it() -> None:
    text = "solver.against_wall(desk[0], walls[1])\nsolver.against_wall(desk[0], walls[3])"
    result = rl.generate(TINY, program=text)
    assert [decision.verdict for decision in result.reconciled.decisions] == ["accepted", "rejected"]
    assert [statement.met for statement in result.report.statements] == [True, False]
    assert not result.report.ok


def test_every_example_reads_without_a_warning_about_its_room_or_its_flags() -> None:
    for path in sorted((ROOT / "examples").rglob("*.json")):
        warnings = rl.load_scene(path).warnings
        assert all("is called" in warning for warning in warnings), (path, warnings)


def test_another_program_is_asked_for_where_a_thing_stands_too_high_for_the_body() -> None:
    """The solver cannot lower what a program puts on a high top, and calls its work done; the report does not."""
    assets = {
        "bookshelf-0": {"category": "bookshelf", "onFloor": True, "size": [0.3, 0.9, 1.9]},
        "night_stand-0": {"category": "night stand", "onFloor": True, "size": [0.4, 0.5, 0.5]},
        "clock-0": {"category": "alarm clock", "onObject": True, "size": [0.1, 0.15, 0.1]},
    }
    for asset in assets.values():
        asset["assetMetadata"] = {"boundingBox": dict(zip("xyz", asset.pop("size"), strict=True))}
    told: list[str] = []

    class Two(OfflinePlanner):
        """Writes a bad program first."""

        def plan(self, request: PlanRequest) -> str:
            told.append(request.feedback)
            return f"solver.on_top_of(clock[0], {'night_stand' if len(told) > 1 else 'bookshelf'}[0])"

    result = rl.generate(TINY | {"assets": assets}, agent="child_6", planner=Two())
    assert len(told) == 2 and result.report.ok, result.report.violations
    assert result.layout["clock-0"].z < 1.0


@pytest.mark.slow
def test_no_fourth_program_is_asked_for_where_three_are_hopeless() -> None:
    size = {"boundingBox": {"x": 0.9, "y": 1.4, "z": 2.0}}
    many = {f"wardrobe-{i}": {"category": "wardrobe", "onFloor": True, "assetMetadata": size} for i in range(6)}
    asked: list[int] = []

    class Ever(OfflinePlanner):
        """Writes ever another program."""

        def plan(self, request: PlanRequest) -> str:
            asked.append(request.seed)
            return f"solver.against_wall(wardrobe[{len(asked)}], walls[0])"

    result = rl.generate(TINY | {"assets": many}, planner=Ever(), attempts=4)
    assert len(asked) == 3
    assert not result.report.ok and set(result.layout) == set(many)


def test_what_a_program_forgets_is_said() -> None:
    report = rl.generate(TINY, program="# nothing").report
    assert report.notes == ("The program says nothing about desk[0], lamp[0].",), report.notes


def test_what_of_a_program_was_read_otherwise_than_it_is_written_is_said() -> None:
    program = "desk[0].position = [2, 2, 0.37]\ndesk[0].rotation = [0, 0, 90]\nsolver.on_top_of(lamp[0], desk[0])\n"
    result = rl.generate(TINY, program=program)
    assert result.report.notes[0].startswith("Rotations of line 2 were read as degrees: three numbers are radians")
    assert result.layout["desk-0"].yaw == pytest.approx(math.pi / 2)


def test_a_scene_for_nobody_is_refused() -> None:
    with pytest.raises(rl.RoboLayoutError, match="agents is empty; name at least one body"):
        replace(rl.scene_from_dict(TINY), agents=())


@pytest.mark.parametrize(
    ("solver", "wall"), [("paper", "walls[1]"), ("default", "walls[0]"), ("trust-constr", "walls[0]")]
)
def test_only_the_papers_solver_filters_as_the_paper_does(solver, wall):
    room = {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5}
    box = {"category": "dresser", "onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.5, "y": 0.9, "z": 0.8}}}
    program = "dresser[0].position = [2.6, 1.6, 0.4]\nsolver.against_wall(dresser[0], walls[0])\n"
    result = rl.generate({"boundary": room, "assets": {"dresser-0": box}}, program=program, solver=solver)
    assert [s.relation.sentence() for s in result.reconciled.program.statements] == [f"against_wall(dresser-0, {wall})"]
    assert result.report.statements[0].sentence.startswith("against_wall(dresser-0, walls[0])"), "judged as asked"


def test_a_room_too_large_for_fine_cells_says_how_it_was_searched() -> None:
    wide = TINY | {"boundary": {"floor_vertices": [[0, 0, 0], [60, 0, 0], [60, 60, 0], [0, 60, 0]], "wall_height": 2.5}}
    report = rl.generate(wide).report
    (note,) = report.to_dict()["notes"]
    assert note.startswith("The room is so large that the search looks for ways on cells of 0.55 m: ")
    assert note in report.to_markdown()
    assert "notes" not in rl.generate(TINY).report.to_dict()


def test_a_second_door_that_a_guess_leaves_no_room_at_is_opened() -> None:
    """Two shelves stand flush with the edges of the second door: 0.90 m, where a wheelchair user needs 0.915 m."""
    shelf = {"category": "bookshelf", "onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.9, "y": 0.8, "z": 1.8}}}
    doors = [{"wall": wall, "offset": 1.55, "width": 0.9, "height": 2.05} for wall in (0, 2)]
    floor = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]
    scene = {
        "boundary": {"floor_vertices": floor, "wall_height": 2.5},
        "doors": doors,
        "assets": {"shelf-0": shelf, "shelf-1": shelf},
    }
    places = ((1.15, 3.54), (2.85, 3.54))
    guess = [f"shelf[{i}].position = [{x}, {y}, 0.9]\nshelf[{i}].rotation = [270]" for i, (x, y) in enumerate(places)]
    program = "\n".join([*guess, *(f"solver.against_wall(shelf[{i}], walls[2])" for i in range(2))])
    poses = {f"shelf-{i}": {"position": [x, y, 0.9], "rotation": [0, 0, 270]} for i, (x, y) in enumerate(places)}
    before = rl.verify(rl.scene_from_dict(scene), layout_from_dict(poses), agent="wheelchair")
    assert before.unmet == ("doors_reached",)
    result = rl.generate(scene, agent="wheelchair", program=program)
    assert result.report.ok, result.report.violations
    moved = [abs(result.layout[name].x - x) for name, (x, _) in zip(("shelf-0", "shelf-1"), places, strict=True)]
    assert 0.01 < max(moved) < 1.0


@pytest.mark.parametrize("seed", [0, 1, 3])
def test_a_corner_that_leaves_room_for_the_others_is_found_whatever_the_seed(seed: int) -> None:
    """Of the two corners at the wall only one has room at the right of the bed."""
    floor = [[0, 0, 0], [4, 0, 0], [4, 2.5, 0], [2.5, 2.5, 0], [2.5, 4.5, 0], [0, 4.5, 0]]
    sizes = {"bed-0": (2.0, 1.4, 0.5), "night_stand-0": (0.4, 0.45, 0.55)}
    assets = {
        name: {
            "category": name[:-2].replace("_", " "),
            "onFloor": True,
            "assetMetadata": {"boundingBox": dict(zip("xyz", size, strict=True))},
        }
        for name, size in sizes.items()
    }
    scene = {
        "boundary": {"floor_vertices": floor, "wall_height": 2.6},
        "doors": [{"wall": 0, "offset": 2.9, "width": 0.9, "height": 2.05}],
        "agent": {"radius": 0.25, "height": 1.4},
        "assets": assets,
    }
    program = (
        "solver.against_wall(bed[0], walls[5])\nsolver.corner(bed[0])\n"
        'solver.next_to(night_stand[0], bed[0], "right")\n'
    )
    report = rl.generate(scene, program=program, seed=seed).report
    assert report.ok, report.violations


def test_other_ways_are_not_tried_for_a_drawer_that_stays_shut(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = rl.load_scene("examples/bedroom.json")
    found = rl.generate(scene)
    program, best = found.reconciled.program, replace(found.solution, verdict=replace(found.solution.verdict, soft=0.5))
    monkeypatch.setattr(bettering, "compile_problem", lambda *_, **__: pytest.fail("a way was built"))
    assert bettering.bettered(scene, program, best, seed=0, config=None) is best


@pytest.mark.slow
def test_what_a_program_forgets_stands_as_is_usual() -> None:
    scene = rl.load_scene(ROOT / "examples" / "bedroom.json")
    program = "solver.against_wall(double_bed[0], walls[1])"
    result = rl.generate(scene, program=program)

    def apart(first: str, second: str) -> float:
        one, other = result.layout[first], result.layout[second]
        return math.dist((one.x, one.y), (other.x, other.y))

    stands = ("night_stand-0", "night_stand-1")
    assert all(apart(stand, "double_bed-0") < 1.7 for stand in stands) and apart(*stands) > 1.7
    assert all(min(apart(lamp, stand) for stand in stands) < 0.2 for lamp in ("table_lamp-0", "table_lamp-1"))
    assert [item.met for item in result.report.statements] == [True]
    assert {wish.by for wish in result.program.wishes} == {"custom"}
    assert not rl.generate(scene, program=program, solver="paper").program.wishes


SQUARE = ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
BED = rl.Asset("my bed", "bed", (2.0, 1.6, 0.5))


@pytest.mark.parametrize(
    ("room", "asset", "message"),
    [
        ({}, {"size": (-1.0, 1.0, 1.0)}, r"asset 'my bed': depth \(boundingBox.x\) must be above 0, but is -1.0"),
        ({}, {"size": (math.nan, 1.0, 1.0)}, "must be a finite number, but is nan"),
        ({"wall_height": 0.0}, {}, "boundary.wall_height must be above 0, but is 0.0"),
        ({"vertices": (SQUARE[0], SQUARE[2], SQUARE[1], SQUARE[3])}, {}, "walls 0 and 2 cross or touch"),
        ({"doors": (Opening(0, 3.5, 0.9, 2.05),)}, {}, "ends at 4.400 m, past the end of wall 0"),
    ],
)
def test_a_scene_made_by_hand_is_refused_as_its_file_would_be(room, asset, message) -> None:
    scene = rl.Scene(replace(rl.Room(SQUARE, 2.5), **room), (replace(BED, **asset),))
    with pytest.raises(SceneError, match=message):
        rl.generate(scene)


def test_a_clockwise_room_made_by_hand_is_turned_around_with_its_doors_and_its_numbers_may_be_numpys() -> None:
    corners = tuple((np.float32(x), np.float64(y)) for x, y in SQUARE[::-1])
    room = rl.Room(corners, np.float32(2.5), (Opening(np.int64(0), np.float32(1.0), 0.9, 2.05),))  # type: ignore[arg-type]
    found = rl.generate(rl.Scene(room, (BED,)), attempts=1, config=rl.SolverConfig(starts=1))
    assert "ran clockwise" in found.scene.warnings[-1]
    assert found.scene.room.area == 16.0 and type(found.scene.room.wall_height) is float
    door = found.scene.room.doors[0]
    middle = found.scene.room.walls[door.wall].point(door.center)
    assert middle == (pytest.approx(1.45), 4.0), "in the upper wall, where it was said to be"


def test_two_things_of_one_name_are_no_scene() -> None:
    with pytest.raises(SceneError, match="two assets are called 'my bed'; give each its own name"):
        rl.Scene(rl.Room(SQUARE, 2.5), (BED, BED))


@pytest.mark.parametrize("attempts", [0, -1, 1.5, "two"])
def test_attempts_are_counted(attempts: int) -> None:
    with pytest.raises(rl.InputError, match="attempts must be a whole number of at least 1, but is "):
        rl.generate(rl.Scene(rl.Room(SQUARE, 2.5), (BED,)), attempts=attempts)


def test_what_is_no_body_is_named() -> None:
    with pytest.raises(rl.InputError, match="the agent must be an object with named values, but is 3"):
        rl.generate(rl.Scene(rl.Room(SQUARE, 2.5), (BED,)), agent=3)  # type: ignore[arg-type]


def test_a_program_is_given_as_text_itself_or_its_file(tmp_path: Path) -> None:
    scene = rl.Scene(rl.Room(SQUARE, 2.5), (BED,))
    text = "my_bed[0].position = [1.2, 2.0, 0.25]\nsolver.against_wall(my_bed[0], walls[1])\n"
    (tmp_path / "program.py").write_text(text, encoding="utf-8")
    ways = (text, rl.read_program(text, scene), tmp_path / "program.py")
    found = [rl.generate(scene, program=way, config=rl.SolverConfig(starts=1)) for way in ways]
    assert found[0].layout["my bed"].x == pytest.approx(2.99, abs=0.02), "its head at the right wall"
    assert [one.layout for one in found] == [found[0].layout] * 3
    judged = [rl.judge(scene, found[0].layout, way).report.statements for way in ways]
    assert [(one.sentence, one.met) for (one,) in judged] == [("against_wall(my bed, walls[1])", True)] * 3


def test_missing_binary_and_huge_programs_are_refused(tmp_path: Path) -> None:
    scene, path = rl.Scene(rl.Room(SQUARE, 2.5), (BED,)), tmp_path / "program.py"
    with pytest.raises(ProgramError, match=r"the program .*program\.py does not exist; check the path"):
        rl.generate(scene, program=path)
    for content, fault in ((b"\xff\xfe\x00", "not UTF-8"), (b"#" * 2_000_001, "larger than 2 MB")):
        path.write_bytes(content)
        with pytest.raises(ProgramError, match=fault):
            rl.generate(scene, program=path)


@pytest.mark.parametrize("x", [math.nan, 1e300])
def test_a_pose_that_no_file_may_give_is_judged_as_none(x: float) -> None:
    scene = rl.load_scene(ROOT / "examples" / "bedroom.json")
    report = rl.judge(scene, rl.Layout({"double_bed-0": rl.Pose(x, 0.0, 0.0, 0.0)})).report
    assert report.figures["placed_share"] == 0.0 and "double_bed-0 is not placed." in report.violations


def test_comparing_takes_bodies_as_generate_does() -> None:
    found = rl.compare(rl.Scene(rl.Room(SQUARE, 2.5), (BED,)), "cat,child_6", config=rl.SolverConfig(starts=1))
    assert [one.scene.agent.name for one in found] == ["cat", "child_6"]


def test_another_program_is_tried_where_words_ask_for_more_than_its_statements(monkeypatch: pytest.MonkeyPatch) -> None:
    """A way that words ask for is no statement: every chair of a cafe was to be reached, and one was not."""
    looked: list[Layout] = []

    def meant(_: Run, layout: Layout, report: Report) -> bool:
        looked.append(layout)
        return len(looked) > 1

    monkeypatch.setattr(Run, "_meant", meant)
    result = rl.generate(ROOT / "examples" / "bedroom.json", seed=0)
    assert len(looked) == 2 and result.layout == looked[1]
