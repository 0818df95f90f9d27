"""Any folder of rooms measured: our figures and the published ones, per room and in sum, against another folder if asked."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout._errors import InputError, RoboLayoutError
from robolayout._files import write_atomic
from robolayout._text import markdown
from robolayout.many.dataset import MESHES
from robolayout.many.found import Found, find_rooms
from robolayout.many.index import PAGES, check_tables, columns, page, write_rows
from robolayout.many.room import figures
from robolayout.run.folder import open_folder
from robolayout.scene import Agent, load_agents

RESAMPLES = 2000  # sets drawn with replacement from the rooms
SURE = 0.95  # share of those sets whose means lie within the interval that is told
LOWER = ("COL", "Col_", "OOB", "R_out", "violations", "short", "exempt", "regions")
"""Parts of the names of figures of which less is better."""


@dataclass(frozen=True)
class Mean:
    """The mean of a figure over rooms."""

    count: int  # rooms that have the figure
    mean: float
    low: float  # lower end of the interval
    high: float  # upper end


@dataclass(frozen=True)
class Paired:
    """A figure in two folders, room by room."""

    difference: Mean  # mean of this folder less the other one, over the rooms that both have
    better: int  # rooms in which it is better here
    worse: int  # rooms in which it is worse here
    chance: float  # probability of so uneven a share by chance (sign test)


@dataclass(frozen=True)
class Evaluation:
    """What was measured in a folder."""

    rows: tuple[Mapping[str, Any], ...]  # one row a room: its name, what a batch drew, and every figure
    skipped: Mapping[str, str]  # rooms that could not be read, with the reason
    # names of what rooms are grouped by, then the means of each figure by group; the whole has the name "all"
    groups: Mapping[str, Mapping[str, Mean]]
    against: Mapping[str, Paired]  # each figure in pairs with the other folder; empty without one
    unpaired: tuple[str, ...] = ()  # names of rooms that only one of the two folders has

    def to_markdown(self) -> str:
        """Return the tables: means by group, and the differences to the other folder."""
        names = list(self.groups)
        heads = (f"{name} ({max((m.count for m in part.values()), default=0)})" for name, part in self.groups.items())
        lines = [f"| figure | {' | '.join(map(markdown, heads))} |"]
        lines += ["|---|" + "---:|" * len(names)]
        for figure in self.groups["all"]:
            cells = (self.groups[name].get(figure) for name in names)
            lines.append(f"| {figure} | " + " | ".join("-" if cell is None else shown(cell) for cell in cells) + " |")
        if self.against:
            lines += ["", "| figure | difference | better | worse | by chance |", "|---|---:|---:|---:|---:|"]
            for figure, pair in self.against.items():
                cells = [shown(pair.difference), str(pair.better), str(pair.worse), f"{pair.chance:.3g}"]
                lines.append(f"| {figure} | {' | '.join(cells)} |")
        if self.skipped:
            lines += ["", "Not read:", ""]
            lines += [f"- {markdown(name)}: {markdown(why)}" for name, why in self.skipped.items()]
        if self.unpaired:
            lines += ["", f"Only in one of the folders: {', '.join(map(markdown, self.unpaired))}."]
        return "\n".join(lines) + "\n"


def shown(mean: Mean) -> str:
    """Return a mean with its interval."""
    return f"{mean.mean:.4g} [{mean.low:.4g}, {mean.high:.4g}]"


def evaluate(  # noqa: PLR0913 - the public page of everything that can be chosen
    folder: str | Path,
    *,
    against: str | Path | None = None,
    agent: Any = None,
    by: Sequence[str] = (),
    scenes: str | Path | None = None,
    asset_dir: str | Path | None = None,
    workers: int = 1,
    progress: Callable[[str], None] | None = None,
) -> Evaluation:
    """Measure every room of a folder, whoever made it.

    Args:
        against: Another folder, whose rooms are paired with these by name.
        agent: The body or bodies to judge for; each room's own if None.
        by: Columns by which rooms are grouped ("solver", "reach").
        scenes: Folder of the scene files, where they are not beside the layouts.
        asset_dir: Folder of assets that scenes refer to.

    Raises:
        InputError: A folder holds no room, or no room has a column of `by`.
    """
    agents = () if agent is None else load_agents(agent)
    places = None if scenes is None else Path(scenes)
    found = {Path(one): find_rooms(Path(one), places) for one in (folder, against) if one is not None}

    def measured(one: Path) -> tuple[list[dict[str, Any]], dict[str, str]]:
        meshes = one / MESHES if (one / MESHES).is_dir() else None  # of a batch
        return _measured(found[one], agents, Path(asset_dir) if asset_dir else meshes, workers, progress or str)

    rows, skipped = measured(Path(folder))
    groups = _groups(rows, by) if rows else {"all": {}}
    if against is None:
        return Evaluation(tuple(rows), skipped, groups, {})
    there, also = measured(Path(against))
    before = {row["room"]: row for row in there}
    pairs = [(row, before[row["room"]]) for row in rows if row["room"] in before]
    if not pairs:
        raise InputError(f"no room of {folder} has a namesake in {against}: rooms are paired by their names.")
    alone = {row["room"] for row in rows} ^ set(before)
    return Evaluation(tuple(rows), {**skipped, **also}, groups, _paired(pairs), tuple(sorted(alone)))


def _measured(
    rooms: Sequence[Found], agents: tuple[Agent, ...], asset_dir: Path | None, workers: int, tell: Callable[[str], Any]
) -> tuple[list[dict[str, Any]], dict[str, str]]:
    """Return a row for every room that can be read, and why the others cannot."""
    rows: list[dict[str, Any]] = []
    skipped: dict[str, str] = {}
    one = partial(_row, agents=agents, asset_dir=asset_dir)
    with ExitStack() as stack:
        mapped: Callable[..., Any] = map
        if min(workers, len(rooms)) > 1:
            pool = stack.enter_context(ProcessPoolExecutor(min(workers, len(rooms)), get_context("spawn")))
            stack.callback(pool.shutdown, cancel_futures=True)
            mapped = pool.map
        for room, found in zip(rooms, mapped(one, rooms), strict=True):
            tell(room.name)
            if isinstance(found, str):
                skipped[room.name] = found
            else:
                rows.append(found)
    return rows, skipped


def _row(room: Found, agents: tuple[Agent, ...], asset_dir: Path | None) -> dict[str, Any] | str:
    try:
        judged = room.judged(agents, asset_dir)
    except RoboLayoutError as error:
        return str(error).splitlines()[0]
    bodies = ",".join(agent.name for agent in judged.scene.agents)
    return {"room": room.name, **room.facts, "bodies": bodies, **figures(judged.report)}


def numbers(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the names of the columns that are figures."""
    found = (n for n in columns(rows) if all(isinstance(row.get(n), int | float | None) for row in rows))
    return [name for name in found if name not in ("seed", "room", "reach")]


