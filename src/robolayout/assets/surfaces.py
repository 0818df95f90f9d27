"""Where a thing can hold others: its tops, seats, shelves and floors, found from its parts.

A surface is what lies level, faces up and is not built over: tops of parts at one height, less what rises from them. What
is covered by the thing itself is a shelf, with the free height below what covers it; the rest is open. Names follow from
that and from the parts: "top", "seat", "shelf 1" (the lowest), "drawer 2", so that a program can say which is meant.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property, lru_cache
from itertools import count, pairwise, product
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Point, Polygon

from robolayout._errors import AssetError
from robolayout.assets.category import read_data
from robolayout.assets.fronts import TRAY
from robolayout.assets.lexicon import category_of
from robolayout.assets.part import Part
from robolayout.assets.prisms import largest_block, level_tops, piece_spans
from robolayout.scene import Asset


@dataclass(frozen=True)
class SurfaceConfig:
    """What of a thing holds others, in metres unless said otherwise."""

    level: float = 0.012  # metres of height within which tops are one surface: seams of a seat, a duvet's edge
    seam: float = 0.015  # metres between tops at one height that are one surface all the same
    rises: float = 0.06  # metres above a surface below which a part over it stands on it; what begins higher covers it
    least_area: float = 0.0025  # square metres below which a top holds nothing
    least_side: float = 0.03  # metres across below which a top holds nothing
    least_shelf: float = 0.01  # square metres below which what is covered holds nothing
    least_free: tuple[float, float] = (0.1, 0.04)  # free height on a shelf, in a drawer, below which it does not
    ledge: float = 0.03  # share of the largest surface of a thing below which another one holds nothing
    simple: float = 0.004  # metres by which a surface's outline may be straightened
    oval: float = 0.012  # share of its area by which an oval may differ from an ellipse: its sides are straight
    inscribed: float = 0.68  # share of an oval's sides that a rectangle in it has: sqrt(1/2), less its straight edges
    corners: int = 10  # coordinates of corners between which the largest rectangle of a region is looked for
    evenly: int = 8  # even steps between which it is looked for in a region with more coordinates than a slanted one
    square: int = 2  # coordinates along an axis of the corners of an upright rectangle
    slim: float = 0.04  # hooks are longer than that, and no wider
    held: float = 0.035  # how far from the end of a hook hangs what it holds
    rim: float = 0.8  # share of its height below which an open surface lies in a thing
    ease: float = 0.005  # metres of height that a thing needs more than its own to be put into a shelf
    apart: float = 0.02  # metres between things that stand side by side on a shelf
    longer: float = 0.05  # steps in metres by which shelves are made longer for what is to stand on them
    deepens: float = 0.35  # metres by which shelves are made deeper at the most for what is to stand on them
    full: float = 1.5  # share of a top that things take for which it is made larger: some reach over its edge
    times: float = 3.0  # times its width that such a top has at the most
    even: float = 1.3  # times its shorter side that the longer one of what is not made wider has at the most


SURFACES = SurfaceConfig()

Size = tuple[float, float, float]
"""Depth, width and height in metres."""

PLAN = [0, 2, 1, 3]  # columns of a span that are its rectangle in plan: least x and y, greatest x and y
SOFT = ("seat", "cushion", "mattress", "duvet", "quilt", "blanket", "bed")
"""Words in names of parts that people sit or lie on."""
HOOKS = ("hook", "peg")  # names of parts that things hang from
COUNTED = ("shelf", "drawer")  # words that a number follows, however few there are


@dataclass(frozen=True)
class Surface:
    """A level place of a thing that can hold others."""

    name: str  # "top", "seat", "shelf 2", "step 1"; unique within the thing
    # its outline in plan, in the frame of the thing (origin in the middle of its box, front along +x), metres
    region: Polygon
    height: float  # metres above the bottom of the thing
    free: float  # metres of free height above it; infinite where nothing covers it
    # which way a hook points from what holds it, a unit vector in plan; (0, 0) for what no hook is
    out: tuple[float, float] = (0.0, 0.0)

    @property
    def is_hook(self) -> bool:
        """Whether things hang from it."""
        return self.out != (0.0, 0.0)

    @property
    def covered(self) -> bool:
        """Whether the thing itself covers it: what lies there is in the thing."""
        return np.isfinite(self.free)

    @cached_property
    def rectangle(self) -> tuple[float, float, float, float]:
        """The largest upright rectangle in it: least x and y, greatest x and y in metres."""
        return _inscribed(self.region) if self.is_oval else _largest_rectangle(self.region)

    @cached_property
    def is_oval(self) -> bool:
        """Whether it is a disc or an ellipse, along the axes of its thing."""
        x0, y0, x1, y1 = self.region.bounds
        disc = Point(0.0, 0.0).buffer(1.0)
        oval = shapely.transform(disc, lambda at: at * [(x1 - x0) / 2, (y1 - y0) / 2] + [(x0 + x1) / 2, (y0 + y1) / 2])
        near = oval.symmetric_difference(self.region).area < SURFACES.oval * oval.area
        return near and self.region.covers(shapely.box(*_inscribed(self.region)))

    @property
    def box(self) -> tuple[float, float, float, float]:
        """Where things may stand: the largest rectangle, the whole of an oval; least x and y, greatest x and y in metres."""
        return self.region.bounds if self.is_oval else self.rectangle

    @property
    def radius(self) -> float:
        """The radius in metres of a disc about the middle of its thing; 0 of what is none."""
        x0, y0, x1, y1 = self.region.bounds
        round_it = max(abs(x0 + x1), abs(y0 + y1), abs(x1 - y1)) < SURFACES.simple
        return (x1 - x0) / 2 if self.is_oval and round_it else 0.0

    @property
    def is_seat(self) -> bool:
        """Whether people sit or lie on it."""
        return self.name.startswith("seat")

    @property
    def is_wide(self) -> bool:
        """Whether something that is no thread lies on it."""
        x0, y0, x1, y1 = self.rectangle
        return min(x1 - x0, y1 - y0) >= SURFACES.least_side / 2

    def holds(self, size: Size) -> bool:
        """Return whether a thing of that depth, width and height lies wholly on it, one way round or the other."""
        x0, y0, x1, y1 = self.rectangle
        small, large = sorted(size[:2])
        least, most = sorted((x1 - x0, y1 - y0))
        fits = small <= least + SURFACES.simple and large <= most + SURFACES.simple
        return fits and size[2] + SURFACES.ease <= self.free


@lru_cache(maxsize=1024)
def surfaces_of(asset: Asset) -> tuple[Surface, ...]:
    """Return the surfaces of a thing, the lowest first; its box's top where it cannot be drawn."""
    from robolayout.assets.meshes import parts

    try:
        made = parts(asset)
    except AssetError:
        return (_box_top(asset),)
    level = asset.size[2] / 2
    tops = [(z + level, area, part.name) for part in made for z, area in level_tops(part, SURFACES.level)]
    spans = piece_spans(asset)
    found = [piece for group in _levels(sorted(tops, key=lambda top: top[0])) for piece in _pieces(group, spans)]
    least = SURFACES.ledge * max((surface.region.area for surface, _ in found), default=0.0)
    wide = tuple(_named(item for item in found if item[0].region.area >= least and item[0].is_wide))
    return (*wide, *_hooks(made, level))


