"""Tables 6 and 7 of Storms & Spieksma (2003): the fractional windows of group D, one by one."""

import pandas as pd

from mda_results import cells
from mda_results.render import Cell, Column, Report, Table
from mda_results.rows import Run, RunError

_PRINTED = 5  # scenarios of the paper
# Solver, its branch and bound, its LP with rounding.
_SOLVERS = (("Clp and CBC", "cbc", "lp-grp"), ("lp_solve", "lpsolve-bb", "lpsolve-lp-grp"))


def report(run: Run) -> Report:
    """Raises RunError when the run has no fractional windows of group D at K = 3."""
    rows = cells.rows_of_paper(run)
    rows = rows[(rows["group"] == "D") & (rows["window_k"] == 3)]
    tables = [_windows(solver, _paired(rows, slow, quick)) for solver, slow, quick in _SOLVERS
              if {slow, quick} <= set(rows["algorithm"])]
    if not tables:
        raise RunError(f"{run.name} has no rows of cbc and lp-grp on group D at K = 3")
    about = [f"Run {run.name}: the windows of group D, K = 3, whose LP is fractional. Times are CPU "
             "times in ms of a whole call, building the model included; the paper's, of 2001 and "
             "of lp_solve 1.5, are in results/published."]
    return Report("Storms & Spieksma 2003, Tables 6 and 7", about,
                  [_ratios(rows), *tables])


def _paired(rows: pd.DataFrame, slow: str, quick: str) -> pd.DataFrame:
    """The fractional windows, one a row, that both algorithms finished."""
    usable = rows[cells.answered(rows) & (rows["stop"] == "finished")]
    key = cells.window_key()
    first = usable[usable["algorithm"] == slow][[*key, "cpu_ms"]]
    second = usable[(usable["algorithm"] == quick) & (usable["integral"] == 0)]
    pairs = second.merge(first, on=key, suffixes=("", "_bb"))
    return pairs.assign(ratio=pairs["cpu_ms_bb"] / pairs["cpu_ms"],
                        optimum=pairs["retired_nats"] + pairs["reference_cost_nats"],
                        gap=cells.without_noise(pairs["gap_nats"]))


def _windows(solver: str, pairs: pd.DataFrame) -> Table:
    columns = [Column("scenario", once=True), Column("scan"), Column("F"),
               Column("t_BB", digits=".2f"), Column("t_LP + t_R", digits=".2f"),
               Column("t_LP", "wall", ".2f"), Column("t_R", "wall", ".3f"), Column("ratio", digits=".2f"),
               Column("O", digits=".2f"), Column("Δ", digits=".2f")]
    rows: list[list[Cell]] = []
    for _, w in pairs[pairs["replicate"] <= _PRINTED].iterrows():
        rows.append([str(int(w["replicate"]) + cells.number_offset("D")), int(w["scan"]),
                     int(w["paper_fractional"]), float(w["cpu_ms_bb"]), float(w["cpu_ms"]),
                     float(w["lp_ms"]), float(w["round_ms"]), float(w["ratio"]),
                     float(w["optimum"]), float(w["gap"])])
    notes = ["F: fractional columns and plots with a fractional slack. O, Δ in nats."]
    if (pairs["replicate"] > _PRINTED).any():
        notes.append(f"The first {_PRINTED} scenarios; the distribution above is of all.")
    return Table(f"windows_{'lpsolve' if solver == 'lp_solve' else 'clp_cbc'}",
                 f"Fractional windows, {solver}", columns, rows, notes)


def _ratios(rows: pd.DataFrame) -> Table:
    """t_BB / (t_LP + t_R), published and with each solver of the run."""
    columns = [Column("solver"), Column("windows"), Column("mean", "ratio", ".2f"),
               Column("median", "ratio", ".2f"), Column(">= 1.2 [%]", "ratio", ".0f"),
               Column(">= 1.5 [%]", "ratio", ".0f"), Column("mean F", digits=".1f"),
               Column("mean Δ", digits=".2f"), Column("max Δ", digits=".2f")]
    paper = cells.published_windows()
    lines = [("published: lp_solve 1.5", paper["ratio_bb_over_lp_plus_round"],
              paper["fractional_f"], paper["gap_delta"])]
    for solver, slow, quick in _SOLVERS:
        if {slow, quick} <= set(rows["algorithm"]):
            pairs = _paired(rows, slow, quick)
            lines.append((f"ours: {solver}", pairs["ratio"], pairs["paper_fractional"],
                          pairs["gap"]))
    table_rows: list[list[Cell]] = [
        [name, len(ratio), float(ratio.mean()), float(ratio.median()),
         100 * float((ratio >= 1.2).mean()), 100 * float((ratio >= 1.5).mean()),
         float(f.mean()), float(gap.mean()), float(gap.max())]
        for name, ratio, f, gap in lines]
    return Table("ratios", "Branch and bound over LP and rounding", columns, table_rows)
