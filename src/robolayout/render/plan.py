"""The plan: a room to scale, as an architect would draw it, with what the agent can do in it.

`draw_plan` makes the drawing, `draw_comparison` several of them side by side at one scale.
"""

from __future__ import annotations

from collections.abc import Sequence

from robolayout._errors import InputError
from robolayout.render._drawing import Drawing, Point, rectangle, text_width
from robolayout.render._marked import Naming, draw_labels, draw_marks
from robolayout.render._style import PLAN
from robolayout.render.contents import PlanMarks, Shown, draw_contents, draw_floor, draw_walls, placing, swings
from robolayout.render.palette import BLOCKED, FREE, INK, ISLAND, NARROW, PAPER, QUIET, REACH, ROUTE, TIGHT, TURN
from robolayout.scene import Agent, Layout, Scene

LEGEND = (
    ("free", "area", FREE, "free to move"),
    ("islands", "area", ISLAND, "cut off"),
    ("routes", "line", ROUTE, "route"),
    ("passages", "line", NARROW, "narrowest"),
    ("circles", "dash", TURN, "turning circle"),
    ("arcs", "line", REACH, "reach"),
    ("blocked", "cross", BLOCKED, "out of reach"),
    ("ghosts", "dash", QUIET, "stood before"),
    ("arrows", "line", ROUTE, "moved"),
    ("added", "line", NARROW, "new"),
    ("gone", "cross", TIGHT, "gone"),
)
"""Marks of a plan (fields of `PlanMarks`) in the legend: how they are drawn there, and in words."""

LINES: dict[str, tuple[float, tuple[float, float] | None]] = {"line": (0.5, None), "dash": (0.35, (1.1, 0.6))}
"""Width, dash and gap of the lines in the legend, millimetres."""

Panel = tuple[str, Scene, Layout, PlanMarks | None]
"""Title, scene (its first agent is the panel's body), layout and marks of one plan."""


def plan_svg(
    scene: Scene,
    layout: Layout,
    *,
    navigation: PlanMarks | None = None,
    agent: Agent | None = None,
    title: str | None = None,
) -> str:
    """Return the plan as SVG text, to scale (see `draw_plan`)."""
    return draw_plan(scene, layout, navigation=navigation, agent=agent, title=title).svg()


def draw_plan(
    scene: Scene,
    layout: Layout,
    *,
    navigation: PlanMarks | None = None,
    agent: Agent | None = None,
    title: str | None = None,
    names: bool = True,
    scale: int | None = None,
) -> Drawing:
    """Return the plan of a room as a drawing in paper millimetres.

    Args:
        navigation: What the agent can do: free space, routes, passages, blocked assets.
        names: Whether things are named; finding places for names takes most of the time.
        scale: Denominator of the scale (50 is 1:50); None chooses.
    """
    marks = navigation or PlanMarks()
    scale = scale or plan_scale(scene)
    k = 1000 / scale
    bounds = x0, y0, x1, y1 = scene.room.extent((PLAN.margin - PLAN.least) / k)
    head = 5.0 if title else 0.0
    foot = 15.0 if agent is not None or navigation is not None else 9.0
    border = PLAN.margin + PLAN.wall * k
    width = max((x1 - x0) * k + 2 * border, 46.0)
    left = (width - (x1 - x0) * k) / 2
    sheet = Drawing(width, (y1 - y0) * k + 2 * border + head + foot)

    if title:
        sheet.words((width / 2, 6.0), title, min(3.4, 3.4 * (width - 8) / max(text_width(title, 3.4), 1)), color=INK)
    box = (1.0, 1.0, sheet.width - 1, sheet.height - 1)
    naming = Naming(box, lines=swings(scene.room)) if names else None
    draw_room(sheet, Shown(scene, layout, marks, agent, placing(bounds, k, left, head + border)), naming)
    _draw_foot(sheet, agent, navigation, scale, left)
    return sheet


