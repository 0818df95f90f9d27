"""Names that anybody may have written do nothing but stand where they are shown."""

from __future__ import annotations

import io
import json
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import ezdxf
import pytest

from robolayout._errors import LayoutError
from robolayout._text import LONGEST_NAME, bullets, file_name, html, markdown, paragraph, printable, table, utf8, xml
from robolayout.export import EXPORTERS, Options, to_bytes
from robolayout.render import plan_svg
from robolayout.scene import Agent, Asset, Layout, Pose, Room, Scene
from robolayout.verify import verify
from running import Ran, run_command

HOSTILE = [
    "[/red]",
    "[bold]loud",
    "\x1b[31mred\x1b]0;title\x07",
    "</script><script>alert(1)</script>",
    "<!-- <b onclick='x'>&quot;",
    "a | b | c",
    "two\n# lines\r\n| x |",
    "nothing\x00more",
    "half\ud800",
    "../../x",
    "n" * 300,
    "\u202egpj.exe",
    "[click](https://example.org)",
    "![seen](x)",
    "*a* _b_ `c` ~~d~~ \\",
    "%%u^J\\U+000A",
    "]]>",
    "\udcff\ufffe\x85",
]
HARMLESS = [
    "double_bed-0",
    "桌子-0",
    "Möbel",
    "\u06a9\u062a\u0627\u0628\u200c\u062e\u0627\u0646\u0647",
    "👩\u200d🦽",
    "against_wall(bed[0], walls[2])",
    "0.62 m < 0.90 m",
]

ROOM = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5)


def furnished(name: str) -> tuple[Scene, Layout]:
    """A room in which scene, asset, category, description and body are all called so."""
    asset = Asset(f"{name}-0", name, (0.5, 0.5, 0.9), description=name)
    body = Agent(name=name, title=name, radius=0.2, height=1.0)
    return Scene(ROOM, (asset,), name, name, (body,), name), Layout({asset.name: Pose(1, 1, 0.45, 0)})


hostile = pytest.mark.parametrize("name", HOSTILE, ids=lambda name: ascii(name)[1:20])


@hostile
def test_a_terminal_gets_one_line_of_letters(name: str) -> None:
    line = printable(name)
    assert line.isprintable() and len(line) == len(name)


@pytest.mark.parametrize("text", HARMLESS)
def test_what_is_harmless_stays_as_it_is(text: str) -> None:
    assert printable(text) == markdown(text) == xml(text) == text


def test_directions_are_not_changed_but_letters_join() -> None:
    assert printable("\u202eb\u200c\u2066") == " b\u200c "


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("a|b", "a\\|b"),
        ("[x](y)", "[x\\](y)"),
        ("[x]: y", "[x\\]: y"),
        ("<b>", "\\<b>"),
        ("&amp;", "\\&amp;"),
        ("_x_ a_b *c*", "\\_x\\_ a_b \\*c\\*"),
        ("# x", "\\# x"),
        ("- x", "\\- x"),
        ("1. x", "1\\. x"),
        ("1.5 m", "1.5 m"),
        ("\\|", "\\\\\\|"),
        ("a\nb", "a b"),
    ],
)
def test_markdown_escapes_what_would_act(text: str, shown: str) -> None:
    assert markdown(text) == shown


@hostile
def test_file_names_stay_in_their_folder(name: str) -> None:
    stem = file_name(name)
    assert stem and not stem.startswith(".") and not set(stem) & set('/\\<>:"|?*\0\n')
    assert len(utf8(stem)) <= LONGEST_NAME and stem == file_name(stem) and stem.isprintable()


def test_file_names_of_usual_names_are_those_names() -> None:
    assert [file_name(name) for name in ("wheelchair", "my room", "桌子", "room-1.v2")] == [
        "wheelchair", "my room", "桌子", "room-1.v2"
    ]  # fmt: skip
    assert {file_name(name) for name in ("", "..", "...", " ", "-")} == {"_"}


@hostile
def test_reports_hold_one_row_for_an_asset_and_no_tags(name: str) -> None:
    report = verify(*furnished(name))
    text = report.to_markdown()
    assert utf8(text).decode() == text and "<script" not in text.replace("\\<script", "")
    rows = [line for line in text.splitlines() if line.endswith(("| yes |", "| **no** |"))]
    assert len(rows) == 1 and rows[0].replace("\\|", "").count("|") == 7
    assert [line for line in text.splitlines() if line.startswith("# ")] == [text.splitlines()[0]]


