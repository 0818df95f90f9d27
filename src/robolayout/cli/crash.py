"""What is said and kept of an error that nobody foresaw: places in programs and versions, no names, keys or contents."""

from __future__ import annotations

import hashlib
import os
import platform
import re
import sys
import tempfile
import traceback
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path

from robolayout._text import TOLD, utf8
from robolayout._version import __version__

DEBUG = "ROBOLAYOUT_DEBUG"
"""Environment variable: if set, the file also holds messages and the whole command line, and so names and contents."""

EXTENSIONS = ("robolayout.exporters", "robolayout.agents")
"""Groups of entry points of other packages, besides relations, which know their modules."""

LIBRARIES = ("jax", "jaxlib", "numpy", "scipy", "shapely", "trimesh", "typer", "pydantic-monty")
"""Libraries whose versions may matter."""


def sentence(error: BaseException, note: Path | None) -> str:
    """Return what to tell the user."""
    if isinstance(error, MemoryError):
        what = "there is not enough memory for this: close other programs, use fewer --starts or a smaller scene."
    else:
        message = str(error)[:200]
        what = f"this is a mistake of RoboLayout, not yours ({type(error).__name__}{': ' * bool(message)}{message})."
    if note is None:
        return f"{what} If it stays, please report what you did; no file about it could be written."
    return f"{what} If it stays, please report what you did and send {note}, which holds no names, keys or contents."


def outside(error: BaseException) -> str:
    """Return where in an extension of the user's own an error arose, and what it says; empty where it arose here or in a library."""
    from importlib.metadata import entry_points

    names = {point.module for group in EXTENSIONS for point in entry_points(group=group)}
    relations = getattr(sys.modules.get("robolayout.constraints"), "RELATIONS", {})  # it may have failed to load
    names |= {one.__module__ for one in relations.values() if not one.__module__.startswith("robolayout.")}
    theirs = {getattr(sys.modules.get(name), "__file__", None) for name in names}
    ours = Path(__file__).parents[1]
    for frame in reversed(traceback.extract_tb(error.__traceback__)):
        if frame.filename in theirs:
            reason = " ".join(f"{type(error).__name__}: {error}".split())[:300]
            return f"{frame.filename}, line {frame.lineno}, in {frame.name}: {reason}"
        if Path(frame.filename).is_relative_to(ours):
            return ""
    return ""


def write_note(error: BaseException, words: Sequence[str]) -> Path | None:
    """Write what helps to find the mistake to the folder for temporary files, else to the current one; None where neither can be written.

    The file is named after what it says: the same mistake twice is one file.
    """
    data = utf8("".join(f"{line}\n" for line in _lines(error, words)))
    name = f"robolayout-error-{hashlib.sha256(data).hexdigest()[:12]}.txt"
    for folder in (tempfile.gettempdir, Path.cwd):
        with suppress(OSError):
            path = Path(folder()) / name
            try:
                with path.open("xb") as file:  # never through a link that somebody else has put there
                    file.write(data)
            except FileExistsError:
                if path.read_bytes() != data:
                    continue
            return path
    return None


def _lines(error: BaseException, words: Sequence[str]) -> Iterator[str]:
    """Yield what the file says."""
    from importlib.metadata import PackageNotFoundError, version

    whole = bool(os.environ.get(DEBUG))
    yield f"robolayout {__version__}, Python {platform.python_version()}, {platform.system()} {platform.machine()}"
    for library in LIBRARIES:
        with suppress(PackageNotFoundError):
            yield f"{library} {version(library)}"
    yield f"command: {' '.join(words if whole else _plain(words))}"
    link: BaseException | None = error
    seen = set[int]()
    while link is not None and id(link) not in seen:
        seen.add(id(link))
        yield f"{type(link).__name__}{f': {link}' if whole else ''}"
        yield from _places(link)
        link = link.__cause__ or link.__context__


def _plain(words: Sequence[str]) -> Iterator[str]:
    """Yield the command and the names of its options; every value is a dot."""
    for number, word in enumerate(words):
        option = re.match(r"--?[a-z][a-z-]{0,30}(?==|$)", word)
        command = number == 0 and re.fullmatch(r"[a-z]{1,20}", word)
        yield word if command else option[0] if option else "."


def _places(error: BaseException) -> list[str]:
    """Return file, line and function of each call, the file from its package on; of very many the first and the last."""
    frames = traceback.extract_tb(error.__traceback__)
    places = [f"  {_below_root(Path(frame.filename))}:{frame.lineno} {frame.name}" for frame in frames]
    if (more := len(places) - 2 * TOLD.ends) > 0:
        places[TOLD.ends : -TOLD.ends] = [f"  ... {more} more"]
    return places


def _below_root(path: Path) -> str:
    """Return a path from the nearest folder that programs are loaded from; elsewhere the file's name."""
    roots = [Path(root) for root in sys.path if root and path.is_relative_to(root)]
    return path.relative_to(max(roots, key=lambda root: len(root.parts))).as_posix() if roots else path.name
