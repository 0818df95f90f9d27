"""A plain `pip install .` of the README, on other Pythons, with the newest of every library that the package allows."""

import os
import subprocess
from pathlib import Path

import pytest

from robolayout.solve.cache import VARIABLE as CACHE

ROOT = Path(__file__).parents[1]

RUN = """
import math, sys
import robolayout as rl

scene = rl.load_scene(sys.argv[1])
lines = []
for name, pose in rl.generate(scene).layout.items():
    thing = "{}[{}]".format(*name.rsplit("-", 1))
    lines += [f"{thing}.position = [{pose.x + 0.2}, {pose.y}, {pose.z}]", f"{thing}.rotation = [{math.degrees(pose.yaw)}]"]
result = rl.generate(scene, program="\\n".join([*lines, "solver.against_wall(double_bed[0])"]))
print(result.solution.phase, "jaxlib.xla_client" in sys.modules, "jax" in sys.modules)
"""


@pytest.mark.slow
@pytest.mark.parametrize("version", ["3.12", "3.13", "3.14"])
def test_the_newest_libraries_compile_once_and_run(version, tmp_path):
    known = {**os.environ, "PYENV_VERSION": version, CACHE: str(tmp_path / "cache")}
    known.pop("PYTHONPATH", None)

    def run(*command: str | Path) -> str:
        done = subprocess.run(command, env=known, capture_output=True, text=True, cwd=tmp_path)
        assert done.returncode == 0, done.stderr
        return done.stdout

    try:
        run(f"python{version}", "-m", "venv", tmp_path / "new")
    except (FileNotFoundError, AssertionError):
        pytest.skip(f"no python{version} on this machine")
    python = tmp_path / "new" / "bin" / "python"
    run(python, "-m", "pip", "install", "-q", ROOT)
    bedroom = ROOT / "examples" / "bedroom.json"
    assert run(python, "-c", RUN, bedroom).split() == ["polish", "True", "True"]
    assert run(python, "-c", RUN, bedroom).split() == ["polish", "True", "False"]  # by the runtime below JAX
    run(python, "-m", "robolayout", "generate", bedroom, "--out", tmp_path / "out")
