"""Published metrics under their own names and rules, so that results compare."""

from robolayout.scene import Layout, Scene
from robolayout.verify._boxes import share
from robolayout.verify.metrics.physcene import physcene as physcene
from robolayout.verify.metrics.sceneeval import sceneeval as sceneeval
from robolayout.verify.metrics.scenesmith import scenesmith as scenesmith
from robolayout.verify.physics import physics

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
        "SceneEval": dict(sceneeval(scene, layout)),
        "PhyScene": dict(physcene(scene, layout)),
        "LayoutVLM": dict(layoutvlm(scene, layout)),
        "SceneSmith": scenesmith(scene, layout),
    }
    rugs = {asset.name for asset in scene.assets if asset.is_flat} & set(layout)
    if rugs:
        bare = Layout({name: pose for name, pose in layout.items() if name not in rugs})
        again = {"SceneEval": sceneeval(scene, bare), "PhyScene": physcene(scene, bare)}
        for benchmark, names in AS_OBSTACLES.items():
            found[benchmark]["rugs"] = f"count as obstacles in {', '.join(names)}, as published"
            found[f"{benchmark}_without_rugs"] = {name: again[benchmark][name] for name in names}
    return found


def layoutvlm(scene: Scene, layout: Layout) -> dict[str, float]:
    """Return LayoutVLM's CF and IB over the placed assets, in percent.

    The exact tolerance of the published CF is not known; ours is the one of DESIGN section 4 (1e-4 m2 in plan and 1 cm in
    height, rugs aside), and IB grows the room by 1 cm. Positions and rotations are judged by a language model there and left out.
    """
    judged = physics(scene, layout)
    there = [name for name, placed in judged.placed.items() if placed]
    return {
        "CF": 100 * share([judged.boxes_apart[name] for name in there]),
        "IB": 100 * share([judged.in_boundary[name] for name in there]),
    }
