"""Scenes, statements and layouts for the laws of relations, made from nothing but a relation's own declaration.

Its `example` names the things it is about ("lamp[0]", "night_stand[0]"): their categories give sizes and flags, and what its
arguments take ("asset", "wall", "point", "room", choices, degrees) is varied at random. So a new relation, one of a user's
too, is held to the laws without a line here.
"""

from __future__ import annotations

import ast
import dataclasses
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache, partial

import jax
import jax.numpy as jnp
import numpy as np

from robolayout.assets import find_category
from robolayout.constraints import RELATIONS, AssetRef, ClearTerm, FrameTerm, PointRef, Relation, WallRef
from robolayout.constraints.mounted_on import EYE_HEIGHT
from robolayout.program import Program, Statement, read_program
from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene
from robolayout.solve import Problem, Weights, compile_problem
from robolayout.solve.arrays import Arrays
from robolayout.solve.search import everything, losses
from robolayout.solve.stage import make_stage, no_routes

STARTS, SLOTS = 16, 8
PARTS = ("statements", "overlap", "inside", "clear")
"""Sums of the solver's terms: of the statement itself, of overlaps, of the boundary, of clear boxes."""

RAW = Weights(saturation=1e6)
"""Statements that do not saturate: their part is the plain sum of residuals."""

STATED = ("statements", "clear")
"""The parts that a statement may add to."""

ROOMS = {
    "rectangle": ((0.0, 0.0), (8.0, 0.0), (8.0, 7.0), (0.0, 7.0)),
    "L": ((0.0, 0.0), (9.0, 0.0), (9.0, 5.0), (5.0, 5.0), (5.0, 8.0), (0.0, 8.0)),
    "triangle": ((0.0, 0.0), (12.0, 0.0), (4.0, 10.0)),
}


@dataclass(frozen=True)
class Case:
    """A statement in a scene, with the solver's arrays for it and poses (starts, slots, 3) as x, y, yaw.

    Attributes:
        satisfied: Poses that descent on the residual alone ended in, some of them satisfied.
        random: Poses anywhere in and around the room.
    """

    scene: Scene
    relation: Relation
    near: Layout
    arrays: Arrays
    satisfied: np.ndarray
    random: np.ndarray

    @property
    def movers(self) -> set[str]:
        """Names of the assets that the relation says it moves."""
        return set(moved_by(self.relation))

    @property
    def rows(self) -> int:
        return len(self.relation.terms(self.scene, self.near))

    def layout(self, poses: np.ndarray) -> Layout:
        """Return poses (slots, 3) as a layout."""
        named = zip(self.scene.assets, poses[: len(self.scene.assets)].tolist(), strict=True)
        return Layout({a.name: replace(self.near[a.name], x=x, y=y, yaw=yaw) for a, (x, y, yaw) in named})


def moved_by(relation: Relation) -> Iterator[str]:
    """Yield the names of the assets that a relation moves; where it is made of others, of what these move."""
    waiting: list[object] = [getattr(relation, name) for name in relation.moves]
    while waiting:
        value = waiting.pop()
        if isinstance(value, tuple):
            waiting += value
        elif isinstance(value, Relation):
            yield from moved_by(value)
        elif isinstance(value, AssetRef):
            yield value.name


def scene_of(example: str, rng: np.random.Generator, room: str = "rectangle", **options: object) -> Scene:
    """Return a room with the things that a line of program text names, sizes varied by 15 %, and two boxes."""
    counts: dict[str, int] = {}
    for node in ast.walk(ast.parse(example)):
        if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.value.id != "walls":
            index = node.slice.value + 1 if isinstance(node.slice, ast.Constant) else 6
            counts[node.value.id] = max(counts.get(node.value.id, 0), index)
    assets = []
    for variable, count in counts.items():
        kind = find_category(variable.replace("_", " "))
        flags = {key: getattr(kind, key) for key in ("on_floor", "on_wall", "on_ceiling", "on_object")}
        size = tuple(float(side * rng.uniform(0.85, 1.15)) for side in kind.size)
        assets += [Asset(f"{variable}-{i}", kind.name, size, **flags) for i in range(count)]
    assets += [Asset(f"bystander-{i}", "box", (0.5, 0.9, 1.2)) for i in range(min(2, SLOTS - len(assets)))]
    door = Opening(0, 1.0, 0.9, 2.05)
    window = Opening(1, 1.5, 1.4, 1.2, 0.9)
    return Scene(Room(ROOMS[room], 2.8, doors=(door,), windows=(window,)), tuple(assets), **options)


