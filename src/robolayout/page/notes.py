"""What a sheet to print and the page say beside their drawings, taken from a report."""

from __future__ import annotations

from typing import Any

from shapely import Polygon, union_all

from robolayout.render import SheetNotes
from robolayout.scene import vertical_span
from robolayout.verify import AgentReport, Report

STANDS = 0.05  # metres above the floor up to which a thing stands on it


def sheet_notes(report: Report, date: str = "") -> SheetNotes:
    """Return areas, findings and rules for the first body of a report; `date` is what the title block says."""
    first = report.agents[0]
    verdict = "all demands are met" if report.ok else "not all demands are met"
    helps = first.remedies.sentences(first.agent)
    rules = tuple(
        (f"{row['name']}: {row['measured']} ({row['source']})", row["met"])
        for row in rule_rows(report)
        if row["agent"] == first.agent.name
    )
    findings = (*first.impossible, *report.violations, *helps)
    return SheetNotes(date, _areas(first), verdict, findings, rules, first.navigation.boxes.carried)


def rule_rows(report: Report) -> list[dict[str, Any]]:
    """Return the named rules of a report as plain data: for whom, what, its source, what was measured, and whether it is met."""
    return [
        {
            "agent": found.agent,
            "name": found.rule.name.replace("_", " "),
            "asks": found.rule.asks,
            "source": found.rule.origin,
            "measured": found.measured.text,
            "met": found.met,
        }
        for found in report.rules
    ]


def _areas(first: AgentReport) -> tuple[tuple[str, str], ...]:
    """Return the areas of a room, and how much of it is furnished and free."""
    nav = first.navigation
    room = Polygon(nav.scene.room.vertices)
    placed = [(nav.scene.by_name[name], pose) for name, pose in nav.layout.items()]
    standing = [
        Polygon(pose.corners(asset.size))
        for asset, pose in placed
        if not asset.is_flat and vertical_span(asset, pose)[0] < STANDS
    ]
    furnished = union_all(standing).intersection(room).area
    return (
        ("Floor", f"{room.area:.2f} m2"),
        ("under furniture", f"{furnished:.2f} m2"),
        ("free floor", f"{room.area - furnished:.2f} m2"),
        ("where the body's centre gets to", f"{nav.main.area:.2f} m2"),
        ("Height of the walls", f"{nav.scene.room.wall_height:.2f} m"),
    )
