"""Writing files so that a killed run, a full disk or a read-only folder leaves no half file behind."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from robolayout._errors import OutputError
from robolayout._text import utf8


def check_writable(folder: Path) -> None:
    """Refuse a folder that cannot be made or written to, before any work is done for it.

    Raises:
        OutputError: The nearest existing folder above (or the folder itself) is none or is read-only.
    """
    nearest = next(path for path in (folder.absolute(), *folder.absolute().parents) if path.exists())
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
