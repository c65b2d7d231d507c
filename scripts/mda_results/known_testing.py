"""Synthetic runs over known targets for the tests."""

import json
import random
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from mda_results import testing
from mda_results.known_targets import RESOLUTIONS, SCENARIOS, nominal_period_s, target_count

Line = dict[str, Any]

ALGORITHMS = ("sd-exact", "scf", "scf-tie", "mcf", "gnn-by-scan")
OPEN_ALGORITHMS = (*ALGORITHMS, "scf-lp", "mcf-lp", "lp", "brute-force")
_STRAY = {"sd-exact": 0.0, "scf": 4.0, "scf-tie": 2.0, "mcf": 3.0, "gnn-by-scan": 9.0}
_LP = ("sd-exact", "scf-lp", "mcf", "mcf-lp", "lp")


def open_row(algorithm: str = "sd-exact", scenario: str = "battistelli-1", k: int = 3,
             scan: int = 4, **changes: Any) -> Line:
    """A row with 14 plots a scan; brute-force is skipped and lp relaxes."""
    targets, scans = target_count(scenario), min(k, scan)
    nodes = targets + scans * (targets + 14) + 1
    line = testing.row(
        algorithm, scenario=scenario, window_k=k, scan=scan, driver="sd-exact", replicate=1,
        scan_period_s=nominal_period_s(scenario), rows=targets + 14 * scans, columns=20 * 2**k,
        cost_nats=-100.0, reference_cost_nats=-100.0, views_ms=0.25, cpu_ms=0.5,
        certified_bound_nats=None, off_column_paths=0, graph_nodes=nodes, graph_arcs=3 * nodes,
        integral=True if algorithm in _LP else None)
    line.update(changes)
    if "fingerprint" not in changes:
        key = (line["scenario"], line["replicate"], line["window_k"], line["scan"])
        line["fingerprint"] = "-".join(map(str, key))
    if algorithm == "lp":
        line.update(answer="relaxation", gap_nats=None)
    if line["status"] == "skipped":
        line.update(dict.fromkeys(("cost_nats", "gap_nats", "cpu_ms", "views_ms", "integral",
                                   "off_column_paths", "graph_nodes", "graph_arcs")))
    return line


def outing(algorithm: str = "sd-exact", scenario: str = "battistelli-2", replicate: int = 1,
           k: int = 3, period: float | None = None, **changes: Any) -> Line:
    """A finished outing of 8 scans; the errors are constant unless `changes` has series."""
    scans = 8
    line: Line = {
        "schema_version": 1, "scenario": scenario, "algorithm": algorithm, "seed": 1,
        "scan_period_s": nominal_period_s(scenario) if period is None else period,
        "replicate": replicate, "window_k": k, "status": "finished", "note": "", "workers": 1,
        "scans": scans, "targets": target_count(scenario), "unanswered": 0, "off_column_paths": 0,
        "position_error_m": 60.0, "position_error_lagged_m": 50.0, "ideal_error_m": 40.0,
        "oracle_error_m": 50.0, "distance_error_m": 30.0, "distance_error_oracle_m": 10.0,
        "lost_ever": 0.25, "lost_at_end": 0.125, "right_share": 0.9, "right_share_fixed": 0.95,
        "cpu_ms": 4.0, "wall_ms": 5.0, "hypotheses_cpu_ms": 8.0,
        "position_error_series_m": [60.0] * scans, "ideal_series_m": [40.0] * scans,
        "oracle_series_m": [50.0] * scans, "right_series": [0.9] * scans,
    }
    line.update(changes)
    return line


def skipped(line: Line) -> Line:
    """The line of an outing that did not take place."""
    kept = ("schema_version", "scenario", "scan_period_s", "seed", "replicate", "window_k",
            "algorithm")
    return {**{f: line[f] for f in kept}, "status": "skipped", "note": "declined", "workers": 1}


