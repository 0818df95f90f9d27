"""Reads and writes the assets of a scene file, and looks up those that a catalogue describes for many scenes."""

from __future__ import annotations

import os
import unicodedata
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from robolayout._errors import AssetError, SceneError, did_you_mean
from robolayout._reading import LIMITS, MESH_SUFFIXES, Checker, inside, misspelt, show
from robolayout._text import printable
from robolayout.scene.asset import FLAGS, Asset, by_variable, split_name, variable_name

NO_TEXT = "\ufffe\uffff"  # code points that are no characters, and that XML cannot hold
SIDES = ("front", "back", "left", "right")  # sides that an asset can be used from
_CHECK, _ASSET = Checker(SceneError), Checker(AssetError)
Entry = Mapping[str, object]  # one asset as a scene file gives it
_KNOWN = (
    "category",
    "description",
    "path",
    "useSides",
    "like",
    "synonyms",
    "parts",
    "without",
    "from",
    "assetMetadata",
    *FLAGS,
)


def read_assets(data: Entry, base: Path | None, asset_dir: Path | None, warnings: list[str]) -> tuple[Asset, ...]:
    """Return the assets of a scene file in the folder `base`, in its order; `warnings` gets a sentence for what was mended."""
    entries = _CHECK.inner(data, "assets", "the scene", "assets")
    if not 0 < len(entries) <= LIMITS.assets:
        raise SceneError(f"the scene has {len(entries)} assets; from 1 to {LIMITS.assets} are allowed.")
    if asset_dir is not None and not asset_dir.is_dir():
        raise AssetError(f"asset folder {asset_dir} does not exist or is no folder; check --asset-dir.")
    folders = [folder for folder in (base, asset_dir) if folder is not None]
    catalogue = find_catalogue(data.get("catalogue"), folders)
    given = {key: _CHECK.mapping(entry, f"asset {show(key)}") for key, entry in entries.items()}
    named = _named(described(given, catalogue), asset_dir)
    folders += [catalogue.parent] if catalogue else []
    assets: dict[str, Asset] = {}
    for key, (name, entry) in named.items():
        _check_name(name)
        if name in assets:
            raise SceneError(f"two assets are called {name!r} (one of them is {show(key)}); give each its own name.")
        assets[name] = _asset(name, entry, folders, warnings)
    warnings.extend(_gaps(assets.values()))
    return tuple(assets.values())


def write_asset(asset: Asset, base: Path | None = None) -> dict[str, object]:
    """Return one entry of "assets" in a scene file; a mesh inside `base` is written relative to it."""
    depth, width, height = asset.size
    entry: dict[str, object] = {
        "category": asset.category,
        "description": asset.description,
        **{key: getattr(asset, name) for key, name in FLAGS.items()},
        "assetMetadata": {"boundingBox": {"x": depth, "y": width, "z": height}},
    }
    if asset.path is not None:
        near = base is not None and inside(asset.path, [base])
        entry["path"] = (asset.path.relative_to(base.resolve()) if base and near else asset.path).as_posix()
    if asset.use_sides is not None:
        entry["useSides"] = list(asset.use_sides)
    own = {"like": asset.like, "synonyms": list(asset.synonyms), "parts": asset.parts, "without": list(asset.without)}
    entry |= {key: value for key, value in own.items() if value}
    return entry | {key: value for key, value in asset.metadata.items() if key not in entry}


def _named(entries: dict[str, Entry], asset_dir: Path | None) -> dict[str, tuple[str, Entry]]:
    """Return (name, entry) by key, after looking up those without a box in the folder of assets."""
    unknown = [key for key, entry in entries.items() if "assetMetadata" not in entry]
    if unknown and asset_dir is None:
        raise SceneError(
            f"asset {show(unknown[0])} has no assetMetadata: give its boundingBox (x: depth, y: width, z: height, in "
            "metres; `robolayout assets` lists usual ones), or name the catalogue (catalogue, from) or the folder (--asset-dir) "
            "in which to look it up."
        )
    found = look_up(unknown, asset_dir) if asset_dir is not None and unknown else {}
    looked_up = {key: (name, entry | dict(entries[key])) for key, (name, entry) in found.items()}
    return {key: looked_up.get(key, (key, entry)) for key, entry in entries.items()}