class Tags(HTMLParser):
    """Collects the tags of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.found.add(tag)


@hostile
def test_html_gets_no_tag_of_a_name(name: str) -> None:
    page = (
        paragraph(name) + table([name, name], [[name, name]]) + bullets([name], 1) + verify(*furnished(name)).to_html()
    )
    assert Tags(page).found <= {"p", "b", "table", "thead", "tbody", "tr", "th", "td", "ul", "li"}
    utf8(page).decode("utf-8")
    assert "\x1b" not in html(name) and "<" not in html(name) and '"' not in html(name)


@hostile
def test_drawings_and_simulator_files_are_read_back(name: str) -> None:
    scene, layout = furnished(name)
    agent = scene.agents[0]
    drawn = ElementTree.fromstring(plan_svg(scene, layout, agent=agent).encode())
    assert not [element for element in drawn.iter() if element.tag.endswith("script")]
    options = Options(agent=agent, routes={f"{name}-0": [(0.5, 0.5), (1.0, 0.5)]})
    for kind in ("mjcf", "urdf", "sdf"):
        found = EXPORTERS[kind].read(to_bytes(scene, layout, kind, options=options))  # type: ignore[misc]
        assert list(found.layout) == [xml(f"{name}-0")], kind


@hostile
def test_dxf_is_sound(name: str) -> None:
    scene, layout = furnished(name)
    data = to_bytes(scene, layout, "dxf", options=Options(routes={f"{name}-0": [(0.5, 0.5), (1.0, 0.5)]}))
    read: Any = ezdxf.read  # pyright: ignore
    plan = read(io.StringIO(data.decode("ascii").replace("\r\n", "\n")))
    assert plan.audit().errors == [] and len(plan.modelspace().query("INSERT")) == 1
    assert list(EXPORTERS["dxf"].read(data).layout) == [printable(f"{name}-0")]  # type: ignore[misc]


@hostile
def test_json_brings_every_name_back_whole(name: str) -> None:
    scene, layout = furnished(name)
    assert list(json.loads(to_bytes(scene, layout, "layout"))) == [f"{name}-0"]
    read, data = EXPORTERS["glb"].read, to_bytes(scene, layout, "glb")
    assert read is not None
    if any(char == "\x00" or "\ud800" <= char <= "\udfff" for char in name):
        with pytest.raises(LayoutError, match=r"this GLB file has (a null character|characters that are no text)"):
            read(data)  # no file that we read can bring such a name
    else:
        assert list(read(data).layout) == [f"{name}-0"]


ENDS = ("\x1b", "\x00", "\u202e", "\r")


def test_a_hostile_body_and_wish_go_through_a_whole_run(tmp_path: Path) -> None:
    name = "[/red]\x1b[31m | </script><script>alert(1)</script> \u202e../x"
    body = {"radius": 0.2, "height": 1.0}
    scene = {
        "task_description": name,
        "boundary": {"floor_vertices": [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], "wall_height": 2.5},
        "agent": [{"name": name, "title": name, **body}, {"name": "../../" + name, **body}],
        "assets": {
            "desk-0": {
                "category": name,
                "description": name,
                "onFloor": True,
                "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.7}},
            }
        },
    }
    file = tmp_path / "[red]\x1b[31m.json"
    file.write_text(json.dumps(scene))
    out = tmp_path / "out"
    for words in ((), ("--json",), ("--quiet",)):
        ran = run_command(
            "generate", file, "--out", out, "--export", "mjcf,urdf,sdf,dxf,usda,svg", "--starts", 1, *words
        )
        assert ran.code in (0, 1), ran
        printed = ran.out + ran.err
        assert not any(end in printed for end in ENDS) and ("--quiet" not in words or printed == "")
    written = {path.name for path in out.iterdir()}
    assert all(name.isprintable() for name in written) and {"plan.svg", "report.html", "run.json"} < written
    assert len([name for name in written if name.startswith("plan_2__.._[_red]")]) == 1
    for path in (path for path in out.rglob("*") if path.is_file()):
        data = path.read_bytes()
        if path.suffix in (".svg", ".xml", ".urdf", ".sdf"):
            assert not [e for e in ElementTree.fromstring(data).iter() if e.tag.endswith("script")]
        elif path.suffix == ".json":
            json.loads(data)
        elif path.suffix in (".md", ".html"):
            text = data.decode()
            assert "</script><script>alert" not in text and not any(end in text for end in ENDS)
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted([file.name, "out"])
    again = run_command("check", out / "scene.json", out / "layout.json", "--json")
    assert next(iter(json.loads(again.out)["agents"])) == name


def test_a_hostile_name_of_a_file_gives_a_folder_below(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    desk = {"onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.7}}}
    corners = [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]]
    room = {"boundary": {"floor_vertices": corners, "wall_height": 2.5}, "assets": {"desk-0": desk}}
    for name in ("...json", "a\nb.json"):
        Path(name).write_text(json.dumps(room))
        ran = run_command("generate", name, "--no-pictures", "--quiet")
        assert ran == Ran(0, "", ""), ran
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["_", "a b"]
