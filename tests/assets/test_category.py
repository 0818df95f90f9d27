"""The catalogue: complete, consistent, readable; broken files are explained."""

import tomllib
from pathlib import Path

import pytest

from robolayout._errors import AssetError
from robolayout.assets import CATALOGUE, read_categories
from robolayout.assets.category import DATA, PLACES, SIDES


def test_there_are_at_least_two_hundred_categories_and_all_make_sense() -> None:
    assert len(CATALOGUE) >= 200
    assert len(CATALOGUE) == sum(len(read_categories(path)) for path in (DATA / "things").glob("*.toml"))
    for name, category in CATALOGUE.items():
        assert category.name == name
        assert category.places
        assert set(category.places) <= set(PLACES)
        assert set(category.use_sides) <= set(SIDES)
        assert all(0.002 < edge < 4.0 for edge in category.size), name
        assert 0.0 <= category.open_depth <= 1.2, name
        assert 0.0 < category.mass < 3000 and 0.0 < category.friction <= 1.0, name
        assert category.source and category.group, name


def test_no_synonym_is_claimed_twice() -> None:
    words = [word for category in CATALOGUE.values() for word in (category.name, *category.synonyms)]
    assert len(words) == len(set(words))


def test_every_ambiguous_word_and_every_wordnet_entry_names_known_categories() -> None:
    ambiguous = tomllib.loads((DATA / "ambiguous.toml").read_text(encoding="utf-8"))
    assert {name for names in ambiguous.values() for name in names} <= set(CATALOGUE)
    assert set(tomllib.loads((DATA / "wordnet.toml").read_text(encoding="utf-8"))) <= set(CATALOGUE)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[bed", "cannot be read"),
        ("[bed]\nplace = ['floor']", "needs size"),
        ("[bed]\nsize = [1, 1, -1]\nplace = ['floor']\nuse_sides = ['left']", "positive"),
        ("[bed]\nsize = [1, 1, 1]\nplace = ['moon']\nuse_sides = ['left']", "floor, wall"),
        ("bed = 3", "needs size"),
    ],
)
def test_a_broken_file_is_explained(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "mine.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(AssetError, match=words):
        read_categories(path)


def test_a_users_own_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text("[throne]\nsize = [0.8, 0.9, 1.6]\nplace = ['floor']\nuse_sides = ['front']\n", encoding="utf-8")
    (throne,) = read_categories(path)
    assert (throne.name, throne.group, throne.on_floor, throne.on_wall) == ("throne", "mine", True, False)
