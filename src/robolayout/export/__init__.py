"""Files that simulators, viewers and drawing programs load: one format a file.

>>> from robolayout.export import EXPORTERS
>>> EXPORTERS["glb"].suffix
'.glb'

A new format is one file with one `Exporter` and one line below. A package outside registers its own under the entry
point group `robolayout.exporters`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from importlib.metadata import entry_points
from pathlib import Path
from types import MappingProxyType

from robolayout._errors import UnknownNameError
from robolayout._files import write_together
from robolayout._reading.plugins import loaded
from robolayout._text import file_name
from robolayout.export._exporter import LEAVES as LEAVES
from robolayout.export._exporter import Contents as Contents
from robolayout.export._exporter import Exporter as Exporter
from robolayout.export._exporter import Options as Options
from robolayout.export._mujoco import simulator as simulator
from robolayout.export.dxf import DXF
from robolayout.export.glb import GLB
from robolayout.export.handles import pull_open as pull_open
from robolayout.export.layout_json import LAYOUT_JSON
from robolayout.export.mjcf import MJCF
from robolayout.export.physics import Driven as Driven
from robolayout.export.physics import Settled as Settled
from robolayout.export.physics import drive as drive
from robolayout.export.physics import settle as settle
from robolayout.export.procthor import PROCTHOR
from robolayout.export.sceneeval import SCENEEVAL
from robolayout.export.sdf import SDF
from robolayout.export.urdf import URDF
from robolayout.export.usd import USDA, USDZ
from robolayout.scene import Layout, Scene, check_layout

EXPORTERS: Mapping[str, Exporter] = MappingProxyType(
    {exporter.name: exporter for exporter in (GLB, LAYOUT_JSON, SCENEEVAL, PROCTHOR, DXF, USDA, USDZ, MJCF, SDF, URDF)}
)
"""The formats of this package, by name."""

GROUP = "robolayout.exporters"  # entry point group under which other packages register formats


@cache
def exporters() -> Mapping[str, Exporter]:
    """Return all formats by name: those of this package, then those that other installed packages register."""
    points = sorted(entry_points(group=GROUP), key=lambda point: point.name)
    outside = (loaded(point, "Exporter", lambda found: isinstance(found, Exporter)) for point in points)
    found = {exporter.name: exporter for exporter in outside}
    return MappingProxyType({**found, **EXPORTERS})


def find_exporter(target: str | Path) -> Exporter:
    """Return the format of a name ("glb") or of a file's suffix ("out/room.glb"); the longest suffix that fits wins."""
    text = str(target)
    if text in EXPORTERS:  # without a look at what else is installed, which takes time
        return EXPORTERS[text]
    known = exporters()
    if text in known:
        return known[text]
    fitting = [exporter for exporter in known.values() if f".{Path(text).name}".lower().endswith(exporter.suffix)]
    if not fitting:
        raise UnknownNameError("export format", text, [*known, *(exporter.suffix for exporter in known.values())])
    return max(fitting, key=lambda exporter: len(exporter.suffix))


def to_bytes(
    scene: Scene, layout: Layout, name: str | Path, *, options: Options | None = None, partial: bool = False
) -> bytes:
    """Return a layout in one format, as the bytes that `export` would write."""
    exporter = find_exporter(name)
    check_layout(scene, layout, partial=partial)
    return exporter.write(scene, layout, options or Options())


def export(
    scene: Scene,
    layout: Layout,
    target: str | Path,
    *,
    folder: str | Path = ".",
    options: Options | None = None,
    partial: bool = False,
) -> Path:
    """Write a layout in the format that the target names.

    Args:
        target: A format ("usd") or suffix ("usda"), written as `<scene name><suffix>`; or a file, whose suffix says the format.
        partial: Whether assets without a pose may be left out; otherwise they are an error.

    Raises:
        UnknownNameError: The format is not known.
        LayoutError: The layout does not fit the scene.
        MissingExtraError: The format needs a dependency that is not installed.
        OutputError: The file cannot be written; nothing half-written is left.
    """
    return export_all(scene, layout, [target], folder=folder, options=options, partial=partial)[0]


def export_all(
    scene: Scene,
    layout: Layout,
    targets: Sequence[str | Path],
    *,
    folder: str | Path = ".",
    options: Options | None = None,
    partial: bool = False,
) -> list[Path]:
    """Write a layout in several formats (see `export`), and what they refer to beside them; nothing is written unless all can be made."""
    made: dict[Path, bytes] = {}
    further: dict[Path, bytes] = {}
    for target in targets:
        exporter = find_exporter(target)
        check_layout(scene, layout, partial=partial)
        data, beside = exporter.files(scene, layout, options or Options())
        word = str(target).removeprefix(".")
        is_format = word == exporter.name or (f".{word}" == exporter.suffix and "." not in word)
        path = Path(folder) / (f"{file_name(scene.name)}{exporter.suffix}" if is_format else target)
        made[path] = data
        further |= {path.parent / name: content for name, content in beside.items()}
    write_together({**further, **made})
    return list(made)
