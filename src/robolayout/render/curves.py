"""Loss curves: every term of a run's trace, once as it is and once as log10 of its absolute value."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby
from operator import attrgetter

import numpy as np
from numpy.typing import NDArray

from robolayout.render._drawing import Drawing, rectangle, text_width
from robolayout.render.palette import INK, QUIET
from robolayout.scene import Trace

COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8c6d31", "#7f7f7f")
"""Line colours, after Okabe and Ito; the total is INK."""

TOTAL = "total"  # name of the sum of all terms
SMALLEST = 1e-8  # absolute values below this leave a gap on the logarithmic scale
POINTS = 400  # most points of a drawn line; where there are more, each column shows its largest value
GRID = "#e4e1db"

NO_SEARCH = "This room needed no search: what was planned was right at once."
"""Said instead of curves where nothing moved."""


@dataclass(frozen=True)
class Frame:
    """Where a panel lies on the sheet: left, upper, right and lower edge of its axes in millimetres."""

    left: float
    top: float
    right: float
    bottom: float


def draw_losses(trace: Trace) -> Drawing:
    """Return two panels side by side, 240 x 92 mm: the terms of the loss, linear, and log10 of their absolute values."""
    sheet = Drawing(240.0, 92.0)
    terms = loss_terms(trace)
    if terms and is_still(trace):
        sheet.words((sheet.width / 2, sheet.height / 2), NO_SEARCH, 4.0, color=INK)
        return sheet
    stages = [(next(run).step, stage) for stage, run in groupby(trace.snapshots, key=attrgetter("stage"))]
    frames = (Frame(16, 12, 116, 74), Frame(136, 12, 236, 74))
    for frame, logarithmic in zip(frames, (False, True), strict=True):
        draw_panel(sheet, frame, terms, logarithmic=logarithmic, stages=stages, caption="step")
        title = "loss, log10 of the absolute value" if logarithmic else "loss"
        sheet.words((frame.left, 6.0), title, 3.6, anchor="start", color=INK)
        if not terms:
            at = ((frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2)
            sheet.words(at, "no losses were recorded", 3.4, color=QUIET)
    x = frames[0].left
    for number, name in enumerate(terms):
        sheet.line([(x, 86.5), (x + 5, 86.5)], _color(number, name), width=0.7)
        sheet.words((x + 6.2, 86.5), name, 3.0, anchor="start")
        x += 11.0 + text_width(name, 3.0)
    return sheet


def is_still(trace: Trace) -> bool:
    """Return whether nothing moved: every moment of the record shows each thing at the same place."""
    seen: dict[str, tuple[float, float, float]] = {}
    kept = (seen.setdefault(name, pose) == pose for shot in trace.snapshots for name, pose in shot.poses.items())
    return bool(trace.snapshots) and all(kept)


def loss_terms(trace: Trace) -> dict[str, NDArray[np.float64]]:
    """Return the values of each term per step, NaN where it is absent; the total last."""
    names = list(dict.fromkeys(name for step in trace.losses for name in step))
    names.sort(key=lambda name: name == TOTAL)
    return {name: np.array([step.get(name, math.nan) for step in trace.losses], dtype=np.float64) for name in names}


def draw_panel(
    sheet: Drawing,
    frame: Frame,
    terms: dict[str, NDArray[np.float64]],
    *,
    logarithmic: bool,
    stages: Sequence[tuple[int, str]] = (),
    caption: str = "",
) -> None:
    """Draw axes and lines of one panel; `caption` stands below its right end."""
    steps = max((len(values) for values in terms.values()), default=0)
    shown = {name: _scaled(values, logarithmic) for name, values in terms.items()}
    finite = [values[np.isfinite(values)] for values in shown.values()]
    heights = np.concatenate([*finite, np.zeros(0)])
    low, high = (float(heights.min()), float(heights.max())) if len(heights) else (0.0, 1.0)
    ticks = nice_ticks(low, high)
    low, high = min(low, ticks[0]), max(high, ticks[-1])

    def place(step: float, value: float) -> tuple[float, float]:
        x = frame.left + (frame.right - frame.left) * step / max(steps - 1, 1)
        return (x, frame.bottom - (frame.bottom - frame.top) * (value - low) / max(high - low, 1e-12))

    _draw_stages(sheet, frame, stages, steps)
    for tick in ticks:
        y = place(0, tick)[1]
        sheet.line([(frame.left, y), (frame.right, y)], GRID, width=0.2)
        sheet.words((frame.left - 1.5, y), f"{tick:g}", 2.7, anchor="end", color=QUIET)
    for tick in nice_ticks(0, max(steps - 1, 1)):
        if 0 <= tick <= max(steps - 1, 1):
            sheet.words((place(tick, low)[0], frame.bottom + 3.2), f"{tick:g}", 2.7, color=QUIET)
    if caption:
        sheet.words((frame.right, frame.bottom + 7.0), caption, 2.7, anchor="end", color=QUIET)
    for number, (name, values) in enumerate(shown.items()):
        for line in _lines(values):
            points = [place(step, value) for step, value in line]
            sheet.line(points, _color(number, name), width=0.55 if name == TOTAL else 0.4)
    sheet.line([(frame.left, frame.top), (frame.left, frame.bottom), (frame.right, frame.bottom)], QUIET, width=0.25)


def nice_ticks(low: float, high: float) -> list[float]:
    """Return about five round numbers that span [low, high]."""
    span = max(high - low, 1e-9 + 1e-6 * abs(high))
    raw = span / 5
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 2.5, 5, 10) if m * power >= raw * 0.999)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [round(k * step, 12) for k in range(first, last + 1)]


def _scaled(values: NDArray[np.float64], logarithmic: bool) -> NDArray[np.float64]:
    """Return the values, or log10 of their absolute values; what is not finite becomes NaN."""
    values = np.where(np.isfinite(values), values, np.nan)
    return np.log10(np.where(np.abs(values) >= SMALLEST, np.abs(values), np.nan)) if logarithmic else values


def _lines(values: NDArray[np.float64]) -> list[list[tuple[float, float]]]:
    """Return the unbroken stretches of a line as (step, value) points, at most POINTS together."""
    stride = max(1, -(-len(values) // POINTS))
    padded = np.full(-(-len(values) // stride) * stride, -np.inf)
    padded[: len(values)] = np.where(np.isnan(values), -np.inf, values)
    columns = padded.reshape(-1, stride)
    stretches: list[list[tuple[float, float]]] = [[]]
    highest = zip(columns.argmax(axis=1).tolist(), columns.max(axis=1).tolist(), strict=True)
    for number, (at, value) in enumerate(highest):
        if value == -np.inf:
            stretches.append([])
        else:
            stretches[-1].append((number * stride + at, value))
    return [line if len(line) > 1 else [line[0], (line[0][0] + 0.5, line[0][1])] for line in stretches if line]


def _draw_stages(sheet: Drawing, frame: Frame, stages: Sequence[tuple[int, str]], steps: int) -> None:
    """Draw every second stage as a faint band, with its name where there is room."""
    ends = [start for start, _ in stages[1:]] + [max(steps - 1, 0)]
    width = (frame.right - frame.left) / max(steps - 1, 1)
    for number, ((start, name), end) in enumerate(zip(stages, ends, strict=False)):
        left, right = frame.left + start * width, frame.left + min(end, steps - 1) * width
        if number % 2 and right > left:
            sheet.polygon([rectangle(left, frame.top, right, frame.bottom)], "#f6f4ef")
        if right - left > text_width(name, 2.4) + 1:
            sheet.words(((left + right) / 2, frame.top - 1.6), name, 2.4, color=QUIET)


def _color(number: int, name: str) -> str:
    return INK if name == TOTAL else COLORS[number % len(COLORS)]
