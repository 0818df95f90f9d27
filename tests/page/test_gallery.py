"""The gallery's page leafs through the rooms, and shows what is said of them as text."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from docs import gallery

from running import ROOT

NAMES = ("bedroom", "dining_room", "studio")


@pytest.fixture
def leaves(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A gallery of three rooms, without the work of furnishing them."""
    monkeypatch.setattr(gallery, "FOLDER", tmp_path)
    files = [ROOT / "examples" / f"{name}.json" for name in NAMES]
    for file in files:
        (tmp_path / file.stem).mkdir()
        said = {"title": "a disc", "ok": True, "rows": [["placed", "1.00", True], ["usable", "0.50", False]]}
        said |= {"violations": ["</script><b id=evil>"], "assets": 7}
        (tmp_path / file.stem / "report.json").write_text(json.dumps(said))
    page = tmp_path / "index.html"
    page.write_text(gallery.leaves(files), encoding="utf-8")
    return page


def test_the_page_holds_every_room(leaves: Path) -> None:
    text = leaves.read_text(encoding="utf-8")
    assert all(f'"name": "{name}"' in text for name in NAMES)
    assert text.count("</script>") == 1


@pytest.mark.slow
def test_the_page_leafs(leaves: Path, chromium: Callable[..., object]) -> None:
    page = chromium().new_page()
    page.goto(leaves.as_uri())
    seen = [page.inner_text("#title")]
    page.click("#next")
    page.wait_for_function("document.getElementById('number').textContent.startsWith('2')")
    seen.append(page.inner_text("#title"))
    page.keyboard.press("ArrowRight")
    page.wait_for_function("document.getElementById('number').textContent.startsWith('3')")
    seen.append(page.inner_text("#title"))
    assert seen == ["Bedroom", "Dining room", "Studio"]
    page.keyboard.press("ArrowRight")
    page.wait_for_function("document.getElementById('number').textContent.startsWith('1')")
    page.click("#before")
    page.wait_for_function("document.getElementById('title').textContent === 'Studio'")
    assert page.locator("#pictures img").count() == 3
    assert page.locator(".short").count() == 1
    assert page.locator("#evil").count() == 0
    assert page.inner_text("#wrong") == "</script><b id=evil>"
    page.close()
