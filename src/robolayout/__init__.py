"""RoboLayout lays out a 3D room for a body: a robot, a child, a wheelchair user, a cat.

    import robolayout as rl

    scene = rl.load_scene("examples/bedroom.json")
    result = rl.generate(scene, agent="wheelchair", seed=0)
    print(result.report)

Everything below is loaded when it is first used, so that importing the package costs nothing.
"""

from __future__ import annotations

import sys
from types import ModuleType
from typing import TYPE_CHECKING

from robolayout._lazy import loader
from robolayout._version import __version__ as __version__

if TYPE_CHECKING:
    from robolayout._errors import InputError, RoboLayoutError
    from robolayout.export import export
    from robolayout.many import batch, evaluate, rooms
    from robolayout.planners import scene_from_sentence
    from robolayout.program import Program, read_program, reconcile
    from robolayout.render import plan_svg
    from robolayout.render import render_view as render
    from robolayout.run.diff import diff
    from robolayout.run.flow import compare, generate, solve
    from robolayout.run.outputs import page_html, write_result
    from robolayout.run.result import Result, judge
    from robolayout.scene import (
        Agent,
        Asset,
        Layout,
        Pose,
        Room,
        Scene,
        load_agent,
        load_layout,
        load_scene,
        scene_from_dict,
    )
    from robolayout.solve import SolverConfig
    from robolayout.verify import Report, verify

__getattr__ = loader(__name__, __file__)

__all__ = [
    "Agent", "Asset", "InputError", "Layout", "Pose", "Program", "Report", "Result", "RoboLayoutError", "Room",
    "Scene", "SolverConfig", "__version__", "batch", "compare", "diff", "evaluate", "export", "generate", "judge",
    "load_agent", "load_layout", "load_scene", "page_html", "plan_svg", "read_program", "reconcile", "render",
    "rooms", "scene_from_dict", "scene_from_sentence", "solve", "verify", "write_result",
]  # fmt: skip


class _Page(ModuleType):
    """This page: `rl.verify(...)` stays the function although a folder of that name is imported too."""

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in __all__ and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Page


def __dir__() -> list[str]:
    return __all__
