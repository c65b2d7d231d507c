"""Closed loop: how well every algorithm tracks when it drives its own windows."""

from pathlib import Path

import pandas as pd

from mda_results import bootstrap
from mda_results.known_targets import is_known
from mda_results.position_targets import is_position
from mda_results.render import Cell, Column, Estimate, Report, Table
from mda_results.rows import SCHEMA_VERSION, RunError, json_lines, load_manifest

_KEY = ["scenario", "scan_period_s", "window_k", "algorithm"]
_UNIT = ["scenario", "scan_period_s", "window_k", "replicate"]
_REFERENCE = "exact"
_MEASURES = (
    "scans unanswered gospa_km gospa_localisation_km2 gospa_missed_km2 gospa_false_km2 ospa_km "
    "correct_association purity completeness track_breaks swaps lost present tracks targets "
    "cost_nats truth_cost_nats wall_ms cpu_ms"
).split()
_KEY_COLUMNS = [Column("group", once=True), Column("T [s]", digits="g"), Column("K"),
                Column("algorithm")]


def report(directory: Path) -> Report:
    """All tables of a closed-loop run; raises RunError when it is none or is damaged."""
    manifest = load_manifest(directory / "manifest.json")
    lines, warnings = _load(directory / "tracking.jsonl")
    about = [
        f"Closed-loop run {directory.resolve().name}: {len(lines)} outings, "
        f"commit {manifest.get('commit', 'unknown')}.",
        "GOSPA and OSPA: p = 2, c = 1 km, alpha = 2, means over the scans; a track counts once it "
        "has 3 plots. Intervals: 95 % over scenarios.",
        *warnings,
    ]
    finished = lines[lines["status"] == "finished"]
    return Report("Tracking in closed loop", about,
                  [_distances(finished), _association(finished), _paired(finished), _fates(lines)])


def _load(path: Path) -> tuple[pd.DataFrame, list[str]]:
    if not path.is_file():
        raise RunError(f"{path.parent} has no tracking.jsonl: it is no closed-loop run")
    warnings: list[str] = []
    every = list(json_lines(path, warnings))
    if not every:
        raise RunError(f"{path} holds no lines")
    numbered = [(n, r) for n, r in enumerate(every, start=1)
                if _other_tables(r.get("scenario")) is None]
    others = sorted({str(_other_tables(r.get("scenario"))) for r in every} - {"None"})
    if not numbered:
        raise RunError(f"the lines of {path} are of scenarios with tables of their own: "
                       f"tables.py {' and '.join(others)}")
    if others:
        warnings.append(f"Left out: {len(every) - len(numbered)} lines of scenarios with "
                        f"tables of their own (tables.py {' and '.join(others)}).")
    for number, record in numbered:
        absent = [f for f in (*_UNIT, "algorithm", "status") if f not in record]
        absent += [f for f in _MEASURES if record.get("status") == "finished" and f not in record]
        if absent:
            raise RunError(f"{path}:{number}: the line has no field '{absent[0]}'")
        if record.get("schema_version") != SCHEMA_VERSION:
            raise RunError(f"{path}:{number}: its schema version is not {SCHEMA_VERSION}")
    frame = pd.DataFrame([r for _, r in numbered])
    frame = frame.reindex(columns=[*_UNIT, "algorithm", "status", *_MEASURES])
    twice = frame.duplicated([*_UNIT, "algorithm"])
    if twice.any():
        number = numbered[int(twice.to_numpy().argmax())][0]
        raise RunError(f"{path}:{number}: this outing is there twice")
    frame = frame.assign(group=frame["scenario"], one=1)
    return frame.sort_values([*_KEY, "replicate"], ignore_index=True), warnings


def _other_tables(scenario: object) -> str | None:
    """The tables that the lines of a scenario belong to, if not these."""
    if is_known(scenario):
        return "battistelli2008"
    return "lee1998" if is_position(scenario) else None


def _mean(frame: pd.DataFrame, part: str, scale: float = 1.0) -> Estimate | None:
    return bootstrap.ratio(frame, part, "one", lambda x: scale * x)