def _box_top(asset: Asset) -> Surface:
    depth, width, height = asset.size
    return Surface("top", shapely.box(-depth / 2, -width / 2, depth / 2, width / 2), height, np.inf)


def outer_surfaces(asset: Asset) -> tuple[Surface, ...]:
    """Return what lies open on a thing, seats where it has them; all surfaces of a thing that covers them all."""
    every = tuple(s for s in surfaces_of(asset) if not s.is_hook)
    return tuple(s for s in every if s.is_seat) or tuple(s for s in every if not s.covered) or every


@cache
def _goods() -> Mapping[str, tuple[str, ...]]:
    """Return the parts of things of a kind that are drawn for what they hold."""
    data = read_data("dressing.toml")
    rules = [(name, rule["clears"]) for rule in data["rule"] if "clears" in rule for name in rule["on"]]
    return {name: tuple(parts) for name, parts in (*rules, *data["goods"].items())}


def emptied(asset: Asset, sizes: Sequence[Size], *, shelves: bool = False) -> Asset:
    """Return a thing on which, or on whose `shelves`, things of some sizes are to lie: without what is drawn in their way."""
    goods = _goods().get(category_of(asset).name, ())
    if not goods or not sizes:
        return asset
    bare = replace(asset, without=(*asset.without, *goods))
    if shelves and open_shelves(bare):
        return bare
    firm = {round(surface.height, 3) for surface in outer_surfaces(bare)}
    free = [surface for surface in outer_surfaces(asset) if round(surface.height, 3) in firm]  # no top of what is drawn
    return asset if all(any(surface.holds(size) for surface in free) for size in sizes) else bare