def vary(relation: Relation, scene: Scene, rng: np.random.Generator, chance: float = 0.5) -> Relation:
    """Return the relation with other arguments of the kinds that it takes, each with that chance."""
    x0, y0, x1, y1 = scene.room.bounds
    middle = (rng.uniform(x0 + 2, x1 - 2), rng.uniform(y0 + 2, y1 - 2))
    changes: dict[str, object] = {}
    for field in relation.arguments():
        takes, value = field.metadata["takes"], getattr(relation, field.name)
        swaps: list[object] = []
        if isinstance(value, WallRef) or ("wall" in takes and "asset" in takes):
            swaps.append(WallRef(int(rng.integers(len(scene.room.walls)))))
        if "point" in takes and field.metadata["many"]:
            turns = np.sort(rng.uniform(0, math.tau, 5)) if rng.random() < 0.5 else np.arange(4) * math.pi / 2 + 0.3
            swaps.append(tuple(PointRef(middle[0] + 2 * math.cos(t), middle[1] + 2 * math.sin(t)) for t in turns))
        elif "point" in takes:
            swaps.append(PointRef(*middle))
        if "room" in takes or (isinstance(value, WallRef) and "none" in takes):
            swaps.append(None)
        swaps += field.metadata["choices"]
        if field.metadata["unit"] == "deg":
            swaps += [0.0, 37.0, 90.0, -135.0]
        if swaps and rng.random() < chance:
            changes[field.name] = swaps[int(rng.integers(len(swaps)))]
    changed = replace(relation, **changes)
    return relation if changed.fault(scene) else changed


def stage_arrays(problem: Problem) -> Arrays:
    """Return the solver's arrays of one statement: what holds wall things and keeps doors clear is left out."""
    arrays = make_stage(problem, 0, problem.start).arrays
    terms = list(problem.statement_terms)
    framed = sum(isinstance(term, FrameTerm) for term in terms)
    implicit = sum(isinstance(term, ClearTerm) for term in problem.implicit_terms)
    row, clear = arrays.frame_row.copy(), arrays.clear_weight.copy()
    row[framed:, -1] = 0.0
    clear[:implicit] = 0.0
    return arrays._replace(frame_row=row, clear_weight=clear, inside=arrays.free[:, 0])


def flat_problem(scene: Scene, *relations: Relation, seed: int = 0) -> Problem:
    """Return a problem in which everything moves at once, at the height that the statements give it."""
    statements = tuple(Statement(relation, number=i) for i, relation in enumerate(relations, 1))
    hung = {asset.name for asset in scene.assets if asset.on_wall and not asset.on_floor}
    heights = (EYE_HEIGHT if asset.name in hung else asset.size[2] / 2 for asset in scene.assets)
    places = enumerate(zip(scene.assets, heights, strict=True), 1)
    apart = Layout({asset.name: Pose(0.1 * i, 0.1 * i, z, 0.0) for i, (asset, z) in places})
    problem = compile_problem(scene, Program(statements=statements), seed=seed, built=apart)
    count = len(scene.assets)
    return replace(problem, parent=(-1,) * count, stage=(0,) * count)


def _terms(poses: jax.Array, arrays: Arrays, factors: jax.Array, weights: Weights) -> tuple[jax.Array, jax.Array]:
    def parts(poses: jax.Array) -> tuple[jax.Array, jax.Array]:
        x, y, yaw = (poses[..., i] for i in range(3))
        local = jnp.stack([x, y, jnp.cos(yaw), jnp.sin(yaw)], axis=-1)
        world = arrays._replace(anchor=jnp.zeros_like(arrays.anchor).at[:, 2].set(1.0))
        found = losses(local, world, no_routes(len(poses), 1), everything(arrays), weights)
        values = jnp.stack([found.statements, found.overlap, found.boundary, found.clear], axis=-1)
        return jnp.sum(values @ factors), values

    gradient, values = jax.grad(parts, has_aux=True)(poses)
    return values, gradient


_compiled = partial(jax.jit, _terms, static_argnames="weights")
_known = {"xla_cpu_use_fusion_emitters": False} if jax.__version__.startswith("0.10.") else {}
_often = _compiled(compiler_options=_known)
_rarely = _compiled(compiler_options={**_known, "xla_backend_optimization_level": "0"})
"""The same in a quarter of the time to compile, at twice the time to run."""


