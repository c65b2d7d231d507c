"""Open loop over known targets: gaps, bounds, integrality, graphs and times per scenario and K."""

import pandas as pd

from mda_results import bootstrap, cells
from mda_results.known_targets import SCENARIOS, nominal, target_count
from mda_results.render import Cell, Column, Estimate, Table
from mda_results.rows import WINDOW_KEY

_RELATIVE_TOLERANCE = 1e-9  # of the cost: what the last digits may hold


def tables(rows: pd.DataFrame) -> list[Table]:
    """A table of gaps per scenario, the sizes, and what became of every row."""
    own = nominal(rows)
    present = [s for s in SCENARIOS if (own["scenario"] == s).any()]
    return [*(_gaps(s, own[own["scenario"] == s]) for s in present), _sizes(own), _fates(own)]


def is_optimal(rows: pd.DataFrame) -> pd.Series:
    """Which rows answer with a cost that is the reference's; unknown gaps count as not."""
    return rows["gap_nats"] <= cells.GAP_TOLERANCE + _RELATIVE_TOLERANCE * rows["cost_nats"].abs()


def mean_gap(own: pd.DataFrame) -> Estimate | None:
    """Over the answered windows whose gap is known; interval over scenes."""
    return bootstrap.ratio(own[cells.answered(own)].dropna(subset=["gap_nats"]), "gap_nats", "one")


def graph_sizes(rows: pd.DataFrame, family: str) -> pd.DataFrame:
    """One line per window: columns, the graph of `family`, and the paper's bounds on that of SCF.

    `family`: "scf", or "mcf" for one graph per track, taken together. Nodes and arcs are NaN where
    no algorithm of the family has told them. Columns scenario, window_k, plots (M, per scan),
    targets (T), columns, nodes, arcs, node_bound = (M + T) S, arc_bound = (M + T)^2 S and, exactly,
    most_nodes with the sources and the sink. The first windows of a scene hold fewer scans than K.
    """
    of_family = rows["algorithm"].str.startswith(family)
    graphs = rows[["graph_nodes", "graph_arcs"]].where(of_family)
    ordered = rows.assign(**graphs).sort_values([*WINDOW_KEY, "algorithm"])
    known = ordered["graph_nodes"].notna()
    own = pd.concat([ordered[known], ordered[~known]]).drop_duplicates(WINDOW_KEY)
    scans = own[["scan", "window_k"]].min(axis=1)
    targets = own["scenario"].map(target_count)
    plots = (own["rows"] - targets) / scans
    return pd.DataFrame({
        "scenario": own["scenario"], "window_k": own["window_k"], "plots": plots,
        "targets": targets, "columns": own["columns"], "nodes": own["graph_nodes"],
        "arcs": own["graph_arcs"], "node_bound": (plots + targets) * scans,
        "arc_bound": (plots + targets) ** 2 * scans,
        "most_nodes": (plots + targets) * scans + targets + 1,
        "every_sequence": targets * (plots + 1) ** scans,
    })


def _gaps(scenario: str, own: pd.DataFrame) -> Table:
    columns = [Column("K", once=True), Column("algorithm"), Column("n"),
               Column("mean gap [nats]", digits=".4f", interval=True),
               Column("optimal", "percent", ".1f"), Column("LP int.", "percent", ".1f"),
               Column("certified", "percent", ".1f"), Column("worst", "gap", ".2f"),
               Column("certified", "gap", ".3f"), Column("off col.", digits=".3f"),
               Column("solve", "CPU [ms]", ".3f"), Column("views", "CPU [ms]", ".3f"),
               Column("skip"), Column("fail")]
    rows = [[str(k), str(a), *_gap_cells(part)]
            for (k, a), part in own.groupby(["window_k", "algorithm"], sort=True)]
    notes = []
    if scenario == SCENARIOS[0]:
        notes = [
            "n: answered windows. Gap: cost minus reference, interval over scenes. optimal: gap at "
            "most 1e-5 nats + 1e-9 |cost|. LP int.: windows in which the algorithm's own LP is "
            "integral. certified: answers with a bound recomputed from multipliers, and their mean "
            "cost above it. off col.: paths per window that are no column. CPU: means over "
            "answered windows; solve holds the making of the graph, views that of tree and graph. "
            "fail: also without an answer.",
        ]
    return Table(f"open_{scenario}", f"Open loop, {scenario}", columns, rows, notes)


def _gap_cells(own: pd.DataFrame) -> list[Cell]:
    good = own[cells.answered(own)]
    with_gap = good.dropna(subset=["gap_nats"])
    bounds = good["certified_bound_nats"]
    skipped = int((own["status"] == "skipped").sum())
    certified = 100.0 * float(bounds.notna().mean()) if len(good) else None
    return [len(good), mean_gap(own),
            100.0 * float(is_optimal(with_gap).mean()) if len(with_gap) else None,
            100.0 * float(good["integral"].mean()), certified, float(with_gap["gap_nats"].max()),
            float((good["cost_nats"] - bounds).mean()), float(good["off_column_paths"].mean()),
            float(good["cpu_ms"].mean()), float(good["views_ms"].mean()), skipped,
            len(own) - len(good) - skipped]


def _sizes(own: pd.DataFrame) -> Table:
    columns = [Column("scenario", once=True), Column("K"), Column("windows"), Column("T"),
               Column("M", digits=".1f"), Column("nodes", "SCF", ".1f"),
               Column("(M+T)K", "SCF", ".1f"), Column("arcs", "SCF", ".1f"),
               Column("(M+T)^2 K", "SCF", ".0f"), Column("nodes", "MCF", ".1f"),
               Column("arcs", "MCF", ".1f"),
               Column("mean", "columns", ".1f"), Column("max", "columns"),
               Column("T (M+1)^K", "columns", ".2g")]
    rows: list[list[Cell]] = []
    key = ["scenario", "window_k"]
    multi = graph_sizes(own, "mcf").groupby(key)[["nodes", "arcs"]].mean()
    for (scenario, k), part in graph_sizes(own, "scf").groupby(key, sort=True):
        rows.append([scenario, int(k), len(part), int(part["targets"].iloc[0]),
                     *(float(part[n].mean()) for n in ("plots", "nodes", "node_bound", "arcs",
                                                       "arc_bound")),
                     *map(float, multi.loc[(scenario, k)]), float(part["columns"].mean()),
                     int(part["columns"].max()), float(part["every_sequence"].mean())])
    notes = ["Gated layered graphs before nodes are split; the paper's count, (M+T)K, leaves out "
             "the T sources and the sink; MCF: those of all tracks together. M: mean plots per "
             "scan. Means over windows, the first ones of a scene hold fewer scans than K."]
    return Table("open_sizes", "Sizes of graphs and windows", columns, rows, notes)


def _fates(own: pd.DataFrame) -> Table:
    columns = [Column("algorithm", once=True), Column("what"), Column("rows"), Column("K"),
               Column("scenarios"), Column("reason of the first")]
    rows: list[list[Cell]] = []
    bad = own[~cells.answered(own)]
    for (algorithm, status), part in bad.groupby(["algorithm", "status"], sort=True, observed=True):
        ks = " ".join(map(str, sorted(part["window_k"].unique())))
        shown = " ".join(s.removeprefix("battistelli-") for s in sorted(part["scenario"].unique()))
        first = part.sort_values(WINDOW_KEY)["note"].iloc[0]
        rows.append([algorithm, str(status), len(part), ks, shown, str(first)[:60] or None])
    return Table("open_fates", "Rows without an answer that stands", columns, rows,
                 [] if rows else ["None."])
