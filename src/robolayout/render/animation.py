"""Animations: how the optimisation went, and the agent driving its routes. Both are plans seen from above, as GIF."""

from __future__ import annotations

import io
import math
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from robolayout._errors import InputError
from robolayout.render._architecture import THICKNESS, draw_floor, draw_walls
from robolayout.render._drawing import Drawing, Item, Point, Text, paint, text_width
from robolayout.render.curves import TOTAL, Frame, draw_panel, loss_terms
from robolayout.render.marks import PlanMarks
from robolayout.render.palette import INK, PAPER, QUIET, ROUTE
from robolayout.render.plan import display_name, draw_contents, draw_footprint
from robolayout.scene import Agent, Asset, Layout, Pose, Room, Scene, Snapshot, Trace

if TYPE_CHECKING:
    from PIL.Image import Image

SAMPLES = 2
"""Supersampling along each side of a frame."""

SHEET = 120.0
"""Width of a frame's drawing, millimetres."""

STRIP = 26.0
"""Height of the loss strip below the plan, millimetres."""

HOLD = 2500
"""Milliseconds for which the last frame stays."""

PALETTE = 96
"""Colours of an animation."""


def progress_gif(
    scene: Scene, trace: Trace, *, layout: Layout | None = None, size: int = 600, frames: int = 40, pause: int = 90
) -> bytes:
    """Return the optimisation as a GIF: the plan step by step above the curve of the total loss.

    Args:
        scene: The scene.
        trace: Losses and snapshots of the run; an empty one shows the final layout alone.
        layout: The final layout, added as the last frame and held.
        size: Pixels of the longer side.
        frames: Most frames.
        pause: Milliseconds per frame.
    """
    chosen = [trace.snapshots[k] for k in _spread(len(trace.snapshots), frames - 1)]
    if layout is not None:
        last = max((s.step for s in trace.snapshots), default=0)
        last = max(last, len(trace.losses) - 1)
        chosen.append(Snapshot(last, "result", {name: (p.x, p.y, p.yaw) for name, p in layout.items()}))
    if not chosen:
        raise InputError("progress_gif has nothing to show: the trace has no snapshots and no layout was given.")
    stage = _Stage(scene.room, STRIP if trace.losses else 8.0)
    frame = Frame(13.0, stage.sheet.height - STRIP + 5.0, SHEET - 4.0, stage.sheet.height - 6.5)
    if trace.losses:
        _draw_curve(stage.sheet, frame, trace)
    order = sorted(scene.assets, key=_level)
    painted = [_progress_items(scene, order, snapshot, stage, (frame, len(trace.losses))) for snapshot in chosen]
    return _gif(stage.sheet, painted, size, [*[pause] * (len(chosen) - 1), HOLD])


