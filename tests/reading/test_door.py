"""The one door: what no reader takes, whichever it is, and the sentence for it."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from robolayout._errors import AgentError, InputError, LayoutError, ProgramError, SceneError
from robolayout._reading import LIMITS, Checker, Unreadable
from robolayout._reading.syntax import json_value, toml_value, xml_root
from robolayout.planners import OfflinePlanner
from robolayout.planners.model.exchange import read_exchanges
from robolayout.run.given import as_text
from robolayout.scene import Asset, Room, Scene, load_agent, load_layout, load_scene

SCENE = Scene(Room(((0, 0), (4, 0), (4, 5), (0, 5)), 2.6), (Asset("bed-0", "bed", (2, 1.6, 0.5)),))
Read = Callable[[Path], object]
JSON: dict[str, Read] = {
    "scene": load_scene,
    "layout": lambda path: load_layout(path, SCENE),
    "agent": load_agent,
    "recording": lambda path: read_exchanges(path.parent),
}
TOML: dict[str, Read] = {"agent": load_agent, "knowledge": lambda path: OfflinePlanner([path])}
ALL: dict[str, tuple[str, Read]] = {
    **{f"{name} JSON": (".json", read) for name, read in JSON.items() if name != "recording"},
    **{f"{name} TOML": (".toml", read) for name, read in TOML.items()},
    "URDF": (".urdf", load_agent),
    "program": (".py", as_text),
}

BAD_JSON = {
    "NaN in a key that nobody knows": (b'{"a": {"b": [1, NaN]}}', "has nan where only finite numbers are allowed at a.b[1]."),
    "a number beyond all bounds": (b'{"a": -1e999}', "has -inf where only finite numbers are allowed at a."),
    "5,000 digits": (b'{"a": ' + b"9" * 5000 + b"}", "has a number of 5000 characters (999999999999...); at most 100 are read."),
    "a lone surrogate": (b'{"a": "\\ud800"}', "has characters that are no text (a lone surrogate at 0) at a."),
    "a lone surrogate in a name": (b'{"\\ud800": 1}', "has a name with characters that are no text (a lone surrogate at 0)."),
    "a null character": (b'{"a": "x\\u0000"}', "has a null character, which no text has, at a."),
    "a name twice": (b'{"a": 1, "a": 2}', "the name 'a' stands twice in one object; give each its own name."),
    "brackets": (b"[" * 200_000, "is nested too deeply. At most 64 levels are read."),
    "braces": (b'{"a":' * 65 + b"1" + b"}" * 65, "is nested too deeply. At most 64 levels are read."),
}  # fmt: skip
BAD_TOML = {
    "NaN": (b"a = { b = [1.0, nan] }", "has nan where only finite numbers are allowed at a.b[1]."),
    "5,000 digits": (b"a = " + b"9" * 5000, "has a number of 5000 characters (999999999999...); at most 100 are read."),
    "5,000 hexadecimal digits": (b"a = 0x" + b"f" * 5000, "has a number of 5002 characters"),
    "a null character": (b'a = "\\u0000"', "has a null character, which no text has, at a."),
    "a name twice": (b"a = 1\na = 2", "is not TOML: "),
    "brackets": (b"a = " + b"[" * 200_000, "is nested too deeply. At most 64 levels are read."),
    "dots": (b"[" + b"a." * 100_000 + b"a]\n" + b"b = 1\n" * 3, "is nested too deeply. At most 64 levels are read."),
}


@pytest.mark.parametrize("reader", JSON)
@pytest.mark.parametrize("case", BAD_JSON)
def test_no_reader_of_json_takes(reader: str, case: str, tmp_path: Path) -> None:
    refused(JSON[reader], tmp_path / "file.json", *BAD_JSON[case])


@pytest.mark.parametrize("reader", TOML)
@pytest.mark.parametrize("case", BAD_TOML)
def test_no_reader_of_toml_takes(reader: str, case: str, tmp_path: Path) -> None:
    refused(TOML[reader], tmp_path / "file.toml", *BAD_TOML[case])


@pytest.mark.parametrize("name", ALL)
def test_no_reader_waits_for_a_pipe_or_reads_a_device_a_folder_or_a_loop(name: str, tmp_path: Path) -> None:
    suffix, read = ALL[name]
    for number, (make, said) in enumerate(
        (
            (os.mkfifo, "is no regular file but a pipe or a device"),
            (lambda path: path.symlink_to("/dev/zero"), "is no regular file but a pipe or a device"),
            (Path.mkdir, "is a folder; name the file in it"),
            (lambda path: path.symlink_to(path), "cannot be read: Too many levels of symbolic links"),
            (
                lambda path: path.write_bytes('{"a": 1}'.encode("utf-16")),
                "is not UTF-8 text (byte 0). Save it as UTF-8.",
            ),
            (lambda path: None, "does not exist; "),
        )
    ):
        path = tmp_path / f"{number}{suffix}"
        make(path)
        refused(read, path, None, said)


def refused(read: Read, path: Path, content: bytes | None, said: str) -> None:
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError) as caught:
        read(path)
    assert said in str(caught.value), str(caught.value)
    assert str(path) in str(caught.value) and "\n" not in str(caught.value)


def test_a_byte_order_mark_is_no_part_of_a_text(tmp_path: Path) -> None:
    path = tmp_path / "program.py"
    path.write_bytes(b"\xef\xbb\xbfx = 1\n")
    assert as_text(path) == "x = 1\n"


def test_what_stands_in_quotes_is_not_counted() -> None:
    brackets, digits = "[{" * 1000, "9" * 5000
    assert json_value(f'{{"a": "{brackets}\\"{digits}"}}') == {"a": f'{brackets}"{digits}'}
    text = (
        f"a = \"{brackets}\"\nb = '{digits}'\nc = '''{brackets}'''\nd = \"\"\"\n{digits}\"\"\" # {digits} {brackets}\n"
    )
    assert toml_value(text) == {"a": brackets, "b": digits, "c": brackets, "d": digits}


def test_values_are_counted_before_they_are_made() -> None:
    with pytest.raises(Unreadable, match="has more than 2000000 values; split it"):
        json_value("[" + "0," * 2_000_001 + "0]")


def test_what_is_allowed_is_exactly_so_deep() -> None:
    deepest = "[" * LIMITS.depth + "]" * LIMITS.depth
    assert json_value(deepest) and toml_value(f"a = {deepest[1:-1]}")
    assert xml_root("<a>" * LIMITS.depth + "</a>" * LIMITS.depth).tag == "a"
    for read, text in (
        (json_value, f"[{deepest}]"),
        (toml_value, f"a = {deepest}"),
        (xml_root, "<a>" * (LIMITS.depth + 1) + "</a>" * (LIMITS.depth + 1)),
    ):
        with pytest.raises(Unreadable, match="nested too deeply"):
            read(text)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("<!doctype a [<!ENTITY b 'c'>]><a>&b;</a>", "has a document type or entities"),
        ("<a>", "is not XML: no element found"),
        ("", "is not XML: no element found"),
        ("<a>\0</a>", "is not XML: not well-formed"),
        ("<a/>" * 1_000_001, "has more than 500000 elements"),
    ],
)
def test_xml_that_is_refused(text: str, said: str) -> None:
    with pytest.raises(Unreadable, match=said):
        xml_root(text)


@pytest.mark.parametrize("error", [SceneError, LayoutError, AgentError, ProgramError])
def test_the_error_is_that_of_the_reader(error: type[InputError], tmp_path: Path) -> None:
    with pytest.raises(error, match=r"the thing .*none does not exist; "):
        Checker(error).read_text(tmp_path / "none", "the thing")
