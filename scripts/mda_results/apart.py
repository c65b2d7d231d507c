"""Relaxations and marginals: no gap, so ranked apart by bound and time."""

import numpy as np
import pandas as pd

from mda_results import facts, measures
from mda_results.contest import Contest, contests
from mda_results.render import Cell, Column, Table
from mda_results.standings import SHIFT_MS, standings


def table(rows: pd.DataFrame, shift_ms: float = SHIFT_MS) -> Table:
    """Both kinds, per hardness; relaxations in the order of their bounds, then time."""
    columns = [Column("answers", once=True), Column("hardness", once=True), Column("place"),
               Column("algorithm"), Column("refuted"), Column("n"),
               Column("answered [%]", digits=".1f"), Column("integral [%]", digits=".1f"),
               Column("mean", "bound below the best [nats]", ".4f"),
               Column("max", "bound below the best [nats]", ".3f"),
               Column("worst row violation", digits=".3g"),
               Column("CPU, shifted geo. mean [ms]", digits=".3f", interval=True), Column("PAR-2")]
    lines: list[list[Cell]] = []
    notes: list[str] = []
    for answer in ("relaxation", "marginals"):
        for contest in contests(rows, notes, answer):
            lines += [[answer, contest.hardness, *line]
                      for line in _lines(contest, rows, shift_ms)]
    notes.append("Bound: certified, else claimed; against the best certified bound of any row. "
                 "Their cost is no cost of an answer, so they have no gap and no place among the "
                 "selections.")
    return Table("apart", "Relaxations and marginals, ranked apart", columns, lines, notes)


def _lines(contest: Contest, rows: pd.DataFrame, shift_ms: float) -> list[list[Cell]]:
    own = rows[rows["window"].isin(contest.windows["window"])
               & rows["algorithm"].isin(contest.algorithms)]
    below = own["bound"] - own["certified_bound_nats"].fillna(own["bound_nats"])
    own = own.assign(below=below.mask(below.abs() <= facts.tolerance(own["bound"]), 0.0))
    by = own.groupby("algorithm")
    found = by.agg(mean=("below", "mean"), most=("below", "max"), integral=("integral", "mean"),
                   violation=("row_violation", "max"))
    scored = {s.algorithm: s for s in standings(contest, shift_ms)}
    names = list(found.index)
    times = np.array([scored[a].time.value for a in names])
    out = np.array([float(scored[a].refuted > 0) for a in names])
    place = measures.places(out, found["mean"].fillna(np.inf).to_numpy(), times)
    lines: list[tuple[tuple[float, int, str], list[Cell]]] = []
    for i, a in enumerate(names):
        s = scored[a]
        lines.append(((out[i], int(place[i]), a), [
            "out" if s.refuted else str(place[i]), a, s.refuted, len(contest.windows),
            100 * s.answered, 100 * float(found["integral"][a]), float(found["mean"][a]),
            float(found["most"][a]), float(found["violation"][a]), s.time, s.penalised]))
    return [line for _, line in sorted(lines, key=lambda entry: entry[0])]
