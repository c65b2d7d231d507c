"""What runs over targets known from the start have in common: their rows in open loop, and the
checks of their lines in tracking.jsonl."""

from collections.abc import Collection, Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from mda_results.rows import COLUMNS, SCHEMA_VERSION, RunError, load_run

OUTING_KEY = ["scenario", "scan_period_s", "window_k", "algorithm"]
STATUSES = ("finished", "failed", "skipped")
NAMES = {"scenario": str, "algorithm": str, "status": str, "note": str, "schema_version": int,
         "replicate": int, "window_k": int, "scan_period_s": float}


def has_lines(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > 0


def open_rows(directory: Path, prefix: str, warnings: list[str]) -> pd.DataFrame:
    """Those of scenarios whose names begin with `prefix`; no lines if the run has none. With, for
    bootstrap.ratio(), the scenario as `group` and 1 as `one`."""
    if not has_lines(directory / "rows.jsonl"):
        return pd.DataFrame(columns=[*COLUMNS, "group", "one"])
    run = load_run(directory)
    warnings += run.warnings
    rows = run.rows[run.rows["scenario"].astype(str).str.startswith(prefix)]
    names = rows["scenario"].astype(str)
    return rows.assign(scenario=names, algorithm=rows["algorithm"].astype(str), group=names,
                       one=1).reset_index(drop=True)


def check_names(record: dict[str, Any], where: str) -> None:
    """That a line says which outing it is and what became of it; raises RunError."""
    for name, kind in NAMES.items():
        if name not in record:
            raise RunError(f"{where}: the line has no field '{name}'")
        value = record[name]
        allowed = (int, float) if kind is float else (kind,)
        if type(value) not in allowed:
            raise RunError(f"{where}: {name} is not of type {kind.__name__}")
    if record["schema_version"] != SCHEMA_VERSION:
        raise RunError(f"{where}: its schema version is not {SCHEMA_VERSION}")
    if record["status"] not in STATUSES:
        raise RunError(f"{where}: unknown status: {record['status']}")


def check_there(record: dict[str, Any], names: Iterable[str], where: str) -> None:
    for name in names:
        if name not in record:
            raise RunError(f"{where}: the line has no field '{name}'")


def check_numbers(record: dict[str, Any], names: Iterable[str], may_be_null: Collection[str],
                  where: str) -> None:
    for name in names:
        value = record[name]
        if type(value) not in (int, float) and not (value is None and name in may_be_null):
            raise RunError(f"{where}: {name} is no number")


def check_shares(record: dict[str, Any], names: Iterable[str], where: str) -> None:
    for name in names:
        if not 0 <= record[name] <= 1:
            raise RunError(f"{where}: {name} is no share")


def check_once(frame: pd.DataFrame, key: list[str], where: object) -> None:
    """That no two lines agree in `key`, which holds that of an outing; raises RunError."""
    twice = frame.duplicated(key)
    if twice.any():
        line = frame[twice].iloc[0]
        raise RunError(f"{where} has two outings of {line['algorithm']} on {line['scenario']}, "
                       f"replicate {line['replicate']}, K = {line['window_k']}")


def true_paths_km(trajectories: dict[str, Any], scenario: str, run: str) -> list[np.ndarray] | None:
    """Per target its true positions, (scans, 2), from the trajectories.json of a run; None if it
    does not tell them."""
    if scenario not in trajectories:
        return None
    try:
        paths = [np.array(path, dtype=float) for path in trajectories[scenario]["targets"]]
    except (TypeError, KeyError, ValueError):
        paths = []
    if not paths or any(path.ndim != 2 or path.shape[1] != 2 for path in paths):
        raise RunError(f"the trajectories.json of {run} has paths of {scenario} that are no "
                       "lists of pairs")
    return paths
