// Curves over the windows of a contest: performance profiles and time to a gap.

import { Figure, axis } from "../figure.js";
import { choice } from "../dom.js";
import { valuesOf } from "../contest.js";
import { legend, lookOf } from "../look.js";
import { ContestChoice } from "./contest_choice.js";

const POINTS = 480;
const SHORTEST_MS = 1e-6;

/** Step curve: share of `values` (Infinity: never) at most x, at `POINTS` places spaced evenly in
 *  log x from `low` to `high`. */
function shares(values, low, high) {
  const sorted = Float64Array.from(values).sort();
  const points = [];
  let place = 0;
  for (let i = 0; i <= POINTS; ++i) {
    const x = low * (high / low) ** (i / POINTS);
    while (place < sorted.length && sorted[place] <= x * (1 + 1e-9)) ++place;
    points.push([x, values.length ? place / values.length : 0]);
  }
  return points;
}

/** Lower and upper end of an axis that holds all curves; `from` replaces the lower one. */
function ends(curves, from) {
  let low = Infinity;
  let high = 0;
  for (const values of curves.values()) {
    for (const value of values) {
      if (!Number.isFinite(value) || value <= 0) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  const start = from ?? (Number.isFinite(low) ? low : 1);
  return [start, Math.max(high, start * 2)];
}

function options(curves, xName, from) {
  const [start, end] = ends(curves, from);
  const label = axis("").axisLabel;
  return {
    grid: { left: 52, right: 16, top: 12, bottom: 46 },
    xAxis: axis(xName, { type: "log", min: start, max: end,
      axisLabel: { ...label, formatter: (x) => String(Number(x.toPrecision(2))) } }),
    yAxis: axis("", { type: "value", min: 0, max: 1,
      axisLabel: { ...label, formatter: (y) => `${Math.round(100 * y)} %` } }),
    tooltip: { trigger: "axis", order: "valueDesc", valueFormatter: (y) => `${(100 * y).toFixed(1)} %`,
      axisPointer: { label: { formatter: ({ value }) => String(Number(value.toPrecision(3))) } } },
    series: [...curves].map(([name, values]) => {
      const { color, dash } = lookOf(name);
      return { name, type: "line", step: "end", showSymbol: false, color,
        data: shares(values, start, end), lineStyle: { color, type: dash, width: 2 } };
    }),
  };
}

function linesOf(curves, xName, from) {
  const [start, end] = ends(curves, from);
  return [["algorithm", xName, "share"], ...[...curves].flatMap(([name, values]) =>
    shares(values, start, end).map(([x, y]) => [name, x, y]))];
}

/** A figure of curves; `curvesOf(rows, contest)`: by algorithm a value per window. */
function curveFigure({ name, title, xName, from, curvesOf, more = [], note }) {
  let curves = new Map();
  const windows = new ContestChoice((contest, rows) => {
    curves = contest ? curvesOf(rows, contest) : new Map();
    figure.title.textContent = `${title} (${contest ? contest.windows.length : 0} ${contest?.hardness ?? ""} windows)`;
    figure.redrawLegend();
    figure.refresh();
  }, more);
  const figure = new Figure({ name, title, controls: windows.controls, note,
    draw: () => options(curves, xName, from), lines: () => linesOf(curves, xName, from) });
  figure.redrawLegend = () => figure.below.replaceChildren(legend([...curves.keys()]));
  figure.update = (state) => windows.update(state);
  figure.again = () => windows.again();
  return figure;
}

/** Times over the least of those who reached the best known cost of the window in time. */
function profileCurves(rows, contest) {
  const times = new Map(contest.algorithms.map((name) => {
    const gaps = valuesOf(rows, contest, name, "gap_to_best_nats");
    const inTime = valuesOf(rows, contest, name, "in_time");
    const spent = valuesOf(rows, contest, name, "charged_ms");
    return [name, spent.map((time, i) =>
      (inTime[i] && gaps[i] !== null && gaps[i] <= 0 ? Math.max(time, SHORTEST_MS) : Infinity))];
  }));
  const best = contest.windows.map((_, i) => Math.min(...[...times.values()].map((own) => own[i])));
  return new Map([...times].map(([name, own]) =>
    [name, own.map((time, i) => (Number.isFinite(time) ? time / best[i] : Infinity))]));
}

export function profileFigure() {
  return curveFigure({ name: "profile", title: "Performance profile", from: 1,
    xName: "CPU time ÷ least CPU time of the window", curvesOf: profileCurves,
    note: "Share of the windows on which the best known cost is reached within a multiple of the least time. It is " +
      "taken over the algorithms that are chosen: leaving one out may reorder the rest." });
}

export function timeToGapFigure() {
  const targets = [["0", "0: best known"], ["0.1", "0.1 nats"], ["1", "1 nat"], ["10", "10 nats"]];
  let target = 0;
  const figure = curveFigure({ name: "time-to-gap", title: "Time to a gap", xName: "CPU time [ms]", from: null,
    more: [choice("gap at most", targets, (value) => {
      target = Number(value);
      figure.again();
    })],
    curvesOf: (rows, contest) => new Map(contest.algorithms.map((name) => {
      const gaps = valuesOf(rows, contest, name, "gap_to_best_nats");
      const spent = valuesOf(rows, contest, name, "spent_ms");
      return [name, gaps.map((gap, i) => (gap !== null && gap <= target ? spent[i] ?? Infinity : Infinity))];
    })),
    note: "Share of the windows with an answer no more than the gap above the best known cost by that time; a curve " +
      "ends at the share that gets there at all." });
  return figure;
}
