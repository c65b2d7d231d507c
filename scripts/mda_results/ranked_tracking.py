"""Closed loop: the order of the algorithms by distance to the truth, over the same scenes."""

import pandas as pd

from mda_results import bootstrap
from mda_results.loops import KINDS, Kind
from mda_results.render import Cell, Column, Table

_GROUP = ["scenario", "scan_period_s", "window_k"]


def tables(outings: pd.DataFrame) -> list[Table]:
    """Of outings as loops.load() gives them; one per kind that has any."""
    return [_table(own, kind) for kind in KINDS
            if not (own := outings[outings["kind"] == kind.name]).empty]


def unknown(outings: pd.DataFrame) -> list[str]:
    """A sentence on the outings that are in no table, if there are any."""
    left = outings[outings["kind"] == ""]
    if left.empty:
        return []
    return [f"{len(left)} outings of {', '.join(sorted(set(left['scenario'])))} have no measure "
            "that is ranked here, or none took place."]


def _table(outings: pd.DataFrame, kind: Kind) -> Table:
    first = kind.measures[0]
    columns = [Column("scenario", once=True), Column("T [s]", digits="g", once=True),
               Column("K", once=True), Column("place"), Column("algorithm"), Column("n"),
               Column("failed"), Column("skipped"), Column("unanswered windows")]
    columns += [Column(m.header, m.block, m.digits, interval=m is first) for m in kind.measures]
    columns.append(Column("CPU [ms/scan]", digits=".4f"))
    lines: list[list[Cell]] = []
    update = outings["update"].map(lambda u: f", {u}" if u else "")
    outings = outings.assign(algorithm=outings["algorithm"] + update)
    for (scenario, period, k), own in outings.groupby(_GROUP, sort=True):
        lines += [[str(scenario), float(period), int(k), *line] for line in _lines(own, kind)]
    notes = [f"Order: {first.header}, less is better, over the n scenes that every algorithm "
             "finished which finished any; brackets: 95 % over scenes. out: some outing failed (it "
             "threw, or an answer was refuted). A dash: it finished none, or no scene is shared.",
             "results/README.md says what the measures are. Not to be mixed with the open loop: "
             "here every algorithm drives its own windows."]
    return Table(kind.name, kind.title, columns, lines, notes)


def _lines(own: pd.DataFrame, kind: Kind) -> list[list[Cell]]:
    finished = own[own["status"] == "finished"]
    scene = ["seed", "replicate"]
    counts = finished.groupby(scene)["algorithm"].transform("nunique")
    shared = finished[counts == finished["algorithm"].nunique()]
    first, ranked = kind.measures[0], []
    for name in sorted(own["algorithm"].unique()):
        mine, part = own[own["algorithm"] == name], shared[shared["algorithm"] == name]
        status = mine["status"].value_counts()
        failed = int(status.get("failed", 0))
        line: list[Cell] = [name, len(part), failed, int(status.get("skipped", 0)),
                            int(mine["unanswered"].fillna(0).sum())]
        if part.empty:
            ranked.append(((2, 0.0, name), [None, *line, *[None] * (len(kind.measures) + 1)]))
            continue
        part = part.assign(group=part["scenario"] + part["seed"].map(" {}".format), one=1)
        line += [bootstrap.ratio(part, first.name, "one"),
                 *(float(part[m.name].mean()) for m in kind.measures[1:]),
                 float(part["cpu_ms"].sum() / part["scans"].sum())]
        mean = round(float(part[first.name].mean()), 9)
        ranked.append(((int(failed > 0), mean, name), [None, *line]))
    ranked.sort(key=lambda entry: entry[0])
    means = [mean for (group, mean, _), _ in ranked if group == 0]
    for (group, mean, _), cells in ranked:
        if group < 2:
            cells[0] = str(1 + sum(m < mean for m in means)) if group == 0 else "out"
    return [cells for _, cells in ranked]
