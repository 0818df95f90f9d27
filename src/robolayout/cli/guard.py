"""The outermost edge of the command line: whatever happens ends in one sentence and an exit code, never in a traceback.

Exit codes (docs/errors.md): 0 all demands met, 1 the report lists unmet demands, 2 the input is wrong, 3 a mistake of
RoboLayout itself, 130 interrupted, 141 nobody reads what is printed.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable
from io import BufferedWriter, FileIO, TextIOWrapper
from typing import TYPE_CHECKING, NoReturn

from robolayout._errors import ProgramError, RoboLayoutError
from robolayout.cli.terminal import warn

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer

UNMET, WRONG, OURS, INTERRUPTED, UNREAD = 1, 2, 3, 130, 141
"""Exit codes; the last two are those of a program that is stopped by the signals SIGINT and SIGPIPE."""

SOON = 0.05  # seconds after which an interrupt that hit a callback is sent again, when the callback is over


class Unforeseen(Exception):
    """Carries an `OSError` or `EOFError` past typer, which would end in silence, to the edge that says it."""


class Outlet(FileIO):
    """A standard stream that never fails: a run goes on though nobody reads what it prints, and its files are complete."""

    blocked: OSError | None = None  # the first error on writing; None if there was none

    def write(self, data: ReadableBuffer, /) -> int | None:
        """Write some bytes; those that cannot be written are gone."""
        try:
            return super().write(data)
        except OSError as error:
            self.blocked = self.blocked or error
            return memoryview(data).nbytes


def main() -> NoReturn:
    """Run the command line and leave with its exit code."""
    outlet = _open_streams()
    if sys.unraisablehook is sys.__unraisablehook__:  # not where a test runner has put its own
        sys.unraisablehook = lambda unraisable: _in_passing(unraisable.exc_type)
        threading.excepthook = lambda args: _in_passing(args.exc_type)

    def commands() -> None:
        from robolayout.cli.app import app  # nothing of it is loaded before the edge is drawn

        app(prog_name="robolayout")

    code = guarded(commands)
    sys.stdout.flush()
    blocked = outlet and outlet.blocked
    if blocked is not None and code != INTERRUPTED:
        code = UNREAD if isinstance(blocked, BrokenPipeError) else WRONG
        if code == WRONG:  # the reader did not just leave
            what = f"what was to be printed cannot be written: {blocked.strerror}"
            warn(f"{what}. Files are complete; give it another way, or --quiet.")
    raise SystemExit(code)


def guarded(work: Callable[[], None]) -> int:
    """Do some work and return its exit code; what went wrong is said in one sentence on standard error."""
    try:
        work()
        code = 0
    except SystemExit as stop:
        code = stop.code if isinstance(stop.code, int) else UNMET if stop.code else 0
    except KeyboardInterrupt:
        code = INTERRUPTED
    except RoboLayoutError as error:
        code = WRONG
        warn(*(str(error).split("\n") if isinstance(error, ProgramError) else [str(error)]))
    except BaseException as error:  # noqa: BLE001 - the one edge that nothing passes, panics of libraries included
        code = _unforeseen(error)
    if code == INTERRUPTED:
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # who cannot wait for threads to end needs to ask only once more
        warn("interrupted; nothing was left half-written.")
    return code


def _open_streams() -> Outlet | None:
    """Open what was closed on starting, lest another file take its number, and make the streams such as never fail.

    Returns where standard output goes; None where a test or another program has put a stream of its own.
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    outlets: dict[str, Outlet] = {}
    for number, name in ((1, "stdout"), (2, "stderr")):
        stream = raw = getattr(sys, name)
        if stream and stream is getattr(sys, f"__{name}__"):
            raw = getattr(stream.buffer, "raw", stream.buffer)
        if raw is None or isinstance(raw, FileIO):
            encoding, lines = ("utf-8", False) if stream is None else (stream.encoding, stream.line_buffering)
            outlets[name] = Outlet(number, "wb", closefd=False)
            text = TextIOWrapper(BufferedWriter(outlets[name]), encoding, "backslashreplace", line_buffering=lines)
            setattr(sys, name, text)
    return outlets.get("stdout")


def _in_passing(kind: type[BaseException]) -> None:
    """Take note of an error where nobody could catch it: in a thread, a callback or while things are cleared away."""
    if issubclass(kind, KeyboardInterrupt):
        again = threading.Timer(SOON, os.kill, (os.getpid(), signal.SIGINT))  # meant for the program, not the callback
        again.daemon = True
        again.start()
    else:
        warn(f"warning: something failed in passing ({kind.__name__}); the result does not depend on it.")


def _unforeseen(error: BaseException) -> int:
    """Say what nobody foresaw, write a file about it, and return the exit code."""
    from robolayout.cli.crash import outside, sentence, write_note

    if isinstance(error, Unforeseen) and error.__cause__ is not None:
        error = error.__cause__
    if place := outside(error):
        warn(f"an extension of yours failed: {place}. Correct it, or leave it out.")
        return WRONG
    warn(sentence(error, write_note(error, sys.argv[1:])))
    return OURS
