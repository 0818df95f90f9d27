"""Pictures for people and for the VLM (docs/pictures.md): views, plans, annotated views, curves and animations.

What is drawn is a `Drawing`: `.svg()`, `.pdf()` and `.image(width)` are its forms. Nothing heavy is loaded before the first picture.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._lazy import loader

if TYPE_CHECKING:
    from robolayout.render._drawing import Drawing as Drawing
    from robolayout.render._drawing import png_bytes as png_bytes
    from robolayout.render._model_plan import model_plan as model_plan
    from robolayout.render.animation import progress_gif as progress_gif
    from robolayout.render.animation import walk_gif as walk_gif
    from robolayout.render.annotation import annotate as annotate
    from robolayout.render.annotation import annotation_camera as annotation_camera
    from robolayout.render.annotation import annotation_marks as annotation_marks
    from robolayout.render.beauty import render_beauty as render_beauty
    from robolayout.render.body import body_text as body_text
    from robolayout.render.body import draw_body as draw_body
    from robolayout.render.camera import Camera as Camera
    from robolayout.render.contents import PlanMarks as PlanMarks
    from robolayout.render.curves import draw_losses as draw_losses
    from robolayout.render.plan import draw_comparison as draw_comparison
    from robolayout.render.plan import draw_plan as draw_plan
    from robolayout.render.plan import plan_svg as plan_svg
    from robolayout.render.sheet import SheetNotes as SheetNotes
    from robolayout.render.sheet import draw_sheet as draw_sheet
    from robolayout.render.view import Buffers as Buffers
    from robolayout.render.view import Studio as Studio
    from robolayout.render.view import asset_sheet as asset_sheet
    from robolayout.render.view import render_asset as render_asset
    from robolayout.render.view import render_view as render_view

__getattr__ = loader(__name__, __file__)
