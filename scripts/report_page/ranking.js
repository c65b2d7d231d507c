// The ranking of a contest: correctness, share proven optimal, certified gap, time, in this order;
// scripts/mda_results/standings.py for the rows that the filter leaves.

import { valuesOf } from "./contest.js";
import { atLeastShare, estimate, places, resampledMean, resamples } from "./stats.js";

/**
 * A line per algorithm, best first: {algorithm, place (null when disqualified), refuted, proven (in
 * percent), certifiedGap, gapP95, gapMax, gap, time, penalised}; estimates are {value, low, high}.
 */
export function standings(rows, contest, shift) {
  const draws = resamples(contest.unitGroups);
  const means = contest.algorithms.map((name) => meansOf(rows, contest, name, shift, draws));
  const decisive = contest.hardness === "open" ? "gap" : "certified";
  const keysOf = (pick) => means.map((m) => [m.refuted > 0 ? 1 : 0, -pick(m.proven),
    Number.isNaN(pick(m[decisive])) ? Infinity : pick(m[decisive]), pick(m.logTime)]);
  const place = places(keysOf((mean) => mean.value));
  const drawn = draws?.map((_, r) => places(keysOf((mean) => mean.drawn[r])));
  return means.map((m, i) => lineOf(m, place[i], drawn?.map((ranks) => ranks[i]) ?? null, shift))
    .sort((a, b) => (a.refuted > 0) - (b.refuted > 0) || a.order - b.order ||
      (a.algorithm < b.algorithm ? -1 : 1));
}

function meansOf(rows, contest, algorithm, shift, draws) {
  const field = (name) => valuesOf(rows, contest, algorithm, name);
  const averaged = (values) => resampledMean(values, contest.unit, draws, contest.unitGroups.length);
  const certifiedGaps = field("certified_gap_nats").map((gap) => gap ?? NaN);
  return {
    algorithm, refuted: contest.refuted.get(algorithm), certifiedGaps,
    proven: averaged(field("fate").map((fate) => Number(fate === "optimal"))),
    certified: averaged(certifiedGaps),
    gap: averaged(field("gap_to_best_nats").map((gap) => gap ?? NaN)),
    logTime: averaged(field("charged_ms").map((time) => Math.log(time + shift))),
    penalised: field("in_time").filter((inTime) => !inTime).length,
  };
}

function lineOf(m, place, drawn, shift) {
  return {
    algorithm: m.algorithm, order: place, refuted: m.refuted,
    place: m.refuted ? null : estimate({ value: place, drawn }),
    proven: estimate(m.proven, (share) => 100 * share),
    certifiedGap: estimate(m.certified), gap: estimate(m.gap),
    gapP95: atLeastShare(m.certifiedGaps, 0.95),
    gapMax: m.certifiedGaps.reduce((most, gap) => Math.max(most, gap), -Infinity),
    time: estimate(m.logTime, (x) => Math.exp(x) - shift),
    penalised: m.penalised,
  };
}
