"""What goes back to a model: what could not be read, what was rejected, what is not met, and what is wrong in the room."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from robolayout._errors import ProgramError

MOST_LINES = 40  # sentences of one kind that are told; more only hide the first ones


@dataclass(frozen=True)
class Feedback:
    """What is told before the next attempt."""

    error: ProgramError | None = None  # why the program could not be read, with line and caret
    cut: bool = False  # whether the answer was cut off at its end
    dropped: Sequence[str] = ()  # what could not be read and was left out of the program, with line and caret
    wishes: Sequence[str] = ()  # what a critic of the finished room wants otherwise
    forgotten: Sequence[str] = ()  # things that the program says nothing about, as they are written in it
    rejections: Sequence[str] = ()  # statements that the filter rejected, with reasons (`Reconciled.rejections`)
    # what the judge found, unmet statements with measured values included (`Report.violations`)
    violations: Sequence[str] = ()
    stands: str = ""  # where the things that the program is about stand, one line each
    moved: Sequence[str] = ()  # how far the solver moved things from their guesses, and why

    def text(self, names: Mapping[str, str] | None = None) -> str:
        """Return it in words, things called as a program writes them (`names`); empty if nothing is wrong."""
        forgotten = ", ".join(self.forgotten[:MOST_LINES])
        wrong = [
            "Your answer was cut off at its end, because it was too long. Write less: loops, and no comments."
            * self.cut,
            _part("The program could not be read", _indented([str(self.error)] if self.error else [])),
            _part("These lines could not be read and were left out; all others were used", _indented(self.dropped)),
            forgotten and f"The program says nothing about these things, though they must be placed: {forgotten}.",
            _part("The critic who saw the finished room says", _bullets(self.wishes, names)),
            _part(
                "These statements could not be used, for the reason given, and were left out",
                _bullets(self.rejections, names),
            ),
            _part("The solver did its best with the rest; the judge then measured", _bullets(self.violations, names)),
        ]
        state = [
            _part("The things that your program is about stand so now", _indented([self.stands])),
            _part("Some are not where your program put them", _bullets(self.moved, names)),
        ]
        return "\n\n".join(filter(None, [*wrong, *state])) if any(wrong) else ""


def _part(head: str, body: str) -> str:
    return f"{head}:\n\n{body}" if body else ""


def _bullets(lines: Sequence[str], names: Mapping[str, str] | None) -> str:
    """Return lines as a list, things called as a program writes them: `bed[0]` for "bed-0"."""
    words = names or {}
    known = "|".join(re.escape(name) for name in sorted(words, key=len, reverse=True)) or "(?!)"  # which fits nothing
    name = re.compile(rf"(?<![\w\[-])(?:{known})(?![\w\[-])")
    told = (name.sub(lambda found: words[found[0]], line).split() for line in lines[:MOST_LINES])
    shown = [f"- {' '.join(line)}".replace("```", "'''") for line in told]
    more = len(lines) - MOST_LINES
    return "\n".join([*shown, f"- and {more} more."] if more > 0 else shown)


def _indented(messages: Sequence[str]) -> str:
    told = (text.replace("```", "'''").splitlines() for text in messages[:MOST_LINES])
    return "\n\n".join("\n".join(f"    {line}" for line in lines) for lines in told)
