"""docs/benchmarks.md and its plots, from the results on disk."""

from __future__ import annotations

import io
import json
import re
import statistics
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from benchmarks.examples import BODIES, ROOMS, ROOT
from benchmarks.measures import SHARES
from benchmarks.store import Row
from benchmarks.vlm import MODES, WAYS
from robolayout._files import write_atomic

RESULTS = ROOT / "benchmarks" / "results"
PAGE = ROOT / "docs" / "benchmarks.md"
PUBLISHED = {10: "10 to 13", 40: "99 to 131 (42 assets)", 80: "184 to 334 (66 assets)"}
"""CPU seconds of one start of the published solvers by number of assets: their variants, on the rooms nearest in size."""
HEADS = [name.removesuffix("_share").replace("_", " ") for name in SHARES]
Rows = dict[str, Row]


def write(results: Path, target: Path) -> None:
    """Write the page and its plots from whatever results there are."""
    parts = [
        "# Benchmarks\n\nWritten by `python -m benchmarks` (`make bench`) from `benchmarks/results/`; do not edit. "
        "Shares are means; what they mean is on the page about [the report](report.md).\n"
        "Each section is measured on its own and may be older than the last change of the code: "
        "the history of its file in `benchmarks/results/` tells, and `--fresh` measures it again.\n"
    ]
    for name, section in SECTIONS.items():
        file = results / f"{name}.json"
        if file.exists():
            data = json.loads(file.read_text(encoding="utf-8"))
            parts += [
                section(data["rows"], target.parent / "images"),
                f"*{data['machine']}, version {data['version']}.*\n",
            ]
        else:
            parts.append(f"*Section {name!r} has not been measured: `python -m benchmarks --section {name}`.*\n")
    write_atomic(target, "\n".join(parts))


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table in Markdown, figures to the right."""
    lines = [heads, ["---", *["---:"] * (len(heads) - 1)], *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def mean(rows: Sequence[Row], name: str) -> float:
    """Return the mean of a figure."""
    return statistics.fmean(float(row[name]) for row in rows)


def shares(rows: Sequence[Row]) -> list[str]:
    """Return the cells of all shares; 1.00 is written only where every run has it."""
    return [f"{min(mean(rows, name), 0.99 if any(row[name] < 1.0 for row in rows) else 1.0):.2f}" for name in SHARES]


def summary(rows: Sequence[Row]) -> list[str]:
    """Return the cells of how many runs there are, how many meet the hard demands, how many all, and the shares."""
    return [str(len(rows)), *(f"{mean(rows, name):.0%}" for name in ("hard_ok", "ok")), *shares(rows)]


def select(rows: Rows, keep: Callable[[list[str]], bool]) -> list[Row]:
    """Return the rows whose key, split at slashes, is wanted."""
    return [row for key, row in rows.items() if keep(key.split("/"))]


def examples(rows: Rows, images: Path) -> str:
    """Return the table of the four examples."""
    lines: list[list[str]] = []
    for room in ROOMS:
        for body in BODIES:
            found = select(rows, lambda key, room=room, body=body: key[:2] == [room, body])
            if found:
                met = f"{sum(row['ok'] for row in found)} of {len(found)}"
                notes = f"{max(row['exempt'] for row in found)}"
                lines.append(
                    [f"{room.replace('_', ' ')}, {body}", met, *shares(found), notes, f"{mean(found, 'wall'):.1f}"]
                )
    heads = ["room and body", "all demands met", *HEADS, "not asked", "seconds"]
    note = (
        "*Not asked*: assets that no layout can bring into the reach of this body (a picture for a vacuum cleaner, "
        "a mirror for a child); they lower reachable and usable, and the report says why.\n"
    )
    return f"## The examples, four bodies, five seeds\n\n{table(heads, lines)}\n{note}"


def tasks(rows: Rows, images: Path) -> str:
    """Return one line per task: all bodies and seeds together, with the bodies that are short of something."""
    groups: dict[str, dict[str, Row]] = {}
    for key, row in rows.items():
        groups.setdefault(key.split("/")[0], {})[key.partition("/")[2]] = row
    lines: list[list[str]] = []
    for task, runs in groups.items():
        found = list(runs.values())
        short = ", ".join(key.replace("/", " seed ") for key, row in runs.items() if not row["ok"])
        met = f"{sum(row['ok'] for row in found)} of {len(found)}"
        seconds = f"{mean(found, 'cpu'):.1f}"
        lines.append([task.replace("_", " "), str(found[0]["assets"]), met, *shares(found), seconds, short or "-"])
    heads = ["task", "assets", "all demands met", *HEADS, "CPU s", "not all met for"]
    intro = (
        "Each for the disc of 0.30 m, a wheelchair user, and the body that the task names, if it names one; up to three "
        "seeds. Reachable and usable count what no layout brings within reach, too.\n"
    )
    return f"## The tasks\n\n{intro}\n{table(heads, lines)}"


def bodies(rows: Rows, images: Path) -> str:
    """Return the table of all bodies and the table of what the ways to mind reach are worth."""
    groups: dict[str, list[Row]] = {}
    ways: dict[str, list[Row]] = {}
    for key, row in rows.items():
        kind, first, second, *_ = key.split("/")
        (groups if kind == "shares" else ways).setdefault(
            first if kind != "shares" else f"{first}/{second}", []
        ).append(row)
    names = ("walkable_ratio", "reachable_share", "usable_share")
    lines: list[list[str]] = []
    for key, found in groups.items():
        body, _, room = key.partition("/")
        met = f"{sum(row['ok'] for row in found)} of {len(found)}"
        why = f"{max(row['impossible'] for row in found)}"
        cells = [f"{mean(found, name):.2f}" for name in (*names, "exempt", "short")]
        lines.append(
            [f"{body.replace('_', ' ')}, {room.replace('_', ' ')}", met, *cells, why, f"{mean(found, 'wall'):.1f}"]
        )
    heads = [
        "body and room",
        "all demands met",
        "walkable",
        "reachable",
        "usable",
        "not asked",
        "short",
        "impossible",
        "s",
    ]
    intro = (
        "*Not asked*: assets that no layout brings within this body's reach; *short*: assets that it should reach or use "
        "and does not; *impossible*: what no layout could do (a forklift through a house door). *crowded*: 10 assets on "
        "40 % of the floor.\n"
    )
    text = f"## Fifteen bodies\n\n{intro}\n{table(heads, lines)}\n"
    if ways:
        heads = ["what minds the body", "runs", "hard demands met", "all demands met", *HEADS, "seconds"]
        cells = [[way, *summary(found), f"{mean(found, 'wall'):.1f}"] for way, found in ways.items()]
        text += (
            "The planner's statements without its guesses, solved once; *no reach*: the solver knows no body, its layout is "
            f"judged for one.\n\n{table(heads, cells)}\n{_by_body(rows)}"
        )
    return text


def _by_body(rows: Rows) -> str:
    """Return what each way to mind reach gives each body: walkable, reachable, usable."""
    cells: dict[str, dict[str, list[Row]]] = {}
    for key, row in rows.items():
        kind, way, body, *_ = key.split("/")
        if kind == "reach":
            cells.setdefault(body.replace("_", " "), {}).setdefault(way, []).append(row)
    ways = list(dict.fromkeys(way for found in cells.values() for way in found))
    names = ("walkable_ratio", "reachable_share", "usable_share")
    lines = [
        [
            body,
            *(" / ".join(f"{mean(found[way], name):.2f}" for name in names) if way in found else "-" for way in ways),
        ]
        for body, found in cells.items()
    ]
    return "Walkable / reachable / usable by body:\n\n" + table(["body", *ways], lines)


def speed(rows: Rows, images: Path) -> str:
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


def crowded(rows: Rows, images: Path) -> str:
    """Return the table of crowded rooms and draw how often all demands are met."""
    groups: dict[str, list[Row]] = {}
    for key, row in rows.items():
        groups.setdefault(key.rpartition("/")[0], []).append(row)
    heads = ["program / solver / room", "rooms", "hard demands met", "all demands met", *HEADS, "CPU s"]
    lines = [[name.replace("/", ", "), *summary(found), f"{mean(found, 'cpu'):.1f}"] for name, found in _sorted(groups)]
    intro = (
        "Rooms made by rule (`benchmarks/rooms.py`), default disc of 0.30 m. *program*: a program with blind guesses, "
        "walls asked without thinking; *planned*: the offline planner writes it. "
        "Hard demands: placed, no collision, inside, supported, doors clear.\n"
    )
    curves: dict[str, list[tuple[float, float]]] = {}
    for name, found in groups.items():
        who, solver, size, fill, *extra = name.split("/")
        if not extra and solver == "default":
            curves.setdefault(f"{who}, {size}", []).append((float(fill.rstrip("%")), 100 * mean(found, "ok")))
    picture = plot(images / "benchmark-crowded.png", curves, ("floor filled, %", "rooms with all demands met, %"))
    return f"## Crowded rooms\n\n{intro}\n{table(heads, lines)}\n{picture}"


def ablation(rows: Rows, images: Path) -> str:
    """Return the table of what each part is worth."""
    groups: dict[tuple[str, str], dict[str, Row]] = {}
    for key, row in rows.items():
        name, family, case = key.split("/", 2)
        groups.setdefault((family, name), {})[case] = row
    heads = ["family", "solver", "runs", "hard demands met", "all demands met", "reachable", "usable", "statements met"]
    heads += ["moved, m", "CPU s", "other layouts than the default's", "made by"]
    lines: list[list[str]] = []
    for (family, name), found in sorted(
        groups.items(), key=lambda item: (item[0][0], item[0][1] != "default", item[0])
    ):
        runs, plain = list(found.values()), groups[family, "default"]
        shares = [f"{mean(runs, n):.2f}" for n in ("reachable_share", "usable_share", "statements_met_share", "moved")]
        other = sum(row["layout"] != plain[case]["layout"] for case, row in found.items())
        lines.append([family, name, *summary(runs)[:3], *shares, f"{mean(runs, 'cpu'):.1f}", str(other), _phases(runs)])
    intro = (
        "The solver without one of its parts, or with other numbers of starts (the default has 16): crowded rooms with blind "
        "guesses, examples for a wheelchair with the planner's statements but no guesses, tasks with a model's rough guess "
        "(below); one attempt each. A row that makes no other layouts than the default changes nothing in its family: where the "
        "planner's statements are built right at once, none does.\n"
    )
    return f"## What each part is worth\n\n{intro}\n{table(heads, lines)}"


def _phases(runs: list[Row]) -> str:
    """Return which phases made the winning layouts, and how often."""
    counts = Counter(row["phase"] for row in runs)
    return ", ".join(
        f"{phase} {count}" for phase, count in sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    )


def paper(rows: Rows, images: Path) -> str:
    """Return the table of the paper's experiments, by solver and whether it knows the body."""
    groups: dict[str, list[Row]] = {}
    for key, row in rows.items():
        _, solver, reach, _ = key.split("/")
        groups.setdefault(f"{solver}, {reach}", []).append(row)
    heads = ["solver", "runs", "hard demands met", "all demands met", *HEADS, "CPU s"]
    lines = [[name, *summary(found), f"{mean(found, 'cpu'):.1f}"] for name, found in sorted(groups.items())]
    rooms = sorted({key.split("/")[0].replace("_", " ") for key in rows})
    intro = (
        f"`benchmarks/paper.toml`, as far as it has been measured: {', '.join(rooms)}; for the robot that it names. *No reach*: made for "
        "nobody, judged for the body. *Unrefined*: the paper's algorithm without its last step.\n"
    )
    return f"## The paper's experiments\n\n{intro}\n{table(heads, lines)}"


