/** The page: one state, and the parts that show it. */
import { REVISION } from "three";
import { readData, readMeshes } from "./data.js";
import { byId, calm, el, fill, narrow } from "./dom.js";
import { readGlb } from "./glb.js";
import { makeLabels, project } from "./labels.js";
import { makeOverlays } from "./overlays.js";
import { fillAgents, fillPanel, showAgent, showAsset } from "./panel.js";
import { makePicking } from "./pick.js";
import { makePlayer, momentsOf, poseAt } from "./player.js";
import { sortRoom } from "./room.js";
import { look, makeStage } from "./stage.js";

const data = readData();
const state = { agent: 0, asset: null, at: 0, atEnd: true, layers: { free: true, routes: true, reach: false, labels: true } };
const canvas = byId("canvas");
document.documentElement.dataset.three = REVISION;

/** Draw in 3D; where the browser cannot, say so: the figures and lists need no picture. */
async function draw() {
  try {
    const root = await readGlb(readMeshes());
    const room = sortRoom(root, data);
    const stage = makeStage(canvas, root, room, data);
    const overlays = makeOverlays(stage, room.assets, data);
    const labels = makeLabels(stage, room.assets, data, byId("labels"));
    drawn = { stage, assets: room.assets, overlays, labels };
    makePicking(stage, room.assets, canvas, choose);
    showMoment();
    showPicture();
    await stage.start();
    document.documentElement.dataset.drawn = performance.now().toFixed();
    document.documentElement.dataset.ready = "3d";
  } catch (error) {
    const message = byId("message");
    message.hidden = false;
    message.textContent = `No 3D here: ${error.message} The figures and lists need none.`;
    document.body.classList.add("flat");
    document.documentElement.dataset.ready = "flat";
  }
}

function showMoment() {
  if (!drawn) return;
  poseAt(drawn.assets, data, moments, state.at);
  drawn.stage.moved();
}

function showPicture() {
  if (!drawn) return;
  drawn.overlays.show(state);
  drawn.labels.show(state);
}

function showLegend() {
  const agent = data.agents[state.agent];
  const [stand, way] = [agent.assets[state.asset]?.stand, agent.routes[state.asset]];
  const rows = [
    [state.layers.free && agent.islands.length, "islands", "free, but cut off"],
    [state.layers.routes && agent.passage.length, "narrow", "narrowest way"],
    [state.layers.reach && agent.beyond.length, "beyond", "floor out of reach"],
    [state.layers.reach && agent.turns.length, "turn", "room to turn round"],
    [way?.length > 1, "way", "way until it is within reach"],
    [stand, "stand", "where the body uses it"],
    [stand, "ring", "how far it reaches there"],
  ];
  const shown = state.atEnd ? rows.filter(([wanted]) => wanted) : [];
  fill(byId("legend"), ...shown.map(([, name, text]) => el("li", {}, el("i", { className: `swatch ${name}` }), text)));
}

function show() {
  showAgent(data, state);
  showAsset(data, state, () => choose(null));
  showLegend();
  showPicture();
}

/** Choose an asset, or none; who chose it from the list goes on reading in its card. */
function choose(index, { fromList = false } = {}) {
  const [before, card] = [state.asset, byId("asset")];
  const inside = card.contains(document.activeElement);
  state.asset = index;
  show();
  if (index !== null) {
    card.scrollIntoView({ block: narrow() ? "start" : "nearest", behavior: calm() ? "auto" : "smooth" });
    if (fromList) card.focus({ preventScroll: true });
  } else if (inside) byId("assets").querySelector(`[data-asset="${before}"]`).focus();
}

function wire() {
  for (const button of byId("layers").children) {
    button.addEventListener("click", () => {
      const { layer } = button.dataset;
      state.layers[layer] = !state.layers[layer];
      button.setAttribute("aria-pressed", String(state.layers[layer]));
      if (layer !== "labels" && state.layers[layer] && !state.atEnd) player.finish();
      show();
    });
  }
  for (const button of byId("cameras").children) {
    button.addEventListener("click", () => drawn && look(drawn.stage, button.dataset.camera, data.agents[state.agent]));
  }
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && state.asset !== null) choose(null);
  });
}

let drawn = null;
const moments = momentsOf(data);
fillPanel(data, choose);
fillAgents(data, (index) => {
  state.agent = index;
  show();
});
const player = makePlayer(data, moments, (at) => {
  state.at = at;
  state.atEnd = at >= moments.length - 1;
  showMoment();
  showLegend();
  showPicture();
});
wire();
show();
// The figures are there before the picture, which may take a second where there is no graphics card.
requestAnimationFrame(() => setTimeout(draw));

/** Where the middle of an asset is drawn, in pixels of the canvas: for tests and for scripts beside the page. */
globalThis.robolayout = {
  project: (name) => {
    const index = data.assets.findIndex((asset) => asset.name === name);
    const { x, y, z } = drawn.assets[index].position;
    return project(drawn.stage, x, y, z);
  },
};
