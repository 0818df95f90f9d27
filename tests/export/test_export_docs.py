"""The pages about exports say what is true, and their code runs."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from robolayout.export import EXPORTERS, Options
from robolayout.scene import Layout, Scene

DOCS = Path(__file__).parents[2] / "docs"
PAGES = {name: (DOCS / name).read_text(encoding="utf-8") for name in ("exports.md", "how-to/exporter.md")}


def run(page: str) -> dict[str, object]:
    """Run all Python blocks of a page, one after the other, as a reader would."""
    names: dict[str, object] = {}
    for number, code in enumerate(re.findall(r"^```python\n(.*?)^```$", PAGES[page], re.MULTILINE | re.DOTALL)):
        exec(compile(code, f"{page}:{number}", "exec"), names)  # noqa: S102 - our own documentation
    return names


def test_the_code_about_exports_runs(capsys: pytest.CaptureFixture[str]) -> None:
    names = run("exports.md")
    assert names["settled"].stable_share == 1.0
    assert names["driven"].contacts == {}
    assert {Path(line).name for line in capsys.readouterr().out.splitlines()[:4]} == {
        "study.glb", "study.usda", "study.xml", "plan.dxf",
    }  # fmt: skip


def test_the_table_lists_all_formats() -> None:
    rows = dict(re.findall(r"^\| `(\w+)` \| `([\w.]+)` \|", PAGES["exports.md"], re.MULTILINE))
    assert rows == {name: exporter.suffix for name, exporter in EXPORTERS.items()}
    for name, exporter in EXPORTERS.items():
        row = next(line for line in PAGES["exports.md"].splitlines() if line.startswith(f"| `{name}` "))
        assert (f"| `{exporter.extra}` |" in row) == (exporter.extra is not None)


def test_the_example_format_obeys_the_laws(scene: Scene, layout: Layout) -> None:
    exporter = run("how-to/exporter.md")["CSV"]
    back = exporter.read(exporter.write(scene, layout, Options())).layout
    for name, pose in layout.items():
        assert (back[name].x, back[name].y, back[name].z, back[name].yaw) == pytest.approx(
            (pose.x, pose.y, pose.z, pose.yaw), abs=1e-9
        )
