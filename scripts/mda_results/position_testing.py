"""Synthetic runs over position targets for the tests."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from mda_results import testing
from mda_results.position_targets import ALGORITHMS, DENSITIES

Line = dict[str, Any]

SCANS = 8
MARGINALS = ("hnpda", "hnpda-raw", "jpda", "pda", "jpda-cheap", "lbp", "mapada-weighted")
_STRAY_KM = {"oracle": 0.0, "mapada": 0.03, "jpda": 0.06, "hnpda": 0.2, "hnpda-raw": 0.25}
_TARGETS = {"crossing": [1, 2], "parallel": [3, 4], "ten": list(range(1, 11))}


def scenario(scene: str, density: float = 0.2, law: str = "normal") -> str:
    uniform = "-uniform" if law == "uniform" else ""
    return f"lee-{scene}{uniform}" + (f"-c{density:g}" if density != DENSITIES[0] else "")


def outing(algorithm: str = "mapada", scene: str = "crossing", replicate: int = 1,
           density: float = 0.2, law: str = "normal", **changes: Any) -> Line:
    """A finished outing of 8 scans whose errors are 0.1 km and 0.02 km/s throughout."""
    targets = _TARGETS[scene]
    line: Line = {
        "schema_version": 1, "scenario": scenario(scene, density, law), "scan_period_s": 1,
        "seed": 1, "replicate": replicate, "window_k": 1, "algorithm": algorithm,
        "update": "soft", "status": "finished", "note": "", "workers": 1, "scans": SCANS,
        "targets": targets, "unanswered": 0, "swaps": 0, "coalescences": 0, "conflict_rate": 0,
        "iterations_per_scan": None, "wall_ms": 0.5, "cpu_ms": 0.4, "hypotheses_cpu_ms": 0.8,
        **per_target(len(targets), dropped=False, maintained_450m=True, maintained_750m=True,
                     position_squares_km2=0.08, velocity_squares_km2_s2=0.0032,
                     predicted_position_squares_km2=0.32,
                     predicted_velocity_squares_km2_s2=0.0128,
                     position_error_series_km=[0.1] * SCANS,
                     velocity_error_series_km_s=[0.02] * SCANS,
                     track_series_km=[[0.2 * t - 0.8, 0.1] for t in range(SCANS)]),
    }
    line.update(changes)
    return line


def per_target(count: int, **values: Any) -> Line:
    """The same value for every target."""
    return {name: [value] * count for name, value in values.items()}


def skipped(line: Line, status: str = "skipped", note: str = "declined") -> Line:
    """The line of an outing that did not take place, or that broke down."""
    kept = ("schema_version", "scenario", "scan_period_s", "seed", "replicate", "window_k",
            "algorithm", "update", "workers")
    return {**{f: line[f] for f in kept}, "status": status, "note": note}


def open_row(algorithm: str = "gnn", scene: str = "crossing", scan: int = 4,
             **changes: Any) -> Line:
    return testing.row(algorithm, **{
        "scenario": scenario(scene), "scan_period_s": 1, "window_k": 1, "scan": scan,
        "views_ms": 0.25, **changes})


def study(runs: int = 3, algorithms: Iterable[str] = ALGORITHMS,
          densities: Iterable[float] = DENSITIES, update: str = "soft") -> list[Line]:
    """All scenes under both laws, random errors that grow with clutter and time."""
    cells = [(s, d, law) for s in ("crossing", "parallel") for d in densities
             for law in ("normal", "uniform")]
    cells += [("ten", 0.2, law) for law in ("normal", "uniform")]
    lines = []
    for n, (scene, density, law) in enumerate(cells):
        for m, algorithm in enumerate(algorithms):
            for replicate in range(1, runs + 1):
                turn = 1 if update == "hard" and algorithm in MARGINALS else 0
                noise = np.random.default_rng([n, m, replicate, turn])
                stray = _STRAY_KM.get(algorithm, 0.05) * density / 0.2
                lines.append(_random_outing(algorithm, scene, replicate, density, law, stray,
                                            noise, update))
    return lines


def _random_outing(algorithm: str, scene: str, replicate: int, density: float, law: str,
                   stray: float, noise: np.random.Generator, update: str) -> Line:
    count = len(_TARGETS[scene])
    error = 0.1 + stray * noise.lognormal(0, 0.5, (count, 1)) * np.arange(SCANS) / SCANS
    error = (error * noise.lognormal(0, 0.2, (count, SCANS))).round(4)
    squares = (error**2).sum(axis=1).tolist()
    kept = error[:, -5:].max(axis=1)
    x = np.linspace(-4, 4, SCANS)
    tracks = [np.column_stack([x, 0.25 * n * x + e]).round(4).tolist()
              for n, e in enumerate(error)]
    return outing(
        algorithm, scene, replicate, density, law, update=update,
        dropped=(kept > 1.5).tolist(), maintained_450m=(kept < 0.45).tolist(),
        maintained_750m=(kept < 0.75).tolist(), position_squares_km2=squares,
        predicted_position_squares_km2=[2 * s for s in squares],
        velocity_squares_km2_s2=[s / 30 for s in squares],
        predicted_velocity_squares_km2_s2=[s / 20 for s in squares],
        position_error_series_km=error.tolist(),
        velocity_error_series_km_s=(error / 5).round(4).tolist(), track_series_km=tracks,
        conflict_rate=0.25 if "hnpda" in algorithm or "literal" in algorithm else 0,
        swaps=int(noise.random() < 0.3), coalescences=int(algorithm == "jpda"),
        iterations_per_scan=100.0 if "mapada" in algorithm else None)


def trajectories() -> dict[str, Any]:
    """Straight lines."""
    x = np.linspace(-4, 4, SCANS)
    return {scenario(s, d, law): {"scan_period_s": 1, "targets": [
        np.column_stack([x, 0.25 * n * x]).tolist() for n in range(len(_TARGETS[s]))]}
        for s in _TARGETS for d in DENSITIES for law in ("normal", "uniform")}


def write_position(run: Path, outings: list[Line], rows: Iterable[Line] = (), about: Any = None,
                   tail: str = "") -> Path:
    """Writes a run directory and returns it; `tail` goes to the end of tracking.jsonl."""
    manifest = {"schema_version": 1, "commit": "abc"} if about is None else about
    testing.write_run(run, list(rows), manifest)
    text = "".join(json.dumps(line) + "\n" for line in outings)
    (run / "tracking.jsonl").write_text(text + tail)
    return run
