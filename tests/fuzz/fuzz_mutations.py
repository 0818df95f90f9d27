"""Spoils good files: values, types, names, nesting, numbers, characters, bytes. The same choices give the same bytes.

A choice is four whole numbers: what to do, where, and with what. They come from Hypothesis, which makes them small again when
an input is found that breaks a reader.
"""

from __future__ import annotations

import copy
import json
import math
import re
import struct
from collections.abc import Callable
from typing import Any

Choice = tuple[int, int, int, int]

DEEP: Any = []
for _ in range(90):
    DEEP = [DEEP]
NASTY: tuple[Any, ...] = (
    None, True, False, 0, 1, -1, 2, 3, 7, 255, 2**31, -(2**31), 2**63, 10**20, 10**99, 10**120, 10**4000,
    0.0, -0.0, 0.5, 1e-9, 5e-324, 1e6, 1e16, 1e308, -1e308, math.nan, math.inf, -math.inf,
    "", " ", "x", "0", "1e999", "nan", "\ud800", "a\udfffb", "\0", "a\0b", "\ufeff", "\u2028", "\u202e", "é", "e\u0301", "桌子",
    "🛏️", "../../etc/passwd", "/etc/passwd", "/dev/zero", "a.glb", "x" * 300, "y" * 20_000, "[/red]", "</script>", "{a}", "{{", "}",
    "__import__", "class", "bed-0", "-1", "walls[0]", "%s%n", "C:\\nul", "1_000", "0x10", "٣",
    [], {}, [[]], {"": {}}, [0], [1, 2, 3], [1, 2, 3, 4], [math.nan] * 3, ["a", "b"], {"a": 1}, {"x": 1, "y": 1, "z": 1},
    [None], [[1, 2], [3, 4]], DEEP, list(range(300)), {str(i): i for i in range(300)}, {"value": 1}, {"kind": "asset"},
)  # fmt: skip
"""Values that readers trip over."""
BYTES = (
    b"", b"\0", b"\xff", b"\xef\xbb\xbf", b"\xff\xfe", b"[" * 3000, b"{\"a\":" * 200, b"9" * 5000, b"nan", b"NaN", b"1e999", b"-",
    b"\n", b"\r", b"\t", b" ", b"\"", b"'", b"\\", b"\\ud800", b"\\u0000", b"<", b">", b"&", b"<!DOCTYPE x [", b"]]>", b"#", b"=",
    b",", b":", b".", b"a." * 2000, b"()", b"(" * 300, b"//", b"f 1 2 3\n", b"v 1 1 1\n", b"\x80\x00\x00\x00", b"\xff" * 8, b"\0" * 64,
)  # fmt: skip
"""Bytes that are put among others."""


def spoiled_tree(tree: Any, choices: list[Choice]) -> Any:
    """Return a tree of lists and objects with a few values, names or places changed."""
    tree = copy.deepcopy(tree)
    for what, where, one, two in choices:
        places = _places(tree)
        if not places:
            return tree
        holder, key = places[where % len(places)]
        if what % 6 == 1:
            del holder[key]
        elif what % 6 == 2 and isinstance(holder, dict):
            name = NASTY[one % len(NASTY)]
            holder[name if isinstance(name, str) else str(name)[:50]] = holder.pop(key)
        elif what % 6 == 3 and isinstance(holder, list):
            holder.insert(one % (len(holder) + 1), copy.deepcopy(holder[key]))
        elif what % 6 == 4:
            other, place = places[one % len(places)]
            holder[key] = copy.deepcopy(other[place]) if place in other or isinstance(place, int) else None
        elif what % 6 == 5 and isinstance(holder, dict):
            holder["unknown"] = copy.deepcopy(NASTY[two % len(NASTY)])
        else:
            holder[key] = copy.deepcopy(NASTY[one % len(NASTY)])
    return tree


def _places(tree: Any) -> list[tuple[Any, Any]]:
    """Return (list or object, index or name) of every value in a tree."""
    found: list[tuple[Any, Any]] = []
    waiting = [tree]
    while waiting and len(found) < 5000:
        item = waiting.pop()
        keys: list[Any] = list(item) if isinstance(item, dict) else list(range(len(item)))
        found += [(item, key) for key in keys]
        waiting += [item[key] for key in keys if isinstance(item[key], (dict, list))]
    return found


