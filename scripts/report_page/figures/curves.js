// Curves over shared windows: performance profiles and time to a gap.

import { Figure, axis } from "../figure.js";
import { choice } from "../dom.js";
import { legend, lookOf } from "../look.js";

const POINTS = 480;

/** Step curve: share of `values` (Infinity: never) at most x, at `POINTS` places spaced evenly in
 *  log x from `low` to `high`. */
function shares(values, low, high) {
  const sorted = Float64Array.from(values).sort();
  const points = [];
  let place = 0;
  for (let i = 0; i <= POINTS; ++i) {
    const x = low * (high / low) ** (i / POINTS);
    while (place < sorted.length && sorted[place] <= x * (1 + 1e-12)) ++place;
    points.push([x, values.length ? place / values.length : 0]);
  }
  return points;
}

function spread(curves) {
  let low = Infinity;
  let high = 0;
  for (const values of curves.values()) {
    for (const value of values) {
      if (!Number.isFinite(value) || value <= 0) continue;
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return low < high ? [low, high] : [1, 10];
}

function options(curves, xName, from) {
  const [low, high] = spread(curves);
  const start = from ?? low;
  const end = Math.max(high, start * 1.01);
  return {
    grid: { left: 52, right: 16, top: 12, bottom: 46 },
    xAxis: axis(xName, { type: "log", min: start, max: end,
      axisLabel: { ...axis("").axisLabel, formatter: (x) => String(Number(x.toPrecision(2))) } }),
    yAxis: axis("", { type: "value", min: 0, max: 1,
      axisLabel: { ...axis("").axisLabel, formatter: (y) => `${Math.round(100 * y)} %` } }),
    tooltip: { trigger: "axis", order: "valueDesc",
      valueFormatter: (y) => `${(100 * y).toFixed(1)} %` },
    series: [...curves].map(([name, values]) => {
      const { color, dash } = lookOf(name);
      return { name, type: "line", step: "end", showSymbol: false, color,
        data: shares(values, start, end), lineStyle: { color, type: dash, width: 2 } };
    }),
  };
}

function csvOf(curves, xName, from) {
  const [low, high] = spread(curves);
  const start = from ?? low;
  const lines = [["algorithm", xName, "share"]];
  for (const [name, values] of curves) {
    for (const [x, y] of shares(values, start, Math.max(high, start * 1.01))) lines.push([name, x, y]);
  }
  return lines;
}

function curveFigure(name, title, xName, from, curvesOf, controls, note) {
  let curves = new Map();
  const figure = new Figure({ name, title, controls, note,
    draw: () => options(curves, xName, from), lines: () => csvOf(curves, xName, from) });
  figure.update = (state) => {
    curves = curvesOf(state);
    figure.title.textContent = `${title} (${state.shared.size} windows)`;
    figure.below.replaceChildren(legend([...curves.keys()]));
    figure.refresh();
  };
  figure.redrawLegend = () => figure.below.replaceChildren(legend([...curves.keys()]));
  return figure;
}

/** Times over the best time of the same window; Infinity without an answer that stands. */
function profileCurves({ rows, members, shared }) {
  const best = new Map();
  const time = (row) => (rows.isAnswered(row) ? Math.max(rows.get("time_ms", row), 1e-6) : Infinity);
  for (const own of members.values()) {
    for (const row of own) {
      const window = rows.window[row];
      best.set(window, Math.min(best.get(window) ?? Infinity, time(row)));
    }
  }
  return new Map([...members].map(([name, own]) => [name, own
    .filter((row) => shared.has(rows.window[row]))
    .map((row) => time(row) / best.get(rows.window[row]))
    .map((ratio) => (Number.isNaN(ratio) ? Infinity : ratio))]));
}

export function profileFigure() {
  return curveFigure("profile", "Performance profile", "CPU time ÷ best CPU time of the window", 1,
    profileCurves, null, "Share of the windows that are answered within a multiple of the best " +
    "time. It is taken over the algorithms that are chosen: leaving one out may reorder the rest.");
}

export function timeToGapFigure() {
  const targets = [["0", "optimal"], ["0.001", "0.1 % of the optimum"], ["0.01", "1 %"], ["0.1", "10 %"]];
  let target = 0;
  let last = null;
  const controls = choice("gap at most", targets, (value) => {
    target = Number(value);
    if (last) figure.update(last);
  });
  controls.className = "controls";
  const curves = ({ rows, members, shared }) => new Map([...members].map(([name, own]) => [name, own
    .filter((row) => shared.has(rows.window[row]))
    .map((row) => (reached(rows, row, target) ? rows.get("time_ms", row) : Infinity))]));
  const figure = curveFigure("time-to-gap", "Time to a gap", "CPU time [ms]", null,
    (state) => curves((last = state)), controls,
    "Share of the windows whose answer is within the gap after that time; a curve ends at the " +
    "share that reaches it at all.");
  return figure;
}

function reached(rows, row, target) {
  const gap = rows.get("certified_gap_nats", row);
  if (gap === null || !rows.isAnswered(row)) return false;
  const size = Math.abs(rows.get("reference_cost_nats", row) ?? 0);
  return gap <= Math.max(1e-5, target * size);
}
