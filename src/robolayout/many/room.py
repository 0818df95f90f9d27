"""One room of a batch: drawn from its number, laid out, judged, and written to bytes; nothing else decides what it is.

    for result in rooms({"rooms": ["bedroom", "office"], "count": 8}, seed=1):
        ...
    rooms("many.toml")[731]

A room is a function of the SPEC, its number and its try, so every worker on every machine makes the same one.
"""

from __future__ import annotations

import hashlib
import json
import re
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from robolayout._errors import InputError, RoboLayoutError
from robolayout._files import write_atomic
from robolayout.export import export_all
from robolayout.many.index import PAGES
from robolayout.many.spec import Ready, RoomSource, Spec, read_spec
from robolayout.many.variety import Thing, things
from robolayout.planners import scene_from_sentence
from robolayout.render import draw_plan, png_bytes
from robolayout.run.flow import generate
from robolayout.run.folder import RunFolder
from robolayout.run.outputs import export_options, write_files, write_plain
from robolayout.run.result import Clock, Result
from robolayout.scene import Agent, Scene, layout_digest, load_agent, scene_digest, scene_from_dict, scene_to_dict
from robolayout.solve import SolverConfig
from robolayout.verify import Report, verify

SAID = {
    "size": re.compile(r"\d\s*(x|\u00d7|by|m2|m\u00b2|m\b|sqm|square|metre|meter|cm|ft|feet|foot|')", re.IGNORECASE),
    "height": re.compile(r"\b(high|height|tall|ceiling)\b", re.IGNORECASE),
    "shape": re.compile(r"\b([lut]-?shaped|square|round|rectangular)\b", re.IGNORECASE),
    "doors": re.compile(r"\bdoors?\b", re.IGNORECASE),
    "windows": re.compile(r"\bwindows?\b", re.IGNORECASE),
}
"""What a sentence says itself is not drawn."""

NOBODY = {"name": "nobody", "radius": 0.001, "height": 0.05, "step": 0.03, "reach": 20.0, "reach_high": 20.0}
"""A body so small that nothing is in its way, for a search that is to know none."""

GRID = 0.05  # metres to which drawn lengths are rounded, as people say them
NOTE = "room.json"  # A room's row in the index, with what else is needed to go on after a stop


@dataclass(frozen=True)
class Drawn:
    """One room as it was drawn, not yet laid out."""

    scene: Scene  # the room with its things and bodies
    solver: str  # name of the solver
    reach: bool  # whether the search knows the bodies
    seed: int  # settles plan and looks
    facts: Mapping[str, Any]  # what was drawn, for the index


_Tried = str | tuple[Drawn, Result]  # why a try is not kept, or what it came to


@dataclass(frozen=True)
class Made:
    """What became of one try at a room."""

    why: str  # why it is not kept; empty if it is
    row: Mapping[str, Any] = field(default_factory=dict[str, Any])  # its row in the index
    things: tuple[Thing, ...] = ()  # what stands where, to tell rooms apart
    files: Mapping[str, bytes] = field(default_factory=dict[str, bytes])  # its files by name
    # CPU seconds by station, and the most memory of the process in MB
    seconds: Mapping[str, float] = field(default_factory=dict[str, float])


def draw(ready: Ready, index: int, attempt: int = 0, meshes: Path | None = None) -> Drawn:
    """Return room number `index` as it is drawn at its `attempt`-th try.

    Where combinations are compared, all of them get the same rooms.

    Args:
        meshes: Folder of the meshes of the catalogues.

    Raises:
        InputError: This draw is no room (its things do not fit); the next one may be.
    """
    turn, which = divmod(index, len(ready.sources))
    chosen: list[Any] = []
    if ready.spec.each:
        for found in ready.choices:
            turn, number = divmod(turn, len(found))
            chosen.append(found[number])
    rng = np.random.default_rng((ready.spec.seed, which, turn, attempt))
    for found in () if chosen else ready.choices:
        chosen.append(found[int(rng.integers(len(found)))])
    bodies, style, dress, solver, reach = chosen
    source = ready.sources[which]
    seed = int(rng.integers(2**31))
    scene = source.scene or _from_words(source, ready.spec, rng, seed, style, bodies)
    if ready.own and meshes is not None:
        scene = _with_own(scene, ready.own, rng, meshes)
    scene = scene.with_agents(*bodies) if bodies and source.scene else scene
    scene = replace(scene, dress=dress) if dress else scene
    facts = {
        "source": source.text, "style": style, "dress": scene.dress, "solver": solver, "reach": reach, "seed": seed,
    }  # fmt: skip
    facts |= {"bodies": ",".join(agent.name for agent in scene.agents), "text": scene.task_description}
    return Drawn(scene, solver, reach, seed, facts)


