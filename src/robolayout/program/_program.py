"""The constraint program as data: statements about where things stand, and first guesses of poses.

`solver.against_wall(bed[0], walls[2])` on line 12 is a `Statement` whose relation is `AgainstWall(bed-0, walls[2])`;
`bed[0].position = [2, 1, 0.3]` is part of the `Guess` for bed-0.
"""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from robolayout.constraints import AssetRef, PointRef, Relation, WallRef
from robolayout.scene import program_variable, split_name


@dataclass(frozen=True)
class ReadingConfig:
    """What of a program counts as a mistake, and how much of it a message shows."""

    line: int = 160  # characters of a line that a message shows
    grace: float = 2.0  # seconds after its time limit at which the child is killed
    message: int = 400  # characters kept of a message that a program raises
    # statements of one answer left out before it counts as unreadable; each is a run of a few hundredths of a second
    dropped: int = 40
    farthest: float = 1e4  # metres from the origin beyond which a position is a mistake
    largest: float = 1e6  # largest number in an argument, in its own unit
    turned: float = 4 * math.pi  # radians beyond which a number that should be radians is read as degrees


READING = ReadingConfig()


@dataclass(frozen=True)
class ProgramLimits:
    """What a program may use; everything beyond ends in a `ProgramLimitError`."""

    seconds: float = 5.0  # time to run, in seconds
    memory: int = 256 * 2**20  # memory of the interpreter in bytes
    text: int = 128 * 1024  # characters of program text
    statements: int = 5_000  # number of statements, however they are made
    items: int = 50_000  # number of things named in all arguments together
    depth: int = 200  # calls inside calls
    printed: int = 4_000  # characters kept of what it prints; the rest is dropped


CUSTOM = "custom"
"""Who asks for what is usual, of a thing that a program says nothing about, or of a layout that is mended."""


@dataclass(frozen=True)
class Statement:
    """One relation that a program states."""

    relation: Relation  # what it says
    line: int = 0  # line of the program text that states it, counted from 1; 0 if it was not read from text
    source: str = ""  # that call as it is written, on one line
    number: int = 0  # its place among the statements, counted from 1; wishes are counted by themselves
    wish: float | None = None  # its weight if it is a wish and no demand; below 0 it is rather not wanted
    # who asks for it: "user" where it is what the words of the scene say, "custom" where it is usual, else "plan"
    by: str = "plan"


@dataclass(frozen=True)
class Guess:
    """Where a program first puts an asset."""

    position: tuple[float, float, float] | None = None  # box centre in metres; None if the program does not say
    yaw: float | None = None  # radians counter-clockwise about z; None if the program does not say


@dataclass(frozen=True)
class Program:
    """A constraint program that was read."""

    text: str = ""  # the program text that was run
    statements: tuple[Statement, ...] = ()  # what it states, in the order in which it ran
    # first poses by asset name, in the order of the scene
    guesses: Mapping[str, Guess] = field(default_factory=dict[str, Guess])
    notes: tuple[str, ...] = ()  # lines that it printed
    # what could not be read and was left out, one message each with line and caret (`read_salvaged`)
    dropped: tuple[str, ...] = ()
    # how each asset is written in program text, by name ("bed-0": "bed[0]")
    expressions: Mapping[str, str] = field(default_factory=dict[str, str], compare=False, repr=False)
    wishes: tuple[Statement, ...] = ()  # what it would like, and no more; each with its weight
    remarks: tuple[str, ...] = ()  # what was read otherwise than it is written, in sentences
    mends: bool = False  # whether its guesses are a layout to mend, where what stays shut is no reason to move things

    @property
    def complete(self) -> bool:
        """Whether it gives a place to everything."""
        placed = {name for name, guess in self.guesses.items() if guess.position is not None}
        return placed == set(self.expressions)

    def place(self, name: str) -> tuple[float, float] | None:
        """Return where it first puts an asset, in metres in plan; None if it does not say."""
        guess = self.guesses.get(name, Guess())
        return guess.position and guess.position[:2]

    def forgotten(self) -> tuple[str, ...]:
        """Return the things, as they are written in a program, that neither a guess nor a statement of its own is about."""
        own = (one for one in (*self.statements, *self.wishes) if one.by != CUSTOM)
        said = {name for statement in own for name in statement.relation.asset_names()} | set(self.guesses)
        return tuple(written for name, written in self.expressions.items() if name not in said)

    def to_text(self) -> str:
        """Return normalised program text; reading it gives the same statements and guesses."""
        lines: list[str] = []
        for name, guess in self.guesses.items():
            if guess.position is not None:
                lines.append(f"{self._asset(name)}.position = {list(guess.position)!r}")
            if guess.yaw is not None:
                lines.append(f"{self._asset(name)}.rotation = [0, 0, {guess.yaw!r}]")
        lines += [f"solver.{self.call(one.relation, one.wish)}" for one in (*self.statements, *self.wishes)]
        return "".join(line + "\n" for line in lines)

    def call(self, relation: Relation, wish: float | None = None) -> str:
        """Return a relation as program text: `against_wall(bed[0], walls[2])`; a wish with its weight."""
        shown: list[str] = []
        for place, spec in enumerate(relation.arguments()):
            value = getattr(relation, spec.name)
            in_place = len(shown) == place and isinstance(value, AssetRef | WallRef | PointRef)
            if spec.default is dataclasses.MISSING or in_place:
                shown.append(self._value(value))
            elif value != spec.default:
                shown.append(f"{spec.name}={self._value(value)}")
        if wish is None:
            return f"{relation.name}({', '.join(shown)})"
        return f"wish.{relation.name}({', '.join([*shown, f'weight={wish:g}'])})"

    def _asset(self, name: str) -> str:
        return self.expressions.get(name) or f"{program_variable(name)}[{split_name(name)[1]}]"

    def _value(self, value: object) -> str:
        match value:
            case AssetRef(name):
                return self._asset(name)
            case WallRef(index):
                return f"walls[{index}]"
            case PointRef(x, y, z):
                return f"AssetInstance(position=[{x!r}, {y!r}, {z!r}])"
            case Relation():
                return f"solver.{self.call(value)}"
            case tuple():
                return "[" + ", ".join(self._value(item) for item in value) + "]"  # type: ignore[misc]
            case str():
                return json.dumps(value)
            case float() if value.is_integer() and math.fabs(value) < 1e9:
                return str(int(value))
            case _:
                return repr(value)
