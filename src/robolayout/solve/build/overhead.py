"""Things off the floor: on walls and under the ceiling."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import groupby

import numpy as np
import shapely

from robolayout.assets.obstacles import only_seen, use_sides
from robolayout.floor import rect_points
from robolayout.scene import Agent, Opening, Point, Wall
from robolayout.scene.agent import horizontal_reach
from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.form import corners_of
from robolayout.solve.build.member import Member
from robolayout.solve.build.places import WALL_GAP, targets, wall_yaw
from robolayout.solve.build.site import AT_WALL, Site, Spot
from robolayout.solve.build.taste import wished
from robolayout.solve.build.wants import Want


@dataclass(frozen=True)
class Hanging:
    """Where things hang, and what a place to hang costs."""

    eye: float = 1.5  # metres at which the middle of a picture hangs
    aside: tuple[float, float, float, float, float] = (0.0, 0.5, -0.5, 1.0, -1.0)
    """Metres by which a ceiling thing moves aside for another."""
    clear_above: float = 0.12  # metres between a piece of furniture and what hangs over it
    work_above: float = 0.2
    """Metres between a top to work at and what is opened over it at the least; 0.5 is usual where everybody reaches that."""
    covered: float = 80.0
    """Cost of hanging where another thing already is; more than of all that a body may miss together."""
    out_of_reach: float = 10.0
    """Cost of hanging what is used higher than the shortest arm gets, or where a door or drawer opens."""
    raised: float = 0.4  # metres above its usual height from which on a thing hangs out of place: a basin over a bed
    step: float = 0.15  # metres between places along a wall
    between: float = 0.5  # metres between what stands before one hung thing and before the next
    apart: float = 0.01  # metres that a hung thing keeps from what stands or hangs beside it at the least
    crowded: float = 8.0  # cost of hanging where all of the floor that it is used from is taken
    juts_out: float = 12.0  # cost of hanging in the way of a body
    thin: float = 0.1  # metres that a thing may stand out from its wall without being in the way
    centred: float = 0.03  # metres off the middle of what it belongs over
    # cost of a metre that a row hangs beside the middle of what it is over, or the upper of two rows beside the lower
    shifted: float = 12.0
    dressing: float = 8.0  # what it is worth that a curtain or blind hangs before the middle of a window
    take_hold: float = 0.05  # metres that a thing begins below the top of the reach


HANGING = Hanging()


def hang(site: Site, names: Sequence[str], rng: np.random.Generator) -> None:
    """Hang things of a kind where a wall is free: over what they belong to, else where there is most room around them.

    Several that are asked over one thing hang in a row over its middle. Mirrors before which a row of chairs is to stand hang in
    a row, where a wall is long enough for it.
    """
    over: dict[str, list[str]] = {}
    for name in names:
        for below in asked_below(site, name)[:1]:
            over.setdefault(below, []).append(name)
    hung = {name for below, row in over.items() if _hang_over(site, below, row) for name in row}
    rest = [name for name in names if name not in hung]
    if not (_hang_lined(site, rest) or _hang_before(site, rest)):
        for name in rest:
            _hang(site, name, rng)


def asked_below(site: Site, name: str) -> Sequence[str]:
    """Return over what a thing is asked to hang."""
    return site.said.above.get(name, ())


def _tier_below(site: Site, name: str) -> list[Member]:
    """Return what a thing is asked to hang above and hangs itself: the lower row of pictures."""
    below = (site.spots[other] for other in asked_below(site, name) if other in site.spots)
    return [spot.member for spot in below if spot.mode == "hang"]


def _hang_over(site: Site, below: str, names: Sequence[str]) -> bool:
    """Hang things in a row over one that stands at a wall; False where it does not, or is too narrow for them."""
    spans = [one for one in site.spans if one.name == below and one.depth <= AT_WALL]
    span = max(spans, key=lambda one: one.rect[2] - one.rect[0], default=None)  # in a corner the wall along which it is
    if span is None or len(names) < 2:
        return False
    wide, long = max(site.size(name)[1] for name in names), span.rect[2] - span.rect[0]
    pitch = min(max(wide + HANGING.apart, long / len(names)), long / (len(names) - 1), wide + HANGING.between)
    slack = (long - pitch * (len(names) - 1)) / 2
    shifts = sorted((0.0, *np.arange(-slack, slack, HANGING.step)), key=abs)
    middle = (span.rect[0] + span.rect[2]) / 2
    places = [(site.room.walls[span.wall], middle + shift, HANGING.shifted * abs(shift)) for shift in shifts]
    return pitch > wide and _hang_row(site, names, pitch, places)


def _hang_lined(site: Site, names: Sequence[str]) -> bool:
    """Hang things in the one row that is demanded of them, so far apart, at one height; False where none is or no wall has room for it."""
    row = site.wants[names[0]].rows if len(names) > 1 else None
    if row is None or row.rows != 1 or {*row.asset_names()} != {*names}:
        return False
    wide = max(site.size(name)[1] for name in names)
    first = (wide + row.gap) * (1 - len(names)) / 2
    half = wide / 2 - first + WALL_GAP
    places = list[tuple[Wall, float, float]]()
    for wall in site.room.walls:
        for t in {wall.length / 2, *np.arange(half, wall.length - half, HANGING.step).tolist()}:
            pose = (*wall.point(t + first, site.size(names[0])[0] / 2 + WALL_GAP / 2), wall_yaw(wall))
            missed = float(site.missed([Member(names[0])], np.array([pose]))[0])
            places += [(wall, t, missed)] * (half <= t <= wall.length - half)
    if not _hang_row(site, names, wide + row.gap, places):
        return False
    top = max(site.spots[name].member.bottom for name in names)
    for name in names:
        spot = site.spots[name]
        site.spots[name] = replace(spot, member=replace(spot.member, bottom=top))
    return True


def _hang_before(site: Site, names: Sequence[str]) -> bool:
    """Hang like things as far apart as what is demanded to stand before each needs; False where that is nothing or there is no wall."""
    before = [_standing_before(site, name) for name in names]
    if len(names) < 2 or not all(len(wants) == 1 for wants in before):
        return False
    wide = max(site.size(want.name)[1] for (want,) in before) + HANGING.between
    clusters, half = [site.clusters.build(want.name) for (want,) in before], wide * len(names) / 2
    places = [(wall, t, 0.0) for wall in site.room.walls for t in np.arange(half, wall.length - half, HANGING.step)]
    return _hang_row(site, names, wide, places, clusters)


def _hang_row(
    site: Site,
    names: Sequence[str],
    pitch: float,
    places: Sequence[tuple[Wall, float, float]],
    before: Sequence[Cluster] = (),
) -> bool:
    """Hang things so far apart around the best of some places, by what stands before each; False where all are taken."""
    along = [pitch * (i - (len(names) - 1) / 2) for i in range(len(names))]
    best, row = HANGING.crowded if before else HANGING.covered, list[Spot]()
    for wall, t, aside in places:
        found = [_hang_cost(site, name, wall, t + off) for name, off in zip(names, along, strict=True)]
        cost = aside + sum(cost for cost, _ in found) / len(names)
        cost += sum(map(partial(_clash_before, site), before, (spot for _, spot in found)))
        if cost < best:
            best, row = cost, [spot for _, spot in found]
    for name, spot in zip(names, row, strict=False):
        site.settle(name, spot)
    return bool(row)


def _standing_before(site: Site, name: str) -> list[Want]:
    """Return what is demanded to stand at a hung thing: the chair of a mirror."""
    return [want for want in site.wants.values() if want.standing and name in want.at]


def _clash_before(site: Site, cluster: Cluster, spot: Spot) -> float:
    """Return the cost of the place of what stands before a hung thing."""
    face, at = site.wants[cluster.anchor].face, spot.member
    low, high = face.distance if face else (0.0, 0.0)
    before = Member(cluster.anchor, (low + high) / 2, yaw=math.pi).moved(at.x, at.y, at.yaw)
    return float(site.clash(cluster, np.array([(before.x, before.y, before.yaw)]))[0])


def _hang(site: Site, name: str, rng: np.random.Generator) -> None:
    """Hang a thing where a wall is free: over what it belongs to, else where there is most room around it."""
    places = [_hang_cost(site, name, wall, t) for wall in site.room.walls for t in _hang_offsets(site, name, wall)]
    if not places:
        return
    costs, spots = np.array([cost for cost, _ in places]), [spot for _, spot in places]
    poses = np.array([(spot.member.x, spot.member.y, spot.member.yaw) for spot in spots])
    openings = [site.room.walls[o.wall].point(o.center) for o in (*site.room.doors, *site.room.windows)]
    for _, stretch in groupby(range(len(spots)), key=lambda i: _stretch(spots[i].member, openings)):
        mine = [*stretch]  # the rows of what is said are those of one stretch of wall
        costs[mine] += site.missed([Member(name)], poses[mine])
    costs += wished(site, name, poses[:, :2], site.wants[name].weights)
    for one in _tier_below(site, name):
        costs += HANGING.shifted * np.hypot(*(poses[:, :2] - (one.x, one.y)).T)
    spot = spots[int(np.argmin(costs + 0.2 * rng.random(len(spots))))]
    site.settle(name, spot)
    if site.standings and _juts_out(site, spot.member) > 0:
        site.floor.take(site.floor.shadow(corners_of(spot.member, site.size(name))))
        site.survey()


def _stretch(member: Member, openings: Sequence[Point]) -> tuple[float, float, tuple[bool, ...]]:
    """Return what tells the stretches of walls apart: heading, height, and the side of each opening on which it is."""
    c, s = math.cos(member.yaw), math.sin(member.yaw)
    return member.yaw, member.bottom, tuple(c * (y - member.y) > s * (x - member.x) for x, y in openings)


def _hang_offsets(site: Site, name: str, wall: Wall) -> list[float]:
    width = site.size(name)[1]
    low, high = width / 2 + WALL_GAP - 1e-6, wall.length - width / 2 - WALL_GAP + 1e-6
    marks = [wall.length / 2, *np.arange(low + 0.04, high, HANGING.step)]
    marks += [(span.rect[0] + span.rect[2]) / 2 for span in site.spans if span.wall == wall.index]
    if site.wants[name].height > 0.0:  # as "a clock above the door"
        marks += [opening.center for opening in (*site.room.doors, *site.room.windows) if opening.wall == wall.index]
    marks += [window.center for window in _dressed(site, name, wall)]
    marks += [wall.place((one.x, one.y))[0] for one in _tier_below(site, name)]
    return sorted({round(float(t), 3) for t in marks if low <= t <= high})


def _dressed(site: Site, name: str, wall: Wall) -> list[Opening]:
    """Return the windows of a wall before which a thing may hang and nothing of its kind does yet."""
    category = site.wants[name].category
    if not category.dresses_windows:
        return []
    hung = [s.member for n, s in site.spots.items() if site.wants[n].category.dresses_windows]
    windows = [window for window in site.room.windows if window.wall == wall.index]
    return [one for one in windows if all(math.dist(wall.point(one.center), (m.x, m.y)) > one.width / 2 for m in hung)]


def _reach_top(site: Site, ahead: float) -> float:
    """Return the highest lower edge, in metres, of what every agent with an arm can take hold of over what juts out below."""
    highest = (_highest(a, ahead) for a in site.scene.agents if a.reach_distance is not None)
    return min(highest, default=9.0) - HANGING.take_hold


def _highest(agent: Agent, ahead: float) -> float:
    """Return how high in metres a body's hand gets that far beyond its footprint; the top of its reach where nowhere."""
    heights = np.arange(agent.reach_high, agent.reach_low, -HANGING.take_hold / 2).tolist()
    far = ((height, horizontal_reach(agent, height, height)) for height in heights)
    return next((height for height, reach in far if reach and reach >= ahead + agent.inradius), agent.reach_high)


