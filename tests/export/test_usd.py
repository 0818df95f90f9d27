"""USD: the library's own validators, and what they leave out: topology, nesting, physics."""

from __future__ import annotations

import zipfile
from collections import Counter
from pathlib import Path

import mujoco
import numpy as np
import pytest
from pxr import Gf, Tf, Usd, UsdGeom, UsdLux, UsdPhysics, UsdShade, UsdValidation

from robolayout.assets import category_of, parts
from robolayout.export import EXPORTERS, Options, export
from robolayout.export._exporter import is_movable, mass
from robolayout.export._mujoco import load
from robolayout.export.mjcf import build
from robolayout.scene import DEFAULT_AGENT, Asset, Layout, Pose, Room, Scene

ROUTES = {"double_bed-0": [(4.0, 0.5), (2.6, 1.0), (2.5, 1.5)]}


def complaints(stage: Usd.Stage) -> list[str]:
    """Run every validator that the library has."""
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    return [f"{error.GetName()}: {error.GetMessage()}" for error in context.Validate(stage)]


def opened(scene: Scene, layout: Layout, folder: Path, name: str = "usd") -> Usd.Stage:
    options = Options(agent=DEFAULT_AGENT, routes=ROUTES)
    return Usd.Stage.Open(str(export(scene, layout, name, folder=folder, options=options)))


@pytest.fixture(scope="module")
def stage(scene: Scene, layout: Layout, tmp_path_factory: pytest.TempPathFactory) -> Usd.Stage:
    return opened(scene, layout, tmp_path_factory.mktemp("usd"))


@pytest.mark.parametrize("name", ["usd", "usdz"])
def test_the_library_finds_nothing_to_complain_about(name: str, scene: Scene, layout: Layout, tmp_path: Path) -> None:
    assert complaints(opened(scene, layout, tmp_path, name)) == []


def prims(stage: Usd.Stage) -> list[Usd.Prim]:
    """Return all prims, those in instances too."""
    return list(Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()))