def many(rows: Rows, images: Path) -> str:
    """Return the table of how fast rooms are made side by side, and what a large set is like."""
    side = {key.partition("/")[2]: row for key, row in rows.items() if key.startswith("workers/")}
    alone = side.get("1 process")
    lines: list[list[str]] = []
    for name, row in side.items():
        rate = 60 * row["rooms"] / row["wall"]
        count = int(re.findall(r"\d+", name)[0])
        share = f"{rate / (count * 60 * alone['rooms'] / alone['wall']):.0%}" if alone else "-"
        cells = [f"{rate:.0f}", f"{60 / row['cpu']:.0f}", share, f"{row['cpu']:.2f}"]
        lines.append([name, str(row["rooms"]), *cells, *(f"{row[part]:.2f}" for part in ("draw", "generate", "write"))])
    heads = ["workers", "rooms", "rooms a minute", "a minute and core", "efficiency"]
    heads += ["CPU s a room", "drawing", "laying out", "writing"]
    parts = [
        "## Many rooms\n\nMixed rooms of ten kinds for six bodies, without pictures; start of the workers included.\n"
    ]
    parts.append(table(heads, lines))
    for key, row in rows.items():
        if key.startswith("large/"):
            near, memory = row["near"] / row["tries"], f"{row['first']:.0f} and {row['last']:.0f} MB"
            stations = {"drawing": ("draw",), "planning": ("plan", "program"), "solving": ("solve",)}
            stations |= {"judging": ("verify",), "writing": ("write",)}
            spent = ", ".join(f"{name} {sum(row[part] for part in found):.2f}" for name, found in stations.items())
            parts.append(
                f"{row['rooms']} rooms with {key.partition('/')[2]}: {row['met']} meet all demands, {row['missing']} were given up; "
                f"{row['tries'] - row['rooms']} tries were replaced, {near:.1%} of all as near-duplicates, and none is left (least "
                f"difference {row['least']:.2f}); {row['cpu']:.2f} CPU s a room ({spent}), {60 / row['cpu']:.0f} rooms a minute and core; "
                f"one room is laid out in {row['median']:.1f} s (median), nine of ten within {row['tenth']:.1f} s, the longest took "
                f"{row['longest']:.0f} s; memory of a process over the first and the last hundred {memory}; "
                f"{1000 * row['mb'] / row['rooms']:.0f} kB in {row['files'] / row['rooms']:.0f} files a room.\n"
            )
    return "\n".join(parts)


