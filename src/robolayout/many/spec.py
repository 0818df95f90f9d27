"""What is asked of a batch: a small table of choices and ranges, read and checked before any work.

    rooms = ["bedroom", "an office for two people", "own/kitchen.json"]
    count = 100
    bodies = ["adult", "wheelchair"]

Every key has a default but `rooms`; ranges are [least, most]. `Spec` is the table, `Ready` the same with all files read that
it names, so that a worker needs nothing but it.
"""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from robolayout._errors import InputError, among
from robolayout._reading import LIMITS, Checker
from robolayout.assets import find_category, import_folder
from robolayout.export import find_exporter
from robolayout.planners import scene_from_sentence
from robolayout.scene import DRESSINGS, Agent, Scene, digest, load_agents, load_scene, scene_digest
from robolayout.solve import EFFORTS, solver_names

_CHECK = Checker(InputError)


def _bounded(default: Any, least: float, most: float) -> Any:
    """Return a field of a number or a range with the bounds that it is checked against."""
    return field(default=default, metadata={"least": least, "most": most})


@dataclass(frozen=True)
class Spec:
    """What is asked of a batch, as it is written."""

    # room types, sentences and scene files (paths from the SPEC's own folder), taken in turn
    rooms: tuple[str, ...] = ()
    count: int = _bounded(100, 1, 10_000_000)  # rooms in all; `each` takes its place
    # where above 0: so many rooms of every combination of rooms, bodies, styles, dress, solvers and reach, for
    # comparing them
    each: int = _bounded(0, 0, 10_000)
    seed: int = _bounded(0, 0, 2**31 - 1)  # settles every choice
    # bodies, one of them for each room; several together with commas. None: those that the room is usually for
    bodies: tuple[str, ...] = ()
    # words of style ("industrial", "Scandinavian"), one of them said of each room that is made from a sentence
    styles: tuple[str, ...] = ()
    # floor area, as a multiple of what is usual for the sentence; where it gives no size itself
    area: tuple[float, float] = _bounded((0.8, 1.5), 0.2, 20.0)
    ratio: tuple[float, float] = _bounded((0.75, 1.33), 0.2, 5.0)  # width over depth, as a multiple of what is usual
    height: tuple[float, float] = _bounded((2.5, 3.0), 2.0, 10.0)  # height of the walls in metres
    l_shaped: float = _bounded(0.2, 0.0, 1.0)  # share of the rooms that are L-shaped
    doors: tuple[int, int] = _bounded((1, 2), 1, 6)  # doors of a room
    windows: tuple[int, int] = _bounded((1, 3), 1, 12)  # windows of a room
    # share of the floor up to which things are added to those that such a room must have
    density: tuple[float, float] = _bounded((0.15, 0.35), 0.0, 0.5)
    # how much lies about: "none", "some", "full", one of them for each room. None: what the words or the scene file say
    dress: tuple[str, ...] = ()
    # folders of own GLB files, or catalogues of them (`robolayout assets import`): where they have a thing of a kind,
    # it is that one
    catalogues: tuple[str, ...] = ()
    formats: tuple[str, ...] = ()  # export formats beside GLB ("mjcf", "usda")
    # "run": a folder as `generate` writes it; "formats": scene, layout, report and the formats alone
    files: str = "run"
    pictures: bool = False  # whether to draw what `generate` draws; a small picture is always drawn
    solvers: tuple[str, ...] = ("default",)  # solvers, one of them for each room
    # whether the search knows the body; where not, the layout is made for nobody and judged for the body
    reach: tuple[bool, ...] = (True,)
    effort: str = "normal"  # how long to search: quick, normal or thorough
    keep_unmet: bool = False  # whether rooms that do not meet their demands are kept rather than replaced
    tries: int = _bounded(8, 1, 100)  # rooms that are drawn in the place of one until it is given up, and named
    # CPU seconds after which a worker that is still at one room is ended
    seconds: float = _bounded(300.0, 1.0, 86_400.0)
    memory: float = _bounded(8.0, 1.0, 1024.0)  # gigabytes of a worker's data, beyond which the system refuses it more
    test: float = _bounded(0.1, 0.0, 0.9)  # share of the rooms that are set aside for testing

    def to_dict(self) -> dict[str, Any]:
        """Return the table as plain values."""
        return {name: list(value) if isinstance(value, tuple) else value for name, value in vars(self).items()}

    @property
    def distinct(self) -> bool:
        """Whether a room that is much like an earlier one is replaced; not where combinations are compared."""
        return not self.each


