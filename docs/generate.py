"""Write the tables that README and pages take from the code: `python -m docs.generate` (or `make docs`).

A table stands between `<!-- table: NAME -->` and `<!-- end of table -->`; `tests/test_docs.py` fails when one is out of date.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Sequence
from dataclasses import MISSING, Field
from pathlib import Path
from typing import Any

from robolayout import _errors
from robolayout._files import write_atomic
from robolayout.constraints import IMPLICIT, RELATIONS
from robolayout.scene import agent_names, load_agent

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
    for kind in (*RELATIONS.values(), *(type(relation) for relation in IMPLICIT)):
        call = f"`{kind.name}({', '.join(_argument(field) for field in kind.arguments())})`"
        met = (kind.check.__doc__ or "").strip()
        rows.append([call if not kind.implicit else f"{kind.name} (in every program)", kind.meaning(), met])
    return table(["statement", "what it asks", "met if"], rows)


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


def errors() -> str:
    """Return one row per class of errors, in the order of the tree."""
    rows: list[list[str]] = []
    for name, kind in vars(_errors).items():
        if isinstance(kind, type) and issubclass(kind, _errors.RoboLayoutError) and kind is not _errors.RoboLayoutError:
            base = kind.__mro__[1].__name__
            meaning = (kind.__doc__ or "").strip().splitlines()[0]
            rows.append([f"`{name}`", f"`{base}`", "2", meaning])
    return table(["error", "is a", "exit code", "meaning"], rows)


TABLES: dict[str, Callable[[], str]] = {
    "relations": relations,
    "statements": statements,
    "agents": agents,
    "errors": errors,
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
