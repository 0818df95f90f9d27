"""`robolayout agents`, `assets` and `constraints`: bodies, furniture and relations; also folders of meshes read."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from typer import Argument, Option

from robolayout._errors import AssetError, InputError
from robolayout._files import write_atomic
from robolayout._text import pretty
from robolayout.cli.options import ending, need
from robolayout.cli.terminal import say, table, warn

if TYPE_CHECKING:
    from robolayout.scene import Agent, Asset


def agents(
    name: Annotated[
        str | None,
        Argument(help="Show one body with its sources: a name, or a .toml, .json, .urdf or .xml file."),
    ] = None,
    out: Annotated[Path | None, Option(help="Draw it to this file: SVG, PNG or PDF.")] = None,
) -> None:
    """List the built-in bodies, or one with its sources and a drawing."""
    from robolayout.scene import agent_names, load_agent

    if name is not None:
        _one(load_agent(name), out)
        return
    if out is not None:
        raise InputError("--out draws one body: name it, such as `robolayout agents wheelchair --out wheelchair.svg`.")
    rows: list[list[str]] = []
    for known in agent_names():
        a = load_agent(known)
        shape = f"disc {2 * a.radius:.2f}" if a.length is None or a.width is None else f"{a.length:.2f} x {a.width:.2f}"
        heights = "-" if a.reach_distance is None else f"{a.reach_low:.2f}-{a.reach_high:.2f}"
        rows.append([known, a.title, shape, f"{a.radius:.3f}", f"{a.height:.2f}", f"{a.reach:.2f}", heights])
    table("Agents (metres)", ["name", "body", "footprint", "radius", "height", "reach", "heights"], rows)


def _one(body: Agent, out: Path | None) -> None:
    """Show a body: its figures with their sources, and a drawing on the terminal or in a file."""
    from robolayout.render import body_text, draw_body
    from robolayout.scene.agents_io import FIGURES

    suffix = "" if out is None else ending(out, "a body", (".svg", ".png", ".pdf"))
    figures = [
        [key, f"{value:g}", "yes" if source.verified else "no", source.text]
        for key, source in body.sources.items()
        if (value := getattr(body, key)) is not None
    ]
    for key in FIGURES:  # those of a user's own file have no source
        value, told = getattr(body, key), body.reach_distance is not None or not key.startswith("reach_")
        if key not in body.sources and value is not None and told:
            figures.append([key, f"{value:g}", "-", "given without a source"])
    table(f"{body.title or body.name} (metres)", ["figure", "value", "verified", "source"], figures)
    if out is not None:
        say(str(write_atomic(out, draw_body(body).file(suffix))))
    elif (sys.stdout.encoding or "utf-8").lower().startswith("utf"):
        say(*body_text(body).splitlines())


def constraints() -> None:
    """List the relations that a constraint program can state."""
    from robolayout.constraints import RELATIONS

    rows = [[relation.example.removeprefix("solver."), relation.meaning()] for relation in RELATIONS.values()]
    table("Relations", ["example", "meaning"], rows)


def assets(
    word: Annotated[
        str | None, Argument(help="Show what this word is understood as, or this group; `import` reads a folder.")
    ] = None,
    folder: Annotated[Path | None, Argument(help="Folder of meshes, after `import`.")] = None,
    out: Annotated[
        Path | None, Option(help="Catalogue file that an import writes; catalogue.json if not given.")
    ] = None,
    front: Annotated[str | None, Option("--front", help="Side that faces forward in the meshes, such as +x.")] = None,
    up: Annotated[str | None, Option("--up", help="Side that points up in the meshes, such as +z.")] = None,
    pictures: Annotated[Path | None, Option("--pictures", help="Also draw what is listed into this PNG file.")] = None,
) -> None:
    """List the catalogue of furniture with typical sizes, look a word up, or import a folder of meshes."""
    from robolayout.assets import CATALOGUE, find_category
    from robolayout.scene import FLAGS, Asset, variable_name

    if word == "import":
        _import(folder, out or Path("catalogue.json"), front, up, pictures)
        return
    if folder is not None:
        raise InputError(f"{str(folder)!r} follows {word!r}: put a name of several words in quotes.")
    need("`assets import FOLDER`", {"out": out is not None, "front": front, "up": up})
    found = [kind for kind in CATALOGUE.values() if word is None or kind.group == word]
    found = found or [find_category(word or "")]
    if pictures is not None:
        flags = [{name: getattr(kind, name) for name in FLAGS.values()} for kind in found]
        names = (f"{variable_name(kind.name)}-0" for kind in found)
        _draw([Asset(n, c.name, c.size, **f) for n, c, f in zip(names, found, flags, strict=True)], pictures)
    rows = [[c.name, c.group, " x ".join(f"{v:g}" for v in c.size), ", ".join(c.places), c.source] for c in found]
    table("Catalogue (depth x width x height in metres)", ["category", "group", "size", "place", "source"], rows)


def _import(folder: Path | None, out: Path, front: str | None, up: str | None, pictures: Path | None) -> None:
    """Write the catalogue of a folder, draw it, and say what was skipped and what is unsure."""
    from robolayout.assets import import_folder
    from robolayout.scene import Asset

    if folder is None:
        raise InputError("import needs a folder: robolayout assets import FOLDER.")
    catalogue = import_folder(folder, front=front, up=up)
    for entry in catalogue["skipped"]:
        warn(f"skipped {entry['path']}: {entry['reason']}")
    if not catalogue["assets"]:
        raise AssetError(f"none of the {len(catalogue['skipped'])} meshes in {folder.name!r} can be used.")
    for sentence in catalogue.pop("unsure"):
        warn(sentence)
    if pictures is not None:
        shown: list[Asset] = []  # each turned as it was understood
        for name, entry in catalogue["assets"].items():
            x, y, z = (entry["assetMetadata"]["boundingBox"][axis] for axis in "xyz")
            axes = {"up": entry["up"], "front": entry["front"]}
            shown.append(Asset(name, entry["category"], (x, y, z), path=folder / entry["path"], metadata=axes))
        _draw(shown, pictures)
    meshes, home = folder.resolve(), out.resolve().parent
    if meshes.is_relative_to(home):  # then a scene beside the catalogue finds the meshes by it
        for entry in catalogue["assets"].values():
            entry["path"] = (meshes.relative_to(home) / entry["path"]).as_posix()
    say(str(write_atomic(out, pretty(catalogue))))


def _draw(shown: Sequence[Asset], target: Path) -> None:
    """Draw things into one picture, each from its front."""
    from robolayout.render import asset_sheet, png_bytes

    ending(target, "pictures", (".png",))
    write_atomic(target, png_bytes(asset_sheet(shown)))
