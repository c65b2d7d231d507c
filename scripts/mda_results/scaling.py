"""How the time of an algorithm grows: exponents by least squares on logarithms."""

from dataclasses import dataclass

import numpy as np

from mda_results import bootstrap, measures
from mda_results.contest import Contest
from mda_results.render import Cell, Column, Estimate, Table

SIZES = {"window_k": "K", "columns": "columns", "targets": "targets"}
_SHORTEST_MS = 1e-3  # a shorter time counts as this one, as the clock's step
_FEWEST = 10  # windows of a fit


@dataclass(frozen=True)
class Exponent:
    """Time grows as size to the power of the exponent."""

    algorithm: str
    size: str  # a key of SIZES
    exponent: Estimate
    windows: int  # of the fit: those solved in time whose size is known
    left_out: int


def exponents(contest: Contest) -> list[Exponent]:
    """Of every algorithm and size; NaN where the size does not vary."""
    weights = contest.weights()
    found = []
    for i, algorithm in enumerate(contest.algorithms):
        y = np.log(np.maximum(contest.time_ms[:, i], _SHORTEST_MS))
        for size in SIZES:
            values = contest.windows[size].to_numpy(dtype=float)
            usable = contest.in_time[:, i] & (np.nan_to_num(values) > 0)
            x = np.log(np.where(usable, values, 1.0))
            x = np.where(usable, x - x[usable].mean() if usable.any() else x, 0.0)
            sums = contest.by_scene(usable[:, None] * np.column_stack(
                [np.ones_like(x), x, y, x * x, x * y]))
            found.append(Exponent(algorithm, size, _fitted(sums, weights), int(usable.sum()),
                                  int((~usable).sum())))
    return found


def _fitted(sums: np.ndarray, weights: np.ndarray | None) -> Estimate:
    total = sums.sum(axis=0)
    value = _slope(total) if total[0] >= _FEWEST else np.array(np.nan)
    if weights is None:
        return Estimate(float(value))
    return bootstrap.interval(float(value), _slope((weights @ sums).T))


def _slope(sums: np.ndarray) -> np.ndarray:
    """Rounded: what a constant time leaves is noise; no minus before zero."""
    return np.round(measures.slope(*sums), 9) + 0.0


def table(contests: list[Contest]) -> Table:
    columns = [Column("hardness", once=True), Column("algorithm")]
    for word in SIZES.values():
        columns += [Column(word, "exponent of CPU time in", ".2f", interval=True)]
    columns += [Column("n"), Column("left out")]
    lines: list[list[Cell]] = []
    for contest in contests:
        found = {(e.algorithm, e.size): e for e in exponents(contest)}
        for a in contest.algorithms:
            own = [found[a, size] for size in SIZES]
            lines.append([contest.hardness, a, *(e.exponent for e in own), own[0].windows,
                          own[0].left_out])
    notes = ["Each size alone, least squares of log time on log size, intervals over scenes. Only "
             "windows solved in time; how many are left out, which flattens the line, stands "
             "beside. Targets: those known, else the births expected up to the newest scan. A "
             "dash: the size does not vary."]
    return Table("scaling", "How time grows", columns, lines, notes)
