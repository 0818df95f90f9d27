"""`robolayout render`: every kind of picture of a layout."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from typer import Option

from robolayout._errors import InputError, UnknownNameError
from robolayout._files import write_atomic
from robolayout._text import pretty
from robolayout.cli.options import DateOption, Laid, ending, spread
from robolayout.cli.terminal import say

if TYPE_CHECKING:
    from PIL.Image import Image

    from robolayout.render import Buffers, Studio
    from robolayout.scene import Layout, Point, Pose, Scene

SUFFIXES = {"plan": (".png", ".svg", ".pdf"), "sheet": (".pdf", ".svg", ".png"), "walk": (".gif",)}
"""Endings of the files of drawings, the first by default; everything else is a PNG."""

VIEWS = ("top", "side", *SUFFIXES)  # views that every room has; the others are an asset's name and eye:ASSET

RENDERERS = {"auto": "auto", "gl": "gl", "ray": "rays", "rays": "rays"}  # names on the command line and in Python

SEEN_FROM = 1.3
"""An eye-level picture is taken where the asset is at least so many of its own sizes away, if the route is long enough."""

LEAST = 1.2  # ... and at least so many metres.


@dataclass(frozen=True, kw_only=True)
class Wish(Laid):
    """What is to be drawn, and how."""

    view: Annotated[
        str, Option(help="top, side, plan, sheet (to print), walk (GIF), an asset's name, or eye:ASSET.")
    ] = "side"
    size: Annotated[int, Option(min=64, max=4096, help="Pixels of a side.")] = 1024
    out: Annotated[
        Path | None, Option(help="Picture file; <view>.png if not given (plan, sheet: also .svg, .pdf).")
    ] = None
    renderer: Annotated[str, Option(help="auto, gl (OpenGL) or ray (ray casting).")] = "auto"
    beauty: Annotated[bool, Option("--beauty", help="Trace paths of light (extra `beauty`).")] = False
    annotated: Annotated[bool, Option("--annotated", help="With grid, fronts and names, as a model sees it.")] = False
    ids: Annotated[bool, Option("--ids", help="Also write which asset each pixel shows.")] = False
    depth: Annotated[bool, Option("--depth", help="Also write each pixel's depth, in millimetres.")] = False
    date: DateOption = ""


@spread
def render(wish: Wish) -> None:
    """Draw a layout."""
    _check(wish)
    given, placed = wish.read_both()
    view = wish.view
    if view not in VIEWS and view.removeprefix("eye:") not in placed:
        eyes = [f"eye:{name}" for name in placed]
        raise UnknownNameError("view", view, eyes if view.startswith("eye:") else [*VIEWS, *placed, "eye:ASSET"])
    allowed = SUFFIXES.get(view, (".png",))
    target = wish.out or Path(f"{view.replace(':', '_')}{allowed[0]}")
    ending(target, f"--view {view}", allowed)
    for path, data in _files(given, placed, wish, target):
        say(str(write_atomic(path, data)))


def _check(wish: Wish) -> None:
    """Refuse what is not known, and options that exclude each other."""
    if wish.renderer not in RENDERERS:
        raise InputError(f"--renderer {wish.renderer!r} is not known: choose auto, gl or ray.")
    chosen = [name for name in ("beauty", "annotated", "ids", "depth") if getattr(wish, name)]
    by_name = ["renderer"] if wish.renderer != "auto" else []
    if wish.beauty and by_name:
        raise InputError("--renderer and --beauty exclude each other: give one of them.")
    if wish.view in SUFFIXES and (found := chosen + by_name):
        raise InputError(
            f"--{found[0]} does not go with --view {wish.view}: use it with top, side, an asset or eye:ASSET."
        )
    if wish.date and wish.view != "sheet":
        raise InputError(f"--date does not go with --view {wish.view}: use it with sheet.")
    if wish.annotated and wish.view not in ("top", "side"):
        raise InputError(f"--annotated does not go with --view {wish.view}: use it with top or side.")
    if len({"beauty", "annotated"} & set(chosen)) and len(chosen) > 1:
        raise InputError(f"--{chosen[0]} and --{chosen[1]} exclude each other: give one of them.")


def _files(scene: Scene, layout: Layout, wish: Wish, target: Path) -> list[tuple[Path, bytes]]:
    """Return the files that were asked for and what is in them, all drawn before any is written."""
    from robolayout.render import Studio, annotate, png_bytes, render_beauty

    if wish.view in SUFFIXES:
        return [(target, _drawn(scene, layout, wish, target.suffix.lower()))]
    stand = _stand(scene, layout, wish.view)
    if wish.beauty:
        return [(target, png_bytes(render_beauty(scene, layout, view=wish.view, size=wish.size, stand=stand)))]
    if wish.annotated:
        picture = annotate(scene, layout, view=wish.view, size=wish.size, renderer=RENDERERS[wish.renderer])  # type: ignore[arg-type]
        return [(target, png_bytes(picture))]
    studio = Studio(scene, layout, renderer=RENDERERS[wish.renderer])  # type: ignore[arg-type]
    if wish.ids or wish.depth:
        return _measured(studio, wish, target, stand)
    return [(target, png_bytes(studio.view(wish.view, size=wish.size, stand=stand)))]


def _drawn(scene: Scene, layout: Layout, wish: Wish, suffix: str) -> bytes:
    from robolayout.page.marks import plan_marks
    from robolayout.render import draw_plan, walk_gif
    from robolayout.run.outputs import sheet
    from robolayout.verify import judge_agent, verify

    if wish.view == "sheet":
        return sheet(verify(scene, layout), suffix, date=wish.date, width=wish.size)
    agent = scene.agent
    judged = judge_agent(scene, layout, agent)
    marks = plan_marks(judged)
    if wish.view == "walk":
        return walk_gif(scene, layout, marks, ways=judged.ways, agent=agent, size=wish.size)
    return draw_plan(scene, layout, navigation=marks, agent=agent).file(suffix, wish.size)


def _stand(scene: Scene, layout: Layout, view: str) -> Point | None:
    """Return where the agent stands for an eye-level picture: on its way to the asset, as near as shows all of it."""
    from robolayout.verify import judge_agent

    name = view.removeprefix("eye:")
    if name == view or name not in layout:
        return None
    route = judge_agent(scene, layout, scene.agent).navigation.routes.get(name)
    return route and viewpoint(route.points, layout[name], SEEN_FROM * max(scene.by_name[name].size))


def viewpoint(route: Sequence[Point], pose: Pose, distance: float) -> Point:
    """Return the last point of a route from which a pose is `distance` metres away (and `LEAST`), or the farthest."""
    points = [route[0]]
    for (ax, ay), (bx, by) in pairwise(route):
        points += [(ax + (bx - ax) * step / 20, ay + (by - ay) * step / 20) for step in range(1, 21)]

    def metres(point: Point) -> float:
        return math.dist(point, (pose.x, pose.y))

    far = [point for point in points if metres(point) >= max(distance, LEAST)]
    return far[-1] if far else max(points, key=metres)


def _measured(studio: Studio, wish: Wish, target: Path, stand: Point | None) -> list[tuple[Path, bytes]]:
    """Return the picture, which asset each pixel shows, how far it is, and what the numbers mean."""
    import numpy as np
    from PIL import Image

    from robolayout.render import png_bytes

    inside = wish.view.startswith("eye:")
    buffers = studio.buffers(studio.camera(wish.view, (wish.size, wish.size), stand=stand), inside=inside)
    files = [(target, png_bytes(Image.fromarray(buffers.color)))]
    if wish.ids:
        files.append((target.with_name(f"{target.stem}-ids.png"), png_bytes(_id_picture(buffers))))
    if wish.depth:  # whole millimetres in 16 bits; 0 is the background
        metres = np.where(np.isfinite(buffers.depth), buffers.depth * 1000.0, 0.0)
        drawn = Image.fromarray(np.clip(np.round(metres), 0, 65535).astype(np.uint16))
        files.append((target.with_name(f"{target.stem}-depth.png"), png_bytes(drawn)))
    camera = buffers.camera
    about = {"position": list(camera.position), "target": list(camera.target), "up": list(camera.up)}
    about |= {"vertical_field_of_view": math.degrees(camera.fov), "width": camera.width, "height": camera.height}
    notes = {
        "ids": {"0": "background", **{str(k + 1): name for k, name in enumerate(buffers.names)}},
        "depth": "millimetres along the line of sight; 0 is the background",
        "camera": about,
    }
    return [*files, (target.with_suffix(".json"), pretty(notes).encode())]


def _id_picture(buffers: Buffers) -> Image:
    """Return ids plus one as a picture: 0 background, 1 room, k + 2 the k-th asset; in colours if there are few."""
    import numpy as np
    from PIL import Image

    numbers = buffers.ids + 1
    if len(buffers.names) > 255:
        return Image.fromarray(numbers.astype(np.uint16))
    picture = Image.fromarray(numbers.astype(np.uint8), mode="P")
    hues = (np.arange(254) * 0.61803) % 1.0
    ramp = np.stack([0.5 + 0.42 * np.cos(2 * np.pi * (hues + shift)) for shift in (0.0, 1 / 3, 2 / 3)], axis=1)
    colors = np.concatenate([[(0, 0, 0), (128, 128, 128)], np.round(255 * ramp)]).astype(np.uint8)
    picture.putpalette(colors.tobytes())
    return picture
