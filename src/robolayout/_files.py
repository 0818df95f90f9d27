"""Writing files so that a killed run, a full disk or a read-only folder leaves no half file behind."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Generator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from robolayout._errors import OutputError
from robolayout._text import utf8

AT_HERE, EXCHANGE = -100, 2  # Linux: names are relative to the current folder; `renameat2` swaps two names


def check_writable(folder: Path) -> None:
    """Refuse a folder that cannot be made or written to, before any work is done for it."""
    nearest = next(path for path in (folder.absolute(), *folder.absolute().parents) if os.path.exists(path))
    if not nearest.is_dir():
        raise OutputError(f"cannot write to {folder}: {nearest} is not a folder; choose another one.")
    if not os.access(nearest, os.W_OK | os.X_OK):
        raise OutputError(f"cannot write to {folder}: {nearest} is read-only; choose a folder that you may write to.")


def write_atomic(path: Path, data: bytes | str) -> Path:
    """Write a file in one step, text as UTF-8, missing folders too: either the whole new content is there, or what was before."""
    return write_together({path: data})[0]


def write_together(files: Mapping[Path, bytes | str]) -> list[Path]:
    """Write files that need each other: none takes its place, in the order given, before the contents of all have reached the disk.

    Raises `OutputError` where one cannot be written; no temporary file and no folder that was made for them is left.
    """
    waiting: dict[Path, Path] = {}
    folders: list[Path] = []
    path, content = Path(), b""
    try:
        for path, data in files.items():
            content = utf8(data) if isinstance(data, str) else data
            folders += [folder for folder in (path.parent, *path.parent.parents) if not os.path.exists(folder)]
            path.parent.mkdir(parents=True, exist_ok=True)
            waiting[path] = path.with_name(f".{path.name}.{os.getpid()}.tmp")
            descriptor = os.open(waiting[path], os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o666)
            with os.fdopen(descriptor, "wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
        for path, temporary in waiting.items():
            os.replace(temporary, path)
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(
            f"cannot write {path} ({len(content)} bytes): {reason}. Nothing was left half-written; "
            "free some space or choose a folder that you may write to."
        ) from error
    finally:
        for temporary in waiting.values():
            with suppress(OSError):
                temporary.unlink()
        for folder in sorted(folders, reverse=True):
            with suppress(OSError):
                folder.rmdir()  # it stays where something is in it
    return list(files)


def exchange(one: Path, other: Path) -> bool:
    """Swap the names of two files or folders in one step, and return whether the system could."""
    try:
        swap = ctypes.CDLL(None).renameat2
    except (AttributeError, OSError, TypeError):  # another system, an old library
        return False
    return swap(AT_HERE, os.fsencode(one), AT_HERE, os.fsencode(other), EXCHANGE) == 0


@contextmanager
def locked(path: Path, folder: Path) -> Generator[None]:
    """Hold a lock file while the block runs; the system lets go of it when the process ends, whatever ends it.

    Raises `OutputError`, which names the folder, where another process or block holds it, or it cannot be made.
    """
    try:
        descriptor = _hold(path, folder)
    except ImportError:  # a system without such locks
        yield
        return
    except OSError as error:
        raise OutputError(
            f"cannot write to {folder}: {path} cannot be made ({error.strerror}); choose another folder."
        ) from error
    try:
        yield
    finally:
        with suppress(OSError):
            path.unlink()
        os.close(descriptor)


def _hold(path: Path, folder: Path) -> int:
    """Return the descriptor of a lock file that is locked and still has its name."""
    import fcntl

    while True:
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o666)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            holder = os.read(descriptor, 20).decode(errors="replace")
            os.close(descriptor)
            raise OutputError(
                f"another run{f' (process {holder})' if holder else ''} is writing to {folder}; wait until it has ended, "
                "or choose another folder."
            ) from None
        except OSError:  # a file system without locks
            return descriptor
        with suppress(OSError):
            if os.path.samestat(os.fstat(descriptor), path.stat()):
                os.ftruncate(descriptor, 0)
                os.write(descriptor, str(os.getpid()).encode())
                return descriptor
        os.close(descriptor)
