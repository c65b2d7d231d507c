"""Time to a proven optimum, on hand-made rows."""

import pytest

from mda_results import certified
from mda_results.rows import RunError, load_run
from mda_results.testing import MANIFEST, row, table_of, values, write_run

_MANIFEST = {**MANIFEST, "sweep": {"name": "small", "seed": 1, "time_limit_s": 10.0}}


def _run(tmp_path, rows):
    return load_run(write_run(tmp_path / "run", rows, _MANIFEST))


def _window(scan, ours_ms, exact_ms, lp_ms, integral=True, **ours):
    return [row("tree-exact", scan=scan, cpu_ms=ours_ms, **ours),
            row("exact", scan=scan, cpu_ms=exact_ms),
            row("lp", scan=scan, cpu_ms=lp_ms, integral=integral, answer="relaxation",
                fractional=0 if integral else 4, cost_nats=-10.0 if integral else -10.5)]


def test_the_best_is_found_window_by_window_and_an_lp_counts_where_it_is_integral(tmp_path):
    run = _run(tmp_path, [*_window(1, 1.0, 4.0, 2.0),
                          *_window(2, 1.0, 4.0, 2.0, integral=False)])
    line = values(table_of(certified.report(run), "ratios"), "A", "3")
    assert line["windows"] == 2
    assert line["best / tree-exact least"] == pytest.approx(2.0)
    assert line["best / tree-exact PAR-2"] == pytest.approx(3.0)
    assert line["won [%]"] == 100


def test_who_proves_nothing_is_charged_twice_the_limit(tmp_path):
    run = _run(tmp_path, [*_window(1, 3.0, 4.0, 8.0, status="feasible", stop="deadline"),
                          *_window(2, 1.0, 4.0, 8.0)])
    report = certified.report(run)
    line = values(table_of(report, "ratios"), "A", "3")
    assert line["proven [%]"] == 50
    assert line["tree-exact [ms] largest"] == 20000
    assert line["best / tree-exact least"] == pytest.approx(4.0 / 20000)
    losses = table_of(report, "losses")
    assert len(losses.rows) == 1
    assert "1 of 2 windows lost" in losses.notes[0]


def test_the_gap_of_the_lp_tells_how_hard_windows_are(tmp_path):
    run = _run(tmp_path, [*_window(1, 1.0, 4.0, 2.0),
                          *_window(2, 1.0, 4.0, 2.0, integral=False)])
    line = values(table_of(certified.report(run), "hardness"), "A", "3")
    assert line["integral [%]"] == 50
    assert line["LP gap [%] largest"] == pytest.approx(5.0)


def test_windows_are_told_apart_by_the_gap_of_their_lp(tmp_path):
    run = _run(tmp_path, [*_window(1, 1.0, 4.0, 2.0), *_window(2, 1.0, 4.0, 3.0),
                          *_window(3, 1.0, 40.0, 2.0, integral=False),
                          row("cg-lp", scan=3, answer="relaxation", cost_nats=-10.5)])
    gaps = table_of(certified.report(run), "gaps")
    assert values(gaps, "A", "none")["windows"] == 2
    assert values(gaps, "A", "none")["best / tree-exact median"] == pytest.approx(2.5)
    assert values(gaps, "A", "above 1")["best / tree-exact PAR-2"] == pytest.approx(40.0)


def test_without_the_lp_nothing_is_said_of_hardness(tmp_path):
    rows = [line for line in _window(1, 1.0, 4.0, 2.0) if line["algorithm"] != "lp"]
    tables = certified.report(_run(tmp_path, rows)).tables
    assert [table.name for table in tables] == ["ratios", "losses"]


def test_the_report_tells_that_short_solves_were_repeated(tmp_path):
    rows = _window(1, 1.0, 4.0, 2.0)
    sweep = {**_MANIFEST["sweep"], "repeats": 3}
    run = load_run(write_run(tmp_path / "repeated", rows, {**_MANIFEST, "sweep": sweep}))
    assert "the fastest of 3." in certified.report(run).lines[0]
    assert "Solves below" not in certified.report(_run(tmp_path, rows)).lines[0]


def test_only_windows_that_all_solvers_have_a_time_for_are_compared(tmp_path):
    rows = [*_window(1, 1.0, 4.0, 2.0), *_window(2, 50.0, 70.0, 60.0)]
    rows = [line for line in rows if (line["scan"], line["algorithm"]) != (2, "tree-exact")]
    report = certified.report(_run(tmp_path, rows))
    line = values(table_of(report, "ratios"), "A", "3")
    assert line["windows"] == 1
    assert line["best [ms] mean"] == pytest.approx(2.0)
    assert report.lines[-1].startswith("1 windows left out")


def test_a_run_without_times_is_refused(tmp_path):
    with pytest.raises(RunError, match="no window"):
        certified.report(_run(tmp_path, _window(1, None, 4.0, 2.0)))


def test_relaxations_that_did_not_finish_tell_nothing_of_hardness(tmp_path):
    rows = _window(1, 1.0, 4.0, 2.0)
    rows[-1].update(status="no_answer", stop="deadline", cost_nats=None)
    tables = certified.report(_run(tmp_path, rows)).tables
    assert [table.name for table in tables] == ["ratios", "losses"]


def test_a_run_without_the_certified_solver_is_refused(tmp_path):
    with pytest.raises(RunError, match="tree-exact"):
        certified.report(_run(tmp_path, [row("exact")]))
