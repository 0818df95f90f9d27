"""One pass over everything in a room: big things first, each at its best place; what is then in the way is moved once more."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np

from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.costs import COSTS
from robolayout.solve.build.grid import grid_batches, in_one_row, last_cell, off_walls, put_grid, side_by_side
from robolayout.solve.build.member import GridPlan, Member
from robolayout.solve.build.overhead import asked_below, hang, lay_on, overhead
from robolayout.solve.build.places import Places, batches, close, walled
from robolayout.solve.build.rugs import lay_rugs
from robolayout.solve.build.said import MISSED
from robolayout.solve.build.site import Site
from robolayout.solve.build.sorts import alike, given_up, uncommon
from robolayout.solve.build.taste import keep_sight, looks, taste
from robolayout.solve.build.wants import Want

Modes = Mapping[str, float]
"""Ways of standing, the best first, with what each costs."""

Choice = tuple[float, Places, int]
GridChoice = tuple[float, GridPlan, Places, int]
"""A place: its cost, for a grid its plan, the batch that it is in, and its row there."""


def _put(site: Site, batch: Places, row: int) -> None:
    """Put a cluster at one place of a batch."""
    wall = int(batch.walls[row])
    site.put(batch.cluster, batch.poses[row], batch.mode, wall if wall >= 0 else None)
    keep_sight(site, batch.cluster.anchor)


@dataclass(frozen=True, eq=False)
class _Step:
    """One thing that was done: how to do it again on another site, what it cost, and how to do it otherwise."""

    put: Callable[[Site], None]  # does it
    cost: float = 0.0  # of the place
    cluster: Cluster | None = None  # what was placed; None for what is not placed otherwise (a grid, a board)
    modes: Modes = field(default_factory=dict[str, float])  # ways of standing that were open to it
    weights: Mapping[str, float] = field(default_factory=dict[str, float])  # what it prefers


class BuildPass:
    """One pass over all assets; what is to be placed `first` missed what is said of it in a pass before."""

    def __init__(self, site: Site, seed: int, number: int, first: Collection[str]) -> None:
        self.base = site.copy()
        self.first = first
        self.missed = set[str]()  # what stands where it misses what is said of it
        self.site = site
        self.rng = np.random.default_rng((seed, number))
        self.calm = seed == number == 0  # whether it follows the wishes to the letter
        self.noise = 0.0 if self.calm else COSTS.noise
        self.steps: list[_Step] = []
        self.lost: list[str] = self.unreached if self.site.spots else []
        self.trials = COSTS.trials

    def furnish_floor(self) -> float:
        """Place what stands on the floor, and boards that the rest looks at; return the total cost."""
        for items in self._turns(last=False):
            self._place_kind(items)
        return self.total()

    def rearrange(self) -> float:
        """Move single things once more while something is out of the way; return the total cost."""
        for _ in range(COSTS.moves):
            if not self._move_some():
                break
        return self.total()

    def total(self) -> float:
        """Return the cost of the room as it is."""
        return sum(step.cost for step in self.steps) + looks(self.site) + self.harm

    @property
    def harm(self) -> float:
        """Cost of what the agents do not get to or cannot use, and of the floor that is cut off."""
        return _harm(self.site)[0]

    @property
    def unreached(self) -> list[str]:
        """What the agents do not get to or cannot use."""
        return _harm(self.site)[1]

    @property
    def serves(self) -> bool:
        """Whether everything is reached and used, and every door and drawer opens."""
        return self.harm < COSTS.unreached and all(step.cost < COSTS.shut for step in self.steps)

    def _move_some(self) -> bool:
        """Take some clusters out and put each where it is less in the way; False if nothing gets better."""
        before, steps, site = self.harm, self.steps, self.site
        if before < COSTS.unreached:
            return False
        self.trials = 2 * COSTS.trials
        for out in self._in_the_way(before):
            self.site, self.steps = self._without(out), [step for step in steps if step not in out]
            self.lost = self.unreached
            for step in out:
                if step.cluster is not None:
                    self._place(step.cluster, step.modes, step.weights)
            if self.harm < before - COSTS.unreached / 2:
                return True
            self.site, self.steps = site, steps
        return False

    def _in_the_way(self, harm: float) -> Iterator[list[_Step]]:
        """Yield what to move: single things without which more is reached, then what stands around the unreached."""
        movable = [step for step in self.steps if step.cluster is not None]
        left = [(_harm(self._without([step], trial=True))[0], i) for i, step in enumerate(movable)]
        yield from ([movable[i]] for value, i in sorted(left)[: COSTS.singles] if value < harm - COSTS.unreached / 2)
        for name in self.unreached[: COSTS.singles]:
            here = self.site.spots[name].member
            near = sorted(range(len(movable)), key=lambda i: self._apart(movable[i], here))
            yield from ([movable[i] for i in sorted(near[:count])] for count in COSTS.around)

    def _apart(self, step: _Step, here: Member) -> float:
        """Return metres between a place and the nearest thing of a step's cluster."""
        spots = (self.site.spots[member.name].member for member in step.cluster.members) if step.cluster else ()
        away = ((math.hypot(at.x - here.x, at.y - here.y), self.site.size(at.name)) for at in spots)
        return min(far - min(size[:2]) / 2 for far, size in away)

    def _without(self, out: Sequence[_Step], *, trial: bool = False) -> Site:
        """Return the site with everything done again but some steps."""
        site = self.base.copy(trial=trial)
        for step in self.steps:
            if step not in out:
                step.put(site)
        return site

    def furnish_walls(self) -> None:
        """Hang and lay the rest, where the agents reach it over the finished floor."""
        turns = self._turns(last=True)
        if turns:
            self.site.survey()
        # a picture that is usual over a bed waits for the photos that are asked to hang there
        for items in sorted(turns, key=lambda kind: not any(asked_below(self.site, item.name) for item in kind)):
            self._place_kind(items)

    def _turns(self, *, last: bool) -> list[list[Want]]:
        """Return what stands by itself, or at what is given, and has no place yet, kind by kind, big things first."""
        by_kind: dict[str, list[Want]] = {}
        for item in self.site.wants.values():
            alone = item.anchor is None or (item.anchor in self.base.spots and item.asset.on_floor)
            alone = alone or (item.name in self.first and self._stands_alone(item.name))
            if alone and item.name not in self.site.spots and (item.name in self.site.late) == last:
                by_kind.setdefault(item.kind, []).append(item)
        nudge = 0.0 if self.calm else COSTS.shuffle
        below = [under for name in self.site.late for under in asked_below(self.site, name)]
        wide = {one for one in below if below.count(one) > 1}  # its wall has to have room for all that hangs over it
        early = wide.union(self.first, self.site.first)
        ahead = [len(by_kind) * any(one.name in early for one in items) for items in by_kind.values()]
        turns = [
            (turn + nudge * self.rng.normal() - ahead[turn], turn, items) for turn, items in enumerate(by_kind.values())
        ]
        for *_, items in turns:
            items.sort(key=lambda item: -item.asset.size[0] * item.asset.size[1])
        return [items for *_, items in sorted(turns, key=lambda entry: entry[:2])]

    def _place_kind(self, items: Sequence[Want]) -> None:
        flat = [item.name for item in items if item.laid]
        hung, high = ([item.name for item in items if getattr(item, way)] for way in ("hung", "overhead"))
        standing = [item.name for item in items if item.standing]
        hang(self.site, hung, self.rng)
        overhead(self.site, high)
        lay_rugs(self.site, flat)
        there = [name for name in (*hung, *high, *flat) if name in self.site.spots]
        for name in hung:
            there += lay_on(self.site, name)
        self.steps += [_Step(partial(Site.settle, name=name, spot=self.site.spots[name])) for name in there]
        clusters = [self._without_first(self.site.clusters.build(name)) for name in standing]
        if not clusters:
            return
        weights, modes = self._weights(items[0].weights), self._modes(items[0])
        if items[0].rows is not None:  # as they are listed, row by row, the one in the middle of the first among them
            turn = {one.name: number for number, one in enumerate(items[0].rows.items)}
            clusters.sort(key=lambda cluster: turn.get(cluster.anchor, len(turn)))
        if items[0].rows is not None or items[0].shape is not None:
            clusters = self._in_rows(clusters, modes, weights)
        elif items[-1].straight and len(clusters) > 1 and next(iter(modes)) == "wall":
            row = side_by_side(self.site, clusters)  # beds with their heads at one wall
            clusters = [] if self._place(row, {"wall": 0.0}, weights, COSTS.bad) else clusters
        for cluster in clusters:
            own = self._modes(self.site.wants[cluster.anchor])
            self._place(cluster, self._open_to(cluster, own), weights)

    def _modes(self, item: Want) -> Modes:
        """Return the ways of standing of a thing, at what it joins if that is there."""
        if item.anchor is None or item.anchor not in self.site.spots:
            return item.stands
        alone = {mode: cost + COSTS.elsewhere for mode, cost in item.stands.items()} if item.loose else {}
        return {"slot": 0.0, "join": COSTS.elsewhere} | alone

    def _open_to(self, cluster: Cluster, modes: Modes) -> Modes:
        """Return the ways of standing that a cluster is open to: all, where in none of its own it meets what the user asks."""
        modes = {**modes, "led": 0.0} if walled(self.site, cluster) else modes
        if not self.site.said.about([member.name for member in cluster.members]):
            return modes
        own = batches(self.site, cluster, modes)
        if any(float(self.site.missed(batch.cluster.members, batch.poses).min()) < MISSED for batch in own):
            return modes
        return dict.fromkeys(("wall", "corner", "middle"), COSTS.otherwise) | dict(modes)

    def _weights(self, wishes: Mapping[str, float]) -> dict[str, float]:
        if self.calm:
            return dict(wishes)
        return {key: value * float(np.exp(self.rng.normal(0.0, COSTS.mood))) for key, value in wishes.items()}

    def _in_rows(self, clusters: Sequence[Cluster], modes: Modes, weights: Mapping[str, float]) -> list[Cluster]:
        """Place what fits well along the walls, put the rest into a grid, and return what fits nowhere."""
        left, least = list(clusters), 2
        if all(any(self.site.wants[n].hung for n in self.site.wants[one.anchor].at) for one in clusters):
            return left  # the mirrors before which they stand hang in a row
        if self.site.wants[clusters[0].anchor].block:
            out = uncommon(self.site, clusters)
            own = [self._without_own(cluster, out) for cluster in clusters]
            row = in_one_row(self.site, own)
            lined = row is not None and "wall" in modes and self._place(row, {"wall": 0.0}, weights, COSTS.much)
            if lined or self._place_grid(own, weights, 0):
                self._place_alone(out)
                return []
        elif not any(map(self.site.backed, clusters)) and (
            next(iter(modes)) == "wall" or {*modes} <= {"wall", "corner"}
        ):
            left = [one for one in clusters if not self._place(one, {"wall": 0.0}, weights, limit=COSTS.bad)]
            if "middle" not in modes:
                return left  # their walls are demanded
            least = COSTS.block
        for equal in alike(self.site, left):
            for count in sorted({max(2, round(len(equal) * share)) for share in COSTS.shares}, reverse=True):
                if least <= count <= len(equal) and self._place_grid(equal[:count], weights, len(equal) - count):
                    left = [one for one in left if one not in equal[:count]]
                    break
        return left

    def _place(self, cluster: Cluster, modes: Modes, weights: Mapping[str, float], limit: float | None = None) -> bool:
        """Put a cluster at its best place; with a limit only if that place is no worse than it."""
        ranked = self._ranked(batches(self.site, cluster, modes), weights, modes)
        if not ranked:
            pose = np.array([*self.site.floor.middle, 0.0])  # the solver has to see
            nowhere = _Step(lambda site: site.put(cluster, pose, "middle"), COSTS.nowhere)
            return limit is None and self._do(nowhere)
        before = self.lost
        cost, batch, row = self._choose(ranked)
        if limit is not None and cost > limit:
            self.lost = before
            return False
        dear = cost > COSTS.much and limit is None
        if dear and len(cluster.members) > 1 and self._split(cluster, modes, weights):
            return True
        if dear and "middle" not in modes:
            self.lost = before
            return self._place(cluster, {**modes, "middle": MISSED}, weights)
        afloat = modes[batch.mode] > COSTS.hopeless and self.site.said.may_go_first(
            [member.name for member in cluster.members]
        )
        if afloat or self.site.missed(batch.cluster.members, batch.poses[[row]])[0] >= MISSED:
            self.missed.add(cluster.anchor)
        return self._do(_Step(partial(_put, batch=batch, row=row), cost, cluster, modes, weights))

    def _do(self, step: _Step) -> bool:
        """Do a step, which may be done again on other sites."""
        step.put(self.site)
        self.steps.append(step)
        return True

    def _ranked(self, found: Sequence[Places], weights: Mapping[str, float], modes: Modes) -> list[Choice]:
        """Return the `COSTS.checked` best places of all batches, best first."""
        choices: list[Choice] = []
        for batch in found:
            cost = self.site.base_cost(batch.cluster, batch.poses) + taste(self.site, batch, weights)
            cost += self.site.missed(batch.cluster.members, batch.poses)
            cost += modes[batch.mode]
            cost += self.rng.random(len(cost)) * self.noise
            best = np.argsort(cost, kind="stable")[: COSTS.checked]
            choices += [(float(cost[row]), batch, int(row)) for row in best]
        return sorted(choices, key=lambda choice: choice[0])[: COSTS.checked]

    def _choose(self, ranked: Sequence[Choice]) -> Choice:
        """Return the first place that is exactly free and cuts nothing off, or else the one that does least harm."""
        best: Choice | None = None
        rejected, left = list[Choice](), dict[float, list[str]]()
        for cost, batch, row in ranked:
            if best is not None and cost > best[0]:
                break
            apart = COSTS.close + COSTS.widen * len(rejected)
            if any(close(batch, row, other, at, apart) for _, other, at in rejected):
                continue
            fault = self.site.fault(batch.cluster, batch.poses[row])
            harm = COSTS.inexact if fault == "touches" else COSTS.shut
            if not fault:
                trial = self.site.copy(trial=True)
                _put(trial, batch, row)
                harm, lost = _harm(trial, self.lost, math.inf if best is None else best[0] - cost)
                left[cost + harm] = lost
                rejected.append((cost, batch, row))
            if best is None or cost + harm < best[0]:
                best = (cost + harm, batch, row)
            if not fault and (harm < COSTS.harmless or len(rejected) >= self.trials):
                break
        chosen = best or ranked[0]
        self.lost = left.get(chosen[0], self.lost)
        return chosen

    def _split(self, cluster: Cluster, modes: Modes, weights: Mapping[str, float]) -> bool:
        """Place a cluster that fits nowhere as a whole: some floor things that can stand alone are placed on their own."""
        loose = [m for m in cluster.members[1:] if self._stands_alone(m.name)]
        out, rest = list[str](), cluster
        for out in given_up(loose):
            rest = self._without_own(cluster, out)
            if len(out) < len(loose):
                found = self._ranked(batches(self.site, rest, modes), weights, modes)
                if found and found[0][0] <= COSTS.much:
                    break
        if not out:
            return False
        self._place(rest, modes, weights)
        self._place_alone(out)
        return True

    def _without_own(self, cluster: Cluster, out: Sequence[str]) -> Cluster:
        """Return a cluster without some things and what goes by them."""
        gone = {m.name for name in out for m in self.site.clusters.build(name).members}
        return replace(cluster, members=tuple(m for m in cluster.members if m.name not in gone))

    def _without_first(self, cluster: Cluster) -> Cluster:
        """Return a cluster without what is placed first by itself."""
        out = [m.name for m in cluster.members[1:] if m.name in self.first and self._stands_alone(m.name)]
        return self._without_own(cluster, out)

    def _place_alone(self, out: Sequence[str]) -> None:
        """Place things that their clusters gave up, each with what goes by it."""
        own = {name: self.site.clusters.build(name) for name in out}
        carried = {member.name for one in own.values() for member in one.members[1:]}  # stand where their anchors go
        for name in (name for name in out if name not in carried):
            want = self.site.wants[name]
            self._place(own[name], want.stands, want.weights)

    def _stands_alone(self, name: str) -> bool:
        item = self.site.wants[name]
        return item.loose and item.asset.on_floor

    def _place_grid(self, clusters: Sequence[Cluster], weights: Mapping[str, float], strays: int) -> bool:
        """Put equal clusters into their best grid, so many others being left; False if none is good."""
        few: list[GridChoice] = []
        more: list[GridChoice] = []
        missed = math.inf  # the least that a place misses of what is said
        told = bool(self.site.wants[clusters[0].anchor].block)
        for plan, batch in grid_batches(self.site, clusters):
            clash = self.site.clash(batch.cluster, batch.poses, limit=1.0)
            free = clash <= 1.0
            if not free.any():
                continue
            batch = replace(batch, poses=batch.poses[free], walls=batch.walls[free])
            cost = self.site.base_cost(batch.cluster, batch.poses, clash[free]) / len(clusters)
            last = last_cell(self.site, plan, batch)
            middle = replace(batch, poses=(batch.poses + last.poses) / 2)
            cost += sum(taste(self.site, one, weights) for one in (batch, middle, last)) / 3
            unmet = self.site.missed(batch.cluster.members, batch.poses)
            missed = min(missed, float(unmet.min()))
            cost += unmet + COSTS.tight * plan.tight + COSTS.ragged * (plan.rows * plan.columns - len(plan.names))
            cost += 0.3 * abs(plan.rows - plan.columns) ** 0.5 + COSTS.elsewhere * off_walls(self.site, plan, batch)
            rows = np.argsort(cost, kind="stable")
            as_good = rows[cost[rows] < cost[rows[0]] + MISSED]
            spread = as_good[:: math.ceil(len(as_good) / COSTS.spread)]
            tried = spread if plan.cells else rows[:4]
            few += [(float(cost[row]), plan, batch, int(row)) for row in tried]
            across = np.abs(np.sin(batch.poses[rows, 2])) > math.sqrt(0.5)
            turned = rows[across != across[0]][: told * COSTS.checked]  # the other way may leave a way past it
            elsewhere = [] if plan.cells else spread[: told * len(spread)]
            more += [(float(cost[row]), plan, batch, int(row)) for row in (*turned, *elsewhere)]
        limit = COSTS.hopeless + (missed if told else 0.0)  # what no place meets of a block speaks against none
        limit = limit if self.site.wants[clusters[0].anchor].shape is None else math.inf
        best = self._best_grid(clusters, few, limit)
        if best is None and more:
            best = self._best_grid(clusters, more, limit)
        if best is None:
            return False
        put = partial(put_grid, clusters=clusters, plan=best[1], frame=best[2].poses[best[3]])
        return self._do(_Step(put, best[0] * len(clusters) ** 0.5 + COSTS.stray * strays))

    def _best_grid(self, clusters: Sequence[Cluster], ranked: Sequence[GridChoice], limit: float) -> GridChoice | None:
        """Return the best place of a grid, with what it costs in all; None if all cost more than a limit."""
        best: GridChoice | None = None
        before, tried = self.unreached, 0
        for cost, plan, batch, row in sorted(ranked, key=lambda entry: entry[0]):
            if cost > limit or tried >= 3 * COSTS.trials or (best is not None and cost > best[0]):
                break
            if not self.site.fault(batch.cluster, batch.poses[row]):
                tried += 1
                trial = self.site.copy(trial=True)
                put_grid(trial, clusters, plan, batch.poses[row])
                worse = limit if best is None else best[0]
                harm = _harm(trial, before, (worse - cost) * len(clusters) ** 0.5)[0] / len(clusters) ** 0.5
                if best is None or cost + harm < best[0]:
                    best = (cost + harm, plan, batch, row)
        return best if best is not None and best[0] <= limit else None


def _harm(site: Site, known: Sequence[str] = (), limit: float = math.inf) -> tuple[float, list[str]]:
    """Return the cost of what the agents do not get to or cannot use, and of the floor that is cut off; and what that is.

    What was `known` to be so costs nothing; above a limit only that it is above is known.
    """
    site.survey()
    cut = COSTS.cut_off * site.cut_off
    lost = site.unreached(known, len(known) + (limit - cut) / COSTS.unreached)
    return COSTS.unreached * (len(lost) - len(known)) + cut, lost
