"""The offline planner says, the solver builds: sensible rooms, checked by the exact judge before any search."""

import json
from pathlib import Path

import pytest

from robolayout.planners import OfflinePlanner, PlanRequest
from robolayout.program import read_program, reconcile
from robolayout.scene import Layout, Scene, load_scene, scene_from_dict
from robolayout.solve import compile_problem
from robolayout.verify import verify
from running import slow

EXAMPLES = Path(__file__).parents[2] / "examples"
PLANNER = OfflinePlanner()


def built(scene: Scene, text: str, seed: int = 0, placed: Layout | None = None) -> Layout:
    program = reconcile(read_program(text, scene), scene).program
    return compile_problem(scene, program, seed=seed, pinned=placed).guess


def room(assets: dict, *, width=4.0, depth=5.0, door=True) -> Scene:
    return scene_from_dict(
        {
            "task_description": "",
            "layout_criteria": "",
            "boundary": {
                "floor_vertices": [[0, 0, 0], [width, 0, 0], [width, depth, 0], [0, depth, 0]],
                "wall_height": 2.6,
            },
            "doors": [{"wall": 0, "offset": width - 1.2, "width": 0.9, "height": 2.05}] if door else [],
            "assets": assets,
        }
    )


def asset(category: str, size: tuple[float, float, float], flag: str = "onFloor", description: str = "") -> dict:
    flags = {key: key == flag for key in ("onFloor", "onWall", "onCeiling", "onObject")}
    box = dict(zip("xyz", size, strict=True))
    return {"category": category, "description": description, **flags, "assetMetadata": {"boundingBox": box}}


@pytest.mark.slow
@pytest.mark.parametrize("name", [slow("bedroom"), slow("living_room"), "dining_room", slow("studio")])
def test_examples_are_good_before_anything_is_solved(name: str) -> None:
    scene = load_scene(EXAMPLES / f"{name}.json")
    text = PLANNER.plan(PlanRequest(scene))
    program = read_program(text, scene)
    report = verify(scene, built(scene, text), program).to_dict()
    assert report["placed_share"] == 1.0
    assert report["collision_free_share"] == 1.0
    assert report["in_boundary_share"] == 1.0
    assert report["door_clear"]
    assert report["statements_met_share"] >= 0.97
    assert report["reachable_share"] == 1.0
    assert all(decision.verdict == "accepted" for decision in reconcile(program, scene).decisions)


def test_the_bed_has_its_head_at_a_wall_and_night_stands_on_both_sides() -> None:
    scene = load_scene(EXAMPLES / "bedroom.json")
    text = PLANNER.plan(PlanRequest(scene))
    assert "solver.against_wall(double_bed[0])" in text
    assert "solver.wish.symmetric_pair(night_stand[" in text
    assert ".position" not in text
    assert text.count("solver.on_top_of(table_lamp[") == 2


def test_plates_lie_before_their_chairs_and_face_as_the_guest_does() -> None:
    scene = load_scene(EXAMPLES / "dining_room.json")
    layout = built(scene, PLANNER.plan(PlanRequest(scene)))
    for i in range(4):
        plate = layout[f"plate-{i}"]
        chair = min(
            (layout[f"dining_chair-{k}"] for k in range(4)), key=lambda c: abs(c.x - plate.x) + abs(c.y - plate.y)
        )
        ahead = (plate.x - chair.x) * chair.forward[0] + (plate.y - chair.y) * chair.forward[1]
        assert 0.2 < ahead < 0.6
        assert plate.forward == pytest.approx(chair.forward, abs=0.01)


@pytest.mark.slow
def test_the_sofa_looks_at_the_television() -> None:
    scene = load_scene(EXAMPLES / "living_room.json")
    layout = built(scene, PLANNER.plan(PlanRequest(scene)))
    sofa, screen = layout["sofa-0"], layout["tv_stand-0"]
    distance = ((screen.x - sofa.x) ** 2 + (screen.y - sofa.y) ** 2) ** 0.5
    ahead = (screen.x - sofa.x) * sofa.forward[0] + (screen.y - sofa.y) * sofa.forward[1]
    assert ahead > 0.95 * distance
    assert 1.8 < distance < 4.6