def _column(rows: Sequence[Mapping[str, Any]], name: str) -> NDArray[np.float64]:
    return np.array([np.nan if row.get(name) is None else float(row[name]) for row in rows], dtype=float)


def _groups(rows: Sequence[Mapping[str, Any]], by: Sequence[str]) -> dict[str, dict[str, Mean]]:
    """Return the means of each figure over all rooms and by group."""
    for name in by:
        if not any(name in row for row in rows):
            raise InputError(f"no room has {name!r} to group by; there is {', '.join(columns(rows))}.")
    members: dict[str, list[Mapping[str, Any]]] = {}
    for row in rows if by else ():
        members.setdefault(", ".join(f"{name} {row.get(name, '-')}" for name in by), []).append(row)
    groups = {"all": list(rows), **dict(sorted(members.items()))}
    return {group: {name: mean(_column(found, name)) for name in numbers(rows)} for group, found in groups.items()}


def _paired(pairs: Sequence[tuple[Mapping[str, Any], Mapping[str, Any]]]) -> dict[str, Paired]:
    """Return the differences of each figure that both folders have."""
    here, there = ([pair[side] for pair in pairs] for side in (0, 1))
    found: dict[str, Paired] = {}
    for name in numbers(here):
        if all(name in row for row in there):
            apart = _column(here, name) - _column(there, name)
            sign = -1.0 if any(part in name for part in LOWER) else 1.0
            better, worse = int((sign * apart > 0).sum()), int((sign * apart < 0).sum())
            found[name] = Paired(mean(apart), better, worse, sign_test(better, worse))
    return found


