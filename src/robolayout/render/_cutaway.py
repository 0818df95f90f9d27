"""What is cut away so that a camera outside looks into the room, and how the cut looks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._color import linear
from robolayout.render._mesh import FLOOR_STRIP, ROOM, Mesh, flat_mesh, merge
from robolayout.render._style import VIEW
from robolayout.render.camera import Camera
from robolayout.scene import Layout, Room, Scene, Wall


def near_walls(room: Room, camera: Camera) -> set[int]:
    """Return the indices of the walls that hide more than `VIEW.hides` of the floor from the camera."""
    floor = _floor_points(room)
    eye = np.asarray(camera.position)
    return {wall.index for wall in room.walls if _hidden_share(wall, room.wall_height, eye, floor) > VIEW.hides}


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
        if asset.on_wall and asset.name in layout:
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


def _hidden_share(wall: Wall, height: float, eye: NDArray[np.float64], floor: NDArray[np.float64]) -> float:
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
