"""What is written into `report.html`, without opening it: hostile text, policy, size, and the viewer's origin."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace

import pytest
from page_runs import HOSTILE, MOMENTS, PLACES, run_of

from robolayout import page_html
from robolayout.page.marks import rule_rows
from robolayout.program import read_program
from robolayout.run.result import Result
from robolayout.scene import Asset, Room, Scene, Snapshot, Trace
from robolayout.verify import exempt_from_reach
from running import ROOT

DATA = ROOT / "src" / "robolayout" / "page" / "data"
WEB = ROOT / "web"
NAMESPACES = {"http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg"}
"""Names that the browser's own functions ask for; nothing is loaded from there."""


class Parts(HTMLParser):
    """Collects what a page consists of."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.policy = ""
        self.texts: dict[str, str] = {}
        self._open = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        known = dict(attrs)
        self.tags.append(tag)
        self._open = (known.get("id") or tag) if tag in ("script", "style") else ""
        if known.get("http-equiv") == "Content-Security-Policy":
            self.policy = known["content"] or ""

    def handle_data(self, data: str) -> None:
        if self._open:
            self.texts[self._open] = self.texts.get(self._open, "") + data

    def handle_endtag(self, tag: str) -> None:
        self._open = ""


def test_the_data_comes_back_as_it_was(run: Result) -> None:
    data = json.loads(Parts(page_html(run)).texts["data"])
    assert [asset["name"] for asset in data["assets"]] == list(PLACES)
    assert data["assets"][0]["pose"] == [1990, 3975, 500, 2700]
    assert [agent["name"] for agent in data["agents"]] == ["wheelchair", "robot_vacuum"]
    assert len(data["trace"]["frames"]) == MOMENTS
    assert data["ok"] is run.report.ok
    for agent, report in zip(data["agents"], run.report.agents, strict=True):
        assert agent["problems"] == list(report.violations)
        aside, routes = exempt_from_reach(run.scene, report.agent), report.navigation.routes
        assert [len(line) // 2 for line in agent["routes"]] == [
            len(routes[name].points) if name in routes and name not in aside else 0 for name in PLACES
        ]


def test_every_verdict_is_the_reports(run: Result) -> None:
    data = json.loads(Parts(page_html(run)).texts["data"])
    assert [s["met"] for s in data["statements"]] == [s.met for s in run.report.statements]
    assert not data["statements"][2]["met"] and "2.60 m" not in data["statements"][0]["text"]
    assert data["problems"] == [f"{s.sentence} is not met: {s.text}." for s in run.report.statements if not s.met]
    for agent, report in zip(data["agents"], run.report.agents, strict=True):
        bad = [name for name, asset in zip(PLACES, agent["assets"], strict=True) if asset["state"] == "bad"]
        assert bad == list(report.short)


def test_hostile_text_stays_text(strange_run: Result) -> None:
    text = page_html(strange_run)
    plain = Parts(text)
    assert text.isascii()
    assert plain.tags.count("img") == 0 and plain.tags.count("script") == 3 and plain.tags.count("style") == 1
    data = json.loads(plain.texts["data"])
    assert data["name"] == data["task"] == data["assets"][0]["description"] == HOSTILE
    assert set("<>&") & set(plain.texts["data"]) == set()


def test_the_policy_allows_this_script_and_this_style_alone(run: Result) -> None:
    parts = Parts(page_html(run))
    rules = dict(rule.strip().split(" ", 1) for rule in parts.policy.split(";"))
    digest = {
        name: base64.b64encode(hashlib.sha256(parts.texts[name].encode()).digest()).decode()
        for name in ("script", "style")
    }
    assert rules == {
        "default-src": "'none'",
        "script-src": f"'sha256-{digest['script']}'",
        "style-src": f"'sha256-{digest['style']}'",
        "base-uri": "'none'",
        "form-action": "'none'",
    }


def test_the_page_names_no_address(run: Result) -> None:
    assert set(re.findall(r"https?://[^\s\"'`)\\]+", page_html(run))) <= NAMESPACES


def test_the_viewer_is_made_of_the_sources_and_the_library_that_are_named() -> None:
    viewer = (DATA / "viewer.js").read_text(encoding="utf-8")
    package = json.loads((WEB / "package.json").read_text(encoding="utf-8"))
    version = package["devDependencies"]["three"]
    assert re.fullmatch(r"0\.\d+\.\d+", version), "one exact version, so that the bundle can be made again"
    assert f"It contains three.js {version}:" in viewer[:1000]
    assert f'"{version.split(".")[1]}"' in viewer, "the library's own word for its version"
    assert "Permission is hereby granted, free of charge" in viewer[:3000]
    assert f"sources {fingerprint()}" in viewer[:1000], "the bundle is older than its sources: run `make page`"
    assert (DATA / "page.html").read_text() == (WEB / "src" / "page.html").read_text()


def fingerprint() -> str:
    """Return the same sum over the sources as web/build.mjs."""
    names = ["package.json", "build.mjs", *sorted(f"src/{path.name}" for path in (WEB / "src").iterdir())]
    digest = hashlib.sha256()
    for name in names:
        digest.update(f"{name}\n{(WEB / name).read_text(encoding='utf-8')}\n".encode())
    return digest.hexdigest()


def test_the_viewer_is_small_and_can_stand_in_a_page() -> None:
    viewer = (DATA / "viewer.js").read_text(encoding="utf-8")
    assert len(viewer) < 800_000 and viewer.isascii()
    assert not re.search(r"</script|<!--|\beval\(|new Function\b|innerHTML|document\.write", viewer)
    assert "</style" not in (DATA / "viewer.css").read_text(encoding="utf-8")


KINDS = {"bookcase": (0.35, 0.9, 1.9), "potted plant": (0.4, 0.4, 1.1), "dining chair": (0.5, 0.45, 0.9)}


def test_a_page_with_twenty_assets_is_at_most_2500_kilobytes() -> None:
    kinds = [list(KINDS)[k % len(KINDS)] for k in range(20)]
    assets = tuple(Asset(f"{kind.replace(' ', '_')}-{k}", kind, KINDS[kind]) for k, kind in enumerate(kinds))
    scene = Scene(Room(((0, 0), (9, 0), (9, 8), (0, 8)), 2.6), assets, name="hall")
    places = {a.name: (1 + 1.7 * (k % 5), 1 + 1.9 * (k // 5), a.size[2] / 2, 10 * k) for k, a in enumerate(assets)}
    made = run_of(scene, places, read_program("", scene))
    long = Trace(
        tuple({"total": 1.0} for _ in range(3000)),
        tuple(Snapshot(k, "search", made.trace.snapshots[-1].poses) for k in range(500)),
    )
    page = page_html(replace(made, solution=replace(made.solution, trace=long)))
    assert len(page) < 2_500_000
    assert len(json.loads(Parts(page).texts["data"])["trace"]["frames"]) == 120


def test_a_run_without_a_trace_and_with_an_unplaced_asset_has_a_page(run: Result) -> None:
    places = {name: place for name, place in PLACES.items() if name != "armchair-0"}
    data = json.loads(Parts(page_html(run_of(run.scene, places, run.program))).texts["data"])
    chair = [asset["name"] for asset in data["assets"]].index("armchair-0")
    assert data["assets"][chair]["pose"] is None
    assert data["assets"][chair]["rows"] == [["Placed", "no", False]]
    assert data["agents"][0]["assets"][chair]["state"] == "bad"


@pytest.mark.parametrize("name", ["viewer.js", "viewer.css", "page.html"])
def test_the_parts_have_unix_line_ends(name: str) -> None:
    assert b"\r" not in Path(DATA / name).read_bytes()


def test_named_rules_say_what_was_measured_and_where_they_come_from() -> None:
    rule = SimpleNamespace(
        name="turning_space", asks="there is a circle", origin="a standard, 3.4 (not checked at its source)"
    )
    found = SimpleNamespace(rule=rule, agent="wheelchair", measured=SimpleNamespace(text="1.20 m"), met=False)
    (row,) = rule_rows(SimpleNamespace(rules=(found,)))  # type: ignore[arg-type]
    assert row == {
        "agent": "wheelchair",
        "name": "turning space",
        "asks": "there is a circle",
        "source": "a standard, 3.4 (not checked at its source)",
        "measured": "1.20 m",
        "met": False,
    }
