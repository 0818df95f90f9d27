"""Tables and plots of docs/benchmarks.md."""

from __future__ import annotations

import io
import statistics
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from benchmarks.measures import SHARES
from benchmarks.store import Row
from robolayout._files import write_atomic

HEADS = [name.removesuffix("_share").replace("_", " ") for name in SHARES]
Rows = dict[str, Row]


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


def phases(runs: list[Row]) -> str:
    """Return which phases made the winning layouts, and how often."""
    counts = Counter(row["phase"] for row in runs)
    return ", ".join(
        f"{phase} {count}" for phase, count in sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    )


def figure(row: Row, key: str, form: str) -> str:
    """Return a figure in its form, or a dash where it was not measured."""
    return form.format(row[key]) if key in row else "-"


def of(part: int, whole: int) -> str:
    """Return a count of a count and its share."""
    return f"{part} of {whole} ({part / whole:.0%})" if whole else "-"


def sorted_groups(groups: dict[str, list[Row]]) -> list[tuple[str, list[Row]]]:
    """Return groups of rows in the natural order of their names."""
    return sorted(groups.items(), key=lambda item: natural(item[0]))


def natural(text: str) -> list[tuple[int, str]]:
    """Return a key that puts 9 before 10."""
    return [
        (int(word), "") if word.isdigit() else (0, word) for word in text.replace("%", " ").replace("/", " ").split()
    ]


def plot(
    path: Path, curves: dict[str, list[tuple[float, float]]], labels: tuple[str, str], *, logarithmic: bool = False
) -> str:
    """Draw curves as a PNG and return the line that shows it."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 3.6), layout="constrained")
    axes: Any = figure.subplots()
    for number, (label, points) in enumerate(sorted(curves.items(), key=lambda item: natural(item[0]))):
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
