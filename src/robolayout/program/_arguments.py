"""From recorded arguments to a `Relation`, checked against what the relation declares it takes."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from typing import Any

from robolayout._errors import did_you_mean
from robolayout.constraints import RELATIONS, AssetRef, PointRef, Ref, Relation, WallRef
from robolayout.program._program import READING
from robolayout.scene import Scene

Recorded = list[Any]  # a value as the recorder wrote it, such as ["asset", name] or ["number", 1.5]

NOUNS = {
    "asset": "an asset such as bed[0]", "wall": "a wall such as walls[0]", "point": "a point such as [1.5, 2.0]",
    "room": "room", "none": "None", "number": "a number", "integer": "a whole number", "text": "a text",
    "polygon": "a list of points", "statement": "a statement such as solver.corner(plant[0]), or a list of those",
}  # fmt: skip
"""Words for what an argument takes."""

OTHER_NAMES = {"asset": "a", "asset1": "a", "asset2": "b", "target": "b", "assets": "items"}
"""Argument names that programs of LayoutVLM use, by ours."""

WEIGHT, HEAVIEST = "weight", 100.0  # the keyword that weighs a wish, and the largest weight of one, either way


class ArgumentError(Exception):
    """An argument does not fit; `argument` is its place among the positional ones, or its keyword, or None for the whole call."""

    def __init__(self, message: str, argument: int | str | None = None) -> None:
        super().__init__(message)
        self.argument = argument


def build_relation(name: str, given: list[Recorded], named: list[tuple[str, Recorded]], scene: Scene) -> Relation:
    """Return the relation that a recorded call states; raises `ArgumentError`."""
    relation = RELATIONS[name]
    specs = {spec.name: spec for spec in relation.arguments()}
    values: dict[str, object] = {}
    for key, (place, recorded) in _bind(name, specs, given, named).items():
        try:
            values[key] = _convert(specs[key], recorded, scene)
        except ArgumentError as error:
            raise ArgumentError(f"{key} of {name} {error}", place) from error
    for key, spec in specs.items():
        if key not in values and spec.default is dataclasses.MISSING:
            raise ArgumentError(f"{name} needs {key}: {_wanted(spec)}. Example: {relation.example}")
    _check_order(name, values)
    statement = relation(**values)
    if fault := statement.fault(scene):
        raise ArgumentError(f"{name}: {fault}")
    return statement


def wish_weight(named: list[tuple[str, Recorded]]) -> float:
    """Return the weight of a wish, 1 if the call gives none; raises `ArgumentError`."""
    given = [value for key, value in named if key == WEIGHT]
    if not given:
        return 1.0
    weight = _number(given[0][1]) if given[0][0] == "number" else math.nan
    if not abs(weight) <= HEAVIEST:
        raise ArgumentError(f"the weight of a wish is a number from -{HEAVIEST:g} (rather not) to {HEAVIEST:g}", WEIGHT)
    return weight


def _bind(
    name: str, specs: Mapping[str, dataclasses.Field[Any]], given: list[Recorded], named: list[tuple[str, Recorded]]
) -> dict[str, tuple[int | str, Recorded]]:
    """Return (place in the call, value) by argument name."""
    names = list(specs)
    if len(given) > len(names):
        takes = f"{len(names)} argument{'s' * (len(names) > 1)} ({', '.join(names)})"
        raise ArgumentError(f"{name} takes {takes}, not {len(given)}", len(names))
    bound: dict[str, tuple[int | str, Recorded]] = {names[i]: (i, value) for i, value in enumerate(given)}
    for word, value in named:
        key = word if word in specs else OTHER_NAMES.get(word, word)
        if key not in specs:
            hint = did_you_mean(word, names)
            raise ArgumentError(f"{name} has no argument {word!r}.{hint} It takes {', '.join(names)}.", word)
        if key in bound:
            raise ArgumentError(f"{name} gets {key!r} twice", word)
        bound[key] = (word, value)
    return bound


def _convert(spec: dataclasses.Field[Any], recorded: Recorded, scene: Scene) -> object:
    if not spec.metadata["many"]:
        return _one(spec, recorded, scene)
    if recorded[0] == "none" and "none" in spec.metadata["takes"]:
        return None
    is_point = "point" in spec.metadata["takes"] and _numbers(recorded) is not None
    items = recorded[1] if recorded[0] == "list" and not is_point else [recorded]
    if not items:
        raise ArgumentError("is an empty list")
    if "statement" in spec.metadata["takes"]:
        ways = [item[1] if item[0] == "list" else [item] for item in items]
        if any(not way or any(part[0] != "statement" for part in way) for way in ways):
            raise ArgumentError(f"takes {NOUNS['statement']}")
        return tuple(tuple(part[1] for part in way) for way in ways)
    if "point" in spec.metadata["takes"] and len(items) < 3:
        raise ArgumentError(f"takes at least 3 points, not {len(items)}")
    return tuple(_one(spec, item, scene) for item in items)


def _one(spec: dataclasses.Field[Any], recorded: Recorded, scene: Scene) -> object:
    takes: tuple[str, ...] = spec.metadata["takes"]
    kind = recorded[0]
    if kind == "list" and len(recorded[1]) == 1 and recorded[1][0][0] == "asset":
        return _one(spec, recorded[1][0], scene)
    if kind in ("asset", "wall") and kind in takes:
        return _ref(kind, recorded[1], scene)
    if kind in ("point", "list") and "point" in takes:
        return _point(recorded)
    if kind == "number" and ("number" in takes or "integer" in takes):
        if spec.name == "weight" and recorded[1] < 0:
            raise ArgumentError(f"is {recorded[1]:g}; a weight is 0 or more")
        return _number(recorded[1], whole="number" not in takes)
    if kind == "text" and "text" in takes:
        return _text(recorded[1], spec.metadata["choices"])
    if (kind == "none" and "none" in takes) or (kind in ("none", "room") and "room" in takes):
        return None
    raise ArgumentError(f"takes {_wanted(spec)}, not {_described(recorded, scene)}")


def _ref(kind: str, value: Any, scene: Scene) -> Ref:
    """Return the asset of that name, or the wall of that number."""
    if kind == "asset" and isinstance(value, str) and value in scene.by_name:
        return AssetRef(value)
    if kind == "wall" and isinstance(value, int) and 0 <= value < len(scene.room.walls):
        return WallRef(value)
    what = "an asset of the scene" if kind == "asset" else "a wall of the room"
    raise ArgumentError(f"takes {what}, not one that was changed or made up")


def _number(value: float, *, whole: bool = False) -> float:
    if not math.isfinite(value):
        raise ArgumentError("is not finite (NaN or infinite)")
    if abs(value) > READING.largest:
        raise ArgumentError(f"is {value:g}; numbers go up to {READING.largest:g}")
    if whole and not value.is_integer():
        raise ArgumentError(f"takes a whole number, not {value:g}")
    return int(value) if whole else value


def _numbers(recorded: Recorded) -> list[float] | None:
    """Return the numbers of a recorded list of numbers, else None."""
    if recorded[0] != "list" or not recorded[1] or any(item[0] != "number" for item in recorded[1]):
        return None
    return [item[1] for item in recorded[1]]


def _point(recorded: Recorded) -> PointRef:
    numbers = _numbers(recorded[1] if recorded[0] == "point" else recorded)
    if numbers is None or len(numbers) not in (2, 3):
        raise ArgumentError(
            "takes a point of two or three numbers, such as [1.5, 2.0] or AssetInstance(position=[1.5, 2.0, 0])"
        )
    return PointRef(*(_number(value) for value in numbers))


def _text(value: str, choices: tuple[str, ...]) -> str:
    if choices and value not in choices:
        known = ", ".join(repr(choice) for choice in choices)
        raise ArgumentError(f"is {value!r}, which is not one of {known}")
    return value


def _wanted(spec: dataclasses.Field[Any]) -> str:
    takes = " or ".join(NOUNS[kind] if kind in NOUNS else str(kind) for kind in spec.metadata["takes"])
    return f"a list, each item of it {takes}" if spec.metadata["many"] else takes


def _described(recorded: Recorded, scene: Scene) -> str:
    kind, value = recorded[0], recorded[1] if len(recorded) > 1 else None
    if kind == "list":
        return f"a list of {len(recorded[1])}"
    if kind == "asset":
        return scene.expressions.get(str(value), "an asset")
    if kind == "wall":
        return f"walls[{value}]"
    if kind in ("number", "text"):
        return f"{value:g}" if kind == "number" else repr(value)
    return {"none": "None", "room": "room", "point": "a point"}.get(str(kind), f"{value}")


def _check_order(name: str, values: Mapping[str, object]) -> None:
    """Raise where a lowest value lies above its highest (`min_distance`, `max_distance`)."""
    for key, low in values.items():
        other = key.replace("min", "max", 1)
        high = values.get(other) if key.startswith("min") else None
        if isinstance(low, float) and isinstance(high, float) and low > high:
            raise ArgumentError(f"{name}: {key} = {low:g} is above {other} = {high:g}", other)