def _from_words(
    source: RoomSource, spec: Spec, rng: np.random.Generator, seed: int, style: str, bodies: Sequence[Agent]
) -> Scene:
    """Return the scene of a sentence to which everything is added that it leaves open."""
    width, depth = source.size
    ranges = (spec.area, spec.ratio, spec.height, spec.density)
    area, ratio, height, density = (float(rng.uniform(*bounds)) for bounds in ranges)
    doors, windows = (int(rng.integers(low, high + 1)) for low, high in (spec.doors, spec.windows))
    bent = rng.random() < spec.l_shaped
    floor, relation = width * depth * area, width / depth * ratio
    width, depth = (_rounded(side) for side in ((floor * relation) ** 0.5, (floor / relation) ** 0.5))
    drawn = {
        "shape": "in an L-shaped room" if bent else "",
        "size": f"{width:g} x {depth:g} m",
        "height": f"{_rounded(height):g} m high",
        "doors": f"with {doors} door{'s' * (doors > 1)}",
        "windows": f"with {windows} window{'s' * (windows > 1)}",
    }
    added = [words for key, words in drawn.items() if words and not SAID[key].search(source.sentence)]
    text = ", ".join([source.sentence, *added, *([f"{style} style"] if style else [])])
    return scene_from_sentence(text, seed=seed, fill=density, agents=bodies)[0]


def _rounded(length: float) -> float:
    return round(round(length / GRID) * GRID, 2)


def _with_own(
    scene: Scene, own: Mapping[str, Sequence[Mapping[str, Any]]], rng: np.random.Generator, meshes: Path
) -> Scene:
    """Return a scene in which things of the catalogues stand for those of their kind; equal things stay equal."""
    data = scene_to_dict(scene)
    assets: dict[str, dict[str, Any]] = data["assets"]  # type: ignore[assignment]
    kinds = sorted({str(entry["category"]) for entry in assets.values()} & set(own))
    chosen = {kind: own[kind][int(rng.integers(len(own[kind])))] for kind in kinds}
    for entry in assets.values():
        entry.update(chosen.get(entry["category"], {}), category=entry["category"])
    return replace(scene_from_dict(data, name=scene.name, asset_dir=meshes), agents=scene.agents)


def laid_out(drawn: Drawn, effort: str, *, trace: bool = False) -> Result:
    """Return a drawn room laid out and judged."""
    config = SolverConfig(trace=trace).at(effort)
    if drawn.reach:
        return generate(drawn.scene, seed=drawn.seed, solver=drawn.solver, config=config)
    blind = drawn.scene.with_agents(load_agent(NOBODY))
    result = generate(blind, seed=drawn.seed, solver=drawn.solver, config=config)
    scene = result.scene.with_agents(*drawn.scene.agents)
    report = replace(verify(scene, result.layout, result.program), asked=result.report.asked)
    return replace(result, scene=scene, report=report)


def tried(ready: Ready, index: int, attempt: int, meshes: Path | None, clock: Clock, *, trace: bool) -> _Tried:
    """Return a room as one try at it is drawn and laid out, or why it is not kept; seconds are told by the clock alone."""
    try:
        with clock.station("draw"):
            drawn = draw(ready, index, attempt, meshes)
        with clock.station("generate"):
            result = laid_out(drawn, ready.spec.effort, trace=trace)
    except RoboLayoutError as error:
        return str(error).splitlines()[0]
    clock.seconds |= {name: dict(seconds) for name, seconds in result.report.timing.items()}
    why, report = list[str](), result.report
    if not ready.spec.keep_unmet:  # which demands are not met, in a few words
        asked = (f"asked: {row.words}" for row in report.asked if row.verdict == "unmet")
        impossible = ["impossible for the body"] if any(one.impossible for one in report.agents) else []
        why = [*report.unmet, *impossible, *asked]
    return ", ".join(why) or (drawn, replace(result, report=replace(report, timing={})))


def make(ready: Ready, index: int, attempt: int, meshes: Path | None = None) -> Made:
    """Return what becomes of one try at a room: its files, or why there are none."""
    spec, clock = ready.spec, Clock()
    found = tried(ready, index, attempt, meshes, clock, trace=spec.pictures)
    if isinstance(found, str):
        return Made(found, seconds=_spent(clock))
    drawn, result = found
    with clock.station("write"):
        files, whole = _files(result, spec, drawn.seed, meshes), hashlib.sha256()
    for name, data in sorted(files.items()):
        whole.update(f"{name}\n{len(data)}\n".encode() + data)
    row = {**drawn.facts, "attempt": attempt, **figures(result.report), "sha256": whole.hexdigest()}
    return Made("", row, things(result.scene, result.layout), files, _spent(clock))


