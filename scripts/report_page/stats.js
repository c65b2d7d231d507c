// Statistics of a part of the rows. What they mean is fixed in scripts/mda_results; they are formed
// here only because a page has to follow its reader's choice.

/** Quantile with linear interpolation between order statistics; NaN of nothing. */
export function quantile(values, share) {
  if (!values.length) return NaN;
  const sorted = Float64Array.from(values).sort();
  const place = share * (sorted.length - 1);
  const low = Math.floor(place);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
}

/** The least value that a share of all do not exceed. */
export function atLeastShare(values, share) {
  if (!values.length) return NaN;
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.max(0, Math.ceil(share * sorted.length - 1e-9) - 1)];
}

export const mean = (values) =>
  values.length ? values.reduce((sum, value) => sum + value, 0) / values.length : NaN;

/** A generator of numbers in [0, 1), the same after every start with the same seed: a Weyl
 *  sequence of 32 bits, mixed by multiplications and shifts. */
function generator(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 16), 0x85ebca6b);
    mixed = Math.imul(mixed ^ (mixed >>> 13), 0xc2b2ae35);
    return ((mixed ^ (mixed >>> 16)) >>> 0) / 4294967296;
  };
}

const RESAMPLES = 1000;
const LEVEL = 0.95;

/** For each resample, how often every scene is in it: scenes are drawn within their group. Null
 *  where no group has two. O(resamples x scenes). */
export function resamples(groups) {
  const members = new Map();
  groups.forEach((group, unit) => {
    if (!members.has(group)) members.set(group, []);
    members.get(group).push(unit);
  });
  if (![...members.values()].some((units) => units.length > 1)) return null;
  const random = generator(1);
  return Array.from({ length: RESAMPLES }, () => {
    const times = new Uint16Array(groups.length);
    for (const units of members.values()) {
      for (let draw = 0; draw < units.length; ++draw) times[units[Math.floor(random() * units.length)]] += 1;
    }
    return times;
  });
}

/**
 * The mean of `values` (one per window) and of every resample of scenes: {value, drawn}; `unit` is
 * each window's scene. Rounded, so that the order of summation makes no difference between equals.
 */
export function resampledMean(values, unit, draws, units) {
  const sums = new Float64Array(units);
  const counts = new Float64Array(units);
  values.forEach((value, i) => {
    sums[unit[i]] += value;
    counts[unit[i]] += 1;
  });
  const over = (times) => {
    let above = 0;
    let below = 0;
    for (let u = 0; u < units; ++u) {
      if (times !== null && times[u] === 0) continue;
      above += (times === null ? 1 : times[u]) * sums[u];
      below += (times === null ? 1 : times[u]) * counts[u];
    }
    return rounded(above / below);
  };
  return { value: over(null), drawn: draws === null ? null : draws.map(over) };
}

const rounded = (value) => (Number.isFinite(value) ? Number(value.toPrecision(12)) : value);

/** {value, low, high} of a value and its resamples, mapped by `of`; null limits without any. */
export function estimate({ value, drawn }, of = (x) => x) {
  const usable = (drawn ?? []).filter(Number.isFinite);
  if (!usable.length || !Number.isFinite(value)) return { value: of(value), low: null, high: null };
  const tail = (1 - LEVEL) / 2;
  return { value: of(value), low: of(quantile(usable, tail)), high: of(quantile(usable, 1 - tail)) };
}

/** Competition ranks (1, 2, 2, 4): `keys` is a list per entrant, less is better, the first counts
 *  most. */
export function places(keys) {
  const order = keys.map((_, i) => i).sort((a, b) => compareKeys(keys[a], keys[b]));
  const result = new Array(keys.length);
  order.forEach((entrant, i) => {
    const same = i > 0 && compareKeys(keys[order[i - 1]], keys[entrant]) === 0;
    result[entrant] = same ? result[order[i - 1]] : i + 1;
  });
  return result;
}

function compareKeys(a, b) {
  const at = a.findIndex((value, i) => value !== b[i]);
  return at < 0 ? 0 : a[at] - b[at] || (a[at] < b[at] ? -1 : 1);
}

/** Exponent b of y ~ x^b by least squares on logarithms; NaN where x does not vary. */
export function exponent(xs, ys) {
  const lx = xs.map(Math.log);
  const ly = ys.map(Math.log);
  const [mx, my] = [mean(lx), mean(ly)];
  let above = 0;
  let below = 0;
  lx.forEach((x, i) => {
    above += (x - mx) * (ly[i] - my);
    below += (x - mx) ** 2;
  });
  return below > 1e-9 * xs.length ? above / below : NaN;
}
