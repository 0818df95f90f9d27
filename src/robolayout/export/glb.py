"""GLB (glTF 2.0 binary): what viewers, game engines and Habitat-style simulators load.

One node per asset with its name, pose and facts ("extras"), one child mesh per material. glTF is y up, so the root
turns the whole scene by -90 degrees about x; below it everything keeps this package's frame (z up, metres, box
centres).
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from robolayout._reading.syntax import Unreadable, decoded, json_value
from robolayout._text import utf8
from robolayout._version import __version__
from robolayout.assets import Material, Part, category_of, room_parts
from robolayout.assets.textures import media_type, picture
from robolayout.export._exporter import Exporter, Json, Options, Rows, facts, is_movable, placed, reader
from robolayout.export._mesh import Surface, base_color, linear, merged, quaternion
from robolayout.export._rugs import laid_parts
from robolayout.export._scenery import SCENERY, lamp, overview
from robolayout.scene import Asset, Layout, Pose, Room, Scene

MAGIC = b"glTF"

FLOAT, UINT32 = 5126, 5125
VERTICES, INDICES = 34962, 34963
REPEAT: Json = {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}
"""How all textures are looked up: smoothly, and again and again."""
LIGHTS = "KHR_lights_punctual"
BULB: Json = {"type": "point", "color": list(SCENERY.warm), "intensity": round(SCENERY.lumens / (4 * math.pi), 3)}
"""The light of every lamp, in candela."""


class _Builder:
    """Collects nodes, meshes and binary data; equal meshes are stored once."""

    def __init__(self) -> None:
        self.nodes: list[Json] = []
        self.meshes: list[Json] = []
        self.materials: list[Json] = []
        self.textures: list[Json] = []
        self.images: list[Json] = []
        self.accessors: list[Json] = []
        self.views: list[Json] = []
        self.blob = bytearray()
        self.cameras: list[Json] = []
        self.lit = False
        self._known: dict[object, int] = {}

    def node(self, name: str, **content: object) -> int:
        """Add a node; return its index."""
        self.nodes.append({"name": name, **content})
        return len(self.nodes) - 1

    def object(self, name: str, pieces: tuple[Part, ...], **content: object) -> int:
        """Add a node with one child mesh per material, and a light if it is a lamp; return its index."""
        children = [
            self.node(f"{name}.{material.name}", mesh=self._mesh(name, material, closed, shape))
            for material, closed, shape in merged(pieces)
            if len(shape.indices)
        ]
        if (bulb := lamp(pieces)) is not None:
            self.lit = True
            light = {LIGHTS: {"light": 0}}
            children.append(self.node(f"{name}.light", translation=list(bulb), extensions=light))
        return self.node(name, **content, **({"children": children} if children else {}))

    def camera(self, room: Room) -> int:
        """Add a camera that sees the whole room; return its node's index."""
        self.cameras.append(
            {
                "type": "perspective",
                "perspective": {"yfov": SCENERY.field, "aspectRatio": SCENERY.aspect, "znear": 0.05},
            }
        )
        view = overview(room)
        w, x, y, z = quaternion(view.rotation)
        return self.node("camera", camera=0, translation=list(view.position), rotation=[x, y, z, w])

    def _mesh(self, name: str, material: Material, closed: bool, shape: Surface) -> int:
        arrays = (shape.positions, shape.normals, shape.indices, shape.uvs)
        key = (material, closed, *(array.tobytes() for array in arrays))
        if key not in self._known:
            self.meshes.append(
                {"name": f"{name}.{material.name}", "primitives": [self.primitive(material, closed, shape)]}
            )
            self._known[key] = len(self.meshes) - 1
        return self._known[key]

    def primitive(self, material: Material, closed: bool, shape: Surface) -> Json:
        """Add a surface of one material; return what a mesh says of it."""
        attributes = {
            "POSITION": self._accessor(shape.positions.astype("<f4"), VERTICES),
            "NORMAL": self._accessor(shape.normals.astype("<f4"), VERTICES),
        }
        if material.texture is not None:
            attributes["TEXCOORD_0"] = self._accessor(shape.uvs.astype("<f4"), VERTICES)
        indices = self._accessor(shape.indices.reshape(-1).astype("<u4"), INDICES)
        return {"attributes": attributes, "indices": indices, "material": self._material(material, closed)}

    def _material(self, material: Material, closed: bool) -> int:
        key = (material, closed)
        if key not in self._known:
            entry: dict[str, Any] = {
                "name": material.name,
                "pbrMetallicRoughness": {
                    "baseColorFactor": [*(round(c, 6) for c in base_color(material)), material.opacity],
                    "metallicFactor": material.metallic,
                    "roughnessFactor": material.roughness,
                },
            }
            if material.texture is not None:
                entry["pbrMetallicRoughness"]["baseColorTexture"] = {"index": self._texture(material.texture)}
            if material.glow:
                entry["emissiveFactor"] = [round(c * material.glow, 6) for c in linear(material.color)]
            if material.opacity < 1:
                entry["alphaMode"] = "BLEND"
            if not closed:
                entry["doubleSided"] = True
            self.materials.append(entry)
            self._known[key] = len(self.materials) - 1
        return self._known[key]

    def _texture(self, texture: str | bytes) -> int:
        if texture not in self._known:
            data = picture(texture)
            self.images.append({"bufferView": self._view(data), "mimeType": media_type(data)})
            self.textures.append({"source": len(self.images) - 1, "sampler": 0})
            self._known[texture] = len(self.textures) - 1
        return self._known[texture]

    def _view(self, data: bytes, **content: int) -> int:
        """Add bytes, padded to the four bytes that numbers need; return the index of their view."""
        self.views.append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data), **content})
        self.blob += data + bytes(-len(data) % 4)
        return len(self.views) - 1

    def _accessor(self, array: NDArray[np.float32 | np.uint32], target: int) -> int:
        entry: Json = {"bufferView": self._view(array.tobytes(), target=target), "count": len(array)}
        if target == INDICES:
            entry |= {"componentType": UINT32, "type": "SCALAR"}
        else:
            low, high = array.min(axis=0), array.max(axis=0)
            kind = f"VEC{array.shape[1]}"
            entry |= {"componentType": FLOAT, "type": kind, "min": low.tolist(), "max": high.tolist()}
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def document(self, root: int) -> Json:
        """Return the JSON of the whole file; empty lists are left out, as the format demands."""
        lists: dict[str, list[Json]] = {
            "meshes": self.meshes,
            "materials": self.materials,
            "textures": self.textures,
            "images": self.images,
            "samplers": [REPEAT] if self.textures else [],
            "cameras": self.cameras,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.blob)}] if self.blob else [],
        }
        lights: Json = {LIGHTS: {"lights": [BULB]}}
        return {
            "asset": {"version": "2.0", "generator": f"robolayout {__version__}"},
            **({"extensionsUsed": [LIGHTS], "extensions": lights} if self.lit else {}),
            "scene": 0,
            "scenes": [{"nodes": [root]}],
            "nodes": self.nodes,
            **{name: entries for name, entries in lists.items() if entries},
        }


