"""What a binary glTF file promises, counted before anything of it is unpacked.

Its JSON is bounded like any other; every view must lie in the file and every accessor in its view; nodes form trees; what all
meshes unfold to, and the pixels of all pictures, are added up from their headers alone.
"""

from __future__ import annotations

import base64
import binascii
import io
import struct
from collections.abc import Mapping
from typing import Any, cast

from robolayout._reading.limits import LIMITS
from robolayout._reading.syntax import Unreadable, decoded, json_value

_MAGIC, _JSON, _BIN = 0x46546C67, 0x4E4F534A, 0x004E4942
_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_LISTS = ("accessors", "buffers", "bufferViews", "images", "materials", "meshes", "nodes", "scenes", "textures")

Entry = Mapping[str, Any]


def check_glb(data: bytes) -> None:
    """Raise `Unreadable` for a file that is broken or promises more than is read."""
    header, binary = _chunks(data)
    lists = {name: _entries(header, name) for name in _LISTS}
    if (count := len(lists["nodes"])) > LIMITS.pieces:
        raise Unreadable(f"has {count} nodes; at most {LIMITS.pieces} are read. Merge its parts and export again")
    if any("uri" in buffer for buffer in lists["buffers"]):
        raise Unreadable("keeps its geometry in another file; export it as one GLB file with everything in it")
    _check_views(lists["bufferViews"], len(binary))
    _check_accessors(lists["accessors"], lists["bufferViews"])
    _check_triangles(lists)
    _check_pictures(lists["images"], lists["bufferViews"], binary)


def glb_notice(data: bytes) -> str:
    """Return the copyright notice of a file; empty where it states none."""
    asset = _chunks(data)[0].get("asset")
    return str(cast(Entry, asset).get("copyright") or "")[:200] if isinstance(asset, dict) else ""


def _broken(why: str) -> Unreadable:
    return Unreadable(f"is broken and cannot be used: {why}")


def _chunks(data: bytes) -> tuple[Entry, bytes]:
    """Return the JSON header and the binary chunk."""
    if len(data) < 20:
        raise _broken("it ends within its first 20 bytes")
    magic, version, _, size, kind = struct.unpack_from("<IIIII", data)
    if magic != _MAGIC or version != 2 or kind != _JSON:
        raise _broken("it is no binary glTF 2.0 file")
    if 20 + size > len(data):
        raise _broken("it ends within its header")
    header = json_value(decoded(data[20 : 20 + size].rstrip(b"\0 ")))
    if not isinstance(header, dict):
        raise _broken("its header is no object")
    at = 20 + size
    while at + 8 <= len(data):
        size, kind = struct.unpack_from("<II", data, at)
        if at + 8 + size > len(data):
            raise _broken("it ends within its geometry")
        if kind == _BIN:
            return cast(Entry, header), data[at + 8 : at + 8 + size]
        at += 8 + size
    return cast(Entry, header), b""


def _entries(header: Entry, name: str) -> list[Entry]:
    found = header.get(name, [])
    if not isinstance(found, list) or not all(isinstance(entry, dict) for entry in cast(list[object], found)):
        raise _broken(f"{name} is no list of objects")
    return cast(list[Entry], found)


def _whole(entry: Entry, key: str, where: str, default: int | None = None, most: int = 2**31) -> int:
    """Return a whole number from 0 to `most` of an entry."""
    value = entry.get(key, default)
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= most:
        raise _broken(f"{key} of {where} is {value!r:.40}, not a whole number from 0 to {most}")
    return value


def _check_views(views: list[Entry], length: int) -> None:
    for i, view in enumerate(views):
        where = f"bufferViews[{i}]"
        _whole(view, "buffer", where, most=0)
        if _whole(view, "byteLength", where) + _whole(view, "byteOffset", where, 0) > length:
            raise _broken(f"{where} reaches beyond the file")
    _check_size(sum(view["byteLength"] for view in views))


def _check_accessors(accessors: list[Entry], views: list[Entry]) -> None:
    total = 0
    for i, accessor in enumerate(accessors):
        where = f"accessors[{i}]"
        kind, parts = accessor.get("componentType"), accessor.get("type")
        if kind not in _BYTES or parts not in _PARTS:
            raise _broken(f"{where} is of no known type")
        count, row = _whole(accessor, "count", where), _BYTES[kind] * _PARTS[parts]
        total += count * row
        if "bufferView" not in accessor:
            continue
        view = views[_whole(accessor, "bufferView", where, most=len(views) - 1)]
        stride = _whole(view, "byteStride", where, row, most=255) or row
        end = _whole(accessor, "byteOffset", where, 0) + (count - 1) * stride + row
        if count and end > view["byteLength"]:
            raise _broken(f"{where} reaches beyond its view")
    _check_size(total)


