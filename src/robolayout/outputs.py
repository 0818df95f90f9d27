"""The output folder of a run: every file of it, written whole or not at all."""

from __future__ import annotations

import io
import json
import math
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from robolayout._files import write_atomic
from robolayout.export import Options, export, find_exporter, to_bytes
from robolayout.render import PlanMarks
from robolayout.scene import Point, scene_to_dict, vertical_span
from robolayout.verify import AgentReport, Navigation, Passage, Report

if TYPE_CHECKING:
    from PIL.Image import Image

    from robolayout.pipeline import Result

ARC = math.radians(16)
"""Half the angle of the arcs that show how far an arm reaches on the plan."""
APART = 0.4
"""Metres between the places to stand that the plan shows."""
CIRCLES = 3
"""Turning circles that the plan shows: the roomiest places."""
Rings = tuple[tuple[Point, ...], ...]
PICTURE_SIZE = 900
"""Pixels of a side of `top.png` and `view.png`."""


def write_result(
    result: Result, folder: str | Path, *, pictures: bool = True, formats: Sequence[str] = ()
) -> list[Path]:
    """Write everything that a run made.

    Args:
        result: The run.
        folder: Where to write; made if missing.
        pictures: Whether to draw.
        formats: Export formats beside GLB ("usda", "mjcf"); see `robolayout.export.EXPORTERS`.

    Returns:
        The files, in the order of writing.

    Raises:
        UnknownNameError: A format is not known (before anything is written).
        OutputError: A file cannot be written.
    """
    folder = Path(folder)
    for name in formats:
        find_exporter(name)
    written = [write_atomic(folder / name, data) for name, data in _texts(result, folder)]
    glb = to_bytes(result.scene, result.layout, "glb", partial=True)
    written.append(write_atomic(folder / "scene.glb", glb))
    options = export_options(result.report)
    for name in formats:
        if name not in ("glb", "layout"):
            written.append(export(result.scene, result.layout, name, folder=folder, options=options, partial=True))
    if pictures:
        written += [write_atomic(folder / name, data) for name, data in _pictures(result, glb)]
    return written


def page_html(result: Result) -> str:
    """Return the run as one page to look at in a browser: the room in 3D, verdicts and figures; it needs no network."""
    glb = to_bytes(result.scene, result.layout, "glb", partial=True)
    return _page(result, glb, [plan_marks(agent) for agent in result.report.agents])


def _page(result: Result, glb: bytes, marks: Sequence[PlanMarks]) -> str:
    from robolayout.page import content, document

    return document(content(result, marks), glb)


def export_options(report: Report) -> Options:
    """Return what exporters may put beside the furniture: the first agent and its routes."""
    first = report.agents[0]
    return Options(agent=first.agent, routes={name: route.points for name, route in first.navigation.routes.items()})


def _texts(result: Result, folder: Path) -> Iterator[tuple[str, str]]:
    yield "scene.json", _json(scene_to_dict(result.scene, base=folder.resolve()))
    yield "grouping.json", _json([group.to_dict() for group in result.groups])
    yield "program.py", result.program.text
    yield "constraints.json", _json(result.reconciled.to_dict())
    yield "layout.json", _json(result.layout.to_dict())
    yield "report.json", _json(result.report.to_dict())
    yield "report.md", result.report.to_markdown()


def _pictures(result: Result, glb: bytes) -> Iterator[tuple[str, str | bytes]]:
    from robolayout.render import Studio, loss_png, plan_svg, progress_gif

    marks = [plan_marks(body) for body in result.report.agents]
    yield "report.html", _page(result, glb, marks)
    for number, body in enumerate(result.report.agents, 1):
        file = "plan.svg" if number == 1 else f"plan_{number}_{re.sub(r'[^A-Za-z0-9]+', '_', body.agent.name)}.svg"
        yield file, plan_svg(result.scene, result.layout, navigation=marks[number - 1], agent=body.agent)
    studio = Studio(result.scene, result.layout)
    yield "top.png", png(studio.view("top", size=PICTURE_SIZE))
    yield "view.png", png(studio.view("side", size=PICTURE_SIZE))
    if result.trace.losses:
        yield "progress.gif", progress_gif(result.scene, result.trace, layout=result.layout)
        yield "loss.png", loss_png(result.trace)


