"""The four examples for four bodies and five seeds: what issue after issue must not make worse."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from benchmarks.measures import generated
from benchmarks.store import Row
from benchmarks.tables import HEADS, Rows, mean, select, shares, table

ROOT = Path(__file__).parents[1]
ROOMS = ("bedroom", "living_room", "dining_room", "studio")
DISC = {"name": "disc", "radius": 0.30, "height": 1.5, "reach": 0.75}
BODIES = {"disc 0.30": DISC, "wheelchair": "wheelchair", "child_6": "child_6", "robot_vacuum": "robot_vacuum"}
SEEDS = range(5)


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room, body and seed."""
    for room in ROOMS[:1] if quick else ROOMS:
        for body, agent in list(BODIES.items())[1:2] if quick else BODIES.items():
            for seed in SEEDS[:1] if quick else SEEDS:
                scene = ROOT / "examples" / f"{room}.json"
                yield f"{room}/{body}/{seed}", partial(generated, scene, agent=agent, seed=seed)


def section(rows: Rows, images: Path) -> str:
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
