"""Builds the USD stage; the only file that imports USD's library, loaded when a stage is asked for."""

# USD's modules carry no types:
# pyright: reportAttributeAccessIssue=false, reportUnknownParameterType=false
from __future__ import annotations

import hashlib
import math
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Gf, Kind, Sdf, Tf, Usd, UsdGeom, UsdLux, UsdPhysics, UsdSemantics, UsdShade, Vt

from robolayout._text import xml
from robolayout.assets import Joint, Material, Part, category_of, parts, room_parts
from robolayout.assets.textures import media_type, picture
from robolayout.export._exporter import Options, is_movable, is_trim, mass, placed
from robolayout.export._mesh import base_color, linear, volume, welded
from robolayout.export._scenery import ASPECT, FIELD, LUMENS, WARM, lamp, overview
from robolayout.export.mjcf import LEAF_MASS, SMALLEST_VOLUME
from robolayout.scene import Asset, Layout, Pose, Room, Scene

BULB = 0.05
"""Radius in metres of a lamp's light."""

WORLD, ROOM, ASSETS, LOOKS, ROUTES = "/World", "/World/Room", "/World/Assets", "/World/Looks", "/World/Routes"
ROUTE_WIDTH = 0.03
"""Width in metres that routes are drawn with."""

Row = tuple[str, tuple[float, float, float], float, tuple[float, float, float]]
"""Name, position, degrees about z, size."""


def build(scene: Scene, layout: Layout, options: Options, pictures: dict[str, bytes] | None = None) -> Any:
    """Return a stage in memory with the room, all placed assets, materials, physics, lights, a camera and routes.

    The textures that it refers to are put into `pictures`, by their names beside it; without it there are only colours.
    """
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    UsdPhysics.SetStageKilogramsPerUnit(stage, 1.0)
    world = UsdGeom.Xform.Define(stage, WORLD).GetPrim()
    stage.SetDefaultPrim(world)
    Usd.ModelAPI(world).SetKind(Kind.Tokens.assembly)
    physics = UsdPhysics.Scene.Define(stage, f"{WORLD}/Physics")
    physics.CreateGravityDirectionAttr(Gf.Vec3f(0, 0, -1))
    physics.CreateGravityMagnitudeAttr(9.81)
    for path in (ROOM, ASSETS):
        group = UsdGeom.Xform.Define(stage, path).GetPrim()
        Usd.ModelAPI(group).SetKind(Kind.Tokens.component if path == ROOM else Kind.Tokens.group)
    UsdGeom.Scope.Define(stage, LOOKS)
    builder = _Builder(stage, pictures)
    room = room_parts(scene.room, seed=options.seed)
    builder.meshes(ROOM, builder.hung(ROOM, tuple(part for part in room if not is_trim(part))), movable=False)
    builder.meshes(ROOM, tuple(part for part in room if is_trim(part)), movable=False, collides=False)
    for asset, pose in placed(scene, layout):
        builder.asset(asset, pose, movable=is_movable(asset, scene, layout), seed=options.seed)
    _camera(stage, scene.room)
    _routes(stage, options)
    return stage


