"""Two runs made by hand, and a browser to open their pages in."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from page_runs import HOSTILE, PLACES, PROGRAM, Opened, run_of

from robolayout import load_scene, page_html
from robolayout.program import read_program
from robolayout.run.result import Result
from robolayout.scene import Scene, load_agents
from running import ROOT

PATIENCE = 240_000
"""Milliseconds that a page may take on a busy machine."""

BROWSER = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")


@pytest.fixture(scope="session")
def bedroom() -> Scene:
    return load_scene(ROOT / "examples" / "bedroom.json").with_agents(*load_agents("wheelchair,robot_vacuum"))


@pytest.fixture(scope="session")
def run(bedroom: Scene) -> Result:
    """The example bedroom, furnished by hand, for two bodies."""
    return run_of(bedroom, PLACES, read_program(PROGRAM, bedroom))


@pytest.fixture(scope="session")
def strange_run(bedroom: Scene) -> Result:
    """The same, with every text that a file can give made hostile."""
    renamed = {"armchair-0": f"{HOSTILE}-0", "wardrobe-0": "__proto__-0"}
    assets = tuple(
        replace(asset, name=renamed.get(asset.name, asset.name), category=HOSTILE, description=HOSTILE)
        for asset in bedroom.assets
    )
    agents = tuple(replace(agent, name=f"{agent.name}{HOSTILE}", title=HOSTILE) for agent in bedroom.agents)
    scene = replace(bedroom, name=HOSTILE, task_description=HOSTILE, assets=assets, agents=agents)
    places = {renamed.get(name, name): place for name, place in PLACES.items() if name != "rug-0"}
    return run_of(scene, places, read_program("solver.against_wall(double_bed[0], walls[2])", bedroom))


def demanded(reason: str) -> None:
    """Skip, or fail where everything is demanded, as `make test` does."""
    if os.environ.get("ROBOLAYOUT_NODE_TOOLS") == "1":
        pytest.fail(reason)
    pytest.skip(reason)


@pytest.fixture(scope="module")
def chromium() -> Iterator[Callable[..., object]]:
    """A function that starts Chromium with further flags; it draws without a graphics card."""
    program = shutil.which("chromium") or shutil.which("google-chrome")
    if program is None:
        demanded("needs Chromium: apt-get install chromium")
    sync = pytest.importorskip("playwright.sync_api")
    with sync.sync_playwright() as playwright:
        started: dict[tuple[str, ...], object] = {}

        def start(*flags: str) -> object:
            if flags not in started:
                args = [*(BROWSER if not flags else BROWSER[:1]), *flags]
                started[flags] = playwright.chromium.launch(executable_path=program, args=args)
            return started[flags]

        yield start
        for browser in started.values():
            browser.close()


@pytest.fixture
def opened(chromium: Callable[..., object], tmp_path: Path) -> Iterator[Callable[..., Opened]]:
    """A function that writes a run's page, opens it without a network and waits until it is drawn."""
    contexts: list[object] = []

    def open_page(result: Result, *flags: str, width: int = 1280, height: int = 800) -> Opened:
        file = tmp_path / "report.html"
        file.write_text(page_html(result), encoding="utf-8")
        context = chromium(*flags).new_context(viewport={"width": width, "height": height}, offline=True)
        context.set_default_timeout(PATIENCE)
        contexts.append(context)
        found = Opened(context.new_page())
        found.page.on("console", lambda message: found.said.append(f"{message.type}: {message.text}"))
        found.page.on("pageerror", lambda error: found.said.append(str(error)))
        found.page.on("request", lambda request: found.asked.append(request.url))
        found.page.goto(file.as_uri())
        found.page.wait_for_selector("html[data-ready]", state="attached")
        return found

    yield open_page
    for context in contexts:
        context.close()
