"""What became of every row, whether two exact algorithms agree, and what the algorithms cost."""

import numpy as np
import pandas as pd

from mda_results import bootstrap, cells
from mda_results.render import Cell, Column, Table
from mda_results.rows import STATUSES, window_name

AGREEMENT_TOLERANCE = 1e-5  # nats
_SHORTEST_MS = 1e-3  # a shorter time counts as this one in geometric means
_PAIR = ("cbc", "exact")


def tables(rows: pd.DataFrame) -> list[Table]:
    """Counts and times of all algorithms; agreement and time ratio when both of the pair ran."""
    has_pair = set(_PAIR) <= set(rows["algorithm"])
    pairs = _pairs(rows) if has_pair else None
    result = [_row_counts(rows), _agreement(rows, pairs), _times(rows)]
    return result + ([_time_ratio(pairs)] if pairs is not None else [])


def _row_counts(rows: pd.DataFrame) -> Table:
    """Rows per algorithm and status. Missing: windows of the grid replicates x K x scans of each
    group, as far as any algorithm has rows of it, without a row of this one."""
    grid = rows.groupby("group")[["replicate", "window_k", "scan"]].nunique().prod(axis=1).sum()
    columns = [Column("algorithm"), Column("windows"), Column("missing"), Column("rows")]
    columns += [Column(s.replace("_", " "), "of the rows") for s in STATUSES]
    columns += [Column("refuted"), Column("deadline", "stopped by"),
                Column("iteration limit", "stopped by")]
    table_rows: list[list[Cell]] = []
    for algorithm, own in rows.groupby("algorithm"):
        failed = own["status"] == "failed"
        table_rows.append([
            str(algorithm), int(grid), int(grid) - len(own), len(own),
            *(int((own["status"] == s).sum()) for s in STATUSES),
            int((failed & (own["stop"] != "error")).sum()),
            int((own["stop"] == "deadline").sum()), int((own["stop"] == "iteration_limit").sum()),
        ])
    notes = [
        "refuted: of the failed, those whose answer the referee refuted (stop is not `error`).",
        "missing: windows of the grid replicates x K x scans without a row of this algorithm.",
    ]
    return Table("row_counts", "What became of every row", columns, table_rows, notes)


def _pairs(rows: pd.DataFrame) -> pd.DataFrame:
    """The windows that both algorithms of the pair finished with status optimal."""
    key = cells.window_key()
    proven = rows[(rows["status"] == "optimal") & (rows["stop"] == "finished")]
    first, second = (proven[proven["algorithm"] == name] for name in _PAIR)
    return first[[*key, "scenario", "scan_period_s", "columns", "cost_nats", "cpu_ms"]].merge(
        second[[*key, "cost_nats", "cpu_ms"]], on=key, suffixes=("", "_second"))


def _agreement(rows: pd.DataFrame, pairs: pd.DataFrame | None) -> Table:
    columns = [Column("windows"), Column("both optimal"), Column("compared"),
               Column("largest difference [nats]", digits=".2e"), Column("beyond 1e-5 nats")]
    windows = len(rows.drop_duplicates(cells.window_key()))
    title = f"Agreement of {_PAIR[0]} and {_PAIR[1]}"
    if pairs is None:
        absent = " and ".join(n for n in _PAIR if not (rows["algorithm"] == n).any())
        return Table("agreement", title, columns, [[windows, 0, 0, None, 0]],
                     [f"This run has no rows of {absent}: nothing to compare."])
    difference = (pairs["cost_nats"] - pairs["cost_nats_second"]).abs()
    compared = int(difference.notna().sum())
    beyond = pairs[difference > AGREEMENT_TOLERANCE]
    largest = float(difference.max())
    row: list[Cell] = [windows, len(pairs), compared, largest, len(beyond)]
    if compared == 0:
        verdict = "There is no window on which both are optimal."
    elif len(beyond):
        example = window_name(beyond.iloc[0])
        verdict = f"THEY DISAGREE on {len(beyond)} of {compared} windows, first {example}."
    else:
        verdict = (
            f"On all {compared} windows that both finished as optimal the costs agree within 1e-5 "
            f"nats; the largest difference is {largest:.2e}."
        )
    return Table("agreement", title, columns, [row], [verdict])


def _finished(rows: pd.DataFrame) -> pd.DataFrame:
    """The rows that have a time worth telling: an answer that stands, and no limit reached."""
    return rows[cells.answered(rows) & (rows["stop"] == "finished")]


def _by_group(frame: pd.DataFrame) -> list[tuple[str, pd.DataFrame]]:
    """The groups present, A-C before D when A, B and C are."""
    present = [g for g in cells.GROUPS if (frame["group"] == g).any()]
    parts = [(g, frame[frame["group"] == g]) for g in present]
    if {"A", "B", "C"} <= set(present):
        parts.insert(3, ("A-C", frame[frame["group"] != "D"]))
    return parts


def _log_time(ms: pd.Series) -> pd.Series:
    return np.log(ms.clip(lower=_SHORTEST_MS))


def _times(rows: pd.DataFrame) -> Table:
    columns = [Column("algorithm"), Column("group"), Column("windows"), Column("finished"),
               Column("total [s]", "CPU", ".3f"), Column("geo. mean [ms]", "CPU", ".4f"),
               Column("total [s]", "wall", ".3f"), Column("over 1.2 CPU", "wall"),
               Column("LP [s]", "of the wall", ".3f"), Column("rounding [s]", "of the wall", ".3f")]
    table_rows: list[list[Cell]] = []
    for algorithm, own in rows.groupby("algorithm"):
        for group, members in _by_group(own):
            done = _finished(members).dropna(subset=["cpu_ms"])
            sums = (done[["cpu_ms", "wall_ms", "lp_ms", "round_ms"]] / 1000).sum(min_count=1)
            log_mean = _log_time(done.loc[done["columns"] > 0, "cpu_ms"]).mean()
            table_rows.append([
                str(algorithm), group, len(members), len(done),
                float(sums["cpu_ms"]), float(np.exp(log_mean)), float(sums["wall_ms"]),
                int((done["wall_ms"] > 1.2 * done["cpu_ms"]).sum()),
                float(sums["lp_ms"]), float(sums["round_ms"]),
            ])
    notes = [
        "Of rows finished with an answer that stands. Geometric means: windows with columns, times "
        "under 1 µs taken as 1 µs.",
        "All times include building the model of a solver library.",
    ]
    return Table("times", "Time of solve()", columns, table_rows, notes)


def _time_ratio(pairs: pd.DataFrame) -> Table:
    """Geometric mean over windows of time of the first over time of the second."""
    timed = pairs[pairs["columns"] > 0].dropna(subset=["cpu_ms", "cpu_ms_second"])
    timed = timed.assign(
        log_ratio=_log_time(timed["cpu_ms"]) - _log_time(timed["cpu_ms_second"]), one=1)
    columns = [Column("group"), Column("windows"),
               Column("geometric mean", digits=".2f", interval=True),
               Column("ratio of totals", digits=".2f")]
    table_rows: list[list[Cell]] = [
        [group, len(part), bootstrap.ratio(part, "log_ratio", "one", np.exp),
         float(part["cpu_ms"].sum() / part["cpu_ms_second"].sum())]
        for group, part in _by_group(timed)
    ]
    title = f"CPU time {_PAIR[0]} / {_PAIR[1]}, paired per window that both finished as optimal"
    return Table("time_ratio", title, columns, table_rows,
                 ["Windows with columns. Brackets: 95 % bootstrap interval over scenarios."])
