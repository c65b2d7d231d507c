// The windows of one hardness on which every algorithm was asked: scripts/mda_results/contest.py,
// for the rows that the filter leaves.

const HARDNESSES = ["easy", "hard", "open"];
const FEWEST = 0.5; // of the windows: an algorithm that tries fewer is named, not ranked

/** {contests, notes}: one per hardness that has any of the chosen rows, and who is left out. */
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
  const notes = [];
  const found = HARDNESSES.map((kind) =>
    contest(rows, own.filter((row) => hardness[rows.window[row]] === kind), kind, refuted, notes));
  return { contests: found.filter((one) => one !== null), notes };
}

/**
 * {hardness, algorithms, members: by algorithm its rows in the order of `windows`, windows, unit:
 * each window's scene, unitGroups: each scene's scenario, refuted}; null without a window.
 */
function contest(rows, own, hardness, refuted, notes) {
  const all = new Set(own.map((row) => rows.window[row]));
  const algorithms = entrants(rows, own, hardness, all.size, notes);
  const entered = new Set(algorithms);
  const counts = new Map();
  for (const row of own) {
    if (!entered.has(rows.algorithm[row])) continue;
    counts.set(rows.window[row], (counts.get(rows.window[row]) ?? 0) + 1);
  }
  const shared = new Set([...counts].filter(([, n]) => n === algorithms.length).map(([w]) => w));
  if (algorithms.length && shared.size < all.size) {
    notes.push(`${hardness}: ${all.size - shared.size} of ${all.size} windows are left out, as not ` +
      "every algorithm of the ranking was asked on them.");
  }
  if (!algorithms.length || !shared.size) return null;
  const members = new Map(algorithms.map((name) => [name, []]));
  for (const row of own) if (shared.has(rows.window[row])) members.get(rows.algorithm[row])?.push(row);
  const windows = members.get(algorithms[0]).map((row) => rows.window[row]);
  return { hardness, algorithms, members, windows, ...scenes(rows, windows),
    refuted: new Map(algorithms.map((name) => [name, refuted.get(name) ?? 0])) };
}

/** The algorithms that try enough of the windows. */
function entrants(rows, own, hardness, windows, notes) {
  const asked = new Map();
  const tried = new Map();
  for (const row of own) {
    const name = rows.algorithm[row];
    const tries = rows.get("fate", row) !== "declined";
    asked.set(name, (asked.get(name) ?? 0) + 1);
    tried.set(name, (tried.get(name) ?? 0) + Number(tries));
  }
  const names = [...asked.keys()].sort();
  const leftOut = new Map(); // by how they are told of
  for (const name of names.filter((one) => tried.get(one) < FEWEST * windows)) {
    const why = `asked on ${asked.get(name)} of ${windows} windows and declining ${asked.get(name) - tried.get(name)}`;
    leftOut.set(why, [...(leftOut.get(why) ?? []), name]);
  }
  for (const [why, own] of leftOut) notes.push(`${hardness}: not ranked, as ${why}: ${own.join(", ")}.`);
  return names.filter((name) => tried.get(name) >= FEWEST * windows);
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
