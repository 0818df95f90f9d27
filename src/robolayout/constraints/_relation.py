"""What a relation is: arguments, terms for the solver, and an exact check for the judge.

`against_wall(bed[0], walls[2])` in a program becomes one frozen `Relation` object whose fields are its arguments. For the
solver it states *terms*: rows of numbers for a few batched kernels (`_geometry`), so that a thousand statements cost
one array program. For the judge it offers `check`, which measures a finished layout exactly and shares no code with the
terms. Hardness is data: a hard relation is multiplied by a larger, ramped weight.
"""

from __future__ import annotations

import dataclasses
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from robolayout.constraints._refs import AssetRef, PointRef, Ref, WallRef
from robolayout.constraints._terms import Term
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Outcome:
    """What an exact check measured."""

    met: bool  # whether the relation holds within its tolerance
    value: float  # the measured figure (the worst one where there are several)
    limit: float  # what that figure is compared with, in the same unit
    unit: str  # unit of both ("m", "deg", "m2", "")
    text: str  # the measurement as part of a sentence ("back edge 0.02 m from walls[2], front 1 deg off")


def argument(*takes: str, many: bool = False, unit: str = "", choices: tuple[str, ...] = (), **options: Any) -> Any:
    """Declare an argument of a relation.

    Args:
        takes: What may stand here: "asset", "wall", "point", "room" (None), "number", "text", "polygon".
        many: Whether it is a list of those.
        unit: Unit of a number as it is written in programs ("m", "deg").
        choices: Allowed texts.
    """
    return dataclasses.field(metadata={"takes": takes, "many": many, "unit": unit, "choices": choices}, **options)


class Relation(ABC):
    """One statement about where things stand; concrete relations are frozen dataclasses, one per file."""

    name: ClassVar[str]  # the word in a program, `solver.<name>(...)`
    moves: ClassVar[tuple[str, ...]] = ("a",)  # which arguments the solver may move to satisfy it
    # whether it settles the heading of its first argument (the filter allows one of those per asset)
    orients: ClassVar[bool] = False
    hard: ClassVar[bool] = False  # whether it must hold before anything else counts
    implicit: ClassVar[bool] = False  # whether it belongs to every program and cannot be written in one
    # whether the terms ask for more than the check, such as a whole footprint where the check wants the centre: the
    # laws then hold one direction only, residual 0 means that the check passes
    surrogate: ClassVar[bool] = False
    as_guessed: ClassVar[bool] = False  # whether its rows hold only while what it refers to stays where it is guessed
    example: ClassVar[str]  # one line of program text that uses it

    @abstractmethod
    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return the rows that the solver evaluates; their sum is the residual, 0 when satisfied.

        Args:
            near: A first guess of all poses, by which a relation with several ways out ("a corner") picks one.
        """

    @abstractmethod
    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Measure the relation exactly in a finished layout; all its assets must be placed."""

    def fault(self, scene: Scene) -> str:
        """Return what makes no sense about the arguments in this scene, as a sentence; "" if nothing does.

        The reader refuses a statement with a fault, so `terms` and `check` never see one.
        """
        return ""

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return the ways in which it can hold, where it leaves open which; else none."""
        return ()

    @classmethod
    def arguments(cls) -> tuple[dataclasses.Field[Any], ...]:
        """Return the declared arguments, in program order."""
        return dataclasses.fields(cls)  # type: ignore[arg-type]

    @classmethod
    def meaning(cls) -> str:
        """Return the first line of the docstring: what it says, in one sentence."""
        return (cls.__doc__ or "").strip().splitlines()[0]

    def refs(self) -> tuple[Ref, ...]:
        """Return everything it is about, in argument order, lists flattened."""
        found: list[Ref] = []
        for field in self.arguments():
            value = getattr(self, field.name)
            for item in value if isinstance(value, tuple) else (value,):
                if isinstance(item, AssetRef | WallRef | PointRef):
                    found.append(item)
        return tuple(found)

    def asset_names(self) -> tuple[str, ...]:
        """Return the names of the assets it is about, in argument order."""
        return tuple(ref.name for ref in self.refs() if isinstance(ref, AssetRef))

    def sentence(self) -> str:
        """Return the statement as program-like text for reports: `against_wall(bed-0, walls[2])`."""
        shown: list[str] = []
        for field in self.arguments():
            value = getattr(self, field.name)
            if field.default is not dataclasses.MISSING and value == field.default:
                continue
            text = _shown(value)
            shown.append(text if not shown or "number" not in field.metadata["takes"] else f"{field.name}={text}")
        return f"{self.name}({', '.join(shown)})"


Way = tuple[Relation, ...]  # relations that hold together


def best_way(ways: Sequence[Way], scene: Scene, layout: Layout) -> tuple[Way, Outcome]:
    """Return which of several ways holds best in a layout, and its worst outcome; of equals the first."""

    def short(outcome: Outcome) -> tuple[bool, float]:
        return (not outcome.met, outcome.value - outcome.limit)

    measured = [(way, max((one.check(scene, layout) for one in way), key=short)) for way in ways]
    return min(measured, key=lambda entry: short(entry[1]))


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return "[" + ", ".join(_shown(item) for item in value) + "]"
    return f"{value:g}" if isinstance(value, float) else str(value)
