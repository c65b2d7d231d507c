"""What the scan period changes: integrality, gaps, columns and time, per group and K."""

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd

from mda_results import bootstrap, cells
from mda_results.known_targets import is_known
from mda_results.position_targets import is_position
from mda_results.render import Cell, Column, Estimate, Report, Table
from mda_results.rows import Run, RunError
from mda_results.three_sensors import is_sensors

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_KEY = ["group", "window_k", "scan_period_s"]
_ROUNDING, _GREEDY, _EXACT = "lp-grp", "greedy", "exact"
# (key of a line, axis label, logarithmic axis)
_PANELS = (
    ("integral", "integral LPs [%]", False),
    ("greedy_gap", "mean gap of greedy [nats]", False),
    ("columns", "mean columns", True),
    ("exact_ms", "mean CPU of exact [ms]", True),
)

Line = dict[str, Estimate | float | int | None]


def report(run: Run) -> Report:
    """The table and the figure; raises RunError when the run has no rows of lp-grp."""
    apart = run.rows["scenario"].map(lambda s: is_known(s) or is_position(s) or is_sensors(s))
    own = run.rows[~apart.astype(bool)]
    rows = own.assign(group=own["scenario"].astype(str), one=1,
                      algorithm=own["algorithm"].astype(str))
    if not (rows["algorithm"] == _ROUNDING).any():
        raise RunError(f"{run.name} has no rows of {_ROUNDING}, which the table needs")
    lines = {key: _line(own) for key, own in rows.groupby(_KEY, sort=True)}
    counted = rows.groupby("group")["replicate"].nunique()
    about = [f"Run {run.name}: seed {rows['seed'].iloc[0]}, scenarios per group: "
             + ", ".join(f"{g} {n}" for g, n in counted.items()) + ".",
             "Births and false alarms stay per scan; only the time step changes. Intervals: 95 % "
             "over scenarios."]
    return Report("Scan periods", about, [_table(lines)],
                  {"scan_periods": lambda: _figure(lines, run.name)})


def _mean(rows: pd.DataFrame, algorithm: str, field: str) -> Estimate | None:
    own = rows[(rows["algorithm"] == algorithm) & cells.answered(rows)].dropna(subset=[field])
    return bootstrap.ratio(own, field, "one")


def _line(own: pd.DataFrame) -> Line:
    lp = own[(own["algorithm"] == _ROUNDING) & own["integral"].notna()]
    return {
        "windows": len(lp),
        "integral": bootstrap.ratio(lp, "integral", "one", lambda x: 100 * x),
        "rounding_gap": _mean(own, _ROUNDING, "gap_nats"),
        "greedy_gap": _mean(own, _GREEDY, "gap_nats"),
        "columns": _mean(own, _ROUNDING, "columns"),
        "rounding_ms": _mean(own, _ROUNDING, "cpu_ms"),
        "exact_ms": _mean(own, _EXACT, "cpu_ms"),
    }


def _table(lines: dict[tuple[str, int, float], Line]) -> Table:
    columns = [Column("group", once=True), Column("K", once=True), Column("T [s]", digits="g"),
               Column("windows"), Column("integral [%]", digits=".1f", interval=True),
               Column("lp-grp", "mean gap [nats]", ".3f", interval=True),
               Column("greedy", "mean gap [nats]", ".2f", interval=True),
               Column("columns", digits=".0f", interval=True),
               Column("lp-grp", "CPU [ms]", ".3f"), Column("exact", "CPU [ms]", ".3f")]
    rows: list[list[Cell]] = []
    for (group, k, period), line in lines.items():
        rows.append([group, str(k), float(period), line["windows"], line["integral"],
                     line["rounding_gap"], line["greedy_gap"], line["columns"],
                     _value(line["rounding_ms"]), _value(line["exact_ms"])])
    notes = ["Gaps above the optimum over all windows, also those with an integral LP."]
    return Table("scan_periods", "By scan period", columns, rows, notes)


def _value(cell: Estimate | float | int | None) -> float | None:
    return cell.value if isinstance(cell, Estimate) else None


def _figure(lines: dict[tuple[str, int, float], Line], name: str) -> "Figure":
    """A row of panels per K, a line per group, bars for the intervals."""
    try:
        import matplotlib
    except ImportError:
        raise RunError("figures need the package python3-matplotlib") from None
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    ks = sorted({k for _, k, _ in lines})
    groups = sorted({g for g, _, _ in lines})
    figure, axes = plt.subplots(len(ks), len(_PANELS), squeeze=False, sharex=True,
                                figsize=(4 * len(_PANELS), 2.8 * len(ks)), layout="constrained")
    for row, k in enumerate(ks):
        for column, (field, label, logarithmic) in enumerate(_PANELS):
            axis = axes[row][column]
            for group in groups:
                _draw(axis, lines, group, k, field)
            if logarithmic:
                axis.set_yscale("log")
            axis.grid(alpha=0.3)
            axis.set_title(f"K = {k}")
            axis.set_ylabel(label)
            if row == len(ks) - 1:
                axis.set_xlabel("scan period [s]")
    handles, labels = axes[0][0].get_legend_handles_labels()
    figure.legend(handles, [f"group {g}" for g in labels], loc="upper right", ncol=len(labels))
    figure.suptitle(f"What the scan period changes ({name}; bars: 95 % over scenarios)\n")
    return figure


def _draw(axis: "Axes", lines: dict[tuple[str, int, float], Line], group: str, k: int,
          field: str) -> None:
    points = [(t, line[field]) for (g, width, t), line in lines.items()
              if g == group and width == k and isinstance(line[field], Estimate)]
    if not points:
        return
    periods = [t for t, _ in points]
    values = np.array([e.value for _, e in points])
    low = np.array([e.low if e.low is not None else e.value for _, e in points])
    high = np.array([e.high if e.high is not None else e.value for _, e in points])
    bars = np.maximum(0.0, [values - low, high - values])
    axis.errorbar(periods, values, yerr=bars, marker="o", capsize=3, label=group)
