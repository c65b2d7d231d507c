"""Storms & Spieksma (2003) as distributions: per group and K, published against ours."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pandas as pd

from mda_results import bootstrap, cells
from mda_results.render import Cell, Column, Estimate, Table

_ALL = "all"
_INTERVALS = "Brackets: 95 % bootstrap interval over scenarios, 2000 resamples."
_KEY_COLUMNS = [Column("group"), Column("K")]


@dataclass(frozen=True)
class _Line:
    """One line of a summary: a group and K, or a total."""

    group: str
    window_k: str
    paper: pd.DataFrame  # cells
    ours: pd.DataFrame  # cells
    rows: pd.DataFrame  # of lp-grp

    @property
    def key(self) -> list[Cell]:
        return [self.group, self.window_k]


def tables(paper: pd.DataFrame, ours: pd.DataFrame, rows: pd.DataFrame) -> list[Table]:
    """The summaries; `rows` are those of all algorithms."""
    own = rows[rows["algorithm"] == cells.ROUNDING]
    lines = list(_lines(paper, ours, own))
    summaries = [_integrality(lines), _rounding(lines), _optimum(lines), _size(lines)]
    return summaries + ([_group_d(rows)] if (rows["group"] == "D").any() else [])


def _lines(paper: pd.DataFrame, ours: pd.DataFrame, own: pd.DataFrame) -> Iterator[_Line]:
    """Per group and K; A, B and C end with a total over the paper's K, C also with that of all."""
    present = set(ours["group"])
    for group in [g for g in cells.GROUPS if g in present]:
        p, o, r = (f[f["group"] == group] for f in (paper, ours, own))
        for k in sorted(set(p["window_k"]) | set(o["window_k"])):
            yield _Line(group, str(k), *(f[f["window_k"] == k] for f in (p, o, r)))
        if group != "D":
            yield _Line(group, _ALL, p, *(f[f["window_k"].isin(p["window_k"])] for f in (o, r)))
        if group == "C" and {"A", "B", "C"} <= present:
            p, o, r = (f[f["group"] != "D"] for f in (paper, ours, own))
            yield _Line("A-C", _ALL, p, *(f[f["window_k"].isin(p["window_k"])] for f in (o, r)))


def _percent(frame: pd.DataFrame, part: str, whole: str) -> Estimate | None:
    return bootstrap.ratio(frame, part, whole, lambda x: 100 * x)


def _integrality(lines: list[_Line]) -> Table:
    columns = list(_KEY_COLUMNS)
    for block in ("published", "ours"):
        columns += [Column("scenarios", block), Column("windows", block),
                    Column("fractional", block), Column("integral %", block, ".1f", interval=True)]
    rows = [
        [*line.key, *_integral_cells(line.paper), *_integral_cells(line.ours)] for line in lines
    ]
    notes = [_INTERVALS, f"\"{_ALL}\" is over the paper's K: 3 to 7."]
    single = [line for line in lines if line.window_k != _ALL]
    unsolved = sum(len(line.rows) - int(line.ours["windows"].sum()) for line in single)
    if unsolved:
        notes.append(f"Left out: {unsolved} windows that {cells.ROUNDING} did not solve.")
    return Table("integrality", "Windows whose LP optimum is integral", columns, rows, notes)


def _integral_cells(frame: pd.DataFrame) -> list[Cell]:
    if frame.empty:
        return [None] * 4
    scenarios = len(frame[["group", "replicate"]].drop_duplicates())
    counted = frame.assign(integral=frame["windows"] - frame["fractional"])
    return [scenarios, int(frame["windows"].sum()), int(frame["fractional"].sum()),
            _percent(counted, "integral", "windows")]


def _rounding(lines: list[_Line]) -> Table:
    columns = list(_KEY_COLUMNS)
    columns += [Column(s, "mean Δ", ".2f") for s in ("publ.", "ours")]
    columns += [Column(s, "max Δ", ".2f") for s in ("publ.", "ours")]
    columns += [Column(s, "optimal windows %", ".0f", True) for s in ("published", "ours")]
    columns += [Column(s, "in cells with Δ = 0, %", ".0f", True) for s in ("published", "ours")]
    rows = []
    for line in lines:
        sides = (line.paper, line.ours)
        means = [bootstrap.ratio(f, "gap_sum", "gap_known") for f in sides]
        rows.append([
            *line.key,
            *(m.value if m else None for m in means),
            *(float(f["gap_max"].max()) for f in sides),
            *(_percent(f, "rounded_optimal", "gap_known") for f in sides),
            *(_percent(f, "in_zero_cell", "fractional") for f in sides),
        ])
    notes = [
        "Over the fractional windows. A gap within 1e-5 nats counts as optimal.",
        "\"in cells with Δ = 0\": R summed over the (scenario, K) cells whose largest gap is 0, "
        "divided by all R; the paper counts so.",
        *(_counts(line) for line in lines if line.group == "A-C"),
    ]
    return Table("rounding", "Greedy rounding on fractional windows", columns, rows, notes)


