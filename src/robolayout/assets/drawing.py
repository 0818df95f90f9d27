"""Furniture drawn from the rows of its record: where each part lies for a given size, and the parts themselves."""

from __future__ import annotations

import ast
import math
import operator
import random
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout._text import utf8
from robolayout.assets.fronts import doors, drawers
from robolayout.assets.palette import Brief, material_of
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import ball, box, cylinder, prism, soft, spun

Place = dict[str, list[float]]
"""What a row says for one size, by field: the two ends along an axis, radii, how it leans; metres."""

RELATIONS: dict[str, Callable[[float, float], bool]] = {
    "<=": operator.le, ">=": operator.ge, "<": operator.lt, ">": operator.gt,
}  # fmt: skip
"""How a row may compare two lengths."""
SUMS: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
}  # fmt: skip
CALLS: dict[str, Callable[..., Any]] = {"min": min, "max": max, "round": round, "floor": math.floor, "abs": abs}
"""What a `let` may compute, beside sums and products."""
BASIS = ("", "m", "d", "w", "h")
"""What an extent is a sum of, before the names of `let`: plain numbers, metres, depth, width, height."""
VARIED = ("skip", "x", "y", "z", "turn")
"""What chance may settle of each drawing of a row: whether it is left out, and how far its fields are moved."""
CROSS = {"z": "xy", "x": "yz", "y": "zx"}  # the two axes across one, in the order that shapes take them


@dataclass(frozen=True)
class Repeat:
    """How a row is drawn several times."""

    count: int  # which value is the number of times
    steps: Mapping[str, slice]  # by field, which values are added each time
    only: tuple[frozenset[int], int] = (frozenset({0}), 1)  # (remainders, divisor) of the times at which it is drawn


Test = tuple[tuple[tuple[frozenset[int], int], ...], tuple[tuple[int, str], ...]]
"""When a row is drawn: (remainders, divisor) that the thing's style must have; (value, relation to 0) of its size."""


@dataclass(frozen=True)
class PartRow:
    """One part, or several alike."""

    name: str  # name of the part
    shape: str  # one of `rows.FIELDS`
    # names of its materials, which take turns where the row is repeated, for each style
    materials: tuple[tuple[str, ...], ...]
    fields: Mapping[str, slice]  # by field, which values it has
    repeats: tuple[Repeat, ...] = ()  # how it is drawn several times
    mirror: str = ""  # axes about which all of them are drawn once more
    # by field, the most that chance adds to each of them; it picks their materials, too
    vary: Mapping[str, slice] = field(default_factory=dict[str, slice])
    tests: tuple[Test, ...] = ()  # it is drawn where one of them holds, or where there is none

    def holds(self, variant: int, values: list[float]) -> bool:
        """Return whether a thing of this style and these values has the part."""
        return not self.tests or any(
            all(variant % by in some for some, by in styles)
            and all(RELATIONS[relation](values[index], 0.0) for index, relation in limits)
            for styles, limits in self.tests
        )

    def places(self, values: list[float]) -> list[tuple[int, Place]]:
        """Return where the part is drawn, and at which time of its first repeat."""
        places: list[tuple[int, Place]] = [(0, {key: values[span] for key, span in self.fields.items()})]
        for repeat in self.repeats:
            steps = {key: values[span] for key, span in repeat.steps.items()}
            some, by = repeat.only
            times = [i for i in range(round(values[repeat.count])) if i % by in some]
            first = repeat is self.repeats[0]
            places = [(i if first else turn, _shifted(place, steps, i)) for i in times for turn, place in places]
        for axis in self.mirror:
            places += [(turn, _mirrored(place, axis)) for turn, place in places]
        return places

    def by_chance(self, places: list[tuple[int, Place]], values: list[float], key: str) -> list[tuple[int, Place]]:
        """Return what chance makes of places; those of one number in several rows of a thing fare alike: pins and their notes."""
        out: list[tuple[int, Place]] = []
        left_out = values[self.vary["skip"]][0] if "skip" in self.vary else 0.0
        for i, (_, place) in enumerate(places):
            luck = random.Random(utf8(f"{key}/{i}"))
            turn, shares = luck.randrange(2520), {name: luck.random() for name in VARIED}
            for name, span in self.vary.items():
                place = _shifted(place, {name: values[span]}, shares[name])
            if shares["skip"] >= left_out:
                out.append((turn, place))
        return out


