"""Pictures for people and for the VLM: views, plans, annotated views, curves and animations.

| function | what it makes |
|---|---|
| `render_view(scene, layout, view=...)` | a picture from above, from the side, of one asset, or from an agent's eyes |
| `Studio(scene, layout)` | the same for many views of one room, with ids and depths |
| `render_asset(asset)` | one asset alone |
| `asset_sheet(assets)` | many assets, each with its name |
| `annotate(scene, layout, view=...)` | a view with grid, fronts, names and walls written into it, for a model |
| `model_plan(scene, layout, marks=...)` | the plan for a model: ticks, names of programs, what must stay free |
| `plan_svg`, `plan_image`, `plan_pdf` | the plan to scale, with what the agent can do (`PlanMarks`) |
| `sheet_svg`, `sheet_image`, `sheet_pdf` | the plan as a sheet to print: dimensions, furniture list, findings (`SheetNotes`) |
| `body_svg`, `body_image`, `body_pdf`, `body_text` | one body to scale, with its reach and what it steps over |
| `compare_image`, `compare_svg` | several plans side by side |
| `progress_gif`, `walk_gif` | the optimisation, and the agent on its round through the room |
| `loss_png`, `loss_image` | the terms of the loss, linear and logarithmic |
| `png_bytes(image)` | a picture as PNG |
| `render_beauty(scene, layout, view=...)` | a path-traced picture (extra `beauty`) |

Nothing heavy is loaded before the first picture.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from robolayout.render.animation import progress_gif
    from robolayout.render.annotation import Mark, annotate, annotation_camera, annotation_marks
    from robolayout.render.beauty import render_beauty
    from robolayout.render.body import body_image, body_pdf, body_svg, body_text
    from robolayout.render.camera import Camera, eye_camera, fitted_camera, spherical_camera
    from robolayout.render.catalogue import asset_sheet
    from robolayout.render.compare import compare_image, compare_svg
    from robolayout.render.curves import loss_image, loss_png
    from robolayout.render.marks import PlanMarks
    from robolayout.render.model_plan import model_plan
    from robolayout.render.pictures import png_bytes
    from robolayout.render.plan import draw_plan, plan_image, plan_pdf, plan_svg
    from robolayout.render.sheet import SheetNotes, draw_sheet, sheet_image, sheet_pdf, sheet_svg
    from robolayout.render.view import Buffers, Studio, render_asset, render_view
    from robolayout.render.walk import walk_gif

_HOMES = {
    "Buffers": "view",
    "Camera": "camera",
    "Mark": "annotation",
    "PlanMarks": "marks",
    "SheetNotes": "sheet",
    "Studio": "view",
    "annotate": "annotation",
    "annotation_camera": "annotation",
    "annotation_marks": "annotation",
    "asset_sheet": "catalogue",
    "body_image": "body",
    "body_pdf": "body",
    "body_svg": "body",
    "body_text": "body",
    "compare_image": "compare",
    "compare_svg": "compare",
    "draw_plan": "plan",
    "draw_sheet": "sheet",
    "eye_camera": "camera",
    "fitted_camera": "camera",
    "loss_image": "curves",
    "loss_png": "curves",
    "model_plan": "model_plan",
    "plan_image": "plan",
    "plan_pdf": "plan",
    "plan_svg": "plan",
    "png_bytes": "pictures",
    "progress_gif": "animation",
    "render_asset": "view",
    "render_beauty": "beauty",
    "render_view": "view",
    "sheet_image": "sheet",
    "sheet_pdf": "sheet",
    "sheet_svg": "sheet",
    "spherical_camera": "camera",
    "walk_gif": "walk",
}
"""Every public name and the module that holds it."""

__all__ = [
    "Buffers",
    "Camera",
    "Mark",
    "PlanMarks",
    "SheetNotes",
    "Studio",
    "annotate",
    "annotation_camera",
    "annotation_marks",
    "asset_sheet",
    "body_image",
    "body_pdf",
    "body_svg",
    "body_text",
    "compare_image",
    "compare_svg",
    "draw_plan",
    "draw_sheet",
    "eye_camera",
    "fitted_camera",
    "loss_image",
    "loss_png",
    "model_plan",
    "plan_image",
    "plan_pdf",
    "plan_svg",
    "png_bytes",
    "progress_gif",
    "render_asset",
    "render_beauty",
    "render_view",
    "sheet_image",
    "sheet_pdf",
    "sheet_svg",
    "spherical_camera",
    "walk_gif",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'robolayout.render' has no attribute {name!r}")
    found = getattr(import_module(f"robolayout.render.{_HOMES[name]}"), name)
    globals()[name] = found
    return found
