/** The furnished room: assets by index, and walls that step aside when they stand between eye and room. */
import { Box3, BufferGeometry, Float32BufferAttribute, FrontSide, Mesh, Vector3 } from "three";
import { paint } from "./shapes.js";

const THICKNESS = 0.1;

/** Opacity of what hangs from the ceiling, seen from above. */
const GHOSTLY = 0.35;

/** Order of drawing of what hangs from the ceiling: after all that lies on the floor. */
const ABOVE = 1000;

/** Return everything of the GLB that is drawn, sorted by what it is. */
export function sortRoom(root, data) {
  const byName = new Map(data.assets.map((asset, index) => [asset.name, index]));
  const assets = data.assets.map(() => null);
  const walls = wallsOf(data.room, data.colors.wall);
  for (const node of [...root.children]) {
    if (node.userData.kind === "asset") assets[byName.get(node.userData.name)] = node;
    else for (const part of node.children) sortPart(part, walls, data.room);
  }
  root.traverse((node) => {
    if (!node.isMesh) return;
    node.castShadow = !node.material.transparent && !isRoom(node);
    node.receiveShadow = true;
  });
  for (const wall of walls) root.add(wall.cap, wall.foot);
  const hung = assets.flatMap((node, index) => (node && data.assets[index].level === "ceiling" ? meshesOf(node) : []));
  return { assets, walls, hung };
}

/** Return the meshes of an asset, each with its material and the same as thin as glass. */
function meshesOf(asset) {
  const found = [];
  asset.traverse((mesh) => {
    if (!mesh.isMesh) return;
    const thin = mesh.material.clone();
    // The highest part is drawn first and hides the others: of a lamp, one layer is seen.
    Object.assign(thin, { transparent: true, opacity: thin.opacity * GHOSTLY, depthWrite: true, side: FrontSide });
    mesh.renderOrder = ABOVE - new Box3().setFromObject(mesh).max.y;
    found.push({ mesh, solid: mesh.material, thin });
  });
  return found;
}

/** Show what hangs from the ceiling as ghosts, or as it is. */
export function ghost(hung, thin) {
  for (const part of hung) part.mesh.material = thin ? part.thin : part.solid;
}

function isRoom(node) {
  for (let at = node; at; at = at.parent) if (at.userData.kind === "room") return true;
  return false;
}

function sortPart(part, walls, room) {
  const [kind, number] = part.userData.name.split("-");
  const index = { wall: number, skirting: number, door: room.doors[number], window: room.windows[number] }[kind];
  if (index !== undefined) walls[index].parts.push(part);
}

/** Return the walls with their outward normals and the dark strips that show where they are cut. */
function wallsOf({ floor, height }, color) {
  const outer = floor.map((_, i) => offsetCorner(floor, i));
  return floor.map((start, i) => {
    const next = (i + 1) % floor.length;
    const end = floor[next];
    const length = Math.hypot(end[0] - start[0], end[1] - start[1]);
    const out = [(end[1] - start[1]) / length, (start[0] - end[0]) / length];
    const quad = [start, outer[i], outer[next], end];
    return { start, out, parts: [], cap: strip(quad, height + 0.002, color), foot: strip(quad, 0.002, color) };
  });
}

/** Return where the outer faces of the walls meet at a corner of the floor; sharp corners are cut short. */
function offsetCorner(floor, i) {
  const count = floor.length;
  const normal = (a, b) => {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    return [(b[1] - a[1]) / length, (a[0] - b[0]) / length];
  };
  const [ax, ay] = normal(floor[(i + count - 1) % count], floor[i]);
  const [bx, by] = normal(floor[i], floor[(i + 1) % count]);
  const [sx, sy] = [ax + bx, ay + by];
  const length = Math.hypot(sx, sy) || 1;
  const reach = (THICKNESS * Math.min(2 / length, 3)) / length;
  return [floor[i][0] + sx * reach, floor[i][1] + sy * reach];
}

function strip(quad, z, color) {
  const shape = new BufferGeometry();
  shape.setAttribute("position", new Float32BufferAttribute(quad.flatMap(([x, y]) => [x, y, z]), 3));
  shape.setIndex([0, 1, 2, 0, 2, 3]);
  return new Mesh(shape, paint(color));
}

/** Hide the walls whose outside the eye sees, and show where they stood. */
export function cutAway(walls, eye) {
  for (const wall of walls) {
    const hidden = wall.out[0] * (eye.x - wall.start[0]) + wall.out[1] * (eye.y - wall.start[1]) > 0;
    for (const part of wall.parts) part.visible = !hidden;
    wall.cap.visible = !hidden;
    wall.foot.visible = hidden;
  }
}

/** Return the corners of the box around the room, metres. */
export function roomCorners({ floor, height }) {
  const [xs, ys] = [floor.map(([x]) => x), floor.map(([, y]) => y)];
  const low = [Math.min(...xs) - THICKNESS, Math.min(...ys) - THICKNESS];
  const high = [Math.max(...xs) + THICKNESS, Math.max(...ys) + THICKNESS];
  return [0, 1, 2, 3, 4, 5, 6, 7].map(
    (k) => new Vector3(k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? height : 0),
  );
}
