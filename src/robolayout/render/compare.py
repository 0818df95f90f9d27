"""Several plans side by side at one scale: the same room for several bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from robolayout._errors import InputError
from robolayout.render._drawing import Drawing, draw_image, draw_svg
from robolayout.render.marks import PlanMarks
from robolayout.render.plan import draw_plan, plan_scale
from robolayout.scene import Layout, Scene

if TYPE_CHECKING:
    from PIL.Image import Image

Panel = tuple[str, Scene, Layout, PlanMarks | None]
"""Title, scene (its first agent is the panel's body), layout and marks of one plan."""


def compare_image(panels: Sequence[Panel], *, width: int = 1800) -> Image:
    """Return plans side by side as an RGB picture `width` pixels wide.

    Raises:
        InputError: There is no panel.
    """
    return draw_image(draw_comparison(panels), width)


def compare_svg(panels: Sequence[Panel]) -> str:
    """Return plans side by side as SVG text, to scale."""
    return draw_svg(draw_comparison(panels))


def draw_comparison(panels: Sequence[Panel]) -> Drawing:
    """Return the drawing behind `compare_image`: all panels at the scale of the largest room, tops aligned."""
    if not panels:
        raise InputError("compare_image has nothing to show: give at least one (title, scene, layout, marks).")
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
