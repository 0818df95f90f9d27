"""Pictures of a furnished room: from above, from the side, of one asset, and from an agent's eyes.

`Studio` loads a scene and layout once and draws any number of views; `render_view` and `render_asset` are its one-line
forms. Walls that hide the floor are cut away, so that every view looks into the room.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Literal, Protocol

import numpy as np
import shapely
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from robolayout._color import linear
from robolayout._errors import InputError, UnknownNameError, among
from robolayout.assets import parts
from robolayout.constraints import hangs
from robolayout.render._drawing import font, is_latin
from robolayout.render._mesh import (
    CEILING,
    FLOOR_STRIP,
    ROOM,
    Mesh,
    ceiling_mesh,
    flat_mesh,
    merge,
    parts_mesh,
    scene_mesh,
)
from robolayout.render._style import VIEW
from robolayout.render.camera import Camera, eye_camera, fitted_camera, room_points
from robolayout.scene import Agent, Asset, Layout, Pose, Room, Scene, Wall, check_layout

Renderer = Literal["auto", "gl", "rays"]

SIDE_AZIMUTHS = tuple(math.radians(a) for a in (-60, -120, -30, -150, 30, 150, 60, 120))
"""Azimuths the side view chooses from, radians; the first wins a tie."""


CLOSE_TURNS = tuple(math.radians(a) for a in (-30, 30, -55, 55, 0))

GHOST = "/ghost "
"""Before the name of what hangs from the ceiling where it is drawn as a ghost; no asset's name has a slash."""


class _Draws(Protocol):
    def color(self, camera: Camera, keep: NDArray[np.bool_]) -> NDArray[np.uint8]: ...
    def marks(self, camera: Camera, keep: NDArray[np.bool_]) -> tuple[NDArray[np.int32], NDArray[np.float32]]: ...


@dataclass(frozen=True, eq=False)
class Buffers:
    """A picture with what a machine may ask about it."""

    color: NDArray[np.uint8]  # (height, width, 3) sRGB bytes
    ids: NDArray[np.int32]  # (height, width) -1 background, 0 room, k + 1 the k-th asset of the scene
    depth: NDArray[np.float32]  # (height, width) metres along the line of sight; inf for the background
    names: tuple[str, ...]  # name of each id from 0 on
    camera: Camera  # the camera that took it


