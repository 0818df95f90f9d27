"""`import robolayout` shows everything and loads nothing heavy."""

from __future__ import annotations

import subprocess
import sys

import pytest

import robolayout

HELP = "\nfrom robolayout.cli import main\ntry:\n    main()\nexcept SystemExit:\n    pass"
HEAVY = (
    "jax",
    "jaxlib",
    "numpy",
    "scipy",
    "shapely",
    "matplotlib",
    "PIL",
    "trimesh",
    "moderngl",
    "mujoco",
    "pydantic_ai",
)


def loaded_by(code: str) -> set[str]:
    """Return which heavy libraries a fresh process has loaded after some code."""
    end = f"\nimport sys; sys.stderr.write(' '.join(n for n in {HEAVY!r} if n in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code + end], check=True, capture_output=True, text=True)
    return set(done.stderr.split())


@pytest.mark.parametrize("name", robolayout.__all__)
def test_every_public_name_loads(name: str) -> None:
    assert getattr(robolayout, name) is not None
    assert name in dir(robolayout)


def test_functions_stay_functions_although_folders_have_their_names() -> None:
    import robolayout.export
    import robolayout.solve
    import robolayout.verify

    assert callable(robolayout.verify) and callable(robolayout.solve) and callable(robolayout.export)


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = robolayout.nothing


@pytest.mark.parametrize(
    "code",
    [
        "import robolayout",
        "import robolayout; robolayout.InputError",
        "import sys; sys.argv = ['robolayout', '--help']" + HELP,
        "import sys; sys.argv = ['robolayout', 'generate', '--help']" + HELP,
    ],
    ids=["import", "an error class", "--help", "generate --help"],
)
def test_nothing_heavy_is_loaded(code: str) -> None:
    assert loaded_by(code) == set()


def test_the_test_of_lightness_can_fail() -> None:
    assert "numpy" in loaded_by("import numpy")
