"""JSON, TOML and XML: each bounded in depth, values and length of numbers before its parser sees it.

The parsers of the standard library are exact but trusting: a megabyte of brackets ends their recursion, a number of 5,000
digits is none of theirs, NaN and lone surrogates pass and break whoever writes them next. What leaves this module holds
finite numbers and text that can be written, at most `LIMITS.depth` deep.
"""

from __future__ import annotations

import json
import math
import re
import struct
import zlib
from itertools import accumulate
from typing import TYPE_CHECKING, cast

from robolayout._reading.limits import LIMITS

if TYPE_CHECKING:
    from collections.abc import Iterator
    from xml.etree.ElementTree import Element

_JSON_TEXT = re.compile(r'"[^"\\]*+(?:\\.[^"\\]*+)*+"?', re.DOTALL)
_TOML_TEXT = re.compile(
    r'"""(?:[^\\]|\\.)*?(?:"""|\Z)|\'\'\'.*?(?:\'\'\'|\Z)|"[^"\\\n]*+(?:\\.[^"\\\n]*+)*+"?|\'[^\'\n]*+\'?|#[^\n]*+',
    re.DOTALL,
)
_LONG_NUMBER = re.compile(rf"[0-9A-Za-z_]{{{LIMITS.digits + 1},}}")
_LONG_KEY = re.compile(rf"(?<![\w-])(?:[\w-]*+[ \t]*+\.[ \t]*+){{{LIMITS.depth}}}", re.ASCII)
_STEPS = {ord("["): 1, ord("{"): 1, ord("]"): -1, ord("}"): -1}
_NO_BRACKETS = bytes(set(range(256)) - set(_STEPS))
_DECLARES = re.compile(r"<!(?:DOCTYPE|ENTITY)", re.IGNORECASE)

FOREIGN_ERRORS = (
    ArithmeticError, AssertionError, AttributeError, EOFError, ImportError, LookupError, MemoryError, NameError,
    OSError, RuntimeError, SyntaxError, TypeError, ValueError, struct.error, zlib.error,
)  # fmt: skip
"""What code of others raises on broken files, and files of one's own when they run."""

ASTRAY = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, struct.error)
"""What is tripped over in data of another form."""


class Unreadable(Exception):
    """Something cannot be read; the message goes on where the thing's name stops ("is nested too deeply")."""


def decoded(content: bytes) -> str:
    """Return UTF-8 text without its byte-order mark."""
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise Unreadable(f"is not UTF-8 text (byte {error.start}). Save it as UTF-8") from None


def json_value(text: str) -> object:
    """Return the value of a JSON text; duplicate keys are refused."""
    _bound(_JSON_TEXT.sub(" ", text))
    try:
        value = json.loads(text, object_pairs_hook=_unique)
    except json.JSONDecodeError as error:
        raise Unreadable(f"is not JSON: {error.msg} at line {error.lineno}, column {error.colno}") from None
    except (RecursionError, ValueError) as error:
        raise Unreadable(f"is not JSON: {error}") from None
    check_plain(value)
    return value


def toml_value(text: str) -> dict[str, object]:
    """Return the tables of a TOML text."""
    import tomllib

    bare = _TOML_TEXT.sub("s", text)
    _bound(bare)
    if _LONG_KEY.search(bare):
        raise Unreadable(f"is nested too deeply. At most {LIMITS.depth} levels are read")
    try:
        value = tomllib.loads(text)
    except (RecursionError, ValueError) as error:
        raise Unreadable(f"is not TOML: {error}") from None
    check_plain(value)
    return value


