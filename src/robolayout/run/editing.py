"""Editing: what of a layout to start from is planned anew, hung as is usual, kept as it was; and what of its mending is told."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

from robolayout._text import listed
from robolayout.assets import place_of
from robolayout.constraints.mounted_on import MountedOn
from robolayout.program import Program
from robolayout.run.given import usual_wishes, with_wishes
from robolayout.run.result import Attempt
from robolayout.scene import Layout, Pose, Scene
from robolayout.solve import carrier_rank, carries
from robolayout.verify import physics


@dataclass(frozen=True)
class EditConfig:
    """What of a layout that was mended is told."""

    raised: float = 0.02  # metres of height from which on a change is told
    radians: float = (
        0.003  # degrees by which a heading may differ from a quarter, half or three quarters of a turn in radians
    )


EDIT = EditConfig()


def supported(scene: Scene, start: Layout, pinned: Mapping[str, Pose]) -> Layout:
    """Return a layout without what can only stand on others and neither stands well nor over a top: its carrier is planned."""
    judged, only_on_others = physics(scene, start), {a.name for a in scene.assets if place_of(a) == "object"}

    def over_a_top(name: str) -> bool:
        others = ((scene.by_name[other], pose) for other, pose in start.items())
        fit = ((other, pose) for other, pose in others if carries(other, scene.by_name[name]))
        return any(carrier_rank(start[name], *one)[:2] == (False, 0.0) for one in fit)

    def stays(name: str) -> bool:
        well = judged.supported[name] and judged.collision_free[name]
        return name in pinned or name not in only_on_others or well or over_a_top(name)

    return Layout({name: pose for name, pose in start.items() if stays(name)})


def hung(scene: Scene, start: Layout, pinned: Mapping[str, Pose], *, seed: int) -> Layout:
    """Return a layout in which what hangs on a wall, but in something else, hangs as high as is usual, where that is free."""
    apart = physics(scene, start).collision_free
    amiss = [n for n in start if place_of(scene.by_name[n]) == "wall" and not apart[n] and n not in pinned]
    usual = [one.relation for one in usual_wishes(scene, seed)] if amiss else []
    heights = {one.a.name: one.height for one in usual if isinstance(one, MountedOn) and one.height is not None}
    for name in (name for name in amiss if name in heights):
        raised = Layout({**start, name: replace(start[name], z=heights[name])})
        start = raised if physics(scene, raised).collision_free[name] else start
    return start


def told(found: Attempt, start: Layout, pinned: Mapping[str, Pose]) -> Attempt:
    """Return a mended layout with remarks: heights that changed, what is kept and in the way, degrees that look like radians."""
    layout, said = found.solution.layout, list[str]()
    heights = {name: (pose.z, layout[name].z) for name, pose in start.items()}
    if raised := [f"{name} ({a:.2f} to {b:.2f} m)" for name, (a, b) in heights.items() if abs(a - b) > EDIT.raised]:
        said.append(f"Put at another height: {listed(raised)}.")
    if stuck := [name for name in found.solution.verdict.culprits if name in pinned]:
        said.append(
            f"What is not met has to do with {listed(stuck)}, which was not to move: free that, too, "
            "or leave keep and free out."
        )
    quarters = (math.pi / 2, math.pi, 3 * math.pi / 2)
    turns = {name: abs(math.remainder(math.degrees(pose.yaw), 360.0)) for name, pose in start.items()}
    if radians := [name for name, turn in turns.items() if any(abs(turn - q) < EDIT.radians for q in quarters)]:
        said.append(
            f"The rotations of {listed(radians)} look like radians; layouts are in degrees, and they were read so."
        )
    return replace(found, asked=replace(found.asked, remarks=(*found.asked.remarks, *said)))


def as_it_was(asked: Program, scene: Scene, start: Layout, *, seed: int) -> Program:
    """Return a program that also wishes what is usual and holds in a layout, so that mending it keeps that."""
    said = {one.relation for one in (*asked.statements, *asked.wishes)}
    new = (one for one in usual_wishes(scene, seed) if one.relation not in said)
    there = (one for one in new if {*one.relation.asset_names()} <= start.keys())
    return with_wishes(asked, [one for one in there if one.relation.check(scene, start).met])