def rough(rows: Rows, images: Path) -> str:
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
    last = [*means, str(sum(row["needless"] for row in found)), _phases(found), f"{mean(found, 'cpu'):.1f}"]
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


def vlm(rows: Rows, images: Path) -> str:
    """Return the table of what the parts of planning with a model are worth, and what four samples cost the solver."""
    groups = {
        f"{mode}, {way}": found
        for mode in MODES
        for way in WAYS
        if (found := select(rows, lambda key, way=way, mode=mode: key[:2] == [way, mode]))
    }
    heads = ["mode, and what is different", "runs", "hard demands met", "all demands met", *HEADS]
    lines = [
        [
            name,
            *summary(found),
            *(f"{sum(row[n] for row in found)}" for n in ("answers", "unreadable", "asked_again", "taken_over")),
            *(f"{mean(found, n):.1f}" for n in ("solve_wall", "solve_cpu")),
        ]
        for name, found in groups.items()
    ]
    heads += ["answers", "unreadable", "asked again", "taken over", "solver wall s", "solver CPU s"]
    intro = (
        "Six rooms with recorded answers (`tests/planners/recordings`): programs as a strong model writes them, with the faults "
        "of such models. *as it is*: one sample, at most three retries, with the filter. *asked again*: answers to a question "
        "that told what was wrong before. *taken over*: groups for which the offline planner stood in. Means over the runs, "
        "sums of the answers; four samples were recorded for one_shot only. A statement that the filter rejects counts as unmet "
        "unless the layout meets it all the same. *each alone*: every recorded program solved by itself, without asking "
        "again; *4 samples* solves them together and keeps the best, for about the CPU time of one. Others used "
        "the machine meanwhile: its CPU seconds compare, its wall seconds do not.\n"
    )
    return f"## Planning with a model\n\n{intro}\n{table(heads, lines)}"


