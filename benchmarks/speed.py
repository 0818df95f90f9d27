"""Seconds: of the command, of its stations, of solving, and how they grow; each in a fresh process with a fresh cache."""

from __future__ import annotations

import json
import os
import resource
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks.examples import ROOMS, ROOT
from benchmarks.measures import watch
from benchmarks.store import Row
from benchmarks.tables import Rows, plot, table
from robolayout.solve import solver_names

COUNTS = (10, 20, 40, 80)
BUCKETS = (8, 16, 32, 64, 128)
SOLVER_ROOMS = ("bedroom.json", "tasks/classroom_crowded.json")
"""Examples with 14 and 79 assets on which the command's solvers are timed."""
REPEATS = 5
PUBLISHED_STEPS = 400


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield processes, stations and growth."""
    bedroom = str(ROOT / "examples" / "bedroom.json")
    python, command = [sys.executable, "-c"], [sys.executable, "-m", "robolayout"]
    yield "process/import robolayout", partial(process, [*python, "import robolayout"])
    yield "process/robolayout --help", partial(process, [*command, "--help"])
    yield "process/robolayout agents", partial(process, [*command, "agents"])
    run = [*command, "generate", bedroom, "--agent", "wheelchair", "--quiet"]
    yield "process/first generate, empty cache", partial(process, run, repeats=1)
    yield "process/later generate", partial(process, run, warm=True)
    yield "process/later generate, no pictures", partial(process, [*run, "--no-pictures"], warm=True)
    for name in () if quick else solver_names():
        for room in SOLVER_ROOMS:
            solved = [*command, "generate", str(ROOT / "examples" / room), "--solver", name, "--no-pictures", "--quiet"]
            yield f"process/{name}/{room}", partial(process, solved, repeats=1, warm=True)
    if not quick:
        demo = f"git clone -q {shlex.quote(str(ROOT))} demo && make -C demo demo"
        yield "process/make demo, clean clone, installation included", partial(process, ["sh", "-c", demo], repeats=1)
    for room in ROOMS[:1] if quick else ROOMS:
        yield f"stations/{room}", partial(in_child, "stations", room)
    for slots in BUCKETS[:1] if quick else BUCKETS:
        yield f"bucket/{slots}", partial(in_child, "bucket", str(slots))
    yield "shared/rooms", partial(in_child, "shared", "2" if quick else "12")
    for count in COUNTS[:1] if quick else COUNTS:
        yield f"growth/{count} assets", partial(in_child, "growth", str(count))


def process(words: list[str], *, repeats: int = REPEATS, warm: bool = False) -> Row:
    """Return the median seconds of a process; `warm` runs it once before, so that what compiles is there."""
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"ROBOLAYOUT_CACHE": str(Path(folder, "cache")), "PYTHONPATH": str(ROOT)}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)  # set here it would have every run compile all sources again
        walls: list[float] = []
        cpus: list[float] = []
        for i in range(repeats + warm):
            before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
            done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True)
            after, ended = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
            if done.returncode not in (0, 1) or "Traceback" in done.stderr:
                raise RuntimeError(f"{words} failed: {done.stderr[-600:]}")
            if i >= warm:
                walls.append(ended - began)
                cpus.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return {"wall": sorted(walls)[len(walls) // 2], "cpu": sorted(cpus)[len(cpus) // 2], "runs": len(walls)}


def in_child(what: str, which: str) -> Row:
    """Return the row that this module prints when it is run on its own in a fresh process with an empty cache."""
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"ROBOLAYOUT_CACHE": str(Path(folder, "cache"))}
        words = [sys.executable, "-m", "benchmarks.speed", what, which]
        done = subprocess.run(words, cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout.splitlines()[-1])


def stations(room: str) -> Row:
    """Return wall and CPU seconds of each station of a warm run, and of the first one in all."""
    import robolayout as rl
    from benchmarks.measures import generated

    scene = ROOT / "examples" / f"{room}.json"
    first = generated(scene, agent="wheelchair", seed=0)
    made = rl.generate(scene, agent="wheelchair", seed=0)
    _one_start(made.scene, made.program)  # waits for what is still compiling behind a room that needed no search
    row = generated(scene, agent="wheelchair", seed=0)
    return row | {"first_wall": first["wall"], "first_cpu": first["cpu"]}


def bucket(slots: str) -> Row:
    """Return seconds of compiling the search for rooms of up to so many assets, and of loading it in the next process."""
    import robolayout as rl
    from benchmarks.rooms import Crowd, crowd
    from robolayout.solve import Effort
    from robolayout.solve.runner import STILL

    scene, program = crowd(Crowd(int(slots), 0.30, 0))
    still = rl.SolverConfig(starts=1, kept=1, route_rounds=0, effort=Effort(nearby=0, mendings=0), polish=STILL)
    with watch() as spent:
        rl.solve(rl.scene_from_dict(scene), program, config=still)
    return {"slots": int(slots), "wall": spent.wall, "cpu": spent.cpu}


def shared(count: str) -> Row:
    """Return how many programs different rooms need between them, solved one after the other from an empty cache."""
    import robolayout as rl
    from robolayout.solve.programs import programs

    files = sorted((ROOT / "examples" / "tasks").glob("*.json"))
    step = max(len(files) // int(count), 1)
    chosen = files[::step][: int(count)]
    sizes: list[int] = []
    for file in chosen:
        scene = rl.load_scene(file)
        sizes.append(len(scene.assets))
        rl.generate(scene, attempts=1)
    return {"rooms": len(chosen), "assets": sizes, "programs": len(programs().keys())}


def growth(count: str) -> Row:
    """Return seconds of solving a room 30 % full: first (compiling), then the median of warm runs; without reach and routes, too.

    *nobody*: the solver knows no body that could be kept out, its layout is then verified for the disc.
    """
    from dataclasses import replace

    import robolayout as rl
    from benchmarks.bodies import NOBODY
    from benchmarks.rooms import Crowd, crowd

    made, program = crowd(Crowd(int(count), 0.30, 0))
    scene = rl.scene_from_dict(made)
    asked = rl.read_program(program, scene)
    from robolayout.solve import Effort

    default = rl.SolverConfig()
    row: Row = {"assets": int(count)}
    for name, seen, config in (
        ("routes", scene, default),
        ("nobody", scene.with_agents(rl.load_agent(NOBODY)), default),
        ("no_routes", scene, replace(default, route_rounds=0, effort=Effort(nearby=0, mendings=0))),
    ):
        seconds: list[tuple[float, float]] = []
        for seed in range(REPEATS + 1):
            with watch() as spent:
                found = rl.solve(seen, program, seed=seed, config=config)
                rl.verify(scene, found.layout, asked)
            seconds.append((spent.wall, spent.cpu))
        warm = sorted(seconds[1:])[REPEATS // 2]
        row |= {f"{name}_first": seconds[0][0], f"{name}_wall": warm[0], f"{name}_cpu": warm[1]}
    return row | {"start_cpu": _one_start(scene, asked)}


def _one_start(scene: Any, asked: Any) -> float:
    """Return CPU seconds of one start of as many gradient steps as the published code takes, 16 of them measured."""
    import numpy as np

    import robolayout as rl
    from robolayout.solve.compile import compile_problem
    from robolayout.solve.config import SearchConfig
    from robolayout.solve.runner import Runner
    from robolayout.solve.stage import make_stage

    problem = compile_problem(scene, rl.reconcile(asked, scene).program)
    stage = make_stage(problem, 0, problem.start)
    phase = SearchConfig(steps=PUBLISHED_STEPS, rate=0.02, final_rate=0.0005)
    runner, worlds = Runner(rl.SolverConfig()), np.repeat(problem.start[None], 16, axis=0)
    runner.advance(stage, worlds, phase, "")  # loads or compiles the program
    with watch() as spent:
        runner.advance(stage, worlds, phase, "")
    return spent.cpu / 16


if __name__ == "__main__":
    made = {"stations": stations, "bucket": bucket, "shared": shared, "growth": growth}[sys.argv[1]](sys.argv[2])
    sys.stdout.write(json.dumps(made) + "\n")


def section(rows: Rows, images: Path) -> str:
    """Return the tables of seconds and draw how they grow."""
    parts = ["## Speed\n"]
    commands = [
        [k.partition("/")[2], f"{r['wall']:.2f}", f"{r['cpu']:.2f}"]
        for k, r in rows.items()
        if k.startswith("process/")
    ]
    parts.append(table(["a new process", "wall s", "CPU s"], commands))
    names = ("scene", "plan", "program", "solve", "verify")
    lines: list[list[str]] = []
    for key, row in rows.items():
        if key.startswith("stations/"):
            cells = [f"{row.get(f'{n}_wall', 0.0):.2f} / {row.get(f'{n}_cpu', 0.0):.2f}" for n in names]
            lines.append([f"{key[9:].replace('_', ' ')}, {row['assets']} assets", f"{row['first_wall']:.1f}", *cells])
    parts.append(table(["station, warm: wall / CPU s", "first run, in all", *names], lines))
    compiled = [
        [f"up to {r['slots']} assets", f"{r['wall']:.1f}", f"{r['cpu']:.1f}"]
        for r in sorted((row for key, row in rows.items() if key.startswith("bucket/")), key=lambda row: row["slots"])
    ]
    parts.append(table(["compiling the search, import of JAX included", "wall s", "CPU s"], compiled))
    for key, row in rows.items():
        if key.startswith("shared/"):
            sizes = ", ".join(map(str, row["assets"]))
            parts.append(
                f"{row['rooms']} rooms with {sizes} assets, laid out one after the other from an empty cache, "
                f"needed {row['programs']} compiled programs between them.\n"
            )
    grown = sorted((row for key, row in rows.items() if key.startswith("growth/")), key=lambda row: row["assets"])
    heads = [
        "solve and verify, blind program, 30 % filled",
        "first s",
        "warm s",
        "warm CPU s",
        "for nobody, warm s",
        "without routes and repair, warm s",
        "one start of 400 steps, CPU s",
        "the published code's, CPU s",
    ]
    names = ("routes_first", "routes_wall", "routes_cpu", "nobody_wall", "no_routes_wall")
    cells = [
        [
            f"{r['assets']} assets",
            *(f"{r[n]:.2f}" for n in names),
            f"{r['start_cpu']:.4f}",
            PUBLISHED.get(r["assets"], "-"),
        ]
        for r in grown
    ]
    parts.append(table(heads, cells))
    parts.append(
        "*For nobody*: the solver knows no body that could be kept out; what it finds is verified for the disc all the same. "
        "The published code was run by us on other rooms with one CPU thread, drawing off.\n"
    )
    if len(grown) > 1:
        curves = {"for a disc": "routes_wall", "for nobody": "nobody_wall", "no routes, no repair": "no_routes_wall"}
        lines_xy = {label: [(r["assets"], r[name]) for r in grown] for label, name in curves.items()}
        parts.append(plot(images / "benchmark-growth.png", lines_xy, ("assets", "seconds, warm"), logarithmic=True))
    return "\n".join(parts)


PUBLISHED = {10: "10 to 13", 40: "99 to 131 (42 assets)", 80: "184 to 334 (66 assets)"}
"""CPU seconds of one start of the published solvers by number of assets: their variants, on the rooms nearest in size."""
