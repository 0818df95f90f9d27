"""The style of every picture: what is a choice of looks stands here, with its unit."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class PlanStyle:
    """How plans are drawn; lengths and font sizes in millimetres of paper unless said otherwise."""

    scales: tuple[int, ...] = (25, 50, 100, 200, 500)  # scales that a plan may have
    longest: float = 180.0  # millimetres that the room may take; the first scale that fits is used
    margin: float = 6.0  # millimetres around the room's walls
    least: float = 4.0  # millimetres around leaves of doors that swing out
    samples: int = 3  # supersampling of the Pillow form along each side
    wall: float = 0.12  # drawn thickness of walls, metres
    arrow: float = 1.8  # length of an arrow's head, millimetres
    width_text: float = 2.1  # font size of the width of a passage, millimetres
    cord: float = 0.9  # half the sides of the cross at which a thing hangs from the ceiling, millimetres


PLAN = PlanStyle()


@dataclass(frozen=True)
class LabelStyle:
    """Where names go, and how large they are."""

    line: float = 1.12  # distance of two lines of text, in font sizes
    squarish: float = 1.6  # ratio of a footprint's sides below which its name stands level aside, not turned
    sizes: tuple[float, ...] = (2.3, 2.0, 1.7, 1.4, 1.15)  # font sizes that are tried for a name, millimetres
    margin: float = 0.25  # millimetres between a name and the edge of the footprint that it stands in
    eager: int = 3  # font sizes that are tried for a place where no line is crossed, before the name may cross one


LABELS = LabelStyle()


@dataclass(frozen=True)
class SheetStyle:
    """The sheet to print: its frame, lists and dimension lines, in millimetres of paper unless said otherwise."""

    edge: float = 8.0  # millimetres at the paper's edges that stay white: printers do not reach them
    inset: float = 5.0  # millimetres between the frame and what is drawn in it
    title: float = 22.0  # height of the title block, millimetres
    legend: float = 6.0  # height of the legend below the plan, millimetres
    names: tuple[float, ...] = (2.4, 2.1, 1.8, 1.6)  # font sizes of names and numbers in the room, millimetres
    texts: tuple[float, ...] = (2.5, 2.25, 2.0, 1.8)  # font sizes of the lists, millimetres
    column: float = 30.0  # least width of a column, in font sizes
    widest: float = 36.0  # largest width of a column, in font sizes
    line: float = 1.42  # distance of two lines of a list, in font sizes
    gap: float = 5.0  # millimetres between two columns
    shortest: int = 4  # lines that a column holds at least
    head: float = 1.22  # font size of a heading, in sizes of the text below it
    beside: float = 8.0  # millimetres between a wall and its first dimension line: room for numbers
    past: float = 3.5  # millimetres between a leaf that swings out and that line: room for lengths
    step: float = 5.5  # millimetres between dimension lines
    lengths: tuple[float, float, float] = (2.1, 1.8, 1.5)  # font sizes that are tried for a length, millimetres
    same: float = 1e-3  # metres within which two marks on a chain are one
    room: float = 0.8  # millimetres that a length leaves free between its ticks


SHEET = SheetStyle()


@dataclass(frozen=True)
class ModelPlanStyle:
    """The plan for a model, in millimetres of paper."""

    longest: float = 150.0  # millimetres that the longer side of the room takes
    edge: float = 12.0  # millimetres around the walls, for ticks and the names of walls, doors and windows
    named_at: float = 8.5  # millimetres from the outside of a wall to its name: beyond the numbers of the ticks
    # font sizes that are tried for a name, millimetres: the smallest has 12 pixels in a picture of 1,024
    sizes: tuple[float, ...] = (3.4, 3.0, 2.6, 2.2)
    text: float = 2.6  # font size of ticks, walls, openings and the key, millimetres
    ticks: int = 25  # most ticks with a number along one side; else every second, fifth ... is written
    hatch: float = 2.2  # millimetres between the lines that cross out what must stay free


MODEL_PLAN = ModelPlanStyle()


@dataclass(frozen=True)
class BodyStyle:
    """The drawing of a body, in millimetres of paper unless said otherwise."""

    scales: tuple[int, ...] = (5, 10, 20, 25, 50, 100)  # scales that a drawing may have
    space: float = 62.0  # millimetres that each of the two views may take
    size: float = 2.3  # millimetres of the letters
    edge: float = 15.0  # millimetres left of the views
    head: float = 12.0  # millimetres above them
    foot: float = 14.0  # millimetres below them
    between: float = 22.0  # millimetres between the two views
    labels: float = 36.0  # millimetres for the words beside the heights
    door: tuple[float, float] = (0.9, 2.05)  # width and height in metres of the doorway that is drawn for comparison


BODY = BodyStyle()


@dataclass(frozen=True)
class MarkStyle:
    """The marks in a picture for a model."""

    arrow: float = 0.75  # length of the arrow along an asset's front in metres (the paper's l)
    wall_offset: float = 0.2  # metres from a wall's middle to its label, away from the room (the paper's beta)
    grid_step: float = 1.0  # smallest grid spacing in metres (the paper's Delta_0)
    azimuth: float = math.radians(-60.0)  # azimuth of the annotated side view, radians, always the same
    enough: float = 46.0  # pixels between grid points below which only every second, third... one is labelled.
    number: float = 9.5  # height of the coordinates in a picture of 768 pixels
    compass: tuple[tuple[int, int], ...] = ((0, -1), (0, 1), (1, 0), (-1, 0), (1, -1), (-1, -1), (1, 1), (-1, 1))


MARKS = MarkStyle()


@dataclass(frozen=True)
class FilmStyle:
    """Moving pictures: the search, and the body's walk."""

    samples: int = 2  # supersampling along each side of a frame
    sheet: float = 120.0  # width of a frame's drawing, millimetres
    strip: float = 26.0  # height of the loss strip below the plan, millimetres
    hold: int = 2500  # milliseconds for which the last frame stays
    search_colors: int = 96  # colours of an animation
    slow: float = 0.25  # metres that the body moves from frame to frame, if there are frames enough
    pause: int = 70  # milliseconds per frame
    stop: int = 9  # frames' time for which the body stays at a stop
    walk_colors: int = 128  # colours of the animation
    foot: float = 9.0  # millimetres below the plan, for the words
    together: float = 0.3  # metres: assets whose ways end as close as this are visited at once
    spacing: float = 0.15  # metres between the points of a way at which the agent may leave it
    slack: float = 1e-3  # metres by which a straight way may leave the free space, for rounding
    nearest: int = 3  # stops, as the crow flies, of which that with the shortest way is the next
    turn: float = 0.3  # metres of way that take as long as a turn by a radian


