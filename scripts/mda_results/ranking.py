"""Tables of the ranking: correctness, what became of every row, the order, gaps, times."""

import pandas as pd

from mda_results import facts, measures
from mda_results.contest import Contest
from mda_results.render import Cell, Column, Estimate, Table
from mda_results.rows import WINDOW_KEY, window_name
from mda_results.standings import SHIFT_MS, Standing, standings

_EXAMPLES = 3  # refuted rows shown per algorithm


def correctness(rows: pd.DataFrame) -> Table:
    """Every algorithm with a refuted claim, with its first ones."""
    wrong = rows[rows["fate"] == facts.REFUTED]
    columns = [Column("algorithm", once=True), Column("refuted"), Column("window"),
               Column("what is wrong")]
    lines: list[list[Cell]] = []
    for algorithm, own in wrong.groupby("algorithm", sort=True):
        for _, row in own.sort_values(WINDOW_KEY).head(_EXAMPLES).iterrows():
            lines.append([str(algorithm), len(own), window_name(row), row["why"]])
    notes = ["Refuted: by the referee when it ran, or now by other rows of the same problem: a "
             "cost below a certified bound, a claimed optimum above a known cost, a claimed bound "
             "above one. One refuted claim disqualifies: the algorithm stands last in the ranking, "
             "without a place, and in no comparison."]
    if not lines:
        notes = [f"No claim of {rows['algorithm'].nunique()} algorithms in {len(rows)} rows is "
                 "refuted.", *notes]
    return Table("correctness", "Correctness", columns, lines, notes)


def fates(rows: pd.DataFrame) -> Table:
    """What became of every window of the selection, per algorithm."""
    windows = rows["window"].nunique()
    columns = [Column("algorithm"), Column("answers"), Column("windows"),
               *(Column(f) for f in facts.FATES)]
    lines: list[list[Cell]] = []
    for algorithm, own in rows.groupby("algorithm", sort=True):
        counts = own["fate"].value_counts()
        lines.append([str(algorithm), str(own["answer"].iloc[0]), windows,
                      *(int(counts.get(f, 0)) for f in range(facts.NOT_ASKED)),
                      windows - len(own)])
    kinds = rows.drop_duplicates("window")["hardness"].value_counts()
    told = ", ".join(f"{int(kinds[h])} {h}" for h in (*facts.HARDNESSES, facts.EMPTY) if h in kinds)
    notes = [f"{windows} windows: {told}. " + " ".join(
        f"{h}: {meaning}." for h, meaning in facts.HARDNESS_MEANING.items())
        + " empty: without columns; counted here, ranked nowhere.",
        "timed out: the deadline came before a proof, with or without an answer at hand. optimal: "
        "proof claimed and not refuted. declined: skipped with a reason."]
    return Table("fates", "What became of every window", columns, lines, notes)


def order(ranked: list[tuple[Contest, list[Standing]]], shift_ms: float = SHIFT_MS) -> Table:
    """The ranking."""
    columns = [Column("hardness", once=True), Column("place"), Column("95 %"), Column("algorithm"),
               Column("refuted"), Column("proven optimal [%]", digits=".1f", interval=True),
               Column("mean", "certified gap [nats]", ".3f", interval=True),
               Column("p95", "certified gap [nats]", ".2f"),
               Column("max", "certified gap [nats]", ".2f"),
               Column("CPU, shifted geo. mean [ms]", digits=".3f", interval=True), Column("PAR-2")]
    lines: list[list[Cell]] = []
    for contest, found in ranked:
        for s in found:
            lines.append([contest.hardness, _place(s), _spread(s.place), s.algorithm, s.refuted,
                          _times(s.proven, 100.0), s.certified_gap, s.certified_gap_p95,
                          s.certified_gap_max, s.time, s.penalised])
    notes = [
        "Order: correctness, share proven optimal, mean certified gap (where no bound is "
        "certified: the gap to the best known cost), CPU time. Brackets and 95 %: bootstrap over "
        "scenes, (scenario, replicate), not windows.",
        "Certified gap: cost minus the best certified bound of any row with the same fingerprint; "
        "no bound by multipliers exceeds the LP optimum, so on hard windows even a proven optimum "
        "has one. A window without an answer counts as doing nothing (inf where that is not allowed).",
        f"CPU: solving and the views asked for; shift {shift_ms:g} ms. PAR-2: windows that cost "
        "twice the time limit (timed out, declined, failed, refuted, no answer).",
    ]
    return Table("ranking", "Ranking", columns, lines, notes)