def walk_gif(
    scene: Scene,
    layout: Layout,
    marks: PlanMarks,
    *,
    agent: Agent | None = None,
    size: int = 600,
    frames: int = 80,
    pause: int = 60,
) -> bytes:
    """Return the agent driving its routes, one after the other, as a GIF.

    Args:
        scene: The scene.
        layout: The layout.
        marks: Routes and free space.
        agent: The body; None takes the scene's first agent.
        size: Pixels of the longer side.
        frames: Most frames.
        pause: Milliseconds per frame.

    Raises:
        InputError: There is no route.
    """
    routes = {name: line for name, line in sorted(marks.routes.items()) if len(line) > 1}
    if not routes:
        raise InputError("walk_gif has nothing to show: the marks have no route.")
    body = agent or scene.agent
    stage = _Stage(scene.room, 8.0)
    quiet = PlanMarks(free=marks.free, islands=marks.islands, blocked=marks.blocked)
    below = Drawing(SHEET, stage.sheet.height)
    draw_contents(below, scene, layout, quiet, stage.place)
    stage.sheet.items[1:1] = below.items
    stage.sheet.items += _names(scene, list(scene.assets), {n: (p.x, p.y, p.yaw) for n, p in layout.items()}, stage)
    painted = [_walk_items(scene, step, routes, body, stage) for step in _walk_steps(routes, frames)]
    return _gif(stage.sheet, painted, size, [*[pause] * (len(painted) - 1), HOLD // 2])


class _Stage:
    """The sheet of every frame: floor and walls, and where metres land on it."""

    def __init__(self, room: Room, strip: float) -> None:
        x0, y0, x1, y1 = room.bounds
        self.scale = min((SHEET - 8.0) / (x1 - x0 + 2 * THICKNESS), 140.0 / (y1 - y0 + 2 * THICKNESS))
        left = (SHEET - (x1 - x0) * self.scale) / 2
        top = 4.0 + THICKNESS * self.scale
        self._origin = (left - x0 * self.scale, top + y1 * self.scale)
        self.sheet = Drawing(SHEET, round(2 * top + (y1 - y0) * self.scale + strip))
        draw_floor(self.sheet, room, self.place)
        draw_walls(self.sheet, room, self.place)

    def place(self, x: float, y: float) -> Point:
        """Return where a point in metres lands, millimetres."""
        return (self._origin[0] + x * self.scale, self._origin[1] - y * self.scale)


def _spread(count: int, most: int) -> list[int]:
    """Return at most `most` indices out of `count`, evenly spread, first and last among them."""
    if count <= most:
        return list(range(count))
    return sorted({round(float(k)) for k in np.linspace(0, count - 1, max(most, 1))})


def _level(asset: Asset) -> int:
    """Return how high an asset lies: rugs, floor, tops, walls, ceiling."""
    if asset.is_flat:
        return 0
    return 4 if asset.on_ceiling else 3 if asset.on_wall else 1 if asset.on_floor else 2


def _draw_curve(sheet: Drawing, frame: Frame, trace: Trace) -> None:
    """Draw the total loss on a logarithmic scale."""
    terms = loss_terms(trace)
    values = terms.get(TOTAL)
    if values is None:
        values = np.nansum(np.stack(list(terms.values())), axis=0)
    draw_panel(sheet, frame, {TOTAL: values}, logarithmic=True)
    sheet.words((frame.left, frame.top - 2.0), "log10 of the loss", 2.7, anchor="start", color=QUIET)


def _progress_items(
    scene: Scene, order: Sequence[Asset], snapshot: Snapshot, stage: _Stage, curve: tuple[Frame, int]
) -> list[Item]:
    """Return what one frame adds: footprints, names, and the place on the curve."""
    sheet = Drawing(SHEET, stage.sheet.height)
    for asset in order:
        if asset.name in snapshot.poses:
            x, y, yaw = snapshot.poses[asset.name]
            draw_footprint(sheet, asset, Pose(x, y, asset.size[2] / 2 + 0.1 * (_level(asset) == 2), yaw), stage.place)
    sheet.items += _names(scene, order, snapshot.poses, stage)
    frame, steps = curve
    if steps:
        x = frame.left + (frame.right - frame.left) * min(snapshot.step / max(steps - 1, 1), 1.0)
        sheet.line([(x, frame.top), (x, frame.bottom)], ROUTE, width=0.45)
        words = snapshot.stage if snapshot.stage == "result" else f"{snapshot.stage}, step {snapshot.step}"
        sheet.words((frame.right, frame.top - 2.0), words, 2.7, anchor="end", color=INK)
    return sheet.items


def _names(
    scene: Scene, order: Sequence[Asset], poses: Mapping[str, tuple[float, float, float]], stage: _Stage
) -> list[Item]:
    """Return the names of the things that are large enough to carry theirs."""
    items: list[Item] = []
    for asset in order:
        if asset.name not in poses or asset.is_flat or asset.on_ceiling:
            continue
        x, y, yaw = poses[asset.name]
        c, s = abs(math.cos(yaw)), abs(math.sin(yaw))
        room_x = (asset.size[0] * c + asset.size[1] * s) * stage.scale
        words = display_name(scene, asset)
        size = min(2.7, 2.7 * (room_x - 4) / text_width(words, 2.7))
        if size >= 2.0 and min(asset.size[:2]) * stage.scale > 3.0:
            items.append(Text(stage.place(x, y), words, size, INK))
    return items


def _walk_steps(routes: Mapping[str, Sequence[Point]], frames: int) -> list[tuple[str, float]]:
    """Return (route, share of its length) per frame, so that the agent moves at one speed."""
    lengths = {name: sum(math.dist(a, b) for a, b in pairwise(line)) for name, line in routes.items()}
    total = max(sum(lengths.values()), 1e-6)
    steps: list[tuple[str, float]] = []
    for name, length in lengths.items():
        count = max(3, round((frames - 3) * length / total))
        steps += [(name, k / (count - 1)) for k in range(count)]
    return [steps[k] for k in _spread(len(steps), frames)]


def _walk_items(
    scene: Scene, step: tuple[str, float], routes: Mapping[str, Sequence[Point]], body: Agent, stage: _Stage
) -> list[Item]:
    """Return what one frame adds: the route, the body on it, and where it goes."""
    name, share = step
    sheet = Drawing(SHEET, stage.sheet.height)
    sheet.line([stage.place(*p) for p in routes[name]], ROUTE, width=0.5)
    x, y, yaw = _along(routes[name], share)
    corners = _body_outline(body, x, y, yaw)
    sheet.polygon([[stage.place(*p) for p in corners]], ROUTE, opacity=0.45, stroke=ROUTE, width=0.4)
    nose = [
        (x + 0.8 * body.radius * math.cos(yaw + a), y + 0.8 * body.radius * math.sin(yaw + a)) for a in (0, 2.5, -2.5)
    ]
    sheet.polygon([[stage.place(*p) for p in nose]], PAPER)
    words = f"to {display_name(scene, scene.by_name[name])}" if name in scene.by_name else f"to {name}"
    sheet.words((SHEET / 2, stage.sheet.height - 5.0), words, 3.4, color=INK)
    return sheet.items


def _along(line: Sequence[Point], share: float) -> tuple[float, float, float]:
    """Return position and heading at a share of a line's length."""
    lengths = [math.dist(a, b) for a, b in pairwise(line)]
    left = share * sum(lengths)
    for (a, b), length in zip(pairwise(line), lengths, strict=True):
        if left <= length or (a, b) == (line[-2], line[-1]):
            t = min(left / max(length, 1e-9), 1.0)
            return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), math.atan2(b[1] - a[1], b[0] - a[0]))
        left -= length
    return (*line[-1], 0.0)


