"""Synthetic rows for the tests of the ranking."""

import random
from pathlib import Path
from typing import Any

from mda_results import pool, rank_report, testing
from mda_results.contest import Contest, contests
from mda_results.rank_report import Selection
from mda_results.testing import Row

MANIFEST = {"schema_version": 1, "commit": "abc", "cpu": "one",
            "sweep": {"name": "small", "seed": 1, "time_limit_s": 10.0}}
PENALTY_MS = 20000.0


def row(algorithm: str, gap: float = 0.0, lp_gap: float = 0.0, **changes: Any) -> Row:
    """A row of a window whose optimum is -10 and LP value -10 - lp_gap, which every row certifies;
    proven without a gap. No views."""
    line: Row = {"cost_nats": -10.0 + gap, "gap_nats": gap, "gap_share": gap / 10.0,
                 "bound_nats": None, "certified_bound_nats": -10.0 - lp_gap,
                 "status": "feasible" if gap else "optimal",
                 "fractional": 6 if lp_gap else 0, "integral": lp_gap == 0}
    line.update(changes)
    return testing.row(algorithm, **line)


def unanswered(algorithm: str, status: str, stop: str, **changes: Any) -> Row:
    """A row without an answer; a time-out took the whole limit."""
    empty = dict.fromkeys(("cost_nats", "gap_nats", "gap_share", "bound_nats", "integral",
                           "certified_bound_nats", "fractional", "row_violation"))
    times = {"cpu_ms": None if status == "skipped" else 10001.0}
    return testing.row(algorithm, **{**empty, **times, "status": status, "stop": stop, **changes})


def study(replicates: int = 6, scans: int = 4) -> list[Row]:
    """Scenarios A and B at K = 3 and 5; every third window is hard. `exact` proves, `quick` strays,
    `late` times out now and then, `small` declines large windows, `lp` relaxes, `odds` gives
    marginals."""
    draw = random.Random(3)
    rows = []
    for scenario in "AB":
        for k in (3, 5):
            for n in range(replicates * scans):
                key = {"scenario": scenario, "window_k": k, "replicate": 1 + n // scans,
                       "scan": 1 + n % scans, "columns": 10 * k + n,
                       "largest_component_columns": 5 + 40 * (n % 4)}
                lp_gap = draw.choice([0.0, 0.0, 0.05 + draw.random()])
                common = {**key, "lp_gap": lp_gap}
                stray = draw.choice([0.0, 0.0, draw.expovariate(1.0)])
                rows += [row("exact", **common, cpu_ms=draw.uniform(2.0, 4.0)),
                         row("quick", stray, **common, status="feasible",
                             cpu_ms=draw.uniform(0.1, 0.3)),
                         row("lp", **common, answer="relaxation", gap_nats=None, gap_share=None,
                             cost_nats=-10.0 - lp_gap),
                         row("odds", **key, answer="marginals", gap_nats=None, gap_share=None,
                             status="feasible", certified_bound_nats=None, row_violation=0.25,
                             integral=None, fractional=None)]
                rows.append(unanswered("late", "no_answer", "deadline", **key)
                            if draw.random() < 0.2 else row("late", **common, cpu_ms=5.0))
                rows.append(unanswered("small", "skipped", "finished", **key, note="too large")
                            if n % 3 == 0 else row("small", **common, cpu_ms=1.0))
    return rows


def contests_of(run: Path, selection: Selection = Selection(),
                told: list[str] | None = None) -> dict[str, Contest]:
    """By hardness."""
    chosen = rank_report.judged(pool.load([run]), selection)
    return {c.hardness: c for c in contests(chosen.rows, told if told is not None else [])}


def write(run: Path, rows: list[Row], manifest: Any = None, tail: str = "") -> Path:
    return testing.write_run(run, rows, MANIFEST if manifest is None else manifest, tail)
