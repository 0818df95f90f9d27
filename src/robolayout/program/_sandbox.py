"""Runs program text in pydantic-monty: a Python interpreter of its own, in a child process, without files or network.

The child gets three feeds: the prelude, the program (a feed of its own, so that line numbers fit) and one expression that
returns all that was recorded as one JSON text. Time, memory and depth are limited inside the child, and the child is
killed should it ever overrun them. The scene arrives there as data (`_rl_scene`), never as text, so no name or size can become
code. Names that start with `_rl_` belong to the recorder: `_source` refuses programs that use them, and the recorder keeps its
own references to the builtins, so that a program may call its list of tables `list`.
"""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Collection
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from robolayout._errors import ProgramError, ProgramLimitError, did_you_mean
from robolayout.program._program import READING, ProgramLimits
from robolayout.program._source import MEANINGLESS, ProgramSource, characters
from robolayout.scene import Scene

if TYPE_CHECKING:
    from pydantic_monty import MontyError

HAS = {
    "Asset": ("a thing", "position, rotation, depth, width, height, size, category and name"),
    "Wall": ("a wall", "start, end, midpoint, normal, length and index"),
    "Room": ("the room", "center, min_x, max_x, min_y, max_y and wall_height"),
}
"""What programs may look at, for messages."""
PROGRAM_FEED = "<python-input-1>"  # what the interpreter calls the second feed: the program
RESULT = "_rl_result()"  # the expression that reads everything back as one JSON text


def run(source: ProgramSource, scene: Scene, relations: Collection[str], limits: ProgramLimits) -> dict[str, Any]:
    """Run the program and return what it recorded; raises `ProgramError` for what goes wrong in it."""
    from pydantic_monty import Monty, MontyError  # 0.08 s to import

    bounds = {
        "max_feed_duration_secs": limits.seconds,
        "max_memory": limits.memory,
        "max_recursion_depth": limits.depth,
    }
    try:
        with (
            Monty(max_processes=1, request_timeout=limits.seconds + READING.grace) as pool,
            pool.checkout(limits=bounds, assert_message_annotations=False) as session,  # type: ignore[arg-type]
        ):
            data = _scene_data(scene, limits)
            session.feed_run(_prelude(scene, relations), inputs={"_rl_scene": data}, print_callback=_drop)
            session.feed_run(source.marked, print_callback=_drop)
            return json.loads(session.feed_run(RESULT, print_callback=_drop))
    except MontyError as error:
        raise _translate(error, source, scene, relations, limits) from error


def _drop(stream: str, text: str) -> None:
    """Drop what the interpreter prints by itself; the prelude's own `print` keeps a bounded part."""


def _prelude(scene: Scene, relations: Collection[str]) -> str:
    """Return the program text that defines the recorder and the variables of `scene`."""
    recorder = (files("robolayout.program") / "data" / "recorder.txt").read_text(encoding="utf-8")
    lines = [recorder, "class _rl_Solver:", "    def __init__(self, site=None, soft=False):"]
    lines += ["        self.site, self.soft = site, soft"]
    calls = {name: f"return _rl_record(self.site, {name!r}, args, kwargs, self.soft)" for name in relations}
    for name in sorted(MEANINGLESS):
        calls[name] = f"_rl_notes.append('solver.{name}() means nothing here and was ignored')"
    lines += [f"    def {name}(self, *args, **kwargs):\n        {body}" for name, body in calls.items()]
    lines += ["solver = _rl_Solver()", "solver.wish = _rl_Solver(None, True)", "room = _rl_Room(*_rl_scene['room'])"]
    lines.append("walls = [_rl_Wall(*wall) for wall in _rl_scene['walls']]")
    lines += ["_rl_assets = [_rl_Asset(*asset) for asset in _rl_scene['assets']]", "assets = _rl_assets[:]"]
    start = 0
    for variable, group in scene.variables.items():
        lines.append(f"{variable} = _rl_assets[{start}:{start + len(group)}]")
        start += len(group)
    return "\n".join(lines) + "\n"


def _scene_data(scene: Scene, limits: ProgramLimits) -> dict[str, object]:
    """Return the scene and the limits as plain data for the recorder."""
    room = scene.room
    assets = [
        [name, written, scene.by_name[name].category, list(scene.by_name[name].size)]
        for name, written in scene.expressions.items()
    ]
    walls = [
        [wall.index, list(wall.start), list(wall.end), list(wall.midpoint), list(wall.normal), wall.length]
        for wall in room.walls
    ]
    bounds = {"statements": limits.statements, "items": limits.items, "printed": limits.printed}
    return {"assets": assets, "walls": walls, "room": [*room.bounds, room.wall_height], **bounds}