def draw_comparison(panels: Sequence[Panel]) -> Drawing:
    """Return plans side by side: all at the scale of the largest room, tops aligned; at least one is needed."""
    if not panels:
        raise InputError("a comparison has nothing to show: give at least one (title, scene, layout, marks).")
    scale = max(plan_scale(scene) for _, scene, _, _ in panels)
    plans = [
        draw_plan(scene, layout, navigation=marks, agent=scene.agent, title=title, scale=scale)
        for title, scene, layout, marks in panels
    ]
    sheet = Drawing(sum(plan.width for plan in plans), max(plan.height for plan in plans))
    left = 0.0
    for plan in plans:
        sheet.items += plan.moved(left, 0.0)
        left += plan.width
    return sheet


def draw_room(sheet: Drawing, shown: Shown, naming: Naming | None) -> None:
    """Draw the room and what stands in it, then what is marked, then the names, if it is said how to name."""
    draw_floor(sheet, shown.scene.room, shown.place)
    draw_contents(sheet, shown)
    draw_marks(sheet, shown)
    draw_walls(sheet, shown.scene.room, shown.place)
    if naming is not None:
        draw_labels(sheet, shown, naming)


def plan_scale(scene: Scene) -> int:
    """Return the denominator of the scale at which the room fits the sheet."""
    x0, y0, x1, y1 = scene.room.bounds
    longest = max(x1 - x0, y1 - y0) * 1000
    return next(
        (s for s in PLAN.scales if longest / s <= PLAN.longest and longest / s > 0 and (s > 25 or longest < 2500)),
        PLAN.scales[-1],
    )


def _draw_foot(sheet: Drawing, agent: Agent | None, marks: PlanMarks | None, scale: int, left: float) -> None:
    """Draw the scale bar and, where there is something to explain, the agent and the legend."""
    y = sheet.height - 5.0
    bar = draw_scale_bar(sheet, (left, y), scale, sheet.width / 3)
    sheet.words((sheet.width - left, y + 2.2), f"1 : {scale}", 1.8, color=QUIET, anchor="end")
    if agent is not None:
        name = agent.title or agent.name
        room = sheet.width - left - (left + bar + 6)
        size = min(2.2, 2.2 * room / max(text_width(name, 2.2), 0.1))
        sheet.words((sheet.width - left, y - 0.6), name, size, anchor="end")
    if marks is not None:
        draw_legend(sheet, marks, (left, y - 5.2), sheet.width - 2 * left)


def draw_scale_bar(sheet: Drawing, at: Point, scale: int, width: float) -> float:
    """Draw a bar of whole metres from a point on, at most about `width` millimetres long; return its length."""
    k, (left, y) = 1000 / scale, at
    metres = next((m for m in (2, 1, 0.5) if m * k <= width), 0.5) if scale <= 50 else 10 * scale / 500
    step = metres * k / 4
    for i in range(4):
        x = left + i * step
        sheet.polygon([rectangle(x, y - 0.5, x + step, y + 0.5)], (INK, PAPER)[i % 2], stroke=INK, width=0.13)
    sheet.words((left, y + 2.2), "0", 1.8, color=QUIET)
    sheet.words((left + 4 * step, y + 2.2), f"{metres:g} m", 1.8, color=QUIET)
    return 4 * step


def draw_legend(sheet: Drawing, marks: PlanMarks, at: Point, width: float) -> None:
    """Explain the marks that are on the plan, in one row of at most `width` millimetres."""
    (x, y), size = at, 1.9
    rows = [row for name, *row in LEGEND if getattr(marks, name)]
    total = sum(6.0 + text_width(words, size) for *_, words in rows)
    size *= min(1.0, width / max(total, 1))
    for kind, color, words in rows:
        box = rectangle(x, y - 0.9, x + 3, y + 0.9)
        if kind == "area":
            sheet.polygon([box], color, stroke=QUIET, width=0.1)
        elif kind in LINES:
            width, dash = LINES[kind]
            sheet.line([(x, y), (x + 3, y)], color, width=width, dash=dash)
        else:
            sheet.line([box[0], box[2]], color, width=0.3)
            sheet.line([box[1], box[3]], color, width=0.3)
        sheet.words((x + 3.8, y), words, size, anchor="start")
        x += 3.8 + text_width(words, size) + 2.2
