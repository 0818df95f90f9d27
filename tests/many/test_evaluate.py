"""Any folder of rooms: found whoever made them, measured as `generate` and the benchmarks measure them."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest
from benchmarks.measures import figures
from benchmarks.rooms import Crowd, crowd

import robolayout as rl
from robolayout import InputError
from robolayout.many import write_evaluation
from robolayout.scene import scene_to_dict
from robolayout.solve import solver_names
from running import Furnished, Ran

Command = Callable[..., Ran]


@pytest.fixture(scope="module")
def crowds(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, rl.Result]]:
    """A crowded room by every solver, as runs in one folder."""
    folder = tmp_path_factory.mktemp("solvers")
    data, program = crowd(Crowd(5, 0.25, 0))
    results = {name: rl.generate(rl.scene_from_dict(data), program=program, solver=name) for name in solver_names()}
    for name, result in results.items():
        rl.write_result(result, folder / name, pictures=False)
    return folder, results


@pytest.mark.slow
def test_every_solvers_layouts_have_the_figures_of_the_benchmarks(crowds: tuple[Path, dict[str, rl.Result]]) -> None:
    folder, results = crowds
    rows = {row["room"]: row for row in rl.evaluate(folder).rows}
    assert set(rows) == set(results) and len(rows) == 5
    for name, result in results.items():
        measured, row = figures(result.report), rows[name]
        row = {**row, "reachable_share": row["reachable_share_chairs_aside"]}
        same = {key: value for key, value in measured.items() if key in row}
        assert {key: row[key] for key in same} == pytest.approx(same, abs=1e-5), "poses in files are rounded to 1e-6"
        assert {
            "ok",
            "short",
            "exempt",
            "walkable_ratio",
            "statements_met_share",
            "door_clear",
        } <= measured.keys() & row.keys()
        assert row["SceneEval_NAV"] == result.report.metrics["SceneEval"]["NAV"]


def forms(folder: Path, result: rl.Result, asset_names: list[str]) -> list[str]:
    """Write one room in every form that is read, and return the names under which it is to be found."""
    scene, layout = json.dumps(scene_to_dict(result.scene)), json.dumps(result.layout.to_dict())
    files = {
        "run/scene.json": scene,
        "run/layout.json": layout,
        "beside.json": scene,
        "beside.layout.json": layout,
        "under.json": scene,
        "under_layout.json": layout,
        "below/room.json": scene,
        "below/room/layout.json": layout,
        "theirs/bedroom/layout.json": layout,
        "theirs/bedroom/other.json": "{}",
        "state/a.sceneeval.json": rl.export,
    }
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        if isinstance(text, str):
            (folder / name).write_text(text)
        else:
            rl.export(result.scene, result.layout, folder / name)
    return ["below/room", "beside", "run", "state/a", "theirs/bedroom", "under"]


@pytest.mark.slow
def test_every_form_of_a_room_is_found_and_measured_alike(furnished: Furnished, tmp_path: Path) -> None:
    scene = rl.load_scene(furnished.folder / "scene.json").with_agents(rl.load_agent("wheelchair"))
    layout = rl.load_layout(furnished.folder / "layout.json", scene)
    names = forms(tmp_path / "rooms", rl.judge(scene, layout), list(layout))  # type: ignore[arg-type]
    (tmp_path / "scenes").mkdir()
    (tmp_path / "scenes" / "bedroom.json").write_text(json.dumps(scene_to_dict(scene)))
    found = rl.evaluate(tmp_path / "rooms", scenes=tmp_path / "scenes", agent="wheelchair")
    assert [row["room"] for row in found.rows] == names and not found.skipped
    first, *others = found.rows
    for row in others:
        for key, value in row.items():
            if key not in ("room", "name") and "hash" not in key and row["room"] != "state/a":
                assert value == first[key], (row["room"], key)
    state = next(row for row in found.rows if row["room"] == "state/a")
    for key in ("things", "area", "doors", "windows", "ok", "walkable_ratio", "collision_free_share", "SceneEval_NAV"):
        assert state[key] == pytest.approx(first[key], abs=1e-6), key


@pytest.mark.slow
def test_a_state_without_sizes_asks_for_the_folder_of_assets(furnished: Furnished, tmp_path: Path) -> None:
    scene = rl.load_scene(furnished.folder / "scene.json")
    layout = rl.load_layout(furnished.folder / "layout.json", scene)
    path = rl.export(scene, layout, tmp_path / "rooms" / "a.sceneeval.json")
    state = json.loads(path.read_text())
    for thing in state["scene"]["object"]:
        del thing["metadata"]
    path.write_text(json.dumps(state))
    found = rl.evaluate(tmp_path / "rooms")
    assert (
        not found.rows and "has no size in its metadata; name the folder of assets (--asset-dir)" in found.skipped["a"]
    )
    (row,) = rl.evaluate(tmp_path / "rooms", asset_dir=tmp_path / "rooms" / "sceneeval").rows
    assert row["collision_free_share"] == 1.0 and row["things"] == len(scene.assets)
    for text, said in (
        ('{"format": "sceneState"}', "has another form than scene@1.0.2"),
        ('{"format": "sceneState", "scene": {"arch": {"elements": []}}}', "has 0 floors; one room at a time"),
    ):
        path.write_text(text)
        assert said in rl.evaluate(tmp_path / "rooms").skipped["a"]


@pytest.mark.slow
def test_two_folders_are_paired_by_name(crowds: tuple[Path, dict[str, rl.Result]], tmp_path: Path) -> None:
    folder, results = crowds
    best = results["default"]
    for name in results:
        rl.write_result(best, tmp_path / "mine" / name, pictures=False)
    rl.write_result(best, tmp_path / "mine" / "more", pictures=False)
    found = rl.evaluate(tmp_path / "mine", against=folder)
    assert found.unpaired == ("more",)
    pair = found.against["collision_free_share"]
    apart = [1.0 - result.report.figures["collision_free_share"] for result in results.values()]
    assert pair.difference.mean == pytest.approx(sum(apart) / 5) and pair.difference.count == 5
    assert (pair.better, pair.worse) == (sum(value > 0 for value in apart), 0)
    assert pair.chance == pytest.approx(2.0 ** (1 - pair.better) if pair.better else 1.0)
    less = found.against["violations"]
    assert less.difference.mean <= 0.0 and less.worse == 0, "fewer violations are better"
    assert (
        "| collision_free_share |" in found.to_markdown() and "Only in one of the folders: more." in found.to_markdown()
    )
    assert rl.evaluate(tmp_path / "mine", workers=2).rows == rl.evaluate(tmp_path / "mine").rows


@pytest.mark.slow
def test_what_is_written(crowds: tuple[Path, dict[str, rl.Result]], tmp_path: Path) -> None:
    found = rl.evaluate(crowds[0], against=crowds[0])
    files = write_evaluation(found, tmp_path / "out")
    assert {path.name for path in files} == {
        "rooms.csv", "rooms.parquet", "figures.csv", "figures.parquet", "report.md", "index.html"
    }  # fmt: skip
    sums = pyarrow.parquet.read_table(tmp_path / "out" / "figures.parquet").to_pylist()
    (row,) = [one for one in sums if (one["group"], one["figure"]) == ("all", "placed_share")]
    assert row["count"] == 5 and row["low"] <= row["mean"] <= row["high"]
    assert all(math.isclose(one["mean"], 0.0) for one in sums if one["group"] == "against")
    page = (tmp_path / "out" / "index.html").read_text()
    assert page.count("data:image/png;base64,") == 1 and "<script>alert" not in page


def test_names_of_rooms_run_nothing_in_the_page() -> None:
    from robolayout.many.index import page

    text = page("<b>", [{"room": "</script><script>alert(1)</script>", "ok": True}])
    assert "alert(1)</script>" not in text and "<b>" not in text and "default-src 'none'" in text


@pytest.mark.slow
def test_groups_are_those_of_a_batch(tmp_path: Path) -> None:
    from tiny_sets import tiny_spec

    rl.batch(tiny_spec(tmp_path, 2, bodies=["adult", "cat"], seed=3), tmp_path / "set")
    found = rl.evaluate(tmp_path / "set", by=["bodies"])
    assert set(found.groups) == {"all", "bodies adult", "bodies cat"}
    assert sum(part["ok"].count for name, part in found.groups.items() if name != "all") == 4
    with pytest.raises(InputError, match="no room has 'solvr' to group by; there is room, "):
        rl.evaluate(tmp_path / "set", by=["solvr"])


@pytest.mark.parametrize(
    ("made", "said"),
    [([], "holds no room"), (None, "is no folder"), (["a.json"], "name the folder of the scene files")],
)
def test_a_folder_without_rooms_is_refused(tmp_path: Path, made: Any, said: str) -> None:
    folder = tmp_path / "rooms"
    if made is not None:
        folder.mkdir()
    for name in made or ():
        (folder / name).write_text("{}")
    with pytest.raises(InputError, match=said):
        rl.evaluate(folder)


@pytest.mark.slow
def test_the_command(crowds: tuple[Path, dict[str, rl.Result]], command: Command, tmp_path: Path) -> None:
    ran = command("evaluate", crowds[0], "--out", tmp_path / "out")
    assert (
        ran.code == 0 and ran.out.startswith("| figure | all (5) |") and str(tmp_path / "out" / "rooms.csv") in ran.out
    )
    (tmp_path / "rooms" / "bad").mkdir(parents=True)
    for name in ("scene.json", "layout.json"):
        (tmp_path / "rooms" / "bad" / name).write_text("{")
    ran = command("evaluate", tmp_path / "rooms", "--json")
    assert ran.code == 1 and list(json.loads(ran.out)["skipped"]) == ["bad"] and "bad was not read" in ran.err