def _hang_cost(site: Site, name: str, wall: Wall, t: float) -> tuple[float, Spot]:
    want, (depth, width, height) = site.wants[name], site.size(name)
    owner, bonus, lift, ahead = _below(site, name, wall, t)
    window = next((one for one in _dressed(site, name, wall) if abs(one.center - t) < HANGING.centred), None)
    used = bool(use_sides(site.scene.by_name[name]))
    clear = HANGING.work_above if used and ahead > 0 else HANGING.clear_above
    above = clear * (lift > 0) + height / 2
    middle = max(want.height or max(HANGING.eye, 0.4 + height / 2), lift + above)
    if window is not None:
        bonus, middle = HANGING.dressing, window.sill + window.height + HANGING.clear_above - height / 2
    top = _reach_top(site, ahead)
    if used:
        middle = min(middle, top + height / 2)
    middle = min(max(middle, lift + above), site.room.wall_height - height / 2 - 0.03)
    takers = site.wall_takers(wall, math.inf if owner is None else depth)
    takers = [taker for taker in takers if window is None or taker[1] != "window"]
    rect = (t - width / 2, middle - height / 2, t + width / 2, middle + height / 2)
    yaw = wall_yaw(wall)
    member = Member(name, *wall.point(t, depth / 2 + WALL_GAP / 2), yaw, middle - height / 2)
    covered = site.wall_conflict(rect, takers, HANGING.apart)
    cost = HANGING.covered * (covered > 0.0) + 20.0 * covered
    cost += HANGING.out_of_reach * (used and middle - height / 2 > top + HANGING.take_hold)
    out_of_place = owner is None and 0.0 < want.height < middle - HANGING.raised
    cost += HANGING.covered * (out_of_place and not asked_below(site, name))
    cost += 1.2 * site.wall_conflict((rect[0] - 0.4, rect[1], rect[2] + 0.4, rect[3]), takers)
    cost += 0.8 * abs(t - wall.length / 2) / wall.length * (1 + want.weights.get("mid_wall", 0.0)) - bonus
    cost += max(want.walls.values(), default=0.0) - want.walls.get(wall.index, 0.0)
    if member.bottom < 2.0 and _in_landing(site, member):
        cost += 30.0
    cost += HANGING.juts_out * _juts_out(site, member)
    cost += HANGING.out_of_reach * bool(shapely.intersects(site.outline(member), site.openings).any())
    cost += _crowding(site, name, member) + _sight(site, name, member) + _far(site, name, member)
    cost += HANGING.crowded * _used_room(site, name, member)
    return cost, Spot(member, "hang", wall.index, owner)


