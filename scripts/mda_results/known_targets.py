"""Runs over known targets, the scenarios of Battistelli et al. (2008): rows and outings.

Open-loop rows are those of rows.py; outings are the lines of tracking.jsonl (results/README.md).
Either may be absent."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from mda_results.rows import (COLUMNS, SCHEMA_VERSION, RunError, json_lines, load_manifest,
                              load_run)

PREFIX = "battistelli-"
SCENARIOS = ("battistelli-1", "battistelli-1-dense", "battistelli-1-wide", "battistelli-2",
             "battistelli-2-radial")
RESOLUTIONS = {"battistelli-2-res0.01": 0.01, "battistelli-2": 1.0, "battistelli-2-res2": 2.0,
               "battistelli-2-res4": 4.0}  # of figure 9; factors on 50 m and 1 degree
OUTING_KEY = ["scenario", "scan_period_s", "window_k", "algorithm"]
SCENE_KEY = ["scenario", "scan_period_s", "replicate"]
SERIES = ("position_error_series_m", "ideal_series_m", "oracle_series_m", "right_series")

_STATUSES = ("finished", "failed", "skipped")
_NAMES = {"scenario": str, "algorithm": str, "status": str, "note": str, "schema_version": int,
          "replicate": int, "window_k": int, "scan_period_s": float}
MEASURES = (
    "scans targets unanswered off_column_paths position_error_m position_error_lagged_m "
    "ideal_error_m oracle_error_m distance_error_m distance_error_oracle_m lost_ever lost_at_end "
    "right_share right_share_fixed cpu_ms wall_ms hypotheses_cpu_ms"
).split()
_SHARES = ("lost_ever", "lost_at_end", "right_share", "right_share_fixed")
_MAY_BE_NULL = ("position_error_lagged_m",)  # a scene of fewer scans than the window


@dataclass(frozen=True)
class KnownRun:
    """A loaded run; what it does not have is a frame without lines. Both frames have, for
    bootstrap.ratio(), the scenario as `group` and 1 as `one`."""

    name: str  # of its directory
    manifest: dict[str, Any]
    trajectories: dict[str, Any]  # what trajectories.json holds; empty without that file
    rows: pd.DataFrame  # open loop, one per (window, algorithm)
    outings: pd.DataFrame  # closed loop, one per (scene, K, algorithm); series as arrays
    warnings: list[str]


def is_known(scenario: object) -> bool:
    """Whether a scenario is one of this study."""
    return isinstance(scenario, str) and scenario.startswith(PREFIX)


def nominal_period_s(scenario: str) -> float:
    """The sampling time that section IV gives."""
    return 5.0 if scenario.startswith(PREFIX + "1") else 2.0


def target_count(scenario: str) -> int:
    """T of section IV."""
    return 20 if scenario.startswith(PREFIX + "1") else 3


def load(directory: Path) -> KnownRun:
    """The run in `directory`. Raises RunError if it is damaged or has nothing of the study; a torn
    last line is left out with a warning."""
    if not directory.is_dir():
        raise RunError(f"there is no run directory {directory}")
    manifest = load_manifest(directory / "manifest.json")
    warnings: list[str] = []
    rows = pd.DataFrame(columns=[*COLUMNS, "group", "one"])
    outings = _frame([])
    if _has_lines(directory / "rows.jsonl"):
        run = load_run(directory)
        rows = run.rows[run.rows["scenario"].astype(str).str.startswith(PREFIX)]
        rows = rows.assign(scenario=rows["scenario"].astype(str), one=1,
                           algorithm=rows["algorithm"].astype(str), group=rows["scenario"])
        warnings += run.warnings
    if _has_lines(directory / "tracking.jsonl"):
        outings = _outings(directory / "tracking.jsonl", warnings)
    if rows.empty and outings.empty:
        raise RunError(f"{directory} has no rows and no outings of scenarios {PREFIX}*")
    paths = directory / "trajectories.json"
    return KnownRun(directory.resolve().name, manifest,
                    load_manifest(paths) if paths.is_file() else {}, rows.reset_index(drop=True),
                    outings, warnings)


def nominal(frame: pd.DataFrame) -> pd.DataFrame:
    """Rows or outings of SCENARIOS at their own scan period."""
    periods = frame["scenario"].map(nominal_period_s)
    return frame[frame["scenario"].isin(SCENARIOS) & (frame["scan_period_s"] == periods)]


def finished(outings: pd.DataFrame) -> pd.DataFrame:
    """Outings whose every answer stood."""
    return outings[outings["status"] == "finished"]


def trajectories_km(run: KnownRun, scenario: str) -> list[np.ndarray] | None:
    """Per target its true positions, (scans, 2); None if the run does not tell them."""
    if scenario not in run.trajectories:
        return None
    try:
        paths = [np.array(path, dtype=float) for path in run.trajectories[scenario]["targets"]]
    except (TypeError, KeyError, ValueError):
        paths = []
    if not paths or any(path.ndim != 2 or path.shape[1] != 2 for path in paths):
        raise RunError(f"the trajectories.json of {run.name} has paths of {scenario} that are no "
                       "lists of pairs")
    return paths


def _has_lines(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > 0


def _outings(path: Path, warnings: list[str]) -> pd.DataFrame:
    frame = _frame(list(_known_lines(path, warnings)))
    twice = frame.duplicated([*OUTING_KEY, "replicate"])
    if twice.any():
        line = frame[twice].iloc[0]
        raise RunError(f"{path} has two outings of {line['algorithm']} on {line['scenario']}, "
                       f"replicate {line['replicate']}, K = {line['window_k']}")
    return frame.sort_values([*OUTING_KEY, "replicate"], ignore_index=True)


def _frame(records: list[dict[str, Any]]) -> pd.DataFrame:
    frame = pd.DataFrame(records).reindex(columns=[*_NAMES, *MEASURES, *SERIES])
    frame[MEASURES] = frame[MEASURES].astype(float)
    return frame.assign(group=frame["scenario"], one=1)


def _known_lines(path: Path, warnings: list[str]) -> Iterator[dict[str, Any]]:
    for number, record in enumerate(json_lines(path, warnings), start=1):
        if not is_known(record.get("scenario")):
            continue
        where = f"{path}:{number}"
        _check_names(record, where)
        if record["status"] != "skipped":
            _check_measures(record, where)
            for name in SERIES:
                record[name] = np.array(record[name], dtype=float)
        yield record


def _check_names(record: dict[str, Any], where: str) -> None:
    for name, kind in _NAMES.items():
        if name not in record:
            raise RunError(f"{where}: the line has no field '{name}'")
        value = record[name]
        allowed = (int, float) if kind is float else (kind,)
        if type(value) not in allowed:
            raise RunError(f"{where}: {name} is not of type {kind.__name__}")
    if record["schema_version"] != SCHEMA_VERSION:
        raise RunError(f"{where}: its schema version is not {SCHEMA_VERSION}")
    if record["status"] not in _STATUSES:
        raise RunError(f"{where}: unknown status: {record['status']}")


def _check_measures(record: dict[str, Any], where: str) -> None:
    for name in (*MEASURES, *SERIES):
        if name not in record:
            raise RunError(f"{where}: the line has no field '{name}'")
    for name in MEASURES:
        value = record[name]
        if type(value) not in (int, float) and not (value is None and name in _MAY_BE_NULL):
            raise RunError(f"{where}: {name} is no number")
    for name in _SHARES:
        if not 0 <= record[name] <= 1:
            raise RunError(f"{where}: {name} is no share")
    if record["scans"] < 1:
        raise RunError(f"{where}: an outing without scans")
    for name in SERIES:
        series = record[name]
        if not isinstance(series, list) or len(series) != record["scans"]:
            raise RunError(f"{where}: {name} is no list with one entry per scan")
        if any(type(value) not in (int, float) for value in series):
            raise RunError(f"{where}: {name} holds something that is no number")
