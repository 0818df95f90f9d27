"""RoboLayout lays out a 3D room for a body: a robot, a child, a wheelchair user, a cat.

    import robolayout as rl

    scene = rl.load_scene("examples/bedroom.json")
    result = rl.generate(scene, agent="wheelchair", seed=0)
    print(result.report)

Everything below is loaded when it is first used, so that importing the package costs nothing.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

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

_HOMES = {
    "Agent": "scene",
    "Asset": "scene",
    "InputError": "_errors",
    "Layout": "scene",
    "Pose": "scene",
    "Program": "program",
    "Report": "verify",
    "Result": "run.result",
    "RoboLayoutError": "_errors",
    "Room": "scene",
    "Scene": "scene",
    "SolverConfig": "solve",
    "batch": "many",
    "compare": "run.flow",
    "diff": "run.diff",
    "evaluate": "many",
    "export": "export",
    "generate": "run.flow",
    "judge": "run.result",
    "load_agent": "scene",
    "load_layout": "scene",
    "load_scene": "scene",
    "page_html": "run.outputs",
    "plan_svg": "render",
    "read_program": "program",
    "reconcile": "program",
    "render": "render",
    "rooms": "many",
    "scene_from_dict": "scene",
    "scene_from_sentence": "planners",
    "solve": "run.flow",
    "verify": "verify",
    "write_result": "run.outputs",
}

_NAMES = {"render": "render_view"}

__all__ = [
    "Agent",
    "Asset",
    "InputError",
    "Layout",
    "Pose",
    "Program",
    "Report",
    "Result",
    "RoboLayoutError",
    "Room",
    "Scene",
    "SolverConfig",
    "__version__",
    "batch",
    "compare",
    "diff",
    "evaluate",
    "export",
    "generate",
    "judge",
    "load_agent",
    "load_layout",
    "load_scene",
    "page_html",
    "plan_svg",
    "read_program",
    "reconcile",
    "render",
    "rooms",
    "scene_from_dict",
    "scene_from_sentence",
    "solve",
    "verify",
    "write_result",
]


class _Page(ModuleType):
    """This page: `rl.verify(...)` stays the function although a folder of that name is imported too."""

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _HOMES and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Page


def __getattr__(name: str) -> Any:
    """Load a name of the public page when it is first used."""
    if name not in _HOMES:
        raise AttributeError(f"module 'robolayout' has no attribute {name!r}")
    value = getattr(import_module(f"robolayout.{_HOMES[name]}"), _NAMES.get(name, name))
    setattr(sys.modules[__name__], name, value)
    return value


def __dir__() -> list[str]:
    return __all__