def _below(site: Site, name: str, wall: Wall, t: float) -> tuple[str | None, float, float, float]:
    """Return what stands below that place and the thing belongs over, what that is worth, its height, and how far it juts out.

    What is yet to come below it has its height, too.
    """
    over, (depth, width, _) = site.wants[name].over, site.size(name)
    here = [s for s in site.spans if s.wall == wall.index and site.spots[s.name].mode != "hang"]
    close = [s for s in here if s.depth <= 0.15 and s.rect[0] < t + width / 2 and s.rect[2] > t - width / 2]
    low = [s for s in close if s.rect[3] < 1.6]
    top = max((s.rect[3] for s in low), default=0.0)
    ahead = max((s.depth + site.size(s.name)[0] - depth for s in low), default=0.0)
    hung_over = {s.anchor for s in site.spots.values() if s.mode == "hang"}
    for span in here:
        centred = abs((span.rect[0] + span.rect[2]) / 2 - t) < HANGING.centred
        if span.name in over and centred and site.spots[span.name].wall == wall.index and span.name not in hung_over:
            return span.name, 6.0 - over.index(span.name), max(top, span.rect[3]), ahead
    under = asked_below(site, name)
    coming = [site.size(other)[2] for other in under if other not in site.spots and site.wants[other].standing]
    tier = (one.bottom + site.size(one.name)[2] for one in _tier_below(site, name))
    return None, 0.0, max(top, *coming[:1], *tier, 0.0), ahead


