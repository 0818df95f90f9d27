"""A catalogue that a scene file names: assets that many scenes share, each described once."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path

from robolayout._errors import SceneError, did_you_mean
from robolayout._reading import Checker, inside, show

Entry = Mapping[str, object]  # one asset as a scene file gives it
_CHECK = Checker(SceneError)


def find_catalogue(value: object, folders: Iterable[Path]) -> Path | None:
    """Return the file that a scene calls its catalogue, a path relative to one of these folders and in it; None where it has none."""
    if value is None:
        return None
    text, places = _CHECK.text(value, "catalogue", most=1000), list(folders)
    for folder in places:
        if "\0" not in text and inside(folder / text, places) and os.path.isfile(folder / text):
            return folder / text
    raise SceneError(
        f"catalogue {show(text)} is no file in the scene file's folder or the asset folder; correct the path, or write "
        "the file with `robolayout assets import FOLDER --out FILE`."
    )


def described(entries: Mapping[str, Entry], catalogue: Path | None) -> dict[str, Entry]:
    """Return the assets of a scene with what a catalogue says of them; what the scene says itself counts more.

    Args:
        entries: The assets; `from` names an entry of the catalogue, without it one without a box goes by its own name.
        catalogue: The catalogue's file.
    """
    if catalogue is None:
        asking = next((name for name, entry in entries.items() if "from" in entry), None)
        if asking is not None:
            raise SceneError(
                f"asset {show(asking)} is taken from a catalogue, but the scene names none; add catalogue."
            )
        return dict(entries)
    data = _CHECK.mapping(_CHECK.read_json(catalogue, "catalogue"), f"catalogue {catalogue.name}")
    known = _CHECK.inner(data, "assets", f"catalogue {catalogue.name}", f"{catalogue.name}: assets")
    found: dict[str, Entry] = {}
    for name, entry in entries.items():
        key = _CHECK.text(entry["from"], f"asset {show(name)}: from", most=200) if "from" in entry else name
        if "from" in entry and key not in known:
            listed = ", ".join(sorted(known)[:20]) + (", ..." if len(known) > 20 else "")
            raise SceneError(
                f"asset {show(name)}: {catalogue.name} has no {show(key)}.{did_you_mean(key, known)} It has: {listed}."
            )
        given = {k: v for k, v in entry.items() if k != "from"}
        takes = key in known and ("from" in entry or "assetMetadata" not in entry)
        found[name] = {**_CHECK.mapping(known[key], f"{catalogue.name}: {show(key)}"), **given} if takes else given
    return found
