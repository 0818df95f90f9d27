"""A run as plain data for the viewer: lengths in whole millimetres, angles in tenths of a degree, verdicts in words."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from robolayout._version import __version__
from robolayout.page.marks import rule_rows
from robolayout.program import Reconciled
from robolayout.render import PlanMarks, palette
from robolayout.render.animation import spread
from robolayout.render.contents import display_name, level
from robolayout.render.curves import TOTAL, loss_terms
from robolayout.scene import Agent, Trace
from robolayout.verify import AgentReport, Demands, Report, exempt_from_reach
from robolayout.verify.navigation import unreached_sentence


@dataclass(frozen=True)
class ContentConfig:
    """How finely the page shows a room and the search for it."""

    tolerance: float = 0.004  # metres by which the drawn outline of a floor area may leave the exact one
    smallest: float = 0.01  # square metres below which a drawn floor area is left out
    frames: int = 120  # most moments of the search that the page holds
    curve: int = 240  # most points of the loss curve


CONTENT = ContentConfig()

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
            "floor": [_listed(vertex) for vertex in room.vertices],
            "height": _millimetres(room.wall_height),
            "doors": [door.wall for door in room.doors],
            "windows": [window.wall for window in room.windows],
        },
        "assets": list(_assets(report, reconciled)),
        "statements": list(_statements(report, reconciled)),
        "rules": rule_rows(report),
        "agents": [_agent(agent, shown, report.demands) for agent, shown in zip(report.agents, marks, strict=True)],
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
            "size": [_millimetres(length) for length in asset.size],
            "pose": None if pose is None else [*map(_millimetres, (pose.x, pose.y, pose.z)), _tenths(pose.yaw)],
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


def _agent(report: AgentReport, marks: PlanMarks, demands: Demands) -> dict[str, Any]:
    """Return what the page shows of one agent; the assets are in the order of the scene."""
    nav, agent = report.navigation, report.agent
    names = [asset.name for asset in nav.scene.assets]
    beyond = Polygon(nav.scene.room.vertices).difference(nav.main.buffer(agent.reach, quad_segs=8))
    return {
        "name": agent.name,
        "title": agent.title or agent.name,
        "body": _body(agent),
        "radius": _millimetres(agent.radius),
        "height": _millimetres(agent.height),
        "reach": _millimetres(agent.reach),
        "entry": nav.entry and _listed(nav.entry),
        "figures": _figures(report, demands),
        "free": _areas(Polygon(rings[0], rings[1:]) for rings in marks.free),
        "islands": _areas(Polygon(rings[0], rings[1:]) for rings in marks.islands),
        "beyond": _areas(shapely.get_parts(beyond)),
        "routes": [[v for point in marks.routes.get(name, ()) for v in _listed(point)] for name in names],
        "passage": [[_listed(a), _listed(b), f"{width:.2f} m"] for a, b, width in marks.passages],
        "turns": [[*_listed(center), _millimetres(across)] for center, across in marks.circles],
        "assets": [_use(report, name) for name in names],
        "problems": list(report.violations),
        "helps": [*report.remedies.sentences(agent)],
    }


def _millimetres(metres: float) -> int:
    """Return a length in whole millimetres."""
    return round(metres * 1000)


def _listed(point: Iterable[float]) -> list[int]:
    """Return coordinates in whole millimetres."""
    return [_millimetres(value) for value in point]


def _rings(shape: Polygon) -> list[list[int]]:
    """Return the rings of a polygon, outer first, without the points that no eye would miss."""
    plain = shape.simplify(CONTENT.tolerance)
    plain = plain if isinstance(plain, Polygon) and not plain.is_empty else shape
    return [[v for x, y in ring.coords[:-1] for v in _listed((x, y))] for ring in (plain.exterior, *plain.interiors)]


def _areas(shapes: Iterable[BaseGeometry]) -> list[list[list[int]]]:
    """Return the rings of every polygon that is large enough to be seen."""
    return [_rings(shape) for shape in shapes if isinstance(shape, Polygon) and shape.area > CONTENT.smallest]


def _body(agent: Agent) -> str:
    plan = f"disc of {2 * agent.radius:.2f} m"
    if agent.length is not None and agent.width is not None:
        plan = f"{agent.length:.2f} x {agent.width:.2f} m"
    arm = "no arm"
    if agent.reach_distance is not None:
        arm = f"reaches {agent.reach:.2f} m, from {agent.reach_low:.2f} to {agent.reach_high:.2f} m high"
    return f"{plan}, {agent.height:.2f} m high, {arm}"


def _figures(report: AgentReport, demands: Demands) -> list[Row]:
    """Return this body's own figures: name, value, whether it is enough (None: nothing is asked)."""
    nav = report.navigation
    needed = 2 * report.agent.radius
    aside = exempt_from_reach(nav.scene, report.agent)
    reached = all(met or name in aside for name, met in nav.reached.items())
    usable = all(met or name in report.exempt for name, met in report.usage.usable.items())
    rows: list[Row] = [
        ("walkable", f"{nav.walkable_ratio:.0%}", nav.walkable_ratio >= demands.walkable_ratio),
        ("doors reached", "yes" if report.doors_reached else "no", report.doors_reached),
        ("reachable as it stands", f"{nav.reachable_share:.0%}", None),
        ("reachable with chairs aside", f"{nav.reachable_share_chairs_aside:.0%}", reached),
        ("usable", f"{report.usage.usable_share:.0%}", usable),
        ("free floor", f"{nav.free.area:.1f} m\u00b2", None),
    ]
    asked = (passage for name, passage in nav.passages.items() if name not in aside)
    narrow = min(asked, key=lambda passage: passage.width, default=None)
    if narrow is not None:
        rows.append(("narrowest way", f"{narrow.shown} (needs {needed:.2f} m)", narrow.width >= needed - 0.01))
    if nav.routes:
        rows.append(("longest route", f"{max(route.length for route in nav.routes.values()):.1f} m", None))
    return rows


