// How an algorithm looks in every chart: the palette of the printed figures, for this page's
// ground, with the markers and dashes as ECharts names them.

import { isDark } from "./theme.js";
import { element } from "./dom.js";

const SYMBOLS = {
  o: "circle", s: "rect", D: "diamond", "^": "triangle", ".": "circle",
  v: "path://M0,0 L10,0 L5,9 Z",
  "<": "path://M10,0 L10,10 L1,5 Z",
  ">": "path://M0,0 L0,10 L9,5 Z",
  d: "path://M3,0 L6,5 L3,10 L0,5 Z",
  p: "path://M5,0 L10,4 L8,10 L2,10 L0,4 Z",
  h: "path://M5,0 L10,3 L10,8 L5,11 L0,8 L0,3 Z",
  P: "path://M3,0 L7,0 L7,3 L10,3 L10,7 L7,7 L7,10 L3,10 L3,7 L0,7 L0,3 L3,3 Z",
  X: "path://M0,2 L2,0 L5,3 L8,0 L10,2 L7,5 L10,8 L8,10 L5,7 L2,10 L0,8 L3,5 Z",
  "*": "path://M5,0 L6.2,3.6 L10,3.8 L7,6.2 L8,10 L5,7.8 L2,10 L3,6.2 L0,3.8 L3.8,3.6 Z",
  x: "path://M0,1 L1,0 L5,4 L9,0 L10,1 L6,5 L10,9 L9,10 L5,6 L1,10 L0,9 L4,5 Z",
};
const DASHES = { "-": "solid", "--": [7, 4], ":": [2, 3], "-.": [8, 3, 2, 3] };

let styles = {};

/** `given`: by algorithm {color, dark, marker, dash}. */
export function setStyles(given) {
  styles = given;
}

/** {color, symbol, dash} of an algorithm on the present ground. */
export function lookOf(algorithm) {
  const style = styles[algorithm] ?? { color: "#777777", dark: "#A0A0A0", marker: "o", dash: "-" };
  return {
    color: isDark() ? style.dark : style.color,
    symbol: SYMBOLS[style.marker] ?? "circle",
    dash: DASHES[style.dash] ?? "solid",
    name: algorithm,
  };
}

/** A line of the names of algorithms, each with its line and marker. */
export function legend(algorithms) {
  return element("div", { class: "legend" },
    ...algorithms.map((name) => element("span", {}, swatch(name), name)));
}

/** A little picture of an algorithm's line and marker. */
export function swatch(algorithm) {
  const { color, symbol, dash } = lookOf(algorithm);
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("class", "swatch");
  svg.setAttribute("viewBox", "0 0 30 14");
  svg.setAttribute("aria-hidden", "true");
  const add = (name, attributes) => {
    const part = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) part.setAttribute(key, value);
    svg.append(part);
  };
  add("line", { x1: 0, y1: 7, x2: 30, y2: 7, stroke: color, "stroke-width": 2,
    "stroke-dasharray": Array.isArray(dash) ? dash.join(" ") : "none" });
  const shapes = { circle: "M5,0 A5,5 0 1 1 4.99,0 Z", rect: "M0,0 H10 V10 H0 Z",
    diamond: "M5,-1 L11,5 L5,11 L-1,5 Z", triangle: "M5,0 L10,10 L0,10 Z" };
  const outline = shapes[symbol] ?? symbol.replace("path://", "");
  add("path", { d: outline, fill: color, transform: "translate(10 2)" });
  return svg;
}
