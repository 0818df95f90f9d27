"""Every example dressed in full: what is added, what goes into what by the exported triangles, and what five seconds of gravity move."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import robolayout as rl
from benchmarks.examples import ROOMS, ROOT
from benchmarks.store import Row
from benchmarks.tables import Rows, table
from benchmarks.tasks import FOLDER
from benchmarks.triangles import penetrations
from robolayout.export import settle
from robolayout.scene.asset import LIES_ABOUT


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room."""
    files = [*(ROOT / "examples" / f"{room}.json" for room in ROOMS), *sorted(FOLDER.glob("*.json"))]
    for file in files[:1] if quick else files:
        yield f"{file.parent.name}/{file.stem}", partial(measured, file)


def measured(file: Path) -> Row:
    """Return how many things a room has before and after, what goes through what, and what moves."""
    result = rl.generate(file, dress="full")
    settled = settle(result.scene, result.layout)
    return {
        "assets": len(result.scene.assets),
        "added": sum(LIES_ABOUT in asset.metadata for asset in result.scene.assets),
        "dress_cpu": result.report.timing["dress"]["cpu"],
        "through": len(penetrations(result.scene, result.layout)),
        "moving": len(settled.violations),
        "moved_mm": 1000 * max(motion.displacement for motion in settled.motions.values()),
    }


def section(rows: Rows, images: Path) -> str:
    """Return the table of rooms dressed in full."""
    lines = [
        [
            room.rpartition("/")[2].replace("_", " "),
            str(row["assets"] - row["added"]),
            str(row["added"]),
            f"{row['dress_cpu']:.2f}",
            str(row["through"]),
            str(row["moving"]),
            f"{row['moved_mm']:.1f} mm",
        ]
        for room, row in sorted(rows.items())
    ]
    heads = ["room", "things", "added", "CPU s", "through each other", "do not stay", "move at most"]
    intro = (
        "`--dress full`. *Through each other*: pairs whose exported triangles go more than 2 mm into each other (python-fcl), rugs "
        "aside; *do not stay*: what five seconds of gravity in MuJoCo move by 1 cm or tilt by 2 degrees.\n"
    )
    return f"## Dressed rooms\n\n{intro}\n{table(heads, lines)}"
