"""The one door for everything that is read: files, JSON, TOML, XML and meshes, bounded before they are parsed.

Whatever comes from outside is hostile until it has passed through here. A file is opened once, only if it is a regular one,
and no more of it is read than is allowed. Text is bounded in depth, in values and in the length of its numbers before a
parser sees it; a mesh in its parts, triangles, bytes and pixels. `Checker` then validates values with one clear sentence each.
"""

from robolayout._reading.check import MESH_SUFFIXES, Checker, inside, misspelt, regular_bytes, show, whole
from robolayout._reading.limits import LIMITS
from robolayout._reading.syntax import Unreadable

__all__ = ["LIMITS", "MESH_SUFFIXES", "Checker", "Unreadable", "inside", "misspelt", "regular_bytes", "show", "whole"]
