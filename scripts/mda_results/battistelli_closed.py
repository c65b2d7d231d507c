"""Closed loop over known targets: equations (IV.2) and (IV.3), right plots and lost tracks."""

import pandas as pd

from mda_results import bootstrap
from mda_results.known_targets import RESOLUTIONS, SCENE_KEY, finished, nominal
from mda_results.outings import OUTING_KEY
from mda_results.render import Cell, Column, Estimate, Table

REFERENCE = "sd-exact"
WINDOW_K = 3  # of the comparison; the paper does not print its S
_KEY_COLUMNS = [Column("scenario", once=True), Column("algorithm"), Column("K")]
_RULE = ("d: mean distance to the truth, lagged: of the state before the window; ideal: exact "
         "association and P_d = 1; oracle: real plots, exact association. DE: distance to the "
         "ideal's and the oracle's estimate.")


def tables(outings: pd.DataFrame) -> list[Table]:
    """Part (b), the sweep over K, and what became of every outing."""
    own = compared(outings)
    return [_positions(own), _association(own), _paired(own), _sweep(outings), _fates(outings)]


def compared(outings: pd.DataFrame) -> pd.DataFrame:
    """Finished outings at the nominal scan period and K = 3; for an algorithm without those on a
    scenario, such as those of one scan, the ones of its widest window."""
    own = finished(nominal(outings))
    by_entry = own.groupby(["scenario", "algorithm"])["window_k"]
    has_k = by_entry.transform(lambda k: (k == WINDOW_K).any()).astype(bool)
    widest = own["window_k"] == by_entry.transform("max")
    return own[(own["window_k"] == WINDOW_K) | (~has_k & widest)].reset_index(drop=True)


def mean(frame: pd.DataFrame, field: str, scale: float = 1.0) -> Estimate | None:
    """Over outings, with its interval over scenes."""
    return bootstrap.ratio(frame, field, "one", lambda x: scale * x)


def paired(own: pd.DataFrame, reference: pd.DataFrame, fields: list[str]) -> pd.DataFrame:
    """The lines of `own` with a line of `reference` on the same scene, and per field the column
    `<field>_difference`, own minus reference, and `<field>_reference`."""
    pairs = own.merge(reference[[*SCENE_KEY, *fields]], on=SCENE_KEY,
                      suffixes=("", "_reference"))
    return pairs.assign(**{f"{f}_difference": pairs[f] - pairs[f"{f}_reference"] for f in fields})


def resolution_table(outings: pd.DataFrame) -> Table:
    """Part (c), figure 9: distance error and lost tracks by scan period and resolution."""
    own = of_figure_9(outings)
    columns = [Column("algorithm", once=True), Column("resolution", digits="g"),
               Column("T [s]", digits="g"), Column("n"),
               Column("DE [m]", digits=".1f", interval=True)]
    columns += [Column(h, "lost tracks [%]", ".1f", interval=True) for h in ("ever", "at end")]
    columns += [Column("d [m]", digits=".1f"), Column("ideal d [m]", digits=".1f"),
                Column("L [%]", digits=".1f")]
    rows: list[list[Cell]] = []
    key = ["algorithm", "resolution", "scan_period_s"]
    for (algorithm, factor, period), part in own.groupby(key, sort=True):
        rows.append([algorithm, float(factor), float(period), len(part),
                     mean(part, "distance_error_m"), mean(part, "lost_ever", 100.0),
                     mean(part, "lost_at_end", 100.0), float(part["position_error_m"].mean()),
                     float(part["ideal_error_m"].mean()),
                     100.0 * float(part["right_share"].mean())])
    notes = [f"K = {WINDOW_K}. Resolution: factor on 50 m and 1 degree. A track is lost while it "
             "is more than 300 m from the ideal one: in any scan, or in the last."]
    return Table("figure_9", "Figure 9: scan period and resolution, scenario battistelli-2",
                 columns, rows, notes)


def of_figure_9(outings: pd.DataFrame) -> pd.DataFrame:
    """Finished outings of its scenarios at K = 3, with the column `resolution`."""
    own = finished(outings)
    own = own[own["scenario"].isin(RESOLUTIONS) & (own["window_k"] == WINDOW_K)]
    return own.assign(resolution=own["scenario"].map(RESOLUTIONS).astype(float))


def _lines(own: pd.DataFrame) -> list[tuple[list[Cell], pd.DataFrame]]:
    return [([s, a, str(k)], part) for (s, a, k), part
            in own.groupby(["scenario", "algorithm", "window_k"], sort=True)]


