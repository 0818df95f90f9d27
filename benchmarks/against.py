"""`python -m benchmarks.against --model openai:gpt-4o`: a model against the planner by rules, on the examples, in one table.

It asks the model that you name, with your key, and costs what that costs: `--max-cost` bounds each room. Every question and answer is
kept below `--out`, and `--replay` makes the same table from there without asking anybody.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import robolayout as rl
from benchmarks.examples import ROOMS, ROOT
from benchmarks.measures import watch
from benchmarks.tables import table
from robolayout.planners import ModelJudge, ModelPlanner
from robolayout.run.result import scored

HEADS = ["room, planner", "right", "of the brief met", "m from guess", "$", "s", "PSA", "planned by rules"]
RULES = "by rules"
Row = dict[str, Any]


def measured(scene: rl.Scene, planner: ModelPlanner | None, judge: ModelJudge | None, seed: int) -> Row:
    """Lay one room out and return what the table says of it."""
    with watch() as spent:
        result = rl.generate(scene, planner=planner, seed=seed)
    report, cost = result.report, None if planner is None else planner.usage.cost
    understood = [row for row in report.asked if row.verdict in ("met", "unmet")]
    guesses = result.program.guesses
    opinion = scored(rl.Result(scene, result.layout, report), judge).report.opinion if judge else {}
    return {
        "right": report.ok,
        "met": sum(row.verdict == "met" for row in understood),
        "asked": len(understood),
        "moved": sum(move.metres for move in report.moved if move.asset in guesses) / max(len(guesses), 1),
        "cost": 0.0 if planner is None else cost,
        "seconds": spent.wall,
        "psa": opinion.get("psa"),
        "taken": len(report.planner.get("taken_over", ())) if planner else None,
        "groups": len(result.groups),
    }


def cells(name: str, rows: Sequence[Row]) -> list[str]:
    """Return one line of the table: a room, or the sums and means over several."""
    costs, scores = ([row[key] for row in rows] for key in ("cost", "psa"))
    return [
        name,
        f"{sum(row['right'] for row in rows)} of {len(rows)}",
        f"{sum(row['met'] for row in rows)} of {sum(row['asked'] for row in rows)}",
        f"{statistics.fmean(row['moved'] for row in rows):.2f}",
        "unknown" if None in costs else f"{sum(costs):.4f}",
        f"{sum(row['seconds'] for row in rows):.1f}",
        "-" if None in scores else f"{statistics.fmean(scores):.0f}",
        "-"
        if rows[0]["taken"] is None
        else f"{sum(r['taken'] for r in rows)} of {sum(r['groups'] for r in rows)} groups",
    ]


def compared(rooms: Sequence[Path], given: argparse.Namespace) -> str:
    """Return the table: every room by rules and by the model, then all of them."""
    found: dict[str, list[Row]] = {RULES: [], given.model or "the recording": []}
    lines: list[list[str]] = []
    for path in rooms:
        scene = rl.load_scene(path)
        for who, rows in found.items():
            kept = given.out / path.stem
            limits = {"base_url": given.base_url, "max_cost": given.max_cost}
            planner, judge = None, None
            if who != RULES:
                asked = {"mode": given.mode, "samples": given.samples, "seed": given.seed}
                planner = ModelPlanner(given.model, **asked, **_kept(kept / "exchanges", given.replay), **limits)
            if given.judge:
                folder = kept / ("judged-rules" if who == RULES else "judged")
                judge = ModelJudge(given.judge, **_kept(folder, given.replay), **limits)
            rows.append(measured(scene, planner, judge, given.seed))
            lines.append(cells(f"{path.stem}, {who}", rows[-1:]))
    return table(HEADS, [*lines, *(cells(f"**all, {who}**", rows) for who, rows in found.items())])


def _kept(folder: Path, replay: bool) -> dict[str, Path]:
    return {"replay" if replay else "exchanges": folder}


def main(words: Sequence[str] | None = None) -> None:
    """Run the comparison that the command line asks for, and write the table to standard output."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.against", description=(__doc__ or "").partition("\n")[0]
    )
    parser.add_argument("--model", help="openai:gpt-4o, anthropic:..., ollama:..., or a name with --base-url")
    parser.add_argument("--base-url", help="a server of your own")
    parser.add_argument("--judge", help="a model that also scores every room")
    parser.add_argument("--mode", default="grouped", help="as of robolayout generate")
    parser.add_argument("--samples", type=int, default=1, help="programs per group")
    parser.add_argument("--max-cost", type=float, help="most dollars for a room, and for its scores")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("out/against"), help="folder for every question and answer")
    parser.add_argument("--replay", action="store_true", help="answer from that folder")
    parser.add_argument("scene", nargs="*", type=Path, help="scene files; the four examples if none are named")
    given = parser.parse_args(words)
    if given.model is None and not given.replay:
        parser.error("name a --model, or --replay what was asked before")
    rooms = given.scene or [ROOT / "examples" / f"{room}.json" for room in ROOMS]
    try:
        sys.stdout.write(compared(rooms, given))
    except rl.RoboLayoutError as error:
        parser.error(str(error))


if __name__ == "__main__":
    main()
