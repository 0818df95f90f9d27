"""USD: the library's own validators, and what they leave out: topology, nesting, physics."""

from __future__ import annotations

import zipfile
from collections import Counter
from pathlib import Path

import pytest
from pxr import Gf, Usd, UsdGeom, UsdLux, UsdPhysics, UsdShade, UsdValidation

from robolayout.assets import category_of, parts
from robolayout.export import EXPORTERS, Options, export
from robolayout.export._exporter import mass
from robolayout.scene import DEFAULT_AGENT, Layout, Scene

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


def nested(stage: Usd.Stage) -> list[str]:
    """Return the paths of rigid bodies below other rigid bodies, which simulators refuse and the library overlooks."""
    paths = [prim.GetPath() for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
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


def test_no_rigid_body_is_nested_and_each_has_a_mass(stage: Usd.Stage, scene: Scene) -> None:
    bodies = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    assert nested(stage) == []
    whole = [p for p in bodies if p.HasAttribute("robolayout:name")]
    weights = {p.GetAttribute("robolayout:name").Get(): UsdPhysics.MassAPI(p).GetMassAttr().Get() for p in whole}
    assert all(UsdPhysics.MassAPI(p).GetMassAttr().Get() > 0 for p in bodies)
    assert set(weights) == {"table_lamp-0", "dining_chair-0", "potted_plant-0"}
    for name, weight in weights.items():
        assert weight == pytest.approx(mass(scene.by_name[name]), rel=1e-6)
        assert 0.2 < weight < 60


def test_walls_and_fixed_things_are_colliders_without_a_body(stage: Usd.Stage) -> None:
    for path in ("/World/Room", "/World/Assets/wardrobe_0", "/World/Assets/picture_0"):
        prim = stage.GetPrimAtPath(path)
        assert not prim.HasAPI(UsdPhysics.RigidBodyAPI)
        assert any(child.HasAPI(UsdPhysics.CollisionAPI) for child in Usd.PrimRange(prim))


def test_every_mesh_is_sound(stage: Usd.Stage) -> None:
    meshes = [UsdGeom.Mesh(prim) for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
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
    for prim in stage.Traverse():
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
    assert data[starts[0] : starts[0] + 8] == b"PXR-USDC"
    assert all(data[start : start + 3] == b"\xff\xd8\xff" for start in starts[1:])


def test_the_package_brings_the_textures_that_its_looks_name(scene: Scene, layout: Layout, tmp_path: Path) -> None:
    path = tmp_path / "x.usdz"
    path.write_bytes(EXPORTERS["usdz"].write(scene, layout, Options()))
    stage = Usd.Stage.Open(str(path))
    with zipfile.ZipFile(path) as package:
        inside = set(package.namelist()[1:])
    shaders = [UsdShade.Shader(prim) for prim in stage.Traverse() if prim.IsA(UsdShade.Shader)]
    named = {shader.GetInput("file").Get().path for shader in shaders if shader.GetIdAttr().Get() == "UsdUVTexture"}
    assert named == inside
    assert len(inside) > 1


def test_lamps_give_light_and_a_camera_sees_the_room(stage: Usd.Stage, scene: Scene, layout: Layout) -> None:
    lights = [prim for prim in stage.Traverse() if prim.IsA(UsdLux.SphereLight)]
    lamps = [asset.name for asset in scene.assets if "lamp" in asset.category and asset.name in layout]
    assert len(lights) == len(lamps) > 0
    frustum = UsdGeom.Camera(stage.GetPrimAtPath("/World/Camera")).GetCamera(0).frustum
    corners = [(x, y, z) for x, y in scene.room.vertices for z in (0.0, scene.room.wall_height)]
    assert all(frustum.Intersects(Gf.Vec3d(*corner)) for corner in corners)


def test_doors_and_drawers_hang_on_joints(stage: Usd.Stage, scene: Scene) -> None:
    joints = [prim for prim in stage.Traverse() if prim.IsA(UsdPhysics.Joint)]
    expected = {
        f"{asset.name} {part.joint.name}"
        for asset in scene.assets
        for part in parts(asset)
        if part.joint is not None and not category_of(asset).movable
    }
    assert len(joints) == len(expected) + len(scene.room.doors)
    for prim in joints:
        joint = UsdPhysics.Joint(prim)
        (still,), (moving,) = joint.GetBody0Rel().GetTargets(), joint.GetBody1Rel().GetTargets()
        assert not stage.GetPrimAtPath(still).HasAPI(UsdPhysics.RigidBodyAPI)
        assert stage.GetPrimAtPath(moving).HasAPI(UsdPhysics.RigidBodyAPI)
        typed = UsdPhysics.RevoluteJoint(prim) or UsdPhysics.PrismaticJoint(prim)
        assert typed.GetLowerLimitAttr().Get() <= 0 < typed.GetUpperLimitAttr().Get()
        turned = Gf.Rotation(Gf.Quatd(joint.GetLocalRot0Attr().Get())).TransformDir(Gf.Vec3d(1, 0, 0))
        assert max(abs(part) for part in turned) == pytest.approx(1.0, abs=1e-6)
