"""Builds USD stages; the only file that imports USD's library, loaded when a stage is asked for.

A room is a layer of places, which refers to one layer for each kind of thing (`things/<kind>.usdc`).
"""

# USD's modules carry no types:
# pyright: reportAttributeAccessIssue=false, reportUnknownParameterType=false
from __future__ import annotations

import hashlib
import math
import tempfile
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from pxr import Gf, Kind, Sdf, Tf, Usd, UsdGeom, UsdLux, UsdPhysics, UsdSemantics, UsdShade, Vt

from robolayout._text import xml
from robolayout.assets import Joint, Material, Part, category_of
from robolayout.assets.textures import media_type, picture
from robolayout.export._bodies import BODIES, BodyLink, BodyTree, things
from robolayout.export._exporter import Options, Rows, unique
from robolayout.export._mesh import DrawnSurface, FloatArray, base_color, linear, quaternion, welded
from robolayout.export._scenery import SCENERY, lamp, overview
from robolayout.scene import Asset, Layout, Pose, Room, Scene

WORLD, ROOM, ASSETS, ROUTES = "/World", "/World/Room", "/World/Assets", "/World/Routes"
THING, SHAPES = "/Thing", "/Shapes"
Types = Sdf.ValueTypeNames
DOORS = "doors"  # variant set of what has joints: "shut", "open", and "drawn" where it is drawn half-open


def room_stage(scene: Scene, layout: Layout, options: Options) -> tuple[Any, dict[str, bytes]]:
    """Return a stage in memory, nothing loaded, with the places of the room and of all placed assets, gravity, a camera and
    routes; and the layers that it refers to with their textures, by their paths from its folder."""
    stage = _stage(WORLD, Kind.Tokens.assembly)
    physics = UsdPhysics.Scene.Define(stage, f"{WORLD}/Physics")
    physics.CreateGravityDirectionAttr(Gf.Vec3f(0, 0, -1))
    physics.CreateGravityMagnitudeAttr(9.81)
    rows = things(scene, layout, replace(options, leaves="swinging"))  # variants say how doors stand
    files: dict[str, bytes] = {}
    room = _payload(stage, ROOM, next(rows), files)
    if scene.room.doors and options.leaves != "swinging":
        room.GetVariantSets().GetVariantSet(DOORS).SetVariantSelection(options.leaves)
    group = UsdGeom.Xform.Define(stage, ASSETS).GetPrim()
    Usd.ModelAPI(group).SetKind(Kind.Tokens.group)
    taken: set[str] = set()
    for thing in rows:
        prim = _payload(stage, _free(ASSETS, xml(thing.name), taken), thing, files)
        form = UsdGeom.Xformable(prim)
        form.AddTranslateOp().Set(Gf.Vec3d(thing.pose.x, thing.pose.y, thing.pose.z))
        form.AddRotateZOp(UsdGeom.XformOp.PrecisionDouble).Set(math.degrees(thing.pose.yaw))
        prim.SetInstanceable(len(thing.links) == 1)
        if thing.asset is not None:
            _described(prim, thing.asset, movable=thing.free)
    _camera(stage, scene.room)
    _routes(stage, options)
    return stage, files


def _described(prim: Any, asset: Asset, *, movable: bool) -> None:
    """Say what an asset is."""
    name = xml(asset.name)
    prim.SetDisplayName(name)
    prim.SetDocumentation(xml(asset.description) or xml(asset.category))
    _custom(prim, "name", Types.String, name)
    _custom(prim, "category", Types.String, xml(asset.category))
    _custom(prim, "size", Types.Double3, Gf.Vec3d(*asset.size))
    _custom(prim, "movable", Types.Bool, movable)
    UsdSemantics.LabelsAPI.Apply(prim, "instance").CreateLabelsAttr([name])


