"""Many assets in one picture, each with its name: what the catalogue looks like."""

from __future__ import annotations

import math
from collections.abc import Sequence

from PIL import Image, ImageDraw

from robolayout.render._drawing import font, is_latin
from robolayout.render.view import render_asset
from robolayout.scene import Asset

PAPER, INK = (246, 245, 241), (40, 40, 40)
MOST_COLUMNS = 10


def asset_sheet(assets: Sequence[Asset], *, tile: int = 200, seed: int = 0) -> Image.Image:
    """Return a sheet with a picture of every asset, `tile` pixels a side, row by row, its category below it."""
    columns = min(MOST_COLUMNS, math.ceil(math.sqrt(len(assets))))
    label = tile // 8
    size = (columns * tile, math.ceil(len(assets) / columns) * (tile + label))
    sheet = Image.new("RGB", size, PAPER)
    draw = ImageDraw.Draw(sheet)
    for number, asset in enumerate(assets):
        x, y = number % columns * tile, number // columns * (tile + label)
        sheet.paste(render_asset(asset, size=tile, seed=seed), (x, y))
        face = font(max(8, label // 2), is_latin(asset.category))
        draw.text((x + tile / 2, y + tile + label / 2), asset.category, INK, face, anchor="mm")
    return sheet
