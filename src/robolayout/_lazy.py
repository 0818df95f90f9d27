"""Names of a package that are loaded when they are first used, so that importing the package costs nothing."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Any


def loader(package: str, homes: Mapping[str, str]) -> Callable[[str], Any]:
    """Return the `__getattr__` of a package.

    Args:
        homes: The names that each module of the package holds, in one text ("Camera eye_camera"); one that is called
            otherwise there is written with both names ("render:render_view").
    """
    pairs = ((name.partition(":"), module) for module, names in homes.items() for name in names.split())
    found = {name: (module, own or name) for (name, _, own), module in pairs}

    def load(name: str) -> Any:
        if name not in found:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module, own = found[name]
        value = getattr(import_module(f"{package}.{module}"), own)
        setattr(sys.modules[package], name, value)
        return value

    return load
