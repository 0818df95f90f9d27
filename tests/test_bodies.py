"""Bodies on the command line and in the files of a run: drawings, several at once, and what is wrong with them."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest

import robolayout as rl
from robolayout.page.marks import plan_marks
from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene, layout_from_dict, load_agent
from robolayout.verify import judge_agent, verify
from running import ROOT, Ran

Command = Callable[..., Ran]

ROOM = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.6, (Opening(0, 1.5, 0.95, 2.05),))
BED = Asset("bed-0", "bed", (2.1, 1.4, 0.9))
SHELF = Asset("bookshelf-0", "bookshelf", (0.3, 0.9, 1.9))
URDF = """<robot name="cart"><link name="base"><collision><geometry><box size="0.6 0.4 0.5"/></geometry></collision></link>
</robot>"""


def test_a_body_is_drawn_to_a_file_or_the_terminal(command: Command, tmp_path: Path) -> None:
    shown = command("agents", "unitree_g1")
    assert shown.code == 0 and "mujoco_menagerie" in shown.out and "\u2800" in shown.out
    for suffix, start in ((".svg", b"<svg"), (".png", b"\x89PNG"), (".pdf", b"%PDF")):
        target = tmp_path / f"body{suffix}"
        assert command("agents", "wheelchair", "--out", target).code == 0
        assert target.read_bytes().startswith(start)
    wrong = command("agents", "wheelchair", "--out", tmp_path / "body.gif")
    assert wrong.code == 2 and "name a file that ends in .svg or .png or .pdf" in wrong.err
    assert "name it, such as" in command("agents", "--out", tmp_path / "body.svg").err


def test_a_users_own_file_and_a_urdf_are_shown_too(command: Command, tmp_path: Path) -> None:
    toml, urdf = tmp_path / "mine.toml", tmp_path / "cart.urdf"
    toml.write_text("radius = 0.3\nheight = { value = 1.1, source = 'measured', verified = true }\n")
    urdf.write_text(URDF)
    mine = command("agents", toml).out
    assert "measured" in mine and "given without a source" in mine
    assert "URDF model cart" in command("agents", urdf).out


@pytest.mark.slow
def test_one_layout_serves_several_bodies_each_with_its_report_and_plan(command: Command, tmp_path: Path) -> None:
    (tmp_path / "cart.urdf").write_text(URDF)
    bodies = f"wheelchair,child_6,{tmp_path / 'cart.urdf'}"
    ran = command("generate", ROOT / "examples" / "bedroom.json", "--agent", bodies, "--out", tmp_path / "out")
    assert ran.code == 0, ran
    report = json.loads((tmp_path / "out" / "report.json").read_text())
    assert list(report["agents"]) == ["wheelchair", "child_6", "cart"]
    for figure in ("walkable_ratio", "reachable_share", "usable_share"):
        assert report[figure] == min(body[figure] for body in report["agents"].values())
    for file, name in (
        ("plan.svg", "wheelchair user"),
        ("plan_2_child_6.svg", "child of 6"),
        ("plan_3_cart.svg", "cart"),
    ):
        assert name in "".join(ElementTree.parse(tmp_path / "out" / file).getroot().itertext())
    page = (tmp_path / "out" / "report.md").read_text()
    assert page.count("| asset | reached |") == 3 and "It can turn right round in" in page


def test_a_plan_shows_what_is_free_under_a_bed_and_its_legs() -> None:
    scene = Scene(ROOM, (BED,))
    layout = Layout({"bed-0": Pose(2.0, 2.6, 0.45, 0.0)})
    low = plan_marks(judge_agent(scene, layout, load_agent("robot_vacuum")))
    assert low.under and len(low.parts) >= 2 and not low.circles and not low.arcs
    tall = plan_marks(judge_agent(scene, layout, load_agent("wheelchair")))
    assert not tall.under and not tall.parts
    ((_, diameter),) = tall.circles
    assert diameter == pytest.approx(1.525)


def test_a_plan_shows_how_far_an_arm_reaches() -> None:
    scene = Scene(ROOM, (SHELF,))
    layout = Layout({"bookshelf-0": Pose(0.15, 2.5, 0.95, 0.0)})
    (arc,) = plan_marks(judge_agent(scene, layout, load_agent("adult"))).arcs
    stand, *edge = arc
    assert all(0.0 <= x <= 4.0 for x, _ in edge)
    assert max((x - stand[0]) ** 2 + (y - stand[1]) ** 2 for x, y in edge) <= 0.65**2 + 1e-9


def test_a_book_on_a_high_shelf_is_out_of_a_wheelchairs_reach_by_so_much() -> None:
    book = Asset("book-0", "book", (0.2, 0.15, 0.04), on_floor=False, on_object=True)
    scene = Scene(ROOM, (SHELF, book))
    layout = Layout({"bookshelf-0": Pose(0.15, 2.5, 0.95, 0.0), "book-0": Pose(0.15, 2.5, 1.92, 0.0)})
    assert verify(scene, layout, agent="wheelchair").violations == (
        "book-0 cannot be used by wheelchair: it begins 1.90 m high, reach ends at 1.22 m: 0.68 m too high.",
    )
    assert verify(scene, layout, agent="adult").ok


def test_the_planner_puts_a_book_where_a_wheelchair_user_gets_it() -> None:
    boxes = {"bookshelf": (0.3, 0.9, 1.9), "desk": (0.7, 1.3, 0.74), "book": (0.2, 0.15, 0.04)}
    assets = {
        f"{name}-0": {
            "category": name,
            "onFloor": name != "book",
            "onObject": name == "book",
            "assetMetadata": {"boundingBox": dict(zip("xyz", size, strict=True))},
        }
        for name, size in boxes.items()
    }
    corners = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]
    given = rl.scene_from_dict({"boundary": {"floor_vertices": corners, "wall_height": 2.6}, "assets": assets})
    from robolayout.planners import OfflinePlanner, PlanRequest

    text = OfflinePlanner().plan(PlanRequest(given.with_agents(load_agent("wheelchair"))))
    assert "solver.on_top_of(book[0], desk[0])" in text


# What is wrong with a body, each with its sentence.


@pytest.mark.parametrize(
    ("room", "agent", "sentence"),
    [
        (
            Room(ROOM.vertices, 2.6, (Opening(0, 1.5, 0.6, 2.05),)),
            load_agent("wheelchair"),
            "Door 0 is 0.60 m wide, wheelchair needs 0.76 m: it cannot come in.",
        ),
        (
            Room(((0, 0), (4, 0), (4, 4), (2, 4), (2, 0.5), (0, 0.5)), 2.6, (Opening(0, 0.2, 0.9, 2.05),)),
            load_agent("adult"),
            "Even in the empty room adult cannot come in by door 0: the room leaves a disc of 0.50 m the way in, "
            "adult needs 0.61 m.",
        ),
        (
            ROOM,
            Agent("crane", 0.3, 2.9),
            "The room is 2.60 m high, crane is 2.90 m: it cannot stand in it.",
        ),
    ],
    ids=["door too narrow", "door blocked from outside the floor", "higher than the room"],
)
def test_bodies_that_do_not_fit(room: Room, agent: Agent, sentence: str) -> None:
    report = verify(Scene(room, (SHELF,)), layout_from_dict({}), agent=agent)
    assert sentence in report.agents[0].violations and not report.ok


def test_bodies_that_are_no_bodies(command: Command, tmp_path: Path) -> None:
    bedroom = ROOT / "examples" / "bedroom.json"
    for text, sentence in (
        ("radius = 0\nheight = 1.0\n", "radius is 0: a point has no body"),
        ("radius = 0.3\nheight = 2.8\n", "is 2.80 m high, but the room only 2.60 m"),
        ("radius = 0.3\nheight = 1.0\nwidht = 0.5\n", "has the unknown key 'widht'"),
    ):
        (tmp_path / "body.toml").write_text(text)
        ran = command("generate", bedroom, "--agent", tmp_path / "body.toml", "--out", tmp_path / "out")
        assert ran.code == 2 and sentence in ran.err, ran


def test_without_a_door_the_report_says_where_the_body_starts() -> None:
    scene = Scene(Room(ROOM.vertices, 2.6), (SHELF,))
    report = verify(scene, Layout({"bookshelf-0": Pose(0.15, 2.5, 0.95, 0.0)}), agent="adult")
    assert report.ok
    assert "The room has no door: adult starts in the largest free part of the floor." in report.to_markdown()


@pytest.mark.slow
def test_in_a_simulator_a_vacuum_cleaner_drives_under_a_bed_and_a_taller_robot_hits_it() -> None:
    """A bed across a narrow room: the only way to the box behind leads under it."""
    pytest.importorskip("mujoco")
    from robolayout.export import drive

    room = Room(((0, 0), (2.3, 0), (2.3, 5), (0, 5)), 2.6, (Opening(0, 0.7, 0.9, 2.05),))
    box = Asset("box-0", "box", (0.4, 0.4, 0.5))
    scene = Scene(room, (BED, box))
    layout = Layout({"bed-0": Pose(1.15, 2.5, 0.45, 0.0), "box-0": Pose(1.15, 4.5, 0.25, 0.0)})
    vacuum = load_agent("robot_vacuum")
    report = judge_agent(scene, layout, vacuum)
    assert report.navigation.reached["box-0"]
    routes = {"box-0": report.navigation.routes["box-0"].points}
    assert not drive(scene, layout, vacuum, routes).contacts
    tall = Agent("tall", vacuum.radius, 0.5, step=vacuum.step)
    assert not judge_agent(scene, layout, tall).navigation.reached["box-0"]
    assert "bed-0" in str(drive(scene, layout, tall, routes).contacts)


def test_a_room_is_arranged_so_that_a_body_that_cannot_slide_sideways_drives_to_what_it_uses() -> None:
    """As first built, the robot could stand beside five things of this bedroom and drive to none of them."""
    report = rl.generate(ROOT / "examples" / "tasks" / "bedroom_small.json", agent="amr").report
    assert report.ok and not report.agents[0].usage.undriven