def binary(stage: Any) -> bytes:
    """Return the root layer of a stage as a binary file."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "layer.usdc"
        stage.GetRootLayer().Export(str(path))
        return path.read_bytes()


def _stage(root: str, kind: str) -> Any:
    """Return an empty stage in memory, z up, in metres and kilograms, with its default prim."""
    stage = Usd.Stage.CreateInMemory(Usd.Stage.LoadNone)
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    UsdPhysics.SetStageKilogramsPerUnit(stage, 1.0)
    prim = UsdGeom.Xform.Define(stage, root).GetPrim()
    stage.SetDefaultPrim(prim)
    Usd.ModelAPI(prim).SetKind(kind)
    return stage


def _payload(stage: Any, path: str, thing: BodyTree, files: dict[str, bytes]) -> Any:
    """Return a new prim whose content is the layer of a kind, which joins the files, with its bounds while that is not loaded."""
    file = f"things/{thing.kind}.usdc"
    if file not in files:
        files[file] = binary(_KindLayer(thing, files).stage)
    prim = UsdGeom.Xform.Define(stage, path).GetPrim()
    prim.GetPayloads().AddPayload(f"./{file}")
    Usd.ModelAPI(prim).SetKind(Kind.Tokens.component)
    points = np.concatenate([s.part.vertices + link.at for link in thing.links for s in link.shapes if s.seen])
    corners = np.array([points.min(axis=0), points.max(axis=0)], np.float32)
    UsdGeom.ModelAPI.Apply(prim).SetExtentsHint(Vt.Vec3fArray.FromNumpy(corners))
    return prim


def _free(folder: str, name: str, taken: set[str]) -> str:
    """Return a new prim path below a folder for a name of ours: legal and unique."""
    return unique(f"{folder}/{Tf.MakeValidIdentifier(name)}", taken)


class _KindLayer:
    """Writes one kind of thing: its parts, how they move and how they look.

    A thing without joints is one rigid body or none, and the room uses it as an instance. Otherwise every link is a rigid body
    (none in another), its shape an instance within the file, and the thing an articulation; what nobody can move is fixed to its place.
    """

    def __init__(self, thing: BodyTree, files: dict[str, bytes]) -> None:
        self.thing = thing
        self.files = files
        self.stage = _stage(THING, Kind.Tokens.component)
        self.looks: dict[object, Any] = {}
        self.taken: set[str] = set()
        root, asset, base = self.stage.GetPrimAtPath(THING), thing.asset, thing.links[0]
        if asset is not None:
            labels = dict.fromkeys((category_of(asset).name, xml(asset.category)))
            UsdSemantics.LabelsAPI.Apply(root, "class").CreateLabelsAttr(list(labels))
        if len(thing.links) > 1:
            self.linked()
        else:
            self.shape(THING, base)
            if thing.free:
                _rigid(root, base)
        bulb = lamp(tuple(shape.part for shape in base.shapes))
        if asset is not None and bulb is not None:
            light = UsdLux.SphereLight.Define(self.stage, _free(THING, "light", self.taken))
            light.CreateRadiusAttr(SCENERY.bulb)
            light.CreateIntensityAttr(SCENERY.lumens / (2 * math.pi * SCENERY.bulb) ** 2)
            light.CreateColorAttr(Gf.Vec3f(*SCENERY.warm))
            light.AddTranslateOp().Set(Gf.Vec3d(*bulb))

    def linked(self) -> None:
        """Add what stays and what moves as links, and the joints between them."""
        self.stage.CreateClassPrim(SHAPES)
        base = self.link("body", self.thing.links[0])
        if self.thing.asset is not None:
            UsdPhysics.ArticulationRootAPI.Apply(self.stage.GetPrimAtPath(THING))
            _rigid(base, self.thing.links[0])
            if not self.thing.free:
                path = _free(THING, "body joint", self.taken)
                _connect(UsdPhysics.FixedJoint.Define(self.stage, path), THING, base)
        links: dict[Joint, Any] = {}
        for link in self.thing.links:
            if link.joint is not None:
                prim = links[link.joint] = self.link(link.joint.name, link)
                _rigid(prim, link)
                self.joint(link.joint, base, prim)
        self.variants(links)

    def link(self, name: str, link: BodyLink) -> Any:
        """Add a link and return its prim; its shape is an instance."""
        prim = UsdGeom.Xform.Define(self.stage, _free(THING, name, self.taken)).GetPrim()
        path = _free(SHAPES, name, self.taken)
        UsdGeom.Xform.Define(self.stage, path)
        self.shape(path, link)
        shape = UsdGeom.Xform.Define(self.stage, f"{prim.GetPath()}/shape").GetPrim()
        shape.GetReferences().AddInternalReference(path)
        shape.SetInstanceable(True)
        return prim

    def joint(self, joint: Joint, still: Any, moving: Any) -> None:
        """Add a joint between what stays and what moves; its x axis is the joint's axis."""
        hinge = joint.kind == "hinge"
        path = _free(THING, f"{joint.name} joint", self.taken)
        made = (UsdPhysics.RevoluteJoint if hinge else UsdPhysics.PrismaticJoint).Define(self.stage, path)
        _connect(made, still.GetPath(), moving, joint)
        made.CreateAxisAttr("X")
        low, high = (math.degrees(end) if hinge else end for end in joint.span)
        made.CreateLowerLimitAttr(low)
        made.CreateUpperLimitAttr(high)

    def variants(self, links: dict[Joint, Any]) -> None:
        """Add the variants of what moves; the first is how it is drawn."""
        states = {"shut": 0, "open": 1}
        if any(joint.span[0] for joint in links):
            states = {"drawn": -1, **states}
        forms = {joint: UsdGeom.Xformable(link) for joint, link in links.items()}
        places = {joint: (form.AddTranslateOp(), form.AddOrientOp()) for joint, form in forms.items()}
        variants = self.stage.GetPrimAtPath(THING).GetVariantSets().AddVariantSet(DOORS)
        for name, end in states.items():
            variants.AddVariant(name)
            variants.SetVariantSelection(name)
            with variants.GetVariantEditContext():
                for joint, (translate, orient) in places.items():
                    value, hinge = 0.0 if end < 0 else joint.span[end], joint.kind == "hinge"
                    turn = Gf.Rotation(Gf.Vec3d(*joint.axis), math.degrees(value) if hinge else 0.0)
                    translate.Set(Gf.Vec3d(*joint.at) + Gf.Vec3d(*joint.axis) * (0.0 if hinge else value))
                    orient.Set(Gf.Quatf(turn.GetQuat()))
        variants.SetVariantSelection(next(iter(states)))

    def shape(self, folder: str, link: BodyLink) -> None:
        """Add what a link is made of and what it looks like, so that nothing outside is referred to; what is touched is a collider."""
        self.bind(self.stage.GetPrimAtPath(folder), self.friction(folder, self.thing.friction), "physics")
        for shape in link.shapes:
            path = _free(folder, shape.part.name, self.taken)
            if not shape.seen and shape.box is not None:
                cube = UsdGeom.Cube.Define(self.stage, path)
                _put(cube, np.diag(shape.box.half) @ shape.box.rotation.T, shape.box.center)
                prim = cube.GetPrim()
            elif len((surface := welded(shape.part)).indices):
                prim = _mesh(self.stage, path, surface, shape.part)
                self.bind(prim, self.look(folder, shape.part.material))
            else:
                continue
            if not shape.seen:
                UsdGeom.Imageable(prim).CreatePurposeAttr(UsdGeom.Tokens.guide)
            if shape.touched:
                UsdPhysics.CollisionAPI.Apply(prim)
                if prim.IsA(UsdGeom.Mesh):
                    UsdPhysics.MeshCollisionAPI.Apply(prim).CreateApproximationAttr(UsdPhysics.Tokens.convexHull)

    def bind(self, prim: Any, material: Any, purpose: str = "") -> None:
        """Bind a material to a prim."""
        binding = UsdShade.MaterialBindingAPI.Apply(prim)
        weaker = UsdShade.Tokens.fallbackStrength
        binding.Bind(material, weaker, purpose) if purpose else binding.Bind(material)

    def material(self, folder: str, name: str) -> Any:
        """Return a new material among the looks of a folder."""
        looks = UsdGeom.Scope.Define(self.stage, f"{folder}/Looks").GetPath()
        return UsdShade.Material.Define(self.stage, _free(str(looks), name, self.taken))

    def look(self, folder: str, material: Material) -> Any:
        """Return the Preview Surface material of a look."""
        if (folder, material) in self.looks:
            return self.looks[folder, material]
        look = self.looks[folder, material] = self.material(folder, material.name)
        path, color = look.GetPath(), linear(material.color)
        inputs = {
            "diffuseColor": (Types.Color3f, Gf.Vec3f(*color)),
            "roughness": (Types.Float, material.roughness),
            "metallic": (Types.Float, material.metallic),
            "opacity": (Types.Float, material.opacity),
        }
        if material.glow:
            inputs["emissiveColor"] = (Types.Color3f, Gf.Vec3f(*(channel * material.glow for channel in color)))
        shader = self.shader(f"{path}/Surface", "UsdPreviewSurface", inputs)
        if material.texture is not None:
            self.textured(path, material, material.texture, shader)
        look.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
        return look

    def shader(self, path: str, kind: str, inputs: Mapping[str, tuple[Any, object]]) -> Any:
        """Return a new shader; an input is a type and a value."""
        made = UsdShade.Shader.Define(self.stage, path)
        made.CreateIdAttr(kind)
        for name, (of, value) in inputs.items():
            made.CreateInput(name, of).Set(value)
        return made

    def textured(self, path: str, material: Material, texture: str | bytes, shader: Any) -> None:
        """Let a look's colour come from its texture, and keep that picture."""
        data = picture(texture)
        name = f"textures/{hashlib.sha256(data).hexdigest()[:16]}.{media_type(data).partition('/')[2]}"
        self.files[f"things/{name}"] = data
        place = self.shader(f"{path}/Place", "UsdPrimvarReader_float2", {"varname": (Types.String, "st")})
        inputs = {
            "file": (Types.Asset, Sdf.AssetPath(f"./{name}")),
            "sourceColorSpace": (Types.Token, "sRGB"),
            "scale": (Types.Float4, Gf.Vec4f(*base_color(material), 1.0)),
            "wrapS": (Types.Token, "repeat"),
            "wrapT": (Types.Token, "repeat"),
        }
        found = self.shader(f"{path}/Texture", "UsdUVTexture", inputs)
        found.CreateInput("st", Types.Float2).ConnectToSource(place.CreateOutput("result", Types.Float2))
        shader.GetInput("diffuseColor").ConnectToSource(found.CreateOutput("rgb", Types.Float3))

    def friction(self, folder: str, value: float) -> Any:
        """Return a new physics material with a friction coefficient."""
        look = self.material(folder, f"friction_{round(value * 100)}")
        physics = UsdPhysics.MaterialAPI.Apply(look.GetPrim())
        physics.CreateStaticFrictionAttr(value)
        physics.CreateDynamicFrictionAttr(value)
        physics.CreateRestitutionAttr(0.0)
        return look


