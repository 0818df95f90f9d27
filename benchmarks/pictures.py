"""What each picture costs in CPU seconds and kilobytes, for the four examples and two shops, and how alike the renderers are."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import numpy as np

import robolayout as rl
from benchmarks.examples import ROOMS, ROOT
from benchmarks.measures import watch
from benchmarks.store import Row
from benchmarks.tables import Rows, figure, table
from robolayout.page.marks import plan_marks
from robolayout.render import (
    Studio,
    annotate,
    draw_losses,
    draw_plan,
    png_bytes,
    progress_gif,
    render_beauty,
    walk_gif,
)
from robolayout.run.outputs import page_html

SHOPS = ("tasks/bookstore_medium", "tasks/florists_shop_medium")
SIZE = 512
VISIBLE = 32
"""Difference of a channel, of 255, that a person sees."""


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room."""
    for room in ROOMS[:1] if quick else (*ROOMS, *SHOPS):
        yield room.rpartition("/")[2], partial(measured, room, beauty=room == ROOMS[0] and not quick)


@lru_cache(maxsize=2)
def furnished(room: str) -> rl.Result:
    """Return one run with its trace."""
    return rl.generate(ROOT / "examples" / f"{room}.json", seed=0, config=rl.SolverConfig(trace=True))


def measured(room: str, *, beauty: bool) -> Row:
    """Return CPU seconds and kilobytes of every picture; each is drawn once before, so that what loads is there."""
    result = furnished(room)
    row: Row = {"assets": len(result.scene.assets)}
    for name, draw in (_files(result) | (_beauty(result) if beauty else {})).items():
        draw()
        with watch() as spent:
            data = draw()
        row |= {f"{name}_cpu": spent.cpu, f"{name}_kb": len(data) / 1000}
    return row | _views(result)


def _files(result: rl.Result) -> dict[str, Callable[[], bytes]]:
    """Return how each file is made."""
    scene, layout, first = result.scene, result.layout, result.report.agents[0]
    marks = plan_marks(first)
    return {
        "plan.svg": lambda: draw_plan(scene, layout, navigation=marks, agent=first.agent).file(".svg"),
        "plan.pdf": lambda: draw_plan(scene, layout, navigation=marks, agent=first.agent).file(".pdf"),
        "walk.gif": lambda: walk_gif(scene, layout, marks, ways=first.ways, agent=first.agent),
        "progress.gif": lambda: progress_gif(scene, result.trace, layout=layout),
        "loss.png": lambda: draw_losses(result.trace).file(".png"),
        "report.html": lambda: page_html(result).encode(),
        "annotated top view, 768": lambda: png_bytes(annotate(scene, layout, view="top")),
    }


def _beauty(result: rl.Result) -> dict[str, Callable[[], bytes]]:
    return {"path tracing, 512": lambda: png_bytes(render_beauty(result.scene, result.layout, size=SIZE))}


def _views(result: rl.Result) -> Row:
    """Return CPU seconds of loading a room and of its views from above and the side, and how the renderers differ."""
    row: Row = {}
    seen: dict[tuple[str, str], Any] = {}
    for renderer in ("gl", "rays"):
        try:
            Studio(result.scene, result.layout, renderer=renderer)
        except rl.InputError:
            continue
        with watch() as spent:
            studio = Studio(result.scene, result.layout, renderer=renderer)
        row[f"{renderer}_load"] = spent.cpu
        for view in ("top", "side"):
            studio.view(view, size=SIZE)
            with watch() as spent:
                seen[renderer, view] = np.asarray(studio.view(view, size=SIZE), dtype=int)
            row |= {f"{renderer}_{view}": spent.cpu, f"{renderer}_{view}_wall": spent.wall}
    if "gl_load" in row:
        apart = [np.abs(seen["gl", view] - seen["rays", view]) for view in ("top", "side")]
        row["differ_mean"] = float(np.mean(apart))
        row["differ_share"] = float(np.mean([(gap.max(axis=2) > VISIBLE).mean() for gap in apart]))
    return row


def section(rows: Rows, images: Path) -> str:
    """Return the table of what each picture costs."""
    rooms = sorted(rows, key=lambda room: rows[room]["assets"])
    files = dict.fromkeys(key.removesuffix("_cpu") for room in rooms for key in rows[room] if key.endswith("_cpu"))
    lines = [[name, *(_picture(rows[room], name) for room in rooms)] for name in files]
    lines += [[words, *(figure(rows[room], key, "{:.2f} s") for room in rooms)] for key, words in VIEWS.items()]
    lines.append(["ray casting against OpenGL: mean difference, of 255"])
    lines[-1] += [figure(rows[room], "differ_mean", "{:.2f}") for room in rooms]
    lines.append(["the same: pixels that differ by more than 32"])
    lines[-1] += [figure(rows[room], "differ_share", "{:.2%}") for room in rooms]
    heads = ["CPU seconds, size", *(f"{room.replace('_', ' ')}, {rows[room]['assets']} assets" for room in rooms)]
    intro = "Each picture drawn a second time in one process; OpenGL without a graphics card.\n"
    return f"## Pictures\n\n{intro}\n{table(heads, lines)}"


VIEWS = {
    "gl_load": "loading a room for OpenGL",
    "gl_top": "OpenGL in software, top view, 512 x 512",
    "gl_top_wall": "the same, wall seconds",
    "gl_side": "OpenGL in software, side view, 512 x 512",
    "gl_side_wall": "the same, wall seconds",
    "rays_load": "loading a room for ray casting",
    "rays_top": "ray casting, top view, 512 x 512",
    "rays_side": "ray casting, side view, 512 x 512",
}
"""Figures of the views, and what they are."""


def _picture(row: Row, name: str) -> str:
    if f"{name}_cpu" not in row:
        return "-"
    return f"{row[f'{name}_cpu']:.2f} s, {row[f'{name}_kb']:.0f} kB"
