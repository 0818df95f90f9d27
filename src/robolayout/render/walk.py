"""The agent on its round: a plan on which the body, at its true size, goes from the door to each asset and back, as GIF.

Ways lead from the door to each thing. Between two of them the agent goes back along the one until they part, or until it can cut
straight across free space to the other; what is nearest then comes next.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from PIL import Image

from robolayout._errors import InputError
from robolayout.render._drawing import Drawing, Item, circle, paint
from robolayout.render._style import FILM
from robolayout.render.animation import Stage, draw_names, save_gif, spread
from robolayout.render.contents import Shown, display_name, draw_contents
from robolayout.render.marks import PlanMarks, Rings
from robolayout.render.palette import INK, PAPER, ROUTE
from robolayout.scene import Agent, Layout, Point, Pose, Scene

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
    places = np.array([step.place for step in steps])
    yaws = places[:, 2] if driven else _ahead(places)
    film = _Film(scene, layout, marks, body, size)
    poses = [Pose(x, y, 0.0, yaw) for (x, y), yaw in zip(places[:, :2].tolist(), yaws.tolist(), strict=True)]
    shown = [film.frame(legs[step.leg], pose) for step, pose in zip(steps, poses, strict=True)]
    waits = [FILM.pause * (FILM.stop if step.stop else 1) for step in steps]
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


@dataclass(frozen=True, eq=False)
class _Step:
    """Where the body is in one frame, on which leg, and whether it has come to that leg's end."""

    place: Line  # (3,) x and y in metres and heading in radians
    leg: int
    stop: bool


def _steps(legs: Sequence[Leg], frames: int) -> list[_Step]:
    """Return the body's places, one per frame, so that it moves at one speed and is seen at every stop."""
    total = sum(leg.length for leg in legs)
    pace = max(FILM.slow, total / max(frames - len(legs) - 1, 1))
    steps = [_Step(legs[0].line[0], 0, stop=False)]
    for number, leg in enumerate(legs):
        count, far = max(1, round(leg.length / pace)), _spent(leg.line)
        for k in range(1, count + 1):
            place = np.array([np.interp(leg.length * k / count, far, column) for column in leg.line.T])
            steps.append(_Step(place, number, stop=k == count))
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
        self._stage = Stage(scene.room, FILM.foot)
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