def spoiled_text(data: bytes, choices: list[Choice]) -> bytes:
    """Return text with a few words, numbers or signs changed, doubled, moved or left out."""
    words = re.findall(rb"[A-Za-z_][\w-]*|[-+]?[\d.]+(?:[eE][-+]?\d+)?|\s+|.", data, re.DOTALL)
    for what, where, one, two in choices:
        if not words:
            break
        place = where % len(words)
        if what % 5 == 1:
            del words[place : place + 1 + one % 4]
        elif what % 5 == 2:
            words[place:place] = words[place : place + 1 + one % 8] * (1 + two % 3)
        elif what % 5 == 3:
            words[place], words[one % len(words)] = words[one % len(words)], words[place]
        else:
            value = NASTY[one % len(NASTY)]
            text = value if isinstance(value, str) else json.dumps(value)[:6000]
            words[place] = text.encode("utf-8", "replace") if two % 2 else BYTES[one % len(BYTES)]
    return b"".join(words)


def spoiled_bytes(data: bytes, choices: list[Choice]) -> bytes:
    """Return bytes with a few cut off, changed, doubled, left out or put in."""
    for what, where, one, two in choices:
        place = where % (len(data) + 1)
        if what % 6 == 0:
            data = data[:place]
        elif what % 6 == 1:
            data = data[:place] + bytes([one % 256]) + data[place + 1 :]
        elif what % 6 == 2:
            data = data[:place] + BYTES[one % len(BYTES)] + data[place:]
        elif what % 6 == 3:
            data = data[:place] + data[place + 1 + one % 32 :]
        elif what % 6 == 4:
            piece = data[place : place + 1 + one % 64]
            data = data[:place] + piece * (1 + two % 50) + data[place:]
        else:
            number = (0, 1, -1, 2**31 - 1, -(2**31), 65_536, 20, 255)[one % 8]
            data = data[:place] + struct.pack("<i", number) + data[place + 4 :]
    return data


def as_json(tree: Any) -> bytes:
    """Return JSON as a careless program writes it: with NaN, lone surrogates as escapes, numbers of any length."""
    return _whole(tree).encode()


def _whole(tree: Any) -> str:
    """Return JSON text also for whole numbers that `json` does not write."""
    if isinstance(tree, dict):
        return "{" + ", ".join(f"{json.dumps(str(key))}: {_whole(value)}" for key, value in tree.items()) + "}"
    if isinstance(tree, list):
        return "[" + ", ".join(map(_whole, tree)) + "]"
    if isinstance(tree, int) and not isinstance(tree, bool) and abs(tree) > 10**4000 - 1:
        return "1" + "0" * 5000
    return json.dumps(tree)


def as_toml(tree: Any) -> bytes:
    """Return a tree as TOML: one line a key, tables in braces."""
    if not isinstance(tree, dict):
        return _inline(tree).encode("utf-8", "replace")
    return "".join(f"{_quoted(key)} = {_inline(value)}\n" for key, value in tree.items()).encode("utf-8", "replace")


def _inline(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_quoted(key)} = {_inline(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(_inline, value)) + "]"
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, float):
        return repr(value) if "." in repr(value) or "e" in repr(value) or not math.isfinite(value) else f"{value}.0"
    return (
        {None: '""', True: "true", False: "false"}.get(value)
        if value is None or isinstance(value, bool)
        else _whole(value)
    )  # type: ignore[return-value]


def _quoted(text: object) -> str:
    return json.dumps(str(text), ensure_ascii=False).replace("\x7f", "\\u007f")


def as_glb(parts: tuple[Any, bytes]) -> bytes:
    """Return a GLB file of a header and a binary chunk, with the lengths that they have."""
    header = as_json(parts[0])
    header += b" " * (-len(header) % 4)
    chunk = struct.pack("<II", len(parts[1]), 0x004E4942) + parts[1]
    head = struct.pack("<IIIII", 0x46546C67, 2, 20 + len(header) + len(chunk), len(header), 0x4E4F534A)
    return head + header + chunk


def glb_parts(data: bytes) -> tuple[Any, bytes]:
    """Return header and binary chunk of a good GLB file."""
    (size,) = struct.unpack_from("<I", data, 12)
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def spoiled(seed: Any, write: Callable[[Any], bytes] | None, choices: list[Choice]) -> bytes:
    """Return a good file spoiled: three times in four in its structure, else in its bytes.

    Args:
        seed: A tree, header and chunk of a GLB, or bytes.
        write: What makes bytes of it; None for text and bytes.
        choices: What to do to it; the first also says where to begin.
    """
    way = choices[0][0] // 7 % 4
    if write is None:
        return (spoiled_text if way in (0, 1) else spoiled_bytes)(seed, choices)
    if way == 3:
        return spoiled_bytes(write(seed), choices)
    if isinstance(seed, tuple):
        return write((spoiled_tree(seed[0], choices), seed[1]))
    return write(spoiled_tree(seed, choices))
