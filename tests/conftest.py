"""What all tests share: a cache of compiled programs, the command line as a function, and one furnished bedroom."""

from __future__ import annotations

import fcntl
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from running import ROOT, Furnished, Ran, run_command

CACHE = "ROBOLAYOUT_CACHE"
_MADE = pytest.StashKey[str]()

unhurried = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow]}
settings.register_profile("robolayout", **unhurried, derandomize=True, print_blob=True)
settings.load_profile("robolayout")  # no test depends on speed, and a run tests what the run before it did


def pytest_configure(config: pytest.Config) -> None:
    """Give this run a cache folder of its own; workers inherit it from the process that starts them."""
    if CACHE not in os.environ:
        config.stash[_MADE] = os.environ[CACHE] = tempfile.mkdtemp(prefix="robolayout-tests-")


def pytest_unconfigure(config: pytest.Config) -> None:
    if made := config.stash.get(_MADE, None):
        shutil.rmtree(made, ignore_errors=True)
        del os.environ[CACHE]


@pytest.fixture(scope="session")
def command() -> Callable[..., Ran]:
    """The command line as a function."""
    return run_command


@pytest.fixture(scope="session")
def furnished(tmp_path_factory: pytest.TempPathFactory) -> Furnished:
    """The example bedroom for a wheelchair user, furnished once per test run, whatever the number of workers."""
    base = tmp_path_factory.getbasetemp()
    shared = (base.parent if "PYTEST_XDIST_WORKER" in os.environ else base) / "furnished"
    scene = ROOT / "examples" / "bedroom.json"
    note = shared / "printed.json"
    with _alone(shared):
        if not note.exists():
            ran = run_command("generate", scene, "--agent", "wheelchair", "--out", shared / "bedroom", "--json")
            note.write_text(json.dumps([ran.code, ran.out, ran.err]), encoding="utf-8")
    code, out, err = json.loads(note.read_text(encoding="utf-8"))
    assert code in (0, 1), err
    return Furnished(shared / "bedroom", scene, code, json.loads(out))


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Hold a lock, so that one worker does the work and the others wait for it."""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield
