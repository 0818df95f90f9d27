"""`robolayout settle` and `robolayout drive`: what happens to a layout in MuJoCo (extra `sim`)."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from typer import Option

from robolayout._errors import among
from robolayout._files import write_atomic
from robolayout._text import pretty
from robolayout.cli import options
from robolayout.cli.terminal import say, table

if TYPE_CHECKING:
    from robolayout.export import Driven, Settled

ReportOption = Annotated[Path | None, Option("--report", "--out", help="Also write it here (JSON).")]


def standing(doors: str) -> str:
    """Return how the room's doors stand, if it is known."""
    from robolayout.export import LEAVES

    among("way for doors to stand", [doors], LEAVES)
    return doors


@options.spread
def settle(
    scene: options.SceneArgument,
    layout: options.LayoutArgument,
    told: options.Told,
    seconds: Annotated[float, Option(min=0.1, max=60.0, help="Seconds of gravity.")] = 5.0,
    report: ReportOption = None,
    asset_dir: options.AssetDirOption = None,
) -> None:
    """Let gravity act on a layout in MuJoCo and report what moves (extra `sim`)."""
    from robolayout.export import settle as run

    _check(report)
    given, placed = options.Laid(scene=scene, layout=layout, asset_dir=asset_dir).read_both()
    found = run(given, placed, seconds)

    def show() -> None:
        farthest = sorted(found.motions.items(), key=lambda pair: -pair[1].displacement)
        rows = [
            [name, f"{how.displacement * 1000:.1f} mm", f"{math.degrees(how.tilt):.2f}", "yes" if how.stable else "NO"]
            for name, how in farthest
        ]
        table(f"{given.name} after {found.seconds:g} s of gravity", ["asset", "moved", "tilt (degrees)", "stays"], rows)
        say(f"{found.stable_share:.2f} of the assets stay within 1 cm and 2 degrees")
        say(*(f"- {sentence}" for sentence in found.violations))

    _tell(found, report, told, show)


@options.spread
def drive(
    laid: options.Laid, told: options.Told, report: ReportOption = None, doors: options.DoorsOption = "open"
) -> None:
    """Drive the agent's footprint to everything that it uses in MuJoCo and report contacts (extra `sim`)."""
    from robolayout.export import drive as run
    from robolayout.verify import judge_agent

    leaves = standing(doors)
    _check(report)
    given, placed = laid.read_both()
    judged = judge_agent(given, placed, given.agent)
    found = run(given, placed, given.agent, judged.ways, leaves=leaves)

    def show() -> None:
        say(f"{len(found.contacts)} contacts on all routes of {given.agent.name}, the room's doors {doors}")
        if judged.usage.undriven:
            say(f"{given.agent.name} finds no way to drive to {', '.join(judged.usage.undriven)}")
        say(*(f"- {sentence}" for sentence in found.violations))

    _tell(found, report, told, show)


def _check(report: Path | None) -> None:
    """Refuse before any work a report that cannot be written, and a missing extra."""
    from robolayout.export import simulator

    simulator()
    if report is not None:
        options.ending(report, "the report", (".json",))


def _tell(found: Settled | Driven, report: Path | None, told: options.Told, show: Callable[[], None]) -> None:
    """Write and print what was found."""
    if report is not None:
        write_atomic(report, pretty(found.to_dict()))
    told.tell(found.to_dict(), show)
    raise typer.Exit(1 if found.violations else 0)
