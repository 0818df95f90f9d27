"""The output folder of a run: every file of it, written whole or not at all."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from robolayout._files import write_atomic
from robolayout.export import Options, export, find_exporter, to_bytes
from robolayout.render import PlanMarks
from robolayout.scene import Point, scene_to_dict
from robolayout.verify import AgentReport, Passage, Report

if TYPE_CHECKING:
    from PIL.Image import Image

    from robolayout.pipeline import Result

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
    written.append(write_atomic(folder / "scene.glb", to_bytes(result.scene, result.layout, "glb", partial=True)))
    options = export_options(result.report)
    for name in formats:
        if name not in ("glb", "layout"):
            written.append(export(result.scene, result.layout, name, folder=folder, options=options, partial=True))
    if pictures:
        written += [write_atomic(folder / name, data) for name, data in _pictures(result)]
    return written


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


def _pictures(result: Result) -> Iterator[tuple[str, str | bytes]]:
    from robolayout.render import Studio, loss_png, plan_svg, progress_gif

    first = result.report.agents[0]
    yield "plan.svg", plan_svg(result.scene, result.layout, navigation=plan_marks(first), agent=first.agent)
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
    image.save(stream, "PNG")
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
    )


def _span(passage: Passage) -> tuple[Point, Point, float]:
    """Return the ends of the narrowest place and its width in metres."""
    ends = (*passage.ends, *passage.ends)
    return (ends[0], ends[1], passage.width)


def _rings(shape: Any) -> tuple[tuple[tuple[tuple[float, float], ...], ...], ...]:
    """Return the polygons of a shape as rings of points, outer ring first."""
    parts: Sequence[Any] = getattr(shape, "geoms", (shape,))
    return tuple(
        tuple(tuple((float(x), float(y)) for x, y in ring.coords) for ring in (part.exterior, *part.interiors))
        for part in parts
        if not part.is_empty
    )


def _json(data: object) -> str:
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"