def _mesh(stage: Any, path: str, surface: DrawnSurface, part: Part) -> Any:
    mesh = UsdGeom.Mesh.Define(stage, path)
    points = Vt.Vec3fArray.FromNumpy(surface.positions.astype(np.float32))
    mesh.CreatePointsAttr(points)
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(surface.indices), 3, np.int32)))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(surface.indices.reshape(-1).astype(np.int32)))
    mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(surface.normals.astype(np.float32)))
    mesh.SetNormalsInterpolation(UsdGeom.Tokens.faceVarying)
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreateExtentAttr(UsdGeom.PointBased.ComputeExtent(points))
    mesh.CreateDoubleSidedAttr(not part.convex)
    if part.material.texture is not None:
        kind = Types.TexCoord2fArray
        places = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", kind, UsdGeom.Tokens.faceVarying)
        places.Set(Vt.Vec2fArray.FromNumpy((surface.uvs * (1, -1) + (0, 1)).astype(np.float32)))
    return mesh.GetPrim()


def _rigid(prim: Any, link: BodyLink) -> None:
    weight, middle, inertia = link.inertia()
    moments, axes = np.linalg.eigh(inertia)
    turn = quaternion(axes * np.sign(np.linalg.det(axes)))
    UsdPhysics.RigidBodyAPI.Apply(prim)
    solid = UsdPhysics.MassAPI.Apply(prim)
    solid.CreateMassAttr(max(weight, BODIES.lightest))
    solid.CreateCenterOfMassAttr(Gf.Vec3f(*middle.tolist()))
    solid.CreateDiagonalInertiaAttr(Gf.Vec3f(*moments.tolist()))
    solid.CreatePrincipalAxesAttr(Gf.Quatf(*turn))