def study_rows(scenes: int = 3, windows: int = 3,
               scenarios: Iterable[str] = SCENARIOS) -> list[Line]:
    """Open loop at K = 1 to 5, random gaps."""
    draw = random.Random(7)
    lines = []
    for scenario in scenarios:
        for k in (1, 2, 3, 4, 5):
            for window in range(scenes * windows):
                key = {"scenario": scenario, "k": k, "replicate": 1 + window // windows,
                       "scan": 5 + 4 * (window % windows)}
                for algorithm in OPEN_ALGORITHMS:
                    gap = max(0.0, draw.gauss(-1.0, 1.0)) * _STRAY.get(algorithm, 0.0) * k / 20
                    cpu = draw.uniform(0.5, 1.0) * (8.0 if algorithm == "sd-exact" else 0.2 * k)
                    status = "skipped" if algorithm == "brute-force" else "feasible"
                    lines.append(open_row(
                        algorithm, gap_nats=gap, cost_nats=-100.0 + gap, cpu_ms=cpu, status=(
                            "optimal" if algorithm == "sd-exact" else status), **key))
    return lines


def study_outings(runs: int = 4, scenarios: Iterable[str] = SCENARIOS) -> list[Line]:
    """Parts (b) and (c), random errors that grow in the manoeuvres of scenario 2."""
    random_errors = np.random.default_rng(8)
    cells = [(s, nominal_period_s(s), 3, a) for s in scenarios for a in ALGORITHMS]
    cells += [(s, nominal_period_s(s), k, a) for s in scenarios for k in (1, 2, 4, 5)
              for a in ("scf-tie", "sd-exact")]
    cells += [(s, t, 3, a) for s in RESOLUTIONS for t in (1.0, 2.0, 5.0, 10.0)
              for a in ("scf-tie", "mcf", "sd-exact") if (s, t) != ("battistelli-2", 2.0)]
    return [_random_outing(*cell, run, random_errors)
            for cell in cells for run in range(1, runs + 1)]


def _random_outing(scenario: str, period: float, k: int, algorithm: str, run: int,
                   noise: np.random.Generator) -> Line:
    duration = 300.0 if scenario.startswith("battistelli-1") else 350.0
    times = period * np.arange(1, int(duration / period) + 1)
    turning = (times >= 200) & (times <= 260) & scenario.startswith("battistelli-2")
    ideal = 25 + 3 * period + 30 * np.exp(-times / 30) + 40 * turning
    oracle = 1.2 * ideal + 30 * turning
    stray = _STRAY[algorithm] * times / 100 + RESOLUTIONS.get(scenario, 1.0) * 2 * period
    error = oracle + stray * noise.lognormal(0, 0.5, len(times)) / k
    right = np.clip(noise.normal(0.97 - 0.004 * _STRAY[algorithm], 0.04, len(times)), 0, 1)
    lost = float(np.clip(noise.normal(0.02 * period, 0.05), 0, 1))
    return outing(
        algorithm, scenario, run, k, period, scans=len(times),
        position_error_m=float(error.mean()), ideal_error_m=float(ideal.mean()),
        oracle_error_m=float(oracle.mean()), distance_error_m=float((error - ideal).mean()),
        right_share=float(right.mean()), lost_ever=lost, lost_at_end=lost / 2,
        position_error_series_m=error.round(2).tolist(), ideal_series_m=ideal.round(2).tolist(),
        oracle_series_m=oracle.round(2).tolist(), right_series=right.round(3).tolist())


def manifest() -> dict[str, Any]:
    """One without plans."""
    return {"schema_version": 1, "commit": "abc", "sweep": {"name": "battistelli2008", "plans": []}}


def trajectories(scenarios: Iterable[str]) -> dict[str, Any]:
    """Every target flies a straight line of its own."""
    return {s: {"scan_period_s": nominal_period_s(s),
                "targets": [[[0.3 * n + 0.02 * t, 16.0 + 0.1 * t - 0.05 * n] for t in range(50)]
                            for n in range(target_count(s))]} for s in scenarios}


def write_known(run: Path, rows: list[Line], outings: list[Line], about: Any = None,
                tail: str = "") -> Path:
    """Writes a run directory and returns it; `tail` goes to the end of tracking.jsonl."""
    testing.write_run(run, rows, manifest() if about is None else about)
    text = "".join(json.dumps(line) + "\n" for line in outings)
    (run / "tracking.jsonl").write_text(text + tail)
    return run
