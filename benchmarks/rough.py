"""Programs as a model writes them: right in most of what they say, rough in where they put things.

A good layout of an example task is read back as statements, most of them LayoutVLM's five, some of which are left out and some
of which contradict the others; then everything is moved by 0.1 to 0.6 m, and some of it is turned around. What the solver makes
of it is compared with that guess: how far things had to go, and which of them went without need.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import robolayout as rl
from benchmarks.examples import ROOT
from benchmarks.measures import warmed
from benchmarks.store import Row
from benchmarks.tables import Rows, mean, phases, table
from robolayout.constraints import AssetRef, Relation, WallRef
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.next_to import NextTo
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.symmetric_pair import SymmetricPair
from robolayout.program import Program
from robolayout.run.flow import make_judge
from robolayout.scene import Asset, Layout, Pose, Scene
from robolayout.solve import compile_problem

TASKS = (
    "bedroom_small", "childrens_room_small", "living_room_small", "bathroom", "deli_small", "bedroom_medium", "meeting_room",
    "hospital_room", "childrens_room_medium", "kitchen", "office", "bedroom_crowded", "cafe", "dining_room_medium",
    "classroom_medium", "living_room_crowded", "florists_shop_crowded", "dining_room_crowded",
)  # fmt: skip
"""Rooms of 9 to 62 assets."""

SEEDS = range(2)
OFF = (0.1, 0.6)
"""Metres by which a guess is off, at least and at most."""

ON_TOP = 0.15
"""The same for what stands on a top, as a share."""

LEFT_OUT, WRONG, TURNED, SAID = 0.15, 0.05, 0.08, 0.4
"""Share of statements left out, of things of which something is said that contradicts the rest, of headings turned by 180
degrees, and of what a model may say or not that it says."""

NEED = 0.05
"""Metres that a thing may be moved without a reason."""


@dataclass(frozen=True)
class Rough:
    """A scene with a rough program.

    Attributes:
        scene: The scene.
        good: The layout from which the program was read.
        text: The program.
    """

    scene: Scene
    good: Layout
    text: str


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room and seed."""
    for seed in SEEDS[:1] if quick else SEEDS:
        for task in TASKS[:2] if quick else TASKS:
            yield f"{task}/{seed}", partial(measured, task, seed)


def rough(task: str, seed: int) -> Rough:
    """Return a task with a rough program; the same for the same seed."""
    result = rl.generate(ROOT / "examples" / "tasks" / f"{task}.json")
    scene, good = result.scene, result.layout
    problem = compile_problem(scene, result.reconciled.program)
    carrier = {name: problem.names[p] for name, p in zip(problem.names, problem.parent, strict=True) if p >= 0}
    rng = random.Random(f"{task} {seed}")
    lines = [*_statements(scene, good, carrier, rng)]
    return Rough(scene, good, "\n".join([*_guesses(scene, good, carrier, rng), *lines]) + "\n")


def _guesses(scene: Scene, good: Layout, carrier: dict[str, str], rng: random.Random) -> Iterator[str]:
    """Yield the lines that say where everything is, more or less; what stands on a top goes with it."""
    shift: dict[str, tuple[float, float]] = {}
    for asset in sorted(scene.assets, key=lambda asset: _depth(asset.name, carrier)):
        away, way = rng.uniform(*OFF), rng.uniform(0.0, math.tau)
        if asset.name in carrier:
            dx, dy = shift[carrier[asset.name]]
            away *= ON_TOP
        else:
            dx, dy = 0.0, 0.0
        shift[asset.name] = dx + away * math.cos(way), dy + away * math.sin(way)
    for asset in scene.assets:
        pose, (dx, dy) = good[asset.name], shift[asset.name]
        yaw = math.degrees(pose.yaw) + (180.0 if rng.random() < TURNED and asset.name not in carrier else 0.0)
        yield f"{said(scene, asset.name)}.position = [{pose.x + dx:.2f}, {pose.y + dy:.2f}, {pose.z:.2f}]"
        yield f"{said(scene, asset.name)}.rotation = [{round(yaw) % 360}]"


