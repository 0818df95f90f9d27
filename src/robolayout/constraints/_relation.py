"""What a relation is: arguments, terms for the solver, and an exact check for the judge.

`against_wall(bed[0], walls[2])` in a program becomes one frozen `Relation` object whose fields are its arguments. For the
solver it states *terms*: rows of numbers for a few batched kernels (`_geometry`), so that a thousand statements cost
one array program; most are "a stands so and so in the frame of b" (a bed at a wall, a chair at a table), a `FrameTerm`. For
the judge it offers `check`, which measures a finished layout exactly and shares no code with the terms. Hardness is data: a
hard relation is multiplied by a larger, ramped weight.
"""

from __future__ import annotations

import dataclasses
import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from robolayout.assets.prisms import Prism
from robolayout.constraints._refs import AssetRef, PointRef, Ref, WallRef
from robolayout.scene import Layout, Scene

FAR = 1.0e3  # metres that stand for "no bound" in a term; larger than any room


@dataclass(frozen=True)
class Interval:
    """Bounds in metres along one axis of b's frame.

    The near side of a must be at or above `low` and the far side at or below `high`, where the sides lie `low_extent` and
    `high_extent` half-extents of a's footprint away from its centre: u - low_extent * e >= low, u + high_extent * e <= high.
    With both 0 the bounds are on the centre.
    """

    low: float = -FAR
    high: float = FAR
    low_extent: float = 0.0
    high_extent: float = 0.0


@dataclass(frozen=True)
class FrameTerm:
    """One row of the frame kernel: where `a` stands in the frame of `b`."""

    a: Ref  # what stands there
    # whose frame it is: an asset (x along its front), a wall (origin in its middle, x along it, y into the room), a
    # point (its axes: the world's, turned by its yaw)
    b: Ref
    along: Interval = Interval()  # interval along b's x axis
    across: Interval = Interval()  # interval along b's y axis
    fold: bool = False  # whether `across` bounds the absolute value (either side of b will do)
    # lowest and highest distance in metres between centres (to a wall: from the centre to its segment)
    distance: tuple[float, float] = (0.0, FAR)
    heading: float | None = None  # angle in radians of a's front in b's frame; None leaves it free
    # angle in radians by which a's front is turned before it must point at b; None leaves it free
    look: float | None = None
    moves: str = "a"  # which of the two yields: "a", "b" or "both"
    weight: float = 1.0  # factor on this row

    def row(self) -> tuple[float, ...]:
        """Return its numbers in the order that `_geometry.frame_residual` reads them."""
        heading, look = self.heading or 0.0, self.look or 0.0
        return (
            *(self.along.low, self.along.high, self.along.low_extent, self.along.high_extent),
            *(self.across.low, self.across.high, self.across.low_extent, self.across.high_extent),
            *self.distance,
            float(self.heading is not None),
            math.cos(heading),
            math.sin(heading),
            float(self.look is not None),
            math.cos(look),
            math.sin(look),
            float(self.fold),
            float(self.moves in ("a", "both")),
            float(self.moves in ("b", "both")),
            self.weight,
        )


@dataclass(frozen=True)
class MirrorTerm:
    """One row of the mirror kernel: `a` and `b` are mirror images about the axis of `ref` (its front; a wall's normal)."""

    a: Ref
    b: Ref
    ref: Ref
    weight: float = 1.0


@dataclass(frozen=True)
class ClearTerm:
    """One row of the clear kernel: a box that stays free of assets."""

    owner: Ref  # Whose frame the box is in; the owner itself may be in it. A wall's frame as in `FrameTerm`.
    center: tuple[float, float]  # middle of the box in that frame, metres
    half: tuple[float, float]  # half its size along the axes of that frame, metres
    span: tuple[float, float]  # lowest and highest height of the box in metres
    exempt: frozenset[str] = frozenset()  # names of assets that may be in it
    hard: bool = True  # whether it must stay free before anything else counts
    weight: float = 1.0  # factor on this row


@dataclass(frozen=True)
class OverlapTerm:
    """One row of the overlap kernel: a prism of `a` and one of `b`, which share a height, keep apart in plan."""

    a: AssetRef
    b: AssetRef
    first: Prism  # the prism of `a`
    second: Prism  # the prism of `b`


Term = FrameTerm | MirrorTerm | ClearTerm | OverlapTerm


@dataclass(frozen=True)
class Outcome:
    """What an exact check measured."""

    met: bool  # whether the relation holds within its tolerance
    value: float  # the measured figure (the worst one where there are several)
    limit: float  # what that figure is compared with, in the same unit
    unit: str  # unit of both ("m", "deg", "m2", "")
    text: str  # the measurement as part of a sentence ("back edge 0.02 m from walls[2], front 1 deg off")
    blamed: tuple[str, ...] = ()  # names of assets that it is not about and that are in the way

    @classmethod
    def at_most(cls, limit: float, value: float, unit: str, text: str) -> Outcome:
        """Return what was measured of a figure that holds up to a limit."""
        return cls(value <= limit, value, limit, unit, text)


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
    """Return of several ways the one with the fewest unmet parts in a layout, then the least missed, and its worst outcome."""

    def short(outcome: Outcome) -> tuple[bool, float]:
        off = outcome.value - outcome.limit  # below 0 where something is too close
        return (not outcome.met, off if outcome.met else abs(off))

    def lacks(outcomes: Sequence[Outcome]) -> tuple[int, float]:
        return sum(not one.met for one in outcomes), short(max(outcomes, key=short))[1]

    measured = [(way, [one.check(scene, layout) for one in way]) for way in ways]
    best, outcomes = min(measured, key=lambda entry: lacks(entry[1]))
    return best, max(outcomes, key=short)


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return "[" + ", ".join(_shown(item) for item in value) + "]"
    return f"{value:g}" if isinstance(value, float) else str(value)
