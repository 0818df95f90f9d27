"""The user's private folder of compiled programs.

Its entries are machine code that later processes load and run, so the folder must belong to the user alone: it is made with
mode 0700, and one that somebody else owns or may write to is not used.
"""

from __future__ import annotations

import hashlib
import json
import os
import platform
import stat
import sys
import warnings
import zlib
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from robolayout._errors import OutputError
from robolayout._files import write_atomic

VARIABLE = "ROBOLAYOUT_CACHE"
"""Environment variable that names the folder; "off" does without."""

MOST_BYTES = 200_000_000
"""Size of the folder from which on the entries unused for longest are removed."""

LARGEST_ENTRY = 100_000_000
"""Bytes of the largest entry that is read, compressed or not."""

MAGIC = b"robolayout-program-1\n"


def cache_folder() -> Path | None:
    """Return the folder, made if need be; None (with a warning) if it cannot be used safely.

    It is `$ROBOLAYOUT_CACHE`, else `$XDG_CACHE_HOME/robolayout`, else the platform's folder for caches.
    """
    chosen = os.environ.get(VARIABLE, "")
    if chosen.lower() == "off":
        return None
    folder = Path(chosen) if chosen else _default_folder()
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        fault = _fault(folder)
    except (OSError, RuntimeError) as error:
        fault = f"cannot be made ({error})"
    if fault is None:
        return folder
    _warn(f"{folder} {fault}")
    return None


def _default_folder() -> Path:
    if os.environ.get("XDG_CACHE_HOME"):
        return Path(os.environ["XDG_CACHE_HOME"], "robolayout")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "robolayout"
    if sys.platform == "win32" and os.environ.get("LOCALAPPDATA"):
        return Path(os.environ["LOCALAPPDATA"], "robolayout", "cache")
    return Path.home() / ".cache" / "robolayout"


def _fault(folder: Path) -> str | None:
    """Return why code must not be loaded from a folder; None if nothing speaks against it."""
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode):
        return "is a link or no folder"
    if hasattr(os, "geteuid"):
        if found.st_uid != os.geteuid():
            return "belongs to another user"
        if found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
            return "may be written to by others"
    return None


@cache
def _warn(reason: str) -> None:
    """Warn once per reason."""
    warnings.warn(
        f"compiled programs are not kept: {reason}. Name a folder of your own in {VARIABLE}, or set it to off.",
        stacklevel=2,
    )


def entry_key(*parts: object) -> str:
    """Return the name of the entry for a program: everything that its machine code depends on, hashed.

    Args:
        parts: What the caller knows of the program; their `repr` must be the same in every process.
    """
    from jaxlib import version

    known = [version.__version__, platform.machine(), _processor(), os.environ.get("XLA_FLAGS", ""), _source_hash()]
    return hashlib.sha256("\n".join(map(repr, [*known, *parts])).encode()).hexdigest()[:40]


@cache
def _processor() -> str:
    """Return the name and abilities of the processor, which machine code is made for."""
    with suppress(OSError):
        lines = Path("/proc/cpuinfo").read_text("utf-8", "replace").splitlines()
        told = {line.split(":")[0].strip(): line for line in reversed(lines)}
        return "".join(told.get(name, "") for name in ("model name", "flags", "Features", "CPU part"))
    return platform.processor()


@cache
def _source_hash() -> str:
    """Return a hash of the code that programs are compiled from."""
    solve = Path(__file__).parent
    files = sorted(solve.rglob("*.py")) + sorted((solve.parent / "_geometry").glob("*.py"))
    return hashlib.sha256(b"\0".join(file.read_bytes() for file in files)).hexdigest()


def read_entry(key: str) -> tuple[dict[str, Any], bytes] | None:
    """Return what an entry says of its program, and its machine code; None if there is none that is whole and the user's."""
    folder = cache_folder()
    if folder is None:
        return None
    path = folder / f"{key}.xla"
    try:
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0))
        with os.fdopen(descriptor, "rb") as file:
            found = os.fstat(descriptor)
            if hasattr(os, "geteuid") and found.st_uid != os.geteuid():
                return None
            data = file.read(LARGEST_ENTRY)
        with suppress(OSError):
            os.utime(path)
    except OSError:
        return None
    return _unpacked(data)


def _unpacked(data: bytes) -> tuple[dict[str, Any], bytes] | None:
    digest, body = data[len(MAGIC) : len(MAGIC) + 32], data[len(MAGIC) + 32 :]
    if not data.startswith(MAGIC) or hashlib.sha256(body).digest() != digest:
        return None
    content = zlib.decompressobj().decompress(body, LARGEST_ENTRY)
    head, _, code = content.partition(b"\n")
    return json.loads(head), code


def has_entry(key: str) -> bool:
    """Return whether there is an entry, without a look at it."""
    folder = cache_folder()
    return folder is not None and (folder / f"{key}.xla").is_file()


def write_entry(key: str, about: dict[str, Any], code: bytes) -> None:
    """Keep a program for later processes; a folder that cannot be written to costs a warning, nothing more."""
    folder = cache_folder()
    if folder is None:
        return
    body = zlib.compress(json.dumps(about).encode() + b"\n" + code, 1)
    try:
        write_atomic(folder / f"{key}.xla", MAGIC + hashlib.sha256(body).digest() + body)
    except OutputError as error:
        _warn(str(error))
    _prune(folder)


def _prune(folder: Path) -> None:
    """Remove the entries unused for longest, until the folder is small enough."""
    with suppress(OSError):
        entries = sorted((entry.stat().st_mtime, entry.name, entry.stat().st_size) for entry in folder.glob("*.xla"))
        excess = sum(size for _, _, size in entries) - MOST_BYTES
        for _, name, size in entries:
            if excess <= 0:
                break
            (folder / name).unlink(missing_ok=True)
            excess -= size