def _connect(made: Any, still: Any, moving: Any, joint: Joint | None = None) -> None:
    """Say what a joint holds together and where; without one of ours, where they both have their origin."""
    made.CreateBody0Rel().SetTargets([still])
    made.CreateBody1Rel().SetTargets([moving.GetPath()])
    at, axis = (joint.at, joint.axis) if joint is not None else ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    turn = Gf.Quatf(Gf.Rotation(Gf.Vec3d(1, 0, 0), Gf.Vec3d(*axis)).GetQuat())
    made.CreateLocalPos0Attr(Gf.Vec3f(*at))
    made.CreateLocalPos1Attr(Gf.Vec3f(0.0))
    made.CreateLocalRot0Attr(turn)
    made.CreateLocalRot1Attr(turn)


def _put(prim: Any, turn: FloatArray, at: ArrayLike) -> None:
    """Place a prim: the rows of `turn` (3, 3) are its axes, scaled."""
    place = np.eye(4)
    place[:3, :3], place[3, :3] = turn, at
    prim.AddTransformOp().Set(Gf.Matrix4d(place.tolist()))


def _camera(stage: Any, room: Room) -> None:
    """Add a camera that sees the whole room."""
    position, axes = overview(room)
    camera = UsdGeom.Camera.Define(stage, f"{WORLD}/Camera")
    height = camera.GetVerticalApertureAttr().Get()
    camera.GetHorizontalApertureAttr().Set(height * SCENERY.aspect)
    camera.GetFocalLengthAttr().Set(height / 2 / math.tan(SCENERY.field / 2))
    _put(camera, axes.T, position)


