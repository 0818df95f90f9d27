"""Moving pictures: how the search went, step by step, and the agent on its round, as GIFs.

On the round the body, at its true size, goes from the door to each asset and back. Ways lead from the door to each thing. Between two
of them the agent goes back along the one until they part, or until it can cut straight across free space to the other; what is
nearest then comes next.
"""

from __future__ import annotations

import io
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from PIL import Image

from robolayout._errors import InputError
from robolayout.render._drawing import Drawing, Item, Text, circle, paint, text_width
from robolayout.render._style import FILM, PLAN
from robolayout.render.contents import (
    LEVELS,
    PlanMarks,
    Rings,
    Shown,
    display_name,
    draw_contents,
    draw_floor,
    draw_footprint,
    draw_walls,
    level,
    placing,
)
from robolayout.render.curves import NO_SEARCH, TOTAL, Frame, draw_panel, is_still, loss_terms
from robolayout.render.palette import INK, PAPER, QUIET, ROUTE
from robolayout.scene import Agent, Asset, Layout, Point, Pose, Room, Scene, Snapshot, Trace


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
    stage = FrameSheet(scene.room, FILM.strip if trace.losses else 8.0)
    frame = Frame(13.0, stage.sheet.height - FILM.strip + 5.0, FILM.sheet - 4.0, stage.sheet.height - 6.5)
    if still:
        stage.sheet.words((FILM.sheet / 2, (frame.top + frame.bottom) / 2), NO_SEARCH, 3.2, color=INK)
    elif trace.losses:
        _draw_curve(stage.sheet, frame, trace)
    order = sorted(scene.assets, key=lambda asset: LEVELS.index(level(asset)))
    curve = (frame, 0 if still else len(trace.losses))
    painted = [_progress_items(scene, order, snapshot, stage, curve) for snapshot in chosen]
    return _gif(stage.sheet, painted, size, [*[pause] * (len(chosen) - 1), FILM.hold])


class FrameSheet:
    """The sheet of every frame: floor and walls, and where metres land on it."""

    def __init__(self, room: Room, strip: float) -> None:
        bounds = x0, y0, x1, y1 = room.extent()
        self.scale = min((FILM.sheet - 8.0) / (x1 - x0 + 2 * PLAN.wall), 140.0 / (y1 - y0 + 2 * PLAN.wall))
        top = 4.0 + PLAN.wall * self.scale
        self.place = placing(bounds, self.scale, (FILM.sheet - (x1 - x0) * self.scale) / 2, top)
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
    scene: Scene, order: Sequence[Asset], snapshot: Snapshot, stage: FrameSheet, curve: tuple[Frame, int]
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
    scene: Scene, order: Sequence[Asset], poses: Mapping[str, tuple[float, float, float]], stage: FrameSheet
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


Line = NDArray[np.float64]  # (n, 3): x and y in metres and heading in radians; 0 where the agent just looks ahead


