"""The report as a pandas table: one row per asset."""

from __future__ import annotations

import math
from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from robolayout._errors import MissingExtraError
from robolayout.scene import Asset

if TYPE_CHECKING:
    from robolayout.verify.report import Report

CHECKS = ("placed", "collision_free", "in_boundary", "supported")  # the physical verdicts


def report_frame(report: Report) -> Any:
    """Return a DataFrame with one row per asset: pose, box, verdicts, and what each agent can do with it."""
    if find_spec("pandas") is None:
        raise MissingExtraError("to_frame()", "pandas", package=True)
    pandas: Any = import_module("pandas")
    rows = [dict(_cells(report, asset)) for asset in report.scene.assets]
    return pandas.DataFrame(rows, index=pandas.Index([asset.name for asset in report.scene.assets], name="asset"))


def _cells(report: Report, asset: Asset) -> Iterator[tuple[str, object]]:
    """Yield the cells of an asset by column: metres and degrees, NaN where there is nothing."""
    name, pose = asset.name, report.layout.get(asset.name)
    place = (math.nan,) * 4 if pose is None else (pose.x, pose.y, pose.z, math.degrees(pose.yaw) % 360.0)
    yield from zip(("x", "y", "z", "yaw"), place, strict=True)
    yield from zip(("depth", "width", "height"), asset.size, strict=True)
    yield from ((check, getattr(report.physics, check)[name]) for check in CHECKS)
    for found in report.agents:
        mark = f"{found.agent.name}: " if len(report.agents) > 1 else ""
        nav = found.navigation
        yield f"{mark}reached", nav.reached[name]
        yield f"{mark}usable", found.usage.usable[name]
        yield f"{mark}route", nav.routes[name].length if name in nav.routes else math.nan
        yield f"{mark}passage", nav.passages[name].width if name in nav.passages else math.nan
