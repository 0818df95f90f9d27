"""The tasks of `examples/tasks/`, each for the default disc, a wheelchair user and the room's own body, three seeds."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import partial

from benchmarks.examples import DISC, ROOT
from benchmarks.measures import generated
from benchmarks.store import Row

FOLDER = ROOT / "examples" / "tasks"
SEEDS = range(3)


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per task, body and seed; all tasks with the first seed come first."""
    files = sorted(FOLDER.glob("*.json"))
    for seed in SEEDS[:1] if quick else SEEDS:
        for file in files[:2] if quick else files:
            bodies: dict[str, object] = {"disc 0.30": DISC, "wheelchair": "wheelchair"}
            own = json.loads(file.read_text(encoding="utf-8")).get("agent")
            if own is not None and own != "wheelchair":
                bodies["its own"] = None
            for body, agent in bodies.items():
                yield f"{file.stem}/{body}/{seed}", partial(generated, file, agent=agent, seed=seed)