@dataclass(frozen=True)
class RoomSource:
    """One entry of `rooms`, read."""

    text: str  # the entry as written
    scene: Scene | None = None  # the scene of a file; None for a sentence
    sentence: str = ""  # the sentence, without the full stop at its end
    size: tuple[float, float] = (0.0, 0.0)  # usual width and depth of such a room in metres


@dataclass(frozen=True)
class Ready:
    """A SPEC with everything read that it names."""

    spec: Spec  # the table
    sources: tuple[RoomSource, ...]  # the rooms
    bodies: tuple[tuple[Agent, ...] | None, ...] = (None,)  # the bodies; None for those that a room is usually for
    # entries of the catalogues by kind of thing; their paths are from the folder of meshes of the batch
    own: Mapping[str, tuple[Mapping[str, Any], ...]] = field(default_factory=dict[str, tuple[Mapping[str, Any], ...]])
    meshes: Mapping[str, Path] = field(default_factory=dict[str, Path])  # mesh files of the catalogues by these paths

    @property
    def choices(self) -> tuple[tuple[Any, ...], ...]:
        """What one of is taken for each room, beside the room itself: bodies, styles, dress, solvers, reach."""
        return (self.bodies, self.spec.styles or ("",), self.spec.dress or ("",), self.spec.solvers, self.spec.reach)

    @property
    def count(self) -> int:
        """Rooms in all."""
        if not self.spec.each:
            return self.spec.count
        ways = len(self.sources)
        for found in self.choices:
            ways *= len(found)
        return ways * self.spec.each

    def digest(self) -> str:
        """Return what tells this batch from others: the table and the content of all files that it names."""
        rooms = [source.text if source.scene is None else scene_digest(source.scene) for source in self.sources]
        meshes = {name: hashlib.sha256(path.read_bytes()).hexdigest() for name, path in self.meshes.items()}
        bodies = [repr(body) for body in self.bodies]
        return digest([self.spec.to_dict(), rooms, bodies, {key: list(one) for key, one in self.own.items()}, meshes])


def read_spec(given: str | Path | Mapping[str, Any], **changes: Any) -> Ready:
    """Return what a SPEC asks for, checked, with everything read that it names.

    Args:
        given: A TOML file, its content as a dictionary, or one room: a type, a sentence or a scene file.
        changes: Keys in place of the file's own.

    Raises:
        InputError: A key is unknown, a range impossible, a file missing; in one sentence that says where.
    """
    base = Path()
    if isinstance(given, Mapping):
        table = dict(given)
    elif str(given).endswith(".toml"):
        base, table = Path(given).parent, _CHECK.read_toml(Path(given), "SPEC")
    else:
        table = {"rooms": [str(given)]}
    spec = _spec({**table, **changes})
    sources = tuple(_source(text, base, spec) for text in spec.rooms)
    named = ([name.strip() for name in text.split(",") if name.strip()] for text in spec.bodies)
    files = ([base / name if (base / name).is_file() else name for name in group] for group in named)
    bodies = tuple(map(load_agents, files)) or (None,)
    own, meshes = _catalogues(spec.catalogues, base)
    return Ready(spec, sources, bodies, own, meshes)


def value_of(text: str) -> dict[str, Any]:
    """Return what "key=value" on a command line says, the value as TOML writes it; a bare word is a text."""
    key, found, value = text.partition("=")
    if not found:
        raise InputError(f"--set {text!r} is no KEY=VALUE, such as count=20 or 'bodies=[\"cat\"]'.")
    try:
        return {key.strip(): tomllib.loads(f"v = {value}")["v"]}
    except tomllib.TOMLDecodeError:
        return {key.strip(): value.strip()}