class _Builder:
    """Adds assets to a stage; equal materials are defined once, and every name becomes a legal, unique prim name."""

    def __init__(self, stage: Any, pictures: dict[str, bytes] | None = None) -> None:
        self.stage = stage
        self.pictures = pictures
        self.looks: dict[object, Any] = {}
        self.taken: set[str] = set()

    def path(self, folder: str, name: str) -> str:
        """Return a new prim path below a folder for a name of ours."""
        stem = f"{folder}/{Tf.MakeValidIdentifier(name)}"
        path, number = stem, 2
        while path in self.taken:
            path, number = f"{stem}_{number}", number + 1
        self.taken.add(path)
        return path

    def asset(self, asset: Asset, pose: Pose, *, movable: bool, seed: int) -> None:
        """Add one asset: its place, its facts, its physics and its parts."""
        name, words = xml(asset.name), xml(asset.category)
        form = UsdGeom.Xform.Define(self.stage, self.path(ASSETS, name))
        prim = form.GetPrim()
        form.AddTranslateOp().Set(Gf.Vec3d(pose.x, pose.y, pose.z))
        form.AddRotateZOp(UsdGeom.XformOp.PrecisionDouble).Set(math.degrees(pose.yaw))
        Usd.ModelAPI(prim).SetKind(Kind.Tokens.component)
        prim.SetDisplayName(name)
        prim.SetDocumentation(xml(asset.description) or words)
        _custom(prim, "name", Sdf.ValueTypeNames.String, name)
        _custom(prim, "category", Sdf.ValueTypeNames.String, words)
        _custom(prim, "size", Sdf.ValueTypeNames.Double3, Gf.Vec3d(*asset.size))
        _custom(prim, "movable", Sdf.ValueTypeNames.Bool, movable)
        UsdSemantics.LabelsAPI.Apply(prim, "class").CreateLabelsAttr([category_of(asset).name, words])
        UsdSemantics.LabelsAPI.Apply(prim, "instance").CreateLabelsAttr([name])
        if movable:
            UsdPhysics.RigidBodyAPI.Apply(prim)
            UsdPhysics.MassAPI.Apply(prim).CreateMassAttr(mass(asset))
        self.bind(prim, self.friction(category_of(asset).friction), "physics")
        folder, pieces = str(prim.GetPath()), parts(asset, seed=seed)
        still = pieces if movable else self.hung(folder, pieces)  # no rigid body may hold another one
        self.meshes(folder, still, movable=movable, collides=not asset.is_flat)
        if (bulb := lamp(pieces)) is not None:
            light = UsdLux.SphereLight.Define(self.stage, self.path(folder, "light"))
            light.CreateRadiusAttr(BULB)
            light.CreateIntensityAttr(LUMENS / (2 * math.pi * BULB) ** 2)
            light.CreateColorAttr(Gf.Vec3f(*WARM))
            light.AddTranslateOp().Set(Gf.Vec3d(*bulb))

    def hung(self, folder: str, pieces: tuple[Part, ...]) -> tuple[Part, ...]:
        """Add a rigid body and its joint for each group of parts that moves, and return the parts that do not."""
        for joint in dict.fromkeys(part.joint for part in pieces if part.joint is not None):
            group = tuple(part for part in pieces if part.joint == joint)
            prim = UsdGeom.Xform.Define(self.stage, self.path(folder, joint.name)).GetPrim()
            UsdPhysics.RigidBodyAPI.Apply(prim)
            UsdPhysics.MassAPI.Apply(prim).CreateMassAttr(
                LEAF_MASS * sum(max(volume(part), SMALLEST_VOLUME) for part in group)
            )
            self.meshes(str(prim.GetPath()), group, movable=True)
            self.joint(self.path(folder, f"{joint.name} joint"), joint, folder, prim)
        return tuple(part for part in pieces if part.joint is None)

    def joint(self, path: str, joint: Joint, still: str, moving: Any) -> None:
        """Add a joint between what stays and what moves; its x axis is the joint's axis."""
        hinge = joint.kind == "hinge"
        made = (UsdPhysics.RevoluteJoint if hinge else UsdPhysics.PrismaticJoint).Define(self.stage, path)
        made.CreateBody0Rel().SetTargets([still])
        made.CreateBody1Rel().SetTargets([moving.GetPath()])
        made.CreateAxisAttr("X")
        turn = Gf.Quatf(Gf.Rotation(Gf.Vec3d(1, 0, 0), Gf.Vec3d(*joint.axis)).GetQuat())
        for place, way in (
            (made.CreateLocalPos0Attr, made.CreateLocalRot0Attr),
            (made.CreateLocalPos1Attr, made.CreateLocalRot1Attr),
        ):
            place(Gf.Vec3f(*joint.at))
            way(turn)
        low, high = (math.degrees(end) if hinge else end for end in joint.span)
        made.CreateLowerLimitAttr(low)
        made.CreateUpperLimitAttr(high)

    def meshes(self, folder: str, pieces: tuple[Part, ...], *, movable: bool, collides: bool = True) -> None:
        """Add one mesh for each part, each its own collider."""
        for part in pieces:
            shape = welded(part)
            if not len(shape.indices):
                continue
            mesh = UsdGeom.Mesh.Define(self.stage, self.path(folder, part.name))
            points = Vt.Vec3fArray.FromNumpy(shape.positions.astype(np.float32))
            mesh.CreatePointsAttr(points)
            mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(shape.indices), 3, np.int32)))
            mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(shape.indices.reshape(-1).astype(np.int32)))
            mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(shape.normals.astype(np.float32)))
            mesh.SetNormalsInterpolation(UsdGeom.Tokens.faceVarying)
            mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
            mesh.CreateExtentAttr(UsdGeom.PointBased.ComputeExtent(points))
            mesh.CreateDoubleSidedAttr(not part.convex)
            if self.pictures is not None and part.material.texture is not None:
                places = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(
                    "st", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.faceVarying
                )
                places.Set(Vt.Vec2fArray.FromNumpy((shape.uvs * (1, -1) + (0, 1)).astype(np.float32)))
            prim = mesh.GetPrim()
            self.bind(prim, self.look(part.material))
            if collides:
                UsdPhysics.CollisionAPI.Apply(prim)
                collider = UsdPhysics.MeshCollisionAPI.Apply(prim)
                collider.CreateApproximationAttr(_approximation(part, movable))

    def bind(self, prim: Any, material: Any, purpose: str = "") -> None:
        """Bind a material to a prim."""
        binding = UsdShade.MaterialBindingAPI.Apply(prim)
        weaker = UsdShade.Tokens.fallbackStrength
        binding.Bind(material, weaker, purpose) if purpose else binding.Bind(material)

    def look(self, material: Material) -> Any:
        """Return the Preview Surface material of a look."""
        if material not in self.looks:
            path = self.path(LOOKS, material.name)
            look = UsdShade.Material.Define(self.stage, path)
            shader = UsdShade.Shader.Define(self.stage, f"{path}/Surface")
            shader.CreateIdAttr("UsdPreviewSurface")
            for name, kind, value in (
                ("diffuseColor", Sdf.ValueTypeNames.Color3f, Gf.Vec3f(*linear(material.color))),
                ("roughness", Sdf.ValueTypeNames.Float, material.roughness),
                ("metallic", Sdf.ValueTypeNames.Float, material.metallic),
                ("opacity", Sdf.ValueTypeNames.Float, material.opacity),
            ):
                shader.CreateInput(name, kind).Set(value)
            if material.glow:
                emitted = Gf.Vec3f(*(channel * material.glow for channel in linear(material.color)))
                shader.CreateInput("emissiveColor", Sdf.ValueTypeNames.Color3f).Set(emitted)
            if self.pictures is not None and material.texture is not None:
                self.textured(path, material, shader, self.pictures)
            look.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
            self.looks[material] = look
        return self.looks[material]

    def textured(self, path: str, material: Material, shader: Any, pictures: dict[str, bytes]) -> None:
        """Let a look's colour come from its texture, and keep that picture."""
        data = picture(material.texture or b"")
        name = f"textures/{hashlib.sha256(data).hexdigest()[:16]}.{media_type(data).partition('/')[2]}"
        pictures[name] = data
        place = UsdShade.Shader.Define(self.stage, f"{path}/Place")
        place.CreateIdAttr("UsdPrimvarReader_float2")
        place.CreateInput("varname", Sdf.ValueTypeNames.String).Set("st")
        found = UsdShade.Shader.Define(self.stage, f"{path}/Texture")
        found.CreateIdAttr("UsdUVTexture")
        found.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(Sdf.AssetPath(name))
        found.CreateInput("sourceColorSpace", Sdf.ValueTypeNames.Token).Set("sRGB")
        found.CreateInput("scale", Sdf.ValueTypeNames.Float4).Set(Gf.Vec4f(*base_color(material), 1.0))
        for side in ("wrapS", "wrapT"):
            found.CreateInput(side, Sdf.ValueTypeNames.Token).Set("repeat")
        result = place.CreateOutput("result", Sdf.ValueTypeNames.Float2)
        found.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(result)
        color = found.CreateOutput("rgb", Sdf.ValueTypeNames.Float3)
        shader.GetInput("diffuseColor").ConnectToSource(color)

    def friction(self, value: float) -> Any:
        """Return the physics material with a friction coefficient."""
        if value not in self.looks:
            look = UsdShade.Material.Define(self.stage, self.path(LOOKS, f"friction_{round(value * 100)}"))
            physics = UsdPhysics.MaterialAPI.Apply(look.GetPrim())
            physics.CreateStaticFrictionAttr(value)
            physics.CreateDynamicFrictionAttr(value)
            physics.CreateRestitutionAttr(0.0)
            self.looks[value] = look
        return self.looks[value]