def write_evaluation(found: Evaluation, folder: str | Path) -> list[Path]:
    """Write an evaluation: the rows and the sums as CSV and Parquet, the tables in Markdown, a page with plots."""
    check_tables()
    sums = [{"group": g, "figure": n, **vars(m)} for g, part in found.groups.items() for n, m in part.items()]
    for name, pair in found.against.items():
        told = {"better": pair.better, "worse": pair.worse, "chance": pair.chance}
        sums.append({"group": "against", "figure": name, **vars(pair.difference), **told})
    with open_folder(Path(folder)) as run:
        written = [*write_rows(run.path / "rooms", found.rows), *write_rows(run.path / "figures", sums)]
        written.append(write_atomic(run.path / "report.md", found.to_markdown()))
        title = f"{len(found.rows)} rooms evaluated"
        written.append(write_atomic(run.path / "index.html", page(title, found.rows, plots=_plots(found))))
        return [run.place(path) for path in written]


def _plots(found: Evaluation) -> dict[str, bytes]:
    known = (name for name, mean in found.groups["all"].items() if mean.count)
    shares = [name for name in known if name.endswith(("_share", "_ratio")) or name == "ok"]
    by_group = {group: {name: part[name] for name in shares[: PAGES.plotted]} for group, part in found.groups.items()}
    plots = {"means by group, with their intervals": by_group}
    if found.against:
        names = [name for name, pair in found.against.items() if pair.better + pair.worse][: PAGES.plotted]
        plots["differences, this folder less the other"] = {"": {n: found.against[n].difference for n in names}}
    return {name: _drawn(bars) for name, bars in plots.items() if any(bars.values())}


def _drawn(bars: Mapping[str, Mapping[str, Mean]]) -> bytes:
    """Return means with their intervals as a PNG, one line a figure, one colour a group."""
    from matplotlib.figure import Figure

    names = list(next(iter(bars.values())))
    figure = Figure(figsize=(8.0, 0.8 + 0.28 * len(names) + 0.12 * len(bars)), layout="constrained")
    axes: Any = figure.subplots()
    step = 0.7 / len(bars)
    for number, (group, part) in enumerate(bars.items()):
        found = [part[name] for name in names]
        ends = np.array([[m.mean - m.low for m in found], [m.high - m.mean for m in found]])
        places = np.arange(len(names)) + step * (number - (len(bars) - 1) / 2)
        middles, ends = [m.mean for m in found], np.maximum(ends, 0.0)
        axes.errorbar(middles, places, xerr=ends, fmt="o", capsize=2, ms=4, label=group)
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.grid(alpha=0.3)
    if len(bars) > 1:
        figure.legend(frameon=False, fontsize=8, loc="outside right upper")
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=110, metadata={"Software": ""})
    return stream.getvalue()


def mean(values: NDArray[np.float64], seed: int = 0) -> Mean:
    """Return the mean of a figure (NaN where a room lacks it) with its interval, by percentiles of the bootstrap."""
    found = values[~np.isnan(values)]
    if found.size == 0:
        return Mean(0, math.nan, math.nan, math.nan)
    rng = np.random.default_rng(seed)
    drawn = [found[rng.integers(0, found.size, found.size)].mean() for _ in range(RESAMPLES)]
    low, high = np.percentile(drawn, [50 * (1 - SURE), 50 * (1 + SURE)])
    return Mean(found.size, float(found.mean()), float(low), float(high))


def sign_test(better: int, worse: int) -> float:
    """Return the probability that, of so many rooms that differ, the better ones are so few or so many by chance.

    Twice the smaller tail of the binomial distribution with p = 1/2, at most 1; rooms that are equal do not count.
    """
    from scipy.stats import binomtest

    return float(binomtest(better, better + worse).pvalue) if better + worse else 1.0
