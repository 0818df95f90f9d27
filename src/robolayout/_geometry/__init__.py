"""Pure, batched, differentiable array functions; they know boxes, segments and polygons, and no noun of the scene."""

from robolayout._geometry.boxes import Array as Array
from robolayout._geometry.boxes import Body as Body
from robolayout._geometry.boxes import backend as backend
from robolayout._geometry.boxes import compose as compose
from robolayout._geometry.boxes import corners as corners
from robolayout._geometry.boxes import cut_separation as cut_separation
from robolayout._geometry.boxes import extents as extents
from robolayout._geometry.boxes import penetration as penetration
from robolayout._geometry.boxes import point_to_box as point_to_box
from robolayout._geometry.boxes import separation as separation
from robolayout._geometry.boxes import signed_distance as signed_distance
from robolayout._geometry.intersection import intersection_over_union as intersection_over_union
from robolayout._geometry.relations import FrameRow as FrameRow
from robolayout._geometry.relations import frame_residual as frame_residual
from robolayout._geometry.relations import mirror_residual as mirror_residual
from robolayout._geometry.relations import soft_abs as soft_abs
