"""The colours of drawings: one calm pair per kind of furniture, and loud ones for what the agent needs to know.

The loud colours are those of Okabe and Ito (Color Universal Design, 2008), which people with any kind of colour vision
tell apart; furniture differs in lightness as well as hue, and always carries its name.
"""

from __future__ import annotations

from robolayout.assets import category_of
from robolayout.scene import Asset

INK = "#2b2b2b"
WALL = "#4a4744"
PAPER = "#ffffff"
FLOOR = "#fbfaf7"
FREE = "#d3e8f3"
ISLAND = "#f6e3c0"
ROUTE = "#0072b2"
NARROW = "#009e73"
TIGHT = "#d55e00"
BLOCKED = "#d55e00"
TURN = "#8e6a9b"
REACH = "#b0527f"
QUIET = "#77736d"

_FAMILIES: dict[str, tuple[str, str]] = {
    "sleeping": ("#ddd5ea", "#6f5f93"),
    "care": ("#ddd5ea", "#6f5f93"),
    "seating": ("#c6d7ea", "#45688f"),
    "hospitality": ("#c6d7ea", "#45688f"),
    "dining": ("#f3dfb4", "#8f6a1c"),
    "kitchen": ("#f3dfb4", "#8f6a1c"),
    "tableware": ("#fffaf0", "#8f6a1c"),
    "work": ("#cfe3cb", "#4b7547"),
    "classroom": ("#cfe3cb", "#4b7547"),
    "workshop": ("#cfe3cb", "#4b7547"),
    "storage": ("#e2d2c1", "#7d5f42"),
    "retail": ("#e2d2c1", "#7d5f42"),
    "warehouse": ("#e2d2c1", "#7d5f42"),
    "structure": ("#d5d2cd", "#65615b"),
    "bathroom": ("#c9e6e6", "#3d7a7c"),
    "media": ("#d4d4da", "#50505e"),
    "games": ("#efd0dc", "#8d4a67"),
    "play": ("#efd0dc", "#8d4a67"),
    "gym": ("#efd0dc", "#8d4a67"),
    "lighting": ("#fbf3c4", "#8a7a1f"),
    "plants": ("#c3dcb0", "#52762f"),
    "decoration": ("#ecdcd3", "#8a6656"),
    "textiles": ("#f1e3dc", "#a98270"),
}

_PLAIN = ("#e6e4e0", "#6a665f")


def asset_colors(asset: Asset) -> tuple[str, str]:
    """Return the fill and the line colour of an asset's footprint, as sRGB hex."""
    return _FAMILIES.get(category_of(asset).group, _PLAIN)
