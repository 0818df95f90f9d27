"""A run as plain data for the viewer: lengths in whole millimetres, angles in tenths of a degree, verdicts in words."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from robolayout._version import __version__
from robolayout.page._agents import CONTENT, agent_content, listed, millimetres
from robolayout.page.notes import rule_rows
from robolayout.program import Reconciled
from robolayout.render import PlanMarks, palette
from robolayout.render.animation import spread
from robolayout.render.contents import display_name, level
from robolayout.render.curves import TOTAL, loss_terms
from robolayout.scene import Trace
from robolayout.verify import Report

Row = tuple[str, str, bool | None]
"""What was looked at, what came out, and whether that is enough (None: nothing is asked)."""


def content(report: Report, reconciled: Reconciled, trace: Trace, marks: Sequence[PlanMarks]) -> dict[str, Any]:
    """Return everything that the page shows of a judged run, the meshes aside; `marks` are those of each agent."""
    scene = report.scene
    room = scene.room
    return {
        "version": __version__,
        "name": scene.name,
        "task": scene.task_description,
        "ok": report.ok,
        "asked": [[row.words, row.understanding, row.verdict, row.value] for row in report.asked],
        "checks": [
            {"name": name, "shown": shown, "met": met, "share": None if shown in ("yes", "no") else float(shown)}
            for name, shown, met in report.rows()
        ],
        "problems": [*report.physics.reasons, *(item.complaint for item in report.statements if not item.met)],
        "timing": [[station, round(spent["wall"], 3)] for station, spent in report.timing.items()],
        "room": {
            "floor": [listed(vertex) for vertex in room.vertices],
            "height": millimetres(room.wall_height),
            "doors": [door.wall for door in room.doors],
            "windows": [window.wall for window in room.windows],
        },
        "assets": list(_assets(report, reconciled)),
        "statements": list(_statements(report, reconciled)),
        "rules": rule_rows(report),
        "agents": [
            agent_content(agent, shown, report.demands) for agent, shown in zip(report.agents, marks, strict=True)
        ],
        "trace": _trace(trace, [asset.name for asset in scene.assets]),
        "colors": {"route": palette.ROUTE, "narrow": palette.NARROW, "bad": palette.BLOCKED, "wall": palette.WALL},
    }


def _assets(report: Report, reconciled: Reconciled) -> Iterator[dict[str, Any]]:
    scene, layout = report.scene, report.layout
    about = {asset.name: list[int]() for asset in scene.assets}
    for i, decision in enumerate(reconciled.decisions):
        for name in dict.fromkeys(decision.statement.relation.asset_names()):
            about[name].append(i)
    for asset in scene.assets:
        pose = layout.get(asset.name)
        yield {
            "name": asset.name,
            "label": display_name(scene, asset),
            "category": asset.category,
            "description": asset.description,
            "level": level(asset),
            "size": [millimetres(length) for length in asset.size],
            "pose": None if pose is None else [*map(millimetres, (pose.x, pose.y, pose.z)), _tenths(pose.yaw)],
            "rows": _physical(report, asset.name),
            "statements": about[asset.name],
        }


def _physical(report: Report, name: str) -> list[Row]:
    """Return the physical checks that an asset fails, or that it fails none."""
    found = report.physics
    if not found.placed[name]:
        return [("Placed", "no", False)]
    hits = [item.b if item.a == name else item.a for item in found.collisions if name in (item.a, item.b)]
    doors = [f"door {item.door}" for item in found.obstructions if item.asset == name]
    rows: list[Row] = [("Collides", f"with {' and '.join(hits)}", False)] if hits else []
    rows += [("Blocks", " and ".join(doors), False)] if doors else []
    rows += [] if found.in_boundary[name] else [("Inside the room", "no", False)]
    rows += [] if found.supported[name] else [("Held", "no: it stands, lies or hangs on nothing", False)]
    return rows or [("Physics", "placed, collides with nothing, inside the room, held", True)]


def _statements(report: Report, reconciled: Reconciled) -> Iterator[dict[str, Any]]:
    decided = {decision.statement.number: decision for decision in reconciled.decisions}
    for item in report.statements:
        decision = decided.get(item.number)
        changed = decision is not None and decision.verdict != "accepted"
        yield {
            "line": item.line,
            "sentence": item.sentence,
            "met": item.met,
            "text": item.text,
            "limit": f"{item.limit:.2f} {item.unit}".strip() if math.isfinite(item.limit) else "",
            "note": f"{decision.verdict} before solving: {decision.reason}" if decision and changed else "",
        }


def _trace(trace: Trace, names: Sequence[str]) -> dict[str, Any]:
    """Return the moments of the search as flat lists of x, y, angle in the order of the assets; absent ones are None."""
    frames: list[list[Any]] = []
    for snapshot in (trace.snapshots[k] for k in spread(len(trace.snapshots), CONTENT.frames)):
        poses: list[int | None] = []
        for name in names:
            x, y, yaw = snapshot.poses.get(name, (None, None, None))
            poses += [None] * 3 if x is None or y is None or yaw is None else [*listed((x, y)), _tenths(yaw)]
        frames.append([snapshot.step, snapshot.stage, poses])
    return {"steps": len(trace.losses), "frames": frames, "curve": _curve(trace)}


def _curve(trace: Trace) -> list[list[float]]:
    """Return (step, log10 of the total loss), where it is positive."""
    total = loss_terms(trace).get(TOTAL)
    if total is None:
        return []
    steps = np.flatnonzero(np.isfinite(total) & (total > 0))
    steps = steps[:: max(1, math.ceil(len(steps) / CONTENT.curve))]
    return [[int(step), round(math.log10(float(total[step])), 3)] for step in steps]


def _tenths(yaw: float) -> int:
    """Return an angle in tenths of a degree."""
    return round(math.degrees(yaw) * 10)
