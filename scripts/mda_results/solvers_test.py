"""Counts, agreement and times of algorithms."""

import pytest

from mda_results.testing import fractional, hand_made, report_of, row, table_of, values


@pytest.mark.parametrize("difference, beyond", [(5e-6, 0), (2e-5, 1)])
def test_agreement(write, difference, beyond):
    rows = hand_made()[:3]
    rows += [row("cbc", scan=s) for s in (1, 2, 3)]
    rows += [row("exact", scan=1), row("exact", scan=2, cost_nats=-10.0 - difference),
             row("exact", scan=3, status="feasible", stop="deadline", cost_nats=-1.0)]
    table = table_of(report_of(write(rows)), "agreement")
    line = values(table, 3)
    assert (line["both optimal"], line["beyond 1e-5 nats"]) == (2, beyond)
    assert line["largest difference [nats]"] == pytest.approx(difference, rel=1e-6)
    assert ("DISAGREE" in table.notes[0]) == bool(beyond)


def test_agreement_says_what_is_absent(write):
    table = table_of(report_of(write(hand_made() + [row("cbc")])), "agreement")
    assert "no rows of exact" in table.notes[0]


def test_every_row_is_counted(write):
    fates = [("optimal", "finished"), ("feasible", "deadline"), ("no_answer", "deadline"),
             ("failed", "error"), ("failed", "finished"), ("skipped", "finished"),
             ("feasible", "iteration_limit")]
    rows = [row(scan=s) for s in range(1, 11)]
    rows += [row("cbc", scan=s, status=status, stop=stop)
             for s, (status, stop) in enumerate(fates, start=1)]
    line = values(table_of(report_of(write(rows)), "row_counts"), "cbc")
    assert list(line.values()) == ["cbc", 10, 3, 7, 1, 2, 1, 2, 1, 1, 2, 1]


def test_times_and_paired_ratio(write):
    rows = [row(scan=s) for s in (1, 2, 3)]
    rows += [row("cbc", scan=1, cpu_ms=2.0, wall_ms=2.1),
             row("cbc", scan=2, cpu_ms=8.0, wall_ms=20.0),
             row("cbc", scan=3, cpu_ms=500.0, status="failed")]
    rows += [row("exact", scan=1, cpu_ms=1.0), row("exact", scan=2, cpu_ms=1.0),
             row("exact", scan=3, cpu_ms=4.0)]
    report = report_of(write(rows))
    line = values(table_of(report, "times"), "cbc", "A")
    assert (line["windows"], line["finished"], line["wall over 1.2 CPU"]) == (3, 2, 1)
    assert line["CPU total [s]"] == pytest.approx(0.010)
    assert line["CPU geo. mean [ms]"] == pytest.approx(4.0)
    line = values(table_of(report, "time_ratio"), "A")
    assert line["windows"] == 2
    assert line["geometric mean"].value == pytest.approx(4.0)
    assert line["ratio of totals"] == pytest.approx(5.0)


def test_group_d_is_compared_as_a_distribution(write):
    rows = [fractional(g, scenario="D", scan=s, cpu_ms=2.0) for s, g in ((1, 0.0), (2, 3.0))]
    rows += [row("cbc", scenario="D", scan=s, cpu_ms=ms) for s, ms in ((1, 2.0), (2, 6.0))]
    lines = {r[0].strip(): r[1:] for r in table_of(report_of(write(rows)), "tables_6_and_7").rows}
    assert lines["fractional windows"] == [66, 2]
    assert lines["mean Δ [nats]"] == [pytest.approx(2.15, abs=0.005), 1.5]
    assert lines["Δ = 0 [%]"] == [pytest.approx(100 * 9 / 66), 50.0]
    assert lines["median"] == [pytest.approx(1.135), 2.0]
    assert lines["at least 1.5 [%]"][1] == 50.0
