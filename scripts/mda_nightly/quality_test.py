"""Answers that changed: which way, and whether that can be called a direction."""

from pathlib import Path
from typing import Any

import pytest

from mda_nightly import quality
from mda_nightly.quality import BETTER, EQUAL, MIXED, WORSE
from mda_results.testing import row, write_run

RIGHT = {"schema_version": 1, "outcome": "finished"}


@pytest.mark.parametrize("worse, better, word", [
    (0, 0, EQUAL), (1, 0, WORSE), (0, 3, BETTER), (3, 2, MIXED), (2, 3, MIXED),
    (20, 2, WORSE), (2, 20, BETTER)])
def test_direction(worse: int, better: int, word: str) -> None:
    assert quality.direction(worse, better) == word


def test_direction_turns_with_the_sides() -> None:
    turned = {WORSE: BETTER, BETTER: WORSE, MIXED: MIXED, EQUAL: EQUAL}
    for worse in range(12):
        for better in range(12):
            assert quality.direction(better, worse) == turned[quality.direction(worse, better)]


@pytest.mark.parametrize("measure, change, word", [
    ("gap [nats]", {"gap_nats": 1.0}, WORSE),
    ("gap [nats]", {"gap_nats": -1.0}, BETTER),
    ("gap [nats]", {"gap_nats": 1e-7}, EQUAL),
    ("certified bound [nats]", {"certified_bound_nats": -10.5}, WORSE),
    ("integral", {"integral": False}, WORSE),
    ("proven optimal", {"status": "feasible"}, WORSE),
    ("answered", {"status": "no_answer", "stop": "deadline", "gap_nats": None}, WORSE),
    ("failed or refuted", {"status": "failed", "stop": "error"}, WORSE)])
def test_each_measure_knows_its_direction(measure: str, change: dict[str, Any], word: str,
                                          tmp_path: Path) -> None:
    base = write_run(tmp_path / "base", [row("exact", scan=s) for s in (1, 2, 3)], RIGHT)
    rows = [row("exact", scan=1), row("exact", scan=2, **change), row("exact", scan=3)]
    candidate = write_run(tmp_path / "candidate", rows, RIGHT)
    found = {d.measure: d for d in quality.open_loop(base, candidate)}
    assert found[measure].word == word
    assert all(d.word == EQUAL for d in quality.open_loop(base, base))


def test_order_of_rows_changes_nothing(tmp_path: Path) -> None:
    rows = [row(a, scan=s, gap_nats=float(s)) for a in ("exact", "greedy") for s in (1, 2, 3)]
    base = write_run(tmp_path / "base", rows, RIGHT)
    turned = write_run(tmp_path / "turned", rows[::-1], RIGHT)
    assert all(d.word == EQUAL for d in quality.open_loop(base, turned))
