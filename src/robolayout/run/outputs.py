"""The files of a run: what is in each of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from robolayout._files import write_atomic
from robolayout._text import file_name, pretty
from robolayout.export import Options, export, find_exporter, to_bytes
from robolayout.page import content, document
from robolayout.page.marks import plan_marks, sheet_marks, sheet_notes
from robolayout.render import (
    Drawing,
    PlanMarks,
    Studio,
    draw_comparison,
    draw_losses,
    draw_plan,
    draw_sheet,
    plan_svg,
    png_bytes,
    progress_gif,
)
from robolayout.run.diff import Difference
from robolayout.run.folder import RunFolder, open_folder
from robolayout.run.result import Result
from robolayout.scene import scene_to_dict
from robolayout.verify import Report

PICTURE_SIZE = 900  # pixels of a side of `top.png` and `view.png`

PLAIN = ("scene.json", "layout.json", "report.json")  # the files without which a layout cannot be judged again


def write_result(
    result: Result, folder: str | Path, *, pictures: bool = True, formats: Sequence[str] = (), date: str = ""
) -> list[Path]:
    """Write everything that a run made, or all that can be said of a layout that somebody else made.

    All of it takes the place of what an older run wrote, or nothing does. What is in the folder and was not written by an older
    run stays; if it has the name of one of our files, it gets `.kept` at its end.

    Args:
        formats: Export formats beside GLB ("usda", "mjcf"); see `robolayout.export.EXPORTERS`.

    Raises:
        UnknownNameError: A format is not known (before anything is written).
        OutputError: A file cannot be written, or another run writes to the folder.
    """
    for name in formats:
        find_exporter(name)
    with open_folder(Path(folder)) as run:
        return [run.place(path) for path in write_files(result, run, pictures=pictures, formats=formats, date=date)]


def write_files(
    result: Result, run: RunFolder, *, pictures: bool, formats: Sequence[str], date: str = "", looks: int = 0
) -> list[Path]:
    """Write the files of a run to where they are made (see `write_result`); `looks` is the seed of how things look."""
    folder = run.path
    written = [write_atomic(folder / name, data) for name, data in _texts(result, run.target)]
    options = replace(export_options(result.report), seed=looks)
    glb = to_bytes(result.scene, result.layout, "glb", options=Options(seed=looks), partial=True)
    written.append(write_atomic(folder / "scene.glb", glb))
    for name in formats:
        if name not in ("glb", "layout"):
            written.append(export(result.scene, result.layout, name, folder=folder, options=options, partial=True))
    if pictures:
        written += [write_atomic(folder / name, data) for name, data in _pictures(result, glb, date, looks)]
    return written


def write_plain(result: Result, folder: Path, base: Path) -> None:
    """Write scene, layout and report alone, the meshes of the scene named from `base`."""
    for name, data in _texts(result, base):
        if name in PLAIN:
            write_atomic(folder / name, data)


def page_html(result: Result) -> str:
    """Return the run as one page to look at in a browser: the room in 3D, verdicts and figures; it needs no network."""
    glb = to_bytes(result.scene, result.layout, "glb", partial=True)
    return _page(result, glb, [plan_marks(agent) for agent in result.report.agents])


def _page(result: Result, glb: bytes, marks: Sequence[PlanMarks]) -> str:
    return document(content(result.report, result.reconciled, result.trace, marks), glb)


def export_options(report: Report) -> Options:
    """Return what exporters may put beside the furniture: the first agent and its routes."""
    first = report.agents[0]
    routes = {name: route.points for name, route in first.navigation.routes.items()}
    return Options(agent=first.agent, routes=routes, start=first.start)


def _texts(result: Result, folder: Path) -> Iterator[tuple[str, str]]:
    yield "scene.json", pretty(scene_to_dict(result.scene, base=folder.resolve()))
    if result.solution:
        yield "grouping.json", pretty([group.to_dict() for group in result.groups])
        if result.samples:
            yield "samples.json", pretty([sample.to_dict() for sample in result.samples])
    if result.solution or result.program.text:
        yield "program.py", result.program.text
        yield "constraints.json", pretty(result.reconciled.to_dict())
    yield "layout.json", pretty(result.layout.to_dict())
    yield "report.json", pretty(result.report.to_dict())
    yield "report.md", result.report.to_markdown()


def _pictures(result: Result, glb: bytes, date: str, looks: int) -> Iterator[tuple[str, str | bytes]]:
    marks = [plan_marks(body) for body in result.report.agents]
    yield "report.html", _page(result, glb, marks)
    for number, body in enumerate(result.report.agents, 1):
        file = "plan.svg" if number == 1 else f"plan_{number}_{file_name(body.agent.name)}.svg"
        yield file, plan_svg(result.scene, result.layout, navigation=marks[number - 1], agent=body.agent)
    yield "sheet.pdf", sheet(result.report, date=date)
    studio = Studio(result.scene, result.layout, seed=looks)
    yield "top.png", png_bytes(studio.view("top", size=PICTURE_SIZE))
    yield "view.png", png_bytes(studio.view("side", size=PICTURE_SIZE))
    if result.trace.losses:
        yield "progress.gif", progress_gif(result.scene, result.trace, layout=result.layout)
        yield "loss.png", draw_losses(result.trace).file(".png")


def comparison(results: Sequence[Result], suffix: str = ".png", *, width: int = 1800) -> bytes:
    """Return the plans of several runs side by side as the content of a PNG (`width` in pixels) or SVG file."""
    bodies = (run.report.agents[0].agent for run in results)
    titled = [(f"{run.scene.name} for {b.title or b.name}", run) for run, b in zip(results, bodies, strict=True)]
    drawing = _side_by_side(titled)
    return drawing.svg().encode() if suffix == ".svg" else png_bytes(drawing.image(width).quantize(256))


def difference_picture(found: Difference, suffix: str = ".png", *, width: int = 1400) -> bytes:
    """Return two layouts in one plan, with arrows from then to now; side by side if they are of different rooms."""
    before, after = found.before, found.after
    if before.scene.room == after.scene.room:
        return draw_plan(after.scene, after.layout, navigation=found.marks()).file(suffix, width)
    return _side_by_side([("before", before), ("after", after)]).file(suffix, width)


def _side_by_side(titled: Sequence[tuple[str, Result]]) -> Drawing:
    return draw_comparison([(title, r.scene, r.layout, plan_marks(r.report.agents[0])) for title, r in titled])


def sheet(report: Report, suffix: str = ".pdf", *, date: str = "", width: int = 1600) -> bytes:
    """Return the sheet to print for the first body of a report; `date` is what its title block says."""
    first, notes = report.agents[0], sheet_notes(report, date)
    drawing = draw_sheet(report.scene, report.layout, notes, marks=sheet_marks(first), agent=first.agent)
    return drawing.file(suffix, width)