def _body_outline(body: Agent, x: float, y: float, yaw: float) -> list[Point]:
    """Return the outline of the agent: its rectangle if it has one, else its disc."""
    if body.length is not None and body.width is not None:
        return list(Pose(x, y, 0.0, yaw).corners((body.length, body.width, 0.0)))
    angles = [2 * math.pi * k / 32 for k in range(32)]
    return [(x + body.radius * math.cos(a), y + body.radius * math.sin(a)) for a in angles]


def _gif(sheet: Drawing, painted: Sequence[Sequence[Item]], size: int, pauses: Sequence[int]) -> bytes:
    """Return an endless GIF of the sheet with each frame's items painted over it."""
    from PIL import Image as images

    scale = size / max(sheet.width, sheet.height)
    width, height = round(sheet.width * scale), round(sheet.height * scale)
    back = images.new("RGB", (width * SAMPLES, height * SAMPLES), sheet.background)
    paint(back, sheet.items, scale * SAMPLES)

    def frame(items: Sequence[Item]) -> Image:
        big = back.copy()
        paint(big, items, scale * SAMPLES)
        return big.reduce(SAMPLES)

    palette = frame(painted[-1]).quantize(PALETTE, images.Quantize.MEDIANCUT)
    frames = [frame(items).quantize(palette=palette, dither=images.Dither.NONE) for items in painted]
    stream = io.BytesIO()
    frames[0].save(
        stream,
        "GIF",
        save_all=True,
        append_images=frames[1:],
        duration=list(pauses),
        loop=0,
        optimize=False,
        disposal=1,
    )
    return stream.getvalue()