def _lines(finished: pd.DataFrame) -> list[tuple[list[Cell], pd.DataFrame]]:
    return [([s, float(t), int(k), a], own)
            for (s, t, k, a), own in finished.groupby(_KEY, sort=True)]


def _distances(finished: pd.DataFrame) -> Table:
    columns = [*_KEY_COLUMNS, Column("n"), Column("GOSPA [km]", digits=".3f", interval=True)]
    columns += [Column(h, "parts [km^2]", ".3f") for h in ("localisation", "missed", "false")]
    columns += [Column("OSPA [km]", digits=".3f"),
                Column("cost - V_T [nats]", digits=".1f", interval=True),
                Column("CPU [ms/scan]", digits=".3f")]
    rows: list[list[Cell]] = []
    for key, own in _lines(finished):
        excess = own.assign(excess=own["cost_nats"] - own["truth_cost_nats"])
        rows.append([*key, len(own), _mean(own, "gospa_km"),
                     *(float(own[f"gospa_{part}_km2"].mean())
                       for part in ("localisation", "missed", "false")),
                     float(own["ospa_km"].mean()), _mean(excess, "excess"),
                     float(own["cpu_ms"].sum() / own["scans"].sum())])
    return Table("tracking_distances", "Distance to the truth", columns, rows)


def _association(finished: pd.DataFrame) -> Table:
    columns = [*_KEY_COLUMNS]
    columns += [Column(h, "percent", ".1f", interval=True)
                for h in ("correct association", "purity", "completeness")]
    columns += [Column(h, "per scene", ".2f") for h in ("tracks", "targets", "breaks", "swaps")]
    columns.append(Column("lost [%]", digits=".1f"))
    rows: list[list[Cell]] = []
    for key, own in _lines(finished):
        present = own["present"].sum()
        rows.append([*key, *(_mean(own, m, 100.0)
                             for m in ("correct_association", "purity", "completeness")),
                     *(float(own[m].mean())
                       for m in ("tracks", "targets", "track_breaks", "swaps")),
                     float(100.0 * own["lost"].sum() / present) if present else None])
    notes = ["lost: targets in the coverage in the last scan without a live track of theirs."]
    return Table("tracking_association", "Plots and tracks against their targets", columns, rows,
                 notes)


def _paired(finished: pd.DataFrame) -> Table:
    columns = [*_KEY_COLUMNS, Column("n"),
               Column("GOSPA difference [km]", digits="+.4f", interval=True),
               Column("better"), Column("equal"), Column("worse")]
    reference = finished[finished["algorithm"] == _REFERENCE][[*_UNIT, "gospa_km"]]
    rows: list[list[Cell]] = []
    others = finished[finished["algorithm"] != _REFERENCE]
    pairs = others.merge(reference, on=_UNIT, suffixes=("", "_reference"))
    pairs = pairs.assign(difference=pairs["gospa_km"] - pairs["gospa_km_reference"])
    for key, own in _lines(pairs):
        d = own["difference"]
        rows.append([*key, len(own), _mean(own, "difference"), int((d < -1e-9).sum()),
                     int((d.abs() <= 1e-9).sum()), int((d > 1e-9).sum())])
    notes = [f"The algorithm's GOSPA minus that of {_REFERENCE} on the same scene and K."]
    return Table("tracking_paired", f"Against {_REFERENCE}, scene by scene", columns, rows, notes)


def _fates(lines: pd.DataFrame) -> Table:
    columns = [Column("algorithm"), Column("outings"), Column("finished"), Column("skipped"),
               Column("failed"), Column("windows without an answer")]
    rows: list[list[Cell]] = []
    for algorithm, own in lines.groupby("algorithm"):
        counts = own["status"].value_counts()
        rows.append([str(algorithm), len(own),
                     *(int(counts.get(s, 0)) for s in ("finished", "skipped", "failed")),
                     int(own["unanswered"].sum())])
    return Table("tracking_fates", "What became of every outing", columns, rows)
