// The windows of one hardness on which every algorithm was asked: scripts/mda_results/contest.py,
// for the rows that the filter leaves.

export const HARDNESSES = ["easy", "hard", "open"];
const FEWEST = 0.5; // of the windows: an algorithm asked on fewer is named, not ranked

/** The contests of the chosen rows, one per hardness that has any. */
export function contests(rows, chosen) {
  const answer = rows.rows.column("answer");
  const hardness = rows.windows.column("hardness");
  const own = chosen.filter((row) => answer[row] === "selection");
  const refuted = new Map();
  for (const row of own) {
    if (rows.get("fate", row) === "refuted") {
      refuted.set(rows.algorithm[row], (refuted.get(rows.algorithm[row]) ?? 0) + 1);
    }
  }
  return HARDNESSES.map((kind) =>
    contest(rows, own.filter((row) => hardness[rows.window[row]] === kind), kind, refuted))
    .filter((found) => found !== null);
}

/**
 * {hardness, algorithms, members: by algorithm its rows in the order of `windows`, windows, unit:
 * each window's scene, unitGroups: each scene's scenario, refuted, notes}; null without a window.
 */
function contest(rows, own, hardness, refuted) {
  const all = new Set(own.map((row) => rows.window[row]));
  const { algorithms, notes } = entrants(rows, own, hardness, all.size);
  const entered = new Set(algorithms);
  const counts = new Map();
  for (const row of own) {
    if (!entered.has(rows.algorithm[row])) continue;
    counts.set(rows.window[row], (counts.get(rows.window[row]) ?? 0) + 1);
  }
  const shared = new Set([...counts].filter(([, n]) => n === algorithms.length).map(([w]) => w));
  if (!algorithms.length || !shared.size) return null;
  if (shared.size < all.size) {
    notes.push(`${hardness}: ${all.size - shared.size} of ${all.size} windows are left out, as not ` +
      "every ranked algorithm was asked on them.");
  }
  const members = new Map(algorithms.map((name) => [name, []]));
  for (const row of own) if (shared.has(rows.window[row])) members.get(rows.algorithm[row])?.push(row);
  const windows = members.get(algorithms[0]).map((row) => rows.window[row]);
  return { hardness, algorithms, members, windows, notes, ...scenes(rows, windows),
    refuted: new Map(algorithms.map((name) => [name, refuted.get(name) ?? 0])) };
}

function entrants(rows, own, hardness, windows) {
  const asked = new Map();
  const tried = new Set();
  for (const row of own) {
    const name = rows.algorithm[row];
    asked.set(name, (asked.get(name) ?? 0) + 1);
    if (rows.get("fate", row) !== "declined") tried.add(name);
  }
  const seldom = [...asked].filter(([, n]) => n < FEWEST * windows);
  const notes = seldom.map(([name, n]) =>
    `${hardness}: ${name} was asked on ${n} of ${windows} windows only and is not ranked.`);
  const out = new Set(seldom.map(([name]) => name));
  const idle = [...asked.keys()].filter((name) => !tried.has(name) && !out.has(name)).sort();
  if (idle.length) notes.push(`${hardness}: declined by ${idle.join(", ")}: all windows.`);
  return { algorithms: [...tried].filter((name) => !out.has(name)).sort(), notes };
}

/** Scenes, (scenario, seed, replicate), numbered in the order in which they come. */
function scenes(rows, windows) {
  const fields = ["scenario", "seed", "replicate"].map((name) => rows.windows.column(name));
  const numbers = new Map();
  const unitGroups = [];
  const unit = windows.map((window) => {
    const name = fields.map((field) => field[window]).join("|");
    if (!numbers.has(name)) {
      numbers.set(name, unitGroups.length);
      unitGroups.push(fields[0][window]);
    }
    return numbers.get(name);
  });
  return { unit, unitGroups };
}

/** A field of every member row of an algorithm, in the order of the windows. */
export function valuesOf(rows, found, algorithm, field) {
  return found.members.get(algorithm).map((row) => rows.get(field, row));
}
