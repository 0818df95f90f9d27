/** Camera, light and drawing: a picture is made only when something changed. */
import {
  DirectionalLight,
  HemisphereLight,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { calm } from "./dom.js";
import { cutAway, ghost, roomCorners } from "./room.js";

const EYE_TIME = 450;
const TURN = 0.12;
const PADDING = 1.06;

/** Degrees that the eye takes in, from bottom to top: little from above, where the room should look like its plan. */
const VIEWS = { corner: 32, top: 9, door: 64 };

/** Share of the room's height that counts at its near side, where the walls are cut away. */
const NEAR_HEIGHT = 0.5;

/** Pixels above and below the room that the bars and the legend cover. */
const COVERED = { top: 62, bottom: 102 };

/** Nearest and farthest that the eye sees around the room, metres beyond it: what the reach of a body draws outside. */
const BEYOND = 3;

/** A view that looks down more steeply than this (the sine of the angle) shows what hangs from the ceiling as ghosts. */
const STEEP = 0.9;

/** Return the stage; throws where the browser cannot draw in 3D. */
export function makeStage(canvas, root, room, data) {
  const renderer = new WebGLRenderer({ canvas, antialias: true });
  renderer.debug.checkShaderErrors = false;
  renderer.setClearColor("#f4f3ef");
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  renderer.shadowMap.needsUpdate = true;
  const scene = new Scene();
  scene.add(root);
  root.updateMatrixWorld(true);
  const corners = roomCorners(data.room);
  const center = corners.reduce((sum, corner) => sum.add(corner), new Vector3()).divideScalar(corners.length);
  center.z = data.room.height * 0.3;
  const camera = new PerspectiveCamera(VIEWS.corner, 1, 0.05, 200);
  light(scene, camera, data, corners, center);
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = !calm();
  controls.maxPolarAngle = Math.PI * 0.52;
  const stage = { renderer, scene, camera, controls, root, corners, center, data, after: [], size: [1, 1], flight: 0 };
  stage.toWorld = (x, y, z) => root.localToWorld(new Vector3(x, y, z));
  stage.toRoom = (point) => root.worldToLocal(point.clone());

  let waiting = true;
  stage.changed = () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      if (controls.update()) stage.changed();
      cutAway(room.walls, stage.toRoom(camera.position));
      ghost(room.hung, isSteep(camera.position, controls.target));
      closeIn(stage);
      renderer.render(scene, camera);
      for (const step of stage.after) step();
    });
  };
  stage.moved = () => {
    renderer.shadowMap.needsUpdate = true;
    stage.changed();
  };
  controls.addEventListener("change", stage.changed);
  controls.addEventListener("start", () => (stage.flight += 1));
  canvas.addEventListener("keydown", (event) => turnByKey(stage, event));
  resize(stage, canvas);
  new ResizeObserver(() => resize(stage, canvas)).observe(canvas.parentElement);
  /** Draw the first picture once its programs are compiled, which does not hold up the page. */
  stage.start = async () => {
    if (renderer.extensions.has("KHR_parallel_shader_compile")) await renderer.compileAsync(scene, camera);
    waiting = false;
    stage.changed();
    await new Promise((drawn) => requestAnimationFrame(() => setTimeout(drawn)));
  };
  return stage;
}

function isSteep(eye, target) {
  return eye.y - target.y > STEEP * eye.distanceTo(target);
}

/** Count depth only from where the room begins to where it ends: the layers of a rug lie a millimetre apart. */
function closeIn({ camera, corners, center, toWorld }) {
  const radius = corners[0].distanceTo(corners[7]) + BEYOND;
  const distance = camera.position.distanceTo(toWorld(center.x, center.y, center.z));
  camera.near = Math.max(0.05, distance - radius);
  camera.far = distance + radius;
  camera.updateProjectionMatrix();
}

/** Light the room: a sun that throws shadows, a lamp at the eye for the walls it looks at, and the sky. */
function light(scene, camera, data, corners, center) {
  const span = corners[0].distanceTo(corners[7]);
  const [x, y] = cornerOf(data, center);
  const sun = new DirectionalLight("#fff7ea", 0.75);
  // Lights, like everything outside the room's own group, count y upwards: (x, y, z) of the room is (x, z, -y) here.
  sun.position.set(center.x + span * (0.1 * x - 0.5 * y), span, -center.y - span * (0.1 * y + 0.5 * x));
  sun.target.position.set(center.x, 0, -center.y);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  sun.shadow.bias = -0.0006;
  sun.shadow.normalBias = 0.025;
  sun.shadow.radius = 2.5;
  Object.assign(sun.shadow.camera, { left: -span / 1.7, right: span / 1.7, top: span / 1.7, bottom: -span / 1.7 });
  Object.assign(sun.shadow.camera, { near: 0.1, far: span * 3 });
  const lamp = new DirectionalLight("#ffffff", 1.05);
  camera.add(lamp, lamp.target);
  lamp.target.position.set(0, 0, -1);
  scene.add(camera, sun, sun.target, new HemisphereLight("#ffffff", "#faf5ee", 2.0));
}

