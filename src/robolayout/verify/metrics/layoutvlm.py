"""LayoutVLM's physical metrics: CF and IB, in percent.

The exact tolerance of the published CF is not known; ours is the one of DESIGN section 4 (1e-4 m2 in plan and 1 cm in height,
rugs aside), and IB grows the room by 1 cm. Positions and rotations are judged by a language model there and left out here.
"""

from __future__ import annotations

from robolayout.scene import Layout, Scene
from robolayout.verify._boxes import share
from robolayout.verify.physics import physics


def layoutvlm(scene: Scene, layout: Layout) -> dict[str, float]:
    """Return CF and IB over the placed assets, in percent."""
    judged = physics(scene, layout)
    there = [name for name, placed in judged.placed.items() if placed]
    return {
        "CF": 100 * share([judged.boxes_apart[name] for name in there]),
        "IB": 100 * share([judged.in_boundary[name] for name in there]),
    }
