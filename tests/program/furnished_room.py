"""One room with enough furniture to state every relation."""

from robolayout.scene import Asset, Opening, Room, Scene


def furnished(*extra: Asset) -> Scene:
    """Return a room of 4 x 5 m with a door, furniture, and `extra` assets."""
    room = Room(((0, 0), (4, 0), (4, 5), (0, 5)), 2.6, doors=(Opening(0, 2.9, 0.9, 2.05),))
    chairs = [Asset(f"chair-{i}", "chair", (0.5, 0.5, 0.9)) for i in range(4)]
    hangs = {"on_floor": False}
    return Scene(
        room,
        (
            Asset("bed-0", "bed", (2.0, 1.6, 0.5)),
            Asset("night_stand-0", "night stand", (0.4, 0.45, 0.5)),
            Asset("night_stand-1", "night stand", (0.4, 0.45, 0.5)),
            Asset("rug-0", "rug", (2.0, 1.4, 0.01)),
            *chairs,
            Asset("table-0", "table", (0.8, 1.4, 0.75)),
            Asset("lamp-0", "table lamp", (0.2, 0.2, 0.4), on_floor=False, on_object=True),
            Asset("picture-0", "picture", (0.03, 0.8, 0.6), on_wall=True, **hangs),
            Asset("pendant-0", "pendant lamp", (0.4, 0.4, 0.5), on_ceiling=True, **hangs),
            *extra,
        ),
    )
