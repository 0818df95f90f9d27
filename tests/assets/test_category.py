"""The catalogue: complete and consistent."""

import tomllib

from robolayout.assets import CATALOGUE
from robolayout.assets.category import BUILT_IN, DATA, HEADS, PLACES, SIDES


def test_there_are_at_least_two_hundred_categories_and_all_make_sense() -> None:
    assert len(CATALOGUE) >= 200
    records = {name: entry for data in BUILT_IN.values() for name, entry in data.items() if name not in HEADS}
    assert len(CATALOGUE) == sum(len({*data} - {*HEADS}) for data in BUILT_IN.values())
    for name, category in CATALOGUE.items():
        assert category.name == name
        assert category.places
        assert set(records[name]["place"]) <= set(PLACES)
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
