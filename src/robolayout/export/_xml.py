"""XML as simulators read it: trees, what is said of things, and safe reading."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping

from robolayout._reading.syntax import Unreadable, decoded, xml_root
from robolayout._text import xml
from robolayout.assets import Material
from robolayout.export._mesh import FloatArray, numbers
from robolayout.scene import Asset, Pose

DRAKE = "http://drake.mit.edu"  # XML namespace of what only Drake reads

STIFF = "1e7"
"""Pascals by which what touches gives way in Drake, over an area: by single points flat things creep on each other."""

Tree = Mapping[str, "str | Tree"]  # what an element holds: attributes ("@name"), texts and trees of its children


def put(parent: ET.Element, tag: str, content: str | Tree) -> ET.Element:
    """Add an element and all that it holds."""
    element = ET.SubElement(parent, tag)
    if isinstance(content, str):
        element.text = xml(content)
        return element
    for name, inner in content.items():
        if name.startswith("@"):
            element.set(name[1:], str(inner))
        else:
            put(element, name, inner)
    return element


def facts(asset: Asset) -> Tree:
    """Return what is said of an asset beside its pose, so that it can be read back."""
    return {"@name": asset.name, "@category": asset.category, "@size": " ".join(map(repr, asset.size))}


def moments(inertia: FloatArray) -> dict[str, str]:
    """Return an inertia as URDF and SDF name its entries."""
    entries = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
    return {name: numbers([float(inertia[place])]) for name, place in entries.items()}


def rgba(material: Material) -> str:
    """Return a colour and how opaque it is."""
    return " ".join(f"{value:.4g}" for value in (*material.color, material.opacity))


def pose_of(place: str) -> Pose:
    """Return the pose that place, roll, pitch and yaw say."""
    x, y, z, _, _, yaw = map(float, place.split())
    return Pose(x, y, z, yaw)


def dump_xml(root: ET.Element) -> bytes:
    """Return an XML file, indented, with a newline at its end; what XML cannot hold is replaced."""
    for element in root.iter():
        for key, value in element.attrib.items():
            element.set(key, xml(value))
    ET.indent(root)
    return ET.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"


def parse_xml(data: bytes, root: str) -> ET.Element:
    """Return the root element of XML text that declares no document type (and so no entities)."""
    element = xml_root(decoded(data))
    if element.tag != root:
        raise Unreadable(f"must start with <{root}>, not <{element.tag[:60]}>")
    return element
