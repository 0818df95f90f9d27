"""Everything that the command line says: lines and tables on standard output, sentences on standard error.

Names and messages come from files that anybody may have written: each line is made printable, and nothing in it is markup.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from robolayout._text import TOLD, printable

if TYPE_CHECKING:
    from robolayout.verify import Report

WIDTH = 140  # columns of a table that goes to a file or another program


def say(*lines: str) -> None:
    """Print lines on standard output."""
    _write(sys.stdout, [printable(line) for line in lines])


def warn(*lines: str) -> None:
    """Print lines on standard error, the first after the name of the program; where nobody can read them, nowhere."""
    with suppress(OSError):
        _write(sys.stderr, [f"robolayout: {printable(lines[0])}", *map(printable, lines[1:])])


def _write(stream: TextIO, lines: Sequence[str]) -> None:
    stream.write("".join(f"{line}\n" for line in lines))
    stream.flush()


def table(title: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    drawn = Table(title=Text(printable(title)), title_justify="left")
    for head in heads:
        drawn.add_column(Text(printable(head)), overflow="fold")
    for row in rows:
        drawn.add_row(*(Text(printable(cell)) for cell in row))
    console = Console(width=None if sys.stdout.isatty() else WIDTH)
    with console.capture() as captured:
        console.print(drawn)
    sys.stdout.write(captured.get())


def bulleted(sentences: Sequence[str], where: str) -> None:
    """Print the first of some sentences, one a line, and how many more there are, and where."""
    say(*(f"- {sentence}" for sentence in sentences[: TOLD.shown]))
    if len(sentences) > TOLD.shown:
        say(f"- and {len(sentences) - TOLD.shown} more in the {where}")


def show(report: Report, files: Sequence[Path]) -> None:
    """Print what was asked and the short report, what is wrong, and where the files are."""
    from robolayout.verify.present import VERDICTS, lying_about, rule_rows

    if report.asked:
        asked = [[row.words, row.understanding, row.verdict, row.value] for row in report.asked]
        table("Asked", ["words", "understood as", "verdict", "measured"], asked)
    rows = [[name, value, VERDICTS[met].replace("short", "SHORT")] for name, value, met in report.rows()]
    table(f"{report.scene.name} for {', '.join(a.agent.name for a in report.agents)}", ["check", "result", ""], rows)
    if report.rules:
        found = [[name, text, met, source] for name, _, text, met, source in rule_rows(report)]
        table("rules of accessibility, beside the demands", ["rule", "measured", "", "source"], found)
    bulleted(report.violations, "report")
    say(*lying_about(report), *report.notes, *report.opinion.get("sentences", ()))
    if report.not_understood:
        say(report.not_understood)
    say(*map(str, files))


@contextmanager
def progress(quiet: bool) -> Generator[Callable[[str], None]]:
    """Show the running phase on a terminal; elsewhere nobody is told."""
    if quiet or not sys.stderr.isatty():
        from robolayout.solve import silent

        yield silent
        return
    from rich.console import Console

    with Console(stderr=True, markup=False).status("starting") as status:

        def tell(phase: str) -> None:
            status.update(f"{printable(phase)} ...")

        yield tell
