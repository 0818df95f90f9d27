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
    if sys.platform == "win32" and os.environ.get("LOCALAPPDATA"):
        return Path(os.environ["LOCALAPPDATA"], "robolayout", "cache")
    return Path.home() / ("Library/Caches" if sys.platform == "darwin" else ".cache") / "robolayout"


def _fault(folder: Path) -> str | None:
    """Return why code must not be loaded from a folder; None if nothing speaks against it."""
    found = folder.lstat()
    if not stat.S_ISDIR(found.st_mode):
        return "is a link or no folder"
    if _foreign(found):
        return "belongs to another user"
    if hasattr(os, "geteuid") and found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
        return "may be written to by others"
    return None


def _foreign(found: os.stat_result) -> bool:
    return hasattr(os, "geteuid") and found.st_uid != os.geteuid()


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


def _entry(key: str) -> Path | None:
    """Return the file of an entry; None where nothing is kept."""
    folder = cache_folder()
    return folder and folder / f"{key}.xla"


def read_entry(key: str) -> tuple[dict[str, Any], bytes] | None:
    """Return what an entry says of its program, and its machine code; None if there is none that is whole and the user's."""
    path = _entry(key)
    with suppress(OSError, zlib.error):
        if path is not None and not _foreign(path.lstat()):
            head, _, code = zlib.decompress(path.read_bytes()).partition(b"\n")
            with suppress(OSError):
                os.utime(path)
            return json.loads(head), code
    return None


def has_entry(key: str) -> bool:
    """Return whether there is an entry, without a look at it."""
    path = _entry(key)
    return path is not None and path.is_file()


def write_entry(key: str, about: dict[str, Any], code: bytes) -> None:
    """Keep a program for later processes; a folder that cannot be written to costs a warning, nothing more."""
    path = _entry(key)
    if path is None:
        return
    try:
        write_atomic(path, zlib.compress(json.dumps(about).encode() + b"\n" + code, 1))
    except OutputError as error:
        _warn(str(error))
    with suppress(OSError):
        kept = 0
        for entry in sorted(path.parent.glob("*.xla"), key=lambda file: file.stat().st_mtime, reverse=True):
            kept += entry.stat().st_size
            if kept > MOST_BYTES:
                entry.unlink(missing_ok=True)