def _translate(
    error: MontyError, source: ProgramSource, scene: Scene, relations: Collection[str], limits: ProgramLimits
) -> ProgramError:
    """Return our error for an error of the interpreter, at the line of the program that caused it."""
    line, column = _place(error, source)
    inner = error.exception()
    text = (str(inner) or str(error))[: READING.message]
    exceeded = _exceeded(error, text, limits)
    if exceeded:
        return source.error(exceeded, line, column, kind=ProgramLimitError)
    if isinstance(inner, NameError) and (match := re.search(r"'(\w+)'", text)):
        text = _unknown_name(match[1], scene, relations)
    elif isinstance(inner, IndexError):
        text = _out_of_range(source, scene, line, column) or text
    elif isinstance(inner, NotImplementedError):
        text = text.replace("The monty syntax parser does not yet support", "programs cannot use")
    elif isinstance(inner, OSError):
        text = f"programs cannot reach files ({text})"
    elif isinstance(inner, AttributeError) and (match := re.match(r"'list' object has no attribute '(\w+)'", text)):
        text = f"a list of assets has no {match[1]!r}; pick one of it, such as bed[0]"
    elif isinstance(inner, AttributeError) and (
        match := re.match(r"'_rl_(\w+)' object has no attribute '(\w+)'", text)
    ):
        if match[1] in HAS:
            text = "{0} has no {name!r}; it has {1}".format(*HAS[match[1]], name=match[2])
    elif isinstance(inner, KeyError):
        text = f"there is no key {text}"
    return source.error(re.sub(r"_rl_(\w+)", lambda name: name[1].lower(), text), line, column)


def _place(error: MontyError, source: ProgramSource) -> tuple[int | None, int | None]:
    """Return line (from 1) and column (from 0) in the program, where the innermost frame of it stands."""
    traceback = getattr(error, "traceback", list)
    frames = [frame for frame in traceback() if frame.filename == PROGRAM_FEED]
    if not frames:
        return None, None
    return frames[-1].line, source.original_column(frames[-1].line, frames[-1].column - 1)


def _exceeded(error: MontyError, text: str, limits: ProgramLimits) -> str | None:
    from pydantic_monty import MontyCrashedError, MontySyntaxError

    inner = error.exception()
    if text.startswith("_rl_limit "):
        return text.removeprefix("_rl_limit ") + "; that is the limit"
    if isinstance(inner, TimeoutError) or (isinstance(error, MontyCrashedError) and error.timed_out):
        return f"the program ran longer than {limits.seconds:g} s; does a loop never end?"
    if isinstance(inner, MemoryError):
        return f"the program needs more than {limits.memory // 2**20} MB of memory"
    if isinstance(inner, RecursionError):
        return f"calls are nested deeper than {limits.depth}; does a function call itself for ever?"
    if isinstance(error, MontySyntaxError) and "nested" in text:
        return "the program is nested too deeply to be read; write shorter expressions"
    if isinstance(error, MontyCrashedError):
        return "the program crashed its interpreter; write it in a simpler way"
    return None


def _unknown_name(name: str, scene: Scene, relations: Collection[str]) -> str:
    if name in relations:
        return f"{name!r} is a relation: write solver.{name}(...)"
    known = [*scene.variables, "walls", "room", "solver"]
    return f"unknown asset or variable {name!r}.{did_you_mean(name, known)} Known variables: {', '.join(known)}."


def _out_of_range(source: ProgramSource, scene: Scene, line: int | None, column: int | None) -> str | None:
    """Return a sentence about the list that is too short, if it is one of the scene's variables."""
    counts = {name: len(group) for name, group in scene.variables.items()} | {"walls": len(scene.room.walls)}
    for node in ast.walk(source.tree):
        if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.lineno == line:
            count = counts.get(node.value.id)
            if count is not None and characters(source.lines[node.lineno - 1], node.col_offset) == column:
                name = node.value.id
                known = f"{name}[0]" if count == 1 else f"{name}[0] to {name}[{count - 1}]"
                return f"{source.segment(node)}: {name} has {count} item{'s' if count > 1 else ''} ({known})"
    return None