def _used_room(site: Site, name: str, member: Member) -> float:
    """Return the share of the floor before a hung thing, as deep as its role wants it clear, that is taken."""
    ahead, (depth, width, _) = site.wants[name].clear.get("front", 0.0), site.size(name)
    if not ahead:
        return 0.0
    points = rect_points((depth / 2, -width / 2, depth / 2 + ahead, width / 2), 0.0)
    pose = np.array([[member.x, member.y, member.yaw]])
    return float(site.floor.maps().taken[site.floor.under(points, pose)].mean())


def _crowding(site: Site, name: str, member: Member) -> float:
    """Return a cost for hanging close to others of its kind, so that pictures spread, and each mirror has room for its chair."""
    same = [s.member for n, s in site.spots.items() if site.wants[n].kind == site.wants[name].kind and s.mode == "hang"]
    away = [math.hypot(m.x - member.x, m.y - member.y) for m in same]
    if not away:
        return 0.0
    before = [site.size(want.name)[1] for want in _standing_before(site, name)]
    if before:
        return HANGING.crowded * sum(max(0.0, max(before) + HANGING.between - far) for far in away)
    if asked_below(site, name) or any(weight > 0 for _, weight in site.wants[name].near):
        return 0.0
    return sum(max(0.0, 2.0 - far) for far in away)


def _in_landing(site: Site, member: Member) -> bool:
    outline = site.outline(member)
    return any(shapely.Polygon(site.room.landing(door)).intersects(outline) for door in site.room.doors)


def _juts_out(site: Site, member: Member) -> float:
    """Return the share of a hung thing that is in the way of a body over free floor; what is thin is not."""
    depth, width, _ = site.size(member.name)
    if depth <= HANGING.thin or member.bottom >= max(agent.height for agent in site.scene.agents):
        return 0.0
    points = rect_points((-depth / 2, -width / 2, depth / 2, width / 2), 0.02)
    pose = np.array([[member.x, member.y, member.yaw]])
    return 1.0 - float(site.floor.maps().taken[site.floor.under(points, pose)].mean())


def _far(site: Site, name: str, member: Member) -> float:
    """Return a cost for hanging where some agent cannot reach or use it; nothing while the floor is still empty."""
    if not site.standings or only_seen(site.scene.by_name[name]):
        return 0.0
    return 10.0 * (not site.serves(site.claim(Spot(member, "hang"))))


