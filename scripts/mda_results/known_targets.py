"""Runs over known targets, the scenarios of Battistelli et al. (2008): rows and outings.

Open-loop rows are those of rows.py; outings are the lines of tracking.jsonl (results/README.md).
Either may be absent."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from mda_results.outings import (NAMES, OUTING_KEY, check_names, check_numbers, check_once,
                                 check_shares, check_there, has_lines, open_rows)
from mda_results.rows import RunError, json_lines, load_manifest

PREFIX = "battistelli-"
SCENARIOS = ("battistelli-1", "battistelli-1-dense", "battistelli-1-wide", "battistelli-2",
             "battistelli-2-radial")
RESOLUTIONS = {"battistelli-2-res0.01": 0.01, "battistelli-2": 1.0, "battistelli-2-res2": 2.0,
               "battistelli-2-res4": 4.0}  # of figure 9; factors on 50 m and 1 degree
SCENE_KEY = ["scenario", "scan_period_s", "replicate"]
SERIES = ("position_error_series_m", "ideal_series_m", "oracle_series_m", "right_series")

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
    rows = open_rows(directory, PREFIX, warnings)
    outings = _frame([])
    if has_lines(directory / "tracking.jsonl"):
        outings = _outings(directory / "tracking.jsonl", warnings)
    if rows.empty and outings.empty:
        raise RunError(f"{directory} has no rows and no outings of scenarios {PREFIX}*")
    paths = directory / "trajectories.json"
    return KnownRun(directory.resolve().name, manifest,
                    load_manifest(paths) if paths.is_file() else {}, rows, outings, warnings)


def nominal(frame: pd.DataFrame) -> pd.DataFrame:
    """Rows or outings of SCENARIOS at their own scan period."""
    periods = frame["scenario"].map(nominal_period_s)
    return frame[frame["scenario"].isin(SCENARIOS) & (frame["scan_period_s"] == periods)]


def finished(outings: pd.DataFrame) -> pd.DataFrame:
    """Outings whose every answer stood."""
    return outings[outings["status"] == "finished"]


def _outings(path: Path, warnings: list[str]) -> pd.DataFrame:
    frame = _frame(list(_known_lines(path, warnings)))
    check_once(frame, [*OUTING_KEY, "replicate"], path)
    return frame.sort_values([*OUTING_KEY, "replicate"], ignore_index=True)


def _frame(records: list[dict[str, Any]]) -> pd.DataFrame:
    frame = pd.DataFrame(records).reindex(columns=[*NAMES, *MEASURES, *SERIES])
    frame[MEASURES] = frame[MEASURES].astype(float)
    return frame.assign(group=frame["scenario"], one=1)


def _known_lines(path: Path, warnings: list[str]) -> Iterator[dict[str, Any]]:
    for number, record in enumerate(json_lines(path, warnings), start=1):
        if not is_known(record.get("scenario")):
            continue
        where = f"{path}:{number}"
        check_names(record, where)
        if record["status"] != "skipped":
            _check_measures(record, where)
            for name in SERIES:
                record[name] = np.array(record[name], dtype=float)
        yield record


def _check_measures(record: dict[str, Any], where: str) -> None:
    check_there(record, (*MEASURES, *SERIES), where)
    check_numbers(record, MEASURES, _MAY_BE_NULL, where)
    check_shares(record, _SHARES, where)
    if record["scans"] < 1:
        raise RunError(f"{where}: an outing without scans")
    for name in SERIES:
        series = record[name]
        if not isinstance(series, list) or len(series) != record["scans"]:
            raise RunError(f"{where}: {name} is no list with one entry per scan")
        if any(type(value) not in (int, float) for value in series):
            raise RunError(f"{where}: {name} holds something that is no number")
