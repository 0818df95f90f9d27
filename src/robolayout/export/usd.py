"""USD: what Isaac, Omniverse and other USD tools load; text (.usda) or one package (.usdz).

Z up, metres, kilograms. `/World/Room` is static; `/World/Assets/<name>` has one mesh for each part, which is its own
convex collider. Movable assets are rigid bodies with a mass; none is nested in another.
"""

from __future__ import annotations

import io
import math
import tempfile
import zipfile
from importlib.util import find_spec
from pathlib import Path

from robolayout._errors import LayoutError, MissingExtraError
from robolayout.export._exporter import Contents, Exporter, Options, reader
from robolayout.scene import Layout, Pose, Scene

EXTRA = "usd"
ALIGNMENT = 64
"""Bytes to which the files in a USDZ package are aligned, as its specification demands."""


def _require() -> None:
    """Raise MissingExtraError unless USD's own library is installed."""
    if find_spec("pxr") is None:
        raise MissingExtraError("reading and writing USD", EXTRA)


def write_text(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the scene as USD text."""
    _require()
    from robolayout.export._usd_stage import build

    stage = build(scene, layout, options)
    return stage.GetRootLayer().ExportToString().encode()


def write_package(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the scene as a USDZ package: a binary layer, then its textures; uncompressed, aligned, with a fixed date."""
    _require()
    from robolayout.export._usd_stage import build

    with tempfile.TemporaryDirectory() as folder:
        path, pictures = Path(folder) / "scene.usdc", dict[str, bytes]()
        stage = build(scene, layout, options, pictures)
        stage.GetRootLayer().Export(str(path))
        content = path.read_bytes()
    package = io.BytesIO()
    with zipfile.ZipFile(package, "w", zipfile.ZIP_STORED) as archive:
        for name, data in {"scene.usdc": content, **dict(sorted(pictures.items()))}.items():
            entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
            padding = -(package.tell() + 30 + len(entry.filename)) % ALIGNMENT
            padding += ALIGNMENT if padding < 4 else 0
            entry.extra = b"\x86\x19" + (padding - 4).to_bytes(2, "little") + bytes(padding - 4)
            archive.writestr(entry, data)
    return package.getvalue()


@reader("USD file")
def read(data: bytes) -> Contents:
    """Return the names, poses and sizes in USD text or a USDZ package that this package wrote.

    Raises:
        LayoutError: USD's own library cannot open the bytes.
    """
    _require()
    from robolayout.export._usd_stage import assets_of

    suffix = "usdz" if data[:2] == b"PK" else "usda"
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"scene.{suffix}"
        path.write_bytes(data)
        try:
            rows = assets_of(path)
        except RuntimeError as error:
            raise LayoutError(f"this {suffix} file cannot be opened: {error}.") from error
    poses = {name: Pose(x, y, z, math.radians(degrees)) for name, (x, y, z), degrees, _ in rows}
    return Contents(Layout(poses), {name: size for name, _, _, size in rows})


USDA = Exporter("usd", ".usda", "USD text with colliders, rigid bodies, masses and labels", EXTRA, write_text, read)
USDZ = Exporter("usdz", ".usdz", "the same USD scene as one package", EXTRA, write_package, read)
