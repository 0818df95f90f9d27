/** Flat things on the floor: areas, ribbons, discs and rings, in the room's own axes (z up). */
import {
  BufferGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Mesh,
  MeshBasicMaterial,
  Path,
  RingGeometry,
  Shape,
  ShapeGeometry,
} from "three";

/** Return a paint that lies over the floor; later ones cover earlier ones. */
export function paint(color, opacity = 1) {
  return new MeshBasicMaterial({ color, opacity, transparent: true, depthWrite: false, side: DoubleSide });
}

/** Return polygons (each a list of rings, outer first) as one mesh at height z. */
export function areaMesh(polygons, material, z) {
  const shapes = polygons.map(([outer, ...holes]) => {
    const shape = new Shape();
    outer.forEach(([x, y], i) => (i ? shape.lineTo(x, y) : shape.moveTo(x, y)));
    shape.holes = holes.map((ring) => {
      const path = new Path();
      ring.forEach(([x, y], i) => (i ? path.lineTo(x, y) : path.moveTo(x, y)));
      return path;
    });
    return shape;
  });
  const mesh = new Mesh(new ShapeGeometry(shapes), material);
  mesh.position.z = z;
  mesh.renderOrder = z * 1000;
  return mesh;
}

/** Return lines (each a list of points) as one mesh of ribbons, `width` metres wide, joined roundly. */
export function ribbonMesh(lines, width, material, z) {
  const corners = [];
  const half = width / 2;
  for (const line of lines) {
    for (let i = 0; i + 1 < line.length; i++) corners.push(...segment(line[i], line[i + 1], half));
    for (const point of line) corners.push(...dot(point, half, 10));
  }
  return flat(corners, material, z);
}

/** Return discs as one mesh. */
export function discMesh(centers, radius, material, z) {
  return flat(
    centers.flatMap((center) => dot(center, radius, 32)),
    material,
    z,
  );
}

/** Return a circle's line, `width` metres wide. */
export function ringMesh([x, y], radius, width, material, z) {
  const mesh = new Mesh(new RingGeometry(radius - width, radius, 72), material);
  mesh.position.set(x, y, z);
  mesh.renderOrder = z * 1000;
  return mesh;
}

function segment([ax, ay], [bx, by], half) {
  const length = Math.hypot(bx - ax, by - ay);
  if (length === 0) return [];
  const [nx, ny] = [((ay - by) / length) * half, ((bx - ax) / length) * half];
  const [p, q, r, s] = [
    [ax + nx, ay + ny],
    [ax - nx, ay - ny],
    [bx - nx, by - ny],
    [bx + nx, by + ny],
  ];
  return [p, q, r, p, r, s];
}

function dot([x, y], radius, count) {
  const rim = (k) => {
    const angle = (2 * Math.PI * k) / count;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  };
  return Array.from({ length: count }, (_, k) => [[x, y], rim(k), rim(k + 1)]).flat();
}

function flat(corners, material, z) {
  const shape = new BufferGeometry();
  shape.setAttribute("position", new Float32BufferAttribute(corners.flatMap(([x, y]) => [x, y, 0]), 3));
  const mesh = new Mesh(shape, material);
  mesh.position.z = z;
  mesh.renderOrder = z * 1000;
  return mesh;
}
