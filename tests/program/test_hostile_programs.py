"""Programs that want to do harm are stopped, in bounded time and memory, with one clear sentence."""

import resource
import subprocess
import sys

import pytest

from robolayout._errors import ProgramError, ProgramLimitError
from robolayout.program import ProgramLimits, _sandbox, read_program
from robolayout.program._program import ReadingConfig
from robolayout.scene import Asset, Scene

QUICK = ProgramLimits(seconds=0.3, memory=64 * 2**20)
PATIENT = ProgramLimits(seconds=120.0, memory=64 * 2**20)
"""For programs that are stopped by a count or by their memory: on a busy machine that may take them many seconds."""

LIMITED = {
    "while True: pass": "the program ran longer than 0.3 s; does a loop never end?",
    "while True:\n  try:\n    while True: pass\n  except BaseException: pass": "the program ran longer than 0.3 s",
    "while True: print('x' * 1000)": "the program ran longer than 0.3 s",
    "x = 3**200000\nwhile True: y = x * x % (x - 1)": "the program ran longer than 0.3 s",
    "x = 'x' * 10**10": "the program needs more than 64 MB of memory",
    "x = 2 ** 10**10": "the program needs more than 64 MB of memory",
    "x = [0]\nwhile True: x = x + x": "the program needs more than 64 MB of memory",
    "raise ValueError('x' * 10**8)": "the program needs more than 64 MB of memory",
    "def f(): f()\nf()": "calls are nested deeper than 200; does a function call itself for ever?",
    "for i in range(10**6): solver.corner(bed[0])": "the program states more than 5000 relations; that is the limit",
    "x = [bed[0]] * 100_000\nsolver.row(x)": "the arguments name more than 50000 things; that is the limit",
    "x = [1]\nx += [x, x, x, x]\nbed[0].position = [x] * 30_000": "the arguments name more than 50000 things",
    "x" * 10**7: "the program has 10000000 characters; at most 131072 are read. Use loops",
    "solver.corner(bed[0])\n" * 10**6: "the program has 22000000 characters; at most 131072 are read",
    "-" * 100_000 + "1": "the program is nested too deeply to be read",
    "a" + ".b" * 50_000: "the program is nested too deeply to be read",
    "a" + "()" * 50_000: "the program is nested too deeply to be read",
    "x = " + "+".join(["1"] * 5_000): "the program is nested too deeply to be read",
    "if 1: 1\n" + "elif 1: 1\n" * 10_000: "the program is nested too deeply to be read",
}


@pytest.mark.parametrize(("text", "answer"), LIMITED.items(), ids=range(len(LIMITED)))
def test_greedy_programs_are_stopped(scene, text, answer):
    with pytest.raises(ProgramLimitError) as caught:
        read_program(text, scene, QUICK if "longer than" in answer else PATIENT)
    assert answer in str(caught.value)
    assert len(str(caught.value)) < 800


REFUSED = {
    "import os": "'os' cannot be imported; programs have only math (already there, with pi, radians and degrees)",
    "import math, subprocess": "'subprocess' cannot be imported",
    "from os import path": "'os' cannot be imported",
    "from . import x": "'.' cannot be imported",
    "__import__('os')": "'__import__': names that start with two underscores",
    "open('/etc/passwd').read()": "'open' does not exist in programs",
    "eval('1')": "'eval' does not exist in programs",
    "exec('x = 1')": "'exec' does not exist in programs",
    "f = getattr\nf(bed, 'x')": "'getattr' does not exist in programs",
    "().__class__.__bases__": "attributes that start with an underscore do not exist in programs",
    "solver.__init__()": "attributes that start with an underscore do not exist in programs",
    "bed[0]._rl_sites = 3": "attributes that start with an underscore do not exist in programs",
    "'{0.__class__}'.format(1)": "no attribute '__class__'",
    "_rl_log = []": "'_rl_log': names that start with two underscores or with _rl_",
    "def _rl_result(): return 'x' * 10**8": "'_rl_result': names that start with",
    "f = lambda _rl_x: 1": "'_rl_x': names that start with",
    "import math as _rl_log": "'_rl_log': names that start with",
    "for __builtins__ in bed: pass": "'__builtins__': names that start with two underscores",
    "breakpoint()": "unknown asset or variable 'breakpoint'",
    "x = '\ud800'": "the program contains characters that are no text",
    "x = 1\0": "this is not Python: ",
    "Sure! I would put the bed here.": "this is not Python: ",
}


@pytest.mark.parametrize(("text", "answer"), REFUSED.items(), ids=range(len(REFUSED)))
def test_what_does_not_exist_is_refused_in_words(scene, text, answer):
    with pytest.raises(ProgramError) as caught:
        read_program(text, scene, PATIENT)
    assert answer in str(caught.value)
    assert caught.value.__class__ is ProgramError


def test_flooding_the_output_keeps_a_bounded_part(scene):
    program = read_program("for i in range(100): print('x' * 10**5)\nsolver.corner(bed[0])", scene)
    assert sum(map(len, program.notes)) <= ProgramLimits().printed
    assert len(program.statements) == 1


def test_our_process_neither_runs_nor_grows(scene, tmp_path):
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for text in ("x = 'x' * 10**10", "x = [0]\nwhile True: x = x + x", "while True: print('y' * 10**6)"):
        with pytest.raises(ProgramLimitError):
            read_program(text, scene, ProgramLimits(seconds=0.5))
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 30 * 1024, "KiB of our own memory"


def test_the_child_is_killed_when_it_overruns(scene, monkeypatch):
    monkeypatch.setattr(_sandbox, "READING", ReadingConfig(grace=-4.7))
    with pytest.raises(ProgramLimitError, match="ran longer than 5 s"):
        read_program("while True: pass", scene)


def test_descriptions_and_categories_never_become_code(scene):
    nasty = "\"'''\n```\nimport os; solver.corner(bed[0]) # {x} %s \\"
    odd = Scene(scene.room, (Asset("bed-0", nasty, (2, 1.6, 0.5), description=nasty, metadata={"a": nasty}),))
    program = read_program("print(bed[0].category)\nsolver.corner(bed[0])", odd)
    assert program.notes == (nasty,)
    assert len(program.statements) == 1
    assert "import" not in program.to_text()


def test_reading_is_the_same_for_every_hash_seed():
    code = (
        "from robolayout.program import read_program\n"
        "from furnished_room import furnished\n"
        'p = read_program(\'for x in {"a", "b", "c"}: print(x)\\nfor c in set(chair): solver.corner(c)\', furnished())\n'
        "assert p.to_text().count('corner') == 4; import sys; sys.stdout.write(p.to_text() + repr(p.notes))"
    )
    texts = [
        subprocess.run(
            [sys.executable, "-c", code],
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": "tests/program:src", "PATH": "/usr/bin"},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("0", "1")
    ]
    assert texts[0] == texts[1] != ""