def _spec(table: Mapping[str, Any]) -> Spec:
    """Return the table of a SPEC with every value in its right type and within its bounds."""
    known = {one.name: one for one in fields(Spec)}
    among("key in the SPEC", map(str, table), known)
    if not table.get("rooms"):
        raise InputError('the SPEC names no rooms; add them, such as rooms = ["bedroom", "office"].')
    if table.get("each") and "count" in table:
        raise InputError("count and each exclude each other: give the number of rooms, or of every combination.")
    spec = Spec(**{key: _value(key, value, known[key].default, known[key].metadata) for key, value in table.items()})
    for kind, names, allowed in (
        ("solver", spec.solvers, solver_names()),
        ("effort", [spec.effort], EFFORTS),
        ("files", [spec.files], ("run", "formats")),
        ("dress", spec.dress, DRESSINGS),
    ):
        among(kind, names, allowed)
    for name in spec.formats:
        find_exporter(name)
    return spec


def _value(key: str, value: object, default: object, bounds: Mapping[str, float]) -> Any:
    """Return one value of a SPEC, checked by what its default is like."""
    where = f"{key} in the SPEC"
    if isinstance(default, bool):
        return _CHECK.flag(value, where)
    if isinstance(default, str):
        return _CHECK.text(value, where)
    if not isinstance(default, tuple):
        return _number(value, where, whole=isinstance(default, int), bounds=bounds)
    if bounds:
        return _range(value, where, whole=isinstance(default[0], int), bounds=bounds)
    entries = _CHECK.sequence([value] if isinstance(value, str | bool) else value, where, most=LIMITS.named)
    read = _CHECK.flag if key == "reach" else _CHECK.text
    found = tuple(read(entry, f"{where}: entry {number + 1}") for number, entry in enumerate(entries))
    if len(set(found)) < len(found) or (default and not found):
        raise InputError(f"{where} is {list(found)}: name at least one and each once.")
    return found


def _number(value: object, where: str, *, whole: bool, bounds: Mapping[str, float]) -> float | int:
    found = _CHECK.number(value, where, least=bounds["least"], most=bounds["most"], is_length=False)
    if whole and found != int(found):
        raise InputError(f"{where} must be a whole number, but is {found:g}.")
    return int(found) if whole else found


def _range(value: object, where: str, *, whole: bool, bounds: Mapping[str, float]) -> tuple[float, float]:
    entries = _CHECK.sequence(value, where, most=2) if isinstance(value, list | tuple) else [value, value]
    if len(entries) != 2:
        raise InputError(f"{where} must be [least, most] or one number, but is {entries}.")
    low, high = (_number(entry, where, whole=whole, bounds=bounds) for entry in entries)
    if low > high:
        raise InputError(f"{where} is [{low:g}, {high:g}], and nothing lies between; write the smaller number first.")
    return low, high


def _source(text: str, base: Path, spec: Spec) -> RoomSource:
    """Return one entry of `rooms`; a sentence is read once, so that what cannot be read is known before any work."""
    if text.endswith(".json"):
        return RoomSource(text, load_scene(base / text))
    sentence = " ".join(text.split()).rstrip(".")
    try:
        _, found = scene_from_sentence(sentence, seed=spec.seed)
    except InputError as error:
        raise InputError(f"rooms in the SPEC: {text!r} is no room: {error}") from None
    return RoomSource(text, None, sentence, found.size)


def _catalogues(names: Sequence[str], base: Path) -> tuple[dict[str, tuple[Mapping[str, Any], ...]], dict[str, Path]]:
    """Return the entries of catalogues by kind of thing, and their meshes by the paths that these have in a batch."""
    own: dict[str, list[Mapping[str, Any]]] = {}
    meshes: dict[str, Path] = {}
    for number, name in enumerate(names):
        file, home = base / name, (base / name).parent
        if file.is_dir():
            data, home = import_folder(file), file
        else:
            data = _CHECK.mapping(_CHECK.read_json(file, "catalogue"), f"catalogue {name}")
        entries = _CHECK.inner(data, "assets", f"catalogue {name}")
        for key, entry in entries.items():
            found = dict(_CHECK.mapping(entry, f"catalogue {name}: {key}"))
            path = _CHECK.text(_CHECK.required(found, "path", f"catalogue {name}: {key}"), f"{name}: {key}: path")
            if not (home / path).is_file():
                raise InputError(f"catalogue {name}: the mesh {path!r} of {key!r} does not exist; import it again.")
            found["path"] = f"{number}/{path}"
            meshes[found["path"]] = home / path
            own.setdefault(find_category(str(found.get("category", key))).name, []).append(found)
    return {kind: tuple(entries) for kind, entries in own.items()}, meshes