VIEWS = {
    "gl_load": "loading a room for OpenGL",
    "gl_top": "OpenGL in software, top view, 512 x 512",
    "gl_top_wall": "the same, wall seconds",
    "gl_side": "OpenGL in software, side view, 512 x 512",
    "gl_side_wall": "the same, wall seconds",
    "rays_load": "loading a room for ray casting",
    "rays_top": "ray casting, top view, 512 x 512",
    "rays_side": "ray casting, side view, 512 x 512",
}
"""Figures of the views, and what they are."""


def pictures(rows: Rows, images: Path) -> str:
    """Return the table of what each picture costs."""
    rooms = sorted(rows, key=lambda room: rows[room]["assets"])
    files = dict.fromkeys(key.removesuffix("_cpu") for room in rooms for key in rows[room] if key.endswith("_cpu"))
    lines = [[name, *(_picture(rows[room], name) for room in rooms)] for name in files]
    lines += [[words, *(_figure(rows[room], key, "{:.2f} s") for room in rooms)] for key, words in VIEWS.items()]
    lines.append(["ray casting against OpenGL: mean difference, of 255"])
    lines[-1] += [_figure(rows[room], "differ_mean", "{:.2f}") for room in rooms]
    lines.append(["the same: pixels that differ by more than 32"])
    lines[-1] += [_figure(rows[room], "differ_share", "{:.2%}") for room in rooms]
    heads = ["CPU seconds, size", *(f"{room.replace('_', ' ')}, {rows[room]['assets']} assets" for room in rooms)]
    intro = "Each picture drawn a second time in one process; OpenGL without a graphics card.\n"
    return f"## Pictures\n\n{intro}\n{table(heads, lines)}"


