"""The plan as a file format: SVG and PDF to scale, with the agent's free space and routes.

They are registered as formats under the entry point group `robolayout.exporters`, as another package's would be: a plan needs
the judge, the pictures and the formats, which do not know each other.
"""

from __future__ import annotations

from collections.abc import Callable

from robolayout.export import Exporter, Options
from robolayout.page.marks import plan_marks
from robolayout.render import draw_plan
from robolayout.scene import Layout, Scene
from robolayout.verify import judge_agent


def _plan(suffix: str) -> Callable[[Scene, Layout, Options], bytes]:
    """Return what makes the plan as a file that ends so."""

    def made(scene: Scene, layout: Layout, options: Options) -> bytes:
        agent = options.agent
        marks = None if agent is None else plan_marks(judge_agent(scene, layout, agent))
        return draw_plan(scene, layout, navigation=marks, agent=agent).file(suffix)

    return made


SVG = Exporter("svg", ".svg", "the plan as a picture to scale, with free space and routes", None, _plan(".svg"))
PDF = Exporter("pdf", ".pdf", "the same as a page to print, to scale", None, _plan(".pdf"))
