"""Writing files so that a killed run, a full disk or a read-only folder leaves no half file behind."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Generator
from contextlib import contextmanager, suppress
from pathlib import Path

from robolayout._errors import OutputError
from robolayout._text import utf8

AT_HERE, EXCHANGE = -100, 2
"""Linux: names are relative to the current folder; `renameat2` swaps two names."""


def check_writable(folder: Path) -> None:
    """Refuse a folder that cannot be made or written to, before any work is done for it.

    Raises:
        OutputError: The nearest existing folder above (or the folder itself) is none or is read-only.
    """
    nearest = next(path for path in (folder.absolute(), *folder.absolute().parents) if os.path.exists(path))
    if not nearest.is_dir():
        raise OutputError(f"cannot write to {folder}: {nearest} is not a folder; choose another one.")
    if not os.access(nearest, os.W_OK | os.X_OK):
        raise OutputError(f"cannot write to {folder}: {nearest} is read-only; choose a folder that you may write to.")


def write_atomic(path: Path, data: bytes | str) -> Path:
    """Write a file in one step: either the whole new content is there, or what was there before.

    The data goes to a temporary file in the same folder, reaches the disk, and then takes the place of `path`. Missing
    folders are made. Text is written as UTF-8 with the line ends it has.

    Args:
        path: Where to write.
        data: The whole content.

    Returns:
        The path.

    Raises:
        OutputError: The folder or file cannot be written; nothing is left half-written.
    """
    content = utf8(data) if isinstance(data, str) else data
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        descriptor = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o666)
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(
            f"cannot write {path} ({len(content)} bytes): {reason}. Nothing was left half-written; "
            "free some space or choose a folder that you may write to."
        ) from error
    finally:
        with suppress(OSError):
            temporary.unlink()
    return path


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

    Args:
        path: The lock file.
        folder: What it locks, for the message.

    Raises:
        OutputError: Another process (or another block of this one) holds it, or it cannot be made.
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
