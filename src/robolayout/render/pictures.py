"""All pictures of a run at once, from one loaded scene."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import TYPE_CHECKING

from robolayout.render.animation import progress_gif
from robolayout.render.curves import loss_png
from robolayout.render.marks import PlanMarks
from robolayout.render.plan import plan_svg
from robolayout.render.view import Renderer, Studio
from robolayout.scene import Agent, Layout, Scene, Trace

if TYPE_CHECKING:
    from PIL.Image import Image

TOP_SIZE = (720, 720)
VIEW_SIZE = (960, 720)
"""Pixels of the pictures from above and from the side."""


def run_pictures(
    scene: Scene,
    layout: Layout,
    trace: Trace,
    *,
    marks: PlanMarks | None = None,
    agent: Agent | None = None,
    title: str | None = None,
    renderer: Renderer = "auto",
) -> dict[str, bytes]:
    """Return the pictures of a run by file name: plan.svg, top.png, view.png, progress.gif and loss.png.

    Args:
        scene: The scene.
        layout: The final layout.
        trace: How the run went; without losses there is no loss.png.
        marks: What the agent can do, for the plan.
        agent: The agent, for the plan's legend.
        title: Title of the plan.
        renderer: "auto", "gl" or "rays".
    """
    studio = Studio(scene, layout, renderer=renderer)
    made: dict[str, Callable[[], bytes]] = {
        "plan.svg": lambda: plan_svg(scene, layout, navigation=marks, agent=agent, title=title).encode(),
        "top.png": lambda: png_bytes(studio.view("top", size=TOP_SIZE)),
        "view.png": lambda: png_bytes(studio.view("side", size=VIEW_SIZE)),
        "progress.gif": lambda: progress_gif(scene, trace, layout=layout),
    }
    if trace.losses:
        made["loss.png"] = lambda: loss_png(trace)
    return {name: make() for name, make in made.items()}


def png_bytes(image: Image) -> bytes:
    """Return a picture as PNG bytes."""
    stream = io.BytesIO()
    image.save(stream, "PNG", compress_level=3)
    return stream.getvalue()
