"""Opening files: regular ones only, at most so many bytes, and never a folder's worth of links."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable
from pathlib import Path

from robolayout._reading.syntax import Unreadable

MESH_SUFFIXES = (".glb", ".obj", ".ply", ".stl")  # kinds of mesh file that are read
_HOW = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
"""Without waiting: a pipe that nobody writes to would hold up its reader for ever."""


def regular_bytes(path: Path, most: int) -> bytes:
    """Return the content of a regular file of at most `most` bytes; raises `Unreadable` for anything else."""
    if os.path.isdir(path):
        raise Unreadable("is a folder")
    try:
        descriptor = os.open(path, _HOW)
        try:
            content = _content(descriptor, most)
        finally:
            os.close(descriptor)
    except (FileNotFoundError, NotADirectoryError, ValueError):  # ValueError: a null byte in the path
        raise Unreadable("does not exist; check the path") from None
    except OSError as error:
        raise Unreadable(f"cannot be read: {error.strerror or error}") from None
    if len(content) > most:
        raise Unreadable(f"is larger than {most // 1_000_000} MB")
    return content


def _content(descriptor: int, most: int) -> bytes:
    """Return at most one byte more than `most` of an open file."""
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        raise Unreadable("is no regular file but a pipe or a device; write its content to a file and name that")
    with os.fdopen(descriptor, "rb", closefd=False) as file:
        return file.read(most + 1)


def inside(path: Path, folders: Iterable[Path]) -> bool:
    """Return whether `path`, links followed, lies in one of the folders."""
    try:
        return any(path.resolve().is_relative_to(folder.resolve()) for folder in folders)
    except (OSError, ValueError, RuntimeError):  # too long, a null byte, a loop of links
        return False
