"""The colours of drawings: one calm pair per kind of furniture, and loud ones for what the agent needs to know.

The loud colours are those of Okabe and Ito (Color Universal Design, 2008), which people with any kind of colour vision
tell apart; furniture differs in lightness as well as hue, and always carries its name.
"""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files

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

_PLAIN = ["#e6e4e0", "#6a665f"]


@cache
def _families() -> dict[str, list[str]]:
    return tomllib.loads((files("robolayout.render") / "palette.toml").read_text(encoding="utf-8"))


def asset_colors(asset: Asset) -> tuple[str, str]:
    """Return the fill and the line colour of an asset's footprint, as sRGB hex."""
    fill, line = _families().get(category_of(asset).group, _PLAIN)
    return fill, line
