"""Where bodies can stand on the floor as it is furnished so far, and from which cells they use a thing.

How a rectangular body gets there is in `lanes`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from robolayout._grid import components, within
from robolayout.floor.cells import Cells, Mask, entered, turning_radius
from robolayout.floor.config import FLOOR
from robolayout.floor.furnished import Floor, Shadow
from robolayout.floor.ground import cells_about, used_from
from robolayout.floor.lanes import either_way, free_ways
from robolayout.floor.targets import SIDES, use_of
from robolayout.scene import Agent, Asset


@dataclass(frozen=True, eq=False)
class Standing:
    """Where one agent gets to."""

    near: Mask  # cells of which it gets within reach
    cut_off: float  # share of the free floor that it cannot get to
    easy: Mask  # cells on which its centre can stand to use something and turn right round
    floor: Floor
    agent: Agent  # the body

    def serves(self, cells: Cells, use: Cells | None) -> bool:
        """Whether it gets within reach of some of these cells and stands, whichever way round, on some of those of a use."""
        if not self.near.ravel()[cells].any():
            return False
        return use is None or bool(self.easy.ravel()[use].any()) or bool(self.stand.ravel()[use].any())

    @cached_property
    def stand(self) -> Mask:
        """Cells on which its centre can stand to use something, one way round or the other."""
        return np.logical_or.reduce(self.ways)

    @cached_property
    def ways(self) -> tuple[Mask, ...]:
        """The same along and across the way in by the first door; a disc has one way round."""
        return (self.easy,) if self.agent.length is None else either_way(self.floor, self.agent)

    def makes_way(self, use: Cells, chairs: Sequence[Shadow]) -> bool:
        """Whether it gets on from where it stands to some cells of a use, once it has moved some chairs away."""
        if self.agent.reach_distance is None or not chairs or not len(use):
            return False
        floor = self.floor
        rim = math.ceil((self.agent.circumradius + FLOOR.onward) / floor.cell) + 2
        x, y = np.divmod(use, floor.body.shape[1])
        window = tuple(slice(max(int(at.min()) - rim, 0), int(at.max()) + rim + 1) for at in (x, y))
        if not any(way[window].any() for way in self.ways):
            return False
        body = floor.body.copy()
        for chair in chairs:
            body[chair.under] -= chair.covered
        taken = ~floor.inside[window] | (body[window] > 0)
        wanted = np.zeros(body.shape, np.bool_)
        wanted[x, y] = True
        for way, free in zip(self.ways, free_ways(floor, taken, self.agent), strict=True):
            labels, sizes = components(free)
            here = np.zeros(len(sizes) + 1, np.bool_)
            here[labels[way[window] & free]] = True
            if here[labels[wanted[window] & free]].any():
                return True
        return False


def standing(floor: Floor, agent: Agent) -> Standing:
    """Return where an agent gets to from the door."""
    labels, sizes = components(floor.clear >= agent.radius / floor.cell + 1.0)
    here = entered(labels, sizes, floor.door)
    if not here:
        nowhere = np.zeros_like(floor.inside)
        return Standing(nowhere, 1.0, nowhere, floor, agent)
    main = labels == here
    near = within(main, (_reach(agent.reach, agent, floor) - FLOOR.short_of) / floor.cell + 1e-6)
    return Standing(near, 1.0 - float(main.sum()) / float(sizes.sum()), _turning(floor, agent, main), floor, agent)


def _reach(reach: float, agent: Agent, floor: Floor) -> float:
    """Return a reach in metres, or as far as the nearest cells on which a body can stand may be from what it stands at."""
    return max(reach, agent.radius + FLOOR.nearest * floor.cell)


def _turning(floor: Floor, agent: Agent, main: Mask) -> Mask:
    """Return where a body that comes in by the door gets to while it can turn right round; `main` for a disc."""
    if agent.length is None or agent.width is None:
        return main
    labels, sizes = components(floor.clear >= turning_radius(agent) / floor.cell + 1.0)
    here = entered(labels, sizes, floor.door)  # what it turns on from the landing is joined to the door, straight in
    return labels == here if here else np.zeros_like(main)


def use_cells(
    floor: Floor, asset: Asset, agent: Agent, place: tuple[float, float, float], bottom: float, *, carried: bool
) -> Cells | None:
    """Return the cells from which an agent uses a thing at a place (x, y, yaw); None as `use_of` has it."""
    use = use_of(asset, bottom, agent, carried=carried)
    if use is None or (agent.reach_distance is None and not asset.on_floor):
        return None
    reach, sides = _reach(use[0], agent, floor), use[1]
    x, y, yaw = place
    pose, half = np.array([x, y, math.cos(yaw), math.sin(yaw)]), np.array(asset.size[:2]) / 2
    i, j = cells_about(floor.xs, floor.ys, pose, half, reach, max(1, round(FLOOR.use_spacing / floor.cell)))
    used, asked = np.zeros(floor.inside.shape, np.bool_), np.array([side in sides for side in SIDES])
    used[i, j] = used_from(floor.xs[i, None], floor.ys[j], pose, half, reach - floor.cell / 2, asked)
    return np.flatnonzero(used)
