// What a scene looks like at a scan: plots, true paths, and an answer judged against the truth.

import { axis, colors } from "./figure.js";
import { lookOf } from "./look.js";
import { isDark } from "./theme.js";

const FALSE_ALARM = -1;
const MISS = -1;

/** The source that most of a track's plots come from, the lowest winning ties and false alarms
 *  losing them; with the plots as {scan, plot, source}. `until`: the newest scan that counts. */
function judge(scene, track, until) {
  const [first, ...numbers] = track;
  const plots = numbers
    .map((plot, i) => ({ scan: first + i, plot }))
    .filter(({ scan, plot }) => plot !== MISS && scan <= until)
    .map(({ scan, plot }) => ({ scan, plot, source: scene.plots[scan - 1][plot][2] }));
  const votes = new Map();
  for (const { source } of plots) votes.set(source, (votes.get(source) ?? 0) + 1);
  const order = ([a, n], [b, m]) => m - n || (a === FALSE_ALARM) - (b === FALSE_ALARM) || a - b;
  const owner = [...votes].sort(order)[0]?.[0] ?? FALSE_ALARM;
  return { owner, plots };
}

/** Judgements of an answer on the plots of scans `from` to `until`: the tracks, plots taken rightly
 *  (of the track's own target), wrongly, and targets' plots that no track takes. */
export function verdictOf(scene, tracks, from, until) {
  const judged = tracks.map((track) => judge(scene, track, until)).filter(({ plots }) => plots.length);
  const taken = new Set();
  const wrong = [];
  let right = 0;
  for (const { owner, plots } of judged) {
    for (const { scan, plot, source } of plots) {
      taken.add(`${scan} ${plot}`);
      if (source === owner && source !== FALSE_ALARM) right += scan >= from ? 1 : 0;
      else if (scan >= from) wrong.push(scene.plots[scan - 1][plot]);
    }
  }
  const missed = [];
  for (let scan = from; scan <= until; ++scan) {
    scene.plots[scan - 1].forEach((plot, i) => {
      if (plot[2] !== FALSE_ALARM && !taken.has(`${scan} ${i}`)) missed.push(plot);
    });
  }
  return { judged, right, wrong, missed };
}

/** A box around the coverage, or around everything without one, with the same kilometres per pixel in x and y. */
function frame(scene, width, height) {
  const points = scene.range_km ? [[-1, -1], [1, 1]].map((p) => p.map((x) => x * scene.range_km))
    : [...scene.plots.flat(), ...scene.targets.flatMap((t) => t.positions_km)];
  const reach = (k) => {
    let [low, high] = [Infinity, -Infinity];
    for (const p of points) {
      low = Math.min(low, p[k]);
      high = Math.max(high, p[k]);
    }
    return low <= high ? [low, high] : [-1, 1];
  };
  const [x, y] = [reach(0), reach(1)];
  const perPixel = 1.06 * Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height, 1e-6);
  const around = ([low, high], size) => {
    const middle = (low + high) / 2;
    return { min: middle - (perPixel * size) / 2, max: middle + (perPixel * size) / 2 };
  };
  return [around(x, width), around(y, height)];
}

const LINE = { show: false, onZero: false };
const GRID = { left: 56, right: 14, top: 10, bottom: 44 };

/** `view`: {scan, from: the oldest scan whose plots are shown, tracks (or null), algorithm, judgedFrom: the
 *  oldest scan of the answer}. */
export function picture(scene, view, width, height) {
  const { muted, warn } = colors();
  const [x, y] = frame(scene, width - GRID.left - GRID.right, height - GRID.top - GRID.bottom);
  const km = (v) => String(Number(v.toFixed(3)));
  const label = { ...axis("").axisLabel, formatter: km, showMinLabel: false, showMaxLabel: false };
  const verdict = view.tracks ? verdictOf(scene, view.tracks, view.judgedFrom, view.scan) : null;
  return {
    grid: GRID,
    xAxis: axis("x [km]", { type: "value", ...x, axisLabel: label, axisLine: LINE }),
    yAxis: axis("y [km]", { type: "value", ...y, nameGap: 40, axisLabel: label, axisLine: LINE }),
    dataZoom: [{ type: "inside", xAxisIndex: 0, zoomOnMouseWheel: "shift", filterMode: "none" },
      { type: "inside", yAxisIndex: 0, zoomOnMouseWheel: "shift", filterMode: "none" }],
    tooltip: { trigger: "item", formatter: ({ data }) => data.told ?? "" },
    series: [...truth(scene, view, muted), ...plots(scene, view, muted), coverage(scene, muted),
      ...(verdict ? answer(scene, verdict, view, warn) : [])],
  };
}

