"""Stops a run's writing at every step that changes a disk, each time in a process and a copy of its own.

Called as `python stopped.py BASE WAY HOW`: BASE/<step>/room is the folder written to. WAY is how it is replaced: "whole"
(exchanged in one step), "twice" (renamed twice, where the system cannot exchange), "inside" (it is the current folder).
HOW is "kill", "interrupt" or "full". The number of steps is printed.
"""

from __future__ import annotations

import errno
import os
import signal
import sys
from pathlib import Path

from robolayout._errors import OutputError
from robolayout._files import exchange, write_atomic
from robolayout.run import folder

CHANGES = {"os.rename", "os.remove", "os.mkdir", "os.rmdir", "os.chmod", "os.truncate"}

OLD = {"layout.json": "old", "report.json": "old", "report.md": "old", "only_old.svg": "old", "exchanges/a.json": "old"}
NEW = {"layout.json": "new", "report.json": "new", "scene.glb": "new", "mine.txt": "new", "exchanges/b.json": "new"}
MINE = {"mine.txt": "mine", "notes/x/y.txt": "mine", "exchanges/mine.txt": "mine"}


def write(target: Path, files: dict[str, str]) -> list[str]:
    """Write a run, and return what was kept."""
    with folder.open_folder(target) as run:
        for name, text in files.items():
            write_atomic(run.path / name, text)
    return run.kept


def prepare(home: Path) -> None:
    """Make a folder of an older run with somebody else's files in it."""
    write(home, OLD)
    for name, text in MINE.items():
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_text(text)


class Step:
    """Counts changes and stops at one of them."""

    def __init__(self, last: int, how: str) -> None:
        self.left, self.how = last, how

    def __call__(self, event: str, args: tuple[object, ...]) -> None:
        changes = event in CHANGES or (event == "open" and isinstance(args[2], int) and args[2] & os.O_CREAT)
        if not changes or self.left < 0:
            return
        self.left -= 1
        if self.left == 0:
            self.left = -1
            if self.how == "kill":
                os.kill(os.getpid(), signal.SIGKILL)
            raise KeyboardInterrupt if self.how == "interrupt" else OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def told(one: Path, other: Path) -> bool:
    """Exchange two names as the system's own call does, which tells nobody."""
    sys.audit("os.rename", one, other)
    return exchange(one, other)


def main(base: Path, way: str, how: str) -> None:
    """Stop at the first step, the second, ... until the run ends by itself."""
    os.fsync = lambda descriptor: None  # a process that ends takes nothing with it that the system has
    if way == "twice":
        folder.exchange = lambda one, other: False
    else:
        folder.exchange = told
    for step in range(1, 200):
        home = base / str(step) / "room"
        prepare(home)
        child = os.fork()
        if child == 0:
            if way == "inside":
                os.chdir(home)
            counter = Step(step, how)
            sys.addaudithook(counter)
            try:
                write(home, NEW)
            except (KeyboardInterrupt, OutputError, OSError):
                os._exit(1)
            os._exit(0 if counter.left > 0 else 1)
        _, status = os.waitpid(child, 0)
        if status == 0:
            sys.stdout.write(f"{step}\n")
            return


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2], sys.argv[3])
