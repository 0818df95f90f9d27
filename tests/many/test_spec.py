"""A SPEC is read or refused in one sentence, before any work."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robolayout import InputError
from robolayout.many import Spec, read_spec
from robolayout.many.spec import value_of
from running import Ran


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({}, "the SPEC names no rooms; add them"),
        ({"rooms": ["bedroom"], "cuont": 3}, "unknown key in the SPEC 'cuont'. Did you mean 'count'?"),
        ({"rooms": ["bedroom"], "area": [2, 1]}, r"area in the SPEC is \[2, 1\], and nothing lies between"),
        ({"rooms": ["bedroom"], "area": [1, 2, 3]}, "area in the SPEC has 3 entries; at most 2"),
        ({"rooms": ["bedroom"], "area": 100}, r"area in the SPEC must be at most 20, but is 100\.$"),
        ({"rooms": ["bedroom"], "test": 5}, r"test in the SPEC must be at most 0.9, but is 5\.$"),
        ({"rooms": ["bedroom"], "doors": [0, 1]}, "doors in the SPEC must be at least 1, but is 0"),
        ({"rooms": ["bedroom"], "doors": 1.5}, "doors in the SPEC must be a whole number, but is 1.5"),
        ({"rooms": ["bedroom"], "count": 0}, "count in the SPEC must be at least 1, but is 0"),
        ({"rooms": ["bedroom"], "count": True}, "count in the SPEC must be a finite number"),
        ({"rooms": ["bedroom"], "count": 2, "each": 2}, "count and each exclude each other"),
        ({"rooms": ["bedroom"], "pictures": 1}, "pictures in the SPEC must be true or false"),
        ({"rooms": ["bedroom", "bedroom"]}, "name at least one and each once"),
        ({"rooms": ["bedroom"], "solvers": []}, "name at least one and each once"),
        ({"rooms": ["bedroom"], "solvers": ["papr"]}, "unknown solver 'papr'. Did you mean 'paper'?"),
        ({"rooms": ["bedroom"], "effort": "norml"}, "unknown effort 'norml'. Did you mean 'normal'?"),
        ({"rooms": ["bedroom"], "files": "all"}, "unknown files 'all'"),
        ({"rooms": ["bedroom"], "formats": ["gbl"]}, "unknown export format 'gbl'. Did you mean 'glb'?"),
        ({"rooms": ["bedroom"], "bodies": ["wheelchiar"]}, "unknown agent 'wheelchiar'. Did you mean 'wheelchair'?"),
        ({"rooms": ["bedroom"], "catalogues": ["own.json"]}, "catalogue own.json does not exist"),
        ({"rooms": ["none.json"]}, "scene file none.json does not exist"),
        ({"rooms": [""]}, "rooms in the SPEC: '' is no room"),
        ({"rooms": "bedroom", "seed": 10**400}, "seed in the SPEC must be"),
    ],
)
def test_what_is_wrong_is_one_sentence(table: dict[str, Any], said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        read_spec(table)
    assert len(str(caught.value).splitlines()) == 1


def test_a_file_is_read_and_names_files_from_its_own_folder(tmp_path: Path) -> None:
    from tiny_sets import TINY

    (tmp_path / "own.json").write_text(json.dumps(TINY))
    spec = tmp_path / "many.toml"
    spec.write_text('rooms = ["own.json", "a bedroom of 3 x 4 m."]\ncount = 7\narea = 1\nbodies = ["cat,dog_medium"]\n')
    ready = read_spec(spec, seed=5)
    assert (ready.count, ready.spec.seed, ready.spec.area) == (7, 5, (1.0, 1.0))
    assert [source.sentence for source in ready.sources] == ["", "a bedroom of 3 x 4 m"]
    assert ready.sources[1].size == (3.0, 4.0)
    assert [[body.name for body in bodies or ()] for bodies in ready.bodies] == [["cat", "dog_medium"]]


def test_a_changed_file_is_another_batch(tmp_path: Path) -> None:
    from tiny_sets import TINY, tiny_spec

    table = tiny_spec(tmp_path)
    before = read_spec(table).digest()
    assert read_spec(table).digest() == before
    changed = json.loads(json.dumps(TINY))
    changed["assets"]["desk-0"]["assetMetadata"]["boundingBox"]["y"] = 1.0
    (tmp_path / "tiny.json").write_text(json.dumps(changed))
    assert read_spec(table).digest() != before
    assert read_spec(table, seed=1).digest() != read_spec(table).digest()


@pytest.mark.parametrize("text", ["rooms = [", "a = 1\na = 2", "[" * 5000, "\x00"])
def test_a_broken_file_is_one_sentence(tmp_path: Path, text: str) -> None:
    (tmp_path / "many.toml").write_text(text)
    with pytest.raises(InputError, match=r"SPEC .*many\.toml"):
        read_spec(tmp_path / "many.toml")


plain = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda one: st.lists(one, max_size=4),
)


@given(st.dictionaries(st.sampled_from([*Spec().to_dict(), "other"]), plain, max_size=4))
def test_anything_else_is_read_or_refused(table: dict[str, Any]) -> None:
    table.pop("catalogues", None)
    try:
        ready = read_spec({"rooms": ["bedroom"], **table})
    except InputError as error:
        assert str(error)
    else:
        assert ready.count >= 1
        assert json.dumps(ready.spec.to_dict())


def test_keys_on_the_command_line() -> None:
    assert value_of("count=20") == {"count": 20}
    assert value_of("effort=quick") == {"effort": "quick"}
    assert value_of('bodies=["cat", "adult"]') == {"bodies": ["cat", "adult"]}
    with pytest.raises(InputError, match="is no KEY=VALUE"):
        value_of("count")


def test_the_command_refuses_before_it_makes_a_folder(command: Callable[..., Ran], tmp_path: Path) -> None:
    out = tmp_path / "set"
    for words in (
        ["bedroom", "--set", "cuont=3"],
        ["bedroom", "--set", "area=[2, 1]"],
        ["bedroom", "--set", 'catalogues=["none.json"]'],
        [tmp_path / "none.toml"],
        ["bedroom", "--cluster", "slurm"],
    ):
        ran = command("batch", *words, "--out", out)
        assert ran.code == 2 and len(ran.err.splitlines()) == 1 and not out.exists(), ran
