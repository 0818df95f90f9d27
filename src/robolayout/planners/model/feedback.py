"""What goes back to a model: what could not be read, what was rejected, what is not met, and what is wrong in the room."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from robolayout._errors import ProgramError

MOST_LINES = 40
"""Sentences of one kind that are told; more only hide the first ones."""


def feedback_text(
    *,
    error: ProgramError | None = None,
    cut: bool = False,
    dropped: Sequence[str] = (),
    rejections: Sequence[str] = (),
    violations: Sequence[str] = (),
    forgotten: Sequence[str] = (),
    wishes: Sequence[str] = (),
) -> str:
    """Return the feedback for the next attempt; empty if nothing is wrong.

    Args:
        error: Why the program could not be read, with line and caret.
        cut: Whether the answer was cut off at its end.
        dropped: What could not be read and was left out of the program, with line and caret.
        rejections: Statements that the filter rejected, with reasons (`Reconciled.rejections`).
        wishes: What a critic of the finished room wants otherwise.
        forgotten: Things that the program says nothing about, as they are written in it.
        violations: What the judge found, unmet statements with measured values included (`Report.violations`).
    """
    parts: list[str] = []
    if cut:
        parts.append("Your answer was cut off at its end, because it was too long. Write less: loops, and no comments.")
    if error is not None:
        parts.append(f"The program could not be read:\n\n{_indented(str(error))}")
    if dropped:
        told = "\n\n".join(_indented(message) for message in dropped[:MOST_LINES])
        parts.append(f"These lines could not be read and were left out; all others were used:\n\n{told}")
    if wishes:
        parts.append("The critic who saw the finished room says:\n\n" + _bullets(wishes))
    if forgotten:
        names = ", ".join(forgotten[:MOST_LINES])
        parts.append(f"The program says nothing about these things, though they must be placed: {names}.")
    if rejections:
        parts.append(
            "These statements could not be used, for the reason given, and were left out:\n\n" + _bullets(rejections)
        )
    if violations:
        parts.append("The solver did its best with the rest; the judge then measured:\n\n" + _bullets(violations))
    return "\n\n".join(parts)


def _bullets(lines: Sequence[str]) -> str:
    shown = [f"- {_one_line(line)}" for line in lines[:MOST_LINES]]
    more = len(lines) - MOST_LINES
    return "\n".join([*shown, f"- and {more} more."] if more > 0 else shown)


def _indented(text: str) -> str:
    return "\n".join(f"    {line}" for line in text.replace("```", "'''").splitlines())


def _one_line(text: str | Iterable[str]) -> str:
    return " ".join(str(text).split()).replace("```", "'''")
