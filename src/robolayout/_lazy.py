"""Names of a package that are loaded when they are first used, so that importing the package costs nothing."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any

IMPORT = re.compile(r"^    from (\S+) import ([^(\n]+|\([^)]+)", re.MULTILINE)  # an import in a block


def loader(package: str, file: str) -> Callable[[str], Any]:
    """Return the `__getattr__` of a package: it loads what the package's file imports in its block for type checkers."""
    with open(file, encoding="utf-8") as source:  # to parse it would double the time that importing the package takes
        imports = IMPORT.findall(source.read())
    pairs = ((module, *name) for module, names in imports for name in re.findall(r"(\w+)(?: as (\w+))?", names))
    found = {name or own: (module, own) for module, own, name in pairs}

    def load(name: str) -> Any:
        if name not in found:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module, own = found[name]
        value = getattr(import_module(module), own)
        setattr(sys.modules[package], name, value)
        return value

    return load
