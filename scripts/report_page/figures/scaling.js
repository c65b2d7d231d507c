// How time grows with the size of a window: medians with the middle half, on double logarithmic
// axes, and the exponent of the growth.

import { Figure, axis } from "../figure.js";
import { choice, element, shown } from "../dom.js";
import { lookOf, swatch } from "../look.js";
import { exponent, quantile } from "../stats.js";
import { ContestChoice } from "./contest_choice.js";

const BINS = 10;
const SIZES = [["window_k", "K"], ["columns", "columns"], ["targets", "targets"],
  ["largest_component_columns", "columns of the largest component"]];
const SHORTEST_MS = 1e-3; // a shorter time counts as this one, as the clock's step

export function scalingFigure() {
  let size = "columns";
  let curves = [];
  const windows = new ContestChoice((contest, rows) => {
    curves = contest ? contest.algorithms.map((name) => curveOf(rows, name, contest.members.get(name), size))
      .filter((curve) => curve.points.length) : [];
    figure.title.textContent = `${title} (${contest?.windows.length ?? 0} ${contest?.hardness ?? ""} windows)`;
    figure.redrawLegend();
    figure.refresh();
  }, [choice("against", SIZES, (value) => {
    size = value;
    windows.again();
  }, size)]);
  const title = "Time against size";
  const name = () => SIZES.find(([key]) => key === size)[1];
  const figure = new Figure({
    name: "scaling", title, controls: windows.controls, height: (width) => (width < 500 ? 320 : 400),
    note: "Median CPU time of the windows solved in time; the band holds their middle half. Windows are binned " +
      "evenly in the logarithm of their size. Exponent: least squares of log time on log size, every window once.",
    draw: () => options(curves, name()),
    lines: () => [["algorithm", name(), "median_ms", "quartile_1_ms", "quartile_3_ms", "windows", "exponent"],
      ...curves.flatMap((c) => c.points.map((p) => [c.algorithm, p.x, p.median, p.low, p.high, p.count, c.exponent]))],
  });
  figure.update = (state) => windows.update(state);
  figure.redrawLegend = () => figure.below.replaceChildren(element("div", { class: "legend" },
    ...curves.map((c) => element("span", {}, swatch(c.algorithm), c.algorithm,
      Number.isNaN(c.exponent) ? "" : ` ∝ ${shownExponent(c.exponent)}`))));
  return figure;
}

const shownExponent = (b) => `x^${b.toFixed(2)}`;

function curveOf(rows, algorithm, own, size) {
  const pairs = own.filter((row) => rows.get("in_time", row) && rows.get(size, row) > 0)
    .map((row) => [rows.get(size, row), Math.max(rows.get("charged_ms", row), SHORTEST_MS)]);
  const bins = new Map();
  const low = Math.log(pairs.reduce((a, [x]) => Math.min(a, x), Infinity));
  const high = Math.log(pairs.reduce((a, [x]) => Math.max(a, x), 0));
  for (const [x, t] of pairs) {
    const bin = size === "window_k" ? x
      : Math.min(BINS - 1, Math.floor((BINS * (Math.log(x) - low)) / (high - low || 1)));
    if (!bins.has(bin)) bins.set(bin, []);
    bins.get(bin).push([x, t]);
  }
  const points = [...bins].sort(([a], [b]) => a - b).map(([, members]) => {
    const times = members.map(([, t]) => t);
    return { x: quantile(members.map(([x]) => x), 0.5), median: quantile(times, 0.5),
      low: quantile(times, 0.25), high: quantile(times, 0.75), count: members.length };
  });
  return { algorithm, points, exponent: exponent(pairs.map(([x]) => x), pairs.map(([, t]) => t)) };
}

function options(curves, xName) {
  const number = (x) => String(Number(x.toPrecision(2)));
  const xs = curves.flatMap((c) => c.points.map((p) => p.x));
  const ys = curves.flatMap((c) => c.points.flatMap((p) => [p.low, p.high]));
  const decade = (round, y) => 10 ** round(Math.log10(y));
  const label = { ...axis("").axisLabel, formatter: number };
  return {
    grid: { left: 62, right: 16, top: 12, bottom: 46 },
    xAxis: axis(xName, { type: "log", axisLabel: label,
      ...(xs.length ? { min: Math.min(...xs) / 1.05, max: Math.max(...xs) * 1.05 } : {}) }),
    yAxis: axis("CPU time [ms]", { type: "log", nameGap: 46, axisLabel: label,
      ...(ys.length ? { min: decade(Math.floor, Math.min(...ys)), max: decade(Math.ceil, Math.max(...ys)) } : {}) }),
    tooltip: { trigger: "item", formatter: ({ seriesName, data }) => `<b>${seriesName}</b><br>${xName} ` +
      `${shown(data[0])}: ${shown(data[1])} ms [${shown(data[2])}, ${shown(data[3])}], ${data[4]} windows` },
    series: [...curves.map(band), ...curves.map((c) => {
      const { color, symbol, dash } = lookOf(c.algorithm);
      return { name: c.algorithm, type: "line", color, symbol, symbolSize: 8, z: 3,
        lineStyle: { color, type: dash, width: 2 },
        data: c.points.map((p) => [p.x, p.median, p.low, p.high, p.count]) };
    })],
  };
}

function band(curve) {
  const { color } = lookOf(curve.algorithm);
  const outline = [...curve.points.map((p) => [p.x, p.high]), ...curve.points.map((p) => [p.x, p.low]).reverse()];
  return { type: "custom", silent: true, z: 1, data: curve.points.length > 1 ? [outline.flat()] : [],
    renderItem: (_, api) => ({ type: "polygon",
      shape: { points: outline.map((point) => api.coord(point)) },
      style: { fill: color, opacity: 0.1 } }) };
}