def _counts(line: _Line) -> str:
    p, o = line.paper, line.ours
    text = (f"A-C: published {p['in_zero_cell'].sum()} of {p['fractional'].sum()} so counted; ours "
            f"{o['in_zero_cell'].sum()} of {o['fractional'].sum()}, and optimal in "
            f"{o['rounded_optimal'].sum()} windows.")
    unknown = int((o["fractional"] - o["gap_known"]).sum())
    return text + (f" The gap of {unknown} windows is not known." if unknown else "")


def _optimum(lines: list[_Line]) -> Table:
    columns = [*_KEY_COLUMNS, Column("published", "mean O", ".0f", interval=True),
               Column("ours", "mean O", ".0f", interval=True),
               Column("ours/publ.", digits=".2f"),
               Column("scenarios", "O above V_T"), Column("of", "O above V_T"),
               Column("largest", "O above V_T", ".1f")]
    rows = []
    for line in lines:
        published, mine = _mean_optimum(line.paper), _mean_optimum(line.ours)
        relative = mine.value / published.value if mine and published else None
        excess = (line.ours["optimum"] - line.ours["truth"]).dropna()
        above = excess[excess > cells.GAP_TOLERANCE]
        rows.append([*line.key, published, mine, relative,
                     *((len(above), len(excess)) if len(excess) else (None, None)),
                     float(above.max())])
    notes = [
        "O in nats, after the last scan. " + _INTERVALS,
        "V_T: cost of the true tracks. The paper, without naming K: O above V_T in three of its "
        "scenarios, by 33.8 (10), 54.7 (27), 38.2 (29).",
    ]
    return Table("optimum", "Optimum after the last scan", columns, rows, notes)


def _mean_optimum(frame: pd.DataFrame) -> Estimate | None:
    counted = frame.assign(known=frame["optimum"].notna().astype(int))
    return bootstrap.ratio(counted, "optimum", "known")


def _size(lines: list[_Line]) -> Table:
    columns = [*_KEY_COLUMNS, Column("mean", "columns before gating", ".3g"),
               Column("max", "columns before gating", ".3g"),
               Column("mean", "columns after gating", ".1f"), Column("max", "columns after gating"),
               Column("mean", "components", ".2f"), Column("max", "components")]
    rows: list[list[Cell]] = []
    for line in lines:
        cell_values: list[Cell] = [*line.key]
        for name in ("ungated_columns", "columns", "components"):
            values = line.rows[name].dropna()
            if values.empty:
                cell_values += [None, None]
            else:
                largest = float(values.max())
                cell_values += [float(values.mean()),
                                largest if name == "ungated_columns" else int(largest)]
        rows.append(cell_values)
    notes = [
        "Ours only. The paper gives one example, K = 7 and 30 plots a scan: 2.2e+10 before gating, "
        "about 1400 after."
    ]
    return Table("size", "Size of the windows", columns, rows, notes)


def _group_d(rows: pd.DataFrame) -> Table:
    """Tables 6 and 7 as distributions: the fractional windows of group D, K = 3."""
    d = rows[(rows["group"] == "D") & (rows["window_k"] == 3)]
    key = cells.window_key()
    own = d[(d["algorithm"] == cells.ROUNDING) & (d["integral"] == 0) & cells.answered(d)]
    own = own.set_index(key)
    bound = d[(d["algorithm"] == "cbc") & (d["status"] == "optimal")].set_index(key)
    ratio = (bound["cpu_ms"].reindex(own.index) / own["cpu_ms"]).dropna()
    gap = cells.without_noise(own["gap_nats"].dropna())
    paper = cells.published_windows()
    printed_ratio = paper["ratio_bb_over_lp_plus_round"]
    published = _group_d_measures(
        len(paper), paper["fractional_f"], paper["gap_delta"], printed_ratio
    )
    ours = _group_d_measures(len(own), own["paper_fractional"].dropna(), gap, ratio)
    lines = [[name, value, ours[name]] for name, value in published.items()]
    columns = [Column("measure"), Column("published", digits=".2f"), Column("ours", digits=".2f")]
    notes = [
        "F: fractional columns and false-alarm variables of the LP optimum.",
        "Time ratio: the paper's solver is lp_solve 1.5; ours is CPU time of cbc over CPU time of "
        "lp-grp.",
    ]
    title = "Tables 6 and 7 as distributions: fractional windows of group D, K = 3"
    return Table("tables_6_and_7", title, columns, lines, notes)


def _group_d_measures(
    count: int, fractional: pd.Series, gap: pd.Series, ratio: pd.Series
) -> dict[str, Cell]:
    def of(series: pd.Series, value: float) -> float:
        return float(value) if len(series) else np.nan

    return {
        "fractional windows": count,
        "mean F": of(fractional, fractional.mean()),
        "max F": of(fractional, fractional.max()),
        "mean Δ [nats]": of(gap, gap.mean()),
        "max Δ [nats]": of(gap, gap.max()),
        "Δ = 0 [%]": of(gap, 100 * (gap <= 0).mean()),
        "time branch and bound / LP and rounding: mean": of(ratio, ratio.mean()),
        "  median": of(ratio, ratio.median()),
        "  at least 1.2 [%]": of(ratio, 100 * (ratio >= 1.2).mean()),
        "  at least 1.5 [%]": of(ratio, 100 * (ratio >= 1.5).mean()),
    }
