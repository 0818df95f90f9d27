"""Published metrics under their own names and rules, so that results compare."""

from robolayout.scene import Layout, Scene
from robolayout.verify.metrics.layoutvlm import layoutvlm as layoutvlm
from robolayout.verify.metrics.physcene import physcene as physcene
from robolayout.verify.metrics.sceneeval import sceneeval as sceneeval
from robolayout.verify.metrics.scenesmith import scenesmith as scenesmith

AS_OBSTACLES = {
    "SceneEval": ("COL", "COL_scene", "NAV", "ACC", "opening_clearance"),
    "PhyScene": ("Col_obj", "Col_scene", "R_walkable", "R_reach"),
}
"""Figures in which a rug is an object like any other, as published: it collides with what stands on it and bars the way."""


def published_metrics(scene: Scene, layout: Layout) -> dict[str, dict[str, object]]:
    """Return all published metrics by their benchmark; they see only the placed assets.

    Where rugs lie in the room, the benchmarks that count them as obstacles say so (`rugs`), and those figures are given again
    without the rugs, under `<benchmark>_without_rugs`.
    """
    found: dict[str, dict[str, object]] = {
        "SceneEval": dict(sceneeval(scene, layout).to_dict()),
        "PhyScene": dict[str, object](physcene(scene, layout)),
        "LayoutVLM": dict(layoutvlm(scene, layout)),
        "SceneSmith": scenesmith(scene, layout),
    }
    rugs = {asset.name for asset in scene.assets if asset.is_flat} & set(layout)
    if rugs:
        bare = Layout({name: pose for name, pose in layout.items() if name not in rugs})
        again = {"SceneEval": sceneeval(scene, bare).to_dict(), "PhyScene": physcene(scene, bare)}
        for benchmark, names in AS_OBSTACLES.items():
            found[benchmark]["rugs"] = f"count as obstacles in {', '.join(names)}, as published"
            found[f"{benchmark}_without_rugs"] = {name: again[benchmark][name] for name in names}
    return found