def _check_name(name: str) -> None:
    where = f"the asset name {show(name)}"
    _CHECK.text(name, where, most=LIMITS.name)
    odd = next((c for c in name if unicodedata.category(c) in ("Cc", "Zl", "Zp") or c in NO_TEXT), None)
    if odd is not None:
        raise SceneError(f"{where} has the control character U+{ord(odd):04X}; any other text on one line is allowed.")
    if not name.strip():
        raise SceneError(f"{where} is empty; call the asset something.")


def _asset(name: str, entry: Entry, folders: list[Path], warnings: list[str]) -> Asset:
    where = f"asset {name!r}"
    warnings.extend(misspelt(entry, _KNOWN, where))
    category = entry.get("category", split_name(name)[0].replace("_", " "))
    text = _CHECK.text(category, f"{where}: category", most=200)
    words = " ".join(printable(text).split())
    if not words:
        raise SceneError(f"{where}: category is empty; say in a word or two what it is.")
    places = {name: _CHECK.flag(entry.get(key, False), f"{where}: {key}") for key, name in FLAGS.items()}
    if not any(places.values()):
        places["on_floor"] = True
        warnings.append(f"{where} says nowhere where it may stand; it goes on the floor (onFloor).")
    return Asset(
        name=name,
        category=words,
        size=_size(entry, where),
        description=_CHECK.text(entry.get("description", ""), f"{where}: description"),
        **places,
        path=_mesh(entry.get("path"), where, folders),
        use_sides=_sides(entry.get("useSides"), where),
        like=_CHECK.text(entry.get("like", ""), f"{where}: like", most=200),
        parts=_CHECK.text(entry.get("parts", ""), f"{where}: parts"),
        synonyms=_words(entry, "synonyms", where),
        without=_words(entry, "without", where),
        metadata={key: _CHECK.plain(value, f"{where}: {key}") for key, value in entry.items() if key not in _KNOWN},
    )


def _words(entry: Entry, key: str, where: str) -> tuple[str, ...]:
    words = _CHECK.sequence(entry.get(key, []), f"{where}: {key}", most=LIMITS.without)
    return tuple(_CHECK.text(word, f"{where}: {key}", most=200) for word in words)


def _size(entry: Entry, where: str) -> tuple[float, float, float]:
    sides: list[float] = []
    meanings = ("depth (boundingBox.x)", "width (boundingBox.y)", "height (boundingBox.z)")
    for value, meaning in zip(_CHECK.bounding_box(entry, where), meanings, strict=True):
        label = f"{where}: {meaning}"
        sides.append(_CHECK.number(value, label, above=0.0, most=LIMITS.largest_side))
        if sides[-1] < LIMITS.smallest_side:
            raise SceneError(f"{label} is {sides[-1]:g} m; sizes are in metres, at least {LIMITS.smallest_side:g}.")
    return (sides[0], sides[1], sides[2])


def _sides(value: object, where: str) -> tuple[str, ...] | None:
    if value is None:
        return None
    sides = tuple(str(side) for side in _CHECK.sequence(value, f"{where}: useSides", most=len(SIDES)))
    for side in sides:
        if side not in SIDES:
            raise SceneError(f"{where}: useSides names {show(side)}; allowed are {', '.join(SIDES)}.")
    return sides


