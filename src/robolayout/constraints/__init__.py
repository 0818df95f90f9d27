"""The vocabulary: one relation a file, with arguments, solver rows, exact check and one-line meaning."""

from importlib.metadata import entry_points

from robolayout.constraints._exact import ANGLE_TOLERANCE
from robolayout.constraints._refs import AssetRef, PointRef, Ref, WallRef
from robolayout.constraints._registry import RELATIONS, register, register_file
from robolayout.constraints._relation import Outcome, Relation, Way, argument, best_way
from robolayout.constraints._terms import (
    FAR,
    ClearTerm,
    FrameTerm,
    InsideTerm,
    Interval,
    MirrorTerm,
    OverlapTerm,
    PairwiseTerm,
    Term,
)
from robolayout.constraints.above import Above
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.any_of import AnyOf
from robolayout.constraints.around import Around
from robolayout.constraints.at_window import AtWindow
from robolayout.constraints.behind import Behind
from robolayout.constraints.between import BetweenTwo
from robolayout.constraints.by_door import ByDoor
from robolayout.constraints.ceiling_above import CeilingAbove
from robolayout.constraints.centered_on import CenteredOn
from robolayout.constraints.corner import Corner
from robolayout.constraints.distance_constraint import DistanceConstraint
from robolayout.constraints.door_clear import DoorClear
from robolayout.constraints.facing_pair import FacingPair
from robolayout.constraints.grid import Grid
from robolayout.constraints.grouped import Grouped
from robolayout.constraints.in_front_of import InFrontOf
from robolayout.constraints.in_rows import InRows
from robolayout.constraints.inside import Inside
from robolayout.constraints.inside_room import InsideRoom
from robolayout.constraints.keep_clear import KeepClear
from robolayout.constraints.left_of import LeftOf
from robolayout.constraints.mid_wall import MidWall
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.near import Near
from robolayout.constraints.next_to import NextTo
from robolayout.constraints.no_overlap import NoOverlap
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.reachable_pairwise import ReachablePairwise
from robolayout.constraints.right_of import RightOf
from robolayout.constraints.room_to_open import RoomToOpen
from robolayout.constraints.row import Row
from robolayout.constraints.snug import Snug
from robolayout.constraints.symmetric_pair import SymmetricPair
from robolayout.constraints.toward import Toward
from robolayout.constraints.under import Under
from robolayout.constraints.zone import Zone

_BUILT_IN: tuple[type[Relation], ...] = (
    AgainstWall,
    DistanceConstraint,
    OnTopOf,
    Inside,
    AlignWith,
    PointTowards,
    SymmetricPair,
    NextTo,
    Near,
    InFrontOf,
    Behind,
    LeftOf,
    RightOf,
    FacingPair,
    Corner,
    CenteredOn,
    Around,
    Row,
    Grid,
    Under,
    MountedOn,
    CeilingAbove,
    Above,
    KeepClear,
    Zone,
    AtWindow,
    ByDoor,
    MidWall,
    Snug,
    Grouped,
    Toward,
    InRows,
    BetweenTwo,
    AnyOf,
)


IMPLICIT: tuple[Relation, ...] = (NoOverlap(), InsideRoom(), DoorClear(), RoomToOpen())
"""What belongs to every program; the `paper` profile adds `ReachablePairwise`."""


for _relation in (*_BUILT_IN, *(point.load() for point in entry_points(group="robolayout.constraints"))):
    register(_relation)

__all__ = [
    "ANGLE_TOLERANCE",
    "FAR",
    "IMPLICIT",
    "RELATIONS",
    "AssetRef",
    "ClearTerm",
    "FrameTerm",
    "InsideTerm",
    "Interval",
    "MirrorTerm",
    "Outcome",
    "OverlapTerm",
    "PairwiseTerm",
    "PointRef",
    "ReachablePairwise",
    "Ref",
    "Relation",
    "Term",
    "WallRef",
    "Way",
    "argument",
    "best_way",
    "register",
    "register_file",
]
