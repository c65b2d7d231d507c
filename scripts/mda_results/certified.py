"""Time to a proven optimum: the certified solver against the best of all others on each window."""

import numpy as np
import pandas as pd

from mda_results import cells
from mda_results.pool import time_limit_s
from mda_results.render import Cell, Column, Report, Table
from mda_results.rows import Run, RunError

_OURS, _LP, _DUAL = "tree-exact", "lp", "dual-ascent"
# An LP proves an optimum where it is integral.
_RIVALS = ("exact", "cbc", "cbc-main", "lpsolve-bb", "glpk-bb", _LP)
_SHIFT_MS = 0.01  # of the geometric means: differences below it hardly count
_KEY = ["scenario", "window_k"]
_WINDOW = [*_KEY, "scan_period_s", "replicate", "scan"]
_GAP_EDGES = [0.0, 1e-4, 0.8, 1.0, np.inf]
_GAP_NAMES = ["none", "to 0.8", "to 1", "above 1"]


def report(run: Run) -> Report:
    """Raises RunError when the run has no rows of tree-exact and at least one rival."""
    rows = run.rows[run.rows["columns"] > 0]
    rows = rows.assign(scenario=rows["scenario"].astype(str),
                       algorithm=rows["algorithm"].astype(str))
    rivals = [name for name in _RIVALS if (rows["algorithm"] == name).any()]
    if not (rows["algorithm"] == _OURS).any() or not rivals:
        raise RunError(f"{run.name} has no rows of {_OURS} beside those of another exact solver")
    limit_s = time_limit_s(run.manifest)
    if limit_s is None:
        raise RunError(f"{run.name} does not tell its time limit")
    limit_ms = 1e3 * limit_s
    times, left_out = _times(rows, limit_ms, [_OURS, *rivals])
    groups = list(times.groupby(level=_KEY, sort=True))
    repeats = int(run.manifest["sweep"].get("repeats", 1))
    repeated = f"Solves below 30 ms: the fastest of {repeats}. " if repeats > 1 else ""
    about = [f"Run {run.name}, time limit {limit_ms / 1e3:g} s. CPU times of a solve, from the "
             "window's columns to the proof, building of models included; the order of solvers is "
             "shuffled window by window. " + repeated + "Best: the fastest of "
             + ", ".join(rivals) + f" on each window, in hindsight; {_LP} counts where it is "
             "integral.",
             "A solver that proves nothing within the limit is charged twice the limit (PAR-2). "
             f"Means are geometric, shifted by {_SHIFT_MS:g} ms."]
    if left_out:
        about.append(f"{left_out} windows left out: not every solver has a row with a time there.")
    tables = [_ratio_table(groups, rivals, 2 * limit_ms)]
    gaps = _lp_gaps(rows)
    if len(gaps):
        tables += [_gap_table(times, gaps, rivals, 2 * limit_ms), _hardness_table(rows, gaps)]
    return Report("Proven optima", about, [*tables, _loss_table(times, 2 * limit_ms)])


def _times(rows: pd.DataFrame, limit_ms: float,
           solvers: list[str]) -> tuple[pd.DataFrame, int]:
    """CPU ms until the optimum was proven, one line a window that all have a time for, one column a
    solver; and how many windows lack one. Raises RunError when all do."""
    proven = (rows["status"].astype(str) == "optimal") & (rows["stop"].astype(str) == "finished")
    proven &= (rows["algorithm"] != _LP) | (rows["integral"] == 1)
    charged = rows.assign(ms=np.where(proven, rows["cpu_ms"].astype(float), 2 * limit_ms))
    times = charged.pivot_table(index=_WINDOW, columns="algorithm", values="ms", observed=True)
    whole = times.dropna(subset=[name for name in solvers if name in times])
    if whole.empty or not set(solvers) <= set(whole):
        raise RunError("there is no window for which every solver has a time")
    return whole, len(times) - len(whole)


def _mean(ms: pd.Series) -> float:
    return float(np.exp(np.log(ms + _SHIFT_MS).mean()) - _SHIFT_MS)


def _ratio_table(groups: list[tuple[tuple[str, int], pd.DataFrame]], rivals: list[str],
                 penalty_ms: float) -> Table:
    shown = [name for name in rivals if name != _LP]
    columns = [Column("scenario", once=True), Column("K"), Column("windows"),
               Column("mean", "tree-exact [ms]", ".3f"),
               Column("largest", "tree-exact [ms]", ".2f"),
               Column("proven [%]", digits=".1f"), Column("by the dual alone [%]", digits=".1f"),
               Column("mean", "best [ms]", ".3f"), Column("proven [%]", "best [ms]", ".1f"),
               Column("of means", "best / tree-exact", ".2f"),
               Column("median", "best / tree-exact", ".2f"),
               Column("least", "best / tree-exact", ".2f"),
               Column("PAR-2", "best / tree-exact", ".2f"), Column("won [%]", digits=".0f"),
               *[Column(name, "of means / tree-exact", ".1f") for name in shown]]
    lines: list[list[Cell]] = []
    for (scenario, k), own in groups:
        ours, best = own[_OURS], own[rivals].min(axis=1)
        ratio = best / ours
        dual = own[_DUAL] if _DUAL in own else pd.Series(np.nan, index=own.index)
        lines.append([scenario, str(k), len(own), _mean(ours), float(ours.max()),
                      100 * float((ours < penalty_ms).mean()),
                      None if dual.isna().all() else 100 * float((dual < penalty_ms).mean()),
                      _mean(best), 100 * float((best < penalty_ms).mean()),
                      _mean(best) / _mean(ours), float(ratio.median()), float(ratio.min()),
                      float(best.mean() / ours.mean()), 100 * float((ratio > 1).mean()),
                      *[_mean(own[name]) / _mean(ours) for name in shown]])
    return Table("ratios", "Time to the proof", columns, lines)


