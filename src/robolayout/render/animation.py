"""How the optimisation went, as a GIF: a plan seen from above, step by step."""

from __future__ import annotations

import io
import math
from collections.abc import Mapping, Sequence

import numpy as np
from PIL import Image

from robolayout._errors import InputError
from robolayout.render._architecture import draw_floor, draw_walls, placing
from robolayout.render._drawing import Drawing, Item, Text, paint, text_width
from robolayout.render._style import FILM, PLAN
from robolayout.render.contents import LEVELS, display_name, draw_footprint, level
from robolayout.render.curves import NO_SEARCH, TOTAL, Frame, draw_panel, is_still, loss_terms
from robolayout.render.palette import INK, PAPER, QUIET, ROUTE
from robolayout.scene import Asset, Layout, Pose, Room, Scene, Snapshot, Trace


def progress_gif(
    scene: Scene, trace: Trace, *, layout: Layout | None = None, size: int = 600, frames: int = 28, pause: int = 130
) -> bytes:
    """Return the optimisation as a GIF: the plan step by step above the curve of the total loss."""
    still = bool(trace.losses) and is_still(trace)
    if still and layout is not None:
        trace = Trace(trace.losses)
    chosen = [trace.snapshots[k] for k in spread(len(trace.snapshots), frames - 1)]
    if layout is not None:
        last = max((s.step for s in trace.snapshots), default=0)
        last = max(last, len(trace.losses) - 1)
        chosen.append(Snapshot(last, "result", {name: (p.x, p.y, p.yaw) for name, p in layout.items()}))
    if not chosen:
        raise InputError("progress_gif has nothing to show: the trace has no snapshots and no layout was given.")
    stage = Stage(scene.room, FILM.strip if trace.losses else 8.0)
    frame = Frame(13.0, stage.sheet.height - FILM.strip + 5.0, FILM.sheet - 4.0, stage.sheet.height - 6.5)
    if still:
        stage.sheet.words((FILM.sheet / 2, (frame.top + frame.bottom) / 2), NO_SEARCH, 3.2, color=INK)
    elif trace.losses:
        _draw_curve(stage.sheet, frame, trace)
    order = sorted(scene.assets, key=lambda asset: LEVELS.index(level(asset)))
    curve = (frame, 0 if still else len(trace.losses))
    painted = [_progress_items(scene, order, snapshot, stage, curve) for snapshot in chosen]
    return _gif(stage.sheet, painted, size, [*[pause] * (len(chosen) - 1), FILM.hold])


class Stage:
    """The sheet of every frame: floor and walls, and where metres land on it."""

    def __init__(self, room: Room, strip: float) -> None:
        x0, y0, x1, y1 = room.bounds
        self.scale = min((FILM.sheet - 8.0) / (x1 - x0 + 2 * PLAN.wall), 140.0 / (y1 - y0 + 2 * PLAN.wall))
        top = 4.0 + PLAN.wall * self.scale
        self.place = placing(room, self.scale, (FILM.sheet - (x1 - x0) * self.scale) / 2, top)
        self.sheet = Drawing(FILM.sheet, round(2 * top + (y1 - y0) * self.scale + strip))
        draw_floor(self.sheet, room, self.place)
        draw_walls(self.sheet, room, self.place)


def spread(count: int, most: int) -> list[int]:
    """Return at most `most` indices out of `count`, evenly spread, first and last among them."""
    if count <= most:
        return list(range(count))
    return sorted({round(float(k)) for k in np.linspace(0, count - 1, max(most, 1))})


def _draw_curve(sheet: Drawing, frame: Frame, trace: Trace) -> None:
    terms = loss_terms(trace)
    values = terms.get(TOTAL)
    if values is None:
        values = np.nansum(np.stack(list(terms.values())), axis=0)
    draw_panel(sheet, frame, {TOTAL: values}, logarithmic=True)
    sheet.words((frame.left, frame.top - 2.0), "log10 of the loss", 2.7, anchor="start", color=QUIET)


def _progress_items(
    scene: Scene, order: Sequence[Asset], snapshot: Snapshot, stage: Stage, curve: tuple[Frame, int]
) -> list[Item]:
    """Return what one frame adds: footprints, names, and the place on the curve."""
    sheet = Drawing(FILM.sheet, stage.sheet.height)
    for asset in order:
        if asset.name in snapshot.poses:
            x, y, yaw = snapshot.poses[asset.name]
            pose = Pose(x, y, asset.size[2] / 2 + 0.1 * (level(asset) == "object"), yaw)
            draw_footprint(sheet, asset, pose, stage.place)
    sheet.items += draw_names(scene, order, snapshot.poses, stage)
    frame, steps = curve
    if steps:
        x = frame.left + (frame.right - frame.left) * min(snapshot.step / max(steps - 1, 1), 1.0)
        sheet.line([(x, frame.top), (x, frame.bottom)], ROUTE, width=0.45)
        words = snapshot.stage if snapshot.stage == "result" else f"{snapshot.stage}, step {snapshot.step}"
        sheet.words((frame.right, frame.top - 2.0), words, 2.7, anchor="end", color=INK)
    return sheet.items


def draw_names(
    scene: Scene, order: Sequence[Asset], poses: Mapping[str, tuple[float, float, float]], stage: Stage
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


def _gif(sheet: Drawing, painted: Sequence[Sequence[Item]], size: int, pauses: Sequence[int]) -> bytes:
    """Return an endless GIF of the sheet with each frame's items painted over it."""
    scale = size / max(sheet.width, sheet.height)
    width, height = round(sheet.width * scale), round(sheet.height * scale)
    back = Image.new("RGB", (width * FILM.samples, height * FILM.samples), PAPER)
    paint(back, sheet.items, scale * FILM.samples)

    def frame(items: Sequence[Item]) -> Image.Image:
        big = back.copy()
        paint(big, items, scale * FILM.samples)
        return big.reduce(FILM.samples)

    palette = frame(painted[-1]).quantize(FILM.search_colors, Image.Quantize.MEDIANCUT)
    return save_gif([frame(items).quantize(palette=palette, dither=Image.Dither.NONE) for items in painted], pauses)


def save_gif(frames: Sequence[Image.Image], pauses: Sequence[int]) -> bytes:
    """Return an endless GIF of frames that share one palette, each shown for its milliseconds."""
    stream = io.BytesIO()
    more = {"save_all": True, "append_images": frames[1:], "duration": list(pauses)}
    frames[0].save(stream, "GIF", loop=0, optimize=False, disposal=1, **more)
    return stream.getvalue()