def inner_surfaces(asset: Asset) -> tuple[Surface, ...]:
    """Return what lies in a thing: its shelves, else its drawers, else the floor of a box or a basket below its rim."""
    every = tuple(s for s in surfaces_of(asset) if not s.is_hook)
    inside = [s for s in every if s.covered]
    shelves = [s for s in inside if not s.name.startswith("drawer")]
    return tuple(shelves or inside or [s for s in every if s.height < SURFACES.rim * asset.size[2]])


def open_shelves(asset: Asset) -> tuple[Surface, ...]:
    """Return the shelves of a thing that nothing has to be opened for."""
    from robolayout.assets.joints import sweeps_of

    if any(surface.is_seat for surface in surfaces_of(asset)) or any(one.joint is not None for one in sweeps_of(asset)):
        return ()
    return tuple(surface for surface in inner_surfaces(asset) if surface.name.startswith("shelf"))


def bearing(asset: Asset, sizes: Sequence[Size], *, shelves: bool) -> Size:
    """Return the size of a thing with `shelves` as deep and long, or a top as wide, as it takes for things of some sizes to stand there.

    Seats, what is about as deep as wide and what would have to be far wider stay as they are.
    """
    (depth, width, height), tops = asset.size, outer_surfaces(asset)
    found = open_shelves(asset) if shelves else ()
    free = max((shelf.free for shelf in found), default=0.0) - SURFACES.ease
    if all(size[2] <= free for size in sizes) and (more := _longer(found, width, sizes)) is not None:
        return round(depth + more[0], 3), round(width + more[1], 3), height
    if not tops:  # a board with hooks
        return asset.size
    x0, y0, x1, y1 = max(tops, key=lambda surface: surface.region.area).rectangle
    sides = [sorted(side + SURFACES.apart for side in size[:2]) for size in sizes]
    taken = sum(map(math.prod, sides)) / ((x1 - x0) * (y1 - y0))
    times = sum(long / max(int((x1 - x0) / short), 1) for short, long in sides) / (y1 - y0)
    # on a board nothing stands behind another
    in_line = not found and len(sizes) > 1 and all(short * 2 > x1 - x0 for short, _ in sides)
    crowded = (taken > SURFACES.full or in_line) and width > SURFACES.even * depth and not tops[0].is_seat
    return (depth, round(width * times, 3), height) if crowded and 1.0 < times <= SURFACES.times else asset.size


def _longer(shelves: Sequence[Surface], width: float, sizes: Sequence[Size]) -> tuple[float, float] | None:
    """Return by how many metres the shelves of a thing so wide must be deeper and longer to hold some sizes; None for too many."""
    x0, _, x1, _ = max(shelves, key=lambda surface: surface.region.area).rectangle
    lacks = max(max(deep for deep, *_ in sizes) + SURFACES.apart - (x1 - x0), 0.0)
    for step in range(int((SURFACES.times - 1.0) * width / SURFACES.longer) + 1):
        more = (lacks, step * SURFACES.longer)
        if hold_all(shelves, sizes, more):
            return more if lacks <= SURFACES.deepens else None
    return None


def hold_all(shelves: Sequence[Surface], sizes: Iterable[Size], more: tuple[float, float] = (0.0, 0.0)) -> bool:
    """Return whether things of some sizes all stand on some shelves, or on shelves that are so much larger."""
    many = [sum(slots(shelf, size, more) for shelf in shelves) for size in sizes]
    return all(many) and sum(Fraction(1, one) for one in many) <= 1


def slots(surface: Surface, size: Size, more: tuple[float, float] = (0.0, 0.0)) -> int:
    """Return how many things of a size stand straight on a surface, side by side and behind each other; on one that is so much larger."""
    x0, y0, x1, y1 = surface.rectangle
    sides = zip((x1 - x0 + more[0], y1 - y0 + more[1]), size, strict=False)
    deep, wide = (int((side + SURFACES.apart) / (own + SURFACES.apart) + SURFACES.simple) for side, own in sides)
    return deep * wide * (size[2] + SURFACES.ease <= surface.free)


