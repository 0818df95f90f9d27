"""A body to scale: its footprint from above with corridor, turning circle and reach, and its heights from the side."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from PIL import Image

from robolayout.render._drawing import Drawing, Point, Shape, circle, paint, rectangle
from robolayout.render._style import BODY
from robolayout.render.palette import FREE, INK, NARROW, QUIET, REACH, ROUTE, TURN
from robolayout.scene import Agent
from robolayout.scene.agent import horizontal_reach


def draw_body(agent: Agent) -> Drawing:
    """Return the drawing of a body in paper millimetres."""
    around = 2 * max(agent.reach if _has_arm(agent) else 0.0, agent.radius, agent.turning_circle / 2)
    tall = max(agent.height, BODY.door[1], agent.reach_high if _has_arm(agent) else 0.0)
    scale = next((s for s in BODY.scales if max(around, tall) * 1000 / s <= BODY.space), BODY.scales[-1])
    k = 1000 / scale
    broad = max(around, 2 * BODY.door[0])
    high = max(around, tall) * k
    sheet = Drawing(2 * BODY.edge + around * k + BODY.between + broad * k, BODY.head + high + BODY.foot)
    sheet.words((BODY.edge, 6.0), agent.title or agent.name, 3.2, anchor="start", color=INK)
    _draw_above(sheet, agent, (BODY.edge + around * k / 2, BODY.head + high / 2), k)
    _draw_side(sheet, agent, (BODY.edge + around * k + BODY.between + broad * k / 2, BODY.head + high), k, broad)
    _draw_legend(sheet, agent, (BODY.edge, sheet.height - 4.0), scale)
    return sheet


def body_text(agent: Agent, *, columns: int = 76) -> str:
    """Return the outlines of the drawing as lines of at most `columns` Braille characters, for a terminal."""
    full = draw_body(agent)
    outlines = [replace(i, fill=None, dash=None, width=0.2) for i in full.items if isinstance(i, Shape) and i.stroke]
    top, bottom = BODY.head - 1.0, full.height - BODY.foot + 1.0
    scale = 2 * columns / (full.width - BODY.labels)
    picture = Image.new("RGB", (2 * columns, 4 * math.ceil((bottom - top) * scale / 4)), "#ffffff")
    sheet = Drawing(full.width, full.height, list(outlines))
    paint(picture, sheet.moved(0.0, -top), scale)
    dots = (np.asarray(picture.convert("L")) < 250).reshape(picture.height // 4, 4, columns, 2)
    weights = np.array([[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]])
    codes = 0x2800 + (dots * weights[None, :, None, :]).sum(axis=(1, 3))
    return "\n".join("".join(map(chr, row)).rstrip(chr(0x2800)) for row in codes.tolist())


def _has_arm(agent: Agent) -> bool:
    return agent.reach_distance is not None


def _size(agent: Agent) -> tuple[float, float]:
    """Return length and width of the footprint in metres."""
    return (agent.length or 2 * agent.radius, agent.width or 2 * agent.radius)


def _draw_above(sheet: Drawing, agent: Agent, middle: Point, k: float) -> None:
    """Draw the footprint from above, heading to the right, with everything that is measured from its centre."""
    (x, y), (length, width) = middle, (v * k for v in _size(agent))
    if _has_arm(agent):
        sheet.polygon([circle(middle, agent.reach * k, 72)], REACH, opacity=0.07, stroke=REACH, width=0.2)
    sheet.polygon([circle(middle, agent.radius * k, 72)], FREE, opacity=0.7, stroke=ROUTE, width=0.2, dash=(0.5, 0.6))
    if agent.length is not None:
        sheet.polygon([circle(middle, agent.turning_circle / 2 * k, 72)], None, stroke=TURN, width=0.3, dash=(1.4, 0.8))
        outline = rectangle(x - length / 2, y - width / 2, x + length / 2, y + width / 2)
    else:
        outline = circle(middle, agent.radius * k, 72)
    sheet.polygon([outline], ROUTE, opacity=0.25, stroke=ROUTE, width=0.35)
    tip = min(2.0, 0.25 * length)
    ahead = x + length / 2
    sheet.polygon([[(ahead - 0.4, y), (ahead - tip, y - 0.6 * tip), (ahead - tip, y + 0.6 * tip)]], ROUTE)
    outer = max(agent.reach if _has_arm(agent) else 0.0, agent.radius, agent.turning_circle / 2) * k
    across = " across" if agent.length is None else f" x {_metres(width / k)}"
    sheet.words((x, y + outer + 2.6), _metres(length / k) + across, BODY.size, color=ROUTE)


def _draw_side(sheet: Drawing, agent: Agent, floor: Point, k: float, broad: float) -> None:
    """Draw the body from the side on the floor, a doorway behind it, and the heights that count."""
    x, y = floor
    half, aside = _size(agent)[0] / 2 * k, BODY.door[0] / 2 * k
    left, right = x - broad * k / 2, x + broad * k / 2
    door = rectangle(x - aside, y, x + aside, y - BODY.door[1] * k)
    sheet.line((door[0], door[3], door[2], door[1]), QUIET, width=0.15, dash=(0.8, 0.8))
    if _has_arm(agent):
        sheet.polygon([_reached(agent, floor, k)], REACH, opacity=0.12, stroke=REACH, width=0.2)
    low, top = y - agent.step * k, y - agent.height * k
    body = ((x - half, low), (x - half, top), (x + half, top), (x + half, low))
    sheet.polygon([body], ROUTE, opacity=0.25, stroke=ROUTE, width=0.35)
    sheet.line([(left - 3, y), (right + 1, y)], INK, width=0.35)
    marks = [(agent.height, "height", ROUTE), (agent.step, "steps over", NARROW)]
    if _has_arm(agent):
        marks += [(agent.reach_high, "reaches up to", REACH), (agent.reach_low, "reaches down to", REACH)]
    if agent.shoulder_height is not None:
        marks.append((agent.shoulder_height, "shoulder", QUIET))
    at = math.inf
    for level, words, color in sorted(marks):
        at = min(at - BODY.size - 0.7, y - level * k)
        sheet.line([(right, y - level * k), (right + 2.0, at)], color, width=0.2)
        sheet.words((right + 2.6, at), f"{words} {_metres(level)}", BODY.size, color=color, anchor="start")
    sheet.width = max(sheet.width, right + BODY.labels)


def _reached(agent: Agent, floor: Point, k: float) -> list[Point]:
    """Return the outline, ahead of the body's middle, of what its arm reaches: a band, cut round about a shoulder."""
    (x, y), levels = floor, [agent.reach_low + (agent.reach_high - agent.reach_low) * i / 24 for i in range(25)]
    reached = [(level, horizontal_reach(agent, level, level)) for level in levels]
    far = [(x + across * k, y - level * k) for level, across in reached if across is not None]
    return [(x, far[0][1]), *far, (x, far[-1][1])] if far else []


