"""Room for knees and toes: who sits at what frontally, and who beside it (ADA 2010, 306)."""

from __future__ import annotations

from dataclasses import replace

import pytest
from verify_rooms import furnished, on_floor, square, thing

from robolayout.scene import Asset, Opening, load_agents
from robolayout.verify import verify
from robolayout.verify._knees import frontal, knee_width

(CHAIR,) = load_agents("wheelchair")
LEGS = "leg: box dark x 0:.04m y 0:.04m z 0:{h} mirror xy\ntop: box wood x 0:1 y 0:1 z {h}:1"


def table(size: tuple[float, float, float], *rows: str, under: float | None = None) -> Asset:
    parts = "\n".join([LEGS.format(h=f"{under or size[2] - 0.03}m"), *rows])
    return replace(thing("desk-0", size, "desk"), parts=parts)


@pytest.mark.parametrize(
    ("asset", "side", "fits"),
    [
        (table((0.8, 1.2, 0.75)), "front", True),
        (table((0.8, 0.80, 0.75)), "front", False),  # 0.72 m between the legs
        (table((0.8, 1.2, 0.70)), "front", False),  # 0.67 m below the top
        (table((0.8, 1.2, 0.75), "wall: box wood x 1-.30m:1-.28m y 0:1 z .25m:.6m"), "front", True),
        (table((0.8, 1.2, 0.75), "wall: box wood x 1-.24m:1-.22m y 0:1 z .25m:.6m"), "front", False),
        (table((0.8, 1.2, 0.75), "wall: box wood x 1-.24m:1-.22m y 0:1 z .60m:.7m"), "front", True),  # it tapers
        (table((0.8, 1.2, 0.75), "board: box wood x 1-.40m:1-.38m y 0:1 z .02m:.1m"), "front", False),  # toes
        (table((0.8, 1.2, 0.75), "board: box wood x 1-.45m:1-.44m y 0:1 z .02m:.1m"), "front", True),
    ],
)
def test_the_figures_of_the_standard(asset: Asset, side: str, fits: bool) -> None:
    assert frontal(asset, side) is fits


def test_what_is_closed_below_has_no_room() -> None:
    assert knee_width(thing("counter-0", (0.6, 1.8, 0.9), "kitchen counter"), "front") == 0.0


def approach(asset: Asset) -> tuple[bool, str, str]:
    scene, layout = furnished(
        square(5.0, doors=(Opening(wall=0, offset=2.0, width=1.0, height=2.05),)),
        (asset, on_floor(asset, 2.5, 3.5, 270)),
        agents=(CHAIR,),
    )
    report = verify(scene, layout)
    use = report.agents[0].usage.uses[asset.name]
    assert (f"yes, {use.approach}" in report.to_markdown()) is use.usable
    return use.usable, use.approach, use.reason


def test_a_wheelchair_rolls_up_to_an_open_desk_and_stands_beside_a_closed_one() -> None:
    assert approach(table((0.8, 1.2, 0.75))) == (True, "frontally", "")
    assert approach(thing("counter-0", (0.6, 1.8, 0.9), "kitchen counter")) == (True, "sideways", "")