def _statements(scene: Scene, good: Layout, carrier: dict[str, str], rng: random.Random) -> Iterator[str]:
    """Yield what a model would say about a layout."""
    named = partial(said, scene)
    for asset in scene.assets:
        name, facts = asset.name, list[str]()
        if name in carrier:
            yield f"solver.on_top_of({named(name)}, {named(carrier[name])})"
            continue
        wall = _wall(scene, good, asset)
        if wall is not None:
            facts.append(f"solver.against_wall({named(name)}, walls[{wall}])")
        other = _anchor(scene, good, asset, carrier)
        if other is not None:
            facts += _about(scene, good, asset, other, rng, turn=wall is None)
        if other is not None and rng.random() < WRONG:
            far = max(scene.assets, key=lambda one: (_apart(good, name, one.name), one.name)).name
            facts.append(f"solver.distance_constraint({named(name)}, {named(far)}, None, 0.8)")
        yield from (fact for fact in facts if rng.random() >= LEFT_OUT)
    yield from (line for line in _pairs(scene, good, carrier) if rng.random() < SAID)


def _about(scene: Scene, good: Layout, asset: Asset, other: Asset, rng: random.Random, *, turn: bool) -> Iterator[str]:
    """Yield what holds between a thing and what it goes by; only what no wall holds is turned towards something."""
    a, b = said(scene, asset.name), said(scene, other.name)
    away = _apart(good, asset.name, other.name)
    first, second = AssetRef(asset.name), AssetRef(other.name)
    if _holds(NextTo(first, second), scene, good) and rng.random() < SAID / 2:
        yield f"solver.next_to({a}, {b})"
    else:
        yield f"solver.distance_constraint({a}, {b}, {max(away - 0.3, 0.0):.1f}, {away + 0.3:.1f})"
    if turn and _holds(PointTowards(first, second), scene, good):
        yield f"solver.point_towards({a}, {b})"
    elif turn and _holds(AlignWith(first, second), scene, good):
        yield f"solver.align_with({a}, {b})"


def _pairs(scene: Scene, good: Layout, carrier: dict[str, str]) -> Iterator[str]:
    """Yield the mirrored pairs of one kind about what both go by."""
    for first, second in zip(scene.assets, scene.assets[1:], strict=False):
        if first.category != second.category or first.name in carrier or second.name in carrier:
            continue
        middle = _anchor(scene, good, first, carrier)
        if middle is None or middle in (first, second):
            continue
        pair = SymmetricPair(AssetRef(first.name), AssetRef(second.name), AssetRef(middle.name))
        if _holds(pair, scene, good):
            names = ", ".join(said(scene, one.name) for one in (first, second, middle))
            yield f"solver.symmetric_pair({names})"


def _wall(scene: Scene, good: Layout, asset: Asset) -> int | None:
    """Return the wall at which a thing stands with its back."""
    if asset.is_flat:
        return None
    walls = (wall.index for wall in scene.room.walls)
    return next((i for i in walls if _holds(AgainstWall(AssetRef(asset.name), WallRef(i)), scene, good)), None)


def _anchor(scene: Scene, good: Layout, asset: Asset, carrier: dict[str, str]) -> Asset | None:
    """Return the nearest thing on the floor that is larger in plan, within 2 m."""
    larger = [
        one
        for one in scene.assets
        if one.name not in carrier and one.on_floor and not one.is_flat and _area(one) > 1.2 * _area(asset)
    ]
    near = [one for one in larger if _apart(good, asset.name, one.name) <= 2.0]
    return min(near, key=lambda one: (_apart(good, asset.name, one.name), one.name), default=None)


def _holds(relation: Relation, scene: Scene, layout: Layout) -> bool:
    return relation.check(scene, layout).met


def _area(asset: Asset) -> float:
    return asset.size[0] * asset.size[1]


def _apart(layout: Layout, first: str, second: str) -> float:
    return math.dist((layout[first].x, layout[first].y), (layout[second].x, layout[second].y))


def _depth(name: str, carrier: dict[str, str]) -> int:
    return 1 + _depth(carrier[name], carrier) if name in carrier else 0


