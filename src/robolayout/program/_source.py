"""Program text before it runs: fences, size, syntax, the words it may not use, and marks that record line numbers.

Nothing is executed here. The text is parsed with `ast` (of bounded size, so of bounded time and memory) to find what the
language does not have, and to insert marks such as `_rl_at(solver, 7).against_wall(...)`: they tell the recorder which
call of the text it is about. Marks never add a line, so every message of the interpreter fits the text as written.
"""

from __future__ import annotations

import ast
import json
import re
import warnings
from collections.abc import Collection, Iterator
from contextlib import suppress
from dataclasses import dataclass

from robolayout._errors import ProgramError, ProgramLimitError, did_you_mean
from robolayout.program._program import READING, ProgramLimits

FENCE = re.compile(r"^(\s*)```+\s*([A-Za-z0-9_+-]*)")
PYTHON = {"python", "py", "python3", "robolayout"}
IMPORTS = {"math", "typing", "__future__"}  # what may be imported: arithmetic, and names that only annotate
NUMPY = "numpy"  # what may be imported under any one name; a few of its functions on plain numbers are there
MEANINGLESS = frozenset({"solve", "optimize", "run", "render", "visualize", "export"})
"""Calls of the solver that programs of LayoutVLM end with; here they are ignored with a note."""
WISH = "wish"  # what `solver.wish.near(...)` goes through: the same statements, as wishes
WRAPPED = ("program", "code", "arguments", "input")  # fields of a JSON answer, or of a tool call, that hold the program
FORBIDDEN = frozenset(
    {"eval", "exec", "compile", "open", "input", "getattr", "setattr", "delattr", "globals", "locals", "vars"}
)
"""Builtins that no program needs to place furniture."""


@dataclass(frozen=True)
class TextPlace:
    """A place in the text that a mark points at."""

    line: int  # line, counted from 1
    column: int  # column, counted from 0
    call: ast.Call | None = None  # the call, for a statement


@dataclass(frozen=True)
class ProgramSource:
    """Program text that may run."""

    text: str  # the text as given, without fences and prose (their lines are empty)
    lines: tuple[str, ...]
    tree: ast.Module  # its syntax tree
    marked: str  # the text with marks
    sites: tuple[TextPlace, ...]  # what the marks point at
    edits: tuple[tuple[int, int, int], ...]  # where marks were inserted: (line, column in the text, length), in order

    def error(
        self, message: str, line: int | None, column: int | None = None, *, kind: type[ProgramError] = ProgramError
    ) -> ProgramError:
        """Return an error that shows the line and a caret."""
        return error_at(self.lines, message, line, column, kind=kind)

    def segment(self, node: ast.expr) -> str:
        """Return the text of a node on one line."""
        first, last = node.lineno - 1, (node.end_lineno or node.lineno) - 1
        rows = [row.encode() for row in self.lines[first : last + 1]]
        rows[-1] = rows[-1][: node.end_col_offset]
        rows[0] = rows[0][node.col_offset :]
        return " ".join(b"\n".join(rows).decode().split())

    def original_column(self, line: int, column: int) -> int:
        """Return the column in the text for a column (both from 0) of the marked text."""
        shift = 0
        for row, place, length in self.edits:
            if row == line and place + shift < column:
                shift += min(length, column - place - shift)
        return max(column - shift, 0)


def read_source(
    text: str, relations: Collection[str], variables: Collection[str], limits: ProgramLimits
) -> ProgramSource:
    """Return checked and marked text; raises `ProgramError` for what the language does not have."""
    if len(text) > limits.text:
        raise ProgramLimitError(
            f"the program has {len(text)} characters; at most {limits.text} are read. Use loops to say more with less."
        )
    text = plain(text)
    lines = tuple(text.split("\n"))
    tree = _parse(text, lines)
    refusals: list[tuple[int, int, str]] = []
    for node in ast.walk(tree):
        if message := _refusal(node, relations, variables):
            column: int = getattr(node, "col_offset", 0)
            if isinstance(node, ast.Attribute) and node.end_lineno == node.lineno:
                column = (node.end_col_offset or 0) - len(node.attr.encode())
            refusals.append((getattr(node, "lineno", 1), column, message))
    if refusals:
        line, column, message = min(refusals)
        raise error_at(lines, message, line, characters(lines[line - 1], column))
    sites, edits = _marks(tree, lines, relations, variables)
    rows = list(lines)
    for line, column, _, mark in reversed(edits):
        rows[line - 1] = rows[line - 1][:column] + mark + rows[line - 1][column:]
    return ProgramSource(text, lines, tree, "\n".join(rows), sites, tuple((r, c, len(t)) for r, c, _, t in edits))


