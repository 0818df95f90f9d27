"""Mesh files that promise too much, point elsewhere or lie: refused from their headers, before memory is made for them."""

from __future__ import annotations

import io
import json
import struct
import subprocess
import sys
import zlib
from pathlib import Path
from typing import Any

import pytest
import trimesh
from PIL import Image

from robolayout._errors import AssetError
from robolayout.assets import load_mesh_parts

SIZE = (0.6, 0.9, 0.8)


def glb(change: Any, binary: bytes = b"") -> bytes:
    """Return a good GLB of a box whose header was changed, with more bytes at its end."""
    data = trimesh.creation.box((1, 1, 1)).export(file_type="glb")
    (size,) = struct.unpack_from("<I", data, 12)
    header, chunk = json.loads(data[20 : 20 + size]), data[28 + size :]
    change(header)
    header["buffers"][0]["byteLength"] = len(chunk) + len(binary)
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    chunk += binary
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(chunk), 0x004E4942) + chunk
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


def png(width: int, height: int) -> bytes:
    """Return a picture of one colour as a PNG of a few bytes a line, whatever its size."""
    packer = zlib.compressobj(9)
    rows = b"".join(packer.compress(bytes(1 + width * 3)) for _ in range(height)) + packer.flush()

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def pictured(picture: bytes) -> bytes:
    def change(header: dict[str, Any]) -> None:
        start = sum(view["byteLength"] for view in header["bufferViews"])
        header["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": len(picture)})
        header["images"] = [{"bufferView": len(header["bufferViews"]) - 1, "mimeType": "image/png"}]
        header["textures"] = [{"source": 0}]
        header["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
        header["meshes"][0]["primitives"][0]["material"] = 0

    return glb(change, picture)


def jpeg(color: str) -> bytes:
    stream = io.BytesIO()
    Image.new("RGB", (8, 8), color).save(stream, "JPEG")
    return stream.getvalue()


def doubled(header: dict[str, Any]) -> None:
    header["nodes"] = [{"children": [1, 1]}, {"mesh": 0}]


def copied(header: dict[str, Any]) -> None:
    header["meshes"][0]["primitives"] *= 500
    header["nodes"] = [{"mesh": 0}] * 20_000


REFUSED: dict[str, tuple[bytes, str]] = {
    "pixels": (pictured(png(20_000, 4_000)), r"pictures of more than 64 million pixels \(images\[0\]: 20000 x 4000\)"),
    "no picture": (pictured(b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\n"), "no PNG, JPEG or WebP picture"),
    "another file": (glb(lambda h: h["buffers"].append({"uri": "../secret.bin", "byteLength": 9})), "in another file"),
    "view": (glb(lambda h: h["bufferViews"][0].update(byteLength=10**6)), r"bufferViews\[0\] reaches beyond the file"),
    "accessor": (glb(lambda h: h["accessors"][0].update(count=10**6)), r"accessors\[0\] reaches beyond its view"),
    "nothing behind": (
        glb(lambda h: (h["accessors"][0].update(count=10**8), h["accessors"][0].pop("bufferView"))),
        "MB of numbers; at most 200 MB",
    ),
    "negative": (glb(lambda h: h["accessors"][0].update(count=-1)), "count of accessors.0. is -1, not a whole number"),
    "copies": (glb(copied), "unfolds to more than 3000000 triangles"),
    "instances": (glb(lambda h: h.update(nodes=[{"mesh": 0}] * 20_001)), "has 20001 nodes; at most 20000 are read"),
    "parents": (glb(doubled), "a node has two parents"),
    "no parts": (glb(lambda h: h["meshes"][0].update(primitives=[{}])), "a primitive without attributes"),
    "no meshes": (glb(lambda h: (h.pop("meshes"), h.update(nodes=[]))), "broken|no triangles"),
    "torn": (glb(lambda h: None)[:-40], "it ends within its geometry"),
    "deep": (glb(lambda h: h.update(extras=json.loads("[" * 80 + "]" * 80))), "nested too deeply"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_a_glb_is_refused_from_its_header(case: str, tmp_path: Path) -> None:
    data, said = REFUSED[case]
    path = tmp_path / "thing.glb"
    path.write_bytes(data)
    with pytest.raises(AssetError, match=said):
        load_mesh_parts(path, SIZE)


def test_a_picture_of_a_few_pixels_gives_the_colour(tmp_path: Path) -> None:
    path = tmp_path / "thing.glb"
    path.write_bytes(pictured(jpeg("red")))
    red, green, _ = load_mesh_parts(path, SIZE)[0].material.color
    assert red > 0.9 and green < 0.1


@pytest.mark.slow
def test_a_megabyte_of_picture_takes_little_memory(tmp_path: Path) -> None:
    data = pictured(png(20_000, 20_000))
    assert len(data) < 1_500_000
    (tmp_path / "thing.glb").write_bytes(data)
    code = (
        "import re, sys; from pathlib import Path; from robolayout._errors import AssetError\n"
        "from robolayout.assets import load_mesh_parts\n"
        "try: load_mesh_parts(Path(sys.argv[1]), (1.0, 1.0, 1.0))\n"
        "except AssetError: print(re.search(r'VmHWM:\\s+(\\d+)', Path('/proc/self/status').read_text())[1])\n"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code, tmp_path / "thing.glb"], capture_output=True, text=True, check=True
    )
    assert int(ran.stdout) < 400_000


@pytest.mark.parametrize(
    ("suffix", "data", "said"),
    [
        (".obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n" + b"o a\nf 1 2 3\n" * 20_001, "has 20001 pieces; at most 20000 are read"),
        (".obj", b"v 0 0 0\nf 1 2", "broken|no triangles"),
        (".stl", b"solid a\n" + b"facet\n" * 3_000_001, "has 3000001 triangles; at most 3000000 are read"),
        (".ply", b"ply\nformat ascii 1.0\nelement vertex x\nend_header\n", "counts elements with what is no number"),
        (".ply", b"ply\nformat ascii 1.0\nelement vertex 10\nend_header\n" + b" " * 100, "broken|no triangles"),
    ],
)  # fmt: skip
def test_other_meshes_are_refused(suffix: str, data: bytes, said: str, tmp_path: Path) -> None:
    path = tmp_path / f"thing{suffix}"
    path.write_bytes(data)
    with pytest.raises(AssetError, match=said):
        load_mesh_parts(path, SIZE)


def test_an_obj_opens_no_other_file(tmp_path: Path) -> None:
    secret = tmp_path / "secret.mtl"
    secret.write_text("newmtl m\nKd 1 0 0\n")
    (tmp_path / "in").mkdir()
    path = tmp_path / "in" / "thing.obj"
    path.write_text("mtllib ../secret.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
    red, green, _ = load_mesh_parts(path, SIZE)[0].material.color
    assert abs(red - green) < 0.2, "the colour in the other file is not taken"