def said(scene: Scene, name: str) -> str:
    """Return how a program names an asset."""
    asset = scene.by_name[name]
    return f"{asset.variable}[{scene.variables[asset.variable].index(asset)}]"


def measured(task: str, seed: int) -> Row:
    """Lay a rough program out, once to load everything and once to measure, and compare the result with its guess."""
    given = rough(task, seed)
    result, row = warmed(given.scene, program=given.text, seed=seed)
    guess = rl.verify(given.scene, guessed(given.scene, result.program), result.program)
    return {
        **row,
        "guess_met": sum(item.met for item in guess.statements),
        **moves(given.scene, result),
        "phase": result.solution.phase,
        "assets": len(given.scene.assets),
    }


def guessed(scene: Scene, program: Program) -> Layout:
    """Return where a program puts things, at the heights at which the solver would put them."""
    return compile_problem(scene, rl.reconcile(program, scene).program).guess


def moves(scene: Scene, result: rl.Result) -> Row:
    """Return how far things are from their guesses, and how many of them without need."""
    guess, layout, gone = guessed(scene, result.program), result.layout, away(scene, result)
    turned = [abs(math.remainder(pose.yaw - layout[name].yaw, math.tau)) for name, pose in guess.items()]
    judge = make_judge(scene, result.reconciled.program)
    least = judge(layout).merit
    idle = [
        name for name, pose in guess.items() if gone[name] > NEED and judge(_back(layout, name, pose)).merit <= least
    ]
    return {
        "moved": sum(gone.values()) / len(gone),
        "farthest": max(gone.values()),
        "turned": math.degrees(sum(turned)) / len(turned),
        "needless": len(idle),
    }


def away(scene: Scene, result: rl.Result) -> dict[str, float]:
    """Return how many metres each thing is from its guess."""
    guess, layout = guessed(scene, result.program), result.layout
    return {name: math.dist((pose.x, pose.y), (layout[name].x, layout[name].y)) for name, pose in guess.items()}


def _back(layout: Layout, name: str, pose: Pose) -> Layout:
    return Layout({**layout, name: pose})


def section(rows: Rows, images: Path) -> str:
    """Return the table of programs with a rough guess, one line per room."""
    lines = [
        [
            *(key.replace("_", " ").replace("/", ", seed "), str(row["assets"]), "yes" if row["hard_ok"] else "no"),
            *(f"{row['walkable_ratio']:.2f}", str(row["short"]), f"{row['guess_met']} / {row['met']} / {row['asked']}"),
            *(f"{row['moved']:.2f} / {row['farthest']:.2f}", f"{row['turned']:.0f}", str(row["needless"])),
            *(row["phase"], f"{row['cpu']:.1f}"),
        ]
        for key, row in _natural_rows(rows)
    ]
    found = list(rows.values())
    total = [f"{sum(row[name] for row in found)}" for name in ("guess_met", "met", "asked")]
    means = [
        f"**{mean(found, 'moved'):.2f}** / {max(row['farthest'] for row in found):.2f}",
        f"{mean(found, 'turned'):.0f}",
    ]
    last = [*means, str(sum(row["needless"] for row in found)), phases(found), f"{mean(found, 'cpu'):.1f}"]
    hard = f"{mean(found, 'hard_ok'):.0%}"
    lines.append(["all", "", hard, "", str(sum(row["short"] for row in found)), " / ".join(total), *last])
    heads = ["room", "assets", "hard demands met", "walkable", "out of reach", "statements met: guess / result / asked"]
    heads += ["moved: mean / most, m", "turned, mean degrees", "without need", "made by", "CPU s, warm"]
    intro = (
        "Programs as a model writes them (`benchmarks/rough.py`): statements read off a good layout of a task, some left out and "
        "some that contradict the others; everything 0.1 to 0.6 m off, some of it turned around. *Without need*: moved by "
        "more than 5 cm although the layout would be no worse with that one thing where the program put it.\n"
    )
    return f"## Programs with a rough guess\n\n{intro}\n{table(heads, lines)}"


def _natural_rows(rows: Rows) -> list[tuple[str, Row]]:
    """Return rows by number of assets, then by name."""
    return sorted(rows.items(), key=lambda item: (item[1]["assets"], item[0]))
