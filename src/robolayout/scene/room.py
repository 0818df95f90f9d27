"""The room: a floor polygon with walls, doors and windows.

A rectangular room has four walls, and a person enters it through the first door; an L-shaped one has six walls, one of
whose corners points inwards. Both are a counter-clockwise ring of vertices: wall i runs from vertex i to vertex i + 1,
and the room lies on its left.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

Point = tuple[float, float]
ROUNDING = 1e-6  # metres: lengths that differ by no more are equal, and points no farther apart are one


@dataclass(frozen=True)
class OpeningConfig:
    """What holds for every door and window, and what is taken where a file does not say."""

    landing_depth: float = 0.9  # metres of depth of the clear landing inside a door (DESIGN section 4)
    one_leaf: float = 1.4  # metres of width up to which a door has one leaf
    landing_height: float = 2.0  # metres above the floor up to which that landing stays free (DESIGN section 4)
    door_height: float = 2.05  # metres of height of a door that gives none
    window_height: float = 1.2  # metres of height of a window that gives none
    window_sill: float = 0.9  # metres of its sill above the floor
    # metres of height that are left to a door or window higher than its wall, or else it is refused
    least_height: float = 0.1


OPENINGS = OpeningConfig()


@dataclass(frozen=True)
class Wall:
    """One straight wall, seen from above."""

    index: int  # its place in the room; it starts at vertex `index`
    start: Point  # first end, metres
    end: Point  # second end, metres

    @cached_property
    def length(self) -> float:
        """Length in metres."""
        return math.dist(self.start, self.end)

    @cached_property
    def direction(self) -> Point:
        """Unit vector from start to end."""
        return ((self.end[0] - self.start[0]) / self.length, (self.end[1] - self.start[1]) / self.length)

    @cached_property
    def normal(self) -> Point:
        """Unit vector into the room."""
        return (-self.direction[1], self.direction[0])

    @cached_property
    def midpoint(self) -> Point:
        """Middle of the wall, metres."""
        return ((self.start[0] + self.end[0]) / 2, (self.start[1] + self.end[1]) / 2)

    def point(self, offset: float, depth: float = 0.0) -> Point:
        """Return the point `offset` metres along the wall and `depth` metres into the room."""
        (dx, dy), (nx, ny) = self.direction, self.normal
        return (self.start[0] + dx * offset + nx * depth, self.start[1] + dy * offset + ny * depth)

    def place(self, point: Point) -> Point:
        """Return where a point is: how far along the wall's line, and how far into the room from it, metres."""
        (dx, dy), (nx, ny), x, y = self.direction, self.normal, point[0] - self.start[0], point[1] - self.start[1]
        return (x * dx + y * dy, x * nx + y * ny)

    def between(self, openings: Iterable[Opening]) -> list[tuple[float, float]]:
        """Return the stretches of the wall, in metres along it, that no opening in it takes."""
        done, stretches = 0.0, list[tuple[float, float]]()
        for opening in sorted((o for o in openings if o.wall == self.index), key=lambda o: o.offset):
            stretches.append((done, opening.offset))
            done = max(done, opening.offset + opening.width)
        return [(start, end) for start, end in (*stretches, (done, self.length)) if start < end]

    def distance(self, point: Point) -> float:
        """Return how far a point is from the wall, metres."""
        return math.dist(point, self.point(min(max(self.place(point)[0], 0.0), self.length)))


@dataclass(frozen=True)
class Leaf:
    """One leaf of a door: how it hangs, and where it opens to."""

    hinge: float  # metres along the wall to the edge at which it hangs
    toward: int  # 1 where it lies towards the wall's end from there while it is shut, -1 towards its start
    width: float  # metres
    into: int  # 1 where it opens into the room, -1 out of it


