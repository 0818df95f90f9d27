"""What other installed packages register through entry points."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import EntryPoint
from typing import Any

from robolayout._errors import InputError
from robolayout._reading.syntax import FOREIGN_ERRORS


def loaded(point: EntryPoint, what: str, fits: Callable[[Any], bool]) -> Any:
    """Return what an entry point names; raises `InputError`, which names its package, where that is not `what` it should be."""
    package = point.dist.name if point.dist else "an unknown package"
    where = f"the entry point {point.name!r} ({point.value}) in {point.group}, of {package},"
    try:
        found = point.load()
    except FOREIGN_ERRORS as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:300]
        raise InputError(f"{where} cannot be loaded: {reason}. Correct or uninstall that package.") from error
    if not fits(found):
        raise InputError(f"{where} is no {what}. Correct or uninstall that package.")
    return found
