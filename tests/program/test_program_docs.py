"""The page about the program language says what is true."""

import re
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path

import pytest

from robolayout._errors import ProgramError
from robolayout.program import ProgramLimits, read_program, reconcile

PAGE = Path("docs/program.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(\w+)\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
PROGRAMS = [text for kind, text in BLOCKS if kind == "python" and "import" not in text]


@pytest.mark.parametrize("text", PROGRAMS, ids=range(len(PROGRAMS)))
def test_programs_on_the_page_run(scene, text):
    program = read_program(text, scene)
    assert program.statements or program.notes
    assert all(decision.verdict == "accepted" for decision in reconcile(program, scene).decisions)


def test_python_on_the_page_runs():
    (code,) = [text for kind, text in BLOCKS if kind == "python" and "import" in text]
    subprocess.run([sys.executable, "-c", code], check=True)


def test_mistake_on_the_page_is_the_real_one(scene):
    (shown,) = [text for kind, text in BLOCKS if kind == "text"]
    with pytest.raises(ProgramError) as caught:
        read_program("# a\n# b\n" + shown.splitlines()[1].strip(), scene)
    assert str(caught.value).splitlines()[1:] == shown.splitlines()[1:]
    assert str(caught.value).startswith(shown.split("Known")[0])


def test_limits_on_the_page_are_the_real_ones():
    shown = {
        float(n.replace(",", "")) for n in re.findall(r"\| ([\d,]+)(?: s| MB| characters)? \|$", PAGE, re.MULTILINE)
    }
    real = asdict(ProgramLimits()) | {"memory": ProgramLimits().memory / 2**20}
    real.pop("printed")
    assert shown == set(real.values())
    assert f"first {ProgramLimits().printed:,} characters" in PAGE


def test_the_interpreter_is_loaded_only_when_a_program_is_read():
    code = "import sys, robolayout.program; assert 'pydantic_monty' not in sys.modules and 'jax' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)
