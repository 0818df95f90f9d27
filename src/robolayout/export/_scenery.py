"""What a file holds beside furniture so that it can be looked at: the light of lamps, and a camera that sees the whole room."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from robolayout.assets import Part
from robolayout.export._mesh import FloatArray
from robolayout.scene import Room

LAMP = "lampshade"  # the material whose parts give a lamp's light


@dataclass(frozen=True)
class SceneryConfig:
    """Light, camera and lines of files that are looked at."""

    # light of one lamp: a bulb that replaces one of 60 W (Commission Regulation (EC) No 244/2009, table 6)
    lumens: float = 806.0
    warm: tuple[float, float, float] = (1.0, 0.71, 0.42)  # linear colour of a bulb of about 3000 K
    field: float = math.radians(40.0)  # vertical field of view of the camera in radians
    aspect: float = 4 / 3  # width of its picture by the height
    bulb: float = 0.05  # metres of a lamp's light's radius
    route_width: float = 0.03  # metres of width that routes are drawn with in USD


SCENERY = SceneryConfig()


def lamp(pieces: tuple[Part, ...]) -> tuple[float, float, float] | None:
    """Return from where in its asset's frame a lamp gives its light, in metres; None for what is no lamp."""
    shades = [part.vertices for part in pieces if part.material.name == LAMP]
    if not shades:
        return None
    points = np.concatenate(shades)
    x, y, z = ((points.min(axis=0) + points.max(axis=0)) / 2).tolist()
    return (x, y, z)


def overview(room: Room) -> tuple[tuple[float, float, float], FloatArray]:
    """Return a camera outside and above, in front of the longest wall without a door, that sees the whole room.

    It is a place in metres, and a (3, 3) rotation whose columns are its right, up and backward axes.
    """
    x0, y0, x1, y1 = room.bounds
    doors = {door.wall for door in room.doors}
    wall = max(room.walls, key=lambda w: (w.index not in doors, round(w.length, 3), -w.index))
    back = np.array([-wall.normal[0], -wall.normal[1], 1.2])
    back /= np.linalg.norm(back)
    middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2, room.wall_height / 2])
    reach = math.hypot(x1 - x0, y1 - y0, room.wall_height) / 2
    right = np.cross((0.0, 0.0, 1.0), back)
    right /= np.linalg.norm(right)
    x, y, z = (middle + back * reach / math.sin(SCENERY.field / 2)).tolist()
    return (x, y, z), np.column_stack([right, np.cross(back, right), back])
