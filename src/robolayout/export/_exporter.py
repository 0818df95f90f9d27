"""What an exporter is: one file format, one entry, pure functions from a scene and a layout to bytes and back."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import wraps
from importlib.resources import files

import numpy as np

from robolayout._errors import LayoutError
from robolayout._reading import LIMITS, Unreadable
from robolayout._reading.syntax import ASTRAY
from robolayout._text import pretty, utf8
from robolayout.assets import Part, category_of
from robolayout.constraints import hangs
from robolayout.scene import Agent, Asset, Layout, Point, Pose, Scene

Routes = Mapping[str, Sequence[Point]]
"""The polyline in metres that the agent's centre follows to each asset, by asset name."""

Json = dict[str, object]
Bundle = tuple[bytes, Mapping[str, bytes]]

LEAVES = ("swinging", "open", "shut")
"""How doors of a room stand in a simulator: as in the scene and free to turn, or fixed, open or shut."""


@dataclass(frozen=True)
class Options:
    """What may go into a file beside the scene and the layout."""

    agent: Agent | None = None  # the body whose base is added where the format can hold one (MJCF); None leaves it out
    whole: bool = False  # whether the whole model of that body is added to its base, if it was read from one (MJCF)
    leaves: str = "swinging"  # how the doors of the room stand in a simulator (MJCF): one of `LEAVES`
    # routes of that agent, kept as metadata or lines where the format has a place
    routes: Routes = field(default_factory=dict[str, Sequence[Point]])
    seed: int = 0  # seed of the parametric meshes
    start: Pose | None = None  # where that agent starts; None for inside the first door
    left_out: tuple[str, ...] = ()  # names of things that the scene had, for which the format has none


@dataclass(frozen=True)
class Contents:
    """What a written file says about the assets."""

    layout: Layout  # poses by asset name
    # box sizes (depth, width, height) in metres by asset name; empty where the format has no place for them
    sizes: Mapping[str, tuple[float, float, float]] = field(default_factory=dict[str, tuple[float, float, float]])


Read = Callable[[bytes], Contents]  # what reads a file's content back

Rows = Iterable[tuple[str, Pose, Iterable[float]]]
"""Names, poses and sizes of assets; nothing for a size that a format has no place for."""


@dataclass(frozen=True)
class Exporter:
    """One file format."""

    name: str  # what people ask for ("glb")
    suffix: str  # end of the file's name, by which the format is recognised (".glb")
    summary: str  # one line for the table of formats
    extra: str | None  # the optional dependency it needs; None for none
    # the file's content for a scene, a layout and options; with the files that it refers to, by their paths from its folder
    make: Callable[[Scene, Layout, Options], bytes | Bundle]
    read: Read | None = None  # reads such content back; None where the format cannot say where things are
    # The room with the things that its readers have; the command line solves that again. None where ours are theirs.
    fit: Callable[[Scene, Layout], tuple[Scene, Layout]] | None = None

    def files(self, scene: Scene, layout: Layout, options: Options) -> Bundle:
        """Return the file's content, and the files that it refers to."""
        made = self.make(scene, layout, options)
        return made if isinstance(made, tuple) else (made, {})

    def write(self, scene: Scene, layout: Layout, options: Options) -> bytes:
        """Return the file's content alone."""
        return self.files(scene, layout, options)[0]


def placed(scene: Scene, layout: Layout) -> tuple[tuple[Asset, Pose], ...]:
    """Return every asset that has a pose, with it, in the order of the scene."""
    return tuple((asset, layout[asset.name]) for asset in scene.assets if asset.name in layout)


def is_movable(asset: Asset, scene: Scene, layout: Layout) -> bool:
    """Return whether an asset may be pushed around: of a movable category, not fixed to the room, and no rug."""
    return category_of(asset).movable and not asset.is_flat and not hangs(asset, scene, layout)


def free_name(word: str, scene: Scene) -> str:
    """Return a name for something of our own ("room") that no asset has, nor the parts of one."""
    while any(asset.name == word or asset.name.startswith(f"{word}/") for asset in scene.assets):
        word += "_"
    return word


def unique(stem: str, taken: set[str], gap: str = "_") -> str:
    """Return a name that is not taken yet, and take it: the stem, or the stem and a number."""
    found, number = stem, 2
    while found in taken:
        found, number = f"{stem}{gap}{number}", number + 1
    taken.add(found)
    return found


def facts(asset: Asset, *, movable: bool) -> Json:
    """Return what a file says about an asset beside its pose and shape."""
    return {
        "name": asset.name,
        "category": asset.category,
        "description": asset.description,
        "size": list(asset.size),
        "movable": movable,
    }


def kind_name(name: str, pieces: Sequence[Part], *facts: object) -> str:
    """Return the name of a file for all things that are alike: what they are, and a digest of their parts and of further facts."""
    whole = hashlib.sha256(repr(facts).encode())
    for part in pieces:
        whole.update(repr((part.name, part.convex, part.joint, part.material)).encode())
        for array in (part.vertices, part.faces, part.uv):
            whole.update(b"" if array is None else np.ascontiguousarray(array).tobytes())
    stem = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_") or "thing"
    return f"{stem[:60]}-{whole.hexdigest()[:12]}"


def data_file(name: str) -> str:
    """Return the text of a file that formats are made from."""
    return files("robolayout.export").joinpath("data", name).read_text(encoding="utf-8")


def dump_json(content: object) -> bytes:
    """Return JSON text, indented, with a newline at its end; numbers keep every digit."""
    return utf8(pretty(content))


def reader(what: str) -> Callable[[Callable[[bytes], Rows]], Read]:
    """Return a decorator for what yields the rows of a format: whatever it cannot read is one sentence about `what`."""

    def decorate(rows: Callable[[bytes], Rows]) -> Read:
        @wraps(rows)
        def read(data: bytes) -> Contents:
            if len(data) > LIMITS.mesh_bytes:
                raise LayoutError(
                    f"this {what} is larger than {LIMITS.mesh_bytes // 1_000_000} MB; export fewer things."
                )
            try:
                found = [(name, pose, tuple(map(float, size))) for name, pose, size in rows(data)]
                layout = Layout({name: pose for name, pose, _ in found})
                sizes = {name: (d, w, h) for name, _, size in found if size for d, w, h in [size]}
                astray = [name for name, pose in layout.items() if not pose.is_finite]
            except Unreadable as error:
                raise LayoutError(f"this {what} {error}. Was the file written to its end?") from error
            except ASTRAY as error:
                text = " ".join(f"{type(error).__name__} {error}".split())[:80]
                raise LayoutError(
                    f"this {what} is none that robolayout wrote ({text}); export the layout again."
                ) from error
            if astray:
                raise LayoutError(
                    f"this {what} gives {astray[0]!r} a pose that is not finite; export the layout again."
                )
            return Contents(layout, sizes)

        return read

    return decorate


def mass(asset: Asset) -> float:
    """Return a plausible mass in kilograms: that of its category, scaled with its box, by no more than a factor of 4."""
    category = category_of(asset)
    typical = category.size[0] * category.size[1] * category.size[2]
    scale = asset.size[0] * asset.size[1] * asset.size[2] / typical
    return category.mass * min(max(scale, 0.25), 4.0)
