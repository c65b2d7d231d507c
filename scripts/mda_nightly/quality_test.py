"""Answers that changed: which way, and whether that can be called a direction."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mda_nightly import quality
from mda_nightly.quality import BETTER, EQUAL, MIXED, WORSE
from mda_nightly.testing import answers, manifest, outings
from mda_results.rows import RunError
from mda_results.testing import row, write_run



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
    base = write_run(tmp_path / "base", [row("exact", scan=s) for s in (1, 2, 3)], manifest(3))
    rows = [row("exact", scan=1), row("exact", scan=2, **change), row("exact", scan=3)]
    candidate = write_run(tmp_path / "candidate", rows, manifest(len(rows)))
    found = {d.measure: d for d in quality.open_loop(base, candidate)}
    assert found[measure].word == word
    assert all(d.word == EQUAL for d in quality.open_loop(base, base))


def test_order_of_rows_changes_nothing(tmp_path: Path) -> None:
    rows = [row(a, scan=s, gap_nats=float(s)) for a in ("exact", "greedy") for s in (1, 2, 3)]
    base = write_run(tmp_path / "base", rows, manifest(len(rows)))
    turned = write_run(tmp_path / "turned", rows[::-1], manifest(len(rows)))
    assert all(d.word == EQUAL for d in quality.open_loop(base, turned))


def test_algorithms_of_one_run_alone_are_named_and_judge_nothing(tmp_path: Path) -> None:
    rows = [row(a, scan=s) for a in ("exact", "greedy") for s in (1, 2)]
    both = write_run(tmp_path / "both", rows, manifest(4))
    one = write_run(tmp_path / "one", rows[:2], manifest(2))
    for base, candidate, side in ((both, one, "baseline"), (one, both, "candidate")):
        alone = [d for d in quality.open_loop(base, candidate) if d.word != EQUAL]
        assert [(d.algorithm, d.word) for d in alone] == [("greedy", f"only in the {side}")]
        assert "greedy" in str(quality.table("answers", "", alone).rows)


def cut(text: str) -> str:
    return "".join(text.splitlines(keepends=True)[:-1])


RUNS = [(answers, "rows.jsonl", quality.open_loop),
        (outings, "tracking.jsonl", quality.closed_loop)]


@pytest.mark.parametrize("make, name, judge", RUNS)
@pytest.mark.parametrize("spoil", [
    cut, lambda text: text[:-9], lambda text: "", lambda text: text + text.splitlines()[0] + "\n",
    lambda text: "\n".join(x for x in text.splitlines() if "greedy" not in x) + "\n",
    lambda text: text.replace('"schema_version": 1', '"schema_version": 9'),
    lambda text: text.replace('"status": "', '"status": "un', 1),
    lambda text: text.replace('"replicate": 1', f'"replicate": {10**400}', 1),
    lambda text: text.replace('"window_k": 3', '"window_k": null', 1),
    lambda text: text.replace('"replicate": 2', '"replicate": 1')])
def test_damaged_runs_are_refused_by_their_file(make: Callable[..., Path], name: str, judge: Any,
                                                spoil: Callable[[str], str],
                                                tmp_path: Path) -> None:
    sides = [make(tmp_path / side) for side in ("base", "candidate")]
    assert judge(*sides)
    for side in sides:  # both, as when the disk was full
        (side / name).write_text(spoil((side / name).read_text()))
    with pytest.raises(RunError, match=str(sides[0])):
        judge(*sides)


@pytest.mark.parametrize("field, value", [
    ("gospa_km", "x"), ("gospa_km", True), ("lost", [1]), ("swaps", 10**400), ("scenario", 5),
    ("algorithm", None), ("scan_period_s", 0), ("schema_version", True), ("status", 5)])
def test_a_field_of_an_outing(field: str, value: Any, tmp_path: Path) -> None:
    base, candidate = outings(tmp_path / "a"), outings(tmp_path / "b", **{field: value})
    with pytest.raises(RunError, match=f"{candidate}/tracking.jsonl:3: {field} is"):
        quality.closed_loop(base, candidate)


@pytest.mark.parametrize("change", [
    {"cost_nats": 10**400}, {"window_k": 10**400}, {"gap_nats": "x"}])
def test_a_number_of_a_row(change: dict[str, Any], tmp_path: Path) -> None:
    base, candidate = answers(tmp_path / "a"), answers(tmp_path / "b", **change)
    with pytest.raises(RunError, match=f"{candidate}/rows.jsonl.*{next(iter(change))}"):
        quality.open_loop(base, candidate)


@pytest.mark.parametrize("make, name, judge", RUNS)
@pytest.mark.parametrize("found", [
    {}, {"summary": {}}, {"summary": 5}, {"summary": {"rows": "x"}}, {"summary": {"rows": 3}},
    {"outcome": "running"}, {"outcome": None}, {"schema_version": 9}, {"schema_version": True}])
def test_a_manifest_that_does_not_fit(make: Callable[..., Path], name: str, judge: Any,
                                      found: dict[str, Any], tmp_path: Path) -> None:
    base, candidate = make(tmp_path / "a"), make(tmp_path / "b")
    (candidate / "manifest.json").write_text(json.dumps({**manifest(4), **found} if found else {}))
    with pytest.raises(RunError, match=f"{candidate}.*manifest"):
        judge(base, candidate)


def test_a_scene_that_was_skipped_has_no_scores(tmp_path: Path) -> None:
    skipped = {"status": "skipped", **dict.fromkeys(quality._SCORES)}
    base, candidate = outings(tmp_path / "a"), outings(tmp_path / "b", **skipped)
    found = {d.measure: d for d in quality.closed_loop(base, candidate) if d.algorithm == "greedy"}
    assert found["finished"].word == WORSE and found["GOSPA [km]"].rows == 0
