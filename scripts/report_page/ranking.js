// The ranking of what the filter leaves: the same columns as the table of rank.py that the page
// starts with, over the windows that all ranked algorithms were asked.

import { quantile, ratio, resample } from "./stats.js";

/** Windows (numbers) that every one of the algorithms was asked and did not decline. */
export function sharedWindows(rows, members) {
  const times = new Map();
  for (const own of members.values()) {
    for (const row of own) {
      if (rows.get("status", row) === "skipped") continue;
      times.set(rows.window[row], (times.get(rows.window[row]) ?? 0) + 1);
    }
  }
  return new Set([...times].filter(([, count]) => count === members.size).map(([window]) => window));
}

/** Sums per scenario of `value(row)` where it is a number, as parts and wholes for ratio(). */
function perUnit(own, unitOf, units, value) {
  const part = new Float64Array(units);
  const whole = new Float64Array(units);
  for (const row of own) {
    const x = value(row);
    if (x === null || Number.isNaN(x)) continue;
    part[unitOf(row)] += x;
    whole[unitOf(row)] += 1;
  }
  return [part, whole];
}

/** Scenarios (group and replicate) of windows, numbered. */
function unitsOf(rows, windows) {
  const scenario = rows.windows.column("scenario");
  const replicate = rows.windows.column("replicate");
  const numbers = new Map();
  const groups = [];
  const ofWindow = new Map();
  for (const window of [...windows].sort((a, b) => a - b)) {
    const name = `${scenario[window]} ${replicate[window]}`;
    if (!numbers.has(name)) {
      numbers.set(name, groups.length);
      groups.push(scenario[window]);
    }
    ofWindow.set(window, numbers.get(name));
  }
  return { groups, ofWindow };
}

/**
 * {shared, lines}: a line per algorithm that gives selections, best first. `shift`: of the shifted
 * geometric mean, milliseconds.
 */
export function rank(rows, chosen, shift) {
  const all = rows.byAlgorithm(chosen);
  const members = new Map([...all].filter(([, own]) =>
    own.some((row) => rows.get("answer", row) === "selection" &&
      rows.get("status", row) !== "skipped")));
  const shared = sharedWindows(rows, members);
  const units = unitsOf(rows, shared);
  const draws = resample(units.groups);
  const lines = [...members].map(([algorithm, own]) =>
    lineOf(rows, algorithm, own, shared, units, draws, shift));
  return { shared: shared.size, units: units.groups.length, lines: lines.sort(better), skipped:
    [...all.keys()].filter((name) => !members.has(name)) };
}

function lineOf(rows, algorithm, every, shared, units, draws, shift) {
  const own = every.filter((row) => shared.has(rows.window[row]));
  const unitOf = (row) => units.ofWindow.get(rows.window[row]);
  const estimate = (value, of) =>
    ratio(...perUnit(own, unitOf, units.groups.length, value), draws, of);
  const gaps = own.map((row) => rows.get("certified_gap_nats", row)).filter((gap) => gap !== null);
  return {
    algorithm,
    refuted: every.filter((row) => rows.get("fate", row) === "refuted").length,
    proven: estimate((row) => (rows.get("fate", row) === "optimal" ? 100 : 0)),
    gap: estimate((row) => rows.get("certified_gap_nats", row)),
    gapP95: quantile(gaps, 0.95),
    gapMax: gaps.length ? gaps.reduce((a, b) => Math.max(a, b)) : NaN,
    unanswered: own.filter((row) => !rows.isAnswered(row)).length,
    time: estimate((row) => Math.log(rows.charged(row) + shift),
      (x) => Math.exp(x) - shift),
  };
}

/** The order of the ranking: wrong answers last, then proofs, gap, time. */
function better(a, b) {
  const keys = (line) => [line.refuted > 0 ? 1 : 0, -(line.proven?.value ?? 0),
    line.gap?.value ?? Infinity, line.time?.value ?? Infinity];
  const [x, y] = [keys(a), keys(b)];
  const place = x.findIndex((value, i) => Math.abs(value - y[i]) > 1e-12);
  return place < 0 ? (a.algorithm < b.algorithm ? -1 : 1) : x[place] - y[place];
}
