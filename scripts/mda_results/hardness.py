"""Gap and time by how hard a window is: LP gap, fractional columns, largest component."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from mda_results import facts, measures
from mda_results.contest import Contest
from mda_results.render import Cell, Column, Table
from mda_results.standings import SHIFT_MS

# (field of a window, what it is called, upper ends of the bins)
MEASURES = (
    ("lp_gap", "LP gap [nats]", (0.0, 0.1, 1.0, np.inf)),
    ("lp_fractional", "fractional columns", (0, 6, 20, np.inf)),
    ("largest_component_columns", "columns of the largest component", (10, 100, 1000, np.inf)),
)


@dataclass(frozen=True)
class Bin:
    """Windows of one hardness, between two values of one measure."""

    field: str
    label: str
    contest: Contest


def bins(contest: Contest) -> Iterator[Bin]:
    """Those that hold windows; a window of which the measure is not known is in none."""
    for field, _, ends in MEASURES:
        values = contest.windows[field].to_numpy(dtype=float)
        if field == "lp_gap":
            within = facts.tolerance(contest.windows["best"]).to_numpy()
            values = np.where(np.abs(values) <= within, 0.0, values)
        below = -np.inf
        for end in ends:
            chosen = (values > below) & (values <= end)
            if chosen.any():
                yield Bin(field, _label(below, end), contest.among(chosen))
            below = end


def tables(contests: list[Contest], shift_ms: float = SHIFT_MS) -> list[Table]:
    """One per measure: a line per algorithm and hardness, a block per bin."""
    found = [b for contest in contests for b in bins(contest)]
    return [_table(field, word, [b for b in found if b.field == field], shift_ms)
            for field, word, _ in MEASURES if any(b.field == field for b in found)]


def _table(field: str, word: str, found: list[Bin], shift_ms: float) -> Table:
    labels = [label for label in _labels(field) if any(b.label == label for b in found)]
    columns = [Column("hardness", once=True), Column("algorithm")]
    for label in labels:
        columns += [Column("n", label), Column("best %", label, ".0f"),
                    Column("gap", label, ".3f"), Column("ms", label, ".3f")]
    by = {(b.contest.hardness, b.label): b.contest for b in found}
    lines: list[list[Cell]] = []
    for hardness in dict.fromkeys(b.contest.hardness for b in found):
        names = next(b.contest.algorithms for b in found if b.contest.hardness == hardness)
        for i, name in enumerate(names):
            cells = [_cells(by.get((hardness, label)), i, shift_ms) for label in labels]
            lines.append([hardness, name, *(c for four in cells for c in four)])
    notes = ["best: share of windows solved in time at the best known cost; gap: mean above it; "
             f"ms: shifted geometric mean of CPU time, shift {shift_ms:g} ms, PAR-2. Windows of "
             "different hardness are never averaged together."]
    return Table(f"hardness_{field}", f"By {word}", columns, lines, notes)


def _labels(field: str) -> Iterator[str]:
    ends = next(ends for name, _, ends in MEASURES if name == field)
    return (_label(below, end) for below, end in zip((-np.inf, *ends), ends))


def _label(below: float, end: float) -> str:
    if np.isinf(end):
        return f"> {below:g}"
    return "0" if end == 0 else f"<= {end:g}"


def _cells(contest: Contest | None, i: int, shift_ms: float) -> list[Cell]:
    if contest is None:
        return [None] * 4
    return [len(contest.windows), 100 * float(contest.reached[:, i].mean()),
            float(contest.gap[:, i].mean()),
            measures.shifted_geometric_mean(contest.time_ms[:, i], shift_ms)]
