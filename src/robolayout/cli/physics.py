"""`robolayout settle` and `robolayout drive`: what happens to a layout in MuJoCo (extra `sim`)."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from robolayout._errors import InputError, UnknownNameError
from robolayout.cli.generate import AgentOption, AssetDirOption, JsonOption, QuietOption, read_scene
from robolayout.cli.terminal import say, table

if TYPE_CHECKING:
    from robolayout.export import Driven, Settled

SceneArgument = Annotated[str, typer.Argument(help="A scene file (JSON).")]
LayoutArgument = Annotated[Path, typer.Argument(help="A layout file (JSON).")]
ReportOption = Annotated[Path | None, typer.Option("--report", "--out", help="Also write it here (JSON).")]

DoorsOption = Annotated[str, typer.Option("--doors", help="How the room's doors stand: swinging, open or shut.")]


def standing(doors: str) -> str:
    """Return how the room's doors stand, if it is known."""
    from robolayout.export import LEAVES

    if doors not in LEAVES:
        raise UnknownNameError("way for doors to stand", doors, LEAVES)
    return doors


def settle(
    scene: SceneArgument,
    layout: LayoutArgument,
    seconds: Annotated[float, typer.Option("--seconds", min=0.1, max=60.0, help="Seconds of gravity.")] = 5.0,
    report: ReportOption = None,
    asset_dir: AssetDirOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Let gravity act on a layout in MuJoCo and report what moves (extra `sim`)."""
    from robolayout.export import settle as run
    from robolayout.scene import load_layout

    _check(report)
    given = read_scene(scene, None, asset_dir)
    found = run(given, load_layout(layout, given), seconds)
    _write(report, found)
    if as_json:
        say(json.dumps(found.to_dict()))
    elif not quiet:
        _show_settled(found, given.name)
    raise typer.Exit(1 if found.violations else 0)


def drive(  # noqa: PLR0913 - one parameter per option
    scene: SceneArgument,
    layout: LayoutArgument,
    report: ReportOption = None,
    agent: AgentOption = None,
    doors: DoorsOption = "open",
    asset_dir: AssetDirOption = None,
    quiet: QuietOption = False,
    as_json: JsonOption = False,
) -> None:
    """Drive the agent along its routes to every asset in MuJoCo and report contacts (extra `sim`)."""
    from robolayout.export import drive as run
    from robolayout.run.outputs import export_options
    from robolayout.scene import load_layout
    from robolayout.verify import verify

    leaves = standing(doors)
    _check(report)
    given = read_scene(scene, agent, asset_dir)
    placed = load_layout(layout, given)
    found = run(given, placed, given.agent, export_options(verify(given, placed)).routes, leaves=leaves)
    _write(report, found)
    if as_json:
        say(json.dumps(found.to_dict()))
    elif not quiet:
        say(f"{len(found.contacts)} contacts on all routes of {given.agent.name}, the room's doors {doors}")
        for sentence in found.violations:
            say(f"- {sentence}")
    raise typer.Exit(1 if found.violations else 0)


def _check(report: Path | None) -> None:
    """Refuse before any work a report that cannot be written, and a missing extra."""
    from robolayout._files import check_writable
    from robolayout.export import check_simulator

    check_simulator()
    if report is not None:
        if report.suffix.lower() != ".json":
            raise InputError(f"the report cannot be written to {report}: name a file that ends in .json.")
        check_writable(report.absolute().parent)


def _write(report: Path | None, found: Settled | Driven) -> None:
    from robolayout._files import write_atomic

    if report is not None:
        write_atomic(report, json.dumps(found.to_dict(), indent=2, ensure_ascii=False) + "\n")


def _show_settled(found: Settled, name: str) -> None:
    """Print how far each asset moved, the farthest first, and what is wrong."""
    rows = [
        [
            asset,
            f"{motion.displacement * 1000:.1f} mm",
            f"{math.degrees(motion.tilt):.2f}",
            "yes" if motion.stable else "NO",
        ]
        for asset, motion in sorted(found.motions.items(), key=lambda pair: -pair[1].displacement)
    ]
    table(f"{name} after {found.seconds:g} s of gravity", ["asset", "moved", "tilt (degrees)", "stays"], rows)
    say(f"{found.stable_share:.2f} of the assets stay within 1 cm and 2 degrees")
    for sentence in found.violations:
        say(f"- {sentence}")
