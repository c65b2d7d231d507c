"""Several runs as one: the rows and outings of all, without anything that would be compared
unfairly."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from mda_results import known_targets, loops
from mda_results.rows import (WINDOW_KEY, RunError, check_torn, load_manifest, load_run,
                              window_name)

KEY = [*WINDOW_KEY, "seed"]  # of a window in a pool
_NAMES = ("scenario", "fingerprint", "algorithm", "answer", "status", "stop", "note")
_NO_MODEL = ("scan_period_s", "scans", "update")  # told by row, or no matter of its problems
_MACHINE = ("cpu", "compiler", "flags", "libraries", "workers")


@dataclass(frozen=True)
class Pool:
    """What was loaded. Frames without lines are empty.

    rows: those of rows.py sorted by KEY and algorithm, with
      run         name of its directory
      time_ms     CPU time of solving and of the views asked for
      penalty_ms  twice the time limit: what a window without a result costs (PAR-2)
      targets     true ones in the window's scene up to its newest scan: as many as are known, or
                  as many births as expected; NaN if the manifest does not tell
    """

    names: list[str]
    rows: pd.DataFrame
    outings: pd.DataFrame  # closed loops, as loops.load()
    about: list[str]  # what a reader must know of the runs
    warnings: list[str]


def load(directories: Sequence[Path]) -> Pool:
    """The runs in `directories`. Raises RunError if one is damaged or has nothing to rank, if a row
    is there twice, or if two runs have different problems under one name. A torn last line is left
    out with a warning if the run did not finish."""
    parts = [_load_one(directory) for directory in sorted(directories)]
    _check_models(directories)
    rows = _together([p.rows for p in parts])
    rows = rows.sort_values([*KEY, "algorithm", "run"], ignore_index=True)
    _check(rows)
    outings = _together([p.outings for p in parts])
    twice = outings.duplicated(loops.OUTING)
    if twice.any():
        raise RunError(f"the runs have two outings of {outings[twice].iloc[0]['algorithm']} on one "
                       "scene: rank such runs apart")
    return Pool([n for p in parts for n in p.names], rows, outings,
                [line for p in parts for line in p.about] + _machines(directories),
                [w for p in parts for w in p.warnings])


def _together(frames: list[pd.DataFrame]) -> pd.DataFrame:
    """One below the other; empty ones would change the types of columns."""
    return pd.concat([f for f in frames if len(f)] or frames[:1], ignore_index=True)


def _load_one(directory: Path) -> Pool:
    has_rows, has_outings = (_has_lines(directory / f"{n}.jsonl") for n in ("rows", "tracking"))
    if has_rows or not has_outings:
        run = load_run(directory)
        manifest, rows, warnings = run.manifest, run.rows, list(run.warnings)
    else:
        manifest, rows, warnings = load_manifest(directory / "manifest.json"), None, []
    name = directory.resolve().name
    outings = pd.DataFrame(columns=loops.COLUMNS)
    if has_outings:
        outings = loops.load(directory / "tracking.jsonl", warnings)
        if rows is None and outings.empty:
            raise RunError(f"{directory} holds no rows and no outings")
    check_torn(directory, warnings)
    about = [_told(name, manifest, rows, len(outings))]
    ready = _prepared(rows, name, manifest, directory) if rows is not None else pd.DataFrame(
        columns=list(dict.fromkeys([*KEY, *_NAMES, "run"])))
    return Pool([name], ready, outings, about, warnings)


def _has_lines(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > 0


def _prepared(rows: pd.DataFrame, name: str, manifest: dict[str, Any],
              directory: Path) -> pd.DataFrame:
    limit_s = time_limit_s(manifest)
    time_ms = rows["cpu_ms"] + rows["views_ms"].fillna(0.0)
    penalty = 2000.0 * limit_s if limit_s is not None else 2.0 * float(time_ms.max())
    words = {n: rows[n].astype(str) for n in _NAMES}
    return rows.assign(run=name, time_ms=time_ms, penalty_ms=penalty,
                       targets=_targets(rows, manifest, directory), **words)


def time_limit_s(manifest: dict[str, Any]) -> float | None:
    """Wall seconds per solve, of a run; None if its manifest does not tell."""
    sweep = manifest.get("sweep")
    limit = sweep.get("time_limit_s") if isinstance(sweep, dict) else None
    return float(limit) if isinstance(limit, (int, float)) and limit > 0 else None


def _targets(rows: pd.DataFrame, manifest: dict[str, Any], directory: Path) -> np.ndarray:
    path = directory / "trajectories.json"
    paths = load_manifest(path) if path.is_file() else {}
    result = np.full(len(rows), np.nan)
    for scenario in rows["scenario"].unique():
        own = (rows["scenario"] == scenario).to_numpy()
        spec = manifest.get("scenarios", {}).get(scenario, {})
        if isinstance(paths.get(scenario), dict):
            result[own] = len(paths[scenario].get("targets", []))
        elif known_targets.is_known(scenario):
            result[own] = known_targets.target_count(scenario)
        elif isinstance(spec.get("three_sensors"), dict):
            result[own] = spec["three_sensors"].get("targets", np.nan)
        elif isinstance(spec.get("births_per_scan"), (int, float)):
            result[own] = (spec.get("initial_targets", 0)
                           + spec["births_per_scan"] * rows.loc[own, "scan"])
    return result


def _told(name: str, manifest: dict[str, Any], rows: pd.DataFrame | None, outings: int) -> str:
    limit = time_limit_s(manifest)
    dirty = " with changes" if manifest.get("dirty") else ""
    held = f"{0 if rows is None else len(rows)} rows"
    held += f" and {outings} outings" if outings else ""
    return (f"Run {name}: {held}, commit {manifest.get('commit', 'unknown')}{dirty}, time limit "
            + (f"{limit:g} s." if limit is not None else
               "unknown: a window without a result costs twice the longest time of the run."))


def _machines(directories: Sequence[Path]) -> list[str]:
    manifests = [load_manifest(d / "manifest.json") for d in directories]
    differing = [f for f in _MACHINE if any(m.get(f) != manifests[0].get(f) for m in manifests)]
    if not differing:
        return []
    return [f"TIMES ARE NOT COMPARABLE across these runs: their {', '.join(differing)} differ."]


def _check_models(directories: Sequence[Path]) -> None:
    """That no two runs have one scenario under different models; raises RunError."""
    seen: dict[str, tuple[Path, dict[str, Any]]] = {}
    for directory in directories:
        scenarios = load_manifest(directory / "manifest.json").get("scenarios")
        for name, spec in (scenarios if isinstance(scenarios, dict) else {}).items():
            other, known = seen.setdefault(name, (directory, spec))
            differing = [f for f in known if f not in _NO_MODEL and known[f] != spec.get(f)]
            if differing:
                raise RunError(f"runs {other.name} and {directory.name} have different models of "
                               f"scenario {name} ({', '.join(differing)}): rank them apart")


def _check(rows: pd.DataFrame) -> None:
    twice = rows.duplicated([*KEY, "algorithm"], keep=False)
    if twice.any():
        row = rows[twice].iloc[0]
        runs = sorted(set(rows.loc[twice, "run"]))
        raise RunError(f"runs {', '.join(runs)} both have {row['algorithm']} for "
                       f"{window_name(row)}: rank them apart")
    same = (rows[KEY] == rows[KEY].shift()).all(axis=1)
    differs = same & (rows["fingerprint"] != rows["fingerprint"].shift())
    if differs.any():
        window = window_name(rows[differs].iloc[0])
        raise RunError(f"the runs have different problems for {window}: rank them apart")
