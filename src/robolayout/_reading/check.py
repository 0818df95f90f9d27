"""Opening files, and checks on their values: each returns the value in its right type or raises one clear sentence.

Files are hostile until they have passed through here: sizes, counts, lengths and numbers are bounded.
"""

from __future__ import annotations

import difflib
import math
import os
import reprlib
import stat
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from numbers import Integral, Real
from pathlib import Path
from typing import TypeVar, cast

from robolayout._errors import InputError, RoboLayoutError
from robolayout._reading.limits import LIMITS
from robolayout._reading.syntax import Unreadable, check_plain, decoded, json_value, toml_value

Given = TypeVar("Given")
Made = TypeVar("Made")

MESH_SUFFIXES = (".glb", ".obj", ".ply", ".stl")  # kinds of mesh file that are read
_HOW = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
"""Without waiting: a pipe that nobody writes to would hold up its reader for ever."""


def show(value: object) -> str:
    """Return a short form of a value for a message."""
    if isinstance(value, int) and value.bit_length() > 100:
        return f"a whole number of {value.bit_length()} bits"
    return reprlib.repr(value)


@dataclass(frozen=True)
class Checker:
    """Checks values and raises `error` with a sentence that names the place, the value and what is allowed."""

    error: type[RoboLayoutError]

    def mapping(self, value: object, where: str) -> Mapping[str, object]:
        """Return `value` if it is an object with text keys."""
        if not isinstance(value, Mapping) or not all(isinstance(key, str) for key in value):
            raise self.error(f"{where} must be an object with named values, but is {show(value)}.")
        return cast("Mapping[str, object]", value)

    def sequence(self, value: object, where: str, most: int) -> list[object]:
        """Return `value` as a list if it is one with at most `most` entries."""
        if not isinstance(value, (list, tuple)):
            raise self.error(f"{where} must be a list, but is {show(value)}.")
        entries = cast("list[object] | tuple[object, ...]", value)
        if len(entries) > most:
            raise self.error(f"{where} has {len(entries)} entries; at most {most} are allowed.")
        return list(entries)

    def required(self, data: Mapping[str, object], key: str, where: str) -> object:
        """Return `data[key]`, which must be there."""
        if key not in data:
            raise self.error(f'{where} has no "{key}"; add it.')
        return data[key]

    def inner(self, data: Mapping[str, object], key: str, where: str, place: str = "") -> Mapping[str, object]:
        """Return the object at `data[key]`, which must be there; messages about it call it `place`."""
        return self.mapping(self.required(data, key, where), place or f"{where}: {key}")

    def bounding_box(self, data: Mapping[str, object], where: str) -> tuple[object, object, object]:
        """Return x, y and z of the box in an asset's metadata, not yet checked."""
        place = f"{where}: assetMetadata"
        box = self.inner(self.inner(data, "assetMetadata", where), "boundingBox", place, f"{place}.boundingBox")
        x, y, z = (self.required(box, axis, f"{place}.boundingBox") for axis in "xyz")
        return x, y, z

    def number(
        self,
        value: object,
        where: str,
        *,
        above: float | None = None,
        least: float | None = None,
        most: float = LIMITS.length,
        is_length: bool = True,
    ) -> float:
        """Return `value` as a finite float within (above, most] or [least, most]; a length may be in the wrong unit."""
        number = math.inf
        if not isinstance(value, bool) and isinstance(value, Real):
            with suppress(OverflowError):
                number = float(value)
        if not abs(number) <= 1e300:
            raise self.error(f"{where} must be a finite number, but is {show(value)}.")
        if above is not None and number <= above:
            raise self.error(f"{where} must be above {above:g}, but is {show(value)}.")
        if least is not None and number < least:
            raise self.error(f"{where} must be at least {least:g}, but is {show(value)}.")
        if number > most:
            told = is_length and most <= LIMITS.length and number <= 100 * most
            ask = f" Lengths are in metres: is it in centimetres? Then write {number / 100:g}." if told else ""
            raise self.error(f"{where} must be at most {most:g}, but is {show(value)}.{ask}")
        return number + 0.0

    def numbers(self, value: object, where: str, count: tuple[int, ...]) -> tuple[float, ...]:
        """Return a list of as many finite numbers as one of `count` says."""
        entries = self.sequence(value, where, most=max(count))
        if len(entries) not in count:
            allowed = " or ".join(str(n) for n in count)
            raise self.error(f"{where} must have {allowed} numbers, but has {len(entries)}.")
        far = LIMITS.farthest
        return tuple(self.number(entry, f"{where}[{i}]", least=-far, most=far) for i, entry in enumerate(entries))

    def text(self, value: object, where: str, most: int = LIMITS.text) -> str:
        """Return `value` if it is a text of at most `most` characters."""
        if not isinstance(value, str):
            raise self.error(f"{where} must be a text, but is {show(value)}.")
        if len(value) > most:
            raise self.error(f"{where} has {len(value)} characters; at most {most} are allowed.")
        try:
            value.encode()
        except UnicodeEncodeError as error:
            message = f"{where} contains characters that are no text (a lone surrogate at {error.start})."
            raise self.error(message) from None
        return value

    def flag(self, value: object, where: str) -> bool:
        """Return `value` if it is true or false."""
        if not isinstance(value, bool):
            raise self.error(f"{where} must be true or false, but is {show(value)}.")
        return value

    def read_json(self, path: Path, what: str, most: int = LIMITS.file_bytes) -> object:
        """Return the content of a JSON file; duplicate keys, deep nesting and large files are refused."""
        return self.parse(json_value, self.read_text(path, what, most), f"{what} {path}")

    def read_toml(self, path: Path, what: str, most: int = LIMITS.file_bytes) -> dict[str, object]:
        """Return the tables of a TOML file."""
        return self.parse(toml_value, self.read_text(path, what, most), f"{what} {path}")

    def read_text(self, path: Path, what: str, most: int = LIMITS.file_bytes) -> str:
        """Return the text of a file of at most `most` bytes, in UTF-8."""
        return self.parse(decoded, self.read_bytes(path, what, most), f"{what} {path}")

    def read_bytes(self, path: Path, what: str, most: int = LIMITS.file_bytes) -> bytes:
        """Return the content of a regular file of at most `most` bytes."""
        if os.path.isdir(path):
            files, likely = [name for name in _names(path) if name.endswith(".json")], f"{what.split()[0]}.json"
            such = next((f", such as {path / name}" for name in (likely, *files) if name in files), "")
            raise self.error(f"{what} {path} is a folder; name the file in it{such}.")
        if not os.path.lexists(path):
            shown = str(path) if len(str(path)) <= LIMITS.shown else f"{str(path)[: LIMITS.shown]}..."
            near = difflib.get_close_matches(path.name[:200], _names(path.parent), n=1, cutoff=0.75)
            meant = f"did you mean {str(path.with_name(near[0]))!r}? Or " if near else ""
            raise self.error(f"{what} {shown} does not exist; {meant}check the path.")
        return self.parse(lambda place: regular_bytes(place, most), path, f"{what} {path}")

    def parse(self, read: Callable[[Given], Made], given: Given, what: str) -> Made:
        """Return what a reader makes of something; what it cannot read is an error about `what`."""
        try:
            return read(given)
        except Unreadable as error:
            raise self.error(f"{what} {error}.") from None

    def plain(self, value: object, where: str) -> object:
        """Return a value that is kept as it is, once it is known that it can be written again."""
        self.parse(check_plain, value, where)
        return value


