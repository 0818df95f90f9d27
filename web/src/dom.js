/** Small helpers for the page. Text from the scene only ever becomes a text node. */

/** Return the element of an id. */
export const byId = (id) => document.getElementById(id);

/** Return a new element with a class, attributes and children (elements, or text). */
export function el(tag, { className = "", ...attributes } = {}, ...children) {
  const node = document.createElement(tag);
  if (className) node.className = className;
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** Put new children in place of all that a node has. */
export function fill(node, ...children) {
  node.replaceChildren(...children);
  return node;
}

const MARKS = { good: "\u2713", bad: "\u2717", free: "\u2013" };
const WORDS = { good: "met", bad: "not met", free: "not asked" };

/** Return the state of a verdict: true, false, or null where nothing is asked. */
export const stateOf = (met) => (met === null ? "free" : met ? "good" : "bad");

/** Return a mark for a verdict, which carries its meaning by shape, colour and word. */
export function mark(state) {
  return el("i", { className: `mark ${state}`, role: "img", "aria-label": WORDS[state] }, MARKS[state]);
}

/** Return the rows of a verdict as the entries of a description list. */
export function rowsOf(rows) {
  return rows.flatMap(([name, text, met]) => [
    el("dt", {}, name),
    el("dd", {}, ...(met === null ? [] : [mark(stateOf(met))]), text),
  ]);
}

/** Whether the reader asked for less motion. */
export const calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Whether the picture stands above the figures instead of beside them. */
export const narrow = () => matchMedia("(max-width: 860px)").matches;