FILM = FilmStyle()


@dataclass(frozen=True)
class ViewStyle:
    """Cameras, and what they see of a room."""

    alpha: float = 1.5  # the paper's camera distance, as a multiple of the room's larger side
    side_polar: float = math.radians(45.0)  # angle from the vertical of the side view, radians
    near: float = 0.05  # nearest depth in metres that is drawn
    top_azimuth: float = -math.pi / 2  # azimuth of the view from above, radians: +x is right, +y is up
    close: float = 0.75  # sides of an asset, the longest, that a close-up shows to each side of its middle ...
    close_least: float = 0.6  # ... and the least metres
    # directions of close-ups from the asset's front and from the vertical
    close_polars: tuple[float, float] = (math.radians(58), math.radians(40))
    ghostly: float = 0.35  # opacity of a ghost
    steep: float = 0.9  # sine of the angle looking down above which what hangs from the ceiling is a ghost ...
    flush: float = 0.3  # ... and metres of height up to which it is one in every view from outside
    largest: int = 8192  # most pixels along a side of a picture
    columns: int = 10  # most columns of a sheet of things
    cut_color: tuple[float, float, float] = (0.42, 0.41, 0.40)  # sRGB colour of a cut wall
    hides: float = 0.02  # share of the floor that a wall may hide before it is cut away
    on_wall: float = 0.25  # metres within which an asset fixed to a wall goes with it


VIEW = ViewStyle()


@dataclass(frozen=True)
class LightStyle:
    """Light, shadow and colour in pictures in space."""

    sky: int = 48  # sky directions whose visibility is looked up for every corner of the refined mesh
    sun: int = 5  # directions inside the sun's disc; they make the shadow's edge soft
    bounce: float = 0.95  # reflected light on a vertical surface ...
    bounce_tilt: float = 0.80  # ... and how much more on one that looks down
    bias: float = 0.012  # metres by which a point is lifted along its normal before its visibility is looked up
    background: tuple[float, float, float] = (0.965, 0.960, 0.950)  # sRGB colour behind everything
    shoulder: float = 0.75  # linear value above which the tone curve bends, so that bright walls keep their drawing
    sun_tile: int = 768  # pixels along a side of a light's depth map
    sun_columns: int = 3  # such maps along a side of the atlas
    texture: int = 512  # most pixels along a side of a texture; larger pictures of own meshes are made smaller
    crease: float = 0.80  # cosine of the angle (37 degrees) below which neighbouring faces are shaded as one
    longest: float = 0.4  # metres to which the edges of a mesh are refined; more in large rooms
    sliver: float = 0.1  # area, in squares of the longest edge allowed, below which a triangle is not refined
    sun_distance: float = 60.0  # metres to the sun ...
    sun_radius: float = 2.6  # ... and of its disc, wider than the real one so that shadows are soft
    indoors: float = 1.6  # radiance of the ceiling in a view from inside, which neither sun nor sky would light
    exposure: float = 0.74  # factor on the radiance before the tone curve


LIGHT = LightStyle()