def _use(report: AgentReport, name: str) -> dict[str, Any]:
    """Return whether an asset is reached and used, where the body stands for it, and both in words."""
    nav = report.navigation
    use = report.usage.uses.get(name)
    if use is None:
        return {"state": "bad", "stand": None, "rows": [("Reached", "no: it has no place", False)]}
    asked = name not in report.exempt
    state = "bad" if name in report.short else "good" if nav.reached[name] and use.usable else "free"
    rows: list[Row] = []
    passage = nav.passages.get(name)
    if passage is None:
        rows.append(("Reached", "nobody needs to get to it", None))
    elif nav.reached[name]:
        route = nav.routes.get(name)
        rows.append(("Reached", f"yes, after {route.length:.1f} m" if route else "yes", True))
        between = f" between {' and '.join(passage.between)}" if passage.between else ""
        rows.append(("Narrowest way", passage.shown + between, None))
    else:
        rows.append(("Reached", unreached_sentence(nav, name), False if asked else None))
    if not use.usable:
        text = f"no: {use.reason}" if asked else f"not asked: {report.exempt[name]}"
        rows.append(("Used", text, False if asked else None))
    elif use.stand is None:
        rows.append(("Used", "it asks for no use", None))
    else:
        moved = f", once {' and '.join(use.moved)} stands aside" if use.moved else ""
        how = f", {use.approach}" if use.approach else ""
        by = f", by the handle of {use.opens}" if use.opens else ""
        side = f"yes, from its {use.side}{how}" if use.side else "yes, from any side"
        rows.append(("Used", side + by + moved, True))
    return {"state": state, "stand": use.stand and _listed(use.stand), "rows": rows}


def _trace(trace: Trace, names: Sequence[str]) -> dict[str, Any]:
    """Return the moments of the search as flat lists of x, y, angle in the order of the assets; absent ones are None."""
    frames: list[list[Any]] = []
    for snapshot in (trace.snapshots[k] for k in spread(len(trace.snapshots), CONTENT.frames)):
        poses: list[int | None] = []
        for name in names:
            x, y, yaw = snapshot.poses.get(name, (None, None, None))
            poses += [None] * 3 if x is None or y is None or yaw is None else [*_listed((x, y)), _tenths(yaw)]
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
