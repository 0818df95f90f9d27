"""How long `report.html` takes to open in headless Chromium, which draws it without a graphics card."""

from __future__ import annotations

import statistics
import tempfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import robolayout as rl
from benchmarks.browser import FLAGS, program
from benchmarks.examples import ROOMS, ROOT
from benchmarks.store import Row
from benchmarks.tables import Rows, figure, table

CROWDED = "tasks/classroom_medium"
TIMES = 5
READ = "performance.getEntriesByType('navigation')[0].domContentLoadedEventEnd"


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room."""
    for room in ROOMS[:1] if quick else (*ROOMS, CROWDED):
        yield room.rpartition("/")[2], partial(opened, room)


def opened(room: str) -> Row:
    """Return the page's kilobytes, and the median seconds until its figures and its first picture are there."""
    from playwright.sync_api import sync_playwright

    result = rl.generate(ROOT / "examples" / f"{room}.json", seed=0, config=rl.SolverConfig(trace=True))
    page = rl.page_html(result)
    row: Row = {"assets": len(result.scene.assets), "kb": len(page) / 1000}
    browser_path = program()
    if browser_path is None:
        return row
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        file = Path(folder, "report.html")
        file.write_text(page, encoding="utf-8")
        browser = playwright.chromium.launch(executable_path=browser_path, args=list(FLAGS))
        figures: list[float] = []
        drawn: list[float] = []
        for _ in range(TIMES):
            tab = browser.new_page(viewport={"width": 1280, "height": 800})
            tab.goto(file.as_uri())
            tab.wait_for_selector("html[data-ready='3d']", state="attached")
            figures.append(tab.evaluate(READ) / 1000)
            drawn.append(float(tab.evaluate("() => document.documentElement.dataset.drawn")) / 1000)
            tab.close()
        browser.close()
    return row | {"figures": statistics.median(figures), "drawn": statistics.median(drawn), "slowest": max(drawn)}


def section(rows: Rows, images: Path) -> str:
    """Return the table of how long `report.html` takes to open."""
    lines: list[list[str]] = []
    for room in sorted(rows, key=lambda room: rows[room]["assets"]):
        row = rows[room]
        times = [figure(row, key, "{:.2f} s") for key in ("figures", "drawn", "slowest")]
        lines.append([room.replace("_", " "), str(row["assets"]), f"{row['kb']:.0f} kB", *times])
    heads = ["room", "assets", "page", "figures are there", "first picture", "slowest of five"]
    intro = "`report.html` in headless Chromium, 1280 x 800, drawn without a graphics card; medians of five.\n"
    return f"## Opening the page\n\n{intro}\n{table(heads, lines)}"
