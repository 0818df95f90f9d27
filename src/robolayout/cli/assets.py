"""`robolayout assets`: the catalogue of furniture, what a word is understood as, and folders of meshes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from robolayout._errors import AssetError, InputError
from robolayout._files import write_atomic
from robolayout._text import pretty
from robolayout.cli.options import ending
from robolayout.cli.terminal import say, table, warn

if TYPE_CHECKING:
    from robolayout.assets import Category
    from robolayout.scene import Asset


def assets(
    word: Annotated[
        str | None, typer.Argument(help="Show what this word is understood as, or this group; `import` reads a folder.")
    ] = None,
    folder: Annotated[Path | None, typer.Argument(help="Folder of meshes, after `import`.")] = None,
    out: Annotated[Path, typer.Option("--out", help="Catalogue file that an import writes.")] = Path("catalogue.json"),
    front: Annotated[
        str | None, typer.Option("--front", help="Side that faces forward in the meshes, such as +x.")
    ] = None,
    pictures: Annotated[
        Path | None, typer.Option("--pictures", help="Also draw what is listed into this PNG file.")
    ] = None,
) -> None:
    """List the catalogue of furniture with typical sizes, look a word up, or import a folder of meshes."""
    from robolayout.assets import CATALOGUE, find_category

    if word == "import":
        _import(folder, out, front, pictures)
        return
    if folder is not None:
        raise InputError(f"{str(folder)!r} follows {word!r}: put a name of several words in quotes.")
    found = [kind for kind in CATALOGUE.values() if word is None or kind.group == word]
    found = found or [find_category(word or "")]
    if pictures is not None:
        _draw([_typical(kind) for kind in found], pictures)
    rows = [[c.name, c.group, " x ".join(f"{v:g}" for v in c.size), ", ".join(c.places), c.source] for c in found]
    table("Catalogue (depth x width x height in metres)", ["category", "group", "size", "place", "source"], rows)


def _import(folder: Path | None, out: Path, front: str | None, pictures: Path | None) -> None:
    """Write the catalogue of a folder, draw it, and say what was skipped and what is unsure."""
    from robolayout.assets import import_folder

    if folder is None:
        raise InputError("import needs a folder: robolayout assets import FOLDER.")
    catalogue = import_folder(folder, front=front)
    for entry in catalogue["skipped"]:
        warn(f"skipped {entry['path']}: {entry['reason']}")
    if not catalogue["assets"]:
        raise AssetError(f"none of the {len(catalogue['skipped'])} meshes in {folder.name!r} can be used.")
    for sentence in catalogue.pop("unsure"):
        warn(sentence)
    if pictures is not None:
        _draw(_own(catalogue["assets"], folder), pictures)
    meshes, home = folder.resolve(), out.resolve().parent
    if meshes.is_relative_to(home):  # then a scene beside the catalogue finds the meshes by it
        for entry in catalogue["assets"].values():
            entry["path"] = (meshes.relative_to(home) / entry["path"]).as_posix()
    say(str(write_atomic(out, pretty(catalogue))))


def _own(entries: Mapping[str, Any], folder: Path) -> list[Asset]:
    """Return imported things, each turned as it was understood."""
    from robolayout.scene import Asset

    found: list[Asset] = []
    for name, entry in entries.items():
        x, y, z = (entry["assetMetadata"]["boundingBox"][axis] for axis in "xyz")
        axes = {"up": entry["up"], "front": entry["front"]}
        found.append(Asset(name, entry["category"], (x, y, z), path=folder / entry["path"], metadata=axes))
    return found


def _typical(kind: Category) -> Asset:
    from robolayout.scene import FLAGS, Asset, variable_name

    flags = {name: getattr(kind, name) for name in FLAGS.values()}
    return Asset(f"{variable_name(kind.name)}-0", kind.name, kind.size, **flags)


def _draw(shown: Sequence[Asset], target: Path) -> None:
    """Draw things into one picture, each from its front."""
    from robolayout.render import asset_sheet, png_bytes

    ending(target, "pictures", (".png",))
    write_atomic(target, png_bytes(asset_sheet(shown)))
