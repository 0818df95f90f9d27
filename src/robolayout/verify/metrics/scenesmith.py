"""SceneSmith's reachability: is the floor of one piece for a disc 0.3 m wide, and which furniture cuts it?

The floor is always the rectangle around the room, and neither doors nor targets play a part, as published. Furniture is what
stands on the floor, rugs aside.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout.scene import Layout, Scene
from robolayout.verify._boxes import boxes
from robolayout.verify._space import components

WIDTH = 0.3  # metres


def scenesmith(scene: Scene, layout: Layout) -> dict[str, object]:
    """Return pieces of free floor, the area of the largest over all (0 if there is none), and furniture without which there are fewer."""
    found = boxes(scene, layout)
    rows = np.flatnonzero(found.placed & ~found.flat & (found.bottom <= 0.02))
    floor = shapely.box(*scene.room.bounds).buffer(-WIDTH / 2)
    grown = shapely.buffer(found.footprints[rows], WIDTH / 2)
    pieces = _pieces(floor, grown)
    areas = shapely.area(pieces)
    suspects = enumerate(rows) if len(pieces) > 1 else ()
    blocking = [found.names[row] for i, row in suspects if len(_pieces(floor, np.delete(grown, i))) < len(pieces)]
    ratio = float(areas.max() / areas.sum()) if len(areas) else 0.0
    return {"regions": len(pieces), "reachability_ratio": ratio, "blocking": blocking}


def _pieces(floor: BaseGeometry, grown: NDArray[np.object_]) -> NDArray[np.object_]:
    return components(floor.difference(shapely.union_all(grown)))
