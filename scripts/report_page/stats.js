// Statistics of a filtered selection. What they mean is fixed in scripts/mda_results; here they are
// only formed again when the reader chooses other rows.

/** Quantile with linear interpolation between order statistics; NaN of nothing. */
export function quantile(values, share) {
  if (!values.length) return NaN;
  const sorted = Float64Array.from(values).sort();
  const place = share * (sorted.length - 1);
  const low = Math.floor(place);
  const high = Math.min(low + 1, sorted.length - 1);
  return sorted[low] + (place - low) * (sorted[high] - sorted[low]);
}

export const mean = (values) =>
  values.length ? values.reduce((sum, value) => sum + value, 0) / values.length : NaN;

/** A generator of numbers in [0, 1), the same after every start with the same seed (mulberry32). */
export function generator(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = state;
    mixed = Math.imul(mixed ^ (mixed >>> 15), mixed | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

const RESAMPLES = 1000;
const LEVEL = 0.95;

/**
 * Resamples of scenarios within their groups. `units` are names such as "A 3" with their group;
 * gives for each resample how often every unit is in it, or null where no group has two.
 */
export function resample(groups) {
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
      for (let draw = 0; draw < units.length; ++draw) {
        times[units[Math.floor(random() * units.length)]] += 1;
      }
    }
    return times;
  });
}

/**
 * sum(part) / sum(whole) over units, mapped by `of`, with its percentile interval over `draws`
 * (of resample()); low and high are null without draws.
 */
export function ratio(part, whole, draws, of = (x) => x) {
  const total = whole.reduce((sum, x) => sum + x, 0);
  if (!total) return null;
  const value = of(part.reduce((sum, x) => sum + x, 0) / total);
  if (!draws) return { value, low: null, high: null };
  const values = [];
  for (const times of draws) {
    let above = 0;
    let below = 0;
    for (let unit = 0; unit < times.length; ++unit) {
      above += times[unit] * part[unit];
      below += times[unit] * whole[unit];
    }
    if (below > 0) values.push(of(above / below));
  }
  const tail = (1 - LEVEL) / 2;
  return { value, low: quantile(values, tail), high: quantile(values, 1 - tail) };
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
  return below > 0 ? above / below : NaN;
}
