"""Tables on the terminal."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from robolayout.verify import Report

SHOWN = 12
"""Violations that are printed; the report holds all."""


def table(title: str, heads: list[str], rows: list[list[str]]) -> None:
    """Print a table."""
    from rich.console import Console
    from rich.table import Table

    drawn = Table(title=title, title_justify="left")
    for head in heads:
        drawn.add_column(head, overflow="fold")
    for row in rows:
        drawn.add_row(*row)
    Console(width=None if sys.stdout.isatty() else 140).print(drawn)


def show(report: Report, files: list[Path]) -> None:
    """Print what was asked and the short report, what is wrong, and where the files are."""
    if report.asked:
        asked = [[row.words, row.understanding, row.verdict, row.value] for row in report.asked]
        table("Asked", ["words", "understood as", "verdict", "measured"], asked)
    rows = [[name, value, "ok" if met else "SHORT"] for name, value, met in report.rows()]
    table(f"{report.scene.name} for {', '.join(a.agent.name for a in report.agents)}", ["check", "result", ""], rows)
    for sentence in report.violations[:SHOWN]:
        typer.echo(f"- {sentence}")
    if len(report.violations) > SHOWN:
        typer.echo(f"- and {len(report.violations) - SHOWN} more in the report")
    if report.not_understood:
        typer.echo(report.not_understood)
    for path in files:
        typer.echo(str(path))
