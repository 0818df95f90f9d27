"""The page of many rooms, in a browser: filters, order and one room's figures; nothing that a room says is run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from robolayout.many.index import page

HOSTILE = "<img src=x onerror=alert(1)>"
ROWS = [
    {
        "room": i,
        "status": "met",
        "source": ("bedroom", "office", HOSTILE)[i % 3],
        "ok": i != 7,
        "why": "",
        "things": i % 50,
    }
    for i in range(130)
]


@pytest.fixture(scope="module")
def shown(chromium: Callable[..., Any], tmp_path_factory: pytest.TempPathFactory) -> Any:
    file: Path = tmp_path_factory.mktemp("many") / "index.html"
    file.write_text(page("130 rooms", ROWS), encoding="utf-8")
    tab = chromium().new_page()
    tab.set_default_timeout(240_000)
    tab.errors = []
    tab.on("pageerror", lambda error: tab.errors.append(str(error)))
    tab.on("dialog", lambda dialog: tab.errors.append(dialog.message))
    tab.goto(file.as_uri())
    yield tab
    assert tab.errors == []
    tab.close()


@pytest.mark.slow
def test_filters_choose_and_order(shown: Any) -> None:
    assert shown.inner_text("#where") == "1 to 60 of 130"
    shown.click("#after")
    assert shown.inner_text("#where") == "61 to 120 of 130"
    shown.locator("label", has_text="source").locator("select").select_option("office")
    assert shown.inner_text("#where") == "1 to 43 of 43"
    numbers = shown.get_by_placeholder("from").locator("..")
    numbers.locator("select").select_option("things")
    shown.get_by_placeholder("from").fill("40")
    shown.locator("label", has_text="order").locator("select").select_option("falling")
    expected = sorted((r["things"] for r in ROWS if r["source"] == "office" and r["things"] >= 40), reverse=True)
    found = [
        int(text.split("m, ")[1].split()[0]) for text in shown.locator("main small:first-of-type").all_inner_texts()
    ]
    assert found == expected


def test_a_click_shows_all_that_is_known_of_a_room_as_text(shown: Any) -> None:
    shown.reload()
    shown.get_by_label("words").fill("onerror")
    assert shown.inner_text("#where") == "1 to 43 of 43"
    shown.locator("main button").first.click()
    assert HOSTILE in shown.inner_text("dialog") and shown.locator("dialog img").count() == 0
