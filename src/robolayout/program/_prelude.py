"""What a program finds when it starts: recorder classes and the scene's variables, defined inside the sandbox.

Nothing here runs in our process: the texts are fed to the interpreter in the child process before the user's program.
The scene arrives there as data (`_rl_scene`), never as text, so no name or size can become code. Names that start with
`_rl_` belong to the recorder; `_source` refuses programs that use them, and the recorder keeps its own references to the
builtins, so that a program may call its list of tables `list`.
"""

from __future__ import annotations

from collections.abc import Iterable
from importlib.resources import files

from robolayout.program._program import Limits
from robolayout.program._source import MEANINGLESS
from robolayout.scene import Scene

RESULT = "_rl_result()"  # the expression that reads everything back as one JSON text


def prelude(scene: Scene, relations: Iterable[str]) -> str:
    """Return the program text that defines the recorder and the variables of `scene`."""
    recorder = (files("robolayout.program") / "data" / "recorder.txt").read_text(encoding="utf-8")
    lines = [recorder, "class _rl_Solver:", "    def __init__(self, site=None, soft=False):"]
    lines += ["        self.site, self.soft = site, soft"]
    for name in relations:
        lines.append(f"    def {name}(self, *args, **kwargs):")
        lines.append(f"        return _rl_record(self.site, {name!r}, args, kwargs, self.soft)")
    for name in sorted(MEANINGLESS):
        lines.append(f"    def {name}(self, *args, **kwargs):")
        lines.append(f"        _rl_notes.append('solver.{name}() means nothing here and was ignored')")
    lines += ["solver = _rl_Solver()", "solver.wish = _rl_Solver(None, True)"]
    lines.append("walls = [_rl_Wall(*wall) for wall in _rl_scene['walls']]")
    lines.append("room = _rl_Room(*_rl_scene['room'])")
    lines.append("_rl_assets = [_rl_Asset(*asset) for asset in _rl_scene['assets']]")
    lines.append("assets = _rl_assets[:]")
    start = 0
    for variable, group in scene.variables.items():
        lines.append(f"{variable} = _rl_assets[{start}:{start + len(group)}]")
        start += len(group)
    return "\n".join(lines) + "\n"


def scene_data(scene: Scene, limits: Limits) -> dict[str, object]:
    """Return the scene and the limits as plain data for the recorder."""
    room = scene.room
    assets = [
        [asset.name, f"{variable}[{i}]", asset.category, list(asset.size)]
        for variable, group in scene.variables.items()
        for i, asset in enumerate(group)
    ]
    walls = [
        [wall.index, list(wall.start), list(wall.end), list(wall.midpoint), list(wall.normal), wall.length]
        for wall in room.walls
    ]
    return {
        "assets": assets,
        "walls": walls,
        "room": [*room.bounds, room.wall_height],
        "statements": limits.statements,
        "items": limits.items,
        "printed": limits.printed,
    }