class Studio:
    """One scene and layout, ready to be drawn from anywhere; by OpenGL ("gl"), ray casting ("rays"), or the first that works ("auto")."""

    def __init__(self, scene: Scene, layout: Layout, *, renderer: Renderer = "auto", seed: int = 0) -> None:
        check_layout(scene, layout, partial=True)
        self.scene, self.layout = scene, layout
        self._mesh = dress(scene_mesh(scene, layout, seed), scene.room)
        self._mesh = merge(merge(self._mesh, ceiling_mesh(scene.room)), self._ghosts())
        self._renderer: _Draws = make_renderer(self._mesh, *self._blockers(), renderer)

    @cached_property
    def side_azimuth(self) -> float:
        """The side from which most furniture shows its front and most walls that carry things stay, radians."""
        return max(SIDE_AZIMUTHS, key=self._side_score)

    def camera(
        self, view: str, size: tuple[int, int], *, agent: Agent | None = None, stand: tuple[float, float] | None = None
    ) -> Camera:
        """Return the camera of a view (see `render_view`)."""
        room = self.scene.room
        if view == "top":
            return fitted_camera(room_points(room), 0.0, VIEW.top_azimuth, size)
        if view == "side":
            return fitted_camera(room_points(room), VIEW.side_polar, self.side_azimuth, size)
        name = view.removeprefix("eye:")
        if name not in self.layout:
            known = ["top", "side", *self.layout, *(f"eye:{n}" for n in self.layout)]
            raise UnknownNameError("view", view, known)
        pose, asset = self.layout[name], self.scene.by_name[name]
        if name != view:
            return eye_camera(agent or self.scene.agent, stand or _entrance(room), pose, size)
        reach = max(VIEW.close_least, VIEW.close * max(asset.size))
        around = np.array((pose.x, pose.y, pose.z)) + reach * np.array([*product((-1, 1), (-1, 1), (-0.5, 0.5))])
        cameras = [
            fitted_camera(around, polar, pose.yaw + turn, size, fov=math.radians(32), margin=0.02)
            for polar in VIEW.close_polars
            for turn in CLOSE_TURNS
        ]
        return min(cameras, key=lambda camera: self._hidden_share(camera, name))

    def _hidden_share(self, camera: Camera, name: str) -> float:
        """Return the share of points all over an asset's box that other boxes hide from a camera, in coarse steps."""
        pose, size = self.layout[name], np.array(self.scene.by_name[name].size)
        grid = np.array([*product((-0.4, 0, 0.4), repeat=3)]) * size
        points = grid @ _turn(pose).T + (pose.x, pose.y, pose.z)
        hidden = np.zeros(len(points), dtype=np.bool_)
        for other, place in self.layout.items():
            if other != name and not self.scene.by_name[other].is_flat:
                half = np.array(self.scene.by_name[other].size) / 2
                hidden |= _crosses(np.array(camera.position), points, place, half)
        return round(4 * float(hidden.mean())) / 4

    def buffers(self, camera: Camera, *, inside: bool = False) -> Buffers:
        """Return colour, ids and depths seen by a camera; `inside` keeps every wall and draws the ceiling."""
        keep = self._keep(camera, inside)
        ids, depth = self._renderer.marks(camera, keep)
        names = ("room", *(asset.name for asset in self.scene.assets))
        return Buffers(self._renderer.color(camera, keep), ids, depth, names, camera)

    def view(
        self,
        view: str = "top",
        *,
        size: int | tuple[int, int] = 512,
        agent: Agent | None = None,
        stand: tuple[float, float] | None = None,
    ) -> Image.Image:
        """Return a view by name (see `render_view`)."""
        camera = self.camera(view, picture_size(size), agent=agent, stand=stand)
        return Image.fromarray(self._renderer.color(camera, self._keep(camera, view.startswith("eye:"))))

    def shown(self, camera: Camera, *, inside: bool = False) -> Mesh:
        """Return the triangles that a camera is shown, without the strips where walls were cut away."""
        keep = self._keep(camera, inside) & np.array([not n.startswith(FLOOR_STRIP) for n in self._mesh.names])
        return self._mesh.take(keep[self._mesh.groups])

    def _ghosts(self) -> Mesh:
        """Return what hangs from the ceiling once more, as thin as glass, for views from above."""
        names = [asset.name for asset in self.scene.assets if asset.on_ceiling]
        ghosts = self._mesh.take(self._mesh.named(names) & (self._mesh.ids != ROOM))
        colors = ghosts.colors.copy()
        colors[:, 3] *= VIEW.ghostly
        return replace(ghosts, colors=colors, names=tuple(f"{GHOST}{name}" for name in ghosts.names))

    def _keep(self, camera: Camera, inside: bool) -> NDArray[np.bool_]:
        """Return which parts are drawn."""
        hidden = set[str]() if inside else hidden_parts(self.scene, self.layout, camera)
        unseen = FLOOR_STRIP if inside else CEILING
        steep = camera.axes[2][2] < -VIEW.steep
        above = (one for one in self.scene.assets if one.on_ceiling and not inside)
        ghosts = {one.name for one in above if steep or one.size[2] < VIEW.flush}
        hidden |= ghosts | {f"{GHOST}{one.name}" for one in self.scene.assets if one.name not in ghosts}
        return np.array([n not in hidden and not n.startswith(unseen) for n in self._mesh.names], dtype=np.bool_)

    def _blockers(self) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Return which triangles take the sky's light away (not: ceiling, strips, things on walls), and the sun's.

        Walls and what hangs from the ceiling throw no shadow of the sun, so that rooms stay bright and calm.
        """
        hung = {asset.name for asset in self.scene.assets if asset.on_wall}
        above = {asset.name for asset in self.scene.assets if asset.on_ceiling}
        added = {name for name in self._mesh.names if name.startswith((CEILING, FLOOR_STRIP, GHOST))}
        solid = self._mesh.opaque
        sun = solid & (self._mesh.ids != ROOM) & ~self._mesh.named(above)
        return solid & ~self._mesh.named(hung | above | added), sun

    def _side_score(self, azimuth: float) -> float:
        """Return how much of the room a side view from there would show, in square metres of fronts."""
        room, assets = self.scene.room, self.scene.by_name
        camera = fitted_camera(room_points(room), VIEW.side_polar, azimuth, (64, 64))
        cut = near_walls(room, camera)
        windows = sum(o.width * o.height for o in (*room.windows, *room.doors) if o.wall not in cut)
        toward = np.array([math.cos(azimuth), math.sin(azimuth)])
        fronts = sum(float(toward @ p.forward) * assets[n].size[1] * assets[n].size[2] for n, p in self.layout.items())
        return round(fronts + windows, 6)


def render_view(
    scene: Scene,
    layout: Layout,
    *,
    view: str = "top",
    size: int | tuple[int, int] = 512,
    renderer: Renderer = "auto",
    agent: Agent | None = None,
    stand: tuple[float, float] | None = None,
) -> Image.Image:
    """Return a picture of the room.

    Args:
        view: "top", "side" (45 degrees, from where most is seen), an asset's name (close up, from its front), or
            "eye:ASSET": what the agent sees when it looks at that asset.
        agent: Whose eyes an "eye:" view uses; None takes the scene's first agent.
        stand: Where it stands, metres in plan; None is the landing of the first door, or the middle of the room.
    """
    return Studio(scene, layout, renderer=renderer).view(view, size=size, agent=agent, stand=stand)


def render_asset(
    asset: Asset, *, size: int | tuple[int, int] = 512, renderer: Renderer = "auto", seed: int = 0
) -> Image.Image:
    """Return a picture of one asset alone, from its front, a little from its right and from above."""
    mesh = parts_mesh(parts(asset, seed), asset.name)
    box = np.array([*product((-0.5, 0.5), repeat=3)]) * asset.size
    camera = fitted_camera(box, math.radians(65), math.radians(-32), picture_size(size), margin=0.08)
    reach, low = 15 * max(asset.size), -asset.size[2] / 2
    a, b, c, d = ((x * reach, y * reach, low) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    scenery = merge(mesh, flat_mesh(np.array([(a, b, c), (a, c, d)]), (0.9, 0.9, 0.9), "ground"))
    solid = scenery.opaque & (scenery.ids != ROOM)
    drawn = make_renderer(scenery, solid, solid, renderer)
    return Image.fromarray(drawn.color(camera, np.ones(len(scenery.names), np.bool_)))


def asset_sheet(assets: Sequence[Asset], *, tile: int = 200, seed: int = 0) -> Image.Image:
    """Return a sheet with a picture of every asset, `tile` pixels a side, row by row, its category below it."""
    columns = min(VIEW.columns, math.ceil(math.sqrt(len(assets))))
    label = tile // 8
    size = (columns * tile, math.ceil(len(assets) / columns) * (tile + label))
    sheet = Image.new("RGB", size, (246, 245, 241))
    draw = ImageDraw.Draw(sheet)
    for number, asset in enumerate(assets):
        x, y = number % columns * tile, number // columns * (tile + label)
        sheet.paste(render_asset(asset, size=tile, seed=seed), (x, y))
        face = font(max(8, label // 2), is_latin(asset.category))
        draw.text((x + tile / 2, y + tile + label / 2), asset.category, (40, 40, 40), face, anchor="mm")
    return sheet


def make_renderer(mesh: Mesh, sky: NDArray[np.bool_], sun: NDArray[np.bool_], renderer: Renderer = "auto") -> _Draws:
    """Return the renderer asked for, or with "auto" the fast one if this machine has EGL and else ray casting.

    `sky` and `sun` say which triangles take the light of each away.
    """
    among("renderer", [renderer], ["auto", "gl", "rays"])
    from robolayout.render._rays import RayRenderer

    if renderer == "rays":
        return RayRenderer(mesh, sky, sun)
    from robolayout.render._gl import GLRenderer, why_unavailable

    reason = why_unavailable()
    if reason is None:
        return GLRenderer(mesh, sky, sun)
    if renderer == "auto":
        return RayRenderer(mesh, sky, sun)
    raise InputError(f"renderer 'gl' does not work on this machine: {reason}. Use renderer='auto' or 'rays'.")


def picture_size(size: int | tuple[int, int]) -> tuple[int, int]:
    """Return (width, height) in pixels, each 16 to 8192; an int is a square."""
    width, height = (size, size) if isinstance(size, int) else size
    if not (16 <= width <= VIEW.largest and 16 <= height <= VIEW.largest):
        raise InputError(
            f"picture size {width} x {height} is not possible: each side must be 16 to {VIEW.largest} pixels."
        )
    return width, height


def _turn(pose: Pose) -> NDArray[np.float64]:
    """Return the rotation from an asset's frame to the room's."""
    c, s = pose.forward
    return np.array([(c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)])


def _crosses(
    start: NDArray[np.float64], ends: NDArray[np.float64], pose: Pose, half: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """Return for each straight line from `start` to one of `ends` (n, 3) whether it crosses a box."""
    back, middle = _turn(pose), (pose.x, pose.y, pose.z)
    near, far = (start - middle) @ back, (ends - middle) @ back
    step = far - near
    step = np.where(np.abs(step) < 1e-12, 1e-12, step)
    first, second = (-half - near) / step, (half - near) / step
    enter, leave = np.minimum(first, second).max(axis=1), np.maximum(first, second).min(axis=1)
    return (enter < leave) & (leave > 0.0) & (enter < 1.0)


def _entrance(room: Room) -> tuple[float, float]:
    """Return where an agent enters, metres in plan: 0.3 m inside the first door, else a point inside the room."""
    if room.doors:
        door = room.doors[0]
        return room.walls[door.wall].point(door.center, 0.3)
    point = shapely.Polygon(room.vertices).representative_point()
    return (point.x, point.y)


def near_walls(room: Room, camera: Camera) -> set[int]:
    """Return the indices of the walls that hide more than `VIEW.hides` of the floor from the camera."""
    floor = _floor_points(room)
    eye = np.asarray(camera.position)
    return {wall.index for wall in room.walls if _covered_share(wall, room.wall_height, eye, floor) > VIEW.hides}


def hidden_parts(scene: Scene, layout: Layout, camera: Camera) -> set[str]:
    """Return the names of the parts to leave out: near walls, their openings, and what hangs on them."""
    room = scene.room
    cut = near_walls(room, camera)
    names = {f"wall-{index}" for index in cut}
    names |= {f"door-{k}" for k, door in enumerate(room.doors) if door.wall in cut}
    names |= {f"skirting-{index}" for index in cut}
    names |= {f"window-{k}" for k, window in enumerate(room.windows) if window.wall in cut}
    names |= {f"{FLOOR_STRIP}-{wall.index}" for wall in room.walls if wall.index not in cut}
    for asset in scene.assets:
        if asset.on_wall and asset.name in layout and hangs(asset, scene, layout):
            pose = layout[asset.name]
            nearest = min(room.walls, key=lambda wall: wall.distance((pose.x, pose.y)))
            if nearest.index in cut and nearest.distance((pose.x, pose.y)) < asset.size[0] / 2 + VIEW.on_wall:
                names.add(asset.name)
    return names


def dress(mesh: Mesh, room: Room) -> Mesh:
    """Return the mesh with the tops of walls in the colour of a cut, and a strip on the ground for every wall."""
    walls = mesh.named(name for name in mesh.names if name.startswith("wall-")) & (mesh.ids == ROOM)
    top = walls & (mesh.normals[:, :, 2] > 0.9).all(axis=1)
    top &= mesh.corners[:, :, 2].min(axis=1) > room.wall_height - 0.01
    colors = mesh.colors.copy()
    colors[top, :3] = linear(np.array(VIEW.cut_color))
    dressed = replace(mesh, colors=colors)
    for wall in room.walls:
        strip = _strip(mesh, room, wall)
        if len(strip):
            dressed = merge(dressed, flat_mesh(strip, VIEW.cut_color, f"{FLOOR_STRIP}-{wall.index}"))
    return dressed


def _strip(mesh: Mesh, room: Room, wall: Wall) -> NDArray[np.float64]:
    """Return the triangles (n, 3, 3) of a cut 1 cm above the floor, as thick as the wall's parts, open at doors."""
    corners = mesh.corners[mesh.named([f"wall-{wall.index}"])].reshape(-1, 3)[:, :2].astype(np.float64)
    if not len(corners):
        return np.zeros((0, 3, 3))
    along = (corners - wall.start) @ np.array(wall.direction)
    outward = float(-((corners - wall.start) @ np.array(wall.normal)).min())
    doors = sorted((d for d in room.doors if d.wall == wall.index), key=lambda d: d.offset)
    stops = [float(along.min()), *(v for d in doors for v in (d.offset, d.offset + d.width)), float(along.max())]
    triangles: list[list[tuple[float, float, float]]] = []
    for start, end in zip(stops[::2], stops[1::2], strict=True):
        if end - start > 1e-3 and outward > 1e-3:
            a, b, c, d = (
                (*wall.point(s, depth), 0.01) for s, depth in ((start, -outward), (end, -outward), (end, 0), (start, 0))
            )
            triangles += [[a, b, c], [a, c, d]]
    return np.array(triangles).reshape(-1, 3, 3)