def _picture(row: Row, name: str) -> str:
    if f"{name}_cpu" not in row:
        return "-"
    return f"{row[f'{name}_cpu']:.2f} s, {row[f'{name}_kb']:.0f} kB"


def _figure(row: Row, key: str, form: str) -> str:
    return form.format(row[key]) if key in row else "-"


def exports(rows: Rows, images: Path) -> str:
    """Return the table of what validators and the simulator say."""
    rooms = sorted(rows, key=lambda room: rows[room]["assets"])
    lines: list[list[str]] = []
    for room in rooms:
        row = rows[room]
        glb = f"{row['glb_errors']} / {row['glb_warnings']}" if "glb_errors" in row else "-"
        lines.append([room.replace("_", " "), str(row["assets"]), f"{row['read_back']:.0e}", glb])
        lines[-1] += [_figure(row, "usd_complaints", "{}"), _figure(row, "stable_share", "{:.2f}")]
        lines[-1] += [f"{row['moved_mm']:.1f} mm, {row['tilt']:.2f} degrees"]
        lines[-1] += [f"{row['contacts']} on {row['routes']} routes", f"{row['off_mm']:.1f} mm"]
    heads = ["room", "assets", "read back, largest difference", "GLB errors / warnings", "USD complaints"]
    heads += ["stable share", "moves, tilts at most", "contacts of the driven base", "off its route at most"]
    intro = (
        "Every format written and read back (metres, radians); Khronos' gltf-validator; all validators of the USD library; "
        "URDF and MJCF loaded by MuJoCo; five seconds of gravity, in which a stable asset moves by less than 1 cm and "
        "tilts by less than 2 degrees; the base driven along every route.\n"
    )
    return f"## Exports\n\n{intro}\n{table(heads, lines)}"


