"""Reads a constraint program safely: checked text in, statements and guesses out, nothing of it executed in our process."""

from __future__ import annotations

import ast
import math
from dataclasses import replace
from typing import Any

from robolayout._errors import ProgramError, ProgramLimitError
from robolayout.constraints import RELATIONS, Relation
from robolayout.program._arguments import WEIGHT, ArgumentError, Recorded, build_relation, wish_weight
from robolayout.program._program import READING, Guess, Program, ProgramLimits, Statement
from robolayout.program._sandbox import run
from robolayout.program._source import ProgramSource, TextPlace, read_source, without_line
from robolayout.scene import Scene

Odd = list[tuple[int, float]]  # lines with a rotation that no radians are, and its third number


def read_program(text: str, scene: Scene, limits: ProgramLimits | None = None) -> Program:
    """Return the statements and guesses of a program for `scene`.

    Args:
        text: Program text, or a model's answer with the program in ``` fences.
        scene: What the program is about; its assets and walls are the program's variables.

    Raises:
        ProgramError: With line, source and caret, and what would have worked.
        ProgramLimitError: Where it ran over a limit.
    """
    limits = limits or ProgramLimits()
    source = read_source(text, tuple(RELATIONS), scene.variables, limits)
    recorded = run(source, scene, tuple(RELATIONS), limits)
    said = _Said(recorded["log"], set(recorded["inner"]), source, scene)
    written = scene.expressions
    poses = dict(zip(written, recorded["poses"], strict=True))
    odd: Odd = []
    guesses = {asset.name: _guess(written[asset.name], poses[asset.name], source, odd) for asset in scene.assets}
    guesses = {name: guess for name, guess in guesses.items() if guess != Guess()}
    notes, wishes = tuple(recorded["notes"]), said.statements(wishes=True)
    return Program(
        source.text, said.statements(), guesses, notes, expressions=written, wishes=wishes, remarks=_remarks(odd)
    )


def read_salvaged(text: str, scene: Scene, limits: ProgramLimits | None = None) -> Program:
    """Return what can be read of a model's answer: a statement that cannot costs that statement, not the program.

    The smallest Python statement that an error points at is left out and the rest read again, until all of it runs.

    Raises:
        ProgramError: Nothing in it places or states anything, or more than `READING.dropped` statements are wrong.
    """
    dropped: list[str] = []
    rest, first = text, None
    while True:
        try:
            program = read_program(rest, scene, limits)
            break
        except ProgramLimitError:
            raise
        except ProgramError as error:
            first = first or error
            shorter = without_line(rest, error.line) if error.line and len(dropped) < READING.dropped else None
            if shorter is None:
                raise first from None
            rest = shorter
            dropped.append(str(error))
    if not (program.statements or program.wishes or program.guesses):
        raise first or ProgramError(
            "the answer holds no program: it places nothing and states nothing. Write assignments such as "
            "bed[0].position = [x, y, z] and statements such as solver.against_wall(bed[0], walls[0]) in one ```python block."
        )
    return replace(program, dropped=tuple(dropped))


class _Said:
    """The recorded calls of a program as statements; `inner` are the places of those that are part of another one."""

    def __init__(self, log: list[list[Any]], inner: set[int], source: ProgramSource, scene: Scene) -> None:
        self.log, self.inner, self.source, self.scene = log, inner, source, scene

    def statements(self, *, wishes: bool = False) -> tuple[Statement, ...]:
        """Return the demands in order, or the wishes."""
        own = [i for i, row in enumerate(self.log) if i not in self.inner and row[4] == wishes]
        return tuple(self._statement(number, self.log[i]) for number, i in enumerate(own, start=1))

    def _statement(self, number: int, row: list[Any]) -> Statement:
        site, weight = _site(self.source, row[0]), None
        try:
            if row[4]:
                weight = wish_weight(row[3])
            relation = self._relation(row)
        except ArgumentError as error:
            node = _argument(site, error.argument)
            line, column = (node.lineno, node.col_offset) if node else (site.line, site.column)
            raise self.source.error(str(error), line, column) from error
        text = self.source.segment(site.call) if site.call else f"solver.{row[1]}(...)"
        return Statement(relation, site.line, text, number, weight)

    def _relation(self, row: list[Any]) -> Relation:
        named = [(key, self._told(value)) for key, value in row[3] if not row[4] or key != WEIGHT]
        return build_relation(row[1], [self._told(value) for value in row[2]], named, self.scene)

    def _told(self, value: Recorded) -> Recorded:
        """Return a recorded value with the relations that it names in place of their calls."""
        if value[0] == "said":
            return ["statement", self._relation(self.log[value[1]])]
        return ["list", [self._told(item) for item in value[1]]] if value[0] == "list" else value


