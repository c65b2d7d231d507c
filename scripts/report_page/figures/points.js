// Mean gap against time, with intervals, and the line of those that none beats in both.

import { Figure, axis, colors } from "../figure.js";
import { shown } from "../dom.js";
import { lookOf } from "../look.js";
import { ContestChoice } from "./contest_choice.js";

const SMALLEST = 1e-6; // nats; a smaller mean gap stands at 0

const interval = (e) => (e.low === null ? "" : ` [${shown(e.low)}, ${shown(e.high)}]`);
const told = (e) => `${shown(e.value)}${interval(e)}`;

export function paretoFigure() {
  let current = null;
  const linesNow = () => (current?.standings ?? []).filter((l) => l.place && Number.isFinite(l.gap.value));
  const title = "Gap against time";
  const windows = new ContestChoice((contest, _, found) => {
    current = found;
    figure.title.textContent = `${title} (${contest?.windows.length ?? 0} ${contest?.hardness ?? ""} windows)`;
    figure.refresh();
  });
  const figure = new Figure({
    name: "pareto", title, height: (width) => (width < 500 ? 340 : 430), controls: windows.controls,
    note: "Mean gap above the best known cost and shifted geometric mean of the CPU time, with their 95 % intervals " +
      "over scenes. The line joins those that no other is as good as in both and better in one.",
    draw: (width) => options(linesNow(), width),
    lines: () => [["algorithm", "time_ms", "time_low", "time_high", "gap_nats", "gap_low", "gap_high"],
      ...linesNow().map((l) => [l.algorithm, l.time.value, l.time.low, l.time.high, l.gap.value, l.gap.low, l.gap.high])],
  });
  figure.update = (state) => windows.update(state);
  return figure;
}

/** Points {x, y} that no other is at most equal to in both and less in one, by x. */
export function front(points) {
  return points.filter((p) => !points.some((q) => q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y)))
    .sort((a, b) => a.x - b.x);
}

/** Where gaps of 0 stand on a logarithmic axis, and its ends. */
function scale(lines) {
  const positive = lines.flatMap((l) => [l.gap.value, l.gap.low ?? 0]).filter((gap) => gap > SMALLEST);
  const least = positive.length ? Math.min(...positive) : 1e-3;
  const most = Math.max(least, ...lines.map((l) => Math.max(l.gap.value, l.gap.high ?? 0)));
  const hasZero = lines.some((l) => l.gap.value <= SMALLEST);
  const floor = 10 ** Math.floor(Math.log10(least) - (hasZero ? 0.7 : 0));
  return { floor, most: 2 * most, hasZero };
}

function options(lines, width) {
  const { floor, most, hasZero } = scale(lines);
  const points = lines.map((line) => ({ line, x: Math.max(line.time.value, 1e-6),
    y: line.gap.value > SMALLEST ? line.gap.value : floor }));
  const edge = front(points);
  const number = (v) => String(Number(v.toPrecision(2)));
  const label = axis("").axisLabel;
  return {
    grid: { left: 64, right: width < 500 ? 20 : 40, top: 22, bottom: 46 },
    xAxis: axis("CPU time, shifted geometric mean [ms]", { type: "log", ...around(points.map((p) => p.x)),
      axisLabel: { ...label, formatter: number, showMinLabel: false, showMaxLabel: false } }),
    yAxis: axis("mean gap [nats]", { type: "log", nameGap: 46, min: floor, max: most,
      axisLabel: { ...label, showMaxLabel: false, formatter: (v) => (hasZero && v <= floor * 1.01 ? "0" : number(v)) } }),
    tooltip: { trigger: "item", formatter: ({ data }) => data.told },
    series: [frontLine(edge), ...points.map((p) => bars(p, floor)), {
      type: "scatter", z: 3, data: points.map((p, i) => pointOf(p, edge.includes(p), stacked(points, i))) }],
  };
}

function frontLine(edge) {
  return { type: "line", step: "end", data: edge.map((p) => [p.x, p.y]), showSymbol: false, silent: true, z: 1,
    lineStyle: { color: colors().muted, width: 1, type: [4, 4] } };
}

/** How many earlier points stand so near that their names would cover this one's. */
function stacked(points, i) {
  const near = (a, b, ratio) => Math.abs(Math.log(a / b)) < Math.log(ratio);
  return points.slice(0, i).filter((p) => near(p.x, points[i].x, 1.6) && near(p.y, points[i].y, 1.5)).length;
}

function pointOf(p, isFront, above) {
  const { color, symbol } = lookOf(p.line.algorithm);
  return { value: [p.x, p.y], symbol, symbolSize: 12, itemStyle: { color },
    label: { show: true, position: "top", formatter: p.line.algorithm, color, fontSize: 12, distance: 8 + 14 * above,
      fontWeight: isFront ? "bold" : "normal" },
    told: `<b>${p.line.algorithm}</b><br>gap ${told(p.line.gap)} nats<br>time ${told(p.line.time)} ms` };
}

function around(values) {
  return values.length ? { min: Math.min(...values) / 1.6, max: Math.max(...values) * 1.6 } : {};
}

function bars(p, floor) {
  const { color } = lookOf(p.line.algorithm);
  const { gap, time } = p.line;
  const data = [];
  if (gap.low !== null && gap.high > SMALLEST) {
    data.push([p.x, Math.max(gap.low, floor), p.x, Math.max(gap.high, floor)]);
  }
  if (time.low !== null) data.push([time.low, p.y, time.high, p.y]);
  return { type: "custom", silent: true, z: 2, data, renderItem: (_, api) => {
    const [x1, y1] = api.coord([api.value(0), api.value(1)]);
    const [x2, y2] = api.coord([api.value(2), api.value(3)]);
    return { type: "line", shape: { x1, y1, x2, y2 }, style: { stroke: color, lineWidth: 1.5, opacity: 0.6 } };
  } };
}
