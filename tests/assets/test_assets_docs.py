"""docs/assets.md tells the truth: its code runs, its misses and its category table are today's."""

import re
from pathlib import Path

from robolayout.assets import CATALOGUE, find_category
from robolayout.assets.lexicon import phrase_index, read_data

TEXT = (Path(__file__).parents[2] / "docs" / "assets.md").read_text(encoding="utf-8")
DESCRIPTIONS = Path(__file__).parent / "descriptions.txt"


def test_every_python_block_runs() -> None:
    blocks = re.findall(r"```python\n(.*?)```", TEXT, flags=re.DOTALL)
    assert len(blocks) >= 2
    for block in blocks:
        exec(compile(block, "docs/assets.md", "exec"), {})  # noqa: S102


def test_the_table_lists_every_category_in_its_group() -> None:
    rows = dict(re.findall(r"^\| ([a-z]+) \| ([^|]+) \|$", TEXT, flags=re.MULTILINE))
    for name, category in CATALOGUE.items():
        assert name in rows[category.group].split(", "), name


def test_what_is_counted_is_as_many_today() -> None:
    groups = {category.group for category in CATALOGUE.values()}
    assert f"knows {len(CATALOGUE)} categories in {len(groups)} groups" in TEXT
    assert f"All {len(CATALOGUE)} categories are drawn by rows" in TEXT
    synonyms = sum(len(category.synonyms) for category in CATALOGUE.values())
    words = sum(len(entry["words"]) for entry in read_data("wordnet.toml").values())
    counts = f"{len(phrase_index())} phrases are known: names, {synonyms} synonyms, {words} words from WordNet"
    assert counts in TEXT


def test_the_misses_are_listed() -> None:
    rows = [line.strip() for line in DESCRIPTIONS.read_text(encoding="utf-8").splitlines() if " => " in line]
    for row in rows:
        text, _, names = row.rpartition(" => ")
        missed = find_category(text).name not in {name.strip() for name in names.split("|")}
        assert (f"| {text} |" in TEXT) == missed, text