def _site(source: ProgramSource, place: object) -> TextPlace:
    return source.sites[place] if isinstance(place, int) and 0 <= place < len(source.sites) else TextPlace(0, 0)


def _argument(site: TextPlace, argument: int | str | None) -> ast.expr | None:
    """Return the node of an argument of the call, if it can be told."""
    if site.call is None or argument is None:
        return None
    if isinstance(argument, str):
        return next((word.value for word in site.call.keywords if word.arg == argument), None)
    starred = any(isinstance(node, ast.Starred) for node in site.call.args)
    return None if starred or argument >= len(site.call.args) else site.call.args[argument]


def _guess(expression: str, recorded: list[Any], source: ProgramSource, odd: Odd) -> Guess:
    """Return the guess for one asset; an empty one if the program says nothing about it."""
    place, turn, place_site, turn_site = recorded
    position = None if place is None else _vector(place, f"{expression}.position", _site(source, place_site), source)
    if position is not None and len(position) != 3:
        where = _site(source, place_site)
        wanted = f"{expression}.position is three numbers, x, y, z in metres, not {len(position)}"
        raise source.error(wanted, where.line, where.column)
    yaw = None if turn is None else _yaw(turn, expression, _site(source, turn_site), source, odd)
    return Guess((position[0], position[1], position[2]) if position else None, yaw)


def _yaw(recorded: Recorded, expression: str, site: TextPlace, source: ProgramSource, odd: Odd) -> float:
    """Return the yaw in radians: one number is degrees, three are radians about x, y and z, unless these are far too many."""
    turns = ["list", [recorded]] if recorded[0] == "number" else recorded
    numbers = _vector(turns, f"{expression}.rotation", site, source)
    if len(numbers) not in (1, 3):
        raise source.error(f"{expression}.rotation is [degrees] or [0, 0, radians(degrees)]", site.line, site.column)
    if len(numbers) == 3 and abs(numbers[2]) <= READING.turned:
        return numbers[2]
    if len(numbers) == 3:
        odd.append((site.line, numbers[2]))
    return math.radians(numbers[-1])


def _remarks(odd: Odd) -> tuple[str, ...]:
    """Return what to say of rotations that were read as degrees."""
    if not odd:
        return ()
    lines, (_, first) = ", ".join(map(str, sorted({line for line, _ in odd}))), odd[0]
    why = f"three numbers are radians, and {first:g} radians are more than two turns"
    return (f"Rotations of line {lines} were read as degrees: {why}; write [{first:g}] or [0, 0, radians({first:g})].",)


def _vector(recorded: Recorded, what: str, site: TextPlace, source: ProgramSource) -> list[float]:
    items = recorded[1] if recorded[0] == "list" else []
    if not items or any(item[0] != "number" for item in items):
        raise source.error(f"{what} takes a list of numbers", site.line, site.column)
    numbers: list[float] = [item[1] for item in items]
    if not all(math.isfinite(value) and abs(value) <= READING.farthest for value in numbers):
        shown = ", ".join(f"{value:g}" for value in numbers[:3])
        message = f"{what} = [{shown}]: every number must be finite and within {READING.farthest:g}"
        raise source.error(message, site.line, site.column)
    return numbers
