// Points with intervals: the ranking as a picture, and gap against time.

import { Figure, axis, colors } from "../figure.js";
import { shown } from "../dom.js";
import { lookOf } from "../look.js";

const interval = (e) => (e.low === null ? "" : ` [${shown(e.low)}, ${shown(e.high)}]`);
const told = (e) => `${shown(e.value)}${interval(e)}`;

/** Mean gap against time, both with intervals, and the line of those that none beats in both. */
export function paretoFigure() {
  let lines = [];
  let shared = 0;
  const title = "Gap against time";
  const figure = new Figure({
    name: "pareto", title, height: (width) => (width < 500 ? 330 : 420),
    note: "Mean certified gap and shifted geometric mean of the CPU time, each with its 95 % " +
      "interval over scenarios; the line joins those that no other beats in both. A gap of 0 " +
      "stands on the lower edge.",
    draw: (width) => options(lines, width),
    lines: () => [["algorithm", "time_ms", "time_low", "time_high", "gap_nats", "gap_low", "gap_high"],
      ...lines.map((l) => [l.algorithm, l.time.value, l.time.low, l.time.high, l.gap.value,
        l.gap.low, l.gap.high])],
  });
  figure.update = (state) => {
    lines = state.ranking.lines.filter((l) => l.time && l.gap && l.refuted === 0);
    shared = state.ranking.shared;
    figure.title.textContent = `${title} (${shared} windows)`;
    figure.refresh();
  };
  return figure;
}

/** Points that no other is at most equal to in both and less in one. */
export function front(points) {
  return points.filter((p) => !points.some((q) => q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y)))
    .sort((a, b) => a.x - b.x);
}

function options(lines, width) {
  const { muted } = colors();
  const positive = lines.map((l) => l.gap.value).filter((gap) => gap > 1e-6);
  const least = positive.length ? Math.min(...positive) : 1e-3;
  const hasZero = positive.length < lines.length;
  const floor = hasZero ? least / 10 : least / 1.8;
  const y = (gap) => Math.max(gap, floor);
  const points = lines.map((l) => ({ x: Math.max(l.time.value, 1e-6), y: y(l.gap.value), line: l }));
  const edge = front(points);
  const label = (p) => ({ show: lines.length <= 12 || edge.includes(p), position: "top",
    formatter: p.line.algorithm, color: lookOf(p.line.algorithm).color, fontSize: 12, distance: 9 });
  return {
    grid: { left: 62, right: width < 500 ? 16 : 40, top: 18, bottom: 46 },
    xAxis: axis("CPU time, shifted geometric mean [ms]", { type: "log", ...around(points.map((p) => p.x)),
      axisLabel: { ...axis("").axisLabel, formatter: (x) => String(Number(x.toPrecision(2))) } }),
    yAxis: axis("mean gap [nats]", { type: "log", nameGap: 44, min: floor,
      max: Math.max(least, ...positive, ...lines.map((l) => l.gap.high ?? 0)) * 2,
      axisLabel: { ...axis("").axisLabel,
        formatter: (v) => (hasZero && v <= floor * 1.01 ? "0" : String(Number(v.toPrecision(2)))) } }),
    tooltip: { trigger: "item", formatter: ({ data }) => data.told },
    series: [
      { type: "line", step: "end", data: edge.map((p) => [p.x, p.y]), showSymbol: false, silent: true,
        lineStyle: { color: muted, width: 1, type: [4, 4] }, z: 1 },
      ...points.map((p) => bars(p, y)),
      { type: "scatter", z: 3, labelLayout: { moveOverlap: "shiftY" },
        data: points.map((p) => ({ value: [p.x, p.y], symbol: lookOf(p.line.algorithm).symbol,
          symbolSize: 12, itemStyle: { color: lookOf(p.line.algorithm).color }, label: label(p),
          told: `<b>${p.line.algorithm}</b><br>gap ${told(p.line.gap)} nats<br>time ${told(p.line.time)} ms` })) },
    ],
  };
}

function around(values) {
  if (!values.length) return {};
  const [low, high] = [Math.min(...values), Math.max(...values)];
  return { min: low / 1.6, max: high * 1.6 };
}

function bars(p, y) {
  const { color } = lookOf(p.line.algorithm);
  const data = [];
  if (p.line.gap.low !== null) data.push([[p.x, y(p.line.gap.low)], [p.x, y(p.line.gap.high)]]);
  if (p.line.time.low !== null) data.push([[p.line.time.low, p.y], [p.line.time.high, p.y]]);
  return { type: "custom", silent: true, z: 2, data: data.map(([a, b]) => [...a, ...b]),
    renderItem: (_, api) => {
      const from = api.coord([api.value(0), api.value(1)]);
      const to = api.coord([api.value(2), api.value(3)]);
      return { type: "line", shape: { x1: from[0], y1: from[1], x2: to[0], y2: to[1] },
        style: { stroke: color, lineWidth: 1.5, opacity: 0.6 } };
    } };
}