def named_surfaces(asset: Asset, name: str) -> tuple[Surface, ...]:
    """Return the surfaces of a name ("shelf 2"), of a kind ("shelf") or of a number from below ("1")."""
    return tuple(s for i, s in enumerate(surfaces_of(asset)) if name in (s.name, s.name.split()[0], str(i + 1)))


@lru_cache(maxsize=4096)
def resting_place(lower: Asset, upper: Asset, among: tuple[Surface, ...] | None = None) -> Surface:
    """Return the surface of `lower` (of those `among` that are meant; None: of what lies open) on which `upper` stands.

    It is the highest that can hold it, a seat before arms and back, or a large place over which it then reaches, or the box's top.
    """
    hooks = [s for s in among or surfaces_of(lower) if s.is_hook]
    if hooks and category_of(upper).hangs:
        return hung_from(hooks[0], upper)
    meant = outer_surfaces(lower) if among is None else among
    fit = [s for s in meant if s.holds(upper.size)]
    high = [s for s in meant if upper.size[2] + SURFACES.ease <= s.free]
    widest = max((s.region.area for s in high), default=0.0)
    broad = [s for s in high if s.region.area >= widest / 2]
    return max(fit or broad or [_box_top(lower)], key=lambda s: s.height)


def hung_from(hook: Surface, thing: Asset) -> Surface:
    """Return where the middle of a thing's bottom is that hangs from a hook, as a surface; other surfaces are as they are."""
    drop = category_of(thing).hangs
    if not (hook.is_hook and drop):
        return hook
    (x, y), (u, v) = hook.region.centroid.coords[0], hook.out
    points = shapely.get_coordinates(hook.region) @ hook.out
    far = max(points.min() + thing.size[0] / 2 + SURFACES.ease / 2, points.max() - SURFACES.held) - (x * u + y * v)
    spot = shapely.Point(x + far * u, y + far * v).buffer(SURFACES.ease)
    return replace(hook, region=spot, height=hook.height - thing.size[2] + drop)


def _hooks(made: tuple[Part, ...], level: float) -> Iterator[Surface]:
    """Yield the hooks of a thing: slim bars that stick out of something."""
    bars = [part for part in made if part.name in HOOKS]
    boxes = [(low, high) for part in made if part.name not in HOOKS for low, high in [part.ends]]
    number = count(1)
    for bar in bars:
        low, high = bar.ends
        middle = (low + high) / 2
        near = [np.clip(middle, a, b) for a, b in boxes if (np.maximum(a - high, low - b) < SURFACES.ease).all()]
        ways = [way[:2] / np.linalg.norm(way[:2]) for way in middle - near if np.linalg.norm(way[:2]) > SURFACES.ease]
        sides = sorted((high - low)[:2])
        if ways and sides[0] <= SURFACES.slim <= sides[1]:
            u, v = ways[0].tolist()
            yield Surface(
                f"hook {next(number)}", shapely.box(*low[:2], *high[:2]), float(high[2]) + level, np.inf, (u, v)
            )


def _levels(tops: list[tuple[float, Any, str]]) -> Iterator[list[tuple[float, Any, str]]]:
    """Yield tops of one height together; those that hold nothing by themselves may do so together."""
    while tops:
        end = sum(top[0] - tops[0][0] <= SURFACES.level for top in tops)
        yield tops[:end]
        tops = tops[end:]


