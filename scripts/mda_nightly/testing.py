"""Sessions and histories that nobody measured, for the tests."""

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from mda_nightly import comparison, sessions
from mda_nightly.sessions import ANCHOR, BASELINE, CANDIDATE, SCHEMA_VERSION, TWIN
from mda_results.testing import row, write_run

SIDES = (BASELINE, TWIN, CANDIDATE, ANCHOR)
CELLS = tuple(f"set/{name}" for name in "abcdefghijkl")
TURNS = 5
MACHINE = {"cpu": "Old Faithful", "cores": 2, "load_1min": 1.0}

Slowdown = Callable[[str, str], float]  # of cell and side: log factor of its times


def none(cell: str, side: str) -> float:
    return 0.0


def planted(cells: Sequence[str], size: float = float(np.log(1.05))) -> Slowdown:
    """The candidate takes longer on some cells."""
    return lambda cell, side: size if side == CANDIDATE and cell in cells else 0.0


def samples(seed: int, slowdown: Slowdown = none, rounds: int = 13, again: Sequence[str] = (),
            noise: float = 0.006, wild: float = 0.1) -> list[dict[str, Any]]:
    """Of a machine whose speed wanders by a factor of two from round to round, the same for all
    sides; each process has luck of its own of size `noise`, and one in twenty of size `wild`."""
    draw = np.random.default_rng(seed)
    lines = []
    for number, cells in ((sessions.FIRST, CELLS), (sessions.AGAIN, again)):
        for r in range(1, rounds + 1):
            for cell in cells:
                speed = 1e-3 * np.exp(draw.uniform(0, np.log(2)))
                for side in SIDES if number == sessions.FIRST else (BASELINE, CANDIDATE):
                    luck = draw.normal(0, wild if draw.random() < 0.05 else noise)
                    turns = np.exp(luck + draw.normal(0, 0.02, TURNS) + slowdown(cell, side))
                    cpu = [float(x) for x in speed * turns]
                    lines.append({"cell": cell, "side": side, "pass": number, "round": r,
                                  "passes": 20, "stalled": 0.5, "cpu_s": cpu,
                                  "wall_s": [1.5 * x for x in cpu],
                                  "counters": {"problems": 7.0, "solver_iterations": 40.0}})
    return lines


def _source(side: str) -> str:
    return BASELINE if side == TWIN else side


def facts(**changes: Any) -> dict[str, Any]:
    """session.json; every side but the twin has a program of its own."""
    base = {"schema_version": SCHEMA_VERSION, "id": "night", "started": "2026-01-01T02:00:00Z",
            "ended": "2026-01-01T02:05:00Z", "machine": MACHINE,
            "seed": 1, "rounds": 13, "broken": {}, "outcome": "finished",
            "sides": {side: {"revision": side, "commit": side * 3,
                             "programs": {"windows_bench": f"hash of {_source(side)}"}}
                      for side in SIDES},
            "cells": {cell: {"program": "windows_bench"} for cell in CELLS}}
    return {**base, "machine_at_end": changes.get("machine", MACHINE), **changes}


def write_session(directory: Path, lines: Sequence[Mapping[str, Any]],
                  counts: Mapping[tuple[str, str], int] | None = None, **changes: Any) -> Path:
    """A session whose sides gave the same answers; returns its directory."""
    rounds = max(line["round"] for line in lines if line["pass"] == sessions.FIRST)
    sessions.write_facts(directory, facts(**{"rounds": rounds, **changes}))
    for side in (BASELINE, CANDIDATE):
        answers(directory / side / comparison.OPEN)
        outings(directory / side / comparison.CLOSED)
    text = "".join(json.dumps(line) + "\n" for line in lines)
    (directory / sessions.SAMPLES_FILE).write_text(text, encoding="utf-8")
    if counts:
        sessions.write_counts(directory / sessions.COUNTS_FILE, counts)
    return directory


def answers(directory: Path, **changes: Any) -> Path:
    """A run of three algorithms on four windows; `changes` go to every row of greedy."""
    rows = [row(name, replicate=replicate, scan=scan, **(changes if name == "greedy" else {}))
            for name in ("exact", "greedy", "lp-grp") for replicate in (1, 2) for scan in (1, 2)]
    directory.parent.mkdir(parents=True, exist_ok=True)
    return write_run(directory, rows, manifest(len(rows)))


def outings(directory: Path, **changes: Any) -> Path:
    """A closed-loop run of two algorithms on two scenes; `changes` go to every line of greedy."""
    lines = [{"schema_version": 1, "scenario": "A", "scan_period_s": 8.0, "window_k": 3,
              "replicate": replicate, "algorithm": name, "status": "finished", "unanswered": 0,
              "gospa_km": 1.0, "correct_association": 0.9, "track_breaks": 0, "swaps": 0, "lost": 0,
              **(changes if name == "greedy" else {})}
             for name in ("exact", "greedy") for replicate in (1, 2)]
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "manifest.json").write_text(json.dumps(manifest(len(lines))))
    (directory / "tracking.jsonl").write_text("".join(json.dumps(x) + "\n" for x in lines))
    return directory


def manifest(rows: int) -> dict[str, Any]:
    """Of a run that finished."""
    return {"schema_version": 1, "outcome": "finished", "summary": {"rows": rows}}
