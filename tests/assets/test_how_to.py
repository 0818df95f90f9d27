"""docs/how-to/thing.md works as it is written: one record in one file, in the package or in a file of one's own."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from robolayout._errors import AssetError, SceneError
from robolayout.assets import parts
from robolayout.planners import OfflinePlanner, PlanRequest, scene_from_sentence

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "how-to" / "thing.md").read_text("utf-8")
RECORD, OWN = re.findall(r"```toml\n(.*?)```", PAGE, flags=re.DOTALL)
SENTENCE = "a living room with a spinning wheel"
FURNISH = f"""
from robolayout.assets import CATALOGUE, find_category
from robolayout.planners import OfflinePlanner, PlanRequest, scene_from_sentence
scene, understood = scene_from_sentence({SENTENCE!r})
assert understood.wished == {{"spinning wheel": 1}} and not understood.ignored
assert find_category("an old saxony wheel").name == "spinning wheel"
print(OfflinePlanner().plan(PlanRequest(scene)))
"""


@pytest.mark.slow
def test_one_record_in_one_file_is_known_drawn_and_placed(tmp_path: Path) -> None:
    package = tmp_path / "robolayout"
    shutil.copytree(ROOT / "src" / "robolayout", package, ignore=shutil.ignore_patterns("__pycache__"))
    named = re.search(r"`src/robolayout/(assets/data/things/\w+\.toml)`", PAGE)
    assert named is not None
    with (package / named[1]).open("a", encoding="utf-8") as file:
        file.write(f"\n{RECORD}")
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    furnished = subprocess.run(
        [sys.executable, "-c", FURNISH], env=environment, capture_output=True, text=True, check=True
    )
    assert "against_wall(spinning_wheel[0]" in furnished.stdout
    laws = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-p",
        "no:cacheprovider",
        "tests/assets/test_meshes.py",
        "-k",
        "spinning",
    ]
    held = subprocess.run(laws, env=environment, cwd=ROOT, capture_output=True, text=True, check=False)
    assert held.returncode == 0 and "1 passed" in held.stdout, held.stdout


def test_a_record_of_ones_own_is_drawn_by_its_own_rows(tmp_path: Path) -> None:
    own = tmp_path / "crafts.toml"
    own.write_text(OWN, encoding="utf-8")
    scene, understood = scene_from_sentence(SENTENCE, knowledge=[own])
    assert understood.wished == {"spinning wheel": 1}
    wheel = next(asset for asset in scene.assets if asset.category == "spinning wheel")
    assert wheel.like == "easel" and {part.name for part in parts(wheel)} == {"bench", "wheel"}
    assert "against_wall(spinning_wheel[0]" in OfflinePlanner([own]).plan(PlanRequest(scene))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "box wood",
            "box wod",
            "parts of the thing 'spinning wheel', part 'bench': unknown material 'wod'; known: white",
        ),
        (
            "z 0:.36",
            "z 0:3.6",
            "parts of the thing 'spinning wheel', part 'bench': z reaches 2.60 m beyond the thing's 1 m",
        ),
        (
            "z 0:.36",
            "z .36:.36",
            "parts of the thing 'spinning wheel', part 'bench': its two ends along z are one; part them",
        ),
        ('role = "statue"', 'role = "statu"', "unknown role of 'spinning wheel': 'statu'. Did you mean 'statue'?"),
        (
            'like = "easel"',
            'likes = "easel"',
            "unknown key in the thing 'spinning wheel': 'likes'. Did you mean 'like'?",
        ),
        ('label = "crafts"', "label = 3", "its group: label must be a text in quotes, but is 3."),
    ],
)
def test_a_broken_record_is_named(tmp_path: Path, old: str, new: str, said: str) -> None:
    own = tmp_path / "crafts.toml"
    own.write_text(OWN.replace(old, new), encoding="utf-8")
    with pytest.raises((SceneError, AssetError)) as error:
        OfflinePlanner([own])
    assert said in str(error.value) and "crafts.toml" in str(error.value)
