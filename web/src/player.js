/** The search, step by step: a slider over its moments, the curve of the loss above it, and a button that plays it. */
import { byId, calm } from "./dom.js";

const PACE = 90;
const SVG = "http://www.w3.org/2000/svg";

/** Return the moments: those of the search, then the result. */
export function momentsOf(data) {
  const last = { step: data.trace.steps, stage: "result", poses: data.assets.map((asset) => asset.pose) };
  return [...data.trace.frames, last];
}

/** Put every asset where it was at a moment, or part of the way to the next one. */
export function poseAt(assets, data, moments, at) {
  const [first, share] = [Math.floor(at), at - Math.floor(at)];
  const [from, to] = [moments[first].poses, (moments[first + 1] ?? moments[first]).poses];
  assets.forEach((node, i) => {
    if (!node) return;
    const here = from[i] ?? to[i];
    node.visible = here !== null;
    if (!here) return;
    const there = to[i] ?? here;
    const yaw = here.yaw + share * shortest(there.yaw - here.yaw);
    const { z } = data.assets[i].pose;
    node.position.set(here.x + share * (there.x - here.x), here.y + share * (there.y - here.y), z);
    node.quaternion.set(0, 0, Math.sin(yaw / 2), Math.cos(yaw / 2));
  });
}

const shortest = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

/** Wire the slider and the button; `show` is called with the moment, a fraction while it plays. */
export function makePlayer(data, moments, show) {
  const [slider, button, output] = [byId("step"), byId("play"), byId("moment")];
  byId("player").hidden = moments.length < 2;
  slider.max = String(moments.length - 1);
  slider.value = slider.max;
  drawCurve(data, moments);
  let run = 0;
  const go = (at) => {
    const { step, stage } = moments[Math.floor(at)];
    const words = stage === "result" ? "result" : `${stage}, step ${step}`;
    output.textContent = words;
    slider.setAttribute("aria-valuetext", words);
    moveMark(data, step);
    show(at);
  };
  const stop = () => {
    run += 1;
    button.classList.remove("playing");
    button.setAttribute("aria-label", "Play the search");
  };
  const play = () => {
    const mine = (run += 1);
    button.classList.add("playing");
    button.setAttribute("aria-label", "Pause");
    const last = moments.length - 1;
    const begin = Number(slider.value) === last ? 0 : Number(slider.value);
    const start = performance.now();
    const tick = (now) => {
      if (mine !== run) return;
      const at = Math.min(begin + Math.max(now - start, 0) / PACE, last);
      slider.value = String(Math.floor(at));
      go(calm() ? Math.floor(at) : at);
      if (at < last) requestAnimationFrame(tick);
      else stop();
    };
    requestAnimationFrame(tick);
  };
  button.addEventListener("click", () => (button.classList.contains("playing") ? stop() : play()));
  slider.addEventListener("input", () => {
    stop();
    go(Number(slider.value));
  });
  go(moments.length - 1);
  return {
    /** Leave the search and show the result. */
    finish() {
      stop();
      slider.value = slider.max;
      go(moments.length - 1);
    },
  };
}

function drawCurve({ trace }, moments) {
  const svg = byId("curve");
  if (trace.curve.length < 2) return;
  const values = trace.curve.map(([, value]) => value);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const points = trace.curve.map(([step, value]) => `${across(moments, step)},${2 + (20 * (high - value)) / (high - low || 1)}`);
  const line = document.createElementNS(SVG, "polyline");
  line.setAttribute("points", points.join(" "));
  const now = document.createElementNS(SVG, "line");
  now.id = "now";
  now.setAttribute("y1", "0");
  now.setAttribute("y2", "24");
  svg.append(line, now);
  svg.moments = moments;
}

/** Return where a step lies on the slider, in hundredths of its length: moments are not evenly spread over steps. */
function across(moments, step) {
  const after = moments.findIndex((moment) => moment.step >= step);
  if (after <= 0) return after === 0 ? 0 : 100;
  const [a, b] = [moments[after - 1].step, moments[after].step];
  return (100 * (after - 1 + (step - a) / (b - a || 1))) / (moments.length - 1);
}

function moveMark({ trace }, step) {
  const [now, svg] = [byId("now"), byId("curve")];
  if (!now) return;
  const at = step >= trace.steps ? 100 : across(svg.moments, step);
  now.setAttribute("x1", String(at));
  now.setAttribute("x2", String(at));
}
