"""Build docs/gallery: every example furnished, with a page to leaf through: `python -m docs.gallery [NAME ...]`.

A room that is there already is left as it is, so an interrupted run goes on; name rooms to make them again.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import robolayout as rl
from robolayout._files import write_atomic
from robolayout.page.marks import plan_marks
from robolayout.render import Studio, plan_svg, png_bytes

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "docs" / "gallery"
SIZE = 560
"""Pixels of a side of the pictures."""

COLOURS = 160
"""Colours of the pictures: a third of the bytes."""


def main(names: list[str]) -> None:
    """Furnish the rooms that are missing or named, then write the pages."""
    files = [*sorted((ROOT / "examples").glob("*.json")), *sorted((ROOT / "examples" / "tasks").glob("*.json"))]
    for file in files:
        if file.stem in names or not (names or (FOLDER / file.stem / "report.json").exists()):
            sys.stdout.write(f"{file.stem}: {furnish(file)}\n")
    done = [file for file in files if (FOLDER / file.stem / "report.json").exists()]
    for number, file in enumerate(done):
        around = (done[number - 1].stem, done[(number + 1) % len(done)].stem)
        write_atomic(FOLDER / file.stem / "README.md", room_page(file, around))
    write_atomic(FOLDER / "README.md", index(done))
    write_atomic(FOLDER / "index.html", leaves(done))


def furnish(file: Path) -> str:
    """Lay out one room for its own agent and keep its pictures; return the report in one line."""
    result = rl.generate(file, seed=0)
    folder, first = FOLDER / file.stem, result.report.agents[0]
    plan = plan_svg(result.scene, result.layout, navigation=plan_marks(first), agent=first.agent)
    write_atomic(folder / "plan.svg", plan)
    studio = Studio(result.scene, result.layout)
    for name, view in (("top", "top"), ("view", "side")):
        write_atomic(folder / f"{name}.png", png_bytes(studio.view(view, size=SIZE).quantize(COLOURS)))
    short = {"title": first.agent.title or first.agent.name, "ok": result.report.ok, "rows": result.report.rows()}
    short |= {"violations": result.report.violations, "assets": len(result.scene.assets)}
    write_atomic(folder / "report.json", json.dumps(short, indent=1) + "\n")
    return str(result.report)


def room_page(file: Path, around: tuple[str, str]) -> str:
    """Return the page of one room: what was asked, pictures, figures, and links to its neighbours."""
    report = json.loads((FOLDER / file.stem / "report.json").read_text(encoding="utf-8"))
    scene = rl.load_scene(file)
    figures = "".join(
        f"| {name} | {value} | {'**short**' if met is False else ''} |\n" for name, value, met in report["rows"]
    )
    wrong = "".join(f"- {sentence}\n" for sentence in report["violations"])
    return (
        f"# {title(file)}\n\n[before](../{around[0]}/README.md) - [all rooms](../README.md) - [next](../{around[1]}/README.md)\n\n"
        f"{scene.task_description}\n\n*{scene.layout_criteria}*\n\n{report['assets']} assets, for: {report['title']}.\n\n"
        "![from the side](view.png) ![from above](top.png)\n\n![plan](plan.svg)\n\n"
        f"| check | result | |\n|---|---:|---|\n{figures}\n{wrong}"
    )


def index(done: list[Path]) -> str:
    """Return the page of all rooms, three in a row."""
    cells = [f"[![]({f.stem}/view.png)<br>{title(f)}]({f.stem}/README.md)" for f in done]
    rows = [" | ".join(cells[i : i + 3] + [""] * (3 - len(cells[i : i + 3]))) for i in range(0, len(cells), 3)]
    lines = "".join(f"| {row} |\n" for row in rows)
    return f"# Gallery\n\nWritten by `make gallery`; every room is one seed, unretouched.\n\n| | | |\n|---|---|---|\n{lines}"


def leaves(done: list[Path]) -> str:
    """Return the page to leaf through in a browser: one room at a time, by buttons, arrow keys or small pictures."""
    rooms: list[dict[str, object]] = []
    for file in done:
        report = json.loads((FOLDER / file.stem / "report.json").read_text(encoding="utf-8"))
        asked = rl.load_scene(file).task_description
        kept = {key: report[key] for key in ("rows", "violations", "assets")}
        rooms.append({"name": file.stem, "title": title(file), "asked": asked, "who": report["title"], **kept})
    page = (ROOT / "docs" / "gallery.html").read_text(encoding="utf-8")
    return page.replace("/*ROOMS*/ []", json.dumps(rooms).replace("<", "\\u003c"))


def title(file: Path) -> str:
    """Return the name of a room for people."""
    return file.stem.replace("_", " ").capitalize()


if __name__ == "__main__":
    main(sys.argv[1:])
