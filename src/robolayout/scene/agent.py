"""The agent: the body that must get through the room and use it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from robolayout.scene.room import ROUNDING


@dataclass(frozen=True)
class Source:
    """Where a figure of an agent comes from."""

    text: str  # the source in words
    verified: bool  # whether the figure was checked against that source


@dataclass(frozen=True)
class Figure:
    """The model of a robot, and how it stands while it drives about."""

    path: Path  # its URDF or MJCF file
    pose: Mapping[str, float]  # values of its joints, radians and metres, by name; others are at 0
    foot: tuple[float, float, float]  # the middle of its footprint, on the floor, in the frame of its root


@dataclass(frozen=True)
class Agent:
    """A body that moves through a room."""

    name: str  # name of the profile
    radius: float  # radius in metres of the disc that must pass (half the corridor it needs, for rectangular bodies)
    height: float  # height in metres; what hangs higher is no obstacle
    length: float | None = None  # length of a rectangular footprint in metres; None for a disc
    width: float | None = None  # width of a rectangular footprint in metres; None for a disc
    # diameter in metres of the circle it needs to turn; None where it turns in place
    turning_diameter: float | None = None
    # radius in metres of the tightest arc that its centre drives; 0 where it turns on the spot; None where it moves
    # sideways, too
    turning_radius: float | None = None
    # horizontal reach in metres from the centre of its footprint; None if it does not reach
    reach_distance: float | None = None
    reach_low: float = 0.0  # lowest height it reaches, metres
    reach_high: float = 2.0  # highest height it reaches, metres
    shoulder_height: float | None = None  # height of the shoulder in metres; None leaves the reach a cylinder
    # how far the hand gets by height, from the model of a robot: (from, to, reach) in metres, lowest first
    reach_bands: tuple[tuple[float, float, float], ...] = ()
    # height in metres that its knees need under a top at which it sits; None where it does not sit
    knee_height: float | None = None
    step: float = 0.03  # height in metres that it steps or drives over
    title: str = ""  # name for people
    # source of each figure, by attribute name
    sources: Mapping[str, Source] = field(default_factory=dict[str, Source], compare=False)
    figure: Figure | None = field(default=None, compare=False)  # its model, if its figures were read from one

    @property
    def reach(self) -> float:
        """Horizontal reach in metres from its centre; at least touching distance (radius + 0.10 m)."""
        return max(self.reach_distance or 0.0, self.radius + BODY.touch)

    @property
    def inradius(self) -> float:
        """Metres from its centre to the nearest that it gets to a thing."""
        return self.radius if self.length is None or self.width is None else min(self.length, self.width) / 2

    @property
    def circumradius(self) -> float:
        """Radius in metres of the disc that holds the whole footprint."""
        if self.length is None or self.width is None:
            return self.radius
        return math.hypot(self.length, self.width) / 2

    @property
    def turning_circle(self) -> float:
        """Diameter in metres of the circle in which it turns right round."""
        return max(2 * self.circumradius, self.turning_diameter or 0.0)


@dataclass(frozen=True)
class BodyDefaults:
    """What is taken of every body, and of one whose figures do not say it."""

    # metres kept free on each side of a rectangular body for which no corridor is given (rule of thumb)
    clearance: float = 0.03
    touch: float = 0.10  # metres beyond its own disc at which every agent counts as having got to a thing
    # a model's body is a disc if its farthest point is at most this many times as far as its farthest side
    round: float = 1.1
    step: float = 0.03  # metres that the body of a model is taken to drive over; the model does not say


BODY = BodyDefaults()


@dataclass(frozen=True)
class Hold:
    """How a body opens one door or drawer."""

    asset: str  # the name of the thing
    joint: str  # the name of what moves
    # its centre and heading (metres, radians) at even steps from shut to open: one where it stands still; none where it
    # finds no place from which to open it
    poses: tuple[tuple[float, float, float], ...]
    moved: tuple[str, ...] = ()  # what people move that is moved away: where it stands, and where the leaf comes


DEFAULT_AGENT = Agent(name="disc", radius=0.30, height=1.5, reach_distance=0.75, title="disc of radius 0.30 m")
"""The agent of a scene that names none."""


def horizontal_reach(agent: Agent, bottom: float, top: float) -> float | None:
    """Return the horizontal reach in metres to something between two heights; None if it is out of reach in height.

    An agent without a reach distance only gets to things, whatever their height. The reach is what its bands say; without
    them, a sphere around the shoulder, and without its height a cylinder between the lowest and the highest height it reaches.
    Where its hand gets no farther than its own footprint it reaches nothing.
    """
    if agent.reach_distance is None:
        return agent.reach
    low, high = max(bottom, agent.reach_low), min(top, agent.reach_high)
    if low > high + ROUNDING:
        return None
    if agent.reach_bands:
        found = (far for begin, end, far in agent.reach_bands if begin <= high + ROUNDING and end >= low - ROUNDING)
        far = max(found, default=0.0)
    elif agent.shoulder_height is None:
        return agent.reach
    else:
        height = abs(min(max(agent.shoulder_height, low), high) - agent.shoulder_height)
        far = math.sqrt(max(agent.reach**2 - height**2, 0.0))
    return far if far > agent.inradius else None