def comparison(results: Sequence[Result], suffix: str = ".png", *, width: int = 1800) -> bytes:
    """Return the plans of several runs side by side.

    Args:
        results: The runs, from left to right.
        suffix: ".png" or ".svg".
        width: Pixels of the PNG's width.
    """
    from robolayout.render import compare_image, compare_svg

    panels = [
        (f"{run.scene.name} for {_body(run.report.agents[0])}", run.scene, run.layout, plan_marks(run.report.agents[0]))
        for run in results
    ]
    if suffix == ".svg":
        return compare_svg(panels).encode()
    return png(compare_image(panels, width=width).quantize(128))


def _body(report: AgentReport) -> str:
    return report.agent.title or report.agent.name


def png(image: Image) -> bytes:
    """Return a picture as PNG."""
    stream = io.BytesIO()
    image.save(stream, "PNG", compress_level=4)  # half the time of the default level, files 8 % larger
    return stream.getvalue()


def plan_marks(report: AgentReport) -> PlanMarks:
    """Return what one agent can do as shapes for the plan: free space, routes, the narrowest passages."""
    nav = report.navigation
    routes = {name: route.points for name, route in nav.routes.items()}
    narrow = sorted((p for p in nav.passages.values() if p.point is not None and p.between), key=lambda p: p.width)
    return PlanMarks(
        free=_rings(nav.main),
        islands=tuple(rings for rings in _rings(nav.free) if rings not in _rings(nav.main)),
        routes=routes,
        passages=tuple(_span(passage) for passage in narrow[:1]),
        blocked=report.short,
        agent_at=nav.entry,
        under=_under(nav),
        parts=tuple(rings[0] for shape in nav.blocking.shapes[nav.blocking.partial] for rings in _rings(shape)),
        circles=_circles(report),
        arcs=_arcs(report),
    )


def _under(nav: Navigation) -> tuple[Rings, ...]:
    """Return the free space under or inside furniture."""
    from shapely import union_all

    shelter = nav.blocking.shelter
    return _rings(nav.main.intersection(union_all(shelter))) if len(shelter) else ()


def _circles(report: AgentReport) -> tuple[tuple[Point, float], ...]:
    """Return the turning circle of a rectangular body at the roomiest spot of each place where it can turn."""
    from shapely import maximum_inscribed_circle

    agent, space = report.agent, report.headings
    if space is None:
        return ()
    diameter = max(2 * agent.circumradius, agent.turning_diameter or 0.0)
    spots = [maximum_inscribed_circle(place, 0.01).coords[0] for place in list(space.turning.geoms)[:CIRCLES]]
    return tuple(((float(x), float(y)), diameter) for x, y in spots)


def _arcs(report: AgentReport) -> tuple[tuple[Point, ...], ...]:
    """Return where the body stands to use things and how far its arm reaches there: a short arc towards each.

    Of places close together one is taken, and what lies behind a wall is cut off.
    """
    from shapely import LineString, Polygon

    from robolayout.verify import horizontal_reach

    room = Polygon(report.navigation.scene.room.vertices)

    agent, nav = report.agent, report.navigation
    found: list[tuple[Point, ...]] = []
    for name, use in report.usage.uses.items() if agent.reach_distance is not None else ():
        reach = horizontal_reach(agent, *vertical_span(nav.scene.by_name[name], nav.layout[name]))
        if use.stand is not None and reach is not None and all(math.dist(use.stand, a[0]) > APART for a in found):
            (x, y), pose = use.stand, nav.layout[name]
            middle = math.atan2(pose.y - y, pose.x - x)
            turns = [middle + ARC * (step / 8 - 1) for step in range(17)]
            rays = [LineString([(x, y), (x + reach * math.cos(t), y + reach * math.sin(t))]) for t in turns]
            ends = [room.intersection(ray).coords[-1] for ray in rays if room.covers(LineString(ray.coords[:1] * 2))]
            found.append(((x, y), *((float(end[0]), float(end[1])) for end in ends)))
    return tuple(found)


def _span(passage: Passage) -> tuple[Point, Point, float]:
    """Return the ends of the narrowest place and its width in metres."""
    ends = (*passage.ends, *passage.ends)
    return (ends[0], ends[1], passage.width)


def _rings(shape: Any) -> tuple[Rings, ...]:
    """Return the polygons of a shape as rings of points, outer ring first."""
    parts: Sequence[Any] = getattr(shape, "geoms", (shape,))
    return tuple(
        tuple(tuple((float(x), float(y)) for x, y in ring.coords) for ring in (part.exterior, *part.interiors))
        for part in parts
        if part.geom_type == "Polygon" and not part.is_empty
    )


def _json(data: object) -> str:
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
