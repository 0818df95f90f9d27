"""Every code block of README and docs runs; every link leads somewhere; every generated table is up to date."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest
from docs.generate import filled, pages

from running import ROOT, Ran

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PAGES = {str(page.relative_to(ROOT)): page.read_text(encoding="utf-8") for page in pages()}
ELSEWHERE = {
    "docs/assets.md": "assets/test_assets_docs.py",
    "docs/conventions.md": "scene/test_conventions.py",
    "docs/constraints.md": "laws/test_user_relations.py",
    "docs/exports.md": "export/test_export_docs.py",
    "docs/how-to/constraint.md": "laws/test_user_relations.py",
    "docs/how-to/exporter.md": "export/test_export_docs.py",
    "docs/how-to/thing.md": "assets/test_how_to.py",
    "docs/how-to/planner-model.md": "planners/test_vlm_docs.py",
    "docs/program.md": "program/test_program_docs.py",
    "docs/report.md": "verify/test_verify_docs.py",
    "docs/vlm.md": "planners/test_vlm_docs.py",
}
"""Pages whose code is run, and whose statements are checked, by the tests of their station."""

HEAVY = ("robolayout compare", "robolayout batch", 'generate "')
"""Beginnings of commands that take several seconds: their blocks are left to `make test-all`."""


def shell_blocks() -> list[object]:
    """Return page and text of every shell block, the heavy ones marked."""
    found: list[object] = []
    for page, text in PAGES.items():
        for number, (kind, code) in enumerate(FENCE.findall(text)):
            if kind in ("sh", "bash", "shell", "console") and page not in ELSEWHERE:
                marks = [pytest.mark.slow] if any(word in code for word in HEAVY) else []
                found.append(pytest.param(page, code, id=f"{page}:{number}", marks=marks))
    return found


@pytest.fixture(scope="session")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder as a reader has it: the examples are there, and what is written stays out of the tree."""
    folder = tmp_path_factory.mktemp("reader")
    (folder / "examples").symlink_to(ROOT / "examples")
    return folder


def save_named(page: str, desk: Path) -> None:
    """Save the TOML file that a page names: the first that it shows."""
    shown = [code for kind, code in FENCE.findall(PAGES[page]) if kind == "toml"]
    if shown and (named := re.search(r'"(\w+\.toml)"', PAGES[page])):
        (desk / named[1]).write_text(shown[0], encoding="utf-8")


FIGURE = re.compile(r"-?\d+\.\d+")
ROUNDING = 0.011
"""How far a printed figure may be from the page's: another processor rounds differently."""


def assert_same_print(shown: list[str], printed: list[str]) -> None:
    """Compare what a block prints with what its page says that it prints, figure by figure."""
    assert [FIGURE.sub("0", line) for line in shown] == [FIGURE.sub("0", line) for line in printed]
    figures = [[float(number) for line in lines for number in FIGURE.findall(line)] for lines in (shown, printed)]
    assert figures[0] == pytest.approx(figures[1], abs=ROUNDING)


@pytest.mark.parametrize("page", [page for page in PAGES if page not in ELSEWHERE and "```python\n" in PAGES[page]])
def test_python_blocks_run(
    page: str, desk: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(desk)
    save_named(page, desk)
    names: dict[str, object] = {}
    for number, (kind, code) in enumerate(FENCE.findall(PAGES[page])):
        if kind == "python":
            code = compile(code, f"{page}:{number}", "exec", dont_inherit=True)
            exec(code, names)  # noqa: S102 - our own documentation
    shown = capsys.readouterr().out
    if page == "README.md":
        printed = next(text for kind, text in FENCE.findall(PAGES[page]) if kind == "text").splitlines()
        assert_same_print(shown.splitlines(), printed)


@pytest.mark.parametrize(("page", "code"), shell_blocks())
def test_shell_blocks_run(
    page: str,
    code: str,
    desk: Path,
    command: Callable[..., Ran],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(desk)
    save_named(page, desk)
    bedroom = desk / "out" / "bedroom" / "layout.json"
    if str(bedroom.relative_to(desk)) in code and not bedroom.exists():
        command("generate", "examples/bedroom.json", "--agent", "wheelchair", "--out", "out/bedroom", "--no-pictures")
    targets = set(re.findall(r"^(\w[\w-]*):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    for line in code.replace("\\\n", " ").splitlines():
        words = shlex.split(line, comments=True)
        if words and words[0] == "robolayout":
            ran = command(*words[1:])
            assert ran.code == 0, (line, ran)
            assert not (set(re.findall(r"--out (\S+)", line)) - {w for w in words if (desk / w).exists()}), line
        elif words and words[0] == "make":
            assert set(words[1:]) <= targets
        elif words:
            assert words[:2] == ["pip", "install"] or words[0] == "export", line


def test_what_is_run_elsewhere_is_run_there() -> None:
    for page, file in ELSEWHERE.items():
        if page in PAGES:
            assert Path(page).name in (ROOT / "tests" / file).read_text(), f"{file} does not test {page}"


def test_generated_tables_are_up_to_date() -> None:
    for page, text in PAGES.items():
        assert filled(text) == text, f"{page} is out of date: run make docs"
        assert text.count("<!-- table: ") == text.count("<!-- end of table -->"), page
    assert (
        filled("<!-- table: agents -->\nold\n<!-- end of table -->")
        != "<!-- table: agents -->\nold\n<!-- end of table -->"
    )


@pytest.mark.parametrize("page", PAGES)
def test_links_lead_somewhere(page: str) -> None:
    for target, anchor in re.findall(r"\]\((?!https?:)([^)#\s]*)(#[^)\s]+)?\)", FENCE.sub("", PAGES[page])):
        path = ((ROOT / page).parent / target).resolve() if target else ROOT / page
        made = path == ROOT / "docs" / "benchmarks.md"  # written by `make bench`
        assert path.exists() or made, f"{page} links to {target}, which is not there"
        if anchor:
            heads = re.findall(r"^#+ (.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
            assert anchor[1:] in {re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-") for head in heads}


def test_every_page_is_listed() -> None:
    index = PAGES["docs/README.md"]
    missing = [p for p in PAGES if p.startswith("docs/") and p != "docs/README.md" and f"({p[5:]})" not in index]
    assert not missing, f"add to docs/README.md: {missing}"


def test_no_page_shows_a_path_of_this_machine() -> None:
    for page, text in PAGES.items():
        assert not re.search(r"/(?:work|root|home|tmp)/\w", text), page
