/** Names over assets, as text on top of the picture; of those that would cover each other the less important hide. */
import { el, fill, mark } from "./dom.js";

const ORDER = { floor: 0, wall: 1, object: 2, ceiling: 3, flat: 4 };
const GAP = 3;

/** Return the labels; `show` says which are wanted, `follow` puts them where their things are drawn. */
export function makeLabels(stage, assets, data, host) {
  const names = data.assets.map((asset) => el("span", { className: "label" }, asset.label));
  const gaps = data.agents.map((agent) =>
    agent.passage.map(({ a, b, text }) => ({ at: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], node: el("span", { className: "label gap" }, text) })),
  );
  fill(host, ...names, ...gaps.flat().map(({ node }) => node));
  let state = null;
  const labels = {
    show(next) {
      state = next;
      data.assets.forEach((asset, i) => {
        const verdict = state.atEnd ? data.agents[state.agent].assets[i].state : "good";
        const shown = verdict === "bad" || (state.layers.reach && state.atEnd);
        fill(names[i], ...(shown ? [mark(verdict)] : []), asset.label);
        names[i].classList.toggle("chosen", i === state.asset);
      });
      labels.follow();
    },
    follow() {
      if (!state) return;
      const taken = [];
      for (const { node, point } of wanted(state, names, gaps, assets, data)) put(stage, node, point, taken);
    },
  };
  stage.after.push(labels.follow);
  return labels;
}

/** Return the labels in the order in which they get their place, each with its point in the room, or none. */
function wanted(state, names, gaps, assets, data) {
  const entries = names.map((node, i) => {
    const { size, level } = data.assets[i];
    const chosen = i === state.asset;
    const bad = state.atEnd && data.agents[state.agent].assets[i].state === "bad";
    const point = assets[i] && (chosen || state.layers.labels) ? assets[i].position : null;
    const top = point && [point.x, point.y, point.z + size[2] / 2 + 0.06];
    return { node, point: top, rank: chosen ? -2 : bad ? -1 : ORDER[level] - Math.min(size[0] * size[1] * size[2], 9) / 10 };
  });
  gaps.forEach((list, agent) => {
    const shown = agent === state.agent && state.atEnd && state.layers.routes;
    for (const { node, at } of list) entries.push({ node, point: shown ? [...at, 0.05] : null, rank: -1.5 });
  });
  return entries.sort((a, b) => a.rank - b.rank);
}

function put(stage, node, point, taken) {
  const spot = point && project(stage, ...point);
  if (!spot) {
    node.hidden = true;
    return;
  }
  node.hidden = false;
  const [width, height] = [node.offsetWidth, node.offsetHeight];
  const box = { left: spot[0] - width / 2, top: spot[1] - height, right: spot[0] + width / 2, bottom: spot[1] };
  if (taken.some((other) => box.left < other.right + GAP && other.left < box.right + GAP && box.top < other.bottom + GAP && other.top < box.bottom + GAP)) {
    node.hidden = true;
    return;
  }
  taken.push(box);
  node.style.transform = `translate(${Math.round(box.left)}px, ${Math.round(box.top)}px)`;
}

/** Return where a point of the room (metres) is drawn, in pixels of the canvas; null behind the eye. */
export function project(stage, x, y, z) {
  const at = stage.toWorld(x, y, z).project(stage.camera);
  if (at.z > 1) return null;
  return [((at.x + 1) / 2) * stage.size[0], ((1 - at.y) / 2) * stage.size[1]];
}