def test_pupils_look_at_the_board_and_have_chairs() -> None:
    scene = load_scene(EXAMPLES / "tasks" / "classroom_small.json")
    layout = built(scene, PLANNER.plan(PlanRequest(scene)))
    board = layout["whiteboard-0"]
    for i in range(6):
        chair = layout[f"school_chair-{i}"]
        ahead = (board.x - chair.x) * chair.forward[0] + (board.y - chair.y) * chair.forward[1]
        assert ahead > 1.0
        assert chair.forward[0] * board.forward[0] + chair.forward[1] * board.forward[1] == pytest.approx(
            -1.0, abs=1e-3
        )


def test_what_nobody_knows_is_placed_by_flags_size_and_shape() -> None:
    scene = room(
        {
            "zorb-0": asset("zorb", (0.5, 0.8, 1.9)),
            "fleem-0": asset("fleem", (0.2, 0.2, 0.2), "onObject"),
            "blick-0": asset("blick", (0.04, 0.5, 0.5), "onWall"),
            "quux-0": asset("quux", (0.4, 0.4, 0.3), "onCeiling"),
            "table-0": asset("table", (0.8, 1.2, 0.75)),
        }
    )
    text = PLANNER.plan(PlanRequest(scene))
    assert "solver.against_wall(zorb[0]" in text
    assert "solver.on_top_of(fleem[0], table[0])" in text
    assert "solver.mounted_on(blick[0]" in text
    layout = built(scene, text)
    assert layout["quux-0"].z == pytest.approx(2.6 - 0.15, abs=0.01)
    assert verify(scene, layout).to_dict()["collision_free_share"] == 1.0


def test_hostile_descriptions_never_enter_the_program() -> None:
    evil = '"""\nimport os\nsolver.zone("x")\n# `rm` {a} {b} \\'
    scene = room({"bed-0": asset("double bed", (2.0, 1.6, 0.9), description=evil)})
    text = PLANNER.plan(PlanRequest(scene))
    assert "import" not in text
    assert read_program(text, scene).statements


@pytest.mark.slow
def test_a_group_is_planned_around_what_stands_already() -> None:
    scene = load_scene(EXAMPLES / "bedroom.json")
    groups = PLANNER.group(scene)
    first = PLANNER.plan(PlanRequest(scene, group=groups[0]))
    placed = Layout({n: p for n, p in built(scene, first).items() if n in groups[0].items})
    second = PLANNER.plan(PlanRequest(scene, group=groups[1], placed=placed))
    program = read_program(second, scene)
    said = {one.relation.asset_names()[0] for one in (*program.statements, *program.wishes)}
    assert said == set(groups[1].items)
    both = built(scene, second, placed=placed)
    assert all(both[name] == pose for name, pose in placed.items())
    assert [v for v in verify(scene, both).violations if "overlap" in v] == []


def test_groups_hold_everything_once_structural_first_decorative_last() -> None:
    scene = load_scene(EXAMPLES / "studio.json")
    groups = PLANNER.group(scene)
    items = [name for group in groups for name in group.items]
    assert sorted(items) == sorted(a.name for a in scene.assets)
    labels = [group.label for group in groups]
    assert labels[0] == "sleeping"
    assert labels[-1] == "decoration"
    sleeping = groups[0]
    assert sleeping.items.index("double_bed-0") < sleeping.items.index("night_stand-0")
    assert "night_stand-0 beside double_bed-0" in sleeping.relations
    assert json.dumps(sleeping.to_dict())


@pytest.mark.slow
def test_another_seed_leads_to_another_room() -> None:
    scene = load_scene(EXAMPLES / "bedroom.json")
    text = PLANNER.plan(PlanRequest(scene))
    assert built(scene, text) == built(scene, text)
    assert built(scene, text) != built(scene, text, seed=1000)


def test_an_overfull_room_still_gets_a_program() -> None:
    scene = room({f"wardrobe-{i}": asset("wardrobe", (0.6, 1.5, 2.1)) for i in range(9)}, width=3.0, depth=3.0)
    text = PLANNER.plan(PlanRequest(scene))
    assert not read_program(text, scene).forgotten()
    assert len(built(scene, text)) == 9