def measure(
    poses: np.ndarray, arrays: Arrays, parts: tuple[str, ...] = STATED, kind: type[np.floating] = np.float64
) -> tuple[np.ndarray, np.ndarray]:
    """Return the chosen parts (starts,) of the solver's terms and their gradient (starts, slots, 3)."""
    chosen = np.array([part in parts for part in PARTS], kind)
    with jax.enable_x64(kind is np.float64):
        exact = jax.tree.map(lambda f: f.astype(kind) if f.dtype.kind == "f" else f, arrays)
        run = _often if kind is np.float64 else _rarely
        values, gradient = run(poses.astype(kind), exact, chosen, RAW)
        return np.asarray(values) @ chosen, np.asarray(gradient)


def descend(poses: np.ndarray, arrays: Arrays, *parts: str, steps: int = 150) -> np.ndarray:
    """Return where Adam on x, y and yaw ends."""
    first, second = np.zeros_like(poses), np.zeros_like(poses)
    for i in range(steps):
        _, gradient = measure(poses, arrays, parts)
        first, second = 0.9 * first + 0.1 * gradient, 0.98 * second + 0.02 * gradient**2
        rate = 0.1 * (1 - i / steps) + 1e-4
        poses = poses - rate * first / (np.sqrt(second) + 1e-4)
    return poses


def anywhere(scene: Scene, rng: np.random.Generator) -> np.ndarray:
    """Return random poses, half of them anywhere in and around a room, half of them in one heap; unused slots are 0."""
    x0, y0, x1, y1 = scene.room.bounds
    poses = rng.uniform((x0 - 0.5, y0 - 0.5, -math.pi), (x1 + 0.5, y1 + 0.5, math.pi), (STARTS, SLOTS, 3))
    poses[STARTS // 2 :, :, :2] = (x0 + x1) / 2, (y0 + y1) / 2
    poses[STARTS // 2 :, :, :2] += rng.normal(0.0, 0.8, (STARTS // 2, SLOTS, 2))
    poses[:, len(scene.assets) :] = 0.0
    return poses


@cache
def case(name: str, variant: int) -> Case:
    """Return a statement of the relation of that name; variant 0 is its own example in a rectangular room."""
    kind = RELATIONS[name]
    rng = np.random.default_rng([variant, *name.encode()])
    scene = scene_of(kind.example, rng, tuple(ROOMS)[variant % len(ROOMS)])
    relation = read_program(kind.example, scene).statements[0].relation
    if variant:
        scene = moved_scene(scene, rng.uniform(0, math.tau), (3.0, -2.0))
        relation = vary(relation, scene, rng, 1.0 if variant == 1 else 0.5)
    problem = flat_problem(scene, relation)
    arrays, random = stage_arrays(problem), anywhere(scene, rng)
    if relation.as_guessed:
        start = [(pose.x, pose.y, pose.yaw) for pose in (problem.guess[asset.name] for asset in scene.assets)]
        others = [i for i, asset in enumerate(scene.assets) if asset.name not in set(moved_by(relation))]
        random[:, others] = np.array(start)[others]
    satisfied = descend(random, arrays, *STATED)
    return Case(scene, relation, problem.guess, arrays, satisfied, random)


def turn(x: float, y: float, angle: float, shift: tuple[float, float]) -> tuple[float, float]:
    c, s = math.cos(angle), math.sin(angle)
    return (c * x - s * y + shift[0], s * x + c * y + shift[1])


def moved_scene(scene: Scene, angle: float, shift: tuple[float, float]) -> Scene:
    vertices = tuple(turn(*vertex, angle, shift) for vertex in scene.room.vertices)
    return replace(scene, room=replace(scene.room, vertices=vertices))


def moved_layout(layout: Layout, angle: float, shift: tuple[float, float]) -> Layout:
    """Return the layout turned about the origin, then shifted."""
    poses = {}
    for name, pose in layout.items():
        x, y = turn(pose.x, pose.y, angle, shift)
        poses[name] = replace(pose, x=x, y=y, yaw=pose.yaw + angle)
    return Layout(poses)


def moved_relation(relation: Relation, angle: float, shift: tuple[float, float]) -> Relation:
    """Return the relation with its fixed points moved along."""

    def moved(value: object) -> object:
        if isinstance(value, tuple):
            return tuple(moved(item) for item in value)
        return PointRef(*turn(value.x, value.y, angle, shift), value.z) if isinstance(value, PointRef) else value

    return replace(relation, **{f.name: moved(getattr(relation, f.name)) for f in dataclasses.fields(relation)})
