"""Loads exported rooms in three.js in headless Chromium, as a page does that shows them, and draws one picture."""

from __future__ import annotations

import shutil
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from benchmarks.examples import ROOT
from robolayout.export.glb import document

THREE = ROOT / "tests" / "tools" / "node_modules" / "three"
FLAGS = ("--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")
SITE = "http://room.invalid/"
PAGE = """<!doctype html><link rel="icon" href="data:,"><script type="importmap">
{"imports": {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
const { scene, cameras } = await new GLTFLoader().loadAsync("/room.glb");
scene.updateMatrixWorld(true);
const found = { things: {}, lights: 0, cameras: cameras.length, textures: 0 };
const textures = new Set(), turn = new THREE.Quaternion(), out = new THREE.Vector3();
scene.traverse((node) => {
  node.frustumCulled = false;
  found.lights += node.isLight ?? 0;
  if (node.material?.map) textures.add(node.material.map.source);
  if (node.userData.kind !== "asset") return;
  const place = node.getWorldPosition(new THREE.Vector3());
  out.set(1, 0, 0).applyQuaternion(node.getWorldQuaternion(turn));
  const own = new THREE.Box3(), back = node.matrixWorld.clone().invert();
  node.traverse((mesh) => {
    if (!mesh.isMesh) return;
    mesh.geometry.computeBoundingBox();
    own.union(mesh.geometry.boundingBox.clone().applyMatrix4(mesh.matrixWorld.clone().premultiply(back)));
  });
  const size = own.getSize(new THREE.Vector3());
  const pose = [place.x, -place.z, place.y, Math.atan2(-out.z, out.x)];
  found.things[node.userData.name ?? node.name] = [...pose, size.x, size.y, size.z];
});
found.textures = textures.size;
const renderer = new THREE.WebGLRenderer();
renderer.setSize(640, 480);
renderer.render(scene, cameras[0]);
found.triangles = renderer.info.render.triangles;
document.body.dataset.found = JSON.stringify(found);
</script><body></body>"""


def program() -> str | None:
    """Return the path of Chromium."""
    return shutil.which("chromium") or shutil.which("google-chrome")


def missing() -> str:
    """Return what must be installed before a browser can load a room; empty where nothing is."""
    if not find_spec("playwright") or program() is None:
        return "needs playwright and Chromium: make tools"
    return "" if THREE.is_dir() else "needs three.js: npm --prefix tests/tools install"


def held(glb: Path) -> dict[str, int]:
    """Return how many lights, cameras, textures and triangles a GLB holds."""
    file: Any = document(glb.read_bytes())
    shown = [p for node in file["nodes"] if "mesh" in node for p in file["meshes"][node["mesh"]]["primitives"]]
    return {
        "lights": sum("KHR_lights_punctual" in node.get("extensions", {}) for node in file["nodes"]),
        "cameras": len(file["cameras"]),
        "textures": len(file.get("images", ())),
        "triangles": sum(file["accessors"][p["indices"]]["count"] for p in shown) // 3,
    }


def in_three(glb: Path) -> dict[str, Any]:
    """Return what three.js finds and draws of a GLB: poses and sizes of things, counts, and what the browser complains of."""
    said: list[str] = []

    def failed(error: Any) -> None:
        said.append(str(error))

    def heard(message: Any) -> None:
        if message.type in ("error", "warning"):
            said.append(str(message.text))

    def answer(route: Any) -> None:
        wanted = str(route.request.url).removeprefix(SITE)
        if wanted.startswith("three/"):
            route.fulfill(path=THREE / wanted.removeprefix("three/"))
        elif wanted == "room.glb":
            route.fulfill(path=glb)
        else:
            route.fulfill(body=PAGE, content_type="text/html")

    with import_module("playwright.sync_api").sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program(), args=list(FLAGS))
        tab = browser.new_page()
        tab.on("console", heard)
        tab.on("pageerror", failed)
        tab.route(f"{SITE}**", answer)
        tab.goto(SITE)
        tab.wait_for_selector("body[data-found]", state="attached")
        found = tab.evaluate("() => JSON.parse(document.body.dataset.found)")
        browser.close()
    return {**found, "said": said}
