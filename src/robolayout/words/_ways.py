"""What relations in words allow: metres, shares of the room, and the statements that meet them."""

from __future__ import annotations

import math
from collections.abc import Mapping

from robolayout.scene import Asset

Ways = tuple[tuple[tuple[str | float, ...], ...], ...]
"""Ways, each of statements, each with its further arguments."""

BESIDE, NEAR, AT_TABLE, AT_WINDOW, AT_DOOR = 0.6, 1.2, 0.5, 0.6, 1.4
"""Metres from edge to edge that "next to", "near", "at" a thing, "at the window" and "by the door" allow (0.9 m before it stay clear)."""

GATE = 1.2
"""Metres of a door from which width on what is by it is farther from its middle."""

CORNER_BY, FREE_IN_CORNER = 0.9, 1.5
"""Metres from an end of a window to what is in the corner by it, and from a corner to what is in it and touches no wall."""

AT_A_LOUNGE, AROUND_A_LOUNGE = (0.25, 0.7), (0.25, 1.4)
"""Metres between a low table and the sofas at some of its sides, or at all of them, so that one gets to it."""

ACROSS_BEDS = 1.8
"""Metres between the feet of two beds headed to opposite walls, for a desk between them."""

TOUCHING, INTO, KNEES = 0.1, (0.5, 0.9), 0.5
"""Metres between the backs of desks at which people face each other, before a mirror into which somebody looks, and between seats
that face each other."""

SAT_AT = 0.65
"""Metres of height from which on seats go under a table."""

ASKEW = (45.0, 135.0, 225.0, 315.0)
"""Degrees by which a thing is turned from a wall that stands diagonally."""

ALONG = 2.0
"""Metres of the strip in which things are along windows before which not all of them have room."""

SMALL_ON_A_RUG, TOY_ON_A_RUG, MIDDLE_OF_A_RUG = 0.7, 0.25, 0.25
"""Shares of a rug's shorter side up to which a thing is on it wholly, on one that lies at a place of its own and on any; and metres
between their middles where it is in its middle."""

MIDDLE_AISLE = 1.2
"""Metres between two columns of benches."""

AISLE = 2.0
"""Metres between two rows between which something stands and can be got to."""

BETWEEN_BEDS = 0.7
"""Metres between beds that stand in a row."""

AT_THE_FRONT = 3.5
"""Metres before a board that are the front of a room."""

AHEAD, LOOKING, BACK, BACK_WALL = 1.5, 2.5, 1.2, 2.0
"""Metres from edge to edge that "in front of" allows, in front of what a seat looks at, "behind", and behind what stands free to what
hangs on the wall."""

SEAT_BEHIND = 1.6
"""Metres from a wall to a desk between which and the wall somebody sits, at most."""

PAST_A_SEAT = (0.7, 1.6)
"""Metres between a desk and what is behind who sits at it, least and most."""

ACROSS = 12.0
"""Metres that may lie between two things that are opposite to each other."""

SEEN = (0.0, 20.0, 340.0, 40.0, 320.0)
"""Degrees by which a seat may be turned from what is visible from it, the relation allows 10 more."""

OPPOSITE: Ways = ((("in_front_of", 0.0, ACROSS),),)
OPPOSITE_HUNG: Ways = ((("in_front_of", 1.0, ACROSS),),)
OPPOSITE_SEATS: Ways = tuple((*OPPOSITE[0], look) for look in (("align_with", 180.0), ("point_towards",)))
"""Where things are that are opposite to another one, to one on the wall, and where seats, which face it."""

END_WALLS = {
    long: tuple(((side, 0.0, ACROSS),) for side in sides)
    for long, sides in ((True, ("left_of", "right_of")), (False, ("in_front_of", "behind")))
}
"""On the wall at an end of a thing, by whether that is wider than deep."""

FAR_SHARE, MIDDLE_SHARE = 0.4, 0.2
"""Shares of the room's longest and shortest side: least distance of "far from", most distance of "in the middle"."""

EXACT = 0.2
"""Metres from the middle of the room to what is exactly there, at most."""

OPEN_SHARE = 0.16
"""Share of the room's shorter side that stays free to each side of its middle where that is to be open."""

DAYLIGHT = 1.8
"""Metres from a window within which a place has daylight: about one and a half times the height of its head over a table."""

TURNED_IN = 2.0
"""Metres up to which free floor in the middle of a room is a circle in which somebody turns, and else a square."""

DEEP, LEAST_DISC = 0.9, 0.4
"""Metres that furniture is deep in a small room, and share of a free disc that it keeps off the middle there."""

OVER = (0.02, 0.1, 0.1)
"""Metres between a door or window and what hangs over it, least and usual, and from its middle to that of the door at most."""

END_OF_A_TOP = 1 / 6
"""Share of a top's width that lies between its middle and what is at one of its ends: in its outer thirds."""

LEAST_FAR, LEAST_MIDDLE = 1.5, 0.5
"""Metres: the same in small rooms."""

CROWD = 5
"""Things of a kind that stand by themselves, whatever is named beside them, and look one way."""

_BY_RIGHT_ANGLE = ((("align_with", 90.0),), (("align_with", 270.0),))
_PARALLEL = ((("align_with", 0.0),), (("align_with", 180.0),))

TOWARDS = {"in_front_of": 180.0, "behind": 0.0, "left_of": 270.0, "right_of": 90.0}
"""Degrees by which the front of what looks at a thing from its side is turned from that thing's own."""

