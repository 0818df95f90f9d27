"""Digests: the same for the same content, whatever the order and the folder; another for other content."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from pathlib import Path

from robolayout.scene import (
    Layout,
    Pose,
    layout_digest,
    layout_from_dict,
    load_scene,
    scene_digest,
    scene_from_dict,
    scene_to_dict,
)

BEDROOM = Path(__file__).parents[2] / "examples" / "bedroom.json"


def test_a_layout_has_the_digest_of_its_file():
    layout = Layout({"b-0": Pose(1.0, 2.0, 0.5, 0.3), "a-0": Pose(0.1, 0.2, 0.3, 0.0)})
    text = json.dumps(layout.to_dict(), sort_keys=True, separators=(",", ":"))
    assert layout_digest(layout) == hashlib.sha256(text.encode("ascii")).hexdigest()
    assert layout_digest(layout_from_dict(json.loads(json.dumps(layout.to_dict())))) == layout_digest(layout)
    assert layout_digest(Layout({"b-0": Pose(1.0, 2.001, 0.5, 0.3)})) != layout_digest(layout)


def test_a_scene_keeps_its_digest_through_its_file():
    scene = load_scene(BEDROOM)
    again = scene_from_dict(json.loads(json.dumps(scene_to_dict(scene))))
    assert scene_digest(again) == scene_digest(scene)
    assert scene_digest(replace(scene, assets=scene.assets[::-1])) == scene_digest(scene)
    assert scene_digest(replace(scene, assets=scene.assets[1:])) != scene_digest(scene)
    assert scene_digest(replace(scene, agents=(replace(scene.agent, radius=0.31),))) != scene_digest(scene)


def test_the_folder_of_a_mesh_does_not_count():
    scene = load_scene(BEDROOM)
    here, there, other = (
        replace(scene, assets=(replace(scene.assets[0], path=Path(path)), *scene.assets[1:]))
        for path in ("/a/x.glb", "/b/c/x.glb", "/a/y.glb")
    )
    assert scene_digest(here) == scene_digest(there) != scene_digest(other)
    assert scene_digest(here) != scene_digest(scene)


def test_odd_names_have_digests_too():
    assert layout_digest(Layout({"桌\udc80-0": Pose(float("nan"), 0, 0, 0)}))
