"""Pure, batched, differentiable array functions; they know boxes, segments and polygons, and no noun of the scene."""

from robolayout._geometry._backend import Array, backend
from robolayout._geometry.boxes import (
    Body,
    compose,
    corners,
    cut_separation,
    extents,
    penetration,
    point_to_box,
    separation,
)
from robolayout._geometry.intersection import intersection_area, intersection_over_union
from robolayout._geometry.polygon import signed_distance
from robolayout._geometry.relations import FrameRow, frame_residual, mirror_residual, soft_abs

__all__ = [
    "Array",
    "Body",
    "FrameRow",
    "backend",
    "compose",
    "corners",
    "cut_separation",
    "extents",
    "frame_residual",
    "intersection_area",
    "intersection_over_union",
    "mirror_residual",
    "penetration",
    "point_to_box",
    "separation",
    "signed_distance",
    "soft_abs",
]
