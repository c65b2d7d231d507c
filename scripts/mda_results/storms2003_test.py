"""Storms & Spieksma's tables on runs small enough to count by hand."""

import math

import numpy as np
import pytest

from mda_results import cells
from mda_results.render import Report, to_text
from mda_results.testing import fractional, full_size, hand_made, report_of, row, table_of, values


def test_scenario_tables_hold_what_was_counted_by_hand(write):
    table = table_of(report_of(write(hand_made())), "table_2")
    expected = {
        (1, "R"): (2, 0), (1, "Δ"): (2.25, None), (1, "O"): (-120.5, -10.0),
        (2, "R"): (1, 2), (2, "Δ"): (0, 0.75), (2, "O"): (-17.0, -10.0),
    }
    for key, (k3, k4) in expected.items():
        line = values(table, *key)
        for header, value in (("ours K=3", k3), ("ours K=4", k4)):
            if value is None:
                assert line[header] is None or math.isnan(line[header])
            else:
                assert line[header] == pytest.approx(value, abs=1e-9)
    assert values(table, 7, "Δ")["published K=3"] == 3.37
    assert values(table, 3, "R")["ours K=3"] is None  # no such replicate


def test_parameters_stand_beside_the_published_ones(write):
    table = table_of(report_of(write(hand_made())), "table_1")
    line = values(table, "false alarms per scan")
    assert [line[f"published {g}"] for g in "ABCD"] == ["1", "5", "25", "2"]
    assert [line[f"ours {g}"] for g in "ABCD"] == ["5", None, None, None]
    line = values(table, "missed detections in a row allowed (p)")
    assert (line["published A"], line["ours A"], line["ours B"]) == ("2", "3", None)
    assert values(table, "density")["ours A"] == "literal"
    assert values(table, "K")["ours A"] == "3 4"


def test_per_scenario_tables_print_the_papers_scenarios_and_summaries_use_all(write):
    rows = [row(replicate=r, scan=s) for r in range(1, 13) for s in (1, 2)]
    report = report_of(write(rows))
    table = table_of(report, "table_2")
    assert {line[0] for line in table.rows} == set(range(1, 11))
    assert any("first 10 of 12" in note for note in table.notes)
    assert values(table_of(report, "integrality"), "A", "3")["ours windows"] == 24


def test_other_scenarios_and_scan_periods_are_left_out_and_told(write):
    rows = hand_made() + [row(scenario="crossing"), row(scan_period_s=2.0)]
    report = report_of(write(rows))
    assert any("Left out: 2 rows" in line for line in report.lines)
    plain = report_of(write(hand_made()))
    assert to_text(Report("", [], report.tables)) == to_text(Report("", [], plain.tables))




def test_rounding_shares_are_those_counted_by_hand(write):
    report = report_of(write(hand_made()))
    line = values(table_of(report, "rounding"), "A", "all")
    # Five fractional windows; gaps 0.5, 2.25, 0 (3e-6), 0, 0.75. Only cell (2, K = 3) is all zero.
    assert line["optimal windows % ours"].value == pytest.approx(100 * 2 / 5)
    assert line["in cells with Δ = 0, % ours"].value == pytest.approx(100 * 1 / 5)
    assert line["mean Δ ours"] == pytest.approx(3.5 / 5)
    assert line["max Δ ours"] == 2.25
    line = values(table_of(report, "integrality"), "A", "all")
    assert (line["ours windows"], line["ours fractional"]) == (12, 5)
    assert line["ours integral %"].value == pytest.approx(100 * 7 / 12)


def test_mean_optimum_and_true_tracks(write):
    line = values(table_of(report_of(write(hand_made())), "optimum"), "A", "3")
    assert line["mean O ours"].value == pytest.approx((-120.5 - 17.0) / 2)
    assert line["mean O published"].value == pytest.approx(-19325.704 / 10)
    assert line["O above V_T scenarios"] == 0 and line["O above V_T of"] == 2


def test_published_totals_are_the_papers(write):
    report = report_of(write(full_size()))
    integrality = table_of(report, "integrality")
    expected = {"A": (98, 93.5), "B": (117, 92.2), "C": (60, 96.0), "A-C": (275, 93.9)}
    for group, (count, percent) in expected.items():
        line = values(integrality, group, "all")
        assert line["published fractional"] == count
        assert round(line["published integral %"].value, 1) == percent
    line = values(integrality, "D", "3")
    assert (line["published fractional"], line["published windows"]) == (66, 150)
    paper = cells.published()
    paper = paper[paper["group"] != "D"]
    assert (paper["in_zero_cell"].sum(), paper["fractional"].sum()) == (195, 275)
    line = values(table_of(report, "rounding"), "A-C", "all")
    assert line["in cells with Δ = 0, % published"].value == pytest.approx(100 * 195 / 275)
    assert line["optimal windows % published"] is None  # not printed in the paper
    line = values(table_of(report, "rounding"), "D", "3")
    assert line["mean Δ publ."] == pytest.approx(2.15, abs=0.005)
    assert line["optimal windows % published"].value == pytest.approx(100 * 9 / 66)


def test_published_tables_agree_with_each_other():
    paper, windows = cells.published(), cells.published_windows()
    d = paper[paper["group"] == "D"].reset_index(drop=True)
    per_scenario = windows.groupby("scenario")["gap_delta"]
    assert list(per_scenario.size()) == list(d["fractional"])
    assert np.allclose(per_scenario.max(), d["gap_max"])


def test_totals_need_all_three_groups(write):
    without_c = [r for r in full_size() if r["scenario"] != "C"]
    report = report_of(write(without_c))
    assert not any(line[0] == "A-C" for line in table_of(report, "integrality").rows)
    assert any(line == "Not in this run: group C." for line in report.lines)
    assert all(t.name != "table_4" for t in report.tables)


def test_windows_without_an_answer_are_not_counted_as_integral(write):
    rows = hand_made()
    rows[0].update(status="failed", stop="error", integral=None, gap_nats=None, cost_nats=None)
    rows[1].update(status="failed", gap_nats=-3.0)  # refuted: its R and gap do not count
    report = report_of(write(rows))
    table = table_of(report, "integrality")
    line = values(table, "A", "3")
    assert (line["ours windows"], line["ours fractional"]) == (4, 2)
    assert any("Left out: 2 windows" in note for note in table.notes)
    assert values(table_of(report, "rounding"), "A", "3")["mean Δ ours"] == pytest.approx(2.25 / 2)


def test_an_unknown_gap_makes_no_zero_cell(write):
    rows = hand_made()
    rows[3] = fractional(0.0, replicate=2, scan=1)
    rows[4]["gap_nats"] = None
    line = values(table_of(report_of(write(rows)), "rounding"), "A", "3")
    assert line["in cells with Δ = 0, % ours"].value == 0.0
