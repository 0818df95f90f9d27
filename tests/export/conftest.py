"""A small furnished room with one of every kind of place: floor, top, wall, ceiling, rug."""

from __future__ import annotations

import math

import pytest

from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene


@pytest.fixture(scope="session")
def scene() -> Scene:
    """An L-shaped room with a door and two windows, one wall of which holds a door and a window."""
    room = Room(
        ((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (3.0, 4.0), (3.0, 3.5), (0.0, 3.5)),
        2.6,
        (Opening(0, 3.6, 0.9, 2.05),),
        (Opening(0, 1.0, 1.2, 1.2, 0.9), Opening(1, 1.0, 1.4, 1.2, 0.9)),
    )
    assets = (
        Asset("double_bed-0", "double bed", (2.0, 1.6, 0.9), "bed with a low \"headboard\" <linen> & 'oak'"),
        Asset("night_stand-0", "night stand", (0.4, 0.45, 0.5)),
        Asset("table_lamp-0", "table lamp", (0.2, 0.2, 0.4), on_floor=False, on_object=True),
        Asset("wardrobe-0", "wardrobe", (0.6, 1.2, 2.0)),
        Asset("dining_chair-0", "dining chair", (0.5, 0.45, 0.86)),
        Asset("potted_plant-0", "potted plant", (0.35, 0.35, 0.9)),
        Asset("picture-0", "picture", (0.03, 0.7, 0.5), on_floor=False, on_wall=True),
        Asset("ceiling_lamp-0", "ceiling lamp", (0.4, 0.4, 0.3), on_floor=False, on_ceiling=True),
        Asset("rug-0", "rug", (1.4, 2.0, 0.01)),
    )
    return Scene(room, assets, "a bedroom", name="den")


@pytest.fixture(scope="session")
def layout() -> Layout:
    """Where everything stands in that room; yaws on the axes and off them."""
    return Layout(
        {
            "double_bed-0": Pose(1.02, 1.6, 0.45, 0.0),
            "night_stand-0": Pose(0.22, 2.7, 0.25, 0.0),
            "table_lamp-0": Pose(0.2, 2.7, 0.7, 0.7),
            "wardrobe-0": Pose(4.69, 3.2, 1.0, math.pi),
            "dining_chair-0": Pose(2.8, 2.9, 0.43, -2.1),
            "potted_plant-0": Pose(0.3, 0.4, 0.45, 1.234567),
            "picture-0": Pose(1.5, 3.485, 1.5, -math.pi / 2),
            "ceiling_lamp-0": Pose(2.5, 1.8, 2.45, 0.3),
            "rug-0": Pose(2.2, 1.6, 0.005, 0.05),
        }
    )