def _floor_points(room: Room) -> NDArray[np.float64]:
    """Return a grid of points (n, 3) on the floor, inside the room."""
    x0, y0, x1, y1 = room.bounds
    xs, ys = np.meshgrid(np.linspace(x0, x1, 32)[1:-1], np.linspace(y0, y1, 32)[1:-1])
    inside = shapely.contains_xy(shapely.Polygon(room.vertices), xs, ys)
    return np.column_stack([xs[inside], ys[inside], np.full(int(inside.sum()), 0.02)])


def _covered_share(wall: Wall, height: float, eye: NDArray[np.float64], floor: NDArray[np.float64]) -> float:
    """Return the share of floor points (n, 3) whose line to the eye crosses the wall's rectangle."""
    normal = np.array([*wall.normal, 0.0])
    corner = np.array([*wall.start, 0.0])
    lines = floor - eye
    slope = lines @ normal
    share = ((corner - eye) @ normal) / np.where(np.abs(slope) < 1e-9, 1e-9, slope)
    hit = eye + share[:, None] * lines
    along = (hit[:, :2] - wall.start) @ np.array(wall.direction)
    crosses = (share > 0) & (share < 1 - 1e-6) & (along > 0) & (along < wall.length)
    return float((crosses & (hit[:, 2] > 0) & (hit[:, 2] < height)).mean()) if len(floor) else 0.0
