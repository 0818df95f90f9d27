"use strict";
// Shows rows of rooms as cards; filters are made from what the columns hold. Texts are only ever shown as text.
const { columns, rows, thumbs } = JSON.parse(document.getElementById("data").textContent);
const AT_ONCE = 60, FEW = 24;
const at = Object.fromEntries(columns.map((name, i) => [name, i]));
const form = document.getElementById("filters"), main = document.getElementById("rooms");
let start = 0;

function made(kind, text, parent) {
  const element = document.createElement(kind);
  if (text !== undefined) element.textContent = text;
  if (parent) parent.append(element);
  return element;
}

function shown(value) {
  return typeof value === "number" && !Number.isInteger(value) ? String(+value.toPrecision(4)) : String(value ?? "");
}

const values = (name) => [...new Set(rows.map((row) => row[at[name]]).filter((value) => value !== null && value !== ""))];
const tests = [];

function words() {
  const input = made("input", undefined, made("label", "words", form));
  input.type = "search";
  tests.push((row) => row.some((cell) => typeof cell === "string" && cell.toLowerCase().includes(input.value.toLowerCase())));
}

function choice(name, found) {
  const select = made("select", undefined, made("label", name, form));
  for (const value of ["", ...found]) made("option", String(value), select);
  tests.push((row) => select.value === "" || String(row[at[name]]) === select.value);
}

function range(names) {
  const label = made("label", "", form), select = made("select", undefined, label);
  for (const name of names) made("option", name, select);
  const [low, high] = ["from", "to"].map((word) => {
    const input = made("input", undefined, label);
    input.type = "number";
    input.step = "any";
    input.placeholder = word;
    input.ariaLabel = word;
    return input;
  });
  const order = made("select", undefined, made("label", "order", form));
  for (const word of ["as made", "rising", "falling"]) made("option", word, order);
  tests.push((row) => {
    const value = row[at[select.value]];
    return (low.value === "" || value >= +low.value) && (high.value === "" || (value !== null && value <= +high.value));
  });
  return (found) => {
    const sign = { rising: 1, falling: -1 }[order.value], column = at[select.value];
    return sign ? found.sort((a, b) => sign * ((a[column] ?? -Infinity) - (b[column] ?? -Infinity))) : found;
  };
}

words();
for (const name of columns) {
  const found = values(name);
  if (found.length > 1 && found.length <= FEW && found.every((value) => typeof value !== "number")) choice(name, found.sort());
}
const sorted = range(columns.filter((name) => values(name).some((value) => typeof value === "number")));

function card(row) {
  const button = made("button", undefined, main);
  if (thumbs && row[at.status] !== "missing") {
    const picture = made("img", undefined, button);
    picture.loading = "lazy";
    picture.alt = "";
    picture.src = row[at.path].split("/").map(encodeURIComponent).join("/") + "/thumb.png";
  }
  made("b", shown(row[at.room] ?? row[0]) + " " + shown(row[at.source] ?? row[at.name]), button);
  const size = [row[at.width], row[at.depth]].map(shown).join(" x ");
  made("small", `${size} m, ${shown(row[at.things])} things, ${shown(row[at.bodies])}`, button);
  const met = row[at.ok] === true;
  made("small", met ? "all demands met" : shown(row[at.why]) || "not all demands met", button).className = met ? "met" : "short";
  button.onclick = () => detail(row);
}

function detail(row) {
  const dialog = document.getElementById("one"), table = dialog.querySelector("table");
  table.replaceChildren();
  columns.forEach((name, i) => {
    if (row[i] === null || row[i] === "") return;
    const line = made("tr", undefined, table);
    made("td", name, line);
    made("td", shown(row[i]), line);
  });
  dialog.showModal();
}

function draw() {
  const found = sorted(rows.filter((row) => tests.every((test) => test(row))));
  start = Math.max(0, Math.min(start, Math.floor((found.length - 1) / AT_ONCE) * AT_ONCE));
  main.replaceChildren();
  found.slice(start, start + AT_ONCE).forEach(card);
  document.getElementById("where").textContent =
    found.length ? `${start + 1} to ${Math.min(start + AT_ONCE, found.length)} of ${found.length}` : "none";
}

form.oninput = () => { start = 0; draw(); };
form.onsubmit = (event) => event.preventDefault();
document.getElementById("before").onclick = () => { start -= AT_ONCE; draw(); };
document.getElementById("after").onclick = () => { start += AT_ONCE; draw(); };
draw();