def by_name(pieces: tuple[Part, ...]) -> dict[str, tuple[Part, ...]]:
    """Return parts grouped by their name, in the order in which the names first appear."""
    groups: dict[str, list[Part]] = {}
    for part in pieces:
        groups.setdefault(part.name, []).append(part)
    return {name: tuple(group) for name, group in groups.items()}


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the room and all placed assets as one GLB file."""
    builder = _Builder()
    room = [builder.object(name, pieces) for name, pieces in by_name(room_parts(scene.room, seed=options.seed)).items()]
    children = [builder.node("room", children=room, extras={"kind": "room"})]
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
    root = builder.node(scene.name, rotation=[-turn, 0.0, 0.0, turn], children=children, extras=extras)
    return _packed(builder.document(root), bytes(builder.blob))


def asset_glb(asset: Asset, pieces: tuple[Part, ...]) -> bytes:
    """Return one asset alone, as a single mesh in glTF's own frame: y up, front along +z, origin in the middle of its box."""
    builder, known = _Builder(), facts(asset, movable=category_of(asset).movable)
    primitives = [builder.primitive(material, closed, _turned(shape)) for material, closed, shape in merged(pieces)]
    builder.meshes.append({"name": asset.name, "primitives": primitives})
    body = builder.node(asset.name, mesh=0, extras={"kind": "asset", **known})
    return _packed(builder.document(body), bytes(builder.blob))


def _turned(shape: Surface) -> Surface:
    """Return a surface in glTF's axes (front z, up y) instead of this package's (front x, up z)."""
    axes = [1, 2, 0]
    return replace(shape, positions=shape.positions[:, axes], normals=shape.normals[:, axes])


def _packed(document: Json, blob: bytes) -> bytes:
    """Return the two chunks of a GLB file, each padded to four bytes."""
    text = utf8(json.dumps(document, separators=(",", ":"), ensure_ascii=False, allow_nan=False))
    chunks = struct.pack("<II", len(text) + -len(text) % 4, 0x4E4F534A) + text + b" " * (-len(text) % 4)
    if blob:
        chunks += struct.pack("<II", len(blob) + -len(blob) % 4, 0x004E4942) + blob + b"\0" * (-len(blob) % 4)
    return MAGIC + struct.pack("<II", 2, 12 + len(chunks)) + chunks


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
