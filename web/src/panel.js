/** The figures beside the picture: they need no 3D and say everything that the picture shows. */
import { byId, el, fill, mark, rowsOf, stateOf } from "./dom.js";

/** Fill what never changes. */
export function fillPanel(data, choose) {
  document.title = `${data.name} - RoboLayout report`;
  byId("name").textContent = data.name;
  byId("task").textContent = data.task;
  const verdict = byId("verdict");
  verdict.className = data.ok ? "good" : "bad";
  verdict.append(mark(stateOf(data.ok)), data.ok ? "All demands are met" : "Not all demands are met");
  fill(byId("checks"), ...data.checks.map(check));
  fill(byId("assets"), ...data.assets.map((asset, i) => assetButton(asset, i, choose)));
  byId("asset-count").textContent = String(data.assets.length);
  const met = data.statements.filter((statement) => statement.met).length;
  byId("statement-count").textContent = `${met} of ${data.statements.length} met`;
  fill(byId("statements"), ...data.statements.map(statementItem));
  byId("rules-part").hidden = !data.rules.length;
  byId("rule-count").textContent = `${data.rules.filter((rule) => rule.met).length} of ${data.rules.length} met`;
  fill(byId("rules"), ...data.rules.map((rule) => statementItem(asStatement(rule, data.agents.length > 1))));
  const total = data.timing.reduce((sum, [, seconds]) => sum + seconds, 0);
  byId("time-total").textContent = `${total.toFixed(2)} s`;
  fill(byId("timing"), ...data.timing.flatMap(([name, seconds]) => [el("dt", {}, name), el("dd", {}, `${seconds.toFixed(3)} s`)]));
  byId("made").textContent = `RoboLayout ${data.version}`;
  byId("assets").addEventListener("keydown", stepThrough);
}

/** Return a rule in the form of a statement. */
function asStatement({ name, asks, source, measured, met, agent }, several) {
  const text = [measured, source, several && agent].filter(Boolean).join(" \u00b7 ");
  return { sentence: `${name}: ${asks}`, met, text };
}

function check({ name, shown, met, share }) {
  const bar = el("span", { className: "bar-fill" });
  bar.style.width = `${100 * (share ?? (met ? 1 : 0))}%`;
  return el(
    "li",
    { className: stateOf(met) },
    mark(stateOf(met)),
    el("span", { className: "check-name" }, name),
    el("span", { className: "bar-track", "aria-hidden": "true" }, bar),
    el("span", { className: "check-value" }, shown),
  );
}

function assetButton(asset, index, choose) {
  const button = el("button", { type: "button", "data-asset": String(index), "aria-pressed": "false" });
  button.addEventListener("click", () => choose(index, { fromList: true }));
  return el("li", {}, button);
}

/** Let the arrow keys walk through the list of assets. */
function stepThrough(event) {
  const steps = { ArrowDown: 1, ArrowUp: -1 };
  if (!(event.key in steps)) return;
  const buttons = [...byId("assets").querySelectorAll("button")];
  const next = buttons[buttons.indexOf(document.activeElement) + steps[event.key]];
  if (!next) return;
  event.preventDefault();
  next.focus();
}

/** Fill the choice of bodies; with one body there is nothing to choose. */
export function fillAgents(data, choose) {
  const host = byId("agents");
  host.hidden = data.agents.length < 2;
  fill(
    host,
    ...data.agents.map((agent, i) => {
      const button = el("button", { type: "button", role: "radio", "data-agent": String(i) }, agent.title);
      button.addEventListener("click", () => choose(i));
      return button;
    }),
  );
  host.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const buttons = [...host.children];
    const next = buttons[(buttons.indexOf(document.activeElement) + step + buttons.length) % buttons.length];
    next.focus();
    next.click();
  });
}

/** Show what is true for the chosen body. */
export function showAgent(data, state) {
  const agent = data.agents[state.agent];
  [...byId("agents").children].forEach((button, i) => {
    button.setAttribute("aria-checked", String(i === state.agent));
    button.tabIndex = i === state.agent ? 0 : -1;
  });
  fill(byId("body"), ...(data.agents.length < 2 ? [el("strong", {}, agent.title), " "] : []), agent.body);
  fill(byId("agent-figures"), ...rowsOf(agent.figures));
  const problems = [...data.problems, ...agent.problems];
  const sentences = problems.map((text) => el("li", { className: "bad" }, mark("bad"), el("span", {}, text)));
  sentences.push(...agent.helps.map((text) => el("li", { className: "help" }, el("span", {}, text))));
  if (!problems.length) sentences.unshift(el("li", { className: "good" }, mark("good"), el("span", {}, "Nothing.")));
  fill(byId("problems"), ...sentences);
  data.assets.forEach((asset, i) => {
    const button = byId("assets").querySelector(`[data-asset="${i}"]`);
    const broken = asset.rows.some(([, , met]) => met === false);
    const unmet = asset.statements.filter((number) => !data.statements[number].met).length;
    const note = unmet ? [el("small", {}, unmet > 1 ? `${unmet} statements unmet` : "1 statement unmet")] : [];
    fill(button, mark(broken ? "bad" : agent.assets[i].state), el("span", {}, asset.label), ...note);
    button.setAttribute("aria-pressed", String(i === state.asset));
  });
}

/** Show the chosen asset: what it is, where it stands, what was said of it, and what the body makes of it. */
export function showAsset(data, state, close) {
  const card = byId("asset");
  card.hidden = state.asset === null;
  if (state.asset === null) {
    fill(card);
    return;
  }
  const asset = data.assets[state.asset];
  const agent = data.agents[state.agent];
  const button = el("button", { type: "button", className: "close", "aria-label": "Close" }, "\u00d7");
  button.addEventListener("click", close);
  const statements = asset.statements.map((i) => data.statements[i]);
  fill(
    card,
    el("div", { className: "card-head" }, el("h2", {}, asset.label), button),
    el("p", { className: "category" }, asset.category, " \u00b7 ", el("code", {}, asset.name)),
    ...(asset.description ? [el("p", { className: "description" }, asset.description)] : []),
    el("dl", {}, ...rowsOf(placeRows(asset))),
    el("h3", {}, agent.title),
    el("dl", {}, ...rowsOf(agent.assets[state.asset].rows)),
    el("h3", {}, statements.length ? "Statements about it" : "No statement is about it"),
    el("ul", { className: "statements" }, ...statements.map(statementItem)),
  );
}

function placeRows({ size, pose, rows }) {
  const [depth, width, height] = size.map((length) => length.toFixed(2));
  const found = [["Size", `${width} wide, ${depth} deep, ${height} high (m)`, null]];
  if (pose) {
    const degrees = Math.round((((pose.yaw * 180) / Math.PI) % 360 + 360) % 360);
    found.push(["Centre", `${pose.x.toFixed(2)}, ${pose.y.toFixed(2)}, ${pose.z.toFixed(2)} m, turned ${degrees}\u00b0`, null]);
  }
  return [...found, ...rows];
}

function statementItem({ sentence, met, text, limit, note, line }) {
  const measured = [text, limit && `limit ${limit}`, line && `line ${line}`].filter(Boolean).join(" \u00b7 ");
  return el(
    "li",
    { className: stateOf(met) },
    mark(stateOf(met)),
    el("div", {}, el("code", {}, sentence), el("p", {}, measured), ...(note ? [el("p", { className: "note" }, note)] : [])),
  );
}
