"""Synthetic runs for the tests."""

import json
import random
from pathlib import Path
from typing import Any

from mda_results import storms2003
from mda_results.render import Report, Table
from mda_results.rows import load_run

Row = dict[str, Any]

SCENARIO = {"scans": 3, "clutter_per_scan": 5.0, "births_per_scan": 1.0,
            "density": "literal", "max_misses": 3}
MANIFEST = {
    "schema_version": 1,
    "scenarios": {"A": SCENARIO},
    "sweep": {"name": "small", "seed": 1},
}


def row(algorithm: str = "lp-grp", **changes: Any) -> Row:
    """A complete row; `gap` > 0 stands for a fractional window."""
    base: Row = {
        "schema_version": 1, "scenario": "A", "driver": "exact", "algorithm": algorithm,
        "answer": "selection", "status": "optimal", "stop": "finished", "note": "", "seed": 1,
        "window_k": 3, "replicate": 1, "scan": 1, "scan_period_s": 8.0, "rows": 4, "columns": 10,
        "nonzeros": 30, "dimensions": 4, "components": 2, "largest_component_columns": 7,
        "fractional": 0, "paper_fractional": 0, "iterations": 5, "nodes": None,
        "off_column_paths": None, "workers": 1, "wall_ms": 1.0, "cpu_ms": 1.0, "translate_ms": 0.1,
        "views_ms": None, "grow_ms": 0.1, "lp_ms": None, "round_ms": None, "cost_nats": -10.0,
        "bound_nats": -10.0, "certified_bound_nats": -10.0, "reference_cost_nats": -10.0,
        "retired_nats": 0.0, "truth_cost_nats": -9.0, "gap_nats": 0.0, "gap_share": 0.0,
        "row_violation": 0.0, "integral": True, "tight": True, "ungated_columns": 1000,
    }
    base.update(changes)
    if "fingerprint" not in base:
        key = (base["scenario"], base["replicate"], base["window_k"], base["scan"])
        base["fingerprint"] = "-".join(map(str, key)).rjust(16, "0")
    return base


def fractional(gap: float, **changes: Any) -> Row:
    return row(integral=False, gap_nats=gap, cost_nats=-10.0 + gap, paper_fractional=6, **changes)


def hand_made() -> list[Row]:
    """Two replicates of three scans at K = 3 and 4, group A; what it holds is counted below."""
    return [
        row(replicate=1, scan=1), fractional(0.5, replicate=1, scan=2),
        fractional(2.25, replicate=1, scan=3, retired_nats=-100.0, reference_cost_nats=-20.5),
        row(replicate=2, scan=1), fractional(3e-6, replicate=2, scan=2),
        row(replicate=2, scan=3, retired_nats=-7.0),
        *(row(window_k=4, replicate=1, scan=s) for s in (1, 2, 3)),
        row(window_k=4, replicate=2, scan=1), fractional(0.0, window_k=4, replicate=2, scan=2),
        fractional(0.75, window_k=4, replicate=2, scan=3),
    ]


def full_size(replicates: int = 2) -> list[Row]:
    """All groups and K of the paper with three scans, four algorithms, random values."""
    draw = random.Random(5)
    rows = []
    for group in "ABCD":
        for k in (3,) if group == "D" else (3, 4, 5, 6, 7):
            for window in range(3 * replicates):
                key = {"scenario": group, "window_k": k, "replicate": 1 + window // 3,
                       "scan": 1 + window % 3}
                gap = draw.choice([None, None, 0.0, draw.expovariate(1.0)])
                lp_grp = row(**key) if gap is None else fractional(gap, **key)
                lp_grp["retired_nats"] = draw.uniform(-2000.0, -1000.0)
                rows.append(lp_grp)
                rows += [row(a, **key, cpu_ms=draw.uniform(0.1, 2.0))
                         for a in ("cbc", "exact", "greedy")]
    return rows


def write_run(run: Path, rows: list[Row], manifest: Any = MANIFEST, tail: str = "") -> Path:
    """Writes a run directory and returns it; `tail` goes unchanged to the end of rows.jsonl."""
    run.mkdir(exist_ok=True)
    (run / "manifest.json").write_text(json.dumps(manifest))
    (run / "rows.jsonl").write_text("".join(json.dumps(r) + "\n" for r in rows) + tail)
    return run


def report_of(run: Path) -> Report:
    return storms2003.report(load_run(run))


def table_of(report: Report, name: str) -> Table:
    return next(t for t in report.tables if t.name == name)


def values(table: Table, *key: Any) -> dict[str, Any]:
    """The line of a table that starts with `key`, by full header."""
    line = next(r for r in table.rows if r[: len(key)] == list(key))
    return {c.full_header: cell for c, cell in zip(table.columns, line)}