def unwrapped(text: str) -> str:
    """Return the program in a JSON answer or tool call; any other text as it is.

    >>> unwrapped('{"name": "plan", "arguments": {"program": "x = 1"}}')
    'x = 1'
    """
    inner = text.strip()
    inner = re.sub(r"^```+json\s*\n(.*?)\n```+$", r"\1", inner, flags=re.DOTALL)
    try:
        found: object = json.loads(inner) if inner.startswith("{") else None
    except (ValueError, RecursionError):
        return text
    for _ in WRAPPED:
        if isinstance(found, str):
            return unwrapped(found)
        fields: dict[str, object] = found if isinstance(found, dict) else {}  # type: ignore[assignment]
        found = next((fields[name] for name in WRAPPED if name in fields), None)
    return text


def without_line(text: str, line: int) -> str | None:
    """Return an answer without the smallest Python statement that stands on a line; None if there is none.

    Lines keep their numbers. Where the text is no Python, the line alone goes.
    """
    text = plain(text)
    lines = text.split("\n")
    first, last = line, line
    with suppress(SyntaxError, ValueError, RecursionError):
        spans = ((n.lineno, n.end_lineno or n.lineno) for n in ast.walk(ast.parse(text)) if isinstance(n, ast.stmt))
        around = [span for span in spans if span[0] <= line <= span[1]]
        first, last = min(around, key=lambda span: span[1] - span[0], default=(line, line))
    if not 1 <= first <= last <= len(lines) or not any(row.strip() for row in lines[first - 1 : last]):
        return None
    indent = lines[first - 1][: len(lines[first - 1]) - len(lines[first - 1].lstrip())]
    lines[first - 1 : last] = [f"{indent}pass" if indent else "", *[""] * (last - first)]
    return "\n".join(lines)


def plain(text: str) -> str:
    """Return the program in an answer: without byte order mark, JSON around it, and all that is not in its fences."""
    text = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    return strip_fences(unwrapped(text))


def strip_fences(text: str) -> str:
    """Return the fenced Python of an answer, all other lines emptied; without a fence, the whole text.

    >>> strip_fences("Here it is:\\n```python\\nx = 1\\n```")
    '\\n\\nx = 1\\n'
    """
    blocks: list[tuple[str, dict[int, str], int]] = []
    lines = text.split("\n")
    inside = False
    for number, line in enumerate(lines):
        if match := FENCE.match(line):
            if not inside:
                blocks.append((match[2].lower(), {}, len(match[1])))
            inside = not inside
        elif inside:
            blocks[-1][1][number] = line[min(blocks[-1][2], len(line) - len(line.lstrip())) :]
    if not blocks:
        return text
    kept = [block for block in blocks if block[0] in PYTHON] or [block for block in blocks if not block[0]]
    result = {number: line for _, numbered, _ in kept for number, line in numbered.items()}
    return "\n".join(result.get(number, "") for number in range(len(lines)))


def error_at(
    lines: tuple[str, ...],
    message: str,
    line: int | None,
    column: int | None = None,
    *,
    kind: type[ProgramError] = ProgramError,
) -> ProgramError:
    """Return a `ProgramError` that shows a line (from 1) and a caret (from 0), or neither if there is no such line."""
    if line is None or not 1 <= line <= len(lines):
        return kind(message)
    row = lines[line - 1]
    start = max(0, (column or 0) - 60) if len(row) > READING.line else 0
    shown = row[start : start + READING.line].replace("\t", " ")
    return kind(message, line=line, source=shown, column=None if column is None else column - start)


def _parse(text: str, lines: tuple[str, ...]) -> ast.Module:
    try:
        text.encode()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text)
    except UnicodeEncodeError as error:
        raise ProgramError("the program contains characters that are no text (lone surrogates)") from error
    except SyntaxError as error:
        column = None if error.offset is None else max(error.offset - 1, 0)
        raise error_at(lines, f"this is not Python: {error.msg}", error.lineno, column) from error
    except ValueError as error:
        raise ProgramError(f"this is not Python: {error}") from error
    except (RecursionError, MemoryError) as error:
        raise ProgramLimitError("the program is nested too deeply to be read; write shorter expressions") from error


def _refusal(node: ast.AST, relations: Collection[str], variables: Collection[str]) -> str | None:
    if isinstance(node, ast.Import | ast.ImportFrom):
        names = [node.module or "."] if isinstance(node, ast.ImportFrom) else [alias.name for alias in node.names]
        numeric = isinstance(node, ast.Import) and names == [NUMPY]
        odd = next((name for name in names if name not in IMPORTS and not numeric), None)
        have = "programs have only math (already there, with pi, radians and degrees)"
        return f"{odd!r} cannot be imported; {have}" if odd is not None else None
    if isinstance(node, ast.Attribute):
        if node.attr.startswith("_"):
            return f"{node.attr!r}: attributes that start with an underscore do not exist in programs"
        known = {"solver": {*relations, *MEANINGLESS, WISH}, f"solver.{WISH}": {*relations}}
        if node.attr not in known.get(_dotted(node.value), (node.attr,)):
            return f"unknown relation {node.attr!r}.{did_you_mean(node.attr, relations)} Known: {', '.join(relations)}."
    if isinstance(node, ast.Name) and node.id in FORBIDDEN and node.id not in variables:
        return f"{node.id!r} does not exist in programs; they only compute positions and state relations"
    if isinstance(node, ast.Yield | ast.YieldFrom | ast.Await | ast.AsyncFunctionDef | ast.AsyncFor | ast.AsyncWith):
        return "generators and async code do not exist in programs; use a list"
    for name in _identifiers(node):
        method = name == "__init__" and isinstance(node, ast.FunctionDef)
        if name.startswith(("__", "_rl_")) and name.strip("_") and not method:
            return f"{name!r}: names that start with two underscores or with _rl_ do not exist in programs"
    return None


