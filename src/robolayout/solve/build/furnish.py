"""Furnishes a room several times over and keeps the best one."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from robolayout.program import Program
from robolayout.scene import Layout, Pose, Scene
from robolayout.solve.build.attempt import BuildPass
from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.member import Member
from robolayout.solve.build.overhead import lay_on
from robolayout.solve.build.site import Site
from robolayout.solve.build.wants import wants_of


@dataclass(frozen=True)
class Attempts:
    """How many times a room is furnished."""

    patience: int = 2  # attempts without a clearly better room after which the search ends
    hope: int = 4  # the same while something is out of the way or does not open
    enough: int = 2
    forlorn: float = 0.5
    """Attempts after which the search ends if more than this share of the things is out of reach in all
    of them: such a room is built anew by the solver."""
    lifted: float = 0.01  # metres above the floor from which on a thing stands on another
    worth: float = 1.0  # cost by which a room is clearly better


ATTEMPTS = Attempts()


def furnished(scene: Scene, program: Program, given: Mapping[str, Pose], seed: int, most: int | None = None) -> Layout:
    """Return poses for all assets that a program says something of, or nothing: the best of several attempts.

    Args:
        scene: The scene.
        program: Statements and wishes; its guesses are not looked at.
        given: Poses that are settled already.
        seed: Settles every choice; 0 follows the wishes to the letter first.
        most: Attempts at the most; as many as the size of the room is worth if None.
    """
    site = _furnish(Site.of(scene, wants_of(scene, program), program), given, seed, most or attempts(len(scene.assets)))
    poses: dict[str, Pose] = {}
    for name, spot in site.spots.items():
        at = spot.member
        poses[name] = given.get(name) or Pose(at.x, at.y, at.bottom + site.size(name)[2] / 2, at.yaw)
    return Layout(poses)


def _furnish(empty: Site, given: Mapping[str, Pose], seed: int, most: int) -> Site:
    """Return the best of so many attempts; the very first one follows the wishes to the letter.

    The floor is furnished in every attempt, walls and ceiling only in the best one. It is good enough after `ATTEMPTS.patience`
    attempts without one that is better by `ATTEMPTS.worth`, or `ATTEMPTS.hope` where it does not serve. Where something is out of the way,
    single things are moved once more; a room that serves then is good enough at once. A hopeless room gets `ATTEMPTS.enough` attempts.
    What misses what is said of it in one attempt is placed first in those that follow.
    """
    count = len(empty.scene.assets)
    best: tuple[float, BuildPass] | None = None
    leap, forlorn, missed = (math.inf, 0), True, set[str]()
    for number in range(most):
        site = empty.copy()
        _keep(site, given)
        attempt = BuildPass(site, seed, number, frozenset(missed))
        cost = attempt.furnish_floor()
        missed |= attempt.missed
        if best is None or cost < best[0]:
            best = (cost, attempt)
        forlorn = forlorn and len(attempt.unreached) > ATTEMPTS.forlorn * count
        if forlorn and number + 1 >= ATTEMPTS.enough:
            break
        if number >= ATTEMPTS.patience and not best[1].serves and (number == ATTEMPTS.patience or best[1] is attempt):
            best = (best[1].rearrange(), best[1])
            if best[1].serves:
                break
        if best[0] < leap[0] - ATTEMPTS.worth:
            leap = (best[0], number)
        if number - leap[1] >= (ATTEMPTS.patience if best[1].serves else ATTEMPTS.hope):
            break
    assert best is not None
    best[1].furnish_walls()
    return best[1].site


def attempts(count: int) -> int:
    """Return how many rooms to try for so many assets: 12 for small rooms, fewer for crowded ones."""
    return max(3, min(12, 240 // max(count, 1)))


def _keep(site: Site, placed: Mapping[str, Pose]) -> None:
    """Put down what is settled already, and onto its tops what belongs there."""
    given = [name for name in site.wants if name in placed]
    for name in given:
        want, pose = site.wants[name], placed[name]
        member = Member(name, bottom=pose.z - site.size(name)[2] / 2)
        mode = "hang" if want.hung else "ceiling" if want.overhead else "rug" if want.laid else "given"
        mode = "join" if want.anchor is not None and member.bottom > ATTEMPTS.lifted else mode
        site.put(Cluster(name, (member,)), np.array([pose.x, pose.y, pose.yaw]), mode)
    for name in given:
        lay_on(site, name)