def _pieces(group: list[tuple[float, Any, str]], spans: NDArray[np.float64]) -> Iterator[tuple[Surface, str]]:
    """Yield what is left of the tops at one height, open and covered, with the name of the part that gives most of it."""
    areas = np.array([area for _, area, _ in group])
    if shapely.area(areas).sum() < SURFACES.least_area:
        return
    height = group[-1][0]

    def own(piece: Polygon) -> tuple[float, str]:
        given = np.round(shapely.area(shapely.intersection(areas, piece)), 4).tolist()
        most = max(zip(given, group, strict=True), key=lambda item: (item[0], item[1][0]))
        least = min(SURFACES.least_area / 10, most[0])
        return max(top[0] for area, top in zip(given, group, strict=True) if area >= least), most[1][2]

    whole = _swelled(shapely.union_all(areas), SURFACES.seam / 2)
    over = (spans[:, 5] > height + SURFACES.level) & (spans[:, 0] < whole.bounds[2]) & (spans[:, 1] > whole.bounds[0])
    rising = over & (spans[:, 4] < height + SURFACES.rises)
    clear = whole.difference(_boxes(spans[rising]))
    above = spans[over & ~rising]
    cover = _boxes(above)
    for piece in _worth(clear.difference(cover)):
        level, word = own(piece)
        yield Surface("", piece, level, np.inf), word
    for piece in _worth(clear.intersection(cover)):
        level, word = own(piece)
        met = shapely.area(shapely.intersection(shapely.box(*above[:, PLAN].T), piece))
        free = float(above[met > SURFACES.least_area / 10, 4].min(initial=np.inf)) - level
        if free >= SURFACES.least_free[word == TRAY] and piece.area >= SURFACES.least_shelf:
            yield Surface("", piece, level, free), word


def _boxes(spans: NDArray[np.float64]) -> Any:
    """Return what parts cover in plan, by the rectangles around them."""
    return shapely.union_all(shapely.box(*spans[:, PLAN].T)) if len(spans) else Polygon()


def _swelled(region: Any, metres: float) -> Any:
    """Return a region made larger and then smaller again, which fills gaps; with metres below 0 that drops what is thin."""
    return region.buffer(metres, join_style="mitre").buffer(-metres, join_style="mitre")


def _worth(region: Any) -> Iterator[Polygon]:
    """Yield the pieces of a region that can hold something."""
    opened = _swelled(region, -SURFACES.least_side / 2)
    for piece in shapely.get_parts(opened.simplify(SURFACES.simple)):
        if piece.geom_type == "Polygon" and piece.area >= SURFACES.least_area:
            yield piece


def _named(found: Iterable[tuple[Surface, str]]) -> Iterator[Surface]:
    """Yield surfaces with names, by the part that gives most of each: shelves and steps are counted from below."""
    ordered = sorted(found, key=lambda item: (item[0].height, item[0].region.centroid.coords[0]))
    highest, words = max((s.height for s, _ in ordered if not s.covered), default=0.0), list[str]()
    for surface, part in ordered:
        is_soft = "back" not in part and any(soft in part for soft in SOFT)
        word = "seat" if is_soft else "top" if surface.height == highest else "step"
        words.append("drawer" if part == TRAY else "shelf" if surface.covered else word)
    for i, (surface, _) in enumerate(ordered):
        alone = words.count(words[i]) == 1 and words[i] not in COUNTED
        yield replace(surface, name=words[i] if alone else f"{words[i]} {words[: i + 1].count(words[i])}")


def _largest_rectangle(region: Polygon) -> tuple[float, float, float, float]:
    """Return the largest upright rectangle between coordinates of the corners of a polygon that lies in it."""
    points = shapely.get_coordinates(region)
    xs, ys = (_thinned(points[:, i]) for i in (0, 1))
    cells = shapely.box(*np.array([(a, c, b, d) for (a, b), (c, d) in product(pairwise(xs), pairwise(ys))]).T)
    shapely.prepare(region)
    grown = region.buffer(SURFACES.simple / 2)
    inside = shapely.covers(grown, cells).reshape(len(xs) - 1, len(ys) - 1)
    i, j, k, m = largest_block(inside, np.outer(np.diff(xs), np.diff(ys)))
    return xs[i], ys[k], xs[j], ys[m]


def _inscribed(oval: Polygon) -> tuple[float, float, float, float]:
    """Return the largest upright rectangle in an oval."""
    x0, y0, x1, y1 = oval.bounds
    dx, dy = ((1.0 - SURFACES.inscribed) / 2 * side for side in (x1 - x0, y1 - y0))
    return x0 + dx, y0 + dy, x1 - dx, y1 - dy


def _thinned(values: NDArray[np.float64]) -> list[float]:
    """Return coordinates in order: some of the corners', and some evenly between their ends."""
    distinct = np.unique(np.round(values, 6))
    kept = np.linspace(0, len(distinct) - 1, min(len(distinct), SURFACES.corners)).round().astype(int)
    steps = SURFACES.evenly if len(distinct) > SURFACES.square else 0
    between = np.linspace(distinct[0], distinct[-1], steps)
    return np.unique(np.concatenate([distinct[kept], between])).tolist()