def _files(result: Result, spec: Spec, looks: int, meshes: Path | None) -> dict[str, bytes]:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        home = meshes or folder  # meshes that rooms share are named from their own folder, wherever the batch lies
        if spec.files == "run":
            write_files(result, RunFolder(home, folder), pictures=spec.pictures, formats=spec.formats, looks=looks)
        else:
            write_plain(result, folder, home)
            options = replace(export_options(result.report), seed=looks)
            export_all(result.scene, result.layout, spec.formats, folder=folder, options=options, partial=True)
        made = (path for path in sorted(folder.rglob("*")) if path.is_file())
        found = {path.relative_to(folder).as_posix(): path.read_bytes() for path in made}
    if "top.png" in found:
        picture = Image.open(BytesIO(found["top.png"])).convert("RGB")
    else:  # the plan costs a fifth
        picture = draw_plan(result.scene, result.layout, names=False).image(2 * PAGES.thumb)
    picture.thumbnail((PAGES.thumb, PAGES.thumb), Image.Resampling.LANCZOS)
    return found | {"thumb.png": png_bytes(picture.quantize(64))}


def figures(report: Report) -> dict[str, Any]:
    """Return every figure of a report in one row: size and counts, ours, and the published ones under their own names."""
    scene = report.scene
    left, front, right, back = scene.room.bounds
    width, depth = right - left, back - front
    row: dict[str, Any] = {"name": scene.name, "ok": report.ok, "width": round(width, 3), "depth": round(depth, 3)}
    row |= {"area": round(scene.room.area, 3), "height": scene.room.wall_height, "corners": len(scene.room.vertices)}
    row |= {"doors": len(scene.room.doors), "windows": len(scene.room.windows), "things": len(scene.assets)}
    row |= {"kinds": len({asset.category for asset in scene.assets}), "violations": len(report.violations)}
    row |= {**report.figures, "asked_met_share": report.asked_met_share, "statements": len(report.statements)}
    row["short"] = sum(len(body.short) for body in report.agents)
    row["exempt"] = sum(len(body.exempt) for body in report.agents)
    for benchmark, found in report.metrics.items():
        row |= {f"{benchmark}_{key}": value for key, value in found.items() if isinstance(value, int | float)}
    return row | {"scene_hash": scene_digest(scene), "layout_hash": layout_digest(report.layout)}


def _spent(clock: Clock) -> dict[str, float]:
    """Return CPU seconds by station, with the memory of the process."""
    import resource

    spent = {name: seconds["cpu"] for name, seconds in clock.seconds.items()}
    return spent | {"memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024}


class Rooms(Sequence[Result]):
    """The rooms of a SPEC, made when they are asked for; the same number is the same room."""

    def __init__(self, ready: Ready, meshes: Path | None = None) -> None:
        self.ready, self.meshes = ready, meshes

    def __len__(self) -> int:
        return self.ready.count

    def __getitem__(self, index: Any) -> Any:
        """Return a room by its number, counted from the end if below 0, or a list of those of a slice."""
        if isinstance(index, slice):
            return [self[number] for number in range(*index.indices(len(self)))]
        number = range(len(self))[index]
        why = ""
        for attempt in range(self.ready.spec.tries):
            found = tried(self.ready, number, attempt, self.meshes, Clock(), trace=False)
            if not isinstance(found, str):
                return found[1]
            why = found
        tries = self.ready.spec.tries
        raise InputError(f"room {number} does not meet its demands in {tries} tries ({why}); ask for less of it.")

    def __repr__(self) -> str:
        return f"Rooms({len(self)} of {json.dumps([source.text for source in self.ready.sources])})"


def rooms(spec: str | Path | Mapping[str, Any], seed: int | None = None) -> Rooms:
    """Return the rooms of a SPEC as a sequence that makes each one when asked for; raises `InputError` for a SPEC it cannot read."""
    ready = read_spec(spec, **({} if seed is None else {"seed": seed}))
    meshes = shelved(ready, Path(tempfile.mkdtemp(prefix="robolayout-meshes-"))) if ready.meshes else None
    return Rooms(ready, meshes)


def shelved(ready: Ready, folder: Path) -> Path:
    """Put the meshes of the catalogues into a folder, under the paths by which rooms name them, and return it."""
    for name, path in ready.meshes.items():
        target = folder / name
        if not target.is_file():
            write_atomic(target, path.read_bytes())
    return folder
