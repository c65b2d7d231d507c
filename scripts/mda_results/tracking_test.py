"""Closed-loop tables, from hand-made outings."""

import json
import random
from pathlib import Path
from typing import Any

import pytest

import tables
from mda_results import tracking
from mda_results.render import Estimate, Report, to_text
from mda_results.rows import RunError


def outing(algorithm: str, replicate: int, gospa: float, **changes: Any) -> dict[str, Any]:
    line = {
        "schema_version": 1, "scenario": "A", "scan_period_s": 8.0, "seed": 1,
        "replicate": replicate, "window_k": 3, "algorithm": algorithm, "status": "finished",
        "note": "", "scans": 30, "unanswered": 0, "gospa_km": gospa,
        "gospa_localisation_km2": 0.1, "gospa_missed_km2": 0.2, "gospa_false_km2": 0.3,
        "ospa_km": 0.5, "correct_association": 0.9, "purity": 0.8, "completeness": 0.7,
        "track_breaks": 1, "swaps": 2, "lost": 1, "present": 4, "tracks": 5, "targets": 6,
        "cost_nats": -90.0, "truth_cost_nats": -100.0, "wall_ms": 60.0, "cpu_ms": 30.0,
        "workers": 1,
    }
    line.update(changes)
    return line


@pytest.fixture
def write_outings(tmp_path: Path):
    def write(lines: list[dict[str, Any]], tail: str = "") -> Path:
        (tmp_path / "manifest.json").write_text(json.dumps({"schema_version": 1, "commit": "c"}))
        text = "".join(json.dumps(line) + "\n" for line in lines)
        (tmp_path / "tracking.jsonl").write_text(text + tail)
        return tmp_path

    return write


def line_of(report: Report, table: str, algorithm: str) -> dict[str, Any]:
    found = next(t for t in report.tables if t.name == table)
    row = next(r for r in found.rows if algorithm in r)
    return {c.full_header: v for c, v in zip(found.columns, row)}


LINES = [outing("exact", 1, 1.0), outing("exact", 2, 3.0), outing("greedy", 1, 1.5),
         outing("greedy", 2, 2.5, lost=3, unanswered=2)]


def test_means_by_hand(write_outings):
    report = tracking.report(write_outings(LINES))
    distances = line_of(report, "tracking_distances", "exact")
    assert distances["n"] == 2
    gospa = distances["GOSPA [km]"]
    assert isinstance(gospa, Estimate) and gospa.value == 2.0
    assert gospa.low is not None and 1.0 <= gospa.low <= 2.0
    assert distances["cost - V_T [nats]"].value == 10.0
    assert distances["CPU [ms/scan]"] == 1.0
    association = line_of(report, "tracking_association", "greedy")
    assert association["lost [%]"] == 50.0
    assert association["percent purity"].value == pytest.approx(80.0)


def test_pairs_by_hand(write_outings):
    paired = line_of(tracking.report(write_outings(LINES)), "tracking_paired", "greedy")
    assert paired["GOSPA difference [km]"].value == pytest.approx(0.0)
    assert (paired["better"], paired["equal"], paired["worse"]) == (1, 0, 1)


def test_nothing_is_dropped_in_silence(write_outings):
    skipped = {k: v for k, v in outing("lp", 1, 0.0, status="skipped").items()
               if k not in tracking._MEASURES}
    failed = outing("greedy", 3, 9.0, status="failed")
    report = tracking.report(write_outings([*LINES, skipped, failed]))
    fates = line_of(report, "tracking_fates", "lp")
    assert (fates["outings"], fates["finished"], fates["skipped"]) == (1, 0, 1)
    fates = line_of(report, "tracking_fates", "greedy")
    assert (fates["outings"], fates["failed"], fates["windows without an answer"]) == (3, 1, 2)
    assert line_of(report, "tracking_distances", "greedy")["n"] == 2


def test_order_does_not_matter(write_outings):
    text = to_text(tracking.report(write_outings(LINES)))
    shuffled = LINES.copy()
    random.Random(3).shuffle(shuffled)
    assert to_text(tracking.report(write_outings(shuffled))) == text


def test_a_torn_last_line_is_told(write_outings, capsys):
    assert tables.main(["tracking", str(write_outings(LINES, '{"schema'))]) == 0
    assert "torn" in capsys.readouterr().out.replace("\n  ", " ")


@pytest.mark.parametrize("lines", [
    [], [{"schema_version": 1}], [outing("exact", 1, 1.0, schema_version=2)],
    [outing("exact", 1, 1.0)] * 2,
    [{k: v for k, v in outing("exact", 1, 1.0).items() if k != "swaps"}],
])
def test_damaged_runs_are_refused(write_outings, lines, capsys):
    directory = write_outings(lines)
    with pytest.raises(RunError):
        tracking.report(directory)
    assert tables.main(["tracking", str(directory)]) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1


def test_an_open_loop_run_is_refused(write_outings):
    directory = write_outings(LINES)
    (directory / "tracking.jsonl").unlink()
    with pytest.raises(RunError, match="no closed-loop run"):
        tracking.report(directory)
