"""A data set of rooms: who is to make which room next, what is kept, and where it stands; one process decides and writes.

Rooms come in any order and are written whole when they come; they are compared with earlier ones in the order of their
numbers, so that the set is the same for any number of workers. The folders of the rooms are all that a run knows of what was
done before it: the same command goes on where another was stopped.
"""

from __future__ import annotations

import json
import re
import shutil
from collections import Counter, deque
from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic
from typing import Any, cast

from robolayout._errors import InputError, OutputError
from robolayout._files import check_writable, locked, write_atomic
from robolayout._reading import Checker
from robolayout._text import pretty
from robolayout._version import __version__
from robolayout.many.index import check_tables, write_index
from robolayout.many.room import NOTE, Made, shelved
from robolayout.many.spec import Ready, read_spec
from robolayout.many.variety import VARIETY, Plan, nearest
from robolayout.many.workers import WORKERS, Local, Ray, Task, Workers, check_cluster
from robolayout.run.folder import open_folder

HEAD, LOCK, TIMES, MESHES = "batch.json", ".robolayout-lock", "timing.csv", "meshes"
"""What a batch is of; who writes to it; how long each try took; the meshes that its rooms share."""

LEFT = ("rooms/*/.*.robolayout-*", ".*.tmp", f"{MESHES}/**/.*.tmp")  # what a run leaves that is killed while it writes

STATIONS = ("draw", "generate", "scene", "plan", "program", "solve", "verify", "conflicts", "write")
"""Columns of CPU seconds in `timing.csv`; `generate` holds those between it and `write`."""

PER_FOLDER = 1000  # rooms in one folder

_CHECK = Checker(InputError)


@dataclass
class Progress:
    """How far a batch is."""

    rooms: int  # rooms in all
    made: int = 0  # rooms that are there or given up
    met: int = 0  # rooms that meet their demands
    replaced: int = 0  # tries that were replaced by another
    here: int = 0  # rooms that this run made
    since: float = field(default_factory=monotonic)  # when it began, by the monotonic clock

    def __str__(self) -> str:
        spent = max(monotonic() - self.since, 1e-9) / 60
        rate = self.here / spent
        left = f"{(self.rooms - self.made) / rate:.0f} min left" if rate else "no time known"
        return f"{self.made} of {self.rooms} rooms, {self.met} met, {self.replaced} replaced, {rate:.1f} rooms a minute, {left}"


@dataclass(frozen=True)
class Batch:
    """A finished data set."""

    folder: Path  # where it is
    rooms: int  # rooms that were asked for
    met: int  # rooms that meet all demands
    unmet: int  # rooms that do not and were kept
    missing: Mapping[int, str]  # rooms that were given up, by their numbers, with the last reason
    replaced: Mapping[str, int]  # reasons for which tries were replaced, and how often
    least: float  # least difference between two rooms; 1 where none were compared

    @property
    def ok(self) -> bool:
        """Whether every room is there and meets its demands."""
        return self.met == self.rooms


