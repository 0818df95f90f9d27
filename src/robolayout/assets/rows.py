"""Reads the rows in which a record says what a thing is made of: one part a row.

    let t = min(.03m, .1h)
    top: box wood x 0:1 y 0:1 z 1-t:1
    leg: box dark x .02m:.06m y .02m:.06m z 0:1-t mirror xy

A number alone is a share of the thing's own depth (x, from the back), width (y, from the right) or height (z, from the
floor); `.03m` are metres; `.1d`, `.1w`, `.1h` are shares of depth, width, height; `t` is what a `let` says. The language
is described in docs/assets.md.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from itertools import pairwise
from typing import NoReturn

import numpy as np

from robolayout._errors import AssetError
from robolayout.assets.drawing import BASIS, CALLS, CROSS, RELATIONS, SUMS, VARIED, PartDrawing, PartRow, Repeat, Test
from robolayout.assets.palette import GROUPS, MATERIALS, make_piece

LENGTHS = {"x": 2, "y": 3, "z": 4}  # where in `BASIS` the length along an axis stands
LEANS = tuple(f"{a}/{b}" for a in "xyz" for b in "xyz" if a != b)
"""Fields that move a part along one axis as it goes along another: `x/z 0:-.05m` leans its top back."""
FIELDS: dict[str, tuple[tuple[str, ...], tuple[str, ...], int]] = {
    "box": (("x", "y", "z"), ("top",), 3),
    "soft": (("x", "y", "z"), ("bevel",), 3),
    "ball": (("x", "y", "z"), ("rings", "sides"), 3),
    "cylinder": (("x", "y", "z", "r"), ("sides",), 1),
    "prism": (("at",), ("x", "y", "z"), 1),
    "doors": (("y", "z", "count"), ("x", "low"), 2),
    "drawers": (("y", "z", "rows"), ("x", "columns", "knobs"), 2),
}
"""What each shape must say, what it may say, and along how many axes it has two ends."""
OVERHANG = (0.25, 0.05)
"""Share of an edge, and metres, by both of which a part must lie outside the box to be taken for a mistake; all is fitted in."""
HOW = "write mirror x|y|xy, repeat N FIELD STEP, vary FIELD MOST, if TEST"
_TERM = re.compile(r"([+-]?)(\d+\.?\d*|\.\d+)?([a-z][a-z0-9_]*)?")

Value = list[float]  # factors of the basis and of the lets


@lru_cache(maxsize=512)
def read_rows(text: str, where: str) -> PartDrawing:
    """Read the rows of a record; `where` says whose they are, for messages."""
    reading = _RowReading(where)
    lines = [line for raw in text.splitlines() if (line := raw.split("#")[0].strip())]
    for line in (line for line in lines if line.startswith("let ")):
        reading.let(line)
    rows = tuple(reading.row(line) for line in lines if not line.startswith("let "))
    if not rows:
        reading.refuse("there is no row", "write one such as 'top: box wood x 0:1 y 0:1 z 0:1'")
    return PartDrawing(reading.lets, np.array(reading.values), rows)


def check_rows(text: str, where: str, size: tuple[float, float, float]) -> None:
    """Refuse rows that cannot be read, or by which a part lies far outside the thing's box."""
    low = np.array([-size[0] / 2, -size[1] / 2, 0.0])
    for part in read_rows(text, where)(make_piece(where, where, where, size, 0)):
        over = np.maximum(low - part.vertices.min(axis=0), part.vertices.max(axis=0) - low - size)
        for axis, edge, beyond, thick in zip("xyz", size, over.tolist(), np.ptp(part.vertices, axis=0), strict=True):
            if thick < 1e-6:
                raise AssetError(f"parts of {where}, part {part.name!r}: its two ends along {axis} are one; part them.")
            if beyond > max(OVERHANG[0] * edge, OVERHANG[1]):
                raise AssetError(f"parts of {where}, part {part.name!r}: {axis} reaches {beyond:.2f} m beyond the thing's "
                                 f"{edge:g} m; keep it between 0 and 1.")  # fmt: skip