def _draw_legend(sheet: Drawing, agent: Agent, at: Point, scale: int) -> None:
    """Explain the circles, in one row."""
    x, y = at
    rows: list[tuple[str, tuple[float, float] | None, str]] = [
        (ROUTE, (0.5, 0.6), f"corridor {_metres(2 * agent.radius)}")
    ]
    if agent.length is not None:
        rows.append((TURN, (1.1, 0.6), f"turning circle {_metres(agent.turning_circle)}"))
    if _has_arm(agent):
        rows.append((REACH, None, f"reach {_metres(agent.reach)} from its centre"))
    rows.append((QUIET, (0.8, 0.8), f"door {BODY.door[0]:.2f} x {_metres(BODY.door[1])}"))
    for color, dash, words in rows:
        sheet.line([(x, y), (x + 3.0, y)], color, width=0.35, dash=dash)
        sheet.words((x + 3.8, y), words, BODY.size, anchor="start", color=INK)
        x += 6.8 + 0.55 * BODY.size * len(words)
    sheet.width = max(sheet.width, x + 10.0)
    sheet.words((sheet.width - 4.0, 6.0), f"1 : {scale}", BODY.size, color=QUIET, anchor="end")


def _metres(value: float) -> str:
    """Return a length in words, to the centimetre or, where that is not all of it, to the millimetre."""
    return f"{value:.2f} m" if abs(value - round(value, 2)) < 5e-4 else f"{value:.3f} m"
