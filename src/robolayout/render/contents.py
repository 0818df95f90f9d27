"""What stands in a room, from above: rugs, free space, footprints with their fronts, what hangs."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.render._architecture import Place
from robolayout.render._drawing import Drawing, Point, rectangle
from robolayout.render._style import PLAN
from robolayout.render.marks import PlanMarks, Rings
from robolayout.render.palette import BLOCKED, FREE, ISLAND, QUIET, asset_colors
from robolayout.scene import Agent, Asset, Layout, Pose, Scene, split_name, vertical_span


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
