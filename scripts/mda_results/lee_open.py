"""Open loop over position targets: gaps to the exact optimum and times."""

import pandas as pd

from mda_results import cells
from mda_results.battistelli_open import is_optimal, mean_gap
from mda_results.render import Cell, Column, Table


def tables(rows: pd.DataFrame) -> list[Table]:
    """A line per scenario and algorithm."""
    columns = [Column("scenario", once=True), Column("algorithm"), Column("n"),
               Column("mean gap [nats]", digits=".4f", interval=True),
               Column("worst", digits=".2f"), Column("optimal [%]", digits=".1f"),
               Column("certified [%]", digits=".1f"), Column("solve", "CPU [ms]", ".4f"),
               Column("views", "CPU [ms]", ".4f"), Column("skip"), Column("fail")]
    lines: list[list[Cell]] = [
        [str(s), str(a), *_line(own)]
        for (s, a), own in rows.groupby(["scenario", "algorithm"], sort=True, observed=True)]
    notes = ["Windows of one scan, driven by the exact optimum. Gap: cost minus optimum; methods "
             "that answer with marginals or a relaxation have none. optimal: gap at most 1e-5 nats "
             "+ 1e-9 |cost|. certified: answers with a bound recomputed from multipliers. CPU: "
             "means over answered windows. fail: also without an answer."]
    return [Table("open_loop", "Open loop", columns, lines, notes)]


def _line(own: pd.DataFrame) -> list[Cell]:
    good = own[cells.answered(own)]
    with_gap = good.dropna(subset=["gap_nats"])
    skipped = int((own["status"] == "skipped").sum())
    optimal = certified = None
    if len(with_gap):
        optimal = 100.0 * float(is_optimal(with_gap).mean())
    if len(good):
        certified = 100.0 * float(good["certified_bound_nats"].notna().mean())
    return [len(good), mean_gap(own),
            float(with_gap["gap_nats"].max()), optimal, certified, float(good["cpu_ms"].mean()),
            float(good["views_ms"].mean()), skipped, len(own) - len(good) - skipped]
