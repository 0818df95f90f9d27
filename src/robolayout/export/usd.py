"""USD: what Isaac, Omniverse and other USD tools load; text (.usda) or one package (.usdz).

Z up, metres, kilograms. The room's layer says where everything is; each kind of thing is a layer of its own beside it,
`things/<kind>.usdc`, shared by all rooms of a folder. Every part is a mesh and its own convex collider; no rigid body is nested in another.
"""

from __future__ import annotations

import io
import tempfile
import zipfile
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from robolayout._errors import LayoutError, MissingExtraError
from robolayout.export._exporter import Bundle, Exporter, Options, Rows, reader
from robolayout.scene import Layout, Scene

EXTRA = "usd"
ALIGNMENT = 64  # bytes to which the files in a USDZ package are aligned, as its specification demands


def _stages() -> Any:
    """Return the module that builds stages; MissingExtraError unless USD's own library is installed."""
    if find_spec("pxr") is None:
        raise MissingExtraError("reading and writing USD", EXTRA)
    return import_module("robolayout.export._usd_stage")


def make_text(scene: Scene, layout: Layout, options: Options) -> Bundle:
    """Return the layer of the room as USD text, and those of each kind of thing and their textures, by path."""
    stage, files = _stages().room_stage(scene, layout, options)  # its layers live as long as it
    return stage.GetRootLayer().ExportToString().encode(), files


def write_package(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the scene as a USDZ package: the room's layer, then what it refers to; uncompressed, aligned, with a fixed date."""
    stage, layers = _stages().room_stage(scene, layout, options)
    files = {"scene.usdc": _stages().binary(stage), **layers}
    package = io.BytesIO()
    with zipfile.ZipFile(package, "w", zipfile.ZIP_STORED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
            padding = -(package.tell() + 30 + len(entry.filename)) % ALIGNMENT
            padding += ALIGNMENT if padding < 4 else 0
            entry.extra = b"\x86\x19" + (padding - 4).to_bytes(2, "little") + bytes(padding - 4)
            archive.writestr(entry, data)
    return package.getvalue()


@reader("USD file")
def read(data: bytes) -> Rows:
    """Yield the names, poses and sizes in USD text or a USDZ package that this package wrote."""
    stages = _stages()
    suffix = "usdz" if data[:2] == b"PK" else "usda"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"scene.{suffix}"
        path.write_bytes(data)
        try:
            yield from stages.assets_of(path)
        except RuntimeError as error:
            raise LayoutError(f"this {suffix} file cannot be opened: {error}.") from error


SUMMARY = "USD with one file per kind of thing: instances, joints, rigid bodies, labels"
USDA = Exporter("usd", ".usda", SUMMARY, EXTRA, make_text, read)
USDZ = Exporter("usdz", ".usdz", "the same USD scene as one package", EXTRA, write_package, read)
