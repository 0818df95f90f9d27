/** The run as the page holds it: whole millimetres and tenths of a degree become metres and radians. */
import { byId } from "./dom.js";

const metres = (value) => value / 1000;
const radians = (tenths) => (tenths * Math.PI) / 1800;

/** Return flat millimetres as points in metres. */
function points(flat) {
  const found = [];
  for (let i = 0; i < flat.length; i += 2) found.push([metres(flat[i]), metres(flat[i + 1])]);
  return found;
}

const areas = (polygons) => polygons.map((rings) => rings.map(points));
const pose = (p) => p && { x: metres(p[0]), y: metres(p[1]), z: metres(p[2]), yaw: radians(p[3]) };
const spot = (p) => p && p.map(metres);

function agentOf(agent) {
  return {
    ...agent,
    radius: metres(agent.radius),
    height: metres(agent.height),
    reach: metres(agent.reach),
    entry: spot(agent.entry),
    free: areas(agent.free),
    islands: areas(agent.islands),
    beyond: areas(agent.beyond),
    routes: agent.routes.map(points),
    passage: agent.passage.map(([a, b, text]) => ({ a: spot(a), b: spot(b), text })),
    turns: agent.turns.map(spot),
    assets: agent.assets.map((asset) => ({ ...asset, stand: spot(asset.stand) })),
  };
}

function frameOf([step, stage, flat]) {
  const poses = [];
  for (let i = 0; i < flat.length; i += 3) {
    poses.push(flat[i] === null ? null : { x: metres(flat[i]), y: metres(flat[i + 1]), yaw: radians(flat[i + 2]) });
  }
  return { step, stage, poses };
}

/** Return the data of the page. */
export function readData() {
  const raw = JSON.parse(byId("data").textContent);
  return {
    ...raw,
    room: { ...raw.room, floor: raw.room.floor.map(spot), height: metres(raw.room.height) },
    assets: raw.assets.map((asset) => ({ ...asset, size: spot(asset.size), pose: pose(asset.pose) })),
    agents: raw.agents.map(agentOf),
    trace: { ...raw.trace, frames: raw.trace.frames.map(frameOf) },
  };
}

/** Return the bytes of the furnished room. */
export function readMeshes() {
  return Uint8Array.from(atob(byId("glb").textContent), (letter) => letter.charCodeAt(0)).buffer;
}
