"""What a program finds when it starts: recorder classes and the scene's variables, defined inside the sandbox.

Nothing here runs in our process: the texts are fed to the interpreter in the child process before the user's program.
The scene arrives there as data (`_rl_scene`), never as text, so no name or size can become code. Names that start with
`_rl_` belong to the recorder; `_source` refuses programs that use them, and the recorder keeps its own references to the
builtins, so that a program may call its list of tables `list`.
"""

from __future__ import annotations

from collections.abc import Iterable

from robolayout.program._program import Limits
from robolayout.program._source import MEANINGLESS
from robolayout.scene import Scene

RECORDER = """
import json as _rl_json
import math
from math import acos, asin, atan, atan2, ceil, cos, degrees, exp, fabs, floor, hypot, pi, radians, sin, sqrt, tan, tau

_rl_len, _rl_isinstance, _rl_type, _rl_str, _rl_float = len, isinstance, type, str, float
_rl_lists, _rl_numbers = (list, tuple), (int, float)
_rl_bool, _rl_text, _rl_range = bool, str, range
_rl_TypeError, _rl_ValueError, _rl_RuntimeError = TypeError, ValueError, RuntimeError
_rl_log, _rl_inner, _rl_notes, _rl_used = [], [], [], {"items": 0, "printed": 0}


class AssetInstance:
    def __init__(self, position=None, rotation=None, **others):
        self.position = position
        self.rotation = rotation


_rl_Point = AssetInstance


class _rl_Numpy:
    def __init__(self):
        self.pi = pi
        self.sin, self.cos, self.tan, self.sqrt, self.hypot, self.arctan2 = sin, cos, tan, sqrt, hypot, atan2
        self.radians = self.deg2rad = radians
        self.degrees = self.rad2deg = degrees
        self.floor, self.ceil, self.abs, self.min, self.max, self.sum = floor, ceil, abs, min, max, sum

    def array(self, values, **others):
        return [value for value in values]

    def linspace(self, start, stop, num=50):
        return [start + (stop - start) * i / (num - 1 or 1) for i in _rl_range(num)]


_rl_np = _rl_Numpy()


class _rl_Asset:
    def __init__(self, name, label, category, size):
        self.name = name
        self.label = label
        self.category = category
        self.size = size
        self.depth, self.width, self.height = size
        self.position = None
        self.rotation = [0.0, 0.0, 0.0]
        self.placements = [self]
        self._rl_sites = {}

    def __repr__(self):
        return self.label


class _rl_Group:
    def __init__(self, items):
        self.placements = items


class _rl_Wall:
    def __init__(self, index, start, end, middle, normal, length):
        self.index = index
        self.start = self.corner1 = start
        self.end = self.corner2 = end
        self.position = self.midpoint = middle
        self.normal = normal
        self.length = length

    def __repr__(self):
        return f"walls[{self.index}]"


class _rl_Room:
    def __init__(self, min_x, min_y, max_x, max_y, wall_height):
        self.min_x, self.min_y, self.max_x, self.max_y = min_x, min_y, max_x, max_y
        self.center = [(min_x + max_x) / 2, (min_y + max_y) / 2]
        self.wall_height = wall_height

    def __repr__(self):
        return "room"


def _rl_several(items, attribute):
    name = items[0].label.split("[")[0] if _rl_len(items) and _rl_isinstance(items[0], _rl_Asset) else "this"
    raise _rl_TypeError(f"{name} is a list of {_rl_len(items)}; write {name}[0].{attribute}")


def _rl_one(thing, attribute, site):
    if _rl_isinstance(thing, _rl_lists):
        if _rl_len(thing) != 1:
            _rl_several(thing, attribute)
        thing = thing[0]
    if _rl_isinstance(thing, _rl_Asset):
        if site is not None:
            thing._rl_sites[attribute] = site
        elif attribute == "position" and thing.position is None:
            raise _rl_ValueError(f"{thing.label} has no position yet; assign {thing.label}.position first")
    return thing


def _rl_all(thing):
    return _rl_Group(thing) if _rl_isinstance(thing, _rl_lists) else thing


def _rl_put(thing, site, value):
    if _rl_isinstance(thing, _rl_Asset) and _rl_isinstance(value, _rl_Point):
        if value.position is not None:
            thing.position, thing._rl_sites["position"] = value.position, site
        if value.rotation is not None:
            thing.rotation, thing._rl_sites["rotation"] = value.rotation, site
        return thing
    return value


def _rl_at(thing, site):
    return _rl_Solver(site, thing.soft) if _rl_isinstance(thing, _rl_Solver) else thing


class _rl_Said:
    def __init__(self, place):
        self._rl_place = place


def _rl_number(value):
    if value > 1e300 or value < -1e300:
        return 1e308 * 10
    return _rl_float(value)


def _rl_encode(value, depth=0):
    _rl_used["items"] += 1
    if _rl_used["items"] > _rl_scene["items"]:
        raise _rl_RuntimeError(f"_rl_limit the arguments name more than {_rl_scene['items']} things")
    if value is None:
        return ["none"]
    if _rl_isinstance(value, _rl_bool):
        return ["other", "True" if value else "False"]
    if _rl_isinstance(value, _rl_numbers):
        return ["number", _rl_number(value)]
    if _rl_isinstance(value, _rl_text):
        return ["text", value[:200]]
    if _rl_isinstance(value, _rl_Asset):
        return ["asset", value.name]
    if _rl_isinstance(value, _rl_Wall):
        return ["wall", value.index]
    if _rl_isinstance(value, _rl_Room):
        return ["room"]
    if _rl_isinstance(value, _rl_Said):
        _rl_inner.append(value._rl_place)
        return ["said", value._rl_place]
    if _rl_isinstance(value, _rl_Point):
        return ["point", _rl_encode(value.position, depth + 1)]
    if _rl_isinstance(value, _rl_lists) and depth < 4:
        return ["list", [_rl_encode(item, depth + 1) for item in value]]
    return ["other", _rl_type(value).__name__]


def _rl_record(site, name, args, kwargs, soft):
    if _rl_len(_rl_log) >= _rl_scene["statements"]:
        raise _rl_RuntimeError(f"_rl_limit the program states more than {_rl_scene['statements']} relations")
    named = [[key, _rl_encode(kwargs[key])] for key in kwargs]
    _rl_log.append([site, name, [_rl_encode(value) for value in args], named, soft])
    return _rl_Said(_rl_len(_rl_log) - 1)


def print(*values, sep=" ", end="", **others):
    left = _rl_scene["printed"] - _rl_used["printed"]
    if left > 0:
        text = " ".join([_rl_str(value) for value in values])[:left]
        _rl_used["printed"] += _rl_len(text) + 1
        _rl_notes.append(text)


def _rl_result():
    _rl_used["items"] = 0
    poses = []
    for asset in _rl_assets:
        sites = asset._rl_sites
        place = _rl_encode(asset.position) if asset.position is not None else None
        turned = "rotation" in sites or asset.rotation != [0.0, 0.0, 0.0]
        turn = _rl_encode(asset.rotation) if turned else None
        poses.append([place, turn, sites.get("position"), sites.get("rotation")])
    return _rl_json.dumps({"log": _rl_log, "inner": _rl_inner, "poses": poses, "notes": _rl_notes})
"""

RESULT = "_rl_result()"
"""The expression that reads everything back as one JSON text."""


def prelude(scene: Scene, relations: Iterable[str]) -> str:
    """Return the program text that defines the recorder and the variables of `scene`."""
    lines = [RECORDER, "class _rl_Solver:", "    def __init__(self, site=None, soft=False):"]
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
