"""What a model is shown: the room as it stands, the things to place, and what came of its program."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from robolayout.page.marks import plan_marks
from robolayout.planners import Pictures
from robolayout.program import Program
from robolayout.render import Studio, annotate, model_plan, png_bytes, render_asset
from robolayout.scene import Layout, Pose, Scene
from robolayout.verify import Report, judge_agent

VIEWS = ("top", "side")  # the paper's annotated views
PICTURE_SIZE = 768  # pixels of a side of the pictures of a finished room


def room_pictures(scene: Scene, layout: Layout, new: Sequence[str], pictures: Pictures) -> dict[str, bytes]:
    """Return plan and annotated views of a room and a picture per kind of thing to place; "named": names without bytes; "none": nothing."""
    kinds = sorted({scene.by_name[name].variable: name for name in reversed(new)}.values())
    if pictures != "drawn":
        return {} if pictures == "none" else dict.fromkeys(("plan", *VIEWS, *kinds), b"")
    body = scene.agents[0]
    marks = plan_marks(judge_agent(scene, layout, body))
    images = {"plan": png_bytes(model_plan(scene, layout, marks=replace(marks, blocked=()), agent=body))}
    images |= {view: png_bytes(annotate(scene, layout, view=view)) for view in VIEWS}
    return images | {name: png_bytes(render_asset(scene.by_name[name])) for name in kinds}


def finished_pictures(scene: Scene, layout: Layout, pictures: Pictures) -> dict[str, bytes]:
    """Return a finished room from above and from the side, with nothing written into it (see `room_pictures`)."""
    if pictures != "drawn":
        return {} if pictures == "none" else {f"finished {view}": b"" for view in VIEWS}
    studio = Studio(scene, layout)
    return {f"finished {view}": png_bytes(studio.view(view, size=PICTURE_SIZE)) for view in VIEWS}


def failed_picture(report: Report, asked: Program, mine: Collection[str]) -> bytes:
    """Return the plan of what came of a program, with where it had put its things and arrows from there."""
    scene, layout, first = report.scene, report.layout, report.agents[0]
    meant: dict[str, Pose] = {}
    for move in report.moved:
        guess = asked.guesses.get(move.asset)
        if move.asset in mine and guess is not None and guess.position is not None:
            here = layout[move.asset]
            meant[move.asset] = Pose(*guess.position[:2], here.z, here.yaw if guess.yaw is None else guess.yaw)
    ways = [(pose.at, layout[name].at) for name, pose in meant.items()]
    marks = replace(
        plan_marks(first),
        ghosts=tuple(pose.corners(scene.by_name[name].size) for name, pose in meant.items()),
        arrows=tuple(way for way in ways if way[0] != way[1]),
    )
    return png_bytes(model_plan(scene, layout, marks=marks, agent=first.agent))
