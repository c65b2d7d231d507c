"""The ranking, from cases worked by hand."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mda_results import curves, facts, pairwise, pool, rank_report, ranking, testing
from mda_results.rank_report import Selection
from mda_results.ranking_testing import PENALTY_MS, contests_of, row, study, unanswered, write
from mda_results.standings import SHIFT_MS, Standing, standings
from mda_results.testing import Row


def ranked(run: Path, hardness: str = "easy") -> dict[str, Standing]:
    return {s.algorithm: s for s in standings(contests_of(run)[hardness])}


def windows(algorithm: str, *values: Any, **common: Any) -> list[Row]:
    """A row per value, two scans a replicate; a number is a gap, a dictionary changes."""
    rows = []
    for n, value in enumerate(values):
        given = value if isinstance(value, dict) else {"gap": value}
        rows.append(row(algorithm, **{"replicate": 1 + n // 2, "scan": 1 + n % 2, **common,
                                      **given}))
    return rows


def test_a_ranking_by_hand(tmp_path):
    rows = windows("exact", 0, 0, 0, 0, cpu_ms=3.0, views_ms=4.0)
    rows += windows("quick", 0.0, 0.0, 1.0, 3.0, cpu_ms=1.0)
    found = ranked(write(tmp_path, rows))
    assert list(found) == ["exact", "quick"]
    exact, quick = found.values()
    assert (exact.place.value, quick.place.value) == (1, 2)
    assert exact.time.value == pytest.approx(7.0)  # the views are charged
    assert quick.time.value == pytest.approx(1.0)
    assert (exact.proven.value, quick.proven.value) == (1.0, 0.5)
    assert quick.certified_gap.value == pytest.approx(1.0)
    assert quick.certified_gap_p95 == quick.certified_gap_max == 3.0
    assert quick.certified == quick.best_known == 0.5
    assert quick.certified_gap.low == 0.0 and quick.certified_gap.high == 2.0  # of two scenes
    assert (exact.place.low, exact.place.high) == (1, 2)  # the first scene alone is a draw in proof


def test_a_time_out_costs_twice_the_limit(tmp_path):
    late = unanswered("late", "no_answer", "deadline", scan=2)
    rows = [row("exact", scan=s) for s in (1, 2)] + [row("late", scan=1, cpu_ms=4.0), late]
    found = ranked(write(tmp_path, rows))["late"]
    assert found.time.value == pytest.approx(
        math.sqrt((4.0 + SHIFT_MS) * (PENALTY_MS + SHIFT_MS)) - SHIFT_MS)
    assert (found.penalised, found.answered) == (1, 0.5)
    assert found.certified_gap.value == pytest.approx(5.0)  # doing nothing costs 10 more


def test_an_answer_at_the_deadline_counts_in_gap_but_not_in_time(tmp_path):
    rows = [row("exact"), row("late", 0.5, stop="deadline", cpu_ms=10000.0)]
    contest = contests_of(write(tmp_path, rows))["easy"]
    late = standings(contest)[1]
    assert late.answered == 1.0 and late.gap.value == pytest.approx(0.5)
    assert late.time.value == pytest.approx(PENALTY_MS)
    assert late.penalised == 1
    assert curves.time_to_gap(contest, 1.0, [9999.0, 10001.0])[:, 1].tolist() == [0.0, 1.0]


def test_the_best_cost_without_a_proof_at_the_deadline_is_no_success(tmp_path):
    rows = [row("exact"), row("late", status="feasible", stop="deadline", cpu_ms=10000.0)]
    contest = contests_of(write(tmp_path, rows))["easy"]
    late = standings(contest)[1]
    assert (late.best_known, late.certified, late.gap.value) == (0.0, 1.0, 0.0)
    assert curves.profile(contest, [1e9])[0].tolist() == [1.0, 0.0]


def test_a_solver_that_times_out_everywhere(tmp_path):
    rows = windows("exact", 0, 0, 0, 0) + [
        unanswered("never", "no_answer", "deadline", replicate=r, scan=s)
        for r in (1, 2) for s in (1, 2)]
    run = write(tmp_path, rows)
    contest = contests_of(run)["easy"]
    never = ranked(run)["never"]
    assert never.time.value == pytest.approx(PENALTY_MS)
    assert (never.penalised, never.answered, never.place.value) == (4, 0.0, 2)
    assert curves.profile(contest, [1.0, 1e9])[:, 1].tolist() == [0.0, 0.0]
    assert curves.time_to_gap(contest, 10.0, [1e9])[0, 1] == 1.0 - 1.0
    counts = testing.values(ranking.fates(facts.judged(pool.load([run]).rows)), "never")
    assert counts["timed out"] == 4 and counts["not asked"] == 0


def test_planted_ties_share_a_place(tmp_path):
    rows = [r for name in ("a", "b", "c") for r in windows(name, 0.0, 2.0, 0.0, 1.0)]
    rows += windows("d", 0.0, 2.0, 0.0, 1.0, cpu_ms=9.0)
    found = ranked(write(tmp_path, rows))
    assert [s.place.value for s in found.values()] == [1, 1, 1, 4]
    assert all((s.place.low, s.place.high) == (s.place.value,) * 2 for s in found.values())


def test_noise_within_the_tolerance_decides_nothing(tmp_path):
    rows = windows("slow", 0, 0, cpu_ms=2.0)
    rows += windows("quick", *({"cost_nats": -10.0 + 3e-6, "gap_nats": 3e-6},) * 2)
    run = write(tmp_path, rows)
    found = ranked(run)
    assert list(found) == ["quick", "slow"]
    assert found["quick"].certified_gap.value == 0.0 and found["quick"].certified == 1.0
    assert found["quick"].best_known == 1.0
    assert pairwise.duels(contests_of(run)["easy"])[0].equal == 2


WRONG = {
    "the referee": {"status": "failed", "note": "a row is broken by 1"},
    "claimed optimal": {"status": "optimal", "cost_nats": -9.0},
    "claimed the bound": {"bound_nats": -9.5},
    "below the certified": {"cost_nats": -11.0, "certified_bound_nats": None},
}


@pytest.mark.parametrize("word", WRONG)
def test_a_planted_wrong_answer_disqualifies_and_is_shown(tmp_path, word):
    rows = windows("exact", 0, 0, 0, 0) + windows("good", 0, 1.0, 12.0, 11.0)
    rows += windows("wrong", 0, 0, 0, WRONG[word], cpu_ms=0.01)
    run = write(tmp_path, rows)
    report = rank_report.rank(pool.load([run])).report
    lines = testing.table_of(report, "ranking").rows
    assert [(line[1], line[3], line[4]) for line in lines] == [
        ("1", "exact", 0), ("2", "good", 0), ("out", "wrong", 1)]
    shown = testing.values(testing.table_of(report, "correctness"), "wrong")
    assert "replicate 2" in shown["window"]
    assert word in shown["what is wrong"] or shown["what is wrong"] == WRONG[word].get("note")
    for name in ("pareto", "profiles", "time_to_gap", "scaling", "beats_cost_easy"):
        assert not any("wrong" in line for line in testing.table_of(report, name).rows)
    assert found_gap(run, "good") == 6.0  # a wrong cost moves no gap


def found_gap(run: Path, algorithm: str) -> float:
    return ranked(run)[algorithm].certified_gap.value


def test_the_best_bound_of_any_row_counts(tmp_path):
    rows = [row("exact", certified_bound_nats=None), row("lp", answer="relaxation", lp_gap=0.5),
            row("weak", lp_gap=4.0)]
    found = ranked(write(tmp_path, rows), "hard")
    assert {s.certified_gap.value for s in found.values()} == {0.5}
    assert found["exact"].certified == 0.0 and found["exact"].gap.value == 0.0


def test_windows_of_one_fingerprint_share_their_facts(tmp_path):
    rows = [row("exact", window_k=3, fingerprint="f" * 16),
            row("quick", 1.0, window_k=5, fingerprint="f" * 16, certified_bound_nats=None)]
    judged = facts.judged(pool.load([write(tmp_path, rows)]).rows)
    assert judged["best"].tolist() == judged["bound"].tolist() == [-10.0, -10.0]
    assert judged["window"].tolist() == [0, 1]


def test_easy_hard_open_and_empty_windows_are_kept_apart(tmp_path):
    rows = [row("exact", scan=1), row("exact", scan=2, lp_gap=0.3),
            row("exact", scan=3, certified_bound_nats=None),
            row("exact", scan=4, columns=0, cost_nats=0.0, reference_cost_nats=0.0)]
    found = contests_of(write(tmp_path, rows))
    assert {h: c.windows["scan"].tolist() for h, c in found.items()} == {
        "easy": [1], "hard": [2], "open": [3]}


def test_all_are_compared_on_the_same_windows(tmp_path):
    rows = windows("exact", 0, 0, 0, 0) + windows("some", 0, 0, 0) + windows("rare", 0)
    rows += [unanswered("small", "skipped", "finished", replicate=r, scan=s)
             for r in (1, 2) for s in (1, 2)]
    notes: list[str] = []
    run = write(tmp_path, rows)
    contest = contests_of(run, told=notes)["easy"]
    assert contest.algorithms == ["exact", "some"] and len(contest.windows) == 3
    told = " ".join(notes)
    assert "not ranked, as asked on 1 of 4 windows and declining 0: rare" in told
    assert "not ranked, as asked on 4 of 4 windows and declining 4: small" in told
    assert "1 of 4 windows are left out" in told
    alone = rank_report.rank(pool.load([run]), Selection(algorithms=("small",))).report
    assert any("not ranked" in line and "small" in line for line in alone.lines)
    assert [t.name for t in alone.tables] == ["correctness", "fates"]


def test_declined_windows_cost_the_penalty(tmp_path):
    rows = windows("exact", 0, 0, 0, 0) + windows("small", 0, 0, 0) + [
        unanswered("small", "skipped", "finished", replicate=2, scan=2)]
    found = ranked(write(tmp_path, rows))["small"]
    assert (found.penalised, found.answered, found.proven.value) == (1, 0.75, 0.75)


def test_pairs_by_hand(tmp_path):
    rows = windows("a", 0, 0, 0, 0, 0, 0) + windows("b", 0, 1.0, 0, 2.0, 0, 3.0, cpu_ms=0.5)
    duels = pairwise.duels(contests_of(write(tmp_path, rows))["easy"])
    cost, time = duels
    assert (cost.better, cost.equal, cost.worse, cost.scenes) == (3, 3, 0, 3)
    assert cost.difference == pytest.approx(-1.0)
    assert cost.p == pytest.approx(0.25)  # three scenes, all of one sign: 2 / 8
    assert (time.better, time.equal, time.worse) == (0, 0, 6)
    assert time.difference == pytest.approx((1.0 + SHIFT_MS) / (0.5 + SHIFT_MS))


def test_a_window_that_forbids_doing_nothing_has_an_infinite_gap_without_an_answer(tmp_path):
    common = {"gap_share": None}
    rows = windows("exact", 0, 0, 0, 0, **common) + windows("late", 0, 0, 0, **common)
    rows.append(unanswered("late", "no_answer", "deadline", replicate=2, scan=2))
    run = write(tmp_path, rows)
    found = ranked(run)["late"]
    assert found.gap.value == math.inf and found.place.value == 2
    cost = pairwise.duels(contests_of(run)["easy"])[0]
    assert (cost.better, cost.equal) == (1, 3)


def test_doing_nothing_may_cost_something(tmp_path):
    """Tracks that must go on alone: the share of a gap tells at what cost, here -2."""
    rows = [row("exact"), row("quick", 4.0, gap_share=0.5),
            unanswered("late", "no_answer", "deadline")]
    assert ranked(write(tmp_path, rows))["late"].gap.value == pytest.approx(8.0)


def test_a_crash_is_counted_and_disqualifies_nobody(tmp_path):
    rows = windows("exact", 0, 0) + windows("crash", 0) + [
        unanswered("crash", "failed", "error", scan=2, note="it threw")]
    run = write(tmp_path, rows)
    found = ranked(run)["crash"]
    assert (found.place.value, found.refuted, found.penalised) == (2, 0, 1)
    counts = testing.values(ranking.fates(facts.judged(pool.load([run]).rows)), "crash")
    assert (counts["failed"], counts["refuted"]) == (1, 0)


def test_without_a_time_limit_the_longest_time_is_doubled(tmp_path):
    rows = windows("exact", 0, 0) + windows("crash", 0, cpu_ms=7.0) + [
        unanswered("crash", "failed", "error", scan=2, cpu_ms=1.0)]
    run = write(tmp_path, rows, {"schema_version": 1})
    assert contests_of(run)["easy"].time_ms.tolist() == [[7.0, 1.0], [14.0, 1.0]]
    assert "twice the longest time" in pool.load([run]).about[0]


def test_scenes_not_windows_are_resampled(tmp_path):
    """Repeating every window of a scene many times leaves the interval as it is."""
    def interval(scans: int) -> tuple[float, float]:
        rows = [row(name, gap * (name == "b"), replicate=r, scan=s, fingerprint=f"{r}-{s}")
                for name in ("a", "b") for r, gap in enumerate((0.0, 1.0, 5.0, 2.0), start=1)
                for s in range(1, scans + 1)]
        found = ranked(write(tmp_path, rows))["b"].certified_gap
        return found.low, found.high

    assert interval(1) == pytest.approx(interval(30))


def test_the_whole_study_holds_together(tmp_path):
    found = contests_of(write(tmp_path, study()))
    assert set(found) == {"easy", "hard"}
    for contest in found.values():
        shape = (len(contest.windows), len(contest.algorithms))
        assert contest.gap.shape == contest.time_ms.shape == shape
        assert (contest.gap >= 0).all() and (contest.certified_gap >= contest.gap - 1e-9).all()
        ladder = curves.profile(contest, curves.FINE_RATIOS)
        assert (np.diff(ladder, axis=0) >= 0).all() and ladder.max() <= 1.0
        assert ladder[0].sum() >= contest.reached.any(axis=1).mean() - 1e-9