function resize(stage, canvas) {
  const { clientWidth: width, clientHeight: height } = canvas.parentElement;
  if (!width || !height) return;
  const untouched = stage.flight === 0;
  stage.size = [width, height];
  stage.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  stage.renderer.setSize(width, height, false);
  stage.camera.aspect = width / height;
  stage.camera.setViewOffset(width, height, 0, (COVERED.bottom - COVERED.top) / 2, width, height);
  if (untouched) place(stage, ...seenFrom(stage, "corner"));
  stage.changed();
}

/** Return (eye, target) in world axes from which the whole room is seen. */
function seenFrom(stage, name, agent) {
  const { data, center } = stage;
  if (name === "door" && agent?.entry) {
    const [x, y] = agent.entry;
    const height = Math.min(Math.max(agent.height * 0.93, 0.25), data.room.height - 0.2);
    const [dx, dy] = [center.x - x, center.y - y];
    const length = Math.hypot(dx, dy) || 1;
    const back = 0.35;
    return [
      stage.toWorld(x - (dx / length) * back, y - (dy / length) * back, height),
      stage.toWorld(center.x, center.y, Math.min(height, 0.8)),
    ];
  }
  const [spanX, spanY] = [stage.corners[7].x - stage.corners[0].x, stage.corners[7].y - stage.corners[0].y];
  const from = name === "top" ? new Vector3(0, -0.001, 1) : new Vector3(...cornerOf(data, center), 1.15);
  if (name !== "top" && spanX < spanY) from.x *= 1.15;
  const target = stage.toWorld(center.x, center.y, center.z);
  const direction = stage.toWorld(center.x + from.x, center.y + from.y, center.z + from.z).sub(target).normalize();
  return [target.clone().addScaledVector(direction, fitting(stage, target, direction, VIEWS[name])), target];
}

/** Return the direction in plan from which the first door does not hide: across the room from the door. */
function cornerOf({ room }, center) {
  const door = room.doors[0] ?? 0;
  const [a, b] = [room.floor[door], room.floor[(door + 1) % room.floor.length]];
  const [x, y] = [center.x - (a[0] + b[0]) / 2, center.y - (a[1] + b[1]) / 2];
  const length = Math.hypot(x, y) || 1;
  const [ux, uy] = [x / length, y / length];
  return [ux * 0.8 + uy * 0.6, uy * 0.8 - ux * 0.6];
}

/** Return how far away the eye must be for all corners to be seen. */
function fitting({ corners, toWorld, size }, target, direction, view) {
  const right = new Vector3().crossVectors(new Vector3(0, 1, 0), direction).normalize();
  const up = new Vector3().crossVectors(direction, right);
  const tanFull = Math.tan((view * Math.PI) / 360) / PADDING;
  const tanV = (tanFull * (size[1] - COVERED.top - COVERED.bottom)) / size[1];
  const tanH = (tanFull * size[0]) / size[1];
  return Math.max(
    ...corners.map((corner) => {
      const near = toWorld(corner.x, corner.y, 0).sub(target).setY(0).dot(direction) > 0;
      const offset = toWorld(corner.x, corner.y, near ? corner.z * NEAR_HEIGHT : corner.z).sub(target);
      const across = Math.max(Math.abs(offset.dot(right)) / tanH, Math.abs(offset.dot(up)) / tanV);
      return across + offset.dot(direction);
    }),
  );
}

function place(stage, eye, target) {
  stage.camera.position.copy(eye);
  stage.controls.target.copy(target);
  stage.controls.update();
}

/** Move the eye to where a name says: "corner", "top" or "door". */
export function look(stage, name, agent) {
  const [eye, target] = seenFrom(stage, name, agent);
  const flight = (stage.flight += 1);
  const [fromEye, fromTarget] = [stage.camera.position.clone(), stage.controls.target.clone()];
  const [fromView, view] = [stage.camera.fov, VIEWS[name]];
  const start = performance.now();
  const fly = (now) => {
    if (flight !== stage.flight) return;
    const share = calm() ? 1 : Math.min((now - start) / EYE_TIME, 1);
    const eased = share * share * (3 - 2 * share);
    place(stage, fromEye.clone().lerp(eye, eased), fromTarget.clone().lerp(target, eased));
    stage.camera.fov = fromView + eased * (view - fromView);
    stage.camera.updateProjectionMatrix();
    stage.changed();
    if (share < 1) requestAnimationFrame(fly);
  };
  requestAnimationFrame(fly);
}

function turnByKey(stage, event) {
  const turns = { ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, -TURN], ArrowDown: [0, TURN] };
  const zooms = { "+": 0.88, "=": 0.88, "-": 1.14 };
  const turn = turns[event.key];
  const zoom = zooms[event.key];
  if ((!turn && !zoom) || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  stage.flight += 1;
  const offset = stage.camera.position.clone().sub(stage.controls.target);
  if (zoom) offset.multiplyScalar(zoom);
  if (turn) turned(offset, ...turn);
  stage.camera.position.copy(stage.controls.target).add(offset);
  stage.controls.update();
  stage.changed();
}

/** Turn an offset about the upright by some radians, and towards or away from it. */
function turned(offset, around, tilt) {
  const length = offset.length();
  const polar = Math.min(Math.max(Math.acos(offset.y / length) + tilt, 0.02), Math.PI * 0.5);
  const azimuth = Math.atan2(offset.x, offset.z) + around;
  offset.set(Math.sin(polar) * Math.sin(azimuth), Math.cos(polar), Math.sin(polar) * Math.cos(azimuth));
  offset.multiplyScalar(length);
}