def nested(stage: Usd.Stage) -> list[str]:
    """Return the paths of rigid bodies below other rigid bodies, which simulators refuse and the library overlooks."""
    paths = [prim.GetPath() for prim in prims(stage) if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    return [str(inner) for inner in paths for outer in paths if inner != outer and inner.HasPrefix(outer)]


def test_the_checks_do_find_faults() -> None:
    broken = Usd.Stage.CreateInMemory()
    for path in ("/A", "/A/B"):
        UsdPhysics.RigidBodyAPI.Apply(UsdGeom.Xform.Define(broken, path).GetPrim())
    assert "MissingDefaultPrim" in " ".join(complaints(broken))
    assert nested(broken) == ["/A/B"]


def test_units_axes_and_gravity(stage: Usd.Stage) -> None:
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert UsdPhysics.GetStageKilogramsPerUnit(stage) == 1.0
    assert stage.GetDefaultPrim().GetPath() == "/World"
    gravity = UsdPhysics.Scene(stage.GetPrimAtPath("/World/Physics"))
    assert gravity.GetGravityMagnitudeAttr().Get() == pytest.approx(9.81)


def test_no_rigid_body_is_nested_or_in_an_instance_and_each_has_a_mass(stage: Usd.Stage, scene: Scene) -> None:
    bodies = [prim for prim in prims(stage) if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    assert nested(stage) == []
    assert not any(prim.IsInstanceProxy() for prim in bodies)  # simulators take colliders there, no bodies
    assert all(UsdPhysics.MassAPI(p).GetMassAttr().Get() > 0 for p in bodies)


def test_masses_and_inertias_are_those_of_mjcf(stage: Usd.Stage, scene: Scene, layout: Layout) -> None:
    model, _ = load(build(scene, layout, Options(), free=is_movable))
    names = {Tf.MakeValidIdentifier(model.body(i).name): i for i in range(model.nbody)}
    weights: dict[str, float] = {}
    for prim in prims(stage):
        if not prim.HasAPI(UsdPhysics.RigidBodyAPI) or "/Assets/" not in str(prim.GetPath()):
            continue
        thing, _, link = str(prim.GetPath()).removeprefix("/World/Assets/").partition("/")
        body = names[thing if link in ("", "body") else f"{thing}_{link}"]
        solid = UsdPhysics.MassAPI(prim)
        weight, middle = solid.GetMassAttr().Get(), solid.GetCenterOfMassAttr().Get()
        turn = Gf.Matrix3d(Gf.Rotation(solid.GetPrincipalAxesAttr().Get()))  # its rows are the axes
        axes, moments = np.array(turn).T, np.array(solid.GetDiagonalInertiaAttr().Get())
        rotation = np.zeros(9)
        mujoco.mju_quat2Mat(rotation, model.body_iquat[body])
        known = rotation.reshape(3, 3) @ np.diag(model.body_inertia[body]) @ rotation.reshape(3, 3).T
        assert weight == pytest.approx(model.body_mass[body], rel=1e-5), prim
        assert tuple(middle) == pytest.approx(model.body_ipos[body], abs=1e-5), prim
        assert np.allclose(axes @ np.diag(moments) @ axes.T, known, rtol=1e-3, atol=1e-6), prim
        weights[thing] = weights.get(thing, 0.0) + weight
    assert {"table_lamp_0", "dining_chair_0", "potted_plant_0", "wardrobe_0"} <= set(weights)
    for name, asset in scene.by_name.items():
        assert weights.get(name.replace("-", "_"), mass(asset)) == pytest.approx(mass(asset), rel=1e-5)


def test_walls_and_fixed_things_are_colliders_without_a_body(stage: Usd.Stage) -> None:
    for path in ("/World/Room/body", "/World/Assets/double_bed_0", "/World/Assets/picture_0"):
        inside = list(Usd.PrimRange(stage.GetPrimAtPath(path), Usd.TraverseInstanceProxies()))
        assert not any(prim.HasAPI(UsdPhysics.RigidBodyAPI) for prim in inside)
        assert any(prim.HasAPI(UsdPhysics.CollisionAPI) for prim in inside)


def test_things_that_are_alike_are_one_file_and_one_prototype(tmp_path: Path) -> None:
    chairs = tuple(Asset(f"dining_chair-{i}", "dining chair", (0.5, 0.45, 0.86)) for i in range(4))
    room = Room(((0, 0), (4, 0), (4, 3), (0, 3)), 2.5)
    layout = Layout({chair.name: Pose(0.6 + 0.8 * i, 1.5, 0.43, 0.2 * i) for i, chair in enumerate(chairs)})
    path = export(Scene(room, chairs, name="a"), layout, "usd", folder=tmp_path)
    export(Scene(room, chairs[:2], name="b"), layout_of(layout, chairs[:2]), "usd", folder=tmp_path)
    files = sorted(file.stem.rpartition("-")[0] for file in (tmp_path / "things").glob("*.usdc"))
    assert files == ["chair", "room"]  # of both rooms
    stage = Usd.Stage.Open(str(path))
    assert len({prim.GetPrototype().GetPath() for prim in stage.GetPrimAtPath("/World/Assets").GetChildren()}) == 1


def layout_of(layout: Layout, assets: tuple[Asset, ...]) -> Layout:
    return Layout({asset.name: layout[asset.name] for asset in assets})


def test_without_payloads_a_room_has_bounds_and_names(scene: Scene, layout: Layout, tmp_path: Path) -> None:
    path = export(scene, layout, "usd", folder=tmp_path)
    stage = Usd.Stage.Open(str(path), Usd.Stage.LoadNone)
    bed = stage.GetPrimAtPath("/World/Assets/double_bed_0")
    assert not bed.GetChildren() and bed.GetDisplayName() == "double_bed-0"
    low, high = UsdGeom.ModelAPI(bed).GetExtentsHint()
    assert tuple(high - low) == pytest.approx(scene.by_name["double_bed-0"].size, abs=1e-6)


def test_doors_stand_as_their_variant_says(scene: Scene, layout: Layout, tmp_path: Path) -> None:
    path = export(scene, layout, "usd", folder=tmp_path, options=Options(leaves="open"))
    stage = Usd.Stage.Open(str(path))
    assert stage.GetPrimAtPath("/World/Room").GetVariantSet("doors").GetVariantSelection() == "open"
    wardrobe = stage.GetPrimAtPath("/World/Assets/wardrobe_0")
    doors = wardrobe.GetVariantSet("doors")
    links = [prim for prim in wardrobe.GetChildren() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]

    def reach() -> float:
        cache = UsdGeom.BBoxCache(0, [UsdGeom.Tokens.default_])
        return max(cache.ComputeUntransformedBound(wardrobe).ComputeAlignedRange().GetMax()[0], 0)

    assert doors.GetVariantNames() == ["open", "shut"] and doors.GetVariantSelection() == "shut" and len(links) > 1
    assert reach() == pytest.approx(0.3, abs=1e-4)
    doors.SetVariantSelection("open")
    assert reach() > 0.6
    assert complaints(stage) == []


def test_every_mesh_is_sound(stage: Usd.Stage) -> None:
    meshes = [UsdGeom.Mesh(prim) for prim in prims(stage) if prim.IsA(UsdGeom.Mesh)]
    assert len(meshes) > 20
    for mesh in meshes:
        path, points = mesh.GetPath(), mesh.GetPointsAttr().Get()
        indices, counts = mesh.GetFaceVertexIndicesAttr().Get(), mesh.GetFaceVertexCountsAttr().Get()
        assert set(counts) == {3}, path
        assert sum(counts) == len(indices) == len(mesh.GetNormalsAttr().Get()), path
        assert min(indices) >= 0 and max(indices) < len(points), path
        triangles = [tuple(indices[i : i + 3]) for i in range(0, len(indices), 3)]
        assert all(len(set(triangle)) == 3 for triangle in triangles), path
        assert all(abs(Gf.GetLength(normal) - 1) < 1e-4 for normal in mesh.GetNormalsAttr().Get()), path
        edges = Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
        closed = all(edges[edge[::-1]] == count == 1 for edge, count in edges.items())
        assert closed or mesh.GetDoubleSidedAttr().Get(), f"{path} has open or doubled edges"
        low, high = mesh.GetExtentAttr().Get()
        assert all(low[k] <= min(p[k] for p in points) + 1e-6 for k in range(3)), path
        assert all(high[k] >= max(p[k] for p in points) - 1e-6 for k in range(3)), path


def test_every_mesh_has_a_preview_surface(stage: Usd.Stage) -> None:
    for prim in prims(stage):
        if prim.IsA(UsdGeom.Mesh):
            material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
            shader, _, _ = material.ComputeSurfaceSource()
            assert shader.GetIdAttr().Get() == "UsdPreviewSurface"


def test_labels_and_friction_follow_the_category(stage: Usd.Stage, scene: Scene) -> None:
    prim = stage.GetPrimAtPath("/World/Assets/dining_chair_0")
    assert "dining chair" in prim.GetAttribute("semantics:labels:class").Get()
    assert list(prim.GetAttribute("semantics:labels:instance").Get()) == ["dining_chair-0"]
    material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")
    friction = UsdPhysics.MaterialAPI(material.GetPrim()).GetDynamicFrictionAttr().Get()
    assert friction == pytest.approx(category_of(scene.by_name["dining_chair-0"]).friction)


def test_routes_are_guides(stage: Usd.Stage) -> None:
    curve = UsdGeom.BasisCurves(stage.GetPrimAtPath("/World/Routes/double_bed_0"))
    points = [coordinate for point in curve.GetPointsAttr().Get() for coordinate in tuple(point)[:2]]
    assert points == pytest.approx([coordinate for point in ROUTES["double_bed-0"] for coordinate in point])
    assert curve.GetPurposeAttr().Get() == "guide"
    assert stage.GetPrimAtPath("/World/Routes").GetAttribute("robolayout:agent").Get() == "disc"


def test_the_package_is_aligned_and_uncompressed(scene: Scene, layout: Layout, tmp_path: Path) -> None:
    data = EXPORTERS["usdz"].write(scene, layout, Options())
    path = tmp_path / "x.usdz"
    path.write_bytes(data)
    with zipfile.ZipFile(path) as package:
        entries = package.infolist()
    starts = [entry.header_offset + 30 + len(entry.filename) + len(entry.extra) for entry in entries]
    assert {entry.compress_type for entry in entries} == {zipfile.ZIP_STORED}
    assert all(start % 64 == 0 for start in starts)
    kinds = {".usdc": b"PXR-USDC", ".jpeg": b"\xff\xd8\xff"}
    assert entries[0].filename == "scene.usdc"
    for entry, start in zip(entries, starts, strict=True):
        assert data[start : start + 8].startswith(kinds[Path(entry.filename).suffix])


@pytest.mark.parametrize("name", ["usd", "usdz"])
def test_the_textures_that_looks_name_are_there(name: str, scene: Scene, layout: Layout, tmp_path: Path) -> None:
    stage = Usd.Stage.Open(str(export(scene, layout, name, folder=tmp_path)))
    shaders = [UsdShade.Shader(prim) for prim in prims(stage) if prim.IsA(UsdShade.Shader)]
    named = [s.GetInput("file").Get() for s in shaders if s.GetIdAttr().Get() == "UsdUVTexture"]
    assert len({path.resolvedPath for path in named}) > 1
    assert all(path.resolvedPath for path in named)


def test_lamps_give_light_and_a_camera_sees_the_room(stage: Usd.Stage, scene: Scene, layout: Layout) -> None:
    lights = [prim for prim in prims(stage) if prim.IsA(UsdLux.SphereLight)]
    lamps = [asset.name for asset in scene.assets if "lamp" in asset.category and asset.name in layout]
    assert len(lights) == len(lamps) > 0
    frustum = UsdGeom.Camera(stage.GetPrimAtPath("/World/Camera")).GetCamera(0).frustum
    corners = [(x, y, z) for x, y in scene.room.vertices for z in (0.0, scene.room.wall_height)]
    assert all(frustum.Intersects(Gf.Vec3d(*corner)) for corner in corners)


def test_doors_and_drawers_hang_on_joints(stage: Usd.Stage, scene: Scene) -> None:
    joints = [prim for prim in prims(stage) if prim.IsA(UsdPhysics.Joint)]
    moving = {asset.name: {part.joint.name for part in parts(asset) if part.joint} for asset in scene.assets}
    fixed = [prim for prim in joints if prim.IsA(UsdPhysics.FixedJoint)]
    assert len(joints) - len(fixed) == sum(map(len, moving.values())) + len(scene.room.doors)
    roots = [prim for prim in prims(stage) if prim.HasAPI(UsdPhysics.ArticulationRootAPI)]
    assert {prim.GetAttribute("robolayout:name").Get() for prim in roots} == {name for name in moving if moving[name]}
    assert len(fixed) == sum(not prim.GetAttribute("robolayout:movable").Get() for prim in roots)
    for prim in joints:
        joint = UsdPhysics.Joint(prim)
        (still,), (link,) = joint.GetBody0Rel().GetTargets(), joint.GetBody1Rel().GetTargets()
        assert stage.GetPrimAtPath(link).HasAPI(UsdPhysics.RigidBodyAPI)
        ends = [
            UsdGeom.Xformable(stage.GetPrimAtPath(path)).ComputeLocalToWorldTransform(0).Transform(Gf.Vec3d(at.Get()))
            for path, at in ((still, joint.GetLocalPos0Attr()), (link, joint.GetLocalPos1Attr()))
        ]
        assert Gf.GetLength(ends[0] - ends[1]) < 1e-5  # where they are held together, they meet
        if prim in fixed:
            continue
        typed = UsdPhysics.RevoluteJoint(prim) or UsdPhysics.PrismaticJoint(prim)
        assert typed.GetLowerLimitAttr().Get() <= 0 < typed.GetUpperLimitAttr().Get()