def opening(rows: Rows, images: Path) -> str:
    """Return the table of how long `report.html` takes to open."""
    lines: list[list[str]] = []
    for room in sorted(rows, key=lambda room: rows[room]["assets"]):
        row = rows[room]
        times = [_figure(row, key, "{:.2f} s") for key in ("figures", "drawn", "slowest")]
        lines.append([room.replace("_", " "), str(row["assets"]), f"{row['kb']:.0f} kB", *times])
    heads = ["room", "assets", "page", "figures are there", "first picture", "slowest of five"]
    intro = "`report.html` in headless Chromium, 1280 x 800, drawn without a graphics card; medians of five.\n"
    return f"## Opening the page\n\n{intro}\n{table(heads, lines)}"


def fuzz(rows: Rows, images: Path) -> str:
    """Return what each reader made of spoiled files."""
    lines = [
        [
            name,
            *(str(row[key]) for key in ("inputs", "accepted", "refused")),
            f"{1000 * row['slowest']:.0f} ms",
            f"{row['memory_mb']:.0f} MB",
        ]
        for name, row in sorted(rows.items())
    ]
    total = [str(sum(row[key] for row in rows.values())) for key in ("inputs", "accepted", "refused")]
    worst = max(row["slowest"] for row in rows.values()), max(row["memory_mb"] for row in rows.values())
    lines.append(["all", *total, f"{1000 * worst[0]:.0f} ms", f"{worst[1]:.0f} MB"])
    heads = ["reader", "inputs", "accepted", "refused in a sentence", "slowest (CPU)", "memory of the process"]
    intro = (
        "Good files of every kind with values, types, names, nesting, numbers and bytes spoiled, the same in every run "
        "(`tests/fuzz`, `make fuzz`). Each is read or refused in one sentence; another error, 10 s or 1 GB would end the "
        "measurement.\n"
    )
    return f"## Spoiled files\n\n{intro}\n{table(heads, lines)}"


def words(rows: Rows, images: Path) -> str:
    """Return the demands met by kind, for the prompts set aside and those of development, and how the ledger agrees."""
    kinds = ("counts", "relations", "places in the room", "room")
    lines: list[list[str]] = []
    for file, shown in (("held", "set aside"), ("open", "of development")):
        found = select(rows, lambda key, file=file: key[0] == file)
        totals = {
            key: sum(int(row.get(key, 0)) for row in found)
            for kind in kinds
            for key in (f"{kind} met", f"{kind} asked")
        }
        cells = [_of(totals[f"{kind} met"], totals[f"{kind} asked"]) for kind in kinds]
        met, asked = (sum(totals[f"{kind} {word}"] for kind in kinds) for word in ("met", "asked"))
        compared, agreed = (sum(int(row.get(word, 0)) for row in found) for word in ("compared", "agreed"))
        refused = str(sum("refused" in row for row in found))
        if found:
            seconds = f"{statistics.median(row['seconds'] for row in found):.1f}"
            lines.append([f"{len(found)} {shown}", _of(met, asked), *cells, _of(agreed, compared), refused, seconds])
    heads = ["prompts", "all demands", *kinds, "ledger agrees", "refused", "CPU s, median"]
    intro = (
        "Prompts of our own in the manner of published ones, with the demands that a person reads in them "
        "(`benchmarks/prompts/`), checked by a script that knows nothing of the reader. *Ledger agrees*: of the demands "
        "that have a row of the ledger, those to which both give the same verdict.\n"
    )
    return f"## Words\n\n{intro}\n{table(heads, lines)}\n{_words_by_kind(rows)}"