def whole(value: object, where: str, least: int = 0) -> None:
    """Refuse what is no whole number of at least `least`."""
    if not isinstance(value, Integral) or int(value) < least:
        raise InputError(f"{where} must be a whole number of at least {least}, but is {show(value)}.")


def misspelt(keys: Iterable[str], known: Iterable[str], where: str) -> list[str]:
    """Return one warning for each unknown key that looks like a known one."""
    names = list(known)
    pairs = ((key, difflib.get_close_matches(key[:40], names, n=1, cutoff=0.8)) for key in keys if key not in names)
    return [f"{where}: {show(key)} is not known; did you mean {near[0]!r}?" for key, near in pairs if near]


def _names(folder: Path) -> list[str]:
    """Return the names in a folder, sorted; none where it cannot be looked into."""
    with suppress(OSError, ValueError):
        return sorted(os.listdir(folder))
    return []


def regular_bytes(path: Path, most: int) -> bytes:
    """Return the content of a regular file of at most `most` bytes; raises `Unreadable` for anything else."""
    if os.path.isdir(path):
        raise Unreadable("is a folder")
    try:
        with os.fdopen(os.open(path, _HOW), "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise Unreadable("is no regular file but a pipe or a device; write its content to a file and name that")
            content = file.read(most + 1)
    except (FileNotFoundError, NotADirectoryError, ValueError):  # ValueError: a null byte in the path
        raise Unreadable("does not exist; check the path") from None
    except OSError as error:
        raise Unreadable(f"cannot be read: {error.strerror or error}") from None
    if len(content) > most:
        raise Unreadable(f"is larger than {most // 1_000_000} MB")
    return content


def inside(path: Path, folders: Iterable[Path]) -> bool:
    """Return whether `path`, links followed, lies in one of the folders."""
    try:
        return any(path.resolve().is_relative_to(folder.resolve()) for folder in folders)
    except (OSError, ValueError, RuntimeError):  # too long, a null byte, a loop of links
        return False
