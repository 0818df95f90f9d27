"""The page about the report runs and names every key."""

from __future__ import annotations

import re
from pathlib import Path

from verify_rooms import furnished, square

from robolayout.verify import verify

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "report.md").read_text(encoding="utf-8")


def test_the_example_runs(monkeypatch, capsys):
    monkeypatch.chdir(ROOT)
    (block,) = re.findall(r"```python\n(.*?)```", PAGE, flags=re.DOTALL)
    names: dict[str, object] = {}
    exec(compile(block, "docs/report.md", "exec"), names)  # noqa: S102
    assert "wardrobe-0" in capsys.readouterr().out
    assert names["data"]["placed_share"] < 0.1  # type: ignore[index]


def test_every_key_is_explained():
    report = verify(*furnished(square()))
    for key in (*report.to_dict(), *report.agents[0].to_dict()):
        assert f"`{key}`" in PAGE or key in {"name", "free_area", "routes", "passages", "unreached", "unusable"}, key


def test_the_keys_stand_in_the_order_of_the_page():
    table = PAGE[PAGE.index("## Figures") : PAGE.index("With several agents")]
    heads = [line.split("|")[1] for line in table.splitlines() if line.startswith("| `")]
    documented = [key for head in heads for key in re.findall(r"`(\w+)`", head)]
    written = list(verify(*furnished(square())).with_notes(("a note",)).to_dict())
    assert [key for key in documented if key in written] == written
