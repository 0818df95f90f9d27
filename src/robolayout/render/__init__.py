"""Pictures for people and for the VLM: views, plans, annotated views, curves and animations.

| function | what it makes |
|---|---|
| `render_view(scene, layout, view=...)` | a picture from above, from the side, of one asset, or from an agent's eyes |
| `Studio(scene, layout)` | the same for many views of one room, with ids and depths |
| `render_asset(asset)` | one asset alone |
| `plan_svg`, `plan_image`, `plan_pdf` | the plan to scale, with what the agent can do (`PlanMarks`) |

Nothing heavy is loaded before the first picture.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from robolayout.render.camera import Camera, eye_camera, fitted_camera, spherical_camera
    from robolayout.render.marks import PlanMarks
    from robolayout.render.plan import plan_image, plan_pdf, plan_svg
    from robolayout.render.view import Buffers, Studio, render_asset, render_view

_HOMES = {
    "Buffers": "view",
    "Camera": "camera",
    "PlanMarks": "marks",
    "Studio": "view",
    "eye_camera": "camera",
    "fitted_camera": "camera",
    "plan_image": "plan",
    "plan_pdf": "plan",
    "plan_svg": "plan",
    "render_asset": "view",
    "render_view": "view",
    "spherical_camera": "camera",
}

__all__ = [
    "Buffers",
    "Camera",
    "PlanMarks",
    "Studio",
    "eye_camera",
    "fitted_camera",
    "plan_image",
    "plan_pdf",
    "plan_svg",
    "render_asset",
    "render_view",
    "spherical_camera",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'robolayout.render' has no attribute {name!r}")
    return getattr(import_module(f"robolayout.render.{_HOMES[name]}"), name)
