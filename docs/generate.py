"""Write the tables that README and pages take from the code: `python -m docs.generate` (or `make docs`).

A table stands between `<!-- table: NAME -->` and `<!-- end of table -->`; `tests/test_docs.py` fails when one is out of date.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import MISSING, Field
from pathlib import Path
from typing import Any

from robolayout import _errors
from robolayout._files import write_atomic
from robolayout.constraints import RELATIONS
from robolayout.many import Spec
from robolayout.planners import scene_from_sentence
from robolayout.scene import agent_names, load_agent
from robolayout.solve import solver_names
from robolayout.verify import RULES

ROOT = Path(__file__).parents[1]
TABLE = re.compile(r"(?<=<!-- table: )(\w+)( -->\n).*?(?=<!-- end of table -->)", re.DOTALL)


def table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    lines = [heads, ["---"] * len(heads), *([cell.replace("|", "\\|") for cell in row] for row in rows)]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def relations() -> str:
    """Return one row per relation of the program language."""
    rows = [[f"`{kind.example.removeprefix('solver.')}`", kind.meaning()] for kind in RELATIONS.values()]
    return table(["relation", "what it asks"], rows)


def statements() -> str:
    """Return one row per relation with its arguments, what it asks, what moves and when it counts as met."""
    rows: list[list[str]] = []
    for kind in RELATIONS.values():
        call = f"`{kind.name}({', '.join(_argument(field) for field in kind.arguments())})`"
        rows.append([call, kind.meaning(), (kind.check.__doc__ or "").strip()])
    return table(["statement", "what it asks", "met if"], rows)


def spec() -> str:
    """Return one row per key of a SPEC of many rooms: its default, and what stands beside or above it."""
    text = (ROOT / "src" / "robolayout" / "many" / "spec.py").read_text(encoding="utf-8")
    fields = text.partition("class Spec:")[2].partition("\n    def ")[0]
    rows = re.findall(r"((?:    # .+\n)*)    (\w+): [^#\n]+?(?:  # (.+))?\n", fields)
    said = {name: (beside or " ".join(re.findall(r"# (.+)", above))).strip() for above, name, beside in rows}
    said = {name: f"{words[:1].upper()}{words[1:]}." for name, words in said.items()}
    default = Spec().to_dict()
    return table(
        ["key", "default", "what it is"], [[f"`{k}`", f"`{json.dumps(default[k])}`", v] for k, v in said.items()]
    )


SENTENCES = (
    "a bedroom for two children with a bunk bed, desks and a reading corner, 4 x 5 m, for a wheelchair user",
    "a small home office with two desks and a printer",
    "a living room of 30 square metres with a corner sofa, a TV and lots of bookshelves",
    "a kitchen, 3.2 by 4.5 m, with an island and four bar stools",
    "a dining room for eight people",
    "a bathroom with a shower, two sinks and a washing machine, 2.5 x 3 m",
    "a classroom for 20 pupils with a whiteboard",
    "a cosy cafe with six small tables for two",
    "a hospital room with two beds, for a nurse's robot: tiago",
    "a bookshop with twelve shelves and a checkout counter",
    "a gym with three treadmills and a bench, 12 ft x 20 ft",
    "a meeting room for ten with a projector screen",
    "an L-shaped studio flat, 6 x 7 m, with a double bed, a settee and a small dining table",
    "a nursery with a cot, a changing table and a rocking chair",
    "a florist's shop with flower stands, 8 x 6 m",
    "a workshop with two workbenches and a tool cabinet for a forklift, 10 x 12 m",
    "a room for my cat with a scratching post and an armchair",
    "a care-home room for an older adult with a walker",
    "a games room with a pool table, a dartboard and a purple dinosaur",
    "somewhere to sleep",
)
"""What people write; the page about the planner shows what is understood."""


def sentences() -> str:
    """Return one row per sentence: room, body, what was wished and added, what meant nothing."""
    rows: list[list[str]] = []
    for text in SENTENCES:
        try:
            _, found = scene_from_sentence(text)
        except _errors.RoboLayoutError as error:
            rows.append([text, f"refused: {error}", "", "", ""])
            continue
        width, depth = found.size
        room = f"{found.room_type}, {width:.1f} x {depth:.1f} m" + (", L-shaped" if "L" in found.shape else "")
        body = found.agent or "-"
        rows.append(
            [text, f"{room}; {body}", _counts(found.wished), _counts(found.added), ", ".join(found.ignored) or "-"]
        )
    return table(["sentence", "room; body", "wished", "added", "meant nothing"], rows)


def _counts(things: Mapping[str, int]) -> str:
    return ", ".join(f"{count} {name}" if count > 1 else name for name, count in things.items()) or "-"


def _argument(field: Field[Any]) -> str:
    """Return an argument as in a signature."""
    text = f"[{field.name}]" if field.metadata["many"] else field.name
    return text if field.default is MISSING else f"{text}={field.default!r}"


def agents() -> str:
    """Return one row per built-in body."""
    rows: list[list[str]] = []
    for name in agent_names():
        body = load_agent(name)
        rectangle = body.length is not None and body.width is not None
        shape = f"{body.length:.2f} x {body.width:.2f}" if rectangle else f"disc {2 * body.radius:.2f}"
        heights = "-" if body.reach_distance is None else f"{body.reach_low:.2f} to {body.reach_high:.2f}"
        checked = f"{sum(source.verified for source in body.sources.values())} of {len(body.sources)}"
        rows.append([f"`{name}`", body.title, shape, f"{body.height:.2f}", f"{body.reach:.2f}", heights, checked])
    heads = ["name", "body", "footprint", "height", "reach", "heights it reaches", "figures checked at their source"]
    return table(heads, rows)


def rules() -> str:
    """Return one row per named rule of accessibility."""
    rows = [
        [
            f"`{rule.name}`",
            rule.asks,
            ", ".join(rule.concerns),
            rule.source + ("" if rule.verified else " (not checked)"),
        ]
        for rule in RULES
    ]
    return table(["rule", "what it asks", "bodies whose name or title says", "source"], rows)


def errors() -> str:
    """Return one row per class of errors, in the order of the tree."""
    rows: list[list[str]] = []
    for name, kind in vars(_errors).items():
        if isinstance(kind, type) and issubclass(kind, _errors.RoboLayoutError) and kind is not _errors.RoboLayoutError:
            base = kind.__mro__[1].__name__
            meaning = (kind.__doc__ or "").strip().splitlines()[0]
            rows.append([f"`{name}`", f"`{base}`", "2", meaning])
    return table(["error", "is a", "exit code", "meaning"], rows)


RESULTS = ROOT / "benchmarks" / "results"


def measured() -> str:
    """Return one row per kind of room of this repository: how many runs of `make bench` meet all that is feasible."""
    rows: list[list[str]] = []
    for section, key, rooms, cases in (
        ("examples", "", "4 examples", "4 bodies x 5 seeds"),
        ("bodies", "shares/", "4 examples and a room 40 % full", "15 bodies x 5 seeds"),
        ("tasks", "", "43 tasks, 9 to 79 assets", "disc, wheelchair, the room's own body x 3 seeds"),
        (
            "crowded",
            "planned/default/",
            "crowded rooms made by rule, 30 % of the floor taken",
            "10 to 120 assets x 10 seeds",
        ),
        ("crowded", "planned/default/", "the same, 45 %", "10 to 120 assets x 10 seeds"),
    ):
        found = json.loads((RESULTS / f"{section}.json").read_text(encoding="utf-8"))["rows"]
        fill = "/30%/" if "30 %" in rooms else "/45%/" if "45 %" in rooms else ""
        runs = [row for name, row in found.items() if name.startswith(key) and fill in name and "concave" not in name]
        hard = sum(bool(row["hard_ok"]) for row in runs)
        proved = sum(row["impossible"] > 0 for row in runs)
        met = f"{sum(bool(row['ok']) for row in runs) + proved} of {len(runs)}"
        rows.append([rooms, cases, f"{hard} of {len(runs)}", met + (f", {proved} proved impossible" if proved else "")])
    heads = ["rooms", "runs", "collision-free, inside, supported, doors clear", "all that is feasible"]
    return table(heads, rows)


def solver_times() -> str:
    """Return one row per solver: CPU seconds of the command that a user gives, everything included."""
    found = json.loads((RESULTS / "speed.json").read_text(encoding="utf-8"))["rows"]
    rooms = ("bedroom.json", "tasks/classroom_crowded.json")
    rows = [
        [
            f"`--solver {name}`",
            *(f"{found[key]['cpu']:.1f}" if (key := f"process/{name}/{room}") in found else "-" for room in rooms),
        ]
        for name in solver_names()
    ]
    return table(["command", *(f"`generate examples/{room} --no-pictures`" for room in rooms)], rows)


TABLES: dict[str, Callable[[], str]] = {
    "relations": relations,
    "statements": statements,
    "sentences": sentences,
    "agents": agents,
    "errors": errors,
    "solver_times": solver_times,
    "measured": measured,
    "rules": rules,
    "spec": spec,
}


def filled(text: str) -> str:
    """Return a page with its tables up to date; tables of other names are left to those who write them."""
    return TABLE.sub(lambda found: found[1] + found[2] + TABLES[found[1]]() if found[1] in TABLES else found[0], text)


def pages() -> list[Path]:
    """Return README and every page of the docs, the gallery aside."""
    return [ROOT / "README.md", *(p for p in sorted((ROOT / "docs").rglob("*.md")) if "gallery" not in p.parts)]


def main() -> None:
    """Bring every page up to date and name those that changed."""
    for page in pages():
        text = page.read_text(encoding="utf-8")
        if (new := filled(text)) != text:
            write_atomic(page, new)
            sys.stdout.write(f"{page.relative_to(ROOT)}\n")


if __name__ == "__main__":
    main()
