"""The public names, and the path-traced picture's extra."""

import importlib
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from robolayout._errors import MissingExtraError
from robolayout.render import beauty, render_beauty


def test_public_names_exist():
    public = importlib.import_module("robolayout.render")
    names = re.findall(r" as (\w+)$", Path(str(public.__file__)).read_text(encoding="utf-8"), re.MULTILINE)
    assert len(names) > 20
    for name in names:
        assert getattr(public, name) is not None, name
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        public.nothing  # noqa: B018


def test_importing_render_loads_no_heavy_library():
    code = (
        "import sys; from robolayout.render import plan_svg; "
        "print([m for m in ('matplotlib', 'moderngl', 'trimesh', 'embreex', 'mitsuba', 'jax') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_without_the_extra_a_sentence_says_how_to_get_it(bedroom, layout, monkeypatch):
    def refuse(name):
        raise ImportError(name)

    monkeypatch.setattr(beauty.importlib, "import_module", refuse)
    with pytest.raises(MissingExtraError, match=r"a path-traced picture needs the extra 'beauty': pip install"):
        render_beauty(bedroom, layout)


def test_a_path_traced_picture_shows_the_same_room(bedroom, layout):
    pytest.importorskip("mitsuba")
    pytest.importorskip("pyoidn")
    from robolayout.render import render_view

    traced = np.asarray(render_beauty(bedroom, layout, view="side", size=(64, 48), samples=4), dtype=int)
    quick = np.asarray(render_view(bedroom, layout, view="side", size=(64, 48), renderer="rays"), dtype=int)
    background = (np.abs(quick - quick[0, 0]).max(axis=2) < 8).mean()
    assert np.corrcoef(traced.mean(axis=2).ravel(), quick.mean(axis=2).ravel())[0, 1] > 0.8
    assert (np.abs(traced - quick[0, 0]).max(axis=2) < 12).mean() == pytest.approx(background, abs=0.12)


def test_a_path_traced_picture_from_inside_is_lit_by_the_ceiling(bedroom, layout):
    pytest.importorskip("mitsuba")
    pytest.importorskip("pyoidn")
    inside = np.asarray(render_beauty(bedroom, layout, view="eye:wardrobe-0", size=(64, 48), samples=4), dtype=int)
    assert inside.mean() > 100, "the ceiling keeps the sky out, so it must shine itself"
