"""A floor as a grid: how clear it is, where a body gets to, by which way, and what a thing cuts off.

It knows rooms, bodies and what stands in their way, but no statements; the judge in `verify` works all of this out for itself.
"""

from robolayout.floor.cells import Cells, turning_radius
from robolayout.floor.config import FLOOR, FloorConfig
from robolayout.floor.furnished import Floor, Points, Shadow, placed, rect_points
from robolayout.floor.goals import missed
from robolayout.floor.ground import Ground, Obstacles, clearance, make_ground, obstacles_of
from robolayout.floor.routes import Plan, plan_routes
from robolayout.floor.standing import Standing, standing, use_cells
from robolayout.floor.targets import SIDES, Contents, Targets, targets_of
from robolayout.floor.walked import Blocks, Walked

__all__ = [
    "FLOOR",
    "SIDES",
    "Blocks",
    "Cells",
    "Contents",
    "Floor",
    "FloorConfig",
    "Ground",
    "Obstacles",
    "Plan",
    "Points",
    "Shadow",
    "Standing",
    "Targets",
    "Walked",
    "clearance",
    "make_ground",
    "missed",
    "obstacles_of",
    "placed",
    "plan_routes",
    "rect_points",
    "standing",
    "targets_of",
    "turning_radius",
    "use_cells",
]
