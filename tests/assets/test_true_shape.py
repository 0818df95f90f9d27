"""Laws of shapes and surfaces, for every record of the catalogue and for a user's own meshes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shapely
import trimesh

from robolayout.assets import CATALOGUE, Category, Prism, parts, prisms_of, resting_place, surfaces_of
from robolayout.assets.mass import centre_of_mass, part_masses
from robolayout.assets.surfaces import bearing, emptied, inner_surfaces, named_surfaces, open_shelves, slots
from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene
from robolayout.verify import verify


def thing(kind: str | Category, size: tuple[float, float, float] | None = None, **more: object) -> Asset:
    category = kind if isinstance(kind, Category) else CATALOGUE[kind]
    flags = {f"on_{place}": place in category.places for place in ("floor", "wall", "ceiling", "object")}
    return Asset(f"{category.name}-0", category.name, size or category.size, **(flags | more))  # type: ignore[arg-type]


def holds(shape: tuple[Prism, ...], points: np.ndarray, low: float) -> np.ndarray:
    """Whether points, with heights above `low`, lie in one of the prisms."""
    inside = np.zeros(len(points), dtype=bool)
    for prism in shape:
        outline = shapely.Polygon(prism.outline).buffer(1e-4)
        level = (points[:, 2] - low >= prism.low - 1e-4) & (points[:, 2] - low <= prism.high + 1e-4)
        inside |= level & shapely.intersects_xy(outline, points[:, 0], points[:, 1])
    return inside


@pytest.mark.parametrize("name", sorted(CATALOGUE))
def test_eight_prisms_hold_every_part(name: str) -> None:
    asset = thing(name)
    shape = prisms_of(asset)
    assert 1 <= len(shape) <= 8
    if len(shape) > 1:
        corners = np.concatenate([part.vertices for part in parts(asset)])
        assert holds(shape, corners, -asset.size[2] / 2).all()
    for prism in shape:
        assert prism.hx > 0 and prism.hy > 0 and 0 <= prism.cut <= min(prism.hx, prism.hy) + 1e-9
        assert np.abs(prism.outline).max(axis=0) == pytest.approx(np.abs(prism.outline).max(axis=0))
        assert (np.abs(prism.outline) <= np.array(asset.size[:2]) / 2 + 1e-6).all()
        assert 0 <= prism.low < prism.high <= asset.size[2] + 1e-6


@pytest.mark.parametrize("name", sorted(CATALOGUE))
def test_nothing_of_a_thing_is_above_its_surfaces(name: str) -> None:
    asset = thing(name)
    made = parts(asset)
    found = surfaces_of(asset)
    assert len({surface.name for surface in found}) == len(found)
    for surface in found:
        assert surface.region.is_valid and surface.region.area > 0
        x0, y0, x1, y1 = surface.rectangle
        assert surface.region.buffer(0.01).covers(shapely.box(x0, y0, x1, y1))
        inner = surface.region.buffer(-0.02)
        for part in made:
            z = part.vertices[:, 2] + asset.size[2] / 2
            if z.max() > surface.height + 0.03 and z.min() < surface.height + min(surface.free, 5.0) - 1e-6:
                foot = shapely.convex_hull(shapely.multipoints(part.vertices[:, :2]))
                assert shapely.area(shapely.intersection(foot, inner)) < 1e-3, (surface.name, part.name)


def test_people_sit_on_seats_and_a_table_leaves_room_for_knees() -> None:
    assert resting_place(thing("sofa"), thing("cushion")).name.startswith("seat")
    assert resting_place(thing("chair"), thing("cushion")).height == pytest.approx(0.45, abs=0.02)
    assert resting_place(thing("dining table"), thing("plate")).height == pytest.approx(0.75)
    top = max(prisms_of(thing("dining table")), key=lambda prism: prism.high)
    assert top.low > 0.6 and top.hy == pytest.approx(0.8)


def test_a_shelf_is_meant_by_name_or_number() -> None:
    stand, box = thing("night stand"), thing("book", (0.2, 0.15, 0.05))
    assert resting_place(stand, box).name == "top"
    shelf = resting_place(stand, box, named_surfaces(stand, "shelf 1"))
    assert shelf is resting_place(stand, box, named_surfaces(stand, "1"))
    assert shelf.covered and shelf.height < 0.2 and inner_surfaces(stand) == (shelf,)
    drawer = resting_place(stand, box, named_surfaces(stand, "drawer 1"))
    assert drawer.covered and shelf.height + shelf.free < drawer.height < drawer.height + drawer.free < stand.size[2]
    assert {s.name for s in inner_surfaces(thing("dresser"))} == {f"drawer {n}" for n in range(1, 9)}


def test_a_round_top_is_an_octagon_and_the_arm_of_a_sofa_leaves_its_notch_free() -> None:
    top = max(prisms_of(thing("round table")), key=lambda prism: prism.high)
    assert top.cut > 0.25
    ell = prisms_of(thing("sectional sofa"))
    notch = shapely.box(0.2, -1.2, 0.8, 0.2)
    assert not any(shapely.Polygon(prism.outline).intersects(notch) for prism in ell)


def test_own_meshes_have_shapes_and_surfaces_too(tmp_path: Path) -> None:
    def block(x: tuple[float, float], y: tuple[float, float], z: tuple[float, float]) -> trimesh.Trimesh:
        ends = np.array([x, y, z])
        mesh = trimesh.creation.box(extents=np.ptp(ends, axis=1))
        mesh.apply_translation(ends.mean(axis=1))
        return mesh

    legs = [block((x, x + 0.06), (y, y + 0.06), (0, 0.7)) for x in (0, 0.94) for y in (0, 0.54)]
    table = trimesh.util.concatenate([*legs, block((0, 1), (0, 0.6), (0.7, 0.75))])
    ell = trimesh.util.concatenate([block((0, 2), (0, 0.8), (0, 0.4)), block((0, 0.8), (0.8, 2), (0, 0.4))])
    for mesh, name in ((table, "table.stl"), (ell, "ell.stl")):
        mesh.export(tmp_path / name)
    own = thing("dining table", (1.0, 0.6, 0.75), path=tmp_path / "table.stl")
    assert len(prisms_of(own)) <= 8
    assert not any(prism.low < 0.6 and abs(prism.x) < prism.hx for prism in prisms_of(own))
    assert [round(s.height, 2) for s in surfaces_of(own)] == [0.75]
    sofa = thing("sofa", (2.0, 2.0, 0.4), path=tmp_path / "ell.stl")
    assert not any(shapely.Polygon(p.outline).intersects(shapely.box(0.1, 0.1, 0.9, 0.9)) for p in prisms_of(sofa))


@pytest.mark.parametrize("flat", [0, 1])
def test_a_mesh_without_a_thickness_is_a_millimetre_thick_in_its_box(flat: int, tmp_path: Path) -> None:
    corners = np.insert(np.array([(0, 0), (1, 0), (1, 1), (0, 1)]), flat, 0, axis=1)
    trimesh.Trimesh(corners, [(0, 1, 2), (0, 2, 3)], process=False).export(tmp_path / "sheet.stl")
    size = np.insert(np.ones(2), flat, 0.001)
    sheet = thing("picture", tuple(size.tolist()), path=tmp_path / "sheet.stl")
    for prism in prisms_of(sheet):
        edges = (2 * prism.hx, 2 * prism.hy, prism.high - prism.low)
        assert min(edges) > 0.0009
        assert np.abs(prism.outline).max(axis=0) == pytest.approx(size[:2] / 2)
        assert -1e-6 <= prism.low < prism.high <= size[2] + 1e-6
    room = Room(((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)), 2.5, doors=(Opening(0, 0.2, 0.9, 2.05),))
    layout = Layout({sheet.name: Pose(2.0, 2.0, float(size[2]) / 2, 0.3)})
    navigation = verify(Scene(room, (sheet,)), layout, agent="wheelchair").agents[0].navigation
    assert navigation.walkable_ratio > 0.9


def test_what_nobody_knows_is_its_box() -> None:
    (box,) = prisms_of(Asset("thingummy-0", "thingummy", (0.5, 0.4, 0.3)))
    assert (box.hx, box.hy, box.low, box.high) == (0.25, 0.2, 0.0, 0.3)


@pytest.mark.parametrize("name", sorted(name for name, c in CATALOGUE.items() if c.on_floor or c.on_object))
def test_nothing_falls_over_by_itself(name: str) -> None:
    """The centre of mass lies over the hull of what touches the ground, by a tilt of a degree and a half or more."""
    asset = thing(name)
    x, y, z = centre_of_mass(asset)
    feet = [shapely.Polygon(prism.outline) for prism in prisms_of(asset) if prism.low < 0.02]
    hull, middle = shapely.union_all(feet).convex_hull, shapely.Point(x, y)
    assert hull.covers(middle)
    assert asset.is_flat or hull.boundary.distance(middle) > np.tan(np.radians(1.5)) * (z + asset.size[2] / 2)


def test_shades_are_light_and_cupboards_hollow() -> None:
    lamp, cupboard = thing("floor lamp"), thing("wardrobe")
    assert centre_of_mass(lamp)[2] < 0.1
    weights, _ = part_masses(parts(cupboard))
    assert 40 < weights.sum() < 250


def test_a_round_top_is_a_disc() -> None:
    """Its largest rectangle was a strip: 1.07 x 0.57 m of a table 1.2 m across."""
    top = resting_place(thing("round table", (1.2, 1.2, 0.75)), thing("cup"))
    x0, y0, x1, y1 = top.rectangle
    assert top.radius == pytest.approx(0.6, abs=0.01)
    assert (x1 - x0, y1 - y0) == pytest.approx((0.82, 0.82), abs=0.01)
    oval = resting_place(thing("round table", (1.2, 2.0, 0.75)), thing("cup"))
    assert oval.is_oval
    assert oval.radius == 0.0
    assert not resting_place(thing("dining table"), thing("cup")).is_oval


def test_shelves_are_as_long_as_what_stands_on_them() -> None:
    """Ten pots on a shelf for nine all stood on its top."""
    pot = (0.3, 0.28, 0.16)
    unit = emptied(thing("shelving unit"), [pot], shelves=True)
    longer = replace(unit, size=bearing(unit, [pot] * 14, shelves=True))
    held = [sum(slots(shelf, pot) for shelf in open_shelves(one)) for one in (unit, longer)]
    assert held[0] < 14 <= held[1]
    assert bearing(unit, [pot] * 3, shelves=True) == unit.size
