"""A floor as a grid: how clear it is, where a body gets to, by which way, and what a thing cuts off.

It knows rooms, bodies and what stands in their way, but no statements; the judge in `verify` works all of this out for itself.
"""

from robolayout.floor.cells import Cells as Cells
from robolayout.floor.cells import cell_size as cell_size
from robolayout.floor.cells import turning_radius as turning_radius
from robolayout.floor.config import FLOOR as FLOOR
from robolayout.floor.furnished import Floor as Floor
from robolayout.floor.furnished import Points as Points
from robolayout.floor.furnished import Shadow as Shadow
from robolayout.floor.furnished import placed as placed
from robolayout.floor.furnished import rect_points as rect_points
from robolayout.floor.ground import Ground as Ground
from robolayout.floor.ground import make_ground as make_ground
from robolayout.floor.routes import RoutePlan as RoutePlan
from robolayout.floor.routes import plan_routes as plan_routes
from robolayout.floor.standing import Standing as Standing
from robolayout.floor.standing import standing as standing
from robolayout.floor.standing import use_cells as use_cells
from robolayout.floor.targets import SIDES as SIDES
from robolayout.floor.targets import RoomContents as RoomContents
from robolayout.floor.targets import targets_of as targets_of
from robolayout.floor.walked import Blocks as Blocks
from robolayout.floor.walked import Walked as Walked