def _words_by_kind(rows: Rows) -> str:
    """Return how many demands of each single kind are met."""
    from benchmarks.words import FILES, RELATIONS, prompts

    asked: dict[str, list[int]] = {}
    for column, file in enumerate(FILES):
        for number, prompt in enumerate(prompts(file)):
            row = rows.get(f"{file}/{number:03}")
            if row is None:
                continue
            unmet = [text.split()[0] for text in str(row.get("unmet", "")).split("; ") if text]
            for demand in prompt.demands:
                counts = asked.setdefault(demand.kind, [0, 0, 0, 0])
                counts[2 * column + 1] += 1
                lost = "refused" in row or demand.kind in unmet
                counts[2 * column] += not lost
                if lost and demand.kind in unmet:
                    unmet.remove(demand.kind)
    lines = [[kind, _of(*asked[kind][:2]), _of(*asked[kind][2:])] for kind in ("count", *RELATIONS) if kind in asked]
    return table(["demand", "set aside", "of development"], lines)


def lists(rows: Rows, images: Path) -> str:
    """Return what a person would object to in rooms made from lists."""
    lines = [
        [
            *key.split("/"),
            "refused" if "refused" in row else "yes" if row["ok"] else "no",
            str(row.get("seats") or "-"),
            str(row.get("soft") or "-"),
            f"{row.get('filled', 0.0):.0%}",
        ]
        for key, row in rows.items()
    ]
    heads = [
        "room",
        "size",
        "all demands met",
        "seats at nothing",
        "hard things on seats",
        "floor within 1.5 m of furniture",
    ]
    intro = (
        "Rooms from lists of names and counts, in three sizes, judged by a person's rules (`benchmarks/lists.py`).\n"
    )
    return f"## Lists\n\n{intro}\n{table(heads, lines)}"


def _of(part: int, whole: int) -> str:
    return f"{part} of {whole} ({part / whole:.0%})" if whole else "-"


SECTIONS: dict[str, Callable[[Rows, Path], str]] = {
    "examples": examples,
    "bodies": bodies,
    "tasks": tasks,
    "speed": speed,
    "crowded": crowded,
    "ablation": ablation,
    "rough": rough,
    "paper": paper,
    "many": many,
    "vlm": vlm,
    "pictures": pictures,
    "exports": exports,
    "opening": opening,
    "fuzz": fuzz,
    "words": words,
    "lists": lists,
}


def plot(
    path: Path, curves: dict[str, list[tuple[float, float]]], labels: tuple[str, str], *, logarithmic: bool = False
) -> str:
    """Draw curves as a PNG and return the line that shows it."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 3.6), layout="constrained")
    axes: Any = figure.subplots()
    for number, (label, points) in enumerate(sorted(curves.items(), key=lambda item: _natural(item[0]))):
        style = "--" if label.startswith("planned") else "-"
        axes.plot(*zip(*sorted(points), strict=True), style, marker="os^Dv"[number % 5], label=label)
    if logarithmic:
        axes.set(xscale="log", yscale="log")
        ticks = sorted({x for points in curves.values() for x, _ in points})
        axes.set_xticks(ticks, [f"{x:g}" for x in ticks], minor=False)
        axes.minorticks_off()
    else:
        axes.set_ylim(-4, 104)
    axes.set(xlabel=labels[0], ylabel=labels[1])
    axes.grid(alpha=0.3)
    axes.legend(frameon=False, fontsize=8)
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=110, metadata={"Software": ""})
    write_atomic(path, stream.getvalue())
    return f"![{labels[1]} by {labels[0]}](images/{path.name})\n"


def _sorted(groups: dict[str, list[Row]]) -> list[tuple[str, list[Row]]]:
    return sorted(groups.items(), key=lambda item: _natural(item[0]))


def _natural(text: str) -> list[tuple[int, str]]:
    """Return a key that puts 9 before 10."""
    return [
        (int(word), "") if word.isdigit() else (0, word) for word in text.replace("%", " ").replace("/", " ").split()
    ]
