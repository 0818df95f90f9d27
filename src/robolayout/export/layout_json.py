"""`layout.json` as the reference writes it: position and rotation in degrees by asset name (DESIGN section 3)."""

from __future__ import annotations

import math
from typing import cast

from robolayout._errors import LayoutError
from robolayout.export._exporter import Contents, Exporter, Options, dump_json, parse_json
from robolayout.scene import Layout, Pose, Scene


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the poses in the order of the scene's assets."""
    ordered = {asset.name: layout[asset.name] for asset in scene.assets if asset.name in layout}
    return dump_json(Layout(ordered).to_dict())


def read(data: bytes) -> Contents:
    """Return the poses in such a file."""
    poses: dict[str, Pose] = {}
    for name, entry in parse_json(data, "layout.json").items():
        try:
            fields = cast(dict[str, list[float]], entry)
            (x, y, z), (_, _, degrees) = fields["position"], fields["rotation"]
            poses[name] = Pose(float(x), float(y), float(z), math.radians(degrees))
        except (KeyError, TypeError, ValueError) as error:
            raise LayoutError(
                f"{name!r} in layout.json must be "
                '{"position": [x, y, z], "rotation": [0, 0, degrees]}, not '
                f"{str(entry)[:80]}."
            ) from error
    return Contents(Layout(poses))


LAYOUT_JSON = Exporter("layout", ".layout.json", "the reference's layout.json: poses by asset name", None, write, read)