def _check_size(size: int) -> None:
    if size > LIMITS.unpacked:
        raise Unreadable(f"promises {size / 1e6:.0f} MB of numbers; at most {LIMITS.unpacked // 1_000_000} MB are read")


def _check_triangles(lists: Mapping[str, list[Entry]]) -> None:
    """Raise for nodes that are no trees and for meshes that unfold to too many triangles."""
    counts = [int(accessor["count"]) for accessor in lists["accessors"]]
    corners = [
        sum(_corners(part, f"meshes[{i}]", counts) for part in _entries(mesh, "primitives"))
        for i, mesh in enumerate(lists["meshes"])
    ]
    used: list[int] = []
    for i, node in enumerate(lists["nodes"]):
        children = node.get("children", [])
        if not isinstance(children, list) or not all(isinstance(child, int) for child in cast(list[object], children)):
            raise _broken(f"children of nodes[{i}] is no list of numbers")
        used += cast(list[int], children)
    if len(set(used)) < len(used):
        raise _broken("a node has two parents")
    placed = sum(
        corners[_whole(node, "mesh", f"nodes[{i}]", most=len(corners) - 1)]
        for i, node in enumerate(lists["nodes"])
        if "mesh" in node
    )
    if max(placed, sum(corners)) > 3 * LIMITS.triangles:
        raise Unreadable(f"unfolds to more than {LIMITS.triangles} triangles. Simplify it and export it again")


def _corners(part: Entry, where: str, counts: list[int]) -> int:
    """Return how many corners of triangles a primitive has, at least its vertices."""
    attributes = part.get("attributes")
    if not isinstance(attributes, dict):
        raise _broken(f"{where} has a primitive without attributes")
    places = [_whole(cast(Entry, attributes), key, where, most=len(counts) - 1) for key in cast(Entry, attributes)]
    vertices = max((counts[place] for place in places), default=0)
    indices = counts[_whole(part, "indices", where, most=len(counts) - 1)] if "indices" in part else 0
    fans = 3 if part.get("mode", 4) in (5, 6) else 1
    return max(vertices, indices) * fans


def _check_pictures(images: list[Entry], views: list[Entry], binary: bytes) -> None:
    """Raise for pictures that are neither PNG nor JPEG nor WebP, and for more pixels than are looked at."""
    pixels = 0
    for i, image in enumerate(images):
        if image.get("mimeType") == "image/ktx2":  # is not looked at
            continue
        content = _picture(image, f"images[{i}]", views, binary)
        if content is not None:
            width, height = _size(content, f"images[{i}]")
            pixels += width * height
            if pixels > LIMITS.pixels:
                raise Unreadable(
                    f"has pictures of more than {LIMITS.pixels // 1_000_000} million pixels (images[{i}]: {width} x {height}); "
                    "make its textures smaller"
                )


def _picture(image: Entry, where: str, views: list[Entry], binary: bytes) -> bytes | None:
    """Return the bytes of a picture; None for one in another file, which is not opened."""
    if "bufferView" in image:
        view = views[_whole(image, "bufferView", where, most=len(views) - 1)]
        start = int(view.get("byteOffset", 0))
        return binary[start : start + int(view["byteLength"])]
    uri = image.get("uri")
    if not isinstance(uri, str) or not uri.startswith("data:"):
        return None
    try:
        return base64.b64decode(uri.partition(",")[2])
    except (binascii.Error, ValueError):
        raise _broken(f"{where} is no base64") from None


def _size(content: bytes, where: str) -> tuple[int, int]:
    """Return width and height in pixels as the picture's header says, without decoding it."""
    import warnings

    from PIL import Image

    try:
        with (
            warnings.catch_warnings(action="ignore"),
            Image.open(io.BytesIO(content), formats=("PNG", "JPEG", "WEBP")) as picture,
        ):
            return picture.size
    except Image.DecompressionBombError:
        raise Unreadable(f"has a picture of more than {LIMITS.pixels // 1_000_000} million pixels ({where})") from None
    except (OSError, SyntaxError, ValueError, TypeError, struct.error):
        raise _broken(f"{where} is no PNG, JPEG or WebP picture") from None
