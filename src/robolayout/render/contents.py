"""A room and what stands in it, from above: walls, doors and windows as architects draw them, rugs, free space, footprints."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import shapely

from robolayout.render._drawing import Drawing, Point, rectangle
from robolayout.render._style import PLAN
from robolayout.render.palette import BLOCKED, FLOOR, FREE, ISLAND, PAPER, QUIET, WALL, asset_colors
from robolayout.scene import Agent, Asset, Layout, Leaf, Opening, Pose, Room, Scene, Wall, split_name, vertical_span

Rings = tuple[tuple[Point, ...], ...]


@dataclass(frozen=True)
class PlanMarks:
    """Shapes to mark on a plan, in metres."""

    # polygons of the free space that the agent can get to (for its centre), each as rings: outer first, holes
    free: tuple[Rings, ...] = ()
    islands: tuple[Rings, ...] = ()  # polygons of free space that it cannot get to
    # polyline from the entrance to each asset, by name
    routes: Mapping[str, tuple[Point, ...]] = field(default_factory=dict[str, tuple[Point, ...]])
    # narrowest passages: the two points between which it is narrowest, and the width in metres
    passages: tuple[tuple[Point, Point, float], ...] = ()
    blocked: tuple[str, ...] = ()  # names of assets that the agent cannot reach
    agent_at: Point | None = None  # where the agent's disc is drawn, or None
    under: tuple[Rings, ...] = ()  # polygons of the free space under or inside furniture
    # outlines of the parts of such furniture that are in the agent's way (the legs of a table)
    parts: tuple[tuple[Point, ...], ...] = ()
    circles: tuple[tuple[Point, float], ...] = ()  # turning circles: centre, and diameter in metres
    # how far the agent reaches: where it stands to use something, then an arc as a polyline
    arcs: tuple[tuple[Point, ...], ...] = ()
    ghosts: tuple[tuple[Point, ...], ...] = ()  # outlines of things where they stood before
    arrows: tuple[tuple[Point, Point], ...] = ()  # from where a thing stood before to where it stands now
    added: tuple[tuple[Point, ...], ...] = ()  # outlines of things that were not there before
    gone: tuple[tuple[Point, ...], ...] = ()  # outlines of things that are not there any more


Place = Callable[[float, float], Point]


def placing(bounds: tuple[float, ...], k: float, left: float, top: float) -> Place:
    """Return where points of a room land: `k` millimetres to a metre, the upper left corner of its bounds at (left, top)."""
    x0, _, _, y1 = bounds
    return lambda x, y: (left + (x - x0) * k, top + (y1 - y) * k)


def draw_floor(sheet: Drawing, room: Room, place: Place) -> None:
    """Draw the floor."""
    sheet.polygon([[place(x, y) for x, y in room.vertices]], FLOOR)


def draw_walls(sheet: Drawing, room: Room, place: Place) -> None:
    """Draw walls in solid section, doors with leaf and swing, windows with their panes."""
    inner = shapely.Polygon(room.vertices)
    solid = inner.buffer(PLAN.wall, join_style="mitre").difference(inner)
    gaps: list[shapely.Polygon] = []
    for opening in (*room.doors, *room.windows):
        hole = rectangle(opening.offset, 0.01, opening.offset + opening.width, -2 * PLAN.wall)
        gaps.append(shapely.Polygon([room.walls[opening.wall].point(*corner) for corner in hole]))
    solid = solid.difference(shapely.union_all(gaps)) if gaps else solid
    for piece in shapely.get_parts(solid):
        if piece.geom_type == "Polygon" and piece.area > 1e-6:
            rings = [piece.exterior, *piece.interiors]
            sheet.polygon([[place(x, y) for x, y in ring.coords[:-1]] for ring in rings], WALL)
    for window in room.windows:
        _draw_window(sheet, room, window, place)
    for door in room.doors:
        _draw_door(sheet, room, door, place)


def _draw_window(sheet: Drawing, room: Room, window: Opening, place: Place) -> None:
    """Draw the sill's two edges and the pane between them."""
    wall = room.walls[window.wall]
    start, end = window.offset, window.offset + window.width
    frame = [place(*wall.point(*corner)) for corner in rectangle(start, 0, end, -PLAN.wall)]
    sheet.polygon([frame], PAPER, stroke=WALL, width=0.18)
    for depth in (0.42, 0.58):
        pane = (wall.point(start, -depth * PLAN.wall), wall.point(end, -depth * PLAN.wall))
        sheet.line([place(*p) for p in pane], WALL, width=0.13)


