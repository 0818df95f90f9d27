"""The reference's own scene files: assets given as `<uid>-<n>` and looked up in a folder of assets.

`DIR/<uid>/data.json` holds the annotations and `DIR/<uid>/<uid>.glb` the mesh. In those raw files the bounding box's x
is the width and y the depth, so they are swapped here, once. Names come from the category: two chairs of one uid are
`chair-0` and `chair-1`; chairs of two uids are `chair_A-0` and `chair_B-0`.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path

from robolayout._errors import AssetError
from robolayout._reading import Checker, inside, show
from robolayout.scene.asset import FLAGS, variable_name

Entry = dict[str, object]  # one asset as a scene file gives it
_CHECK = Checker(AssetError)
_COPIED = ("description", *FLAGS, "frontView")


def look_up(keys: Iterable[str], asset_dir: Path) -> dict[str, tuple[str, Entry]]:
    """Return for each key `<uid>-<n>` its name in the scene and its entry in the format of DESIGN section 3."""
    if not asset_dir.is_dir():
        raise AssetError(f"asset folder {asset_dir} does not exist; check --asset-dir.")
    uids: dict[str, list[str]] = {}
    for key in keys:
        uids.setdefault(key.rpartition("-")[0] or key, []).append(key)
    entries = {uid: _entry(uid, asset_dir) for uid in uids}
    variables = _variables(entries)
    return {key: (f"{variables[uid]}-{n}", entries[uid]) for uid in uids for n, key in enumerate(uids[uid])}


def _entry(uid: str, asset_dir: Path) -> Entry:
    folder = asset_dir / uid
    if Path(uid).name != uid or not inside(folder, [asset_dir]):
        raise AssetError(f"asset uid {show(uid)} is not the name of a folder inside {asset_dir}.")
    path = folder / "data.json"
    if not os.path.isfile(path):
        raise AssetError(f"asset {show(uid)} is missing: there is no {path}; check --asset-dir.")
    where = f"{uid}/data.json"
    data = _CHECK.mapping(_CHECK.read_json(path, "asset file"), where)
    annotations = _CHECK.inner(data, "annotations", where)
    category = _CHECK.required(annotations, "category", f"{where}: annotations")
    entry: Entry = {"category": _CHECK.text(category, f"{where}: category", most=200), "uid": uid}
    entry |= {key: annotations[key] for key in _COPIED if key in annotations}
    width, depth, height = _CHECK.bounding_box(data, where)
    entry["assetMetadata"] = {"boundingBox": {"x": depth, "y": width, "z": height}}
    mesh = folder / f"{uid}.glb"
    if os.path.isfile(mesh):
        entry["path"] = str(mesh.resolve())
    return entry


def _variables(entries: Mapping[str, Entry]) -> dict[str, str]:
    """Return the program variable of each uid; uids that share a category get a letter each."""
    shared: dict[str, list[str]] = {}
    for uid, entry in entries.items():
        shared.setdefault(variable_name(str(entry["category"])), []).append(uid)
    return {
        uid: name if len(group) == 1 else f"{name}_{_letters(i)}"
        for name, group in shared.items()
        for i, uid in enumerate(group)
    }


def _letters(number: int) -> str:
    """Return A, B, ..., Z, AA, AB, ... for 0, 1, 2, ..."""
    tail = chr(ord("A") + number % 26)
    return tail if number < 26 else _letters(number // 26 - 1) + tail
