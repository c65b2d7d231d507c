// Heat maps over group and K, one panel per scan period: integrality, gaps, proofs of one algorithm.

import { Figure, axis, colors } from "../figure.js";
import { choice, element, shown } from "../dom.js";
import { mean, quantile } from "../stats.js";
import { distinct } from "../data.js";

// Cividis: even in lightness, and the same for the colour blind.
const RAMP = ["#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369",
  "#e1cc55", "#fee838"];

const SHARE = { unit: " %", min: 0, max: 100 };
const MEASURES = {
  integral: { text: "LP optimum integral", ...SHARE,
    of: (rows, own) => share(own.map((row) => rows.get("integral", row))) },
  proven: { text: "proven optimal", ...SHARE,
    of: (rows, own) => share(own.map((row) => rows.get("fate", row) === "optimal")) },
  gap: { text: "mean gap to the best known cost", unit: " nats", log: true,
    of: (rows, own) => mean(known(own.map((row) => rows.get("gap_to_best_nats", row)))) },
  certified: { text: "mean certified gap", unit: " nats", log: true,
    of: (rows, own) => mean(known(own.map((row) => rows.get("certified_gap_nats", row)))) },
  time: { text: "median CPU time", unit: " ms", log: true,
    of: (rows, own) => quantile(known(own.map((row) => rows.get("time_ms", row))), 0.5) },
  columns: { text: "mean columns of a window", unit: "", log: true,
    of: (rows, own) => mean(own.map((row) => rows.get("columns", row))) },
};

const known = (values) => values.filter((value) => value !== null);
function share(values) {
  const told = known(values);
  return told.length ? (100 * told.filter(Boolean).length) / told.length : NaN;
}

/** `suggested`: the algorithm shown first. */
export function heatFigure(name, measure, suggested) {
  let algorithm = suggested;
  let kind = measure;
  let state = null;
  let cells = { periods: [], groups: [], ks: [], values: [] };
  const controls = element("div", { class: "controls" });
  const compute = () => {
    cells = cellsOf(state.rows, state.all.get(algorithm) ?? [], MEASURES[kind]);
    figure.title.textContent = `${MEASURES[kind].text}, ${algorithm}`;
    figure.refresh();
  };
  const figure = new Figure({
    name: `heat-${name}`, title: MEASURES[kind].text, controls,
    draw: (width) => options(cells, MEASURES[kind], width),
    lines: () => [["scan_period_s", "group", "K", "windows", MEASURES[kind].text],
      ...cells.values.map((c) => [c.period, c.group, c.k, c.count, c.value])],
    height: (width) => heightOf(cells, width),
    note: "Over all windows that the filter leaves: Hardness, above, takes easy and hard ones apart.",
  });
  figure.update = (next) => {
    state = next;
    const names = [...state.all.keys()];
    if (!names.includes(algorithm)) algorithm = names.includes(suggested) ? suggested : names[0];
    controls.replaceChildren(
      choice("algorithm", names.map((n) => [n, n]), (v) => ((algorithm = v), compute()), algorithm),
      choice("measure", Object.entries(MEASURES).map(([key, m]) => [key, m.text]),
        (v) => ((kind = v), compute()), kind));
    compute();
  };
  return figure;
}

function cellsOf(rows, own, measure) {
  const found = new Map();
  for (const row of own) {
    const key = ["scan_period_s", "scenario", "window_k"].map((f) => rows.get(f, row)).join("|");
    if (!found.has(key)) found.set(key, []);
    found.get(key).push(row);
  }
  const values = [...found].map(([key, members]) => {
    const [period, group, k] = key.split("|");
    return { period: Number(period), group, k: Number(k), count: members.length,
      value: measure.of(rows, members) };
  });
  return { values, periods: distinct(values.map((c) => c.period)),
    groups: distinct(values.map((c) => c.group)), ks: distinct(values.map((c) => c.k)) };
}