def batch(
    spec: str | Path | Mapping[str, Any] | Ready,
    out: str | Path,
    *,
    workers: int = 1,
    cluster: str | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> Batch:
    """Make a data set of rooms, or go on with one.

    Args:
        spec: A TOML file, its content as a dictionary, one room in words or a scene file, or what `read_spec` returns.
        out: Folder of the data set; empty, missing, or one of the same SPEC.
        workers: Processes, or tasks of a cluster, that make rooms at the same time.
        cluster: Address of a Ray cluster ("local" starts one); None uses processes of this machine.

    Raises:
        InputError: The SPEC cannot be read, or the folder holds something else.
        OutputError: The folder cannot be written; what is there is whole, and the same call goes on.
    """
    check_tables()  # before hours of work
    ready = spec if isinstance(spec, Ready) else read_spec(spec)
    folder = Path(out)
    check_writable(folder)
    _check_folder(folder, ready)
    if cluster is not None:
        check_cluster(cluster)
    folder.mkdir(parents=True, exist_ok=True)
    with locked(folder / LOCK, folder):
        content = {"robolayout": __version__, "digest": ready.digest(), "spec": ready.spec.to_dict()}
        write_atomic(folder / HEAD, pretty(content))
        meshes = shelved(ready, folder / MESHES)
        run = _Run(ready, folder, progress or (lambda progress: None))
        run.go_on()
        if not run.complete:
            count = max(1, min(workers, ready.count))
            engine = Local(ready, meshes, count) if cluster is None else Ray(ready, cluster, workers)
            with closing(engine):
                run.finish(engine)
        return run.close()


def _check_folder(folder: Path, ready: Ready) -> None:
    """Refuse a folder that holds anything but a batch of the same SPEC."""
    if not folder.exists():
        return
    head, others = folder / HEAD, sorted(path.name for path in folder.iterdir() if path.name != LOCK)
    if others and not head.is_file():
        shown = ", ".join(others[:3]) + (", ..." if len(others) > 3 else "")
        raise InputError(f"{folder} holds something else ({shown}); give --out a folder that is empty or missing.")
    if not head.is_file():
        return
    found = _CHECK.mapping(_CHECK.read_json(head, "batch"), f"batch {head}")
    if found.get("digest") == ready.digest() and found.get("robolayout") == __version__:
        return
    before, now = _CHECK.mapping(found.get("spec"), f"spec of {head}"), ready.spec.to_dict()
    keys = [key for key in {**before, **now} if before.get(key) != now.get(key)]
    what = f"a file that it names changed, or RoboLayout ({found.get('robolayout')}) did"
    what = f"its {', '.join(keys)} changed" if keys else what
    raise InputError(f"{folder} holds rooms of another SPEC: {what}; choose another folder, or the former SPEC.")


def room_path(index: int) -> str:
    """Return where a room is in its batch."""
    return f"rooms/{index // PER_FOLDER:05d}/{index:08d}"


@dataclass
class _Known:
    """What is known of one room."""

    status: str
    attempt: int
    replaced: list[str]
    plan: Plan | None = None
    nearest: tuple[float, int] = (1.0, -1)


class _Run:
    """One run of a batch: what is known of every room, and what is to be done."""

    def __init__(self, ready: Ready, folder: Path, tell: Callable[[Progress], None]) -> None:
        self.ready, self.folder, self.tell = ready, folder, tell
        self.known: dict[int, _Known] = {}
        self.queue: deque[int] = deque()
        self.tries: dict[int, list[str]] = {}  # of a room under way: why its former tries were replaced
        self.deaths: Counter[Task] = Counter()
        self.settled = 0  # rooms below this number have been compared with all before them
        self.plans: dict[str, list[tuple[int, Plan]]] = {}
        self.progress = Progress(ready.count)

    @property
    def complete(self) -> bool:
        """Whether every room is there or given up."""
        return self.settled == self.ready.count

    def go_on(self) -> None:
        """Look at what an earlier run made, and queue the rest."""
        for pattern in LEFT:
            for left in self.folder.glob(pattern):
                shutil.rmtree(left) if left.is_dir() else left.unlink()
        for index in range(self.ready.count):
            note = self.folder / room_path(index) / NOTE
            if note.is_file():
                self._know(index, _CHECK.mapping(_CHECK.read_json(note, "room"), f"room {note}"))
            else:
                self.queue.append(index)
        self._settle()

    def finish(self, engine: Workers) -> None:
        """Have all rooms made that are not there."""
        under_way = 0
        try:
            while self.queue or under_way:
                while self.queue and under_way < engine.slots:
                    index = self.queue.popleft()
                    engine.send(Task(index, len(self.tries.setdefault(index, []))))
                    under_way += 1
                for task, made in engine.done():
                    under_way -= 1
                    self._take(task, made)
                    self._settle()
                    self.tell(self.progress)
        except OutputError as error:
            whole = f"{self.progress.made} of {self.ready.count} rooms are whole"
            raise OutputError(f"{error} {whole}; the same command goes on with the others.") from error

    def _take(self, task: Task, made: Made | None) -> None:
        """Keep what was made, or have the room made again."""
        if made is None:
            self.deaths[task] += 1
            if self.deaths[task] < WORKERS.deaths:
                self.queue.appendleft(task.index)
                return
            bounds = f"{self.ready.spec.seconds:g} s and {self.ready.spec.memory:g} GB"
            made = Made(f"its worker ended {WORKERS.deaths} times; bounds are {bounds}")
        self._time(task, made)
        if made.why:
            self._replace(task.index, made.why)
            return
        before = self.tries.pop(task.index)
        row = dict(made.row)
        note = {"status": "met" if row["ok"] else "unmet", "attempt": task.attempt, "replaced": before, "row": row}
        self._write(task.index, {**note, "things": made.things}, made.files)

    def _replace(self, index: int, why: str) -> None:
        """Queue another try at a room, or give it up and say so in its place."""
        before = self.tries.setdefault(index, [])
        before.append(why)
        self.progress.replaced += 1
        if len(before) < self.ready.spec.tries:
            self.queue.appendleft(index)
            return
        del self.tries[index]
        row = {"source": self.ready.sources[index % len(self.ready.sources)].text}
        note = {"status": "missing", "attempt": len(before), "replaced": before, "row": row, "things": []}
        self._write(index, note, {})

    def _write(self, index: int, note: Mapping[str, Any], files: Mapping[str, bytes]) -> None:
        """Put a room in its place, whole or not at all."""
        with open_folder(self.folder / room_path(index)) as run:
            for name, data in files.items():
                write_atomic(run.path / name, data)
            write_atomic(run.path / NOTE, json.dumps(note, ensure_ascii=False, allow_nan=False) + "\n")
        self.progress.here += 1
        self._know(index, note)

    def _know(self, index: int, note: Mapping[str, Any]) -> None:
        """Remember what is needed of a room."""
        plan = Plan(note["things"]) if self.ready.spec.distinct and note["status"] != "missing" else None
        self.known[index] = _Known(note["status"], note["attempt"], list(note["replaced"]), plan)
        self.progress.made += 1
        self.progress.met += note["status"] == "met"

    def _settle(self) -> None:
        """Compare rooms with all before them, in the order of their numbers, as far as these are there."""
        while (room := self.known.get(self.settled)) is not None:
            if room.plan is not None:
                source = self.ready.sources[self.settled % len(self.ready.sources)].text
                others = self.plans.setdefault(source, [])
                room.nearest = nearest(room.plan, others)
                if room.nearest[0] < VARIETY.least:  # it is made again
                    del self.known[self.settled]
                    self.progress.made -= 1
                    self.progress.here -= 1
                    self.progress.met -= room.status == "met"
                    self.tries[self.settled] = room.replaced
                    self._replace(self.settled, f"near-duplicate of room {room.nearest[1]}")
                    continue
                others.append((self.settled, room.plan))
                room.plan = None
            self.settled += 1

    def _time(self, task: Task, made: Made) -> None:
        """Write down how long a try took, apart from what it made."""
        file = self.folder / TIMES
        spent = [f"{made.seconds.get(name, 0.0):.3f}" for name in STATIONS] + [f"{made.seconds.get('memory', 0):.0f}"]
        line = [task.index, task.attempt, "replaced" if made.why else "made", *spent]
        try:
            with file.open("a", encoding="utf-8") as lines:
                if not lines.tell():
                    lines.write(",".join(["room", "attempt", "outcome", *STATIONS, "memory_mb"]) + "\n")
                lines.write(",".join(map(str, line)) + "\n")
        except OSError as error:
            raise OutputError(f"cannot write {file}: {error.strerror}; free some space.") from error

    def close(self) -> Batch:
        """Write the index and all that is about the whole set, and return what became of it."""
        rows: list[dict[str, Any]] = []
        reasons: Counter[str] = Counter()
        for index, room in sorted(self.known.items()):
            note = cast("dict[str, Any]", _CHECK.read_json(self.folder / room_path(index) / NOTE, "room"))
            reasons.update(re.sub(r"\d[\d.]*", "#", why) for why in room.replaced)
            about = {"room": index, "status": room.status, "path": room_path(index), "replaced": len(room.replaced)}
            about["why"] = room.replaced[-1] if room.status == "missing" else ""
            if self.ready.spec.distinct:
                about |= {"difference": round(room.nearest[0], 4), "nearest_room": room.nearest[1]}
            rows.append(about | note["row"])
        write_index(self.ready, self.folder, rows, dict(reasons.most_common()))
        count = Counter(room.status for room in self.known.values())
        missing = {row["room"]: row["why"] for row in rows if row["status"] == "missing"}
        least = min((room.nearest[0] for room in self.known.values()), default=1.0)
        return Batch(self.folder, len(rows), count["met"], count["unmet"], missing, dict(reasons), least)