def _sight(site: Site, name: str, member: Member) -> float:
    """Return a cost for not being in front of what it serves (a screen before its sofa)."""
    face = site.wants[name].face
    costs = [0.0]
    for other in targets(site, name) if face else ():
        target = site.spots[other].member
        dx, dy = member.x - target.x, member.y - target.y
        away = max(math.hypot(dx, dy), 1e-6)
        seen = (dx * math.cos(target.yaw) + dy * math.sin(target.yaw)) / away
        costs.append((face.weight if face else 0.0) * (1 - seen))
    return max(costs)


def overhead(site: Site, names: Sequence[str]) -> None:
    """Hang ceiling things: one over each thing they belong to, the rest evenly over the room."""
    free: list[str] = []
    owned: dict[str, list[str]] = {}
    for name in names:
        owners = [n for n in site.wants[name].over if n in site.spots]
        if owners:
            owned.setdefault(min(owners, key=lambda n: (len(owned.get(n, ())), owners.index(n))), []).append(name)
        else:
            free.append(name)
    for owner, lamps in owned.items():
        _over(site, owner, lamps)
    for name, point in zip(free, _spread(site, len(free)), strict=True):
        _hang_from_ceiling(site, name, point, 0.0, None)


def _over(site: Site, owner: str, lamps: Sequence[str]) -> None:
    """Hang lamps over a thing: one over its middle, several along it."""
    there, (depth, width, _) = site.spots[owner].member, site.size(owner)
    for i, name in enumerate(lamps):
        turned = site.size(name)[1] > site.size(name)[0] and depth > width
        along = (2 * (i + 0.5) / len(lamps) - 1) * max(depth, width) / 2
        spot = Member(name, *((along, 0.0) if depth > width else (0.0, along)), math.pi / 2 if turned else 0.0)
        world = spot.moved(there.x, there.y, there.yaw)
        _hang_from_ceiling(site, name, (world.x, world.y), world.yaw, owner if len(lamps) == 1 else None)


def _hang_from_ceiling(site: Site, name: str, point: tuple[float, float], yaw: float, owner: str | None) -> None:
    bottom = site.room.wall_height - site.size(name)[2]
    apart = [point, *((point[0] + dx, point[1] + dy) for dx in HANGING.aside for dy in HANGING.aside)]
    if owner is None:
        point = next((p for p in apart if _is_free_above(site, name, p)), point)
    site.settle(name, Spot(Member(name, *point, yaw, bottom), "ceiling"))


def _spread(site: Site, count: int) -> list[tuple[float, float]]:
    """Return points that share the floor evenly, by a few rounds of Lloyd's algorithm from a fixed start."""
    if not count:
        return []
    i, j = np.nonzero(site.floor.inside)
    stride = max(1, len(i) // 4000)
    points = np.stack([i[::stride], j[::stride]], -1) + 0.5
    x, y = points.T
    order = np.lexsort((y, x) if np.ptp(x) > np.ptp(y) else (x, y))
    seeds = np.array([part.mean(0) for part in np.array_split(points[order], count)])
    for _ in range(30):
        nearest = np.argmin(((points[:, None] - seeds[None]) ** 2).sum(-1), axis=1)
        seeds = np.array([points[nearest == k].mean(0) if (nearest == k).any() else seeds[k] for k in range(count)])
    world = seeds * site.floor.cell + np.asarray(site.floor.origin)
    return [(float(x), float(y)) for x, y in world]


def _is_free_above(site: Site, name: str, point: tuple[float, float]) -> bool:
    """Whether nothing else hangs from the ceiling there and the whole thing is inside the room."""
    outline = site.outline(Member(name, *point))
    others = [site.foot(n) for n, s in site.spots.items() if s.mode == "ceiling"]
    inside = shapely.Polygon(site.room.vertices).covers(outline)
    return inside and not any(outline.intersects(other) for other in others)


def lay_on(site: Site, name: str) -> list[str]:
    """Put what belongs on a thing that stands or hangs already onto it, and return the names."""
    if name not in site.spots:
        return []
    on, laid = site.spots[name].member, list[str]()
    for member in site.clusters.build(name).members:
        if member.name not in site.spots and member.bottom > 0.0 and site.wants[member.name].anchor in site.spots:
            world = member.moved(on.x, on.y, on.yaw)
            world = replace(world, bottom=world.bottom + on.bottom)
            site.settle(member.name, Spot(world, "join", None, site.wants[member.name].anchor))
            laid.append(member.name)
    return laid
