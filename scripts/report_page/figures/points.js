// Mean gap against time, with intervals, and the line of those that none beats in both.

import { Figure, axis, colors } from "../figure.js";
import { shown } from "../dom.js";
import { legend, lookOf } from "../look.js";
import { ContestChoice } from "./contest_choice.js";

const SMALLEST = 1e-6; // nats; a smaller mean gap stands at 0

const GRID = { left: 64, right: 24, top: 22, bottom: 46 };
const FONT_PX = 12;

const interval = (e) => (e.low === null ? "" : ` [${shown(e.low)}, ${shown(e.high)}]`);
const told = (e) => `${shown(e.value)}${interval(e)}`;

export function paretoFigure() {
  let current = null;
  const linesNow = () => (current?.standings ?? []).filter((l) => l.place && Number.isFinite(l.gap.value));
  const title = "Gap against time";
  const windows = new ContestChoice((contest, _, found) => {
    current = found;
    figure.title.textContent = `${title} (${contest?.windows.length ?? 0} ${contest?.hardness ?? ""} windows)`;
    figure.redrawLegend();
    figure.refresh();
  });
  const figure = new Figure({
    name: "pareto", title, height: (width) => (width < 500 ? 340 : 430), controls: windows.controls,
    note: "Mean gap above the best known cost and shifted geometric mean of the CPU time, with their 95 % intervals " +
      "over scenes. The line joins those that no other is as good as in both and better in one.",
    draw: (width) => options(linesNow(), width, figure.height(width)),
    lines: () => [["algorithm", "time_ms", "time_low", "time_high", "gap_nats", "gap_low", "gap_high"],
      ...linesNow().map(({ algorithm, time, gap }) =>
        [algorithm, time.value, time.low, time.high, gap.value, gap.low, gap.high])],
  });
  figure.redrawLegend = () => figure.below.replaceChildren(legend(current?.contest.algorithms ?? []));
  figure.update = (state) => windows.update(state);
  return figure;
}

/** Points {x, y} that no other is at most equal to in both and less in one, by x. */
function front(points) {
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

function options(lines, width, height) {
  const { floor, most, hasZero } = scale(lines);
  const points = lines.map((line) => ({ line, x: Math.max(line.time.value, 1e-6),
    y: line.gap.value > SMALLEST ? line.gap.value : floor }));
  const edge = front(points);
  const ends = around(points.map((p) => p.x));
  const share = (v, low, high) => Math.log(v / low) / Math.log(high / low);
  const inside = [width - GRID.left - GRID.right, height - GRID.top - GRID.bottom];
  const places = namePlaces(points.map((p) => ({ name: p.line.algorithm, px: inside[0] * share(p.x, ends.min, ends.max),
    py: inside[1] * (1 - share(p.y, floor, most)) })), (i) => edge.includes(points[i]), width - GRID.left);
  const number = (v) => String(Number(v.toPrecision(2)));
  const label = axis("").axisLabel;
  return {
    grid: GRID,
    xAxis: axis("CPU time, shifted geometric mean [ms]", { type: "log", ...ends,
      axisLabel: { ...label, formatter: number, showMinLabel: false, showMaxLabel: false } }),
    yAxis: axis("mean gap [nats]", { type: "log", nameGap: 46, min: floor, max: most,
      axisLabel: { ...label, showMaxLabel: false,
        formatter: (v) => (hasZero && v <= floor * 1.01 ? "0" : number(v)) } }),
    tooltip: { trigger: "item", formatter: ({ data }) => data.told },
    series: [frontLine(edge), ...points.map((p) => bars(p, floor)), {
      type: "scatter", z: 3, data: points.map((p, i) => pointOf(p, edge.includes(p), places[i])) }],
  };
}

function frontLine(edge) {
  return { type: "line", step: "end", data: edge.map((p) => [p.x, p.y]), showSymbol: false, silent: true, z: 1,
    lineStyle: { color: colors().muted, width: 1, type: [4, 4] } };
}

function pointOf(p, isFront, place) {
  const { color, symbol } = lookOf(p.line.algorithm);
  return { value: [p.x, p.y], symbol, symbolSize: 12, itemStyle: { color },
    label: { show: place !== null, position: "inside", offset: place ?? [0, 0], formatter: p.line.algorithm, color,
      fontSize: FONT_PX, fontWeight: isFront ? "bold" : "normal" },
    told: `<b>${p.line.algorithm}</b><br>gap ${told(p.line.gap)} nats<br>time ${told(p.line.time)} ms` };
}

/** For each point {px, py, name} where its name goes, as the shift of the name's middle, so that it
 *  covers no point and no other name; null where there is no room. Those of `first` choose first. */
function namePlaces(points, first, width) {
  const half = (name) => [(name.length * FONT_PX * 0.6) / 2, FONT_PX * 0.6];
  const taken = points.map(({ px, py }) => [px - 7, py - 7, px + 7, py + 7]);
  const places = points.map(() => null);
  const order = points.map((_, i) => i).sort((a, b) => first(b) - first(a) || a - b);
  for (const i of order) {
    const [w, h] = half(points[i].name);
    const ways = [[0, -h - 9], [w + 10, 0], [0, h + 9], [-w - 10, 0], [w + 6, -h - 8], [-w - 6, -h - 8],
      [w + 6, h + 8], [-w - 6, h + 8], [0, -3 * h - 9]];
    for (const [dx, dy] of ways) {
      const [x, y] = [points[i].px + dx, points[i].py + dy];
      const box = [x - w, y - h, x + w, y + h];
      if (box[0] < 0 || box[2] > width || taken.some((other) => overlap(box, other))) continue;
      taken.push(box);
      places[i] = [dx, dy];
      break;
    }
  }
  return places;
}

const overlap = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

function around(values) {
  return values.length ? { min: Math.min(...values) / 1.6, max: Math.max(...values) * 1.6 } : { min: 1, max: 10 };
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