def xml_root(text: str) -> Element:
    """Return the root element of an XML text; document types and entities are refused."""
    from xml.etree.ElementTree import ParseError, XMLPullParser

    if _DECLARES.search(text):
        raise Unreadable("has a document type or entities, which are not allowed; remove them")
    if text.count("<") > 2 * LIMITS.elements:
        raise Unreadable(f"has more than {LIMITS.elements} elements; simplify it")
    parser, depth, root = XMLPullParser(("start", "end")), 0, None
    try:
        for start in range(0, len(text), 65_536):
            parser.feed(text[start : start + 65_536])
            for event, element in cast("Iterator[tuple[str, Element]]", parser.read_events()):
                depth += 1 if event == "start" else -1
                root = element if root is None else root
                if depth > LIMITS.depth:
                    raise Unreadable(f"is nested too deeply. At most {LIMITS.depth} levels are read")
        parser.close()
    except (ParseError, ValueError) as error:
        raise Unreadable(f"is not XML: {error}") from None
    if root is None:
        raise Unreadable("is not XML: it has no element")
    return root


def check_plain(value: object) -> None:
    """Raise `Unreadable` for the first value in lists and objects that could not be written again.

    That is a number that is not finite or has more than `LIMITS.digits` digits, a text with a lone surrogate or a null
    character, and what is nested deeper than `LIMITS.depth`.
    """
    waiting: list[tuple[object, tuple[str | int, ...]]] = [(value, ())]
    while waiting:
        item, path = waiting.pop()
        if fault := _fault(item):
            raise Unreadable(f"has {fault}{_place(path)}")
        if not isinstance(item, (dict, list, tuple)):
            continue
        if len(path) >= LIMITS.depth:
            raise Unreadable(f"is nested too deeply. At most {LIMITS.depth} levels are read")
        if isinstance(item, dict):
            for key, inner in item.items():  # pyright: ignore[reportUnknownVariableType]
                if fault := _fault(key):
                    raise Unreadable(f"has a name with {fault}{_place(path)}")
                waiting.append((inner, (*path, str(key))))  # pyright: ignore[reportUnknownArgumentType]
        else:
            waiting += [(inner, (*path, i)) for i, inner in enumerate(item)]  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]


def _fault(item: object) -> str:
    """Return what keeps one value from being written again; empty for nothing."""
    if isinstance(item, float) and not math.isfinite(item):
        return f"{item} where only finite numbers are allowed"
    if isinstance(item, int) and item.bit_length() > 3.33 * LIMITS.digits:
        return f"a whole number of {item.bit_length()} bits, longer than {LIMITS.digits} digits,"
    if isinstance(item, str) and not item.isascii():
        try:
            item.encode()
        except UnicodeEncodeError as error:
            return f"characters that are no text (a lone surrogate at {error.start})"
    return "a null character, which no text has," if isinstance(item, str) and "\0" in item else ""


def _place(path: tuple[str | int, ...]) -> str:
    """Return " at assets.bed-0.size[2]" for the path of a value, shortened."""
    text = "".join(f"[{step}]" if isinstance(step, int) else f".{step[:60]}" for step in path).lstrip(".")
    shown = "".join(c if c.isprintable() else "?" for c in text)
    return f" at {shown[:200]}" if shown else ""


def _bound(bare: str) -> None:
    """Raise for depth, count and length of numbers beyond the bounds; `bare` is the text without what is quoted."""
    if number := _LONG_NUMBER.search(bare):
        raise Unreadable(
            f"has a number of {len(number[0])} characters ({number[0][:12]}...); at most {LIMITS.digits} are read"
        )
    brackets = bare.encode("utf-8", "replace").translate(None, _NO_BRACKETS)
    if bare.count(",") + len(brackets) // 2 > LIMITS.values:
        raise Unreadable(f"has more than {LIMITS.values} values; split it or leave out what is not needed")
    if len(brackets) > LIMITS.depth and max(accumulate(map(_STEPS.__getitem__, brackets))) > LIMITS.depth:
        raise Unreadable(f"is nested too deeply. At most {LIMITS.depth} levels are read")


def _unique(pairs: list[tuple[str, object]]) -> dict[str, object]:
    data = dict(pairs)
    if len(data) < len(pairs):
        seen: set[str] = set()
        twice = next(key for key, _ in pairs if key in seen or seen.add(key))
        raise Unreadable(f"is not usable: the name {twice[:60]!r} stands twice in one object; give each its own name")
    return data
