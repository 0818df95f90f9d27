/** Reads the GLB that RoboLayout writes: indexed triangles with normals and plain colours, nothing else. */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LinearSRGBColorSpace,
  Mesh,
  MeshLambertMaterial,
} from "three";

const JSON_CHUNK = 0x4e4f534a;
const ARRAYS = { 5126: Float32Array, 5125: Uint32Array };
const WIDTHS = { SCALAR: 1, VEC3: 3 };

/** Return the JSON and the binary chunk of a GLB file. */
function chunks(buffer) {
  const view = new DataView(buffer);
  if (view.getUint32(0, true) !== 0x46546c67) throw new Error("the meshes in this page are no GLB");
  let document = null;
  let blob = new ArrayBuffer(0);
  for (let at = 12; at < buffer.byteLength; ) {
    const length = view.getUint32(at, true);
    const bytes = buffer.slice(at + 8, at + 8 + length);
    if (view.getUint32(at + 4, true) === JSON_CHUNK) document = JSON.parse(new TextDecoder().decode(bytes));
    else blob = bytes;
    at += 8 + length;
  }
  return { document, blob };
}

function attribute(document, blob, index) {
  const { bufferView, componentType, count, type } = document.accessors[index];
  const { byteOffset } = document.bufferViews[bufferView];
  return new BufferAttribute(new ARRAYS[componentType](blob, byteOffset, count * WIDTHS[type]), WIDTHS[type]);
}

function geometry(document, blob, { attributes, indices }) {
  const shape = new BufferGeometry();
  shape.setAttribute("position", attribute(document, blob, attributes.POSITION));
  shape.setAttribute("normal", attribute(document, blob, attributes.NORMAL));
  shape.setIndex(attribute(document, blob, indices));
  return shape;
}

/** Return a material; the file holds linear light, which is what the renderer counts in. */
function material(entry) {
  const [red, green, blue, opacity] = entry.pbrMetallicRoughness.baseColorFactor;
  return new MeshLambertMaterial({
    color: new Color().setRGB(red, green, blue, LinearSRGBColorSpace),
    opacity,
    transparent: opacity < 1,
    depthWrite: opacity === 1,
    // One side for all: every further kind of material is a further program to compile before the first picture.
    side: DoubleSide,
  });
}

/** Return the scene of a GLB file; each node keeps its name and facts in `userData`. */
export function readGlb(buffer) {
  const { document, blob } = chunks(buffer);
  const materials = (document.materials ?? []).map(material);
  const shapes = (document.meshes ?? []).map(({ primitives: [primitive] }) => [
    geometry(document, blob, primitive),
    materials[primitive.material],
  ]);
  const build = (index) => {
    const { name, mesh, children = [], translation, rotation, extras } = document.nodes[index];
    const node = mesh === undefined ? new Group() : new Mesh(...shapes[mesh]);
    node.userData = { name, kind: extras?.kind };
    if (translation) node.position.fromArray(translation);
    if (rotation) node.quaternion.fromArray(rotation);
    for (const child of children) node.add(build(child));
    return node;
  };
  return build(document.scenes[document.scene].nodes[0]);
}