def _dotted(node: ast.expr) -> str:
    """Return `solver` or `solver.wish` as text; "" for anything else."""
    if isinstance(node, ast.Attribute):
        return f"{_dotted(node.value)}.{node.attr}" if node.attr == WISH else ""
    return node.id if isinstance(node, ast.Name) else ""


def _identifiers(node: ast.AST) -> Iterator[str]:
    """Yield the names that a node itself mentions or binds."""
    if isinstance(node, ast.Constant):
        return
    for _, value in ast.iter_fields(node):
        for item in value if isinstance(value, list) else (value,):  # type: ignore[reportUnknownVariableType]
            if isinstance(item, str):
                yield item


Edit = tuple[int, int, int, str]  # line, column in characters, a key that orders marks at one place, inserted text


def _marks(
    tree: ast.Module, lines: tuple[str, ...], relations: Collection[str], variables: Collection[str]
) -> tuple[tuple[TextPlace, ...], list[Edit]]:
    """Return the sites of the text and the marks to insert.

    `x.against_wall` becomes `_rl_at(x, site).against_wall`, `x.position` and `x.rotation` become
    `_rl_one(x, "position", site).position` (no site when it is only read), `x.placements` becomes `_rl_all(x).placements`;
    where anything else is assigned, `x.name` becomes `_rl_own(x, "name").name`.
    """
    calls = {id(node.func): node for node in ast.walk(tree) if isinstance(node, ast.Call)}
    sites: list[TextPlace] = []
    edits: list[Edit] = []
    for node in _attributes(tree):
        if node.attr in relations and isinstance(node.ctx, ast.Load):
            opening, closing = "_rl_at(", f", {len(sites)})"
        elif node.attr in ("position", "rotation"):
            site = "None" if isinstance(node.ctx, ast.Load) else str(len(sites))
            opening, closing = "_rl_one(", f", {node.attr!r}, {site})"
        elif node.attr == "placements":
            opening, closing = "_rl_all(", ")"
        elif isinstance(node.ctx, ast.Store):
            opening, closing = "_rl_own(", f", {node.attr!r})"
        else:
            continue
        edits += _around(node.value, lines, opening, closing)
        sites.append(TextPlace(node.lineno, edits[-2][1], calls.get(id(node))))
    for node in ast.walk(tree):
        if isinstance(node, ast.Import) and node.names[0].name == NUMPY:
            start = characters(lines[node.lineno - 1], node.col_offset)
            edits.append((node.lineno, start, 0, f"{node.names[0].asname or NUMPY} = _rl_np #"))
        elif isinstance(node, ast.Assign) and _thing(target := node.targets[0], variables):
            # `bed[0] = AssetInstance(...)` sets a guess instead of replacing the bed; around the marks of the value itself
            edits += _around(node.value, lines, f"_rl_put({ast.unparse(target)}, {len(sites)}, ", ")", outer=1)
            sites.append(TextPlace(node.lineno, characters(lines[node.lineno - 1], node.value.col_offset)))
    return tuple(sites), sorted(edits)


def _thing(target: ast.expr, variables: Collection[str]) -> bool:
    """Return whether an assignment is to one of the scene's things (`bed[0]`)."""
    return isinstance(target, ast.Subscript) and isinstance(target.value, ast.Name) and target.value.id in variables


def _around(value: ast.expr, lines: tuple[str, ...], opening: str, closing: str, outer: int = 0) -> list[Edit]:
    """Return marks before and after an expression, around those of what it begins and ends with."""
    last, end = value.end_lineno or value.lineno, value.end_col_offset or 0
    start = characters(lines[value.lineno - 1], value.col_offset)
    return [
        (value.lineno, start, -(last * 1_000_000 + end) - outer, opening),
        (last, characters(lines[last - 1], end), outer, closing),
    ]


def _attributes(tree: ast.Module) -> Iterator[ast.Attribute]:
    """Yield all attributes outside f-strings (Python 3.11 does not know the columns inside those)."""
    nodes: list[ast.AST] = [tree]
    while nodes:
        node = nodes.pop()
        if isinstance(node, ast.Attribute):
            yield node
        if not isinstance(node, ast.JoinedStr):
            nodes.extend(ast.iter_child_nodes(node))


def characters(row: str, offset: int) -> int:
    """Return the column in characters for an offset in UTF-8 bytes."""
    return offset if row.isascii() else len(row.encode()[:offset].decode(errors="ignore"))
