"""Text that is not ours (of files, models, names) made harmless for the place where it goes, and small pieces of HTML with it.

Whatever shows a name, a description, a path or a message uses one of these: in JSON the escapes are those of the format.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape


@dataclass(frozen=True)
class Telling:
    """How much of a long list a person is told."""

    named: int = 3  # things, reasons, or kinds of things, that a sentence names
    shown: int = 12  # violations, reasons or rooms that are listed; the report, or the index, holds all
    kept: int = 5  # kept files that are named
    ends: int = 20  # places kept at each end of a chain of calls; a recursion without end has thousands in between


TOLD = Telling()


JOINERS = "\u200c\u200d"
"""Characters that change nothing but how letters join: Persian and Indian words and pictured people are written with them."""

_ACTIVE = re.compile(r"[|*`]|(?<!\w)_|_(?!\w)|<(?=[\w/!?])|&(?=[\w#])|\](?=[(\[:])|~~|\\(?=[!-/:-@\[-`{-~])")
"""What Markdown acts on in the middle of a line; `against_wall(bed[0], walls[2])` and 0.6 < 0.9 stay as they are."""

_LEADING = re.compile(r"^(\d*)(?=[#>=+~-]|(?<=\d)[.)](?:\s|$))")
"""What Markdown acts on at the start of a line."""

_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML 1.0 cannot hold, escaped or not; USD does not want them either."""

_NOT_IN_A_FILE_NAME = re.compile(r'[<>:"/\\|?*]|\s+')
"""Characters that some system gives a meaning in names of files; blanks are kept, but one at a time."""

LONGEST_NAME = 100  # bytes of UTF-8 that a text gives to the name of a file, a third of what file systems take


def printable(text: str) -> str:
    """Return one line without control characters, terminal sequences, changes of direction and halves of characters.

    Each becomes a blank, so words stay apart; letters of every script stay.
    """
    return "".join(c if c.isprintable() or c in JOINERS else " " for c in text)


def markdown(text: str) -> str:
    """Return text that Markdown shows as it is, also in a table: no link, tag, emphasis, heading or further column."""
    return _LEADING.sub(r"\1\\", _ACTIVE.sub(lambda found: "\\" + found[0], printable(text)))


def html(text: str) -> str:
    """Return text for HTML and SVG, within an element or a quoted attribute."""
    return escape(printable(text))


def xml(text: str) -> str:
    """Return text as XML can hold it, not yet escaped: what it cannot hold becomes U+FFFD, all else stays."""
    return _NOT_XML.sub("\ufffd", text)


def utf8(text: str) -> bytes:
    """Return text as UTF-8; half a character becomes its escape, as JSON and Python write it."""
    return text.encode("utf-8", "backslashreplace")


def pretty(data: object) -> str:
    """Return JSON text, indented, with a newline at its end; numbers keep every digit, and none but finite ones are written."""
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def file_name(text: str) -> str:
    """Return the stem of a file's name: never a path, never hidden, never too long, the same on every system."""
    stem = _NOT_IN_A_FILE_NAME.sub(lambda found: " " if found[0].isspace() else "_", printable(text)).strip(" .-")
    return stem.encode()[:LONGEST_NAME].decode(errors="ignore").rstrip(" .") or "_"


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return an HTML table; the first column is text, the others are figures."""
    top = "".join(f"<th>{html(head)}</th>" for head in heads)
    styles = [' style="text-align:left"', *[""] * (len(heads) - 1)]
    cells = ("".join(f"<td{style}>{html(text)}</td>" for style, text in zip(styles, row, strict=True)) for row in rows)
    body = "".join(f"<tr>{row}</tr>" for row in cells)
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def paragraph(text: str) -> str:
    """Return an HTML paragraph in bold."""
    return f"<p><b>{html(text)}</b></p>"


def listed(names: Sequence[str], most: int = TOLD.named) -> str:
    """Return the first of some names and how many more there are.

    >>> listed(["bed-0", "desk-0", "chair-0"], 2)
    'bed-0, desk-0 and 1 more'
    """
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def bullets(sentences: Sequence[str], most: int) -> str:
    """Return an HTML list of at most `most` sentences and how many more there are; nothing for none."""
    shown = list(sentences[:most])
    if len(sentences) > most:
        shown.append(f"and {len(sentences) - most} more")
    return f"<ul>{''.join(f'<li>{html(sentence)}</li>' for sentence in shown)}</ul>" if shown else ""