def _mesh(value: object, where: str, folders: list[Path]) -> Path | None:
    """Return the mesh file, which must lie inside one of the folders and not be too large."""
    if value is None or value == "":
        return None
    text = _CHECK.text(value, f"{where}: path", most=1000)
    if not text.lower().endswith(MESH_SUFFIXES) or "\0" in text:
        known = ", ".join(MESH_SUFFIXES)
        raise SceneError(f"{where}: path {show(text)} is no mesh file ({known}); convert the mesh or leave path out.")
    places = [folder / text for folder in folders]
    allowed = [place for place in places if inside(place, folders)]
    if not allowed:
        raise SceneError(
            f"{where}: path {show(text)} lies outside the scene file's folder and the asset folder; "
            "move the mesh there or name its folder with --asset-dir."
        )
    for place in allowed:
        if os.path.isfile(place):
            length = place.stat().st_size
            if length > LIMITS.mesh_bytes:
                most = LIMITS.mesh_bytes // 1_000_000
                raise SceneError(
                    f"{where}: path {show(text)} has {length / 1e6:.0f} MB; at most {most} MB are read. "
                    "Simplify the mesh or leave path out for a built-in shape."
                )
            return place.resolve()
    raise SceneError(f"{where}: path {show(text)} does not exist; correct it or leave it out for a built-in shape.")


def _gaps(assets: Iterable[Asset]) -> Iterator[str]:
    """Warn where the numbers of a variable have a gap or stand twice, since a program counts its list without either."""
    for variable, group in by_variable(assets).items():
        odd = next((i for i, asset in enumerate(group) if asset.index != i), None)
        if odd is not None:
            gap = f"{variable} stands for several names"
            gap = f"there is no {variable}-{odd}" if group[odd].index > odd else gap
            yield f"{gap}: in a program, {variable}[{odd}] is {group[odd].name}."


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

    `from` names an entry of the catalogue; without it, an asset without a box goes by its own name.
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


def look_up(keys: Iterable[str], asset_dir: Path) -> dict[str, tuple[str, dict[str, object]]]:
    """Return for each key `<uid>-<n>` its name in the scene and its entry in the format of DESIGN section 3.

    `DIR/<uid>/data.json` holds the annotations and `DIR/<uid>/<uid>.glb` the mesh. In those raw files the bounding box's x
    is the width and y the depth, so they are swapped here, once. Names come from the category: two chairs of one uid are
    `chair-0` and `chair-1`; chairs of two uids are `chair_A-0` and `chair_B-0`.
    """
    uids: dict[str, list[str]] = {}
    for key in keys:
        uids.setdefault(key.rpartition("-")[0] or key, []).append(key)
    entries = {uid: _looked_up(uid, asset_dir) for uid in uids}
    shared: dict[str, list[str]] = {}  # uids that share a category, which get a letter each
    for uid, entry in entries.items():
        shared.setdefault(variable_name(str(entry["category"])), []).append(uid)
    variables = {
        uid: name if len(group) == 1 else f"{name}_{_letters(i)}"
        for name, group in shared.items()
        for i, uid in enumerate(group)
    }
    return {key: (f"{variables[uid]}-{n}", entries[uid]) for uid in uids for n, key in enumerate(uids[uid])}


def _looked_up(uid: str, asset_dir: Path) -> dict[str, object]:
    folder = asset_dir / uid
    if Path(uid).name != uid or not inside(folder, [asset_dir]):
        raise AssetError(f"asset uid {show(uid)} is not the name of a folder inside {asset_dir}.")
    path = folder / "data.json"
    if not os.path.isfile(path):
        raise AssetError(f"asset {show(uid)} is missing: there is no {path}; check --asset-dir.")
    where = f"{uid}/data.json"
    data = _ASSET.mapping(_ASSET.read_json(path, "asset file"), where)
    annotations = _ASSET.inner(data, "annotations", where)
    category = _ASSET.required(annotations, "category", f"{where}: annotations")
    entry: dict[str, object] = {"category": _ASSET.text(category, f"{where}: category", most=200), "uid": uid}
    entry |= {key: annotations[key] for key in ("description", *FLAGS, "frontView") if key in annotations}
    width, depth, height = _ASSET.bounding_box(data, where)
    entry["assetMetadata"] = {"boundingBox": {"x": depth, "y": width, "z": height}}
    mesh = folder / f"{uid}.glb"
    if os.path.isfile(mesh):
        entry["path"] = str(mesh.resolve())
    return entry


def _letters(number: int) -> str:
    """Return A, B, ..., Z, AA, AB, ... for 0, 1, 2, ..."""
    tail = chr(ord("A") + number % 26)
    return tail if number < 26 else _letters(number // 26 - 1) + tail
