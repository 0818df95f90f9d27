"""The output folder is one run: made beside it, put in its place whole, and nothing of an older run stays.

    with open_folder(Path("out/bedroom")) as run:
        write_atomic(run.path / "layout.json", text)

`run.json` lists the files of a run. An older run's own files go when the new ones come; all others are somebody else's and
stay. The new folder takes the place of the old one in one step, so that a kill or a full disk at any point leaves the one or
the other. Where a folder cannot be replaced (it is the current one, a mount point, or stands in a folder that cannot be
written to), its files are: first the old claims go, then the old files, then the new ones come, the claims last; a run that
is killed meanwhile is brought to its end by the next one. Two runs never write to one folder at a time.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Generator, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any

from robolayout._errors import OutputError
from robolayout._files import check_writable, exchange, locked, write_atomic
from robolayout._text import pretty
from robolayout._version import __version__

RUN = "run.json"  # the list of a run's files
ANSWERS = "exchanges"  # folder of a model's answers, which are paid for: they outlive a run that fails

FRESH, FORMER, READY, LOCK = (f"robolayout-{word}" for word in ("new", "old", "ready", "lock"))
"""Ends of the names of our hidden files: a run being made; what a finished run replaces; a finished run whose files are
being moved in; the lock."""

CLAIM = "report."  # how the files begin that say what the layout achieves; they never stand beside another run's layout


@dataclass
class RunFolder:
    """Where a run writes."""

    target: Path  # the output folder
    path: Path  # where its files are made
    # what was in the folder and belongs to no run of ours, as it is called now; known at the end
    kept: list[str] = field(default_factory=list[str])
    answers: Path | None = None  # where a model's answers are after a run that failed; None if there were none

    def place(self, path: Path) -> Path:
        """Return where a file that was made is in the end."""
        return self.target / path.relative_to(self.path)


@contextmanager
def open_folder(target: Path) -> Generator[RunFolder]:
    """Give a place to write a run to, and put it in place of the target when the block ends; if it fails, nothing changes."""
    check_writable(target)
    with _as_output_error(target):
        home = target.resolve()
        made = [folder for folder in home.parents if not folder.exists()]
        home.parent.mkdir(parents=True, exist_ok=True)
    try:
        with locked(_hidden(home, LOCK, inside=not _is_free(home.parent)), target):
            with _as_output_error(target):
                _recover(home)
                inside = _is_fixed(home)
                run = RunFolder(target, _hidden(home, FRESH, inside=inside))
                run.path.mkdir()
            try:
                yield run
                with _as_output_error(target):
                    names = sorted(p.relative_to(run.path).as_posix() for p in run.path.rglob("*") if p.is_file())
                    write_atomic(run.path / RUN, pretty({"robolayout": __version__, "files": names}))
                    run.kept = _fill(run.path, home) if inside else _replace(run.path, home)
            finally:
                run.answers = _saved(run.path / ANSWERS, home)
                shutil.rmtree(run.path, ignore_errors=True)
    finally:
        for folder in made:
            with suppress(OSError):  # it is in use now
                folder.rmdir()


@contextmanager
def _as_output_error(target: Path) -> Generator[None]:
    """Say what the system refuses as a sentence."""
    try:
        yield
    except (OSError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or error
        raise OutputError(
            f"cannot write to {target}: {reason}. It holds what it held before; free some space or choose another folder."
        ) from error


def _is_free(folder: Path) -> bool:
    return os.access(folder, os.W_OK | os.X_OK)


def _is_fixed(home: Path) -> bool:
    """Return whether a folder must stay the one it is: nobody wants to stand in a folder that is gone, or to lose its owner."""
    if not home.exists():
        return False
    foreign = hasattr(os, "geteuid") and home.stat().st_uid != os.geteuid()
    held = not home.name or not _is_free(home.parent)
    return foreign or held or os.path.ismount(home) or os.path.samefile(home, os.curdir)


def _hidden(home: Path, kind: str, *, inside: bool) -> Path:
    """Return one of our hidden places, in a folder or beside it."""
    if inside:
        return home / f".{kind}"
    name = home.name if len(os.fsencode(home.name)) < 200 else hashlib.sha256(os.fsencode(home.name)).hexdigest()
    return home.with_name(f".{name}.{kind}")


def _saved(answers: Path, home: Path) -> Path | None:
    """Put a failed run's answers beside the folder that they were for, and return where they are."""
    if not any(_said(exchange, "answer") for exchange in answers.glob("*.json")):  # only why there is none
        return None
    folder = home.parent if _is_free(home.parent) else home
    with suppress(OSError):
        return folder / _move(answers.parent, ANSWERS, folder, f"{home.name}-{ANSWERS}")
    return None


def _said(file: Path, key: str) -> Any:
    """Return what one of our own JSON files says; None where it cannot be read."""
    try:
        return json.loads(file.read_bytes())[key]
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None


