"""The outermost edge: whatever happens, one sentence, an exit code, and never a traceback."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

import robolayout.scene
from robolayout._text import TOLD
from running import Ran

Command = Callable[..., Ran]
SECRET = "sk-0123456789 in bed-0\n[/red]\x1b[31m"


class Panic(BaseException):
    """What libraries in other languages raise."""


def raises(error: BaseException) -> Callable[..., Any]:
    def work(*_: object) -> Any:
        raise error.with_traceback(None)

    return work


def deep() -> Any:
    return deep()


def threaded(*_: object) -> Any:
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(raises(ZeroDivisionError(SECRET))).result()


def chained(*_: object) -> Any:
    try:
        raise KeyError(SECRET)
    except KeyError as error:
        raise ValueError(SECRET) from error


UNFORESEEN: dict[str, tuple[Callable[..., Any], str]] = {
    "ValueError": (raises(ValueError(SECRET)), "mistake of RoboLayout"),
    "AssertionError": (raises(AssertionError()), "(AssertionError)"),
    "MemoryError": (raises(MemoryError()), "not enough memory"),
    "RecursionError": (deep, "RecursionError"),
    "Panic": (raises(Panic(SECRET)), "Panic"),
    "OSError": (raises(OSError(5, "Input/output error")), "Input/output error"),
    "BrokenPipeError": (raises(BrokenPipeError(32, "Broken pipe")), "Broken pipe"),
    "EOFError": (raises(EOFError()), "EOFError"),
    "UnicodeEncodeError": (lambda: "\ud800".encode(), "surrogates"),
    "in a thread": (threaded, "ZeroDivisionError"),
    "chained": (chained, "ValueError"),
}


@pytest.fixture
def notes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "notes"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    monkeypatch.delenv("ROBOLAYOUT_DEBUG", raising=False)
    return folder


@pytest.mark.parametrize("case", UNFORESEEN)
def test_an_unforeseen_error_is_one_sentence_and_a_file(
    command: Command, notes: Path, monkeypatch: pytest.MonkeyPatch, case: str
) -> None:
    work, said = UNFORESEEN[case]
    monkeypatch.setattr(robolayout.scene, "agent_names", work)
    ran = command("agents")
    assert (ran.code, ran.out) == (3, "")
    assert ran.err.startswith("robolayout: ") and ran.err.count("\n") == 1 and "Traceback" not in ran.err
    assert said in ran.err and ran.err.strip().isprintable()
    (note,) = notes.iterdir()
    text = note.read_text(encoding="utf-8")
    assert f"send {note}, which holds no names, keys or contents." in ran.err
    assert "command: agents" in text and "robolayout/cli/lists.py:" in text and "numpy" in text
    assert "sk-" not in text and "bed-0" not in text and str(Path.home()) not in text
    assert len(text.splitlines()) < 40 + 2 * 2 * TOLD.ends


def test_an_error_on_loading_a_library(command: Command, notes: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "robolayout.scene", None)
    ran = command("agents")
    assert ran.code == 3 and "ModuleNotFoundError" in ran.err and ran.err.count("\n") == 1


def test_the_same_error_twice_is_one_file_with_names_of_options_only(
    command: Command, notes: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(robolayout.scene, "load_agent", raises(KeyError(SECRET)))
    for name in ("grandmother", "grandfather"):
        assert command("agents", name, f"--out={SECRET}", "--out", "/home/me/key.svg").code == 3
    (note,) = notes.iterdir()
    text = note.read_text(encoding="utf-8")
    assert "command: agents . --out --out .\n" in text and "grand" not in text and "key.svg" not in text


def test_messages_and_command_line_are_kept_if_asked(
    command: Command, notes: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROBOLAYOUT_DEBUG", "1")
    monkeypatch.setattr(robolayout.scene, "load_agent", raises(KeyError("bed-0")))
    assert command("agents", "grandmother").code == 3
    (note,) = notes.iterdir()
    assert "command: agents grandmother\n" in note.read_text() and "KeyError: 'bed-0'\n" in note.read_text()


def test_the_file_goes_elsewhere_or_nowhere(
    command: Command, notes: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(robolayout.scene, "agent_names", raises(ValueError("no")))
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "missing"))
    monkeypatch.chdir(notes)
    ran = command("agents")
    (note,) = notes.iterdir()
    assert ran.code == 3 and str(note) in ran.err
    monkeypatch.setattr(tempfile, "gettempdir", raises(FileNotFoundError(2, "no usable folder")))
    monkeypatch.setattr(Path, "cwd", raises(FileNotFoundError(2, "gone")))
    ran = command("agents")
    assert ran.code == 3 and "no file about it could be written" in ran.err and ran.err.count("\n") == 1


def test_a_link_in_the_way_is_not_followed(
    command: Command, notes: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(robolayout.scene, "agent_names", raises(ValueError("no")))
    monkeypatch.chdir(tmp_path)
    assert command("agents").code == 3
    (note,) = notes.iterdir()
    victim = tmp_path / "victim"
    victim.write_text("mine")
    note.unlink()
    note.symlink_to(victim)
    assert str(tmp_path / note.name) in command("agents").err
    assert victim.read_text() == "mine"


def started(code: str, *words: str, **how: Any) -> subprocess.CompletedProcess[str]:
    """Run a command line in a fresh process after some code."""
    return subprocess.run(
        [sys.executable, "-c", f"{code}\nfrom robolayout.cli import main\nmain()", *words],
        capture_output=True, text=True, timeout=120, **how,
    )  # fmt: skip


INTERRUPTED = "robolayout: interrupted; nothing was left half-written.\n"
KILL = (  # a shell that started the tests in the background has interrupts ignored
    "import os, signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
    "def kill(*_):\n    os.kill(os.getpid(), signal.SIGINT)\n"
)
MOMENTS = {
    "in a command": "import robolayout.scene\nrobolayout.scene.agent_names = kill",
    "while the edge is loaded": (
        "import sys\nclass Finder:\n    def find_spec(self, name, *rest):\n        if name == 'robolayout.cli.guard': kill()\n"
        "sys.meta_path.insert(0, Finder())"
    ),
    "while loading": (
        "import sys\nclass Finder:\n    def find_spec(self, name, *rest):\n        if name == 'typer': kill()\n"
        "import robolayout.cli\nsys.meta_path.insert(0, Finder())"
    ),
    "in a callback": (
        "import time, weakref, robolayout.scene\nclass Thing: pass\n"
        "def work():\n    thing = Thing()\n    keep = weakref.ref(thing, kill)\n    del thing\n"
        "    for _ in range(6000): time.sleep(0.01)\n    return ()\n"
        "robolayout.scene.agent_names = work"
    ),
    "while a thread works": (
        "import robolayout.scene\nfrom concurrent.futures import ThreadPoolExecutor\n"
        "def work():\n    with ThreadPoolExecutor(1) as pool:\n        return pool.submit(kill).result()\n"
        "robolayout.scene.agent_names = work"
    ),
}


@pytest.mark.parametrize("moment", MOMENTS)
def test_an_interrupt_is_one_line(moment: str) -> None:
    done = started(KILL + MOMENTS[moment], "agents")
    assert (done.returncode, done.stderr) == (130, INTERRUPTED)


def test_an_error_in_a_thread_or_a_destructor_is_one_line() -> None:
    code = (
        "import threading, robolayout.scene\nclass Thing:\n    def __del__(self): 1 / 0\n"
        "def work():\n    Thing()\n    t = threading.Thread(target=lambda: {}['x'])\n    t.start()\n    t.join()\n    return ()\n"
        "robolayout.scene.agent_names = work"
    )
    done = started(code, "agents")
    assert done.returncode == 0 and "Traceback" not in done.stderr
    assert [line.split("(")[1][:12] for line in done.stderr.splitlines()] == ["ZeroDivision", "KeyError); t"]


def shell(line: str) -> subprocess.CompletedProcess[str]:
    """Run a line of Bash in which `$R` is the command line; its own exit code is printed."""
    environment = {**os.environ, "R": f"{sys.executable} -m robolayout"}
    return subprocess.run(["bash", "-c", line], capture_output=True, text=True, env=environment, timeout=120)


FULL = "robolayout: what was to be printed cannot be written: No space left on device. Files are complete; "


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
@pytest.mark.parametrize("words", ["agents", "agents cat", "--help", "--version"])
def test_a_standard_output_that_is_full_closed_or_left(words: str) -> None:
    done = shell(f"$R {words} > /dev/full")
    assert done.returncode == 2 and done.stderr.startswith(FULL) and done.stderr.count("\n") == 1
    done = shell(f"$R {words} | head -c 0; echo ${{PIPESTATUS[0]}}")
    assert (done.stdout, done.stderr) == ("141\n", "")
    done = shell(f"$R {words} >&-")
    assert (done.returncode, done.stderr) == (0, "")
    assert shell(f"$R {words} <&- >&- 2>&-").returncode == 0


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="the system has no /dev/full")
def test_a_standard_error_that_is_full_or_closed_changes_no_exit_code() -> None:
    for there in ("2> /dev/full", "2>&-", "> /dev/full 2> /dev/full"):
        assert shell(f"$R agents nobody {there}").returncode == 2


def test_letters_that_a_terminal_does_not_have_are_escaped() -> None:
    done = shell("PYTHONIOENCODING=ascii $R agents '桌\x1b[31m'")
    assert done.returncode == 2 and "\\u684c" in done.stderr and done.stderr.isascii() and "\x1b" not in done.stderr


def test_help_by_either_name(command: Command) -> None:
    for words in ((), ("generate",), ("agents",), ("check",)):
        short = command(*words, "-h")
        assert short.code == 0 and short == command(*words, "--help") and "Usage: robolayout" in short.out


def test_threads_keep_their_hook_under_a_test_runner(command: Command) -> None:
    before = (sys.unraisablehook, threading.excepthook)
    command("--version")
    assert (sys.unraisablehook, threading.excepthook) == before