def _custom(prim: Any, name: str, kind: Any, value: object) -> None:
    prim.CreateAttribute(f"robolayout:{name}", kind, True, Sdf.VariabilityUniform).Set(value)


def _routes(stage: Any, options: Options) -> None:
    """Add the agent's routes as guide curves on the floor."""
    if not options.routes:
        return
    scope = UsdGeom.Scope.Define(stage, ROUTES).GetPrim()
    if options.agent is not None:
        _custom(scope, "agent", Types.String, xml(options.agent.name))
    taken: set[str] = set()
    for name, line in options.routes.items():
        if len(line) < 2:
            continue
        curve = UsdGeom.BasisCurves.Define(stage, _free(ROUTES, xml(name), taken))
        points = Vt.Vec3fArray([Gf.Vec3f(float(x), float(y), 0.0) for x, y in line])
        curve.CreateTypeAttr(UsdGeom.Tokens.linear)
        curve.CreatePointsAttr(points)
        curve.CreateCurveVertexCountsAttr([len(line)])
        curve.CreateWidthsAttr([SCENERY.route_width])
        curve.SetWidthsInterpolation(UsdGeom.Tokens.constant)
        curve.CreateExtentAttr(UsdGeom.Curves.ComputeExtent(points, Vt.FloatArray([SCENERY.route_width])))
        curve.CreatePurposeAttr(UsdGeom.Tokens.guide)
        _custom(curve.GetPrim(), "name", Types.String, xml(name))


def assets_of(path: Path) -> Rows:
    """Yield what a stage on disk says about its assets."""
    stage = Usd.Stage.Open(str(path), Usd.Stage.LoadNone)
    folder = stage.GetPrimAtPath(ASSETS) if stage else None
    if not folder:
        raise RuntimeError(f"it has no {ASSETS}")
    for prim in folder.GetAllChildren():  # payloads are not loaded, and without them the others are no "children"
        x, y, z = prim.GetAttribute("xformOp:translate").Get()
        pose = Pose(x, y, z, math.radians(prim.GetAttribute("xformOp:rotateZ").Get()))
        yield str(prim.GetAttribute("robolayout:name").Get()), pose, prim.GetAttribute("robolayout:size").Get()