def _recover(home: Path) -> None:
    """Bring a run that was killed to its end, or undo it."""
    for inside in (False, True):
        shutil.rmtree(_hidden(home, FRESH, inside=inside), ignore_errors=True)
    former, ready = _hidden(home, FORMER, inside=False), _hidden(home, READY, inside=True)
    if former.is_dir() and home.exists():
        _settle(former, home)
    elif former.is_dir():
        os.rename(former, home)
    if ready.is_dir():
        _finish(ready, home)


def _own(folder: Path) -> list[str]:
    """Return the files of the run that a folder holds, claims first and the list itself last; none if it holds none."""
    names = _said(folder / RUN, "files")
    if not isinstance(names, list):
        return []
    paths = [PurePosixPath(str(name)) for name in names if name != RUN]
    safe = [path.as_posix() for path in paths if not path.is_absolute() and ".." not in path.parts]
    return [*sorted(safe, key=lambda name: (not name.startswith(CLAIM), name)), RUN]


def _parents(names: Iterable[str]) -> list[str]:
    """Return the folders that hold files, the innermost first."""
    found = {parent.as_posix() for name in names for parent in PurePosixPath(name).parents if parent.parts}
    return sorted(found, reverse=True)


def _foreign(folder: Path, own: Sequence[str], below: str = "") -> Iterator[str]:
    """Yield what in a folder is no file of a run; a folder without any such file as one."""
    shared, ours = _parents(own), {*own, *(f".{kind}" for kind in (FRESH, READY, LOCK))}
    for entry in sorted(os.scandir(folder / below), key=lambda entry: entry.name):
        name, is_folder = f"{below}{entry.name}", entry.is_dir(follow_symlinks=False)
        if is_folder and name in shared:
            yield from _foreign(folder, own, f"{name}/")
        elif name not in ours:
            yield name


def _clear(folder: Path, own: Sequence[str]) -> None:
    """Remove the files of a run, then the folders that are empty without them, and the list at last."""
    shared = _parents(own)
    links = [name for name in shared if (folder / name).is_symlink()]
    for name in own[:-1]:
        if not os.path.isdir(folder / name) and not set(links) & set(_parents([name])):
            (folder / name).unlink(missing_ok=True)
    for name in shared:
        with suppress(OSError):  # somebody else's files are in it
            (folder / name).rmdir()
    for name in own[-1:]:
        (folder / name).unlink(missing_ok=True)


def _move(source: Path, name: str, home: Path, called: str = "") -> str:
    """Move one thing to another folder; what is called so there already stays, and the thing gets a name that is free."""
    wanted = called or name
    found, number = wanted, 1
    (home / found).parent.mkdir(parents=True, exist_ok=True)
    while os.path.lexists(home / found):
        found, number = f"{wanted}.kept{number if number > 1 else ''}", number + 1
    os.rename(source / name, home / found)
    return found


def _replace(fresh: Path, home: Path) -> list[str]:
    """Put a finished folder in place of another, in one step where the system knows one; return what is somebody else's."""
    if not home.exists():
        os.rename(fresh, home)
        return []
    former = _hidden(home, FORMER, inside=False)
    shutil.copymode(home, fresh)
    os.rename(fresh, former)  # what is hidden may now hold somebody else's files, and is not thrown away whole any more
    if not exchange(former, home):
        os.rename(former, fresh)
        try:
            os.rename(home, former)
        except OSError:  # another disk, or held by another program
            return _fill(Path(shutil.copytree(fresh, _hidden(home, FRESH, inside=True))), home)
        try:
            os.rename(fresh, home)
        except (OSError, KeyboardInterrupt):
            os.rename(former, home)
            raise
    return _settle(former, home)


def _settle(former: Path, home: Path) -> list[str]:
    """Bring back from a replaced folder what is somebody else's, remove the rest, and return what was brought back."""
    own = _own(former)
    kept = [_move(former, name, home) for name in list(_foreign(former, own))]
    _clear(former, own)
    with suppress(OSError):
        former.rmdir()
    return kept


def _fill(fresh: Path, home: Path) -> list[str]:
    """Put finished files in place of others, without a moment in which both stand together; return what is somebody else's."""
    ready = _hidden(home, READY, inside=True)
    os.rename(fresh, ready)
    _finish(ready, home)
    return list(_foreign(home, _own(home)))


def _finish(ready: Path, home: Path) -> None:
    """Do what is left of moving files in: the old ones go, their list last; the new ones come, their list last."""
    if (names := _own(ready)) and _own(home):
        _clear(home, _own(home))
    for name in [*reversed(names[:-1]), *names[-1:]]:
        if (ready / name).exists():
            for other in (*_parents([name]), name):  # a folder may stay where one is needed, nothing else
                if os.path.lexists(home / other) and not (other != name and (home / other).is_dir()):
                    _move(home, other, home)
            _move(ready, name, home)
    shutil.rmtree(ready)