def _lp_gaps(rows: pd.DataFrame) -> pd.Series:
    """Percent of the best choice that anybody found, one line a window whose LP was solved."""
    answer = rows["answer"].astype(str)
    best, lp = (rows[cells.answered(rows) & (answer == kind)]
                .groupby(_WINDOW, observed=True)["cost_nats"].min()
                for kind in ("selection", "relaxation"))
    return (100 * (best - lp) / best.abs()).clip(lower=0.0).dropna()


def _gap_table(times: pd.DataFrame, gaps: pd.Series, rivals: list[str],
               penalty_ms: float) -> Table:
    columns = [Column("family", once=True), Column("LP gap [%]"), Column("windows"),
               Column("proven [%]", "tree-exact", ".1f"), Column("proven [%]", "best", ".1f"),
               Column("median", "best / tree-exact", ".2f"),
               Column("least", "best / tree-exact", ".2f"),
               Column("PAR-2", "best / tree-exact", ".2f")]
    own = times.loc[times.index.intersection(gaps.index)]
    family = pd.Series([str(name).split("-")[0] for name in own.index.get_level_values(0)],
                       index=own.index)
    kind = pd.cut(gaps.reindex(own.index), _GAP_EDGES, labels=_GAP_NAMES, include_lowest=True)
    lines: list[list[Cell]] = []
    for (name, gap), part in own.groupby([family, kind], observed=True, sort=True):
        ours, best = part[_OURS], part[rivals].min(axis=1)
        lines.append([name, gap, len(part), 100 * float((ours < penalty_ms).mean()),
                      100 * float((best < penalty_ms).mean()), float((best / ours).median()),
                      float((best / ours).min()), float(best.mean() / ours.mean())])
    return Table("gaps", "By the gap of the LP", columns, lines)


def _hardness_table(rows: pd.DataFrame, gaps: pd.Series) -> Table:
    """What the windows are like, from the rows of the LP."""
    columns = [Column("scenario", once=True), Column("K"), Column("median", "columns", ".0f"),
               Column("largest", "columns"), Column("component", "largest, median", ".0f"),
               Column("integral [%]", digits=".0f"), Column("fractional", "mean", ".0f"),
               Column("mean", "LP gap [%]", ".3f"), Column("largest", "LP gap [%]", ".3f")]
    lp = rows[(rows["algorithm"] == _LP) & cells.answered(rows)]
    lines: list[list[Cell]] = []
    for (scenario, k), own in lp.groupby(_KEY, sort=True):
        gap = gaps.reindex(pd.MultiIndex.from_frame(own[_WINDOW]))
        lines.append([scenario, str(k), float(own["columns"].median()), int(own["columns"].max()),
                      float(own["largest_component_columns"].median()),
                      100 * float((own["integral"] == 1).mean()), float(own["fractional"].mean()),
                      float(gap.mean()), float(gap.max())])
    return Table("hardness", "How hard the windows are", columns, lines,
                 ["LP gap: between the LP's value and the best choice known, as a share of that."])


def _loss_table(times: pd.DataFrame, penalty_ms: float) -> Table:
    """The windows on which another solver was faster."""
    rivals = [name for name in _RIVALS if name in times]
    best = times[rivals].min(axis=1)
    lost = times.assign(best=best, by=times[rivals].idxmin(axis=1))[best < times[_OURS]]
    lost = lost.assign(ratio=lost["best"] / lost[_OURS]).sort_values("ratio").head(20)
    columns = [Column("scenario"), Column("K"), Column("replicate"), Column("scan"),
               Column("tree-exact", "CPU [ms]", ".3f"), Column("best", "CPU [ms]", ".3f"),
               Column("which"), Column("ratio", digits=".2f")]
    lines: list[list[Cell]] = []
    for key, line in lost.iterrows():
        named = dict(zip(times.index.names, key, strict=True))
        lines.append([named["scenario"], str(named["window_k"]), int(named["replicate"]),
                      int(named["scan"]), float(line[_OURS]), float(line["best"]), line["by"],
                      float(line["ratio"])])
    notes = [f"{int((best < times[_OURS]).sum())} of {len(times)} windows lost; the worst 20. "
             f"{penalty_ms:.0f} ms: nothing proven."]
    return Table("losses", "Windows on which another solver was faster", columns, lines, notes)
