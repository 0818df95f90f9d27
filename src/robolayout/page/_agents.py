"""What one body can do, as plain data: figures, shapes on the floor, and a verdict in words for every asset."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.render import PlanMarks
from robolayout.scene import Agent, Point
from robolayout.verify import AgentReport, Demands, exempt_from_reach
from robolayout.verify.sentences import unreached_sentence


@dataclass(frozen=True)
class ContentConfig:
    """How finely the page shows a room and the search for it."""

    tolerance: float = 0.004  # metres by which the drawn outline of a floor area may leave the exact one
    smallest: float = 0.01  # square metres below which a drawn floor area is left out
    frames: int = 120  # most moments of the search that the page holds
    curve: int = 240  # most points of the loss curve


CONTENT = ContentConfig()

Rings = Sequence[Sequence[Point]]


def agent_content(report: AgentReport, marks: PlanMarks, demands: Demands) -> dict[str, Any]:
    """Return what the page shows of one agent; the assets are in the order of the scene."""
    nav, agent = report.navigation, report.agent
    names = [asset.name for asset in nav.scene.assets]
    return {
        "name": agent.name,
        "title": agent.title or agent.name,
        "body": _body(agent),
        "radius": millimetres(agent.radius),
        "height": millimetres(agent.height),
        "reach": millimetres(agent.reach),
        "entry": nav.entry and listed(nav.entry),
        "figures": _figures(report, demands),
        "free": _areas(Polygon(rings[0], rings[1:]) for rings in marks.free),
        "islands": _areas(Polygon(rings[0], rings[1:]) for rings in marks.islands),
        "beyond": _areas(shapely.get_parts(_beyond(report))),
        "routes": [[v for point in marks.routes.get(name, ()) for v in listed(point)] for name in names],
        "passage": [[listed(a), listed(b), f"{width:.2f} m"] for a, b, width in marks.passages],
        "turns": [[*listed(center), millimetres(across)] for center, across in marks.circles],
        "assets": [_asset(report, name) for name in names],
        "problems": list(report.violations),
        "helps": [*report.remedies.sentences(agent)],
    }


def millimetres(metres: float) -> int:
    """Return a length in whole millimetres."""
    return round(metres * 1000)


def listed(point: Iterable[float]) -> list[int]:
    """Return coordinates in whole millimetres."""
    return [millimetres(value) for value in point]


def _rings(shape: Polygon) -> list[list[int]]:
    """Return the rings of a polygon, outer first, without the points that no eye would miss."""
    plain = shape.simplify(CONTENT.tolerance)
    plain = plain if isinstance(plain, Polygon) and not plain.is_empty else shape
    return [[v for x, y in ring.coords[:-1] for v in listed((x, y))] for ring in (plain.exterior, *plain.interiors)]


def _areas(shapes: Iterable[BaseGeometry]) -> list[list[list[int]]]:
    """Return the rings of every polygon that is large enough to be seen."""
    return [_rings(shape) for shape in shapes if isinstance(shape, Polygon) and shape.area > CONTENT.smallest]


def _beyond(report: AgentReport) -> BaseGeometry:
    """Return the part of the floor that the body cannot reach from anywhere."""
    nav = report.navigation
    return shapely.difference(Polygon(nav.scene.room.vertices), nav.main.buffer(report.agent.reach, quad_segs=8))


def _body(agent: Agent) -> str:
    plan = f"disc of {2 * agent.radius:.2f} m"
    if agent.length is not None and agent.width is not None:
        plan = f"{agent.length:.2f} x {agent.width:.2f} m"
    arm = "no arm"
    if agent.reach_distance is not None:
        arm = f"reaches {agent.reach:.2f} m, from {agent.reach_low:.2f} to {agent.reach_high:.2f} m high"
    return f"{plan}, {agent.height:.2f} m high, {arm}"


def _figures(report: AgentReport, demands: Demands) -> list[tuple[str, str, bool | None]]:
    """Return this body's own figures: name, value, whether it is enough (None: nothing is asked)."""
    nav = report.navigation
    needed = 2 * report.agent.radius
    aside = exempt_from_reach(nav.scene, report.agent)
    reached = all(met or name in aside for name, met in nav.reached.items())
    usable = all(met or name in report.exempt for name, met in report.usage.usable.items())
    rows: list[tuple[str, str, bool | None]] = [
        ("walkable", f"{nav.walkable_ratio:.0%}", nav.walkable_ratio >= demands.walkable_ratio),
        ("doors reached", "yes" if report.doors_reached else "no", report.doors_reached),
        ("reachable as it stands", f"{nav.reachable_share:.0%}", None),
        ("reachable with chairs aside", f"{nav.reachable_share_chairs_aside:.0%}", reached),
        ("usable", f"{report.usage.usable_share:.0%}", usable),
        ("free floor", f"{nav.free.area:.1f} m\u00b2", None),
    ]
    narrow = min(nav.passages.values(), key=lambda passage: passage.width, default=None)
    if narrow is not None:
        rows.append(("narrowest way", f"{narrow.shown} (needs {needed:.2f} m)", narrow.width >= needed - 0.01))
    if nav.routes:
        rows.append(("longest route", f"{max(route.length for route in nav.routes.values()):.1f} m", None))
    return rows


def _asset(report: AgentReport, name: str) -> dict[str, Any]:
    """Return whether an asset is reached and used, where the body stands for it, and both in words."""
    nav = report.navigation
    use = report.usage.uses.get(name)
    if use is None:
        return {"state": "bad", "stand": None, "rows": [("Reached", "no: it has no place", False)]}
    asked = name not in report.exempt
    state = "bad" if name in report.short else "good" if nav.reached[name] and use.usable else "free"
    rows: list[tuple[str, str, bool | None]] = []
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
    return {"state": state, "stand": use.stand and listed(use.stand), "rows": rows}
