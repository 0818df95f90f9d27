"""The pages about models: their code runs, their lists are those of the code."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest

from robolayout.planners.model.planner import MODES

ROOT = Path(__file__).parents[2]
PAGES = ("docs/vlm.md", "docs/how-to/planner-model.md")


def blocks(page: str) -> list[str]:
    return re.findall(r"```python\n(.*?)^```", (ROOT / page).read_text(), re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize(("page", "number"), [(page, i) for page in PAGES for i in range(len(blocks(page)))])
def test_code_on_the_page_runs(
    page: str, number: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    code = blocks(page)[number]
    script = tmp_path / "block.py"
    script.write_text(code)
    runpy.run_path(str(script))
    shown = [comment for line in code.splitlines() if (comment := line.partition(")  # ")[2])]
    if shown:
        assert capsys.readouterr().out.splitlines() == shown


def test_the_table_of_modes_is_complete() -> None:
    rows = re.findall(
        r"^\| `(\w+)`(?: \(default\))? \| .* \| (yes|no) \|", (ROOT / "docs/vlm.md").read_text(), re.MULTILINE
    )
    assert tuple(mode for mode, _ in rows) == MODES
    assert [mode for mode, pictures in rows if pictures == "no"] == ["no_image"]


def test_the_prompt_of_the_judge_is_on_the_page() -> None:
    shown = re.search(
        r"<!-- judge\.md -->\n```text\n(.*?)^```", (ROOT / "docs/vlm.md").read_text(), re.DOTALL | re.MULTILINE
    )
    assert shown and shown[1] == (ROOT / "src/robolayout/planners/model/prompts/judge.md").read_text()