def _draw_door(sheet: Drawing, room: Room, door: Opening, place: Place) -> None:
    """Draw the threshold, and each leaf open at the face of the wall to which it opens, with its swing."""
    wall = room.walls[door.wall]
    for depth in (0.0, -PLAN.wall):
        edge = [place(*wall.point(along, depth)) for along in (door.offset, door.offset + door.width)]
        sheet.line(edge, QUIET, width=0.1, dash=(0.6, 0.5))
    for leaf in door.hung():
        sheet.line([place(*p) for p in _swing(wall, leaf)], QUIET, width=0.13)
        face = _face(leaf)
        board = rectangle(leaf.hinge, face, leaf.hinge + leaf.toward * 0.04, face + leaf.into * leaf.width)
        sheet.polygon([[place(*wall.point(*corner)) for corner in board]], PAPER, stroke=WALL, width=0.16)


def swings(room: Room) -> tuple[tuple[Point, ...], ...]:
    """Return the open leaf of each door and the arc of its edge as one line, metres."""
    return tuple(
        (room.walls[door.wall].point(leaf.hinge, _face(leaf)), *reversed(_swing(room.walls[door.wall], leaf)))
        for door in room.doors
        for leaf in door.hung()
    )


def named_at(door: Opening) -> float:
    """Return how far out of the wall a door is named at least, metres: clear of the arcs where two leaves swing out."""
    return 0.8 * door.outward if door.leaves == 2 else 0.0


def _face(leaf: Leaf) -> float:
    """Return the depth of the wall's face at which a leaf hangs, metres into the room."""
    return 0.0 if leaf.into > 0 else -PLAN.wall


def _swing(wall: Wall, leaf: Leaf) -> list[Point]:
    """Return the arc of a leaf's edge, from the wall to where it stands open, metres."""
    angles = [math.pi / 2 * k / 16 for k in range(17)]
    turned = [(leaf.width * math.cos(a), leaf.width * math.sin(a)) for a in angles]
    return [wall.point(leaf.hinge + leaf.toward * x, _face(leaf) + leaf.into * y) for x, y in turned]


@dataclass(frozen=True)
class Shown:
    """What a plan shows, and where it lands on the paper."""

    scene: Scene
    layout: Layout
    marks: PlanMarks
    agent: Agent | None
    place: Place


def draw_contents(sheet: Drawing, shown: Shown) -> None:
    """Draw rugs, free space, then every footprint from the floor up; what hangs from the ceiling is dashed."""
    scene, layout, marks, place = shown.scene, shown.layout, shown.marks, shown.place
    placed = [(asset, layout[asset.name]) for asset in scene.assets if asset.name in layout]
    placed.sort(key=lambda pair: (vertical_span(*pair)[0], -pair[0].size[0] * pair[0].size[1]))
    for asset, pose in placed:
        if asset.is_flat:
            draw_footprint(sheet, asset, pose, place)
    _draw_areas(sheet, marks.free, FREE, place, opacity=0.72)
    _draw_areas(sheet, marks.islands, ISLAND, place, opacity=0.72)
    for asset, pose in placed:
        if not (asset.is_flat or asset.on_ceiling):
            draw_footprint(sheet, asset, pose, place, blocked=asset.name in marks.blocked)
    _draw_areas(sheet, marks.under, FREE, place, opacity=0.6)
    for outline in marks.parts:
        sheet.polygon([[place(x, y) for x, y in outline]], QUIET, opacity=0.3, stroke=QUIET, width=0.12)
    for asset, pose in placed:
        if asset.on_ceiling:
            draw_footprint(sheet, asset, pose, place)