def _place(standing: Standing) -> str:
    return "out" if standing.place is None else f"{standing.place.value:.0f}"


def _spread(place: Estimate | None) -> str | None:
    if place is None or place.low is None or place.high is None:
        return None
    return f"{place.low:.0f}-{place.high:.0f}"


def _times(estimate: Estimate, factor: float) -> Estimate:
    if estimate.low is None or estimate.high is None:
        return Estimate(factor * estimate.value)
    return Estimate(factor * estimate.value, factor * estimate.low, factor * estimate.high)


def gaps(ranked: list[tuple[Contest, list[Standing]]]) -> Table:
    """Against the best known cost, and what is certified."""
    columns = [Column("hardness", once=True), Column("algorithm"), Column("n"),
               Column("answered", "percent", ".1f"), Column("best known", "percent", ".1f"),
               Column("certified", "percent", ".1f"),
               Column("mean", "above the best known cost [nats]", ".4f", interval=True),
               Column("max", "above the best known cost [nats]", ".3f")]
    lines: list[list[Cell]] = [
        [contest.hardness, s.algorithm, len(contest.windows), 100 * s.answered, 100 * s.best_known,
         100 * s.certified, s.gap, s.gap_max] for contest, found in ranked for s in found]
    notes = ["best known: in time at the cheapest verified cost of columns of any row. certified: "
             "the answer's cost equals a certified bound, whoever certified it. Negative gaps: "
             "sequences that are no column."]
    return Table("gaps", "Gaps and answers", columns, lines, notes)


def times(ranked: list[tuple[Contest, list[Standing]]], shift_ms: float = SHIFT_MS) -> Table:
    """How far the shift decides."""
    shifts = [shift_ms * factor for factor in (0.1, 1.0, 10.0)]
    columns = [Column("hardness", once=True), Column("algorithm"), Column("n")]
    columns += [Column(f"s = {s:g}", "shifted geometric mean [ms]", ".4g") for s in shifts]
    columns += [Column(f"s = {s:g}", "place by time alone") for s in shifts]
    columns += [Column("median [ms]", digits=".4g"), Column("max in time [ms]", digits=".4g"),
                Column("PAR-2"), Column("wall > 1.2 CPU")]
    lines: list[list[Cell]] = []
    for contest, found in ranked:
        own = {a: contest.time_ms[:, i] for i, a in enumerate(contest.algorithms)}
        means = {a: [measures.shifted_geometric_mean(t, s) for s in shifts]
                 for a, t in own.items()}
        for s in found:
            time = own[s.algorithm]
            i = contest.algorithms.index(s.algorithm)
            in_time = time[contest.in_time[:, i]]
            lines.append([
                contest.hardness, s.algorithm, len(time), *means[s.algorithm],
                *(1 + sum(m[k] < means[s.algorithm][k] for m in means.values())
                  for k in range(len(shifts))),
                float(pd.Series(time).median()), float(in_time.max()) if len(in_time) else None,
                s.penalised, int(contest.disturbed[:, i].sum())])
    return Table("times", "CPU time, with PAR-2", columns, lines,
                 ["The shift s keeps tiny times from deciding; places that move with it are weak."])


def ranked(contests: list[Contest],
           shift_ms: float = SHIFT_MS) -> list[tuple[Contest, list[Standing]]]:
    """Every contest with its ranking."""
    return [(contest, standings(contest, shift_ms)) for contest in contests]