def _camera(stage: Any, room: Room) -> None:
    """Add a camera that sees the whole room."""
    view = overview(room)
    camera = UsdGeom.Camera.Define(stage, f"{WORLD}/Camera")
    height = camera.GetVerticalApertureAttr().Get()
    camera.GetHorizontalApertureAttr().Set(height * ASPECT)
    camera.GetFocalLengthAttr().Set(height / 2 / math.tan(FIELD / 2))
    matrix = np.eye(4)
    matrix[:3, :3], matrix[3, :3] = view.rotation.T, view.position
    camera.AddTransformOp().Set(Gf.Matrix4d(matrix.tolist()))


def _approximation(part: Part, movable: bool) -> str:
    """Return how a simulator makes a collider of a part: convex parts are their own hull."""
    if part.convex:
        return UsdPhysics.Tokens.convexHull
    return UsdPhysics.Tokens.convexDecomposition if movable else UsdPhysics.Tokens.none


def _custom(prim: Any, name: str, kind: Any, value: object) -> None:
    """Set one attribute of ours on a prim."""
    prim.CreateAttribute(f"robolayout:{name}", kind, True, Sdf.VariabilityUniform).Set(value)


def _routes(stage: Any, options: Options) -> None:
    """Add the agent's routes as guide curves on the floor."""
    if not options.routes:
        return
    scope = UsdGeom.Scope.Define(stage, ROUTES).GetPrim()
    if options.agent is not None:
        _custom(scope, "agent", Sdf.ValueTypeNames.String, xml(options.agent.name))
    taken = _Builder(stage)
    for name, line in options.routes.items():
        if len(line) < 2:
            continue
        curve = UsdGeom.BasisCurves.Define(stage, taken.path(ROUTES, xml(name)))
        points = Vt.Vec3fArray([Gf.Vec3f(float(x), float(y), 0.0) for x, y in line])
        curve.CreateTypeAttr(UsdGeom.Tokens.linear)
        curve.CreatePointsAttr(points)
        curve.CreateCurveVertexCountsAttr([len(line)])
        curve.CreateWidthsAttr([ROUTE_WIDTH])
        curve.SetWidthsInterpolation(UsdGeom.Tokens.constant)
        curve.CreateExtentAttr(UsdGeom.Curves.ComputeExtent(points, Vt.FloatArray([ROUTE_WIDTH])))
        curve.CreatePurposeAttr(UsdGeom.Tokens.guide)
        _custom(curve.GetPrim(), "name", Sdf.ValueTypeNames.String, xml(name))


def assets_of(path: Path) -> list[Row]:
    """Return what a stage on disk says about its assets.

    Raises:
        RuntimeError: The stage cannot be opened, or holds no `/World/Assets`.
    """
    stage = Usd.Stage.Open(str(path))
    folder = stage.GetPrimAtPath(ASSETS) if stage else None
    if not folder:
        raise RuntimeError(f"it has no {ASSETS}")
    rows: list[Row] = []
    for prim in folder.GetChildren():
        x, y, z = prim.GetAttribute("xformOp:translate").Get()
        depth, width, height = prim.GetAttribute("robolayout:size").Get()
        degrees = prim.GetAttribute("xformOp:rotateZ").Get()
        rows.append((str(prim.GetAttribute("robolayout:name").Get()), (x, y, z), degrees, (depth, width, height)))
    return rows
