"""The report as a pandas table: one row per asset."""

from __future__ import annotations

import math
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from robolayout._errors import MissingExtraError
from robolayout.scene import Layout

if TYPE_CHECKING:
    from robolayout.verify.agent_report import AgentReport
    from robolayout.verify.report import Report


def report_frame(report: Report) -> Any:
    """Return a DataFrame with one row per asset: pose, box, verdicts, and what each agent can do with it.

    Raises:
        MissingExtraError: pandas is not installed.
    """
    if find_spec("pandas") is None:
        raise MissingExtraError("to_frame()", "pandas", package=True)
    pandas: Any = import_module("pandas")
    names = [asset.name for asset in report.scene.assets]
    columns = _poses(report, names) | _verdicts(report, names)
    for found in report.agents:
        mark = f"{found.agent.name}: " if len(report.agents) > 1 else ""
        columns |= {f"{mark}{head}": values for head, values in _agent(found, names).items()}
    return pandas.DataFrame(columns, index=pandas.Index(names, name="asset"))


def _poses(report: Report, names: list[str]) -> dict[str, list[Any]]:
    """Return the columns of poses (NaN where unplaced) and boxes, metres and degrees."""
    layout: Layout = report.layout
    poses = [layout.get(name) for name in names]
    sizes = [asset.size for asset in report.scene.assets]
    return {
        "x": [math.nan if pose is None else pose.x for pose in poses],
        "y": [math.nan if pose is None else pose.y for pose in poses],
        "z": [math.nan if pose is None else pose.z for pose in poses],
        "yaw": [math.nan if pose is None else math.degrees(pose.yaw) % 360.0 for pose in poses],
        "depth": [size[0] for size in sizes],
        "width": [size[1] for size in sizes],
        "height": [size[2] for size in sizes],
    }


def _verdicts(report: Report, names: list[str]) -> dict[str, list[Any]]:
    """Return the columns of physical verdicts."""
    checks = ("placed", "collision_free", "in_boundary", "supported")
    return {check: [getattr(report.physics, check)[name] for name in names] for check in checks}


def _agent(found: AgentReport, names: list[str]) -> dict[str, list[Any]]:
    """Return the columns of one agent: reached, usable, metres of way, metres of its narrowest place."""
    nav = found.navigation
    routes, passages = nav.routes, nav.passages
    return {
        "reached": [bool(nav.reached.get(name, False)) for name in names],
        "usable": [bool(found.usage.usable.get(name, False)) for name in names],
        "route": [routes[name].length if name in routes else math.nan for name in names],
        "passage": [passages[name].width if name in passages else math.nan for name in names],
    }
