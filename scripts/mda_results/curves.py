"""Performance profiles, time to a gap, and the trade-off of gap against time, as tables."""

from collections.abc import Sequence

import numpy as np

from mda_results import measures
from mda_results.contest import Contest
from mda_results.render import Cell, Column, Table
from mda_results.standings import Standing

RATIOS = (1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 30.0, 100.0, 1000.0)
FINE_RATIOS = tuple(10.0 ** (k / 16) for k in range(65))
TIMES_MS = tuple(10.0 ** k for k in range(-2, 5))
FINE_TIMES_MS = tuple(10.0 ** (k / 8) for k in range(-24, 41))
TARGETS_NATS = (0.0, 0.1, 1.0, 10.0)


def profile(contest: Contest, ratios: Sequence[float] = FINE_RATIOS) -> np.ndarray:
    """(ratios, algorithms): share of windows on which the algorithm reached the best known cost
    within the ratio times the least CPU time of those that did."""
    times = np.where(contest.reached, contest.time_ms, np.inf)
    return measures.share_within(measures.performance_ratios(np.maximum(times, 1e-6)), ratios)


def time_to_gap(contest: Contest, target_nats: float,
                times_ms: Sequence[float] = FINE_TIMES_MS) -> np.ndarray:
    """(times, algorithms): share of windows on which an answer no more than the target above the
    best known cost was there by the time. An answer is there when its solver ends."""
    there = np.where(contest.gap <= target_nats, contest.spent_ms, np.inf)
    return measures.share_within(there, times_ms)


def profiles(contests: list[Contest], ratios: Sequence[float], name: str) -> Table:
    columns = [Column("hardness", once=True), Column("algorithm")]
    columns += [Column(_rounded(r), "percent within this ratio of the fastest", ".1f")
                for r in ratios]
    lines: list[list[Cell]] = []
    for contest in contests:
        shares = 100 * profile(contest, ratios)
        lines += [[contest.hardness, a, *map(float, shares[:, i])]
                  for i, a in enumerate(contest.algorithms)]
    notes = ["Dolan and More (2002). Success is the best known cost in time; all else is infinite. "
             "The fastest is that of the algorithms shown: with others left out, the order of the "
             "rest may change."]
    return Table(name, "Performance profiles", columns, lines, notes)


def ecdf(contests: list[Contest], targets_nats: Sequence[float], times_ms: Sequence[float],
         name: str) -> Table:
    columns = [Column("hardness", once=True), Column("algorithm", once=True),
               Column("gap at most [nats]", digits="g"), Column("ever [%]", digits=".1f")]
    columns += [Column(_rounded(t), "percent by this CPU time [ms]", ".1f") for t in times_ms]
    lines: list[list[Cell]] = []
    for contest in contests:
        shares = {t: 100 * time_to_gap(contest, t, [*times_ms, np.finfo(float).max])
                  for t in targets_nats}
        lines += [[contest.hardness, a, target, float(shares[target][-1, i]),
                   *map(float, shares[target][:-1, i])]
                  for i, a in enumerate(contest.algorithms) for target in targets_nats]
    notes = ["Empirical distribution over windows of the time to an answer within a gap to the "
             "best known cost; failures count as never."]
    return Table(name, "Time to a gap", columns, lines, notes)


def _rounded(value: float) -> str:
    return f"{float(f'{value:.4g}'):g}"


def pareto(ranked: list[tuple[Contest, list[Standing]]]) -> Table:
    """Mean gap above the best known cost against time; the disqualified are left out."""
    columns = [Column("hardness", once=True), Column("algorithm"),
               Column("gap [nats]", digits=".4f"), Column("CPU [ms]", digits=".3f"),
               Column("front"), Column("beaten in both by")]
    lines: list[list[Cell]] = []
    for contest, found in ranked:
        points = sorted((s for s in found if s.place is not None),
                        key=lambda s: (s.time.value, s.gap.value, s.algorithm))
        gap = np.array([s.gap.value for s in points])
        time = np.array([s.time.value for s in points])
        for i, s in enumerate(points):
            by = measures.dominator(gap, time, i)
            lines.append([contest.hardness, s.algorithm, s.gap.value, s.time.value,
                          "front" if by is None else "", points[by].algorithm if by is not None
                          else None])
    notes = ["Means as in the tables above. On the front: no other algorithm is as good in both "
             "and better in one."]
    return Table("pareto", "Pareto front of gap against time", columns, lines, notes)