const perLine = (cells, width) => Math.max(1, Math.min(cells.periods.length,
  Math.floor(width / Math.max(250, 70 + 46 * cells.ks.length))));
const panelHeight = (cells) => 66 + 30 * cells.groups.length;
const heightOf = (cells, width) =>
  Math.ceil(cells.periods.length / perLine(cells, width)) * panelHeight(cells) + 34;

/** How values become colours: {least, most, hasZero, scaled(value), isLight(value)}. */
function scaleOf(cells, measure) {
  const told = cells.values.map((c) => c.value).filter(Number.isFinite);
  const positive = told.filter((value) => value > 1e-6);
  const smallest = Math.min(...(positive.length ? positive : [1e-6]));
  const hasZero = Boolean(measure.log) && positive.length < told.length;
  const least = measure.min ?? (hasZero ? smallest / 10 : smallest);
  const most = measure.max ?? Math.max(...told, 1e-6);
  const scaled = (value) => (measure.log ? Math.log(Math.max(value, least)) : value);
  const span = scaled(most) - scaled(least) || 1;
  return { least, most, hasZero, scaled, isLight: (value) => (scaled(value) - scaled(least)) / span > 0.55 };
}

function options(cells, measure, width) {
  const { ink, card } = colors();
  const scale = scaleOf(cells, measure);
  const inLine = perLine(cells, width);
  const left = Math.min(130, 30 + 7 * Math.max(1, ...cells.groups.map((g) => g.length)));
  const panelWidth = width / inLine;
  const panels = cells.periods.map((period, i) => ({ period, i,
    x: (i % inLine) * panelWidth, y: Math.floor(i / inLine) * panelHeight(cells) }));
  const category = (i, data, more) => ({ type: "category", gridIndex: i, data, splitLine: { show: false },
    axisTick: { show: false }, ...more });
  return {
    title: panels.map(({ period, x, y }) => ({ text: `scan period ${period} s`, left: x + left, top: y,
      textStyle: { fontSize: 12, fontWeight: 500, color: ink } })),
    grid: panels.map(({ x, y }) => ({ left: x + left, top: y + 22, width: panelWidth - left - 12,
      height: 30 * cells.groups.length })),
    xAxis: panels.map(({ i }) => axis("K", category(i, cells.ks.map(String), { nameGap: 22 }))),
    yAxis: panels.map(({ i }) => axis("", category(i, cells.groups, { inverse: true }))),
    visualMap: colorBar(scale, measure, ink),
    tooltip: { formatter: ({ data, seriesName }) => `group ${data.value[1]}, K = ${data.value[0]}, ` +
      `${seriesName}<br><b>${shown(data.told, 4)}${measure.unit}</b> over ${data.count} windows` },
    series: panels.map(({ period, i }) => ({ type: "heatmap", name: `${period} s`, xAxisIndex: i,
      yAxisIndex: i, data: cells.values.filter((c) => c.period === period).map((c) => cellOf(c, scale)),
      label: { show: panelWidth / Math.max(1, cells.ks.length) > 34, fontSize: 11,
        formatter: ({ data }) => shown(data.told) },
      itemStyle: { borderColor: card, borderWidth: 2 } })),
  };
}

function cellOf(c, scale) {
  const known = Number.isFinite(c.value);
  return { value: [String(c.k), c.group, known ? scale.scaled(c.value) : "-"], count: c.count, told: c.value,
    label: { color: scale.isLight(c.value) ? "#14171b" : "#ffffff" } };
}

function colorBar({ least, most, hasZero, scaled }, measure, ink) {
  const min = scaled(least);
  return { min, max: Math.max(scaled(most), min + 1e-9), dimension: 2, calculable: false, orient: "horizontal",
    left: "center", bottom: 0, itemWidth: 10, itemHeight: 140, inRange: { color: RAMP },
    text: [`${shown(most)}${measure.unit}`, hasZero ? "0" : shown(least)], textStyle: { color: ink, fontSize: 11 } };
}