def walk_gif(
    scene: Scene,
    layout: Layout,
    marks: PlanMarks,
    *,
    ways: Mapping[str, Sequence[tuple[float, ...]]] | None = None,
    agent: Agent | None = None,
    size: int = 600,
    frames: int = 120,
) -> bytes:
    """Return the agent on its round as a GIF: from the door to each asset in a short order, and back.

    Args:
        ways: The ways that it takes, by asset (`AgentReport.ways`): x, y and, of a body that is no disc, its heading, which it
            then keeps; None takes the routes of the marks.
    """
    ways = marks.routes if ways is None else ways
    ways = {name: way for name, way in ways.items() if len(way) > 1 and name in scene.by_name}
    if not ways:
        raise InputError("walk_gif has nothing to show: there is no way from the door to anything.")
    body, driven = agent or scene.agent, all(len(way[0]) > 2 for way in ways.values())
    legs = tour(ways, () if driven else marks.free)
    steps = _steps(legs, frames)
    places = np.array([place for place, *_ in steps])
    yaws = places[:, 2] if driven else _ahead(places)
    film = _Film(scene, layout, marks, body, size)
    poses = [Pose(x, y, 0.0, yaw) for (x, y), yaw in zip(places[:, :2].tolist(), yaws.tolist(), strict=True)]
    shown = [film.frame(legs[number], pose) for (_, number, _), pose in zip(steps, poses, strict=True)]
    waits = [FILM.pause * (FILM.stop if stops else 1) for *_, stops in steps]
    return save_gif(shown, [*waits[:-1], FILM.hold // 2])


@dataclass(frozen=True, eq=False)
class Leg:
    """A way to one stop."""

    names: tuple[str, ...]  # assets that are reached at its end; empty for the way back to the door
    line: Line  # the way

    @property
    def length(self) -> float:
        """Metres, turns counted."""
        return float(_spent(self.line)[-1])


def tour(ways: Mapping[str, Sequence[tuple[float, ...]]], free: Sequence[Rings]) -> tuple[Leg, ...]:
    """Return the legs of a round over all ways, the way back to their common start last.

    Args:
        ways: Way from the door to each asset by name: x and y in metres and, where it is given, the heading in radians.
        free: Polygons of the free space of the agent's centre, as rings; without them it only goes along ways.
    """
    space = shapely.union_all([shapely.Polygon(rings[0], rings[1:]) for rings in free if rings])
    space = shapely.buffer(space, FILM.slack)
    shapely.prepare(space)
    lines = {names: _dense(np.array(ways[names[0]], dtype=np.float64)) for names in _stops(ways)}
    legs: list[Leg] = []
    before = next(iter(lines.values()))[:1]
    while lines:
        near = sorted(lines, key=lambda names: math.dist(lines[names][-1, :2], before[-1, :2]))[: FILM.nearest]
        legs.append(min((Leg(n, _between(before, lines[n], space)) for n in near), key=lambda leg: leg.length))
        before = lines.pop(legs[-1].names)
    return (*legs, Leg((), before[::-1]))


def _stops(ways: Mapping[str, Sequence[tuple[float, ...]]]) -> list[tuple[str, ...]]:
    """Return the names of the assets in groups that are visited at once."""
    groups: list[list[str]] = []
    for name, line in sorted(ways.items()):
        near = [g for g in groups if math.dist(ways[g[0]][-1][:2], line[-1][:2]) <= FILM.together]
        if near:
            near[0].append(name)
        else:
            groups.append([name])
    return [tuple(group) for group in groups]


def _spent(line: Line) -> NDArray[np.float64]:
    """Return the way from a line's start to each of its points, metres, turns counted."""
    moved = np.abs(np.diff(line, axis=0))
    return np.concatenate([[0.0], np.cumsum(np.hypot(moved[:, 0], moved[:, 1]) + FILM.turn * moved[:, 2])])


def _dense(line: Line) -> Line:
    """Return a line with a point at least every `FILM.spacing` metres, from one without headings one with none."""
    line = np.pad(line, ((0, 0), (0, 3 - line.shape[1])))
    pieces = [line[:1]]
    for a, b, far in zip(line, line[1:], np.diff(_spent(line)), strict=False):
        count = max(1, math.ceil(far / FILM.spacing))
        pieces.append(a + (b - a) * (np.arange(1, count + 1) / count)[:, None])
    return np.concatenate(pieces)


def _between(one: Line, other: Line, space: shapely.Geometry) -> Line:
    """Return the shortest way from the end of one line to the end of another: back, across, and on."""
    back, on = _spent(one)[-1] - _spent(one), _spent(other)[-1] - _spent(other)
    across = np.linalg.norm(one[:, None] - other[None], axis=2)
    total = back[:, None] + across + on[None]
    order = np.argsort(total, axis=None, kind="stable")
    for some in np.array_split(order, max(1, len(order) // 24)):
        i, j = np.unravel_index(some, total.shape)
        chords = shapely.linestrings(np.stack([one[i, :2], other[j, :2]], axis=1))
        fits = shapely.covers(space, chords) | (across[i, j] < FILM.slack)
        if fits.any():
            k = int(np.argmax(fits))
            return np.concatenate([one[i[k] :][::-1], other[j[k] :]])
    return np.concatenate([one[::-1], other])


def _steps(legs: Sequence[Leg], frames: int) -> list[tuple[Line, int, bool]]:
    """Return the body's place (x, y, heading) in each frame, the number of its leg, and whether it has come to that leg's end.

    It moves at one speed and is seen at every stop.
    """
    total = sum(leg.length for leg in legs)
    pace = max(FILM.slow, total / max(frames - len(legs) - 1, 1))
    steps = [(legs[0].line[0], 0, False)]
    for number, leg in enumerate(legs):
        count, far = max(1, round(leg.length / pace)), _spent(leg.line)
        for k in range(1, count + 1):
            place = np.array([np.interp(leg.length * k / count, far, column) for column in leg.line.T])
            steps.append((place, number, k == count))
    return [steps[k] for k in spread(len(steps), max(frames, 2))]


def _ahead(places: Line) -> Line:
    """Return the direction of travel at every place, radians; where it stands still, that of before."""
    moves = np.diff(places, axis=0, append=places[-1:])
    angles = np.arctan2(moves[:, 1], moves[:, 0])
    for k in np.flatnonzero(np.hypot(moves[:, 0], moves[:, 1]) < 1e-6):
        angles[k] = angles[k - 1] if k else 0.0
    return angles


class _Film:
    """The unchanging picture of every leg, onto which each frame paints only the body."""

    def __init__(self, scene: Scene, layout: Layout, marks: PlanMarks, body: Agent, size: int) -> None:
        self._stage = FrameSheet(scene.room, FILM.foot)
        sheet = self._stage.sheet
        below = Drawing(FILM.sheet, sheet.height)
        draw_contents(below, Shown(scene, layout, marks, body, self._stage.place))
        sheet.items[1:1] = below.items
        poses = {name: (pose.x, pose.y, pose.yaw) for name, pose in layout.items()}
        sheet.items += draw_names(scene, list(scene.assets), poses, self._stage)
        self._scale = FILM.samples * size / max(sheet.width, sheet.height)
        width, height = (FILM.samples * round(v * self._scale / FILM.samples) for v in (sheet.width, sheet.height))
        self._plan = Image.new("RGB", (width, height), PAPER)
        paint(self._plan, sheet.items, self._scale)
        self._palette = self._colours()
        self._scene, self._layout, self._body = scene, layout, body
        self._leg: Leg | None = None

    def frame(self, leg: Leg, pose: Pose) -> Image.Image:
        """Return the picture of the body on a leg, in the palette of all frames."""
        if leg is not self._leg:
            self._leg, self._back = leg, self._plan.copy()
            paint(self._back, self._leg_items(leg), self._scale)
            self._small = self._quantized(self._back)
        k = self._scale / FILM.samples
        sheet = Drawing(FILM.sheet, self._stage.sheet.height)
        outline = [self._stage.place(*corner) for corner in _outline(self._body, pose)]
        sheet.polygon([outline], ROUTE, opacity=0.45, stroke=ROUTE, width=0.4)
        sheet.polygon([[self._stage.place(*corner) for corner in _arrow(self._body, pose)]], PAPER)
        left, top = (max(0, math.floor(min(v) * k) - 3) for v in zip(*outline, strict=True))
        right, bottom = (math.ceil(max(v) * k) + 3 for v in zip(*outline, strict=True))
        box = (left, top, min(right, self._small.width), min(bottom, self._small.height))
        patch = self._back.crop(
            (FILM.samples * box[0], FILM.samples * box[1], FILM.samples * box[2], FILM.samples * box[3])
        )
        paint(patch, sheet.moved(-left / k, -top / k), self._scale)
        picture = self._small.copy()
        picture.paste(self._quantized(patch), box[:2])
        return picture

    def _leg_items(self, leg: Leg) -> list[Item]:
        """Return what a leg adds to the plan: its way, its goals, and where it leads in words."""
        place, sheet = self._stage.place, Drawing(FILM.sheet, self._stage.sheet.height)
        for name in leg.names:
            if name in self._layout:
                corners = self._layout[name].corners(self._scene.by_name[name].size)
                sheet.polygon([[place(*corner) for corner in corners]], None, stroke=ROUTE, width=0.7)
        line = [place(x, y) for x, y in leg.line[:, :2].tolist()]
        sheet.line(line, PAPER, width=1.1)
        sheet.line(line, ROUTE, width=0.5)
        words = self._words(leg)
        sheet.words((FILM.sheet / 2, sheet.height - 5.0), words, min(3.6, 3.6 * 52 / max(len(words), 1)), color=INK)
        return sheet.items

    def _words(self, leg: Leg) -> str:
        names = [display_name(self._scene, self._scene.by_name[name]) for name in leg.names]
        if not names:
            return "back to the door"
        shown = names if len(names) <= 3 else [*names[:2], f"{len(names) - 2} more"]
        return "to " + " and ".join([", ".join(shown[:-1]), shown[-1]] if len(shown) > 1 else shown)

    def _colours(self) -> Image.Image:
        """Return a picture whose palette serves every frame."""
        sample = self._plan.reduce(FILM.samples)
        spot = (4, 4, sample.width // 6, sample.height // 6)
        for k, mix in enumerate((ROUTE, "#3a8fc4", "#8dbddb", PAPER, "#5aa3cf", INK, "#6e6e6e", "#b0b0b0")):
            sample.paste(mix, (spot[0] + 9 * k, spot[1], spot[0] + 9 * k + 9, spot[1] + 60))
        return sample.quantize(FILM.walk_colors, kmeans=2)

    def _quantized(self, picture: Image.Image) -> Image.Image:
        return picture.reduce(FILM.samples).quantize(palette=self._palette, dither=Image.Dither.NONE)


def _outline(body: Agent, pose: Pose) -> list[Point]:
    """Return the outline of the agent in metres: its rectangle if it has one, else its disc."""
    if body.length is not None and body.width is not None:
        return list(pose.corners((body.length, body.width, 0.0)))
    return circle((pose.x, pose.y), body.radius, 32)


def _arrow(body: Agent, pose: Pose) -> list[Point]:
    """Return the arrow in metres that shows where the agent's front is."""
    reach = 0.7 * (min(body.length, body.width) / 2 if body.length and body.width else body.radius)
    tips = ((0.0, reach), (2.5, reach), (math.pi, 0.4 * reach), (-2.5, reach))
    return [(pose.x + r * math.cos(pose.yaw + a), pose.y + r * math.sin(pose.yaw + a)) for a, r in tips]
