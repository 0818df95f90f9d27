"""Whatever is killed, the finished set is byte for byte that of an undisturbed run."""

from __future__ import annotations

import multiprocessing
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import robolayout as rl
from robolayout.many.dataset import Progress
from running import ROOT
from tiny_sets import tiny_spec, tree


def hidden(folder: Path) -> list[str]:
    return [path.name for path in folder.rglob(".*")]


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="the system cannot fork")
def test_killed_at_twenty_moments_of_its_work_on_the_disk(tmp_path: Path) -> None:
    script = [sys.executable, str(ROOT / "tests" / "many" / "killed.py"), str(tmp_path), "20"]
    done = subprocess.run(script, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    whole = tree(tmp_path / "whole")
    assert int(done.stdout) > 200 and b"near-duplicate of room 0" in whole["rooms/00000/00000003/room.json"]
    stopped = [path for path in tmp_path.iterdir() if path.name.isdigit()]
    assert len(stopped) == 20
    for folder in stopped:
        assert tree(folder) == whole, folder.name
        assert hidden(folder) == []


def killed_workers(tmp_path: Path, count: int, kills: int) -> int:
    """Make a set while workers are killed, compare it with an undisturbed one, and return how many were killed.

    The oldest worker is killed, each time after a room more has been made: a room whose workers end five times is replaced.
    """
    table, rng, done, made = tiny_spec(tmp_path, count), random.Random(1), list[int](), [0]

    def kill(progress: Progress) -> None:
        workers = multiprocessing.active_children()
        if len(done) < kills and workers and progress.made != made[0]:
            time.sleep(rng.random() * 0.2)
            victim = min(workers, key=lambda worker: int(worker.name.rpartition("-")[2]))
            made[0] = progress.made
            done.append(victim.pid or 0)
            os.kill(done[-1], signal.SIGKILL)

    rl.batch(table, tmp_path / "disturbed", workers=2, progress=kill)
    rl.batch(table, tmp_path / "whole", workers=2)
    assert tree(tmp_path / "disturbed") == tree(tmp_path / "whole")
    assert all(status["status"] == "met" for status in _notes(tmp_path / "disturbed"))
    return len(done)


def _notes(folder: Path) -> list[dict[str, str]]:
    import json

    # rooms that are being written are hidden, and take their names while one looks
    return [json.loads(path.read_text()) for path in sorted(folder.glob("rooms/*/[0-9]*/room.json"))]


@pytest.mark.slow
def test_killed_workers_cost_nothing_but_time(tmp_path: Path) -> None:
    assert killed_workers(tmp_path, 5, 2) == 2


@pytest.mark.slow
def test_twenty_killed_workers_cost_nothing_but_time(tmp_path: Path) -> None:
    assert killed_workers(tmp_path, 40, 20) == 20


def killed_drivers(tmp_path: Path, count: int, kills: int) -> None:
    """Kill the command at random moments, let it go on each time, and compare with an undisturbed run."""
    table, rng = tiny_spec(tmp_path), random.Random(2)
    keys = ["--set", f"each={count}", "--set", "files=formats", "--workers", "2", "--quiet"]
    words = [sys.executable, "-m", "robolayout", "batch", table["rooms"][0], *keys, "--out"]
    for _ in range(kills):
        with subprocess.Popen([*words, str(tmp_path / "disturbed")], stderr=subprocess.PIPE, text=True) as process:
            there = len(_notes(tmp_path / "disturbed"))
            while process.poll() is None and len(_notes(tmp_path / "disturbed")) <= there:
                time.sleep(0.02)
            time.sleep(rng.random() * 0.5)
            process.send_signal(signal.SIGKILL)
            assert process.stderr is not None and process.stderr.read() == ""
    for name in ("disturbed", "whole"):
        subprocess.run([*words, str(tmp_path / name)], check=True)
    assert tree(tmp_path / "disturbed") == tree(tmp_path / "whole")
    assert hidden(tmp_path) == []


@pytest.mark.slow
@pytest.mark.parametrize(("count", "kills"), [(60, 20)])
def test_the_command_killed_at_random_moments(tmp_path: Path, count: int, kills: int) -> None:
    killed_drivers(tmp_path, count, kills)


@pytest.mark.slow
def test_the_command_killed_once(tmp_path: Path) -> None:
    killed_drivers(tmp_path, 4, 1)


def test_workers_end_with_the_command_that_started_them(tmp_path: Path) -> None:
    table = tiny_spec(tmp_path, 2)
    code = (
        "import sys, time, multiprocessing\nfrom pathlib import Path\nfrom robolayout.many import read_spec\n"
        "from robolayout.many.workers import Local, Task\n"
        "if __name__ == '__main__':\n    workers = Local(read_spec(sys.argv[1]), Path(), 1)\n"
        "    workers.send(Task(0, 0))\n    print(multiprocessing.active_children()[0].pid, flush=True)\n    time.sleep(60)"
    )
    script = tmp_path / "script.py"
    script.write_text(code)
    with subprocess.Popen([sys.executable, script, table["rooms"][0]], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        worker = int(process.stdout.readline())
        process.send_signal(signal.SIGKILL)
        process.wait()
    for _ in range(600):
        if not alive(worker):
            break
        time.sleep(0.1)
    assert not alive(worker)


def alive(process: int) -> bool:
    """Return whether a process runs; one that has ended and that nobody waited for does not."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False
