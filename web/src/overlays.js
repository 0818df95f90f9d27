/** What the chosen body can do, drawn into the room: free floor, routes, reach, and the place where it stands. */
import { BoxGeometry, CylinderGeometry, EdgesGeometry, FrontSide, Group, LineBasicMaterial, LineSegments, Mesh } from "three";
import { areaMesh, discMesh, paint, ribbonMesh, ringMesh } from "./shapes.js";

const SKY = "#56b4e9";
const AMBER = "#e69f00";
const TURN = "#cc79a7";
const CORNERS = [[1, -1], [1, 1], [-1, 1], [-1, -1]];

/** Heights in metres at which flat things lie, above rugs and in this order. */
const Z = { free: 0.031, islands: 0.032, beyond: 0.033, edge: 0.034, print: 0.036, routes: 0.038, chosen: 0.04, stand: 0.042 };

/** Return the overlays; `show` brings them up to date with what is chosen. */
export function makeOverlays(stage, assets, data) {
  const made = data.agents.map((agent) => agentLayers(agent, data));
  const chosen = new Group();
  for (const layers of made) stage.root.add(...Object.values(layers));
  stage.root.add(chosen);
  return {
    show(state) {
      made.forEach((layers, i) => {
        for (const [name, group] of Object.entries(layers)) {
          group.visible = i === state.agent && state.atEnd && state.layers[name];
        }
      });
      for (const part of chosen.children) part.geometry.dispose();
      chosen.clear();
      if (state.asset !== null) chosen.add(...chosenParts(state, assets, data));
      stage.changed();
    },
  };
}

function agentLayers(agent, data) {
  const { route, narrow } = data.colors;
  const layers = { free: new Group(), routes: new Group(), reach: new Group() };
  if (agent.free.length) {
    layers.free.add(areaMesh(agent.free, paint(SKY, 0.38), Z.free));
    layers.free.add(ribbonMesh(closed(agent.free.flat()), 0.012, paint(route, 1), Z.edge));
  }
  if (agent.islands.length) {
    layers.free.add(areaMesh(agent.islands, paint(AMBER, 0.5), Z.islands));
    layers.free.add(ribbonMesh(closed(agent.islands.flat()), 0.012, paint("#9c6b00", 1), Z.edge));
  }
  layers.routes.add(ribbonMesh(agent.routes.filter((line) => line.length > 1), 0.028, paint(route), Z.routes));
  for (const { a, b } of agent.passage) layers.routes.add(ribbonMesh([[a, b]], 0.04, paint(narrow), Z.chosen));
  if (agent.entry) layers.routes.add(body(agent, agent.entry, route), ringMesh(agent.entry, agent.radius, 0.015, paint(route), Z.routes));
  if (agent.beyond.length) layers.reach.add(areaMesh(agent.beyond, paint(data.colors.bad, 0.45), Z.beyond));
  layers.reach.add(...footprints(agent, data));
  for (const [x, y, across] of agent.turns) layers.reach.add(ringMesh([x, y], across / 2, 0.02, paint(TURN), Z.stand));
  const stands = agent.assets.map((asset) => asset.stand).filter(Boolean);
  layers.reach.add(discMesh(stands, 0.05, paint(route), Z.stand));
  return layers;
}

const closed = (rings) => rings.map((ring) => [...ring, ring[0]]);

/** Return the outlines of all assets, in the colours of their verdicts. */
function footprints(agent, data) {
  const colors = { good: data.colors.narrow, bad: data.colors.bad, free: "#77736d" };
  return Object.entries(colors).map(([state, color]) => {
    const lines = data.assets
      .filter((asset, i) => asset.pose && asset.level !== "ceiling" && agent.assets[i].state === state)
      .map(outline);
    return ribbonMesh(lines, 0.03, paint(color), Z.print);
  });
}

function outline({ pose, size }) {
  const [c, s] = [Math.cos(pose.yaw), Math.sin(pose.yaw)];
  const ring = CORNERS.map(([i, j]) => [
    pose.x + (c * i * size[0] - s * j * size[1]) / 2,
    pose.y + (s * i * size[0] + c * j * size[1]) / 2,
  ]);
  return [...ring, ring[0]];
}

/** Return the body as a pale upright cylinder, which is not seen from inside. */
function body(agent, [x, y], color) {
  const height = Math.max(agent.height - Z.stand, 0.02);
  const shape = new CylinderGeometry(agent.radius, agent.radius, height, 48);
  const mesh = new Mesh(shape, paint(color, 0.26));
  mesh.material.side = FrontSide;
  mesh.rotation.x = Math.PI / 2;
  mesh.position.set(x, y, Z.stand + height / 2);
  mesh.renderOrder = 60;
  return mesh;
}

/** Return what is drawn for the chosen asset: its box, and the body on its way to it. */
function chosenParts(state, assets, data) {
  const node = assets[state.asset];
  if (!node) return [];
  const parts = boxAround(node, data.assets[state.asset].size, data.colors.route);
  const agent = data.agents[state.agent];
  const { stand } = agent.assets[state.asset];
  if (!state.atEnd) return parts;
  const line = agent.routes[state.asset];
  if (line.length > 1) {
    parts.push(ribbonMesh([line], 0.06, paint(data.colors.route), Z.chosen));
    parts.push(discMesh(line.slice(-1), 0.07, paint(data.colors.route), Z.chosen));
  }
  if (stand) {
    parts.push(body(agent, stand, data.colors.route));
    parts.push(ringMesh(stand, agent.radius, 0.02, paint(data.colors.route), Z.stand));
    parts.push(ringMesh(stand, agent.reach, 0.025, paint(data.colors.narrow), Z.stand));
  }
  return parts;
}

function boxAround(node, size, color) {
  const shape = new BoxGeometry(...size.map((length) => length + 0.03));
  const edges = new LineSegments(new EdgesGeometry(shape), new LineBasicMaterial({ color }));
  const veil = new Mesh(shape, paint(color, 0.1));
  for (const part of [edges, veil]) {
    part.position.copy(node.position);
    part.quaternion.copy(node.quaternion);
    part.renderOrder = 70;
  }
  return [edges, veil];
}