def _positions(own: pd.DataFrame) -> Table:
    columns = [*_KEY_COLUMNS, Column("n"), Column("d [m]", digits=".1f", interval=True),
               *(Column(h, "d [m]", ".1f") for h in ("lagged", "ideal", "oracle")),
               Column("ideal", "DE [m] from", ".1f", interval=True),
               Column("oracle", "DE [m] from", ".1f")]
    rows: list[list[Cell]] = [
        [*key, len(part), mean(part, "position_error_m"),
         *(float(part[f].mean())
           for f in ("position_error_lagged_m", "ideal_error_m", "oracle_error_m")),
         mean(part, "distance_error_m"), float(part["distance_error_oracle_m"].mean())]
        for key, part in _lines(own)]
    return Table("closed_positions", f"Closed loop, K = {WINDOW_K}: position errors", columns, rows,
                 [_RULE + " Intervals: 95 % over runs."])


def _association(own: pd.DataFrame) -> Table:
    columns = [*_KEY_COLUMNS, Column("newest", "L [%]", ".2f", interval=True),
               Column("fixed", "L [%]", ".2f")]
    columns += [Column(h, "lost tracks [%]", ".1f", interval=True) for h in ("ever", "at end")]
    columns += [Column("solve", "CPU [ms/scan]", ".3f"), Column("hyp.", "CPU [ms/scan]", ".3f")]
    rows: list[list[Cell]] = []
    for key, part in _lines(own):
        scans = part["scans"].sum()
        rows.append([*key, mean(part, "right_share", 100.0),
                     100.0 * float(part["right_share_fixed"].mean()),
                     mean(part, "lost_ever", 100.0), mean(part, "lost_at_end", 100.0),
                     *(float(part[f].sum() / scans) for f in ("cpu_ms", "hypotheses_cpu_ms"))])
    notes = ["L: share of right decisions on the newest scan; fixed: when they leave the window. "
             "Lost: more than 300 m from the ideal track in any scan, or in the last."]
    return Table("closed_association", f"Closed loop, K = {WINDOW_K}: right plots, losses, time",
                 columns, rows, notes)


def _paired(own: pd.DataFrame) -> Table:
    columns = [*_KEY_COLUMNS, Column("n"), Column("d [m]", "difference", "+.1f", interval=True),
               Column("DE [m]", "difference", "+.1f", interval=True),
               Column("L [points]", "difference", "+.2f", interval=True),
               Column("lost at end [points]", "difference", "+.1f", interval=True)]
    fields = ["position_error_m", "distance_error_m", "right_share", "lost_at_end"]
    is_reference = own["algorithm"] == REFERENCE
    pairs = paired(own[~is_reference], own[is_reference], fields)
    rows: list[list[Cell]] = [
        [*key, len(part), *(mean(part, f"{f}_difference", 1.0 if f.endswith("_m") else 100.0)
                            for f in fields)] for key, part in _lines(pairs)]
    return Table("closed_paired", f"Against {REFERENCE} on the same runs", columns, rows,
                 [f"The algorithm's value minus that of {REFERENCE} at K = {WINDOW_K}."])


def _sweep(outings: pd.DataFrame) -> Table:
    columns = [*_KEY_COLUMNS, Column("n"), Column("d [m]", digits=".1f", interval=True),
               Column("d - d(K=1) [m]", digits="+.1f", interval=True),
               Column("DE [m]", digits=".1f"), Column("L [%]", digits=".2f"),
               Column("lost at end [%]", digits=".1f"), Column("CPU [ms/scan]", digits=".3f")]
    rows: list[list[Cell]] = []
    own = finished(nominal(outings))
    own = own[own.groupby(["scenario", "algorithm"])["window_k"].transform("nunique") > 1]
    for key, part in _lines(own):
        single = own[(own["window_k"] == 1) & (own["algorithm"] == key[1])]
        pairs = paired(part, single, ["position_error_m"])
        gain = mean(pairs, "position_error_m_difference") if len(pairs) else None
        rows.append([*key, len(part), mean(part, "position_error_m"), gain,
                     float(part["distance_error_m"].mean()),
                     100.0 * float(part["right_share"].mean()),
                     100.0 * float(part["lost_at_end"].mean()),
                     float(part["cpu_ms"].sum() / part["scans"].sum())])
    return Table("closed_windows", "Closed loop by window width", columns, rows,
                 ["Algorithms that ran with several K."])


def _fates(outings: pd.DataFrame) -> Table:
    columns = [Column("algorithm"), Column("outings"), Column("finished"), Column("skipped"),
               Column("failed"), Column("windows without an answer"), Column("off-column paths"),
               Column("note of the first skipped or failed")]
    rows: list[list[Cell]] = []
    for algorithm, own in outings.groupby("algorithm"):
        counts = own["status"].value_counts()
        bad = own[own["status"] != "finished"].sort_values([*OUTING_KEY, "replicate"])
        rows.append([str(algorithm), len(own),
                     *(int(counts.get(s, 0)) for s in ("finished", "skipped", "failed")),
                     int(own["unanswered"].sum()), int(own["off_column_paths"].sum()),
                     str(bad["note"].iloc[0])[:60] if len(bad) else None])
    return Table("closed_fates", "What became of every outing", columns, rows,
                 ["Only finished outings enter the tables above."])