AT_A_DESK: Ways = ((("in_front_of", -BESIDE, BESIDE),), (("behind", -BESIDE, BESIDE),))
"""Where seats stand that a desk or counter has."""

ACROSS_A_DESK: Ways = ((("behind", 0.0, BESIDE), ("align_with", 0.0)), (("behind", 0.0, AHEAD),))
"""Where a seat and another thing stand that are in front of a desk behind which somebody sits."""

VISITING: Ways = ((("behind", 0.0, AHEAD), ("align_with", 0.0)),)
"""Where seats stand that face a desk behind which somebody sits."""

BEFORE_WATCHED: Ways = (
    (("in_front_of", 0.0, LOOKING), ("point_towards",)),
    (("near", LOOKING), ("align_with", 180.0)),
)
"""Where seats stand that are in front of what is looked at: before it, or beside one that is, turned alike."""

BY_A_FIRE: Ways = (
    *((("in_front_of", 0.0, AHEAD), ("point_towards", angle)) for angle in SEEN),
    *((("near", AHEAD), ("point_towards", angle)) for angle in SEEN),
    (("next_to", "beside", AT_TABLE),),
)
"""Where seats stand that are by a fire: where one sees it, or beside it."""

BEFORE_A_MIRROR: Ways = ((("point_towards",), ("in_front_of", *INTO)),)
"""Where a seat stands from which one looks into a mirror."""

AROUND_WATCHED: Ways = (
    (("in_front_of", KNEES, LOOKING), ("point_towards",)),
    (("near", LOOKING), ("point_towards",)),
)
"""Where seats stand that are around what is looked at: before it, or near it."""

TO_ANOTHER: Mapping[str, Ways] = {
    "next": ((("near", BESIDE),),),
    "near": ((("near", NEAR),),),
    "wall": ((("near", BESIDE / 2),),),
    "by": ((("near", AT_TABLE),),),
    "left": ((("left_of", 0.0, NEAR),),),
    "right": ((("right_of", 0.0, NEAR),),),
    "front": ((("in_front_of", 0.0, AHEAD),),),
    "foot": ((("in_front_of", 0.0, BESIDE),),),
    "end": ((("in_front_of", 0.0, BESIDE),), (("next_to", "beside", BESIDE),)),
    "backsto": ((("behind", 0.0, AT_TABLE), ("align_with", 180.0)),),
    "aligned": _PARALLEL,
    "square": _BY_RIGHT_ANGLE,
}
"""What a thing is asked to be to another one, or to a place of the room, by the word of the list."""

AT_HAND = {"lefthand": 180.0, "righthand": 0.0}
"""Degrees by which a thing with a door or window at its left or right is turned from its wall."""

TURNED = frozenset((*AT_HAND, "aligned", "square", "sidelong"))
"""Relations that say how a thing is turned to a wall, a door or a window."""

AT_PLACES = frozenset((*TO_ANOTHER, *TURNED, "oneside", "on", "in", "flank", "under", "above", "behind", "hanging"))
"""Relations that lead to a place of the room as well as to things."""

KEPT_OFF = 0.6
"""Metres between a thing and what it must not be near."""

MORE = 0.3
"""Metres that may lie between two things beyond what is said."""

FAR_APART = 20.0
"""Metres that "at least" leaves open."""

OFF_A_WALL = (0.3, math.inf)
"""Metres between things and a wall that stays free, least and most."""

ABREAST: Ways = ((("next_to", "beside", AT_TABLE), ("align_with",)),)
"""Side by side, turned alike."""

FLUSH: Ways = ((("next_to", "beside", TOUCHING), ("align_with",)),)
"""As one with a counter."""

IN_A_CHAIN: Mapping[str, Ways] = {
    "together": ((("near", AT_TABLE),),),
    "abreast": ABREAST,  # on the floor, others are together
    "abreast apart": ((("near", NEAR),),),  # something stands between them
    "parallel": _PARALLEL,
    "crossed": _BY_RIGHT_ANGLE,
    "ell": tuple((("near", NEAR), *way) for way in _BY_RIGHT_ANGLE),
    "stacked": ((("on_top_of",),),),
    "tiered": ((("above",),),),
}
"""What each of several is asked to be to the one before it."""

BY_TWOS: Mapping[str, Ways] = {
    "mutual": ((("facing_pair",),),),
    "pairs": ((("near", AT_TABLE),),),
    "backs": ((("behind", 0.0, TOUCHING), ("align_with", 180.0)),),
    "mutual desks": ((("behind", 0.0, TOUCHING), ("align_with", 180.0)),),
}
"""What the second of every two is asked to be to the first."""


def beyond_jambs(width: float) -> float:
    """Return how many metres farther from the middle of a door of some width things may be that are by it."""
    return max(0.0, width - GATE) / 2


def visits(category: str) -> bool:
    """Return whether such seats are of those who sit across a desk from whose it is: a visitor chair."""
    return not {"visitor", "guest", "client", "patient"}.isdisjoint(category.split())


def rows_of(count: int) -> int:
    """Return in how many rows so many seats stand before what they face."""
    return max(2, math.isqrt(count))


def looks_over(asset: Asset) -> bool:
    """Return whether who sits at a thing looks over its back: at a desk or table, not at a reception desk."""
    kinds = [kind for kind in (asset.category, asset.like) if kind.endswith(("desk", "table"))]
    return bool(kinds) and not any(kind.endswith("reception desk") for kind in kinds)
