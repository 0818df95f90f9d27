"""What goes back to a model: what could not be read, what was rejected, what is not met, and what is wrong in the room."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from robolayout._errors import ProgramError

MOST_LINES = 40  # sentences of one kind that are told; more only hide the first ones

NO_NAMES: Mapping[str, str] = MappingProxyType({})


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

    def text(self, names: Mapping[str, str] = NO_NAMES) -> str:
        """Return it in words, things called as a program writes them (`names`); empty if nothing is wrong."""
        parts: list[str] = []
        if self.cut:
            parts.append(
                "Your answer was cut off at its end, because it was too long. Write less: loops, and no comments."
            )
        if self.error is not None:
            parts.append(f"The program could not be read:\n\n{_indented(str(self.error))}")
        if self.dropped:
            told = "\n\n".join(_indented(message) for message in self.dropped[:MOST_LINES])
            parts.append(f"These lines could not be read and were left out; all others were used:\n\n{told}")
        if self.forgotten:
            listed = ", ".join(self.forgotten[:MOST_LINES])
            parts.append(f"The program says nothing about these things, though they must be placed: {listed}.")
        lists = (
            ("The critic who saw the finished room says", self.wishes),
            ("These statements could not be used, for the reason given, and were left out", self.rejections),
            ("The solver did its best with the rest; the judge then measured", self.violations),
        )
        parts += [f"{head}:\n\n{_bullets(lines, names)}" for head, lines in lists if lines]
        if parts and self.stands:
            parts.append(f"The things that your program is about stand so now:\n\n{_indented(self.stands)}")
        if parts and self.moved:
            parts.append(f"Some are not where your program put them:\n\n{_bullets(self.moved, names)}")
        return "\n\n".join(parts)


def _bullets(lines: Sequence[str], names: Mapping[str, str]) -> str:
    told = (" ".join(in_program_words(line, names).split()) for line in lines[:MOST_LINES])
    shown = [f"- {line}".replace("```", "'''") for line in told]
    more = len(lines) - MOST_LINES
    return "\n".join([*shown, f"- and {more} more."] if more > 0 else shown)


def _indented(text: str) -> str:
    return "\n".join(f"    {line}" for line in text.replace("```", "'''").splitlines())


def in_program_words(sentence: str, names: Mapping[str, str]) -> str:
    """Return a sentence in which things are called as a program writes them: `bed[0]` for "bed-0"."""
    if not names:
        return sentence
    known = "|".join(re.escape(name) for name in sorted(names, key=len, reverse=True))
    return re.sub(rf"(?<![\w\[-])(?:{known})(?![\w\[-])", lambda found: names[found[0]], sentence)
