"""The folder of compiled programs: where it is, when it is refused, and what a broken entry does."""

from __future__ import annotations

import os
import subprocess
import sys
import warnings
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from robolayout.solve import cache, programs
from robolayout.solve.cache import cache_folder, entry_key, read_entry, write_entry
from running import slow

EXAMPLES = Path(__file__).parents[2] / "examples"

OTHER = 12_345
"""A user that is not us."""


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    place = tmp_path / "cache"
    monkeypatch.setenv("ROBOLAYOUT_CACHE", str(place))
    cache._warn.cache_clear()
    return place


def test_the_folder_is_made_for_its_user_alone(folder):
    assert cache_folder() == folder
    assert folder.stat().st_mode & 0o777 == 0o700


def test_without_its_variable_the_folder_is_among_the_users_caches(tmp_path, monkeypatch):
    monkeypatch.delenv("ROBOLAYOUT_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache_folder() == tmp_path / "robolayout"


def test_off_keeps_nothing(monkeypatch, tmp_path):
    monkeypatch.setenv("ROBOLAYOUT_CACHE", "off")
    monkeypatch.chdir(tmp_path)
    write_entry("key", {}, b"code")
    assert cache_folder() is None
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_others_may_write_to_is_refused(folder):
    folder.mkdir(mode=0o700)
    folder.chmod(0o777)
    with pytest.warns(UserWarning, match=r"may be written to by others. Name a folder of your own in ROBOLAYOUT_CACHE"):
        assert cache_folder() is None


def test_a_link_is_refused(folder, tmp_path):
    (tmp_path / "elsewhere").mkdir()
    folder.symlink_to(tmp_path / "elsewhere")
    with pytest.warns(UserWarning, match="is a link or no folder"):
        assert cache_folder() is None


def test_a_folder_of_somebody_else_is_refused(folder, monkeypatch):
    folder.mkdir(mode=0o700)
    monkeypatch.setattr(os, "geteuid", lambda: OTHER)
    with pytest.warns(UserWarning, match="belongs to another user"):
        assert cache_folder() is None


def test_a_folder_that_cannot_be_made_costs_one_warning(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("ROBOLAYOUT_CACHE", str(tmp_path / "file" / "cache"))
    with pytest.warns(UserWarning, match="cannot be made"):
        assert cache_folder() is None
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert cache_folder() is None


def test_an_entry_reads_back():
    write_entry("key", {"results": [[[2], "<f4"]]}, b"\x00machine\ncode")
    assert read_entry("key") == ({"results": [[[2], "<f4"]]}, b"\x00machine\ncode")
    assert read_entry("other") is None


def test_an_entry_that_somebody_else_wrote_is_not_loaded(monkeypatch):
    write_entry("key", {}, b"code")
    folder = cache_folder()
    monkeypatch.setattr(os, "geteuid", lambda: OTHER)
    monkeypatch.setattr(cache, "cache_folder", lambda: folder)
    assert read_entry("key") is None


@pytest.mark.parametrize("harm", ["cut", "flipped", "empty", "other"])
def test_a_broken_entry_is_no_entry(folder, harm):
    write_entry("key", {}, b"code" * 100)
    path = folder / "key.xla"
    data = path.read_bytes()
    flipped = data[:-5] + bytes([data[-5] ^ 1]) + data[-4:]
    path.write_bytes({"cut": data[:-9], "flipped": flipped, "empty": b"", "other": b"something else"}[harm])
    assert read_entry("key") is None


def test_the_entries_unused_for_longest_make_room(folder, monkeypatch):
    for number in range(4):
        write_entry(f"key{number}", {}, os.urandom(1000))
        os.utime(folder / f"key{number}.xla", (number, number))
    assert read_entry("key0") is not None  # used just now
    monkeypatch.setattr(cache, "MOST_BYTES", 3 * (folder / "key0.xla").stat().st_size + 100)
    write_entry("key4", {}, os.urandom(1000))
    assert sorted(path.stem for path in folder.iterdir()) == ["key0", "key3", "key4"]


def test_every_part_of_a_program_is_in_its_key(monkeypatch):
    keys = {entry_key("f", (2,)), entry_key("g", (2,)), entry_key("f", (3,))}
    monkeypatch.setenv("XLA_FLAGS", "--xla_cpu_enable_fast_math=true")
    assert len(keys | {entry_key("f", (2,))}) == 4
    assert len(entry_key("f")) == 40


RUN = """
import sys
import numpy as np
from robolayout.solve.programs import call
x = np.arange(6, dtype=np.float32).reshape(2, 3)
(found,) = call("_probe:twice", x, factor=2.0)
print(found.tolist(), "jax" in sys.modules)
"""

PROBE = "def twice(x, *, factor):\n    return factor * x\n"


@pytest.fixture
def probe(monkeypatch, tmp_path):
    """A tiny program beside the search's, so that tests compile in no time."""
    (tmp_path / "_probe.py").write_text(PROBE)
    solve = import_module("robolayout.solve")
    monkeypatch.setattr(solve, "__path__", [*solve.__path__, str(tmp_path)])
    sys.modules.pop("robolayout.solve._probe", None)
    return tmp_path


def _fresh(probe) -> str:
    path = f"from importlib import import_module\nimport_module('robolayout.solve').__path__.append({str(probe)!r})\n"
    done = subprocess.run([sys.executable, "-c", path + RUN], capture_output=True, text=True, check=True)
    return done.stdout.strip()


@pytest.mark.slow
def test_a_second_process_runs_the_program_without_jax(probe, folder):
    first, second = _fresh(probe), _fresh(probe)
    assert first == "[[0.0, 2.0, 4.0], [6.0, 8.0, 10.0]] True"
    assert second == "[[0.0, 2.0, 4.0], [6.0, 8.0, 10.0]] False"
    (entry,) = folder.glob("*.xla")
    entry.write_bytes(entry.read_bytes()[:-1])
    assert _fresh(probe) == first  # compiled anew
    assert _fresh(probe) == second


def test_whole_entries_of_nonsense_are_compiled_anew(probe):
    known = programs.Programs()
    array = np.ones(3, np.float32)
    key = entry_key("_probe:twice", (((3,), "<f4"),), (("factor", 3.0),), programs._options())
    write_entry(key, {"results": [[[3], "<f4"]]}, b"no machine code")
    (found,) = known.future("_probe:twice", (array,), {"factor": 3.0}).result()([array])
    assert found.tolist() == [3.0, 3.0, 3.0]
    assert len(read_entry(key)[1]) > 100


def test_threads_that_want_one_program_share_it(probe, monkeypatch):
    known, made = programs.Programs(), []
    make = programs._make
    monkeypatch.setattr(programs, "_make", lambda *a, **k: made.append(a[0]) or make(*a, **k))
    array = np.ones(4, np.float32)
    with ThreadPoolExecutor(4) as pool:
        runs = list(pool.map(lambda _: known.future("_probe:twice", (array,), {"factor": 2.0}).result(), range(8)))
    assert made == ["_probe:twice"]
    assert {run([array])[0].sum() for run in runs} == {8.0}


def test_the_arrays_of_nested_tuples_come_in_order():
    template = (1, (2, (3,)), 4)
    assert [int(leaf) for leaf in programs.leaves(template)] == [1, 2, 3, 4]


@pytest.mark.parametrize("room", ["bedroom", "dining_room", "living_room", slow("tasks/classroom_crowded")])
def test_what_is_warmed_up_is_what_the_room_needs_in_every_stage(room, monkeypatch):
    from robolayout.planners import OfflinePlanner, PlanRequest
    from robolayout.program import read_program, reconcile
    from robolayout.scene import load_scene
    from robolayout.solve import compile_problem, runner, warm_up
    from robolayout.solve.stage import make_stage, stages

    def shapes(arguments):
        return [(leaf.shape, leaf.dtype) for leaf in programs.leaves(arguments)]

    warmed = []
    monkeypatch.setattr(programs.Programs, "future", lambda *asked: warmed.append(shapes(asked[2])))
    scene = load_scene(EXAMPLES / f"{room}.json")
    warm_up(scene)
    program = reconcile(read_program(OfflinePlanner().plan(PlanRequest(scene, seed=0)), scene), scene).program
    problem = compile_problem(scene, program)
    for number in stages(problem):
        stage = make_stage(problem, number, problem.start)
        assert shapes(runner._arguments(stage, problem.start[None], runner.STILL)) == warmed[0]


@pytest.mark.slow
def test_an_unknown_runtime_leaves_the_work_to_jax(probe, folder):
    other = "from robolayout.solve import programs\nprograms.TESTED = ('none',)\n"
    path = f"from importlib import import_module\nimport_module('robolayout.solve').__path__.append({str(probe)!r})\n"
    done = subprocess.run([sys.executable, "-c", path + other + RUN], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[[0.0, 2.0, 4.0], [6.0, 8.0, 10.0]] True"
    assert list(folder.glob("*.xla")) == []
    assert any((folder / "jax").iterdir())


@pytest.mark.parametrize("kept", [True, False])
def test_what_is_kept_is_not_loaded_before_it_is_needed(monkeypatch: pytest.MonkeyPatch, kept: bool) -> None:
    monkeypatch.setattr(programs, "_make", lambda *_, **__: lambda values: values)
    monkeypatch.setattr(programs, "has_entry", lambda _: kept)
    mine = programs.Programs()
    mine.compile_missing("search:advance", (np.zeros(3),), {}).result()
    assert bool(mine.keys()) != kept
