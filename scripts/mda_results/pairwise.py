"""Who beats whom: on how many windows, and whether scenes bear it out."""

import itertools
from dataclasses import dataclass, replace

import numpy as np

from mda_results import measures
from mda_results.contest import Contest
from mda_results.render import Cell, Column, Table
from mda_results.standings import SHIFT_MS

_LEVEL = 0.05


@dataclass(frozen=True)
class Duel:
    """The first against the second, by cost or by time; less is better."""

    measure: str  # "cost" or "time"
    first: str
    second: str
    better: int
    equal: int
    worse: int
    difference: float  # nats; of times the ratio of shifted geometric means
    scenes: int  # that the test rests on
    p: float  # of Wilcoxon's test over the means of scenes
    p_holm: float  # the same adjusted for all duels of one measure

    @property
    def decided(self) -> bool:
        return self.p_holm < _LEVEL


def duels(contest: Contest, shift_ms: float = SHIFT_MS) -> list[Duel]:
    """Every pair of algorithms (first before second in the contest), by cost, then by time. The
    test's unit is the scene: the windows of a scene are no independent draws."""
    log_time = np.log(contest.time_ms + shift_ms)
    by_time = _family(contest, "time", contest.time_ms, log_time, 1e-12)
    return _family(contest, "cost", contest.gap, contest.gap, 1e-9) + by_time


def _family(contest: Contest, measure: str, compared: np.ndarray, averaged: np.ndarray,
            noise: float) -> list[Duel]:
    counts = np.bincount(contest.unit, minlength=len(contest.unit_groups))[:, None]
    scenes = contest.by_scene(averaged) / counts
    found = []
    for i, j in itertools.combinations(range(len(contest.algorithms)), 2):
        better = int((compared[:, i] < compared[:, j]).sum())
        worse = int((compared[:, i] > compared[:, j]).sum())
        d = _difference(scenes[:, i], scenes[:, j], noise)
        with np.errstate(invalid="ignore"):
            mean = float(_difference(averaged[:, i], averaged[:, j], 0.0).mean())
        found.append(Duel(measure, contest.algorithms[i], contest.algorithms[j], better,
                          len(compared) - better - worse, worse,
                          float(np.exp(mean)) if measure == "time" else mean,
                          len(d), measures.signed_rank_p(d), 1.0))
    adjusted = measures.holm([duel.p for duel in found])
    return [replace(duel, p_holm=p) for duel, p in zip(found, adjusted)]


def _difference(first: np.ndarray, second: np.ndarray, noise: float) -> np.ndarray:
    """0 where both are infinite or within noise."""
    with np.errstate(invalid="ignore"):  # infinite: no answer where doing nothing is not allowed
        d = np.where(first == second, 0.0, first - second)
    return np.where(np.abs(d) <= noise, 0.0, d)


def matrix(contest: Contest, found: list[Duel], measure: str) -> Table:
    """Share of windows on which the line's algorithm beats the column's."""
    names, shares = contest.algorithms, {}
    for duel in found:
        if duel.measure == measure:
            n, mark = len(contest.windows), "*" if duel.decided else ""
            shares[duel.first, duel.second] = f"{100 * duel.better / n:.0f}{mark}"
            shares[duel.second, duel.first] = f"{100 * duel.worse / n:.0f}{mark}"
    columns = [Column(""), Column("beats, % of windows"),
               *(Column(str(k)) for k in range(1, len(names) + 1))]
    lines: list[list[Cell]] = [
        [str(k), name, *(shares.get((name, other)) for other in names)]
        for k, name in enumerate(names, start=1)]
    notes = [f"The rest of 100 % minus both directions are ties. *: the scenes differ, Wilcoxon's "
             f"signed-rank test over the means of {len(contest.unit_groups)} scenes, p < "
             f"{_LEVEL:g} after Holm over all {len(shares) // 2} pairs."]
    least = min(1.0, 2.0 ** (1 - len(contest.unit_groups)) * (len(shares) // 2))
    if least >= _LEVEL:
        notes.append(f"With so few scenes no p-value can pass: the least possible is {least:.2g}.")
    word = "lower cost" if measure == "cost" else "less CPU time (PAR-2)"
    return Table(f"beats_{measure}_{contest.hardness}",
                 f"Who beats whom by {word}, {contest.hardness} windows", columns, lines, notes)


def pairs(found: list[tuple[Contest, list[Duel]]]) -> Table:
    """Every duel with its p-values: data for files."""
    columns = [*map(Column, ("hardness", "by", "first", "second", "better", "equal", "worse")),
               Column("difference or ratio", digits=".4g"),
               Column("scenes"), Column("p", digits=".3g"), Column("p Holm", digits=".3g")]
    lines: list[list[Cell]] = [
        [contest.hardness, d.measure, d.first, d.second, d.better, d.equal, d.worse, d.difference,
         d.scenes, d.p, d.p_holm] for contest, duels_of in found for d in duels_of]
    return Table("pairs", "Every pair", columns, lines,
                 ["by cost: mean difference in nats; by time: ratio of geometric means."])
