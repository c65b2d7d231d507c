"""What Storms & Spieksma (2003) report of one scenario under one K, from a run and as published.

Both come as a frame with one row per (group, replicate, window_k) and the columns
  windows         windows whose LP was solved and rounded
  fractional      R: those with a fractional LP optimum
  gap_known       fractional windows whose rounding gap is known
  gap_sum         sum of these gaps, nats
  gap_max         Delta: the largest of these gaps, nats; NaN when there is none
  rounded_optimal those with gap 0
  in_zero_cell    R if every gap is known and Delta is 0, else 0
  optimum         O: cost of the optimum after the last scan, nats
  truth           cost of the true tracks after the last scan, nats
A gap within GAP_TOLERANCE counts as 0.
"""

from pathlib import Path

import numpy as np
import pandas as pd

from mda_results.rows import WINDOW_KEY, Run, RunError

GROUPS = ("A", "B", "C", "D")
GAP_TOLERANCE = 1e-5  # nats: what branch and bound may miss
PUBLISHED = Path(__file__).resolve().parents[2] / "results" / "published"

_SCAN_PERIOD_S = 8.0
_SCANS = 30
_CELL = ["group", "replicate", "window_k"]
ROUNDING = "lp-grp"


def rows_of_paper(run: Run) -> pd.DataFrame:
    """The rows of groups A to D at the paper's scan period, with the scenario's name as `group`."""
    rows = run.rows
    chosen = rows["scenario"].isin(GROUPS) & (rows["scan_period_s"] == _SCAN_PERIOD_S)
    rows = rows[chosen].reset_index(drop=True)
    if rows.empty:
        raise RunError(
            f"{run.name} has no rows of scenarios A, B, C or D at a scan period of "
            f"{_SCAN_PERIOD_S:g} s"
        )
    rows = rows.assign(
        group=rows["scenario"].astype(str), algorithm=rows["algorithm"].astype(str)
    )
    if not (rows["algorithm"] == ROUNDING).any():
        others = ", ".join(sorted(rows["algorithm"].unique()))
        raise RunError(
            f"{run.name} has no rows of {ROUNDING}, which the tables need; it has {others}"
        )
    return rows


def left_out(run: Run, rows: pd.DataFrame) -> str | None:
    """A sentence on the rows of the run that are none of the paper's."""
    count = len(run.rows) - len(rows)
    if count == 0:
        return None
    return (
        f"Left out: {count} rows of other scenarios than A to D or of other scan periods than "
        f"{_SCAN_PERIOD_S:g} s."
    )


def answered(rows: pd.DataFrame) -> pd.Series:
    """Which rows hold an answer that stands: neither missing nor refuted."""
    return rows["status"].isin(["optimal", "feasible"])


def without_noise(gap: pd.Series) -> pd.Series:
    """Gaps with those within GAP_TOLERANCE set to 0; unknown ones stay NaN."""
    return gap.where((gap.abs() > GAP_TOLERANCE) | gap.isna(), 0.0)


def window_key() -> list[str]:
    """The columns of rows_of_paper() that name a window."""
    return ["group", *WINDOW_KEY[2:]]


def measured(rows: pd.DataFrame) -> pd.DataFrame:
    """The cells of a run, from its rows of lp-grp."""
    own = rows[rows["algorithm"] == ROUNDING]
    integral = own["integral"].where(answered(own))
    fractional = integral == 0
    gap = without_noise(own["gap_nats"]).where(fractional)
    windows = own.assign(
        windows=integral.notna().astype(int),
        fractional=fractional.astype(int),
        gap_known=gap.notna().astype(int),
        gap_sum=gap.fillna(0.0),
        gap_max=gap,
        rounded_optimal=(gap <= 0).astype(int),
        optimum=own["retired_nats"] + own["reference_cost_nats"],
        truth=own["truth_cost_nats"],
    )
    by_cell = windows.groupby(_CELL, sort=True)
    cells = by_cell.agg(
        {
            "windows": "sum",
            "fractional": "sum",
            "gap_known": "sum",
            "gap_sum": "sum",
            "gap_max": "max",
            "rounded_optimal": "sum",
        }
    )
    last_scan = windows["scan"] == windows.groupby("group")["scan"].transform("max")
    final = windows[last_scan].set_index(_CELL)
    cells["optimum"] = final["optimum"]
    cells["truth"] = final["truth"]
    return _with_zero_cells(cells.reset_index())


def published() -> pd.DataFrame:
    """The cells of the paper's Tables 2 to 5; gaps of single windows are printed for D only."""
    cells = pd.read_csv(PUBLISHED / "storms2003_tables_2_to_5.csv").rename(
        columns={"roundings_r": "fractional", "max_gap_delta": "gap_max", "optimum_o": "optimum"}
    )
    cells["replicate"] = cells["scenario"] - cells["group"].map(number_offset)
    cells["windows"] = _SCANS
    cells["truth"] = np.nan
    gaps = published_windows().groupby("scenario")["gap_delta"]
    cells = cells.set_index("scenario")
    cells["gap_known"] = gaps.size().reindex(cells.index, fill_value=0)
    cells["gap_sum"] = gaps.sum().reindex(cells.index, fill_value=0.0)
    cells["rounded_optimal"] = gaps.agg(lambda g: int((g == 0).sum())).reindex(
        cells.index, fill_value=0
    )
    zero_unknown = _with_zero_cells(cells.assign(gap_known=cells["fractional"]))
    cells["in_zero_cell"] = zero_unknown["in_zero_cell"]
    return cells.reset_index(drop=True)


def published_windows() -> pd.DataFrame:
    """The paper's Tables 6 and 7: the fractional windows of group D."""
    return pd.read_csv(PUBLISHED / "storms2003_tables_6_and_7.csv")


def number_offset(group: str) -> int:
    """What is added to a replicate to give the paper's scenario number."""
    return 10 * GROUPS.index(group)


def _with_zero_cells(cells: pd.DataFrame) -> pd.DataFrame:
    zero = (cells["gap_max"] <= 0) & (cells["gap_known"] == cells["fractional"])
    return cells.assign(in_zero_cell=cells["fractional"].where(zero, 0))