def _draw_areas(sheet: Drawing, areas: tuple[Rings, ...], color: str, place: Place, *, opacity: float) -> None:
    """Fill areas, each given as its outer ring and its holes."""
    for rings in areas:
        sheet.polygon([[place(x, y) for x, y in ring] for ring in rings], color, opacity=opacity)


def draw_footprint(sheet: Drawing, asset: Asset, pose: Pose, place: Place, *, blocked: bool = False) -> None:
    """Draw one asset's box from above, with a small arrow at its front."""
    fill, line = asset_colors(asset)
    corners = [place(*corner) for corner in pose.corners(asset.size)]
    if asset.on_ceiling:
        sheet.polygon([corners], None, stroke=line, width=0.2, dash=(0.9, 0.6), title=asset.name)
        a, b, c, d = cord(pose, place)
        sheet.line([a, c], line, width=0.2)
        sheet.line([b, d], line, width=0.2)
        return
    if asset.is_flat:
        sheet.polygon([corners], fill, stroke=line, width=0.14, opacity=0.55, dash=(0.5, 0.4), title=asset.name)
        return
    raised = vertical_span(asset, pose)[0] > 0.05
    stroke, width = (BLOCKED, 0.6) if blocked else (line, 0.14 if raised else 0.28)
    sheet.polygon([corners], fill, stroke=stroke, width=width, title=asset.name)
    if blocked:
        sheet.line([corners[0], corners[2]], BLOCKED, width=0.2)
        sheet.line([corners[1], corners[3]], BLOCKED, width=0.2)
    if has_arrow(asset):
        sheet.polygon([[place(*p) for p in front(asset, pose)]], line)


def cord(pose: Pose, place: Place) -> tuple[Point, Point, Point, Point]:
    """Return the corners of the cross where the cord of what hangs from the ceiling is fixed, millimetres."""
    x, y = place(pose.x, pose.y)
    return rectangle(x - PLAN.cord, y - PLAN.cord, x + PLAN.cord, y + PLAN.cord)


LEVELS = ("flat", "floor", "object", "wall", "ceiling")  # where things are held, from below


def level(asset: Asset) -> str:
    """Return where an asset is held, one of `LEVELS`."""
    if asset.is_flat:
        return "flat"
    found = {"ceiling": asset.on_ceiling, "wall": asset.on_wall, "floor": asset.on_floor}
    return next((name for name, here in found.items() if here), "object")


def display_name(scene: Scene, asset: Asset) -> str:
    """Return the asset's name for people: "bed", or "night stand 1" where there are several."""
    alike = scene.variables[asset.variable]
    stems = {split_name(other.name)[0] for other in alike}
    words = split_name(asset.name)[0].replace("_", " ").strip()
    if len(stems) > 1 or not words:
        return asset.name
    return f"{words} {asset.index}" if len(alike) > 1 else words


def has_arrow(asset: Asset) -> bool:
    """Return whether the plan shows the asset's front: not of small, flat or hanging things."""
    return min(asset.size[:2]) > 0.26 and not asset.is_flat and not asset.on_ceiling


def front(asset: Asset, pose: Pose) -> list[Point]:
    """Return the small triangle that points out of the asset's front, metres."""
    depth, width, _ = asset.size
    arrow = min(0.08, 0.3 * depth, 0.3 * width)
    tips = ((depth / 2 - 0.2 * arrow, 0.0), (depth / 2 - arrow, 0.7 * arrow), (depth / 2 - arrow, -0.7 * arrow))
    return [pose.point(*tip) for tip in tips]
