"""Runs SceneEval's own code on scene states; Blender's Python interpreter runs this file, with SceneEval on its path.

    python sceneeval_judge.py FOLDER OUT.json STATE.json ...

FOLDER holds the meshes. SceneEval asks a model of vision and language how each thing is held; here the parent of the thing
in the state says it.
"""

# ruff: noqa: E402
from __future__ import annotations

import json
import sys
import types
from pathlib import Path
from unittest.mock import MagicMock

for _module in ("cv2", "openai", "dotenv", "vlm", "matplotlib", "matplotlib.pyplot", "natsort", "hydra"):
    sys.modules.setdefault(_module, MagicMock())  # what it imports for its other metrics

import numpy as np
from assets.base import DatasetConfig  # type: ignore[import-not-found]
from metrics.collision import CollisionMetric, CollisionMetricConfig  # type: ignore[import-not-found]
from metrics.support import SupportMetric, SupportMetricConfig  # type: ignore[import-not-found]
from scenes import BlenderConfig, Scene, SceneConfig, SceneState, TrimeshConfig  # type: ignore[import-not-found]

from assets import Retriever  # type: ignore[import-not-found]


class Held:
    """Says how things are held, in the order in which it is asked."""

    def __init__(self, kinds: list[str]) -> None:
        self.kinds = iter(kinds)

    def reset(self) -> None:
        """Forget nothing."""

    def send(self, *_: object, **__: object) -> object:
        """Return how the next thing is held."""
        return types.SimpleNamespace(support_type=next(self.kinds))


def judged(path: Path, meshes: Path) -> dict[str, object]:
    """Return what SceneEval makes of a state: boxes of its two worlds, what meets and what is held."""
    state = SceneState(path)
    retriever = Retriever({"layoutvlm_objathor": DatasetConfig("robolayout", str(meshes), "")})
    blender = BlenderConfig(suppress_warning=True, render_engine="BLENDER_EEVEE")
    scene = Scene(retriever, state, SceneConfig(), blender, TrimeshConfig(), path.parent)
    ids = {f"idx{obj.index}_{obj.model_id}": obj.id for obj in state.objs}
    worlds = {
        "trimesh": {ids[name]: mesh.bounds.tolist() for name, mesh in scene.t_objs.items()},
        "blender": {
            ids[name]: [np.array([b.matrix_world @ v.co for v in b.data.vertices]).min(axis=0).tolist(),
                        np.array([b.matrix_world @ v.co for v in b.data.vertices]).max(axis=0).tolist()]
            for name, b in scene.b_objs.items()
        },
    }  # fmt: skip
    hits = CollisionMetric(scene, CollisionMetricConfig()).run().data["collision_results"]
    kinds = [
        "wall" if "|wall|" in o.parentId else "ceiling" if "ceiling" in o.parentId else "ground" for o in state.objs
    ]
    scene.get_obj_render_path = lambda *_: ""
    held = SupportMetric(scene, Held(kinds), SupportMetricConfig()).run().data
    return {
        **worlds,
        "collisions": {ids[name]: [ids[o] for o in hit["colliding_with"]] for name, hit in hits.items()},
        "supported": {ids[name]: bool(row["supported"]) for name, row in held.items()},
    }


if __name__ == "__main__":
    folder, out, *states = map(Path, sys.argv[1:])
    out.write_text(json.dumps({path.name: judged(path, folder) for path in states}))
