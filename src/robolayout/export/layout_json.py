"""`layout.json` as the reference writes it: position and rotation in degrees by asset name (DESIGN section 3)."""

from __future__ import annotations

from robolayout._reading.syntax import decoded, json_value
from robolayout.export._exporter import Exporter, Options, Rows, dump_json, placed, reader
from robolayout.scene import Layout, Scene, layout_from_dict


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the poses in the order of the scene's assets."""
    return dump_json(Layout({asset.name: pose for asset, pose in placed(scene, layout)}).to_dict())


@reader("layout.json")
def read(data: bytes) -> Rows:
    """Yield the names and poses in such a file."""
    for name, pose in layout_from_dict(json_value(decoded(data))).items():
        yield name, pose, ()


LAYOUT_JSON = Exporter("layout", ".layout.json", "the reference's layout.json: poses by asset name", None, write, read)
