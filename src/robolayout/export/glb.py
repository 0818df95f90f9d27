"""GLB (glTF 2.0 binary): what viewers, game engines and Habitat-style simulators load.

One node per asset with its name, pose and facts ("extras"), one child mesh per material. glTF is y up, so the root
turns the whole scene by -90 degrees about x; below it everything keeps this package's frame (z up, metres, box
centres).
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import cast

import numpy as np
from numpy.typing import NDArray

from robolayout._reading.syntax import Unreadable, decoded, json_value
from robolayout._text import utf8
from robolayout._version import __version__
from robolayout.assets import Material, Part, category_of, room_parts
from robolayout.assets.textures import media_type, picture
from robolayout.export._exporter import Exporter, Json, Options, Rows, facts, is_movable, placed, reader
from robolayout.export._mesh import DrawnSurface, base_color, linear, merged
from robolayout.export._rugs import laid_parts
from robolayout.export._scenery import SCENERY, lamp, overview
from robolayout.scene import Asset, Layout, Pose, Room, Scene

MAGIC = b"glTF"
LISTS = (
    "nodes", "meshes", "materials", "textures", "images", "samplers", "cameras", "accessors", "bufferViews", "buffers",
)  # fmt: skip

FLOAT, UINT32 = 5126, 5125
VERTICES, INDICES = 34962, 34963
REPEAT: Json = {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}
"""How all textures are looked up: smoothly, and again and again."""
LIGHTS = "KHR_lights_punctual"
BULB: Json = {"type": "point", "color": list(SCENERY.warm), "intensity": round(SCENERY.lumens / (4 * math.pi), 3)}
"""The light of every lamp, in candela."""


class _Builder:
    """Collects the lists of a document and its binary data; equal meshes, materials and textures are stored once."""

    def __init__(self) -> None:
        self.lists: dict[str, list[Json]] = {name: [] for name in LISTS}
        self.blob = bytearray()
        self._known: dict[object, int] = {}

    def add(self, kind: str, entry: Json) -> int:
        """Add an entry to a list; return its index."""
        self.lists[kind].append(entry)
        return len(self.lists[kind]) - 1

    def _once(self, kind: str, key: object, make: Callable[[], Json]) -> int:
        """Return the index of what is known by a key, which is made and added if it is not there yet."""
        if key not in self._known:
            self._known[key] = self.add(kind, make())
        return self._known[key]

    def object(self, name: str, pieces: tuple[Part, ...], **content: object) -> int:
        """Add a node with one child mesh per material, and a light if it is a lamp; return its index."""
        children: list[int] = []
        for look, closed, shape in merged(pieces):
            if len(shape.indices):
                own = f"{name}.{look.name}"
                children.append(self.add("nodes", {"name": own, "mesh": self._mesh(own, look, closed, shape)}))
        if (bulb := lamp(pieces)) is not None:
            light: Json = {"name": f"{name}.light", "translation": list(bulb)}
            children.append(self.add("nodes", {**light, "extensions": {LIGHTS: {"light": 0}}}))
        return self.add("nodes", {"name": name, **content, **({"children": children} if children else {})})

    def camera(self, room: Room) -> int:
        """Add a camera that sees the whole room; return its node's index."""
        lens: Json = {"yfov": SCENERY.field, "aspectRatio": SCENERY.aspect, "znear": 0.05}
        number = self.add("cameras", {"type": "perspective", "perspective": lens})
        position, axes = overview(room)
        place = np.vstack([np.column_stack([axes, position]), (0.0, 0.0, 0.0, 1.0)])
        return self.add("nodes", {"name": "camera", "camera": number, "matrix": place.T.ravel().tolist()})

    def _mesh(self, name: str, material: Material, closed: bool, shape: DrawnSurface) -> int:
        arrays = (shape.positions, shape.normals, shape.indices, shape.uvs)
        key = (material, closed, *(array.tobytes() for array in arrays))
        return self._once(
            "meshes", key, lambda: {"name": name, "primitives": [self.primitive(material, closed, shape)]}
        )

    def primitive(self, material: Material, closed: bool, shape: DrawnSurface) -> Json:
        """Add a surface of one material; return what a mesh says of it."""
        vertices = {"POSITION": shape.positions, "NORMAL": shape.normals}
        if material.texture is not None:
            vertices["TEXCOORD_0"] = shape.uvs
        attributes = {name: self._vertices(array.astype("<f4")) for name, array in vertices.items()}
        corners = shape.indices.reshape(-1).astype("<u4")
        view = self._view(corners.tobytes(), target=INDICES)
        indices: Json = {"bufferView": view, "count": len(corners), "componentType": UINT32, "type": "SCALAR"}
        return {
            "attributes": attributes,
            "indices": self.add("accessors", indices),
            "material": self._once("materials", (material, closed), lambda: self._material(material, closed)),
        }

    def _material(self, material: Material, closed: bool) -> Json:
        surface: Json = {
            "baseColorFactor": [*(round(c, 6) for c in base_color(material)), material.opacity],
            "metallicFactor": material.metallic,
            "roughnessFactor": material.roughness,
        }
        entry: Json = {"name": material.name, "pbrMetallicRoughness": surface}
        if (texture := material.texture) is not None:
            surface["baseColorTexture"] = {"index": self._once("textures", texture, lambda: self._texture(texture))}
        if material.glow:
            entry["emissiveFactor"] = [round(c * material.glow, 6) for c in linear(material.color)]
        if material.opacity < 1:
            entry["alphaMode"] = "BLEND"
        return entry if closed else {**entry, "doubleSided": True}

    def _texture(self, texture: str | bytes) -> Json:
        self.lists["samplers"] = [REPEAT]
        data = picture(texture)
        image = self.add("images", {"bufferView": self._view(data), "mimeType": media_type(data)})
        return {"source": image, "sampler": 0}

    def _view(self, data: bytes, **content: int) -> int:
        """Add bytes, padded to the four bytes that numbers need; return the index of their view."""
        view: Json = {"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data), **content}
        self.blob += data + bytes(-len(data) % 4)
        return self.add("bufferViews", view)

    def _vertices(self, array: NDArray[np.float32]) -> int:
        """Add what each vertex has (n, 2 or 3); return the index of its accessor."""
        entry: Json = {"bufferView": self._view(array.tobytes(), target=VERTICES), "count": len(array)}
        kind: Json = {"componentType": FLOAT, "type": f"VEC{array.shape[1]}"}
        low, high = array.min(axis=0).tolist(), array.max(axis=0).tolist()
        return self.add("accessors", {**entry, **kind, "min": low, "max": high})

    def packed(self, root: int) -> bytes:
        """Return the whole file with its root node; empty lists are left out, as the format demands."""
        lights: Json = {LIGHTS: {"lights": [BULB]}}
        lit = any("extensions" in node for node in self.lists["nodes"])
        self.lists["buffers"] = [{"byteLength": len(self.blob)}] if self.blob else []
        document = {
            "asset": {"version": "2.0", "generator": f"robolayout {__version__}"},
            **({"extensionsUsed": [LIGHTS], "extensions": lights} if lit else {}),
            "scene": 0,
            "scenes": [{"nodes": [root]}],
            **{name: entries for name, entries in self.lists.items() if entries},
        }
        text = utf8(json.dumps(document, separators=(",", ":"), ensure_ascii=False, allow_nan=False))
        chunks = _chunk(b"JSON", text, b" ") + (_chunk(b"BIN\0", bytes(self.blob), b"\0") if self.blob else b"")
        return MAGIC + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def _chunk(kind: bytes, data: bytes, filler: bytes) -> bytes:
    """Return a chunk of a GLB file, padded to four bytes."""
    padding = -len(data) % 4
    return struct.pack("<I", len(data) + padding) + kind + data + filler * padding


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the room and all placed assets as one GLB file."""
    builder, shell = _Builder(), room_parts(scene.room, seed=options.seed)
    names = dict.fromkeys(part.name for part in shell)
    room = [builder.object(name, tuple(part for part in shell if part.name == name)) for name in names]
    children = [builder.add("nodes", {"name": "room", "children": room, "extras": {"kind": "room"}})]
    for asset, pose in placed(scene, layout):
        half = pose.yaw / 2
        children.append(
            builder.object(
                asset.name,
                laid_parts(asset, scene, layout, seed=options.seed),
                translation=[pose.x, pose.y, pose.z],
                rotation=[0.0, 0.0, math.sin(half), math.cos(half)],
                extras={"kind": "asset", **facts(asset, movable=is_movable(asset, scene, layout))},
            )
        )
    children.append(builder.camera(scene.room))
    turn = math.sqrt(0.5)
    extras: Json = {"kind": "scene", "frame": "z up, metres, box centres, yaw 0 faces +x"}
    if options.agent is not None:
        extras["agent"] = options.agent.name
    if options.routes:
        extras["routes"] = {name: [list(point) for point in line] for name, line in options.routes.items()}
    root: Json = {"name": scene.name, "rotation": [-turn, 0.0, 0.0, turn], "children": children, "extras": extras}
    return builder.packed(builder.add("nodes", root))


def asset_glb(asset: Asset, pieces: tuple[Part, ...]) -> bytes:
    """Return one asset alone, as a single mesh in glTF's own frame: y up, front along +z, origin in the middle of its box."""
    builder, known = _Builder(), facts(asset, movable=category_of(asset).movable)
    primitives = [builder.primitive(material, closed, _turned(shape)) for material, closed, shape in merged(pieces)]
    mesh = builder.add("meshes", {"name": asset.name, "primitives": primitives})
    extras: Json = {"kind": "asset", **known}
    return builder.packed(builder.add("nodes", {"name": asset.name, "mesh": mesh, "extras": extras}))


def _turned(shape: DrawnSurface) -> DrawnSurface:
    """Return a surface in glTF's axes (front z, up y) instead of this package's (front x, up z)."""
    axes = [1, 2, 0]
    return replace(shape, positions=shape.positions[:, axes], normals=shape.normals[:, axes])


def document(data: bytes) -> Json:
    """Return the JSON chunk of a GLB file."""
    if len(data) < 20 or data[:4] != MAGIC or data[16:20] != b"JSON":
        raise Unreadable("is no GLB: it must start with the four letters glTF and a JSON chunk")
    (length,) = struct.unpack("<I", data[12:16])
    return cast(Json, json_value(decoded(data[20 : 20 + length])))


@reader("GLB file")
def read(data: bytes) -> Rows:
    """Yield the names, poses and sizes in a GLB file that this package wrote."""
    for node in cast(list[Json], document(data).get("nodes", [])):
        extras = cast(Mapping[str, object], node.get("extras", {}))
        if extras.get("kind") != "asset":
            continue
        x, y, z = cast(list[float], node["translation"])
        _, _, sine, cosine = cast(list[float], node["rotation"])
        yield str(node["name"]), Pose(x, y, z, 2 * math.atan2(sine, cosine)), cast(list[float], extras["size"])


GLB = Exporter("glb", ".glb", "glTF binary: meshes, materials, one node per asset", None, write, read)
