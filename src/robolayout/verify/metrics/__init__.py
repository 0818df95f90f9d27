"""Published metrics under their own names and rules, so that results compare."""

from robolayout.scene import Layout, Scene
from robolayout.verify.metrics.layoutvlm import layoutvlm
from robolayout.verify.metrics.physcene import PhyScene, physcene
from robolayout.verify.metrics.sceneeval import SceneEval, sceneeval
from robolayout.verify.metrics.scenesmith import SceneSmith, scenesmith

__all__ = [
    "PhyScene",
    "SceneEval",
    "SceneSmith",
    "layoutvlm",
    "physcene",
    "published_metrics",
    "sceneeval",
    "scenesmith",
]


def published_metrics(scene: Scene, layout: Layout) -> dict[str, dict[str, object]]:
    """Return all published metrics by their benchmark; they see only the placed assets."""
    return {
        "SceneEval": dict(sceneeval(scene, layout).to_dict()),
        "PhyScene": dict(physcene(scene, layout).to_dict()),
        "LayoutVLM": dict(layoutvlm(scene, layout)),
        "SceneSmith": scenesmith(scene, layout).to_dict(),
    }