const hollow = (borderColor, borderWidth) => ({ color: "transparent", borderColor, borderWidth });

function truth(scene, view, muted) {
  const until = (t) => t.positions_km.slice(0, Math.max(0, view.scan - t.first_scan + 1));
  const paths = scene.targets.map((target, number) => ({ number, path: until(target),
    end: target.first_scan + target.positions_km.length - 1 }));
  const alive = paths.filter(({ path, end }) => path.length && end >= view.scan);
  return [
    ...paths.filter(({ path }) => path.length > 1).map(({ path }) => ({ type: "line", data: path, silent: true,
      showSymbol: false, z: 1, lineStyle: { color: muted, width: 1.2, opacity: 0.75 } })),
    { type: "scatter", z: 2, symbol: "circle", symbolSize: 10, itemStyle: hollow(muted, 1.3),
      data: alive.map(({ number, path }) => ({ value: path[path.length - 1],
        told: `target ${number}, true position at scan ${view.scan}` })) },
  ];
}

function plots(scene, view, muted) {
  const points = [[], []];
  for (let scan = view.from; scan <= view.scan; ++scan) {
    const age = (view.scan - scan) / Math.max(1, view.scan - view.from);
    for (const [px, py, source] of scene.plots[scan - 1]) {
      const name = source === FALSE_ALARM ? "false alarm" : `plot of target ${source}`;
      points[source === FALSE_ALARM ? 0 : 1].push({ value: [px, py], told: `${name}, scan ${scan}`,
        itemStyle: { opacity: 1 - 0.65 * age } });
    }
  }
  const cross = "path://M0,1 L1,0 L5,4 L9,0 L10,1 L6,5 L10,9 L9,10 L5,6 L1,10 L0,9 L4,5 Z";
  return [
    { name: "false alarms", type: "scatter", symbol: cross, symbolSize: 7, z: 3,
      itemStyle: { color: muted }, data: points[0] },
    { name: "plots of targets", type: "scatter", symbol: "circle", symbolSize: 6, z: 4,
      itemStyle: { color: isDark() ? "#56B4E9" : "#0072B2" }, data: points[1] },
  ];
}

function coverage(scene, muted) {
  if (!scene.range_km) return { type: "line", data: [] };
  const circle = Array.from({ length: 181 }, (_, i) => {
    const angle = (i * Math.PI) / 90;
    return [scene.range_km * Math.cos(angle), scene.range_km * Math.sin(angle)];
  });
  return { name: "coverage", type: "line", data: circle, showSymbol: false, silent: true, z: 0,
    lineStyle: { color: muted, width: 1, type: [3, 4], opacity: 0.6 } };
}

function answer(scene, verdict, view, warn) {
  const { color } = lookOf(view.algorithm);
  const place = ({ scan, plot }) => scene.plots[scan - 1][plot].slice(0, 2);
  const ring = (name, points, look) => ({ name, type: "scatter", symbol: "circle", symbolSize: 15, z: 6,
    itemStyle: hollow(look, 2), data: points.map(([px, py]) => ({ value: [px, py], told: name })) });
  return [
    ...verdict.judged.map(({ plots: own, owner }) => ({ name: view.algorithm, type: "line", z: 5,
      data: own.map(place), symbol: "none", silent: true, lineStyle: { color: owner === FALSE_ALARM ? warn : color,
        width: 2.6, type: owner === FALSE_ALARM ? [3, 3] : "solid" } })),
    ring("taken by a track of another source", verdict.wrong, warn),
    ring("plot of a target that no track takes", verdict.missed, isDark() ? "#F0C040" : "#B8860B"),
  ];
}
