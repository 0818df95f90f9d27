/** Reads the GLB that RoboLayout writes: indexed triangles with normals, colours and textures; no lights, no camera. */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LinearSRGBColorSpace,
  Mesh,
  MeshLambertMaterial,
  RepeatWrapping,
  SRGBColorSpace,
  Texture,
} from "three";

const JSON_CHUNK = 0x4e4f534a;
const ARRAYS = { 5126: Float32Array, 5125: Uint32Array };
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3 };

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
  if (attributes.TEXCOORD_0 !== undefined) shape.setAttribute("uv", attribute(document, blob, attributes.TEXCOORD_0));
  shape.setIndex(attribute(document, blob, indices));
  return shape;
}

async function texture(document, blob, { source }) {
  const { bufferView, mimeType } = document.images[source];
  const { byteOffset, byteLength } = document.bufferViews[bufferView];
  const picture = new Blob([blob.slice(byteOffset, byteOffset + byteLength)], { type: mimeType });
  const found = new Texture(await createImageBitmap(picture));
  found.wrapS = found.wrapT = RepeatWrapping;
  found.flipY = false;
  found.colorSpace = SRGBColorSpace;
  found.needsUpdate = true;
  return found;
}

/** Return a material; the file holds linear light, which is what the renderer counts in. */
function material({ pbrMetallicRoughness: look, emissiveFactor = [0, 0, 0] }, textures) {
  const [red, green, blue, opacity] = look.baseColorFactor;
  return new MeshLambertMaterial({
    color: new Color().setRGB(red, green, blue, LinearSRGBColorSpace),
    emissive: new Color().setRGB(...emissiveFactor, LinearSRGBColorSpace),
    map: look.baseColorTexture ? textures[look.baseColorTexture.index] : null,
    opacity,
    transparent: opacity < 1,
    depthWrite: opacity === 1,
    // One side for all: every further kind of material is a further program to compile before the first picture.
    side: DoubleSide,
  });
}

/** Return the scene of a GLB file; each node keeps its name and facts in `userData`. */
export async function readGlb(buffer) {
  const { document, blob } = chunks(buffer);
  const textures = await Promise.all((document.textures ?? []).map((entry) => texture(document, blob, entry)));
  const materials = (document.materials ?? []).map((entry) => material(entry, textures));
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
