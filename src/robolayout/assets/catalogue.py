"""Things of a user's own, as a catalogue of meshes describes them: read, and as kinds that sentences name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from robolayout._errors import AssetError
from robolayout._reading import Checker
from robolayout.assets.category import Category
from robolayout.assets.folder import import_folder
from robolayout.assets.lexicon import LONGEST_PHRASE, category_of
from robolayout.scene import FLAGS, Scene, scene_from_dict, scene_to_dict, split_name

FILE = "catalogue.json"  # what a catalogue is called in the folder of its meshes
HALL: Mapping[str, object] = {
    "boundary": {"floor_vertices": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "wall_height": 20}
}
"""A scene file's content of a room that everything fits into."""
Entry = Mapping[str, object]
_CHECK = Checker(AssetError)


def own_assets(folder: Path) -> Scene:
    """Return the things of a folder's catalogue, or of its meshes where it has none, as a scene's.

    Raises:
        InputError: There is no such folder, or it describes what no scene may have.
    """
    data: Mapping[str, Any] = (
        _CHECK.mapping(_CHECK.read_json(folder / FILE, "catalogue"), FILE)
        if (folder / FILE).is_file()
        else import_folder(folder)
    )
    return scene_from_dict({**HALL, "assets": _CHECK.inner(data, "assets", FILE)}, base=folder)


def own_kinds(scene: Scene) -> dict[str, list[tuple[Category, Entry]]]:
    """Return things of a user's own with their entries by kind: of their own words, and of the built-in kind that they are of."""
    found: dict[str, list[tuple[Category, Entry]]] = {}
    entries: Mapping[str, Entry] = scene_to_dict(scene)["assets"]  # type: ignore[assignment]
    for asset in scene.assets:
        kind = category_of(asset)
        flags = {name: getattr(asset, name) for name in FLAGS.values()}
        made = replace(kind, size=asset.size, use_sides=kind.use_sides if asset.use_sides is None else asset.use_sides)
        made = replace(made, **flags)
        stem = split_name(asset.name)[0].replace("_", " ")
        words = (asset.category, *asset.synonyms, asset.description, stem)
        names = [word for word in dict.fromkeys(words) if word and len(word.split()) <= LONGEST_PHRASE]
        names = [word for word in names if word.lower() != kind.name]
        if kind.group != "unknown":
            found.setdefault(kind.name, []).append((made, entries[asset.name]))
        if names:
            own = replace(made, name=names[0], like=kind.name, synonyms=tuple(names[1:]))
            found.setdefault(names[0], []).append((own, entries[asset.name]))
    return found