@dataclass(frozen=True, eq=False)
class PartDrawing:
    """The rows of a record, read."""

    lets: Mapping[str, ast.expr]  # what each `let` computes, by its name, from what is known before it
    matrix: NDArray[np.float64]  # (values, basis and lets): every value of every row
    rows: tuple[PartRow, ...]

    def __call__(self, p: Brief) -> Iterator[Part]:
        """Yield the parts of a piece."""
        known: dict[str, float] = dict(zip(BASIS, (1.0, 1.0, p.d, p.w, p.h), strict=True))
        for name, expression in self.lets.items():
            known[name] = _computed(expression, known)
        values: list[float] = (self.matrix @ np.array(list(known.values()))).tolist()
        for row in self.rows:
            if row.holds(p.variant, values):
                turns = [material_of(name, p) for name in row.materials[p.variant % len(row.materials)]]
                places = row.places(values)
                for turn, place in row.by_chance(places, values, p.key) if row.vary else places:
                    yield from _made(p, row, turns[turn % len(turns)], place)


def _computed(node: ast.expr, known: Mapping[str, float]) -> float:
    """Return the value of a `let`, whose kinds of nodes the reader has checked."""
    if isinstance(node, ast.Constant):
        return float(node.value)  # type: ignore[arg-type]
    if isinstance(node, ast.Name):
        return known[node.id]
    if isinstance(node, ast.BinOp):
        return SUMS[type(node.op)](_computed(node.left, known), _computed(node.right, known))
    if isinstance(node, ast.IfExp):
        return _computed(node.body if _computed(node.test, known) else node.orelse, known)
    if isinstance(node, ast.Compare):
        low, high = _computed(node.left, known), _computed(node.comparators[0], known)
        return float(low < high if isinstance(node.ops[0], ast.Lt) else low > high)
    assert isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    return float(CALLS[node.func.id](*(_computed(item, known) for item in node.args)))


def _shifted(place: Place, steps: Place, times: float) -> Place:
    """Return a place after some steps; a single step moves both ends of an extent."""
    out = dict(place)
    for key, step in steps.items():
        ends = place.get(key, [0.0])
        full = step * len(ends) if len(step) == 1 else step
        out[key] = [end + times * more for end, more in zip(ends, full, strict=True)]
    return out


def _mirrored(place: Place, axis: str) -> Place:
    """Return a place on the other side of the middle."""
    out = dict(place)
    for key, ends in place.items():
        if key == axis:
            out[key] = [-end for end in reversed(ends)]
        elif key.startswith(f"{axis}/"):
            out[key] = [-end for end in ends]
        elif key.endswith(f"/{axis}"):
            out[key] = ends[::-1]
    return out


def _made(p: Brief, row: PartRow, material: Material, place: Place) -> Iterable[Part]:
    if row.shape in FRONTS:
        (y0, y1), (z0, z1) = place["y"], place["z"]
        numbers = {key: round(place[key][0]) for key in ("count", "low", "rows", "columns", "knobs") if key in place}
        ahead = place["x"][0] if "x" in place else p.d / 2
        return FRONTS[row.shape](material, p.palette.metal, ahead, ((y0, y1), (z0, z1)), **numbers)
    part = _one(row, material, place)
    for key, (low, high) in ((key, ends) for key, ends in place.items() if "/" in key):
        moves, along = ("xyz".index(axis) for axis in key.split("/"))
        ends = part.vertices[:, along].min(), part.vertices[:, along].max()
        part.vertices[:, moves] += low + (high - low) * (part.vertices[:, along] - ends[0]) / (ends[1] - ends[0])
    return [spun(part, math.radians(place["turn"][0])) if "turn" in place else part]


def _one(row: PartRow, material: Material, place: Place) -> Part:
    """Return the part of one place, as it stands before it leans or is spun."""
    options: dict[str, Any] = {key: place[key][0] for key in ("bevel", "rings", "sides") if key in place}
    options |= {"top": place["top"]} if "top" in place else {}
    if row.shape in SOLIDS:
        return SOLIDS[row.shape](row.name, material, place["x"], place["y"], place["z"], **options)
    axis = next(axis for axis in "xyz" if len(place.get(axis, ())) == 2)  # along which it lies, or is drawn out
    u, v = (place.get(across, [0.0])[0] for across in CROSS[axis])
    if row.shape == "cylinder":
        radii = (place["r"][:2], place["r"][2:])
        return cylinder(row.name, material, (u, v), radii, place[axis], axis=axis, **options)
    outline = [(a + u, b + v) for a, b in zip(place["at"][::2], place["at"][1::2], strict=True)]
    return prism(row.name, material, outline, place[axis], axis=axis)


SOLIDS: dict[str, Callable[..., Part]] = {"box": box, "soft": soft, "ball": ball}
"""What draws a shape that fills three ranges."""
FRONTS: dict[str, Callable[..., Iterator[Part]]] = {"doors": doors, "drawers": drawers}
"""What draws several parts at once."""