@dataclass(frozen=True)
class Opening:
    """A door or window in a wall."""

    wall: int  # index of the wall it is in
    offset: float  # metres from the wall's start to the opening's nearer edge
    width: float  # clear width in metres
    height: float  # height of the opening in metres
    sill: float = 0.0  # height of its lower edge above the floor in metres; 0 for doors
    hinge: str = "left"  # side on which a door hangs, "left" or "right", seen from inside the room
    swing: str = "out"  # whether a door opens "in" to the room or "out" of it
    open: bool = False  # whether a door stands open, at a right angle to its wall

    @property
    def leaves(self) -> int:
        """Number of its leaves: a wide door has two."""
        return 2 if self.width > OPENINGS.one_leaf else 1

    @property
    def center(self) -> float:
        """Metres from the wall's start to the middle of the opening."""
        return self.offset + self.width / 2

    @property
    def outward(self) -> float:
        """Metres out of the room that a door's leaves sweep; 0 where they swing in."""
        return self.width / self.leaves if self.swing == "out" else 0.0

    def hung(self, rim: float = 0.0, gap: float = 0.0) -> tuple[Leaf, ...]:
        """Return a door's leaves, `rim` metres inside the opening's edges and with `gap` metres between two."""
        into, clear = 1 if self.swing == "in" else -1, self.width - 2 * rim
        wide = clear if self.leaves == 1 else (clear - gap) / 2
        right, left = Leaf(self.offset + rim, 1, wide, into), Leaf(self.offset + self.width - rim, -1, wide, into)
        return (right, left) if self.leaves == 2 else (left,) if self.hinge == "left" else (right,)


@dataclass(frozen=True)
class Room:
    """A room: its floor polygon, wall height, doors and windows."""

    vertices: tuple[Point, ...]  # counter-clockwise floor corners in metres; may be concave
    wall_height: float  # height of walls and ceiling in metres
    doors: tuple[Opening, ...] = ()  # doors; the first one is where agents enter
    windows: tuple[Opening, ...] = ()
    # name of what lies on the floor ("oak planks", "marble tiles"); where it is empty or unknown, the seed picks
    floor: str = ""

    @cached_property
    def walls(self) -> tuple[Wall, ...]:
        """All walls, in the order of the vertices."""
        ring = zip(self.vertices, self.vertices[1:] + self.vertices[:1], strict=True)
        return tuple(Wall(i, start, end) for i, (start, end) in enumerate(ring))

    @cached_property
    def bounds(self) -> tuple[float, float, float, float]:
        """Smallest x, smallest y, largest x, largest y in metres."""
        xs, ys = zip(*self.vertices, strict=True)
        return (min(xs), min(ys), max(xs), max(ys))

    def extent(self, free: float = 0.0) -> tuple[float, float, float, float]:
        """Return `bounds`, larger where leaves swing out of the room by more than `free` metres, metres."""
        swept = [
            self.walls[door.wall].point(edge, min(free - door.outward, 0.0))
            for door in self.doors
            for edge in (door.offset, door.offset + door.width)
        ]
        xs, ys = zip(*self.vertices, *swept, strict=True)
        return (min(xs), min(ys), max(xs), max(ys))

    @cached_property
    def area(self) -> float:
        """Floor area in square metres."""
        return sum(w.start[0] * w.end[1] - w.end[0] * w.start[1] for w in self.walls) / 2

    @cached_property
    def fills_bounds(self) -> bool:
        """Whether it is a rectangle along the axes."""
        x0, y0, x1, y1 = self.bounds
        return math.isclose(self.area, (x1 - x0) * (y1 - y0))

    def way_in(self, length: float, width: float, slack: float) -> tuple[Point, Point, Point, Point]:
        """Return the corners of where a rectangular body's centre is, within a slack, once it is straight in by the first door."""
        aside, depth = max(self.doors[0].width - width, slack), length / 2 + slack
        return self.landing(replace(self.doors[0], offset=self.doors[0].center - aside / 2, width=aside), depth)

    def landing(self, door: Opening, depth: float | None = None) -> tuple[Point, Point, Point, Point]:
        """Return the corners of the door's landing: its width, `depth` metres into the room, counter-clockwise.

        Without a depth it is as deep as a landing must be, or as a leaf that swings in.
        """
        if depth is None:
            depth = max(OPENINGS.landing_depth, door.width / door.leaves if door.swing == "in" else 0.0)
        wall = self.walls[door.wall]
        near, far = door.offset, door.offset + door.width
        return (wall.point(near), wall.point(far), wall.point(far, depth), wall.point(near, depth))
