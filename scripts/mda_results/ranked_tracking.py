"""Closed loop: the order of the algorithms by distance to the truth, over the same scenes."""

from dataclasses import dataclass

import pandas as pd

from mda_results import bootstrap
from mda_results.render import Cell, Column, Table

_GROUP = ["scenario", "scan_period_s", "window_k"]


@dataclass(frozen=True)
class _Measure:
    field: str
    header: str
    digits: str
    scale: float = 1.0
    block: str = ""


# The first one ranks; less is better.
_BORN = (_Measure("gospa_km", "GOSPA [km]", ".3f"), _Measure("ospa_km", "OSPA [km]", ".3f"),
         _Measure("correct_association", "right plots", ".1f", 100.0, "percent"),
         _Measure("completeness", "complete", ".1f", 100.0, "percent"),
         _Measure("track_breaks", "breaks", ".2f", block="per scene"),
         _Measure("swaps", "swaps", ".2f", block="per scene"),
         _Measure("lost", "lost", ".2f", block="per scene"))
_KNOWN = (_Measure("distance_error_m", "distance to the ideal [m]", ".2f"),
          _Measure("position_error_m", "to the truth [m]", ".2f"),
          _Measure("right_share", "right decisions", ".1f", 100.0, "percent"),
          _Measure("lost_ever", "ever lost", ".2f", 100.0, "percent"),
          _Measure("lost_at_end", "lost at the end", ".2f", 100.0, "percent"))


def tables(born: pd.DataFrame, known: pd.DataFrame) -> list[Table]:
    """Of outings as in pool.Pool; one per kind of scenario that has any."""
    found = []
    if not born.empty:
        found.append(_table(born, "tracking_births", "Closed loop, scenarios with births", _BORN))
    if not known.empty:
        found.append(_table(known, "tracking_known", "Closed loop, known targets", _KNOWN))
    return found


def _table(outings: pd.DataFrame, name: str, title: str, measures: tuple[_Measure, ...]) -> Table:
    columns = [Column("scenario", once=True), Column("T [s]", digits="g", once=True),
               Column("K", once=True), Column("place"), Column("algorithm"), Column("n"),
               Column("failed"), Column("skipped"), Column("unanswered windows")]
    columns += [Column(m.header, m.block, m.digits, interval=m is measures[0]) for m in measures]
    columns.append(Column("CPU [ms/scan]", digits=".4f"))
    lines: list[list[Cell]] = []
    for (scenario, period, k), own in outings.groupby(_GROUP, sort=True):
        lines += [[str(scenario), float(period), int(k), *line] for line in _lines(own, measures)]
    notes = [f"Order: {measures[0].header}, over the n scenes that all algorithms with a place or "
             "'out' finished; brackets: 95 % over scenes. out: some outing failed (it threw, or an "
             "answer was refuted). A dash: it finished none, or no scene is shared.",
             "results/README.md says what the measures are. Never to be mixed with the open loop: "
             "here every algorithm drives its own windows."]
    return Table(name, title, columns, lines, notes)


def _lines(own: pd.DataFrame, measures: tuple[_Measure, ...]) -> list[list[Cell]]:
    finished = own[own["status"] == "finished"]
    names = sorted(finished["algorithm"].unique())
    counts = finished.groupby("replicate")["algorithm"].nunique()
    shared = finished[finished["replicate"].isin(counts.index[counts == len(names)])]
    ranked = []
    for name in sorted(own["algorithm"].unique()):
        mine, part = own[own["algorithm"] == name], shared[shared["algorithm"] == name]
        status = mine["status"].value_counts()
        failed = int(status.get("failed", 0))
        line: list[Cell] = [name, len(part), failed, int(status.get("skipped", 0)),
                            int(mine["unanswered"].fillna(0).sum())]
        if part.empty:
            ranked.append(((2, 0.0, name), [None, *line, *[None] * (len(measures) + 1)]))
            continue
        first = bootstrap.ratio(part.assign(one=1), measures[0].field, "one")
        others = [m.scale * float(part[m.field].mean()) for m in measures[1:]]
        cpu = float(part["cpu_ms"].sum() / part["scans"].sum())
        mean = float(part[measures[0].field].mean())
        ranked.append(((int(failed > 0), round(mean, 9), name), [None, *line, first, *others, cpu]))
    ranked.sort(key=lambda entry: entry[0])
    means = [key[1] for key, _ in ranked if key[0] == 0]
    for (kind, mean, _), cells in ranked:
        if kind < 2:
            cells[0] = str(1 + sum(m < mean for m in means)) if kind == 0 else "out"
    return [cells for _, cells in ranked]
