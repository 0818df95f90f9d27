"""Furnishes a room several times over and keeps the best one."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from robolayout.planners._asked import Asked
from robolayout.planners._attempt import Attempt
from robolayout.planners._cluster import ClusterBuilder
from robolayout.planners._member import Member
from robolayout.planners._roles import Cast
from robolayout.planners._site import Site, Spot
from robolayout.scene import Layout, Scene

PATIENCE = 2
"""Attempts without a clearly better room after which the search ends."""

HOPE = 4
"""The same while something is out of the way or does not open."""

ENOUGH, FORLORN = 2, 0.5
"""Attempts after which the search ends if more than this share of the things is out of reach in all of them: such a room is
built anew by the solver."""

WORTH = 1.0
"""Cost by which a room is clearly better."""


def furnish(
    scene: Scene, cast: Mapping[str, Cast], placed: Layout | None, seed: int, asked: Asked | None = None
) -> Site:
    """Return the best of several attempts; the very first one follows the knowledge to the letter.

    The floor is furnished in every attempt, walls and ceiling only in the best one. It is good enough after `PATIENCE`
    attempts without one that is better by `WORTH`, or `HOPE` where it does not serve. Where something is out of the way,
    single things are moved once more; a room that serves then is good enough at once. A hopeless room gets `ENOUGH` attempts.
    """
    empty = Site.of(scene, cast, asked)
    builder = ClusterBuilder(scene, cast)
    best: tuple[float, Attempt] | None = None
    leap, forlorn = (math.inf, 0), True
    for number in range(attempts(len(scene.assets))):
        site = empty.copy()
        _keep(site, builder, placed)
        attempt = Attempt(site, builder, np.random.default_rng((seed, number)), calm=number == 0 and seed == 0)
        cost = attempt.furnish_floor()
        if best is None or cost < best[0]:
            best = (cost, attempt)
        forlorn = forlorn and len(attempt.site.unreached()) > FORLORN * len(scene.assets)
        if forlorn and number + 1 >= ENOUGH:
            break
        if number >= PATIENCE and not best[1].serves and (number == PATIENCE or best[1] is attempt):
            best = (best[1].rearrange(), best[1])
            if best[1].serves:
                break
        if best[0] < leap[0] - WORTH:
            leap = (best[0], number)
        if number - leap[1] >= (PATIENCE if best[1].serves else HOPE):
            break
    assert best is not None
    best[1].furnish_walls()
    return best[1].site


def attempts(count: int) -> int:
    """Return how many rooms to try for so many assets: 12 for small rooms, fewer for crowded ones."""
    return max(3, min(12, 240 // max(count, 1)))


def _keep(site: Site, builder: ClusterBuilder, placed: Layout | None) -> None:
    """Put down what is settled already, and let what joins it join it."""
    if not placed:
        return
    given = [name for name in site.cast if name in placed]
    for name in given:
        pose = placed[name]
        member = Member(name, pose.x, pose.y, pose.yaw, pose.z - site.size(name)[2] / 2)
        site.settle(name, Spot(member, "given"))
    for name in given:
        pose = placed[name]
        for member in builder.build(name).members:
            if member.name not in site.spots and site.cast[member.name].anchor is not None:
                world = member.moved(pose.x, pose.y, pose.yaw)
                world = replace(world, bottom=world.bottom + site.spots[name].member.bottom)
                site.settle(member.name, Spot(world, "join", None, site.cast[member.name].anchor))
