"""The one door for everything that is read: files, JSON, TOML, XML and meshes, bounded before they are parsed.

Whatever comes from outside is hostile until it has passed through here. A file is opened once, only if it is a regular one,
and no more of it is read than is allowed. Text is bounded in depth, in values and in the length of its numbers before a
parser sees it; a mesh in its parts, triangles, bytes and pixels. `Checker` then validates values with one clear sentence each.
"""

from robolayout._reading.check import MAX_LENGTH, Checker, misspelt, show
from robolayout._reading.files import (
    MAX_FILE_BYTES,
    MAX_MESH_BYTES,
    MESH_SUFFIXES,
    inside,
    is_file,
    is_folder,
    regular_bytes,
)
from robolayout._reading.syntax import Unreadable

__all__ = [
    "MAX_FILE_BYTES",
    "MAX_LENGTH",
    "MAX_MESH_BYTES",
    "MESH_SUFFIXES",
    "Checker",
    "Unreadable",
    "inside",
    "is_file",
    "is_folder",
    "misspelt",
    "regular_bytes",
    "show",
]