class _RowReading:
    """Reads rows one after the other and collects their values."""

    def __init__(self, where: str) -> None:
        self.where = where
        self.part = ""
        self.names: dict[str, int] = {name: i for i, name in enumerate(BASIS)}
        self.lets: dict[str, ast.expr] = {}
        self.values: list[Value] = []

    def refuse(self, what: str, allowed: str) -> NoReturn:
        """Say what is wrong where, and what is allowed."""
        part = f", part {self.part!r}" if self.part else ""
        raise AssetError(f"parts of {self.where}{part}: {what}; {allowed}.")

    def let(self, line: str) -> None:
        """Read a line that names an expression."""
        match = re.fullmatch(r"let ([a-z][a-z0-9_]*) = (.+)", line)
        if match is None or match[1] in self.names:
            self.refuse(
                f"{line!r} cannot be read", "write 'let NAME = EXPRESSION', in small letters, a new name each time"
            )
        try:
            node = ast.parse(re.sub(r"(\d)([a-z])", r"\1*\2", match[2]), mode="eval").body
        except SyntaxError:
            self.refuse(f"{match[2]!r} cannot be read", "write sums and products of lengths")
        for inner in ast.walk(node):
            if not self._allowed(inner):
                self.refuse(
                    f"{match[2]!r} holds {ast.unparse(inner)!r}", f"use {', '.join([*self.names, *CALLS][1:])}, + - * /"
                )
        self.lets[match[1]] = node
        self.names[match[1]] = len(self.names)

    def _allowed(self, node: ast.AST) -> bool:
        """Return whether a `let` may hold a node."""
        if isinstance(node, ast.Name):
            return node.id in self.names or node.id in CALLS
        if isinstance(node, ast.BinOp):
            return type(node.op) in SUMS
        if isinstance(node, ast.Compare):
            return len(node.ops) == 1 and isinstance(node.ops[0], ast.Lt | ast.Gt)
        kinds = ast.Constant | ast.Call | ast.IfExp | ast.operator | ast.cmpop | ast.expr_context
        return isinstance(node, kinds)

    def row(self, line: str) -> PartRow:
        """Read a row."""
        self.part, _, rest = (item.strip() for item in line.partition(": "))
        words = rest.split()
        if len(words) < 2:
            self.refuse(f"{line!r} cannot be read", "write 'NAME: SHAPE MATERIAL x .. y .. z ..'")
        shape, styles = words[0], [style.split("/") for style in words[1].split("|")]
        materials = tuple(tuple(one for name in style for one in GROUPS.get(name, (name,))) for style in styles)
        self._among("shape", [shape], FIELDS)
        self._among("material", [name for style in materials for name in style], MATERIALS)
        starts = [i for i, word in enumerate(words) if word in ("mirror", "repeat", "vary", "if") and i > 1]
        body, *tails = (words[start:end] for start, end in pairwise([2, *starts, len(words)]))
        fields = self._fields(shape, body)
        repeats, tests, mirror, vary = list[Repeat](), list[Test](), "", dict[str, slice]()
        for word, *rest_of in tails:
            if word == "repeat" and rest_of:
                said = self._pairs(rest_of[1:], (*LENGTHS, *LEANS, "r", "bevel", "turn", "only"))
                only, count = self._remainders(said.pop("only", "0/1")), self._add(self._sum(rest_of[0])).start
                repeats.append(Repeat(count, self._steps(said), only))
            elif word == "vary" and rest_of:
                vary = self._steps(self._pairs(rest_of, VARIED))
            elif word == "mirror" and rest_of in (["x"], ["y"], ["xy"]):
                mirror = rest_of[0]
            elif word == "if" and len(rest_of) == 1:
                tests += [self._test(clauses) for clauses in rest_of[0].split("|")]
            else:
                self.refuse(f"{' '.join([word, *rest_of])!r} cannot be read", HOW)
        return PartRow(self.part, shape, materials, fields, tuple(repeats), mirror, vary, tuple(tests))

    def _among(self, kind: str, names: Iterable[str], known: Iterable[str]) -> None:
        for name in names:
            if name not in known:
                self.refuse(f"unknown {kind} {name!r}", f"known: {', '.join(known)}")

    def _pairs(self, words: list[str], known: Iterable[str]) -> dict[str, str]:
        if len(words) % 2:
            self.refuse(f"{words[-1]!r} has no value", "write a value after each field")
        self._among("field", words[::2], known)
        return dict(zip(words[::2], words[1::2], strict=True))

    def _fields(self, shape: str, words: list[str]) -> dict[str, slice]:
        """Read the fields of a row and see that none is missing and that it has its ends."""
        must, may, spans = FIELDS[shape]
        said = self._pairs(words, (*must, *may, *LEANS, "turn"))
        for key in must:
            if key not in said:
                self.refuse(f"{key} is missing", f"a {shape} needs {', '.join(must)}")
        ends = [axis for axis in LENGTHS if axis in said and (":" in said[axis] or "~" in said[axis])]
        if len(ends) != spans:
            self.refuse(
                f"it has two ends along {', '.join(ends) or 'no axis'}", f"a {shape} has them along {spans} of x, y, z"
            )
        across = CROSS[ends[0]]
        return {key: self._add(*self._values(key, text, across)) for key, text in said.items()}

    def _values(self, key: str, text: str, across: str) -> list[Value]:
        if key in LENGTHS:
            return self._ends(text, lambda item: self._place(item, key))
        if key == "at":
            points = (zip(across, point.split(","), strict=True) for point in text.split(";"))
            return [self._place(item, axis) for point in points for axis, item in point]
        if key == "r":
            rings = [[self._length(item) for item in ring.split(",")] for ring in text.split(":")]
            return [value for ring in (rings[0], rings[-1]) for value in (ring[0], ring[-1])]
        if key in LEANS or key == "bevel":
            return self._ends(text, self._length)
        return [self._sum(item) for item in text.split(",")]

    def _steps(self, said: Mapping[str, str]) -> dict[str, slice]:
        """Read what is added to fields."""
        alone = ("turn", "skip")  # fields of one plain number
        read = {k: [self._sum(t)] if k in alone else self._ends(t, self._length) for k, t in said.items()}
        return {key: self._add(*values) for key, values in read.items()}

    def _remainders(self, text: str) -> tuple[frozenset[int], int]:
        match = re.fullmatch(r"(\d+(?:,\d+)*)/([1-9]\d*)", text)
        if match is None:
            self.refuse(f"{text!r} cannot be read", "write remainders and a divisor such as 0,2/4")
        return frozenset(int(item) for item in match[1].split(",")), int(match[2])

    def _ends(self, text: str, read: Callable[[str], Value]) -> list[Value]:
        if "~" not in text:
            return [read(item) for item in text.split(":")]
        middle, half = text.split("~", 1)
        m, h = read(middle), self._length(half)
        return [[a - b for a, b in zip(m, h, strict=True)], [a + b for a, b in zip(m, h, strict=True)]]

    def _place(self, text: str, axis: str) -> Value:
        value = self._sum(text)
        value[LENGTHS[axis]] += value[0] - (0.0 if axis == "z" else 0.5)
        value[0] = 0.0
        return value

    def _length(self, text: str) -> Value:
        value = self._sum(text)
        if value[0]:
            self.refuse(f"{text!r} is no length", "write metres (.03m) or a share of an edge (.1d, .1w, .1h)")
        return value

    def _sum(self, text: str) -> Value:
        value, at = [0.0] * len(self.names), 0
        while at < len(text) or not text:
            match = _TERM.match(text, at)
            if match is None or match.end() == at or (match[3] or "") not in self.names:
                self.refuse(
                    f"{text!r} cannot be read", f"write a sum such as 1-.03m+.1w of {', '.join(self.names)[2:]}"
                )
            value[self.names[match[3] or ""]] += (-1.0 if match[1] == "-" else 1.0) * float(match[2] or 1.0)
            at = match.end()
        return value

    def _test(self, clauses: str) -> Test:
        """Read conditions that must all hold."""
        styles: list[tuple[frozenset[int], int]] = []
        limits: list[tuple[int, str]] = []
        for clause in clauses.split("&"):
            relation = next((sign for sign in RELATIONS if sign in clause), "")
            if clause.startswith("style="):
                styles.append(self._remainders(clause.removeprefix("style=")))
            elif relation:
                low, high = (self._length(side) for side in clause.split(relation, 1))
                limits.append((self._add([a - b for a, b in zip(low, high, strict=True)]).start, relation))
            else:
                self.refuse(f"{clause!r} cannot be read", "write w>1.2m or style=0,2/4")
        return tuple(styles), tuple(limits)

    def _add(self, *values: Value) -> slice:
        start = len(self.values)
        self.values += values
        return slice(start, len(self.values))
