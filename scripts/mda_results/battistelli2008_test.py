"""Tables of the study over known targets, from hand-made runs."""

import json
import random
from pathlib import Path
from typing import Any

import pytest

import tables
from mda_results import battistelli2008, known_testing, testing
from mda_results.known_testing import open_row, outing, skipped, write_known
from mda_results.render import Estimate, Report, to_text
from mda_results.rows import RunError
from mda_results.testing import table_of, values


@pytest.fixture
def report_of(tmp_path: Path):
    def report(rows: list[dict], outings: list[dict], **options: Any) -> Report:
        return battistelli2008.report(write_known(tmp_path / "run", rows, outings, **options))[0]

    return report


def test_gaps_by_hand(report_of):
    rows = [open_row("scf", scan=4, gap_nats=0.0, off_column_paths=2, cpu_ms=1.0,
                     certified_bound_nats=-103.0),
            open_row("scf", scan=5, gap_nats=0.5, cpu_ms=3.0, views_ms=0.75),
            open_row("scf", scan=6, status="skipped", note="too large"),
            open_row("scf", scan=7, status="failed", cost_nats=None, gap_nats=None),
            open_row("lp", scan=4)]
    report = report_of(rows, [])
    found = values(table_of(report, "open_battistelli-1"), "3", "scf")
    assert found["mean gap [nats]"].value == 0.25
    assert found["percent optimal"] == 50.0 and found["gap worst"] == 0.5
    assert found["percent certified"] == 50.0 and found["gap certified"] == 3.0
    assert found["off col."] == 1.0
    assert (found["CPU [ms] solve"], found["CPU [ms] views"]) == (2.0, 0.5)
    assert (found["n"], found["skip"], found["fail"]) == (2, 1, 1)
    relaxed = values(table_of(report, "open_battistelli-1"), "3", "lp")
    assert relaxed["n"] == 1 and relaxed["mean gap [nats]"] is None
    assert relaxed["percent LP int."] == 100.0
    assert values(table_of(report, "open_fates"), "scf", "skipped")["reason of the first"] == (
        "too large")


def test_tolerance_grows_with_the_cost(report_of):
    rows = [open_row("scf", scan=4, gap_nats=5e-4, cost_nats=-1e6),
            open_row("scf", scan=5, gap_nats=5e-4, cost_nats=-1e3)]
    found = values(table_of(report_of(rows, []), "open_battistelli-1"), "3", "scf")
    assert found["percent optimal"] == 50.0


def test_sizes_count_windows_once_and_first_windows_by_their_scans(report_of):
    rows = [open_row(a, scenario="battistelli-2", k=3, scan=s)
            for a in ("scf", "sd-exact") for s in (1, 4)]
    rows += [{**r, "algorithm": "mcf", "graph_nodes": 900} for r in rows if r["scan"] == 4]
    found = values(table_of(report_of(rows[:-1], []), "open_sizes"), "battistelli-2", 3)
    assert found["SCF nodes"] == (21 + 55) / 2 and found["MCF nodes"] == 900
    assert found["windows"] == 2 and found["T"] == 3 and found["M"] == 14.0
    assert found["SCF (M+T)K"] == 17.0 * (1 + 3) / 2
    assert found["SCF (M+T)^2 K"] == 17.0**2 * (1 + 3) / 2
    assert found["columns T (M+1)^K"] == 3 * (15.0 + 15.0**3) / 2


def test_graphs_are_found_on_the_rows_that_have_them(report_of):
    rows = [open_row("cbc", graph_nodes=None, graph_arcs=None), open_row("scf")]
    assert values(table_of(report_of(rows, []), "open_sizes"), "battistelli-1", 3)["SCF arcs"] > 0


def test_closed_loop_by_hand(report_of):
    outings = [outing(replicate=1, position_error_m=50.0), outing(replicate=2, lost_at_end=0.5),
               outing(replicate=3, status="failed", position_error_m=1e9, unanswered=4),
               skipped(outing("mcf"))]
    report = report_of([], outings)
    positions = values(table_of(report, "closed_positions"), "battistelli-2", "sd-exact", "3")
    assert positions["n"] == 2 and positions["d [m]"].value == 55.0
    assert positions["d [m] ideal"] == 40.0 and positions["DE [m] from ideal"].value == 30.0
    association = values(table_of(report, "closed_association"), "battistelli-2", "sd-exact", "3")
    assert association["lost tracks [%] at end"].value == pytest.approx(31.25)
    assert association["CPU [ms/scan] solve"] == 0.5
    fates = values(table_of(report, "closed_fates"), "sd-exact")
    assert (fates["outings"], fates["finished"], fates["failed"]) == (3, 2, 1)
    assert fates["windows without an answer"] == 4
    assert values(table_of(report, "closed_fates"), "mcf")["skipped"] == 1


def test_differences_of_equal_algorithms_are_zero(report_of):
    draw = random.Random(2)
    outings = []
    for replicate in range(1, 9):
        errors = {"position_error_m": draw.uniform(50, 90), "right_share": draw.random()}
        outings += [outing(a, replicate=replicate, **errors) for a in ("sd-exact", "scf")]
        errors["position_error_m"] -= 5.0
        outings.append(outing("mcf", replicate=replicate, **errors))
    table = table_of(report_of([], outings), "closed_paired")
    same = values(table, "battistelli-2", "scf", "3")
    assert all(same[f"difference {name}"] == Estimate(0.0, 0.0, 0.0)
               for name in ("d [m]", "DE [m]", "L [points]", "lost at end [points]"))
    better = values(table, "battistelli-2", "mcf", "3")["difference d [m]"]
    assert better.value == better.low == better.high == pytest.approx(-5.0)


def test_pairs_are_of_the_same_runs(report_of):
    outings = [outing(replicate=1), outing("scf", replicate=1, position_error_m=70.0),
               outing("scf", replicate=2, position_error_m=1e6)]
    found = values(table_of(report_of([], outings), "closed_paired"), "battistelli-2", "scf", "3")
    assert found["n"] == 1 and found["difference d [m]"].value == 10.0


def test_single_scan_algorithms_are_compared_too(report_of):
    outings = [outing(), outing(k=1), outing("gnn", k=1)]
    lines = table_of(report_of([], outings), "closed_positions").rows
    assert [line[1:3] for line in lines] == [["gnn", "1"], ["sd-exact", "3"]]


def test_windows_and_figure_9_by_hand(report_of):
    outings = [outing("scf-tie", k=k, position_error_m=60.0 - 5 * k) for k in (1, 2)]
    outings += [outing("mcf", "battistelli-2-res4", period=t, distance_error_m=10 * t)
                for t in (1.0, 10)]
    report = report_of([], outings)
    found = values(table_of(report, "closed_windows"), "battistelli-2", "scf-tie", "2")
    assert found["d - d(K=1) [m]"].value == -5.0
    assert values(table_of(report, "figure_9"), "mcf", 4.0, 10.0)["DE [m]"].value == 100.0


def test_shares_are_shares(report_of):
    pair = ["battistelli-1", "battistelli-2"]
    report = report_of(known_testing.study_rows(2, 2, pair), known_testing.study_outings(2, pair))
    checked = 0
    for table in report.tables:
        shares = [j for j, c in enumerate(table.columns)
                  if "%" in c.full_header or "percent" in c.full_header]
        for cell in (row[j] for row in table.rows for j in shares):
            if isinstance(cell, Estimate):
                assert 0 <= cell.low <= cell.value <= cell.high <= 100
            else:
                assert cell is None or not 0 > cell and not cell > 100
            checked += 1
    assert checked > 300
    assert max(map(len, to_text(Report("", [], report.tables[:-2])).splitlines())) <= 130


def test_order_does_not_matter(report_of):
    rows = known_testing.study_rows(2, 1, ["battistelli-2"])
    outings = known_testing.study_outings(2, ["battistelli-2"])
    text = to_text(report_of(rows, outings))
    random.Random(1).shuffle(rows)
    random.Random(2).shuffle(outings)
    assert to_text(report_of(rows, outings)) == text


def test_missing_parts_are_named(report_of):
    only_open = report_of([open_row(scenario="battistelli-2")], [])
    told = " ".join(only_open.lines)
    assert "part (b)" in told and "part (c)" in told
    assert "battistelli-1-dense, battistelli-1-wide, battistelli-2-radial of part (a)" in told
    assert not any(t.name.startswith("closed") for t in only_open.tables)
    only_closed = report_of([], [outing("scf-tie", "battistelli-2-res4")])
    assert "Not in this run: part (a), open loop." in only_closed.lines
    assert [t.name for t in only_closed.tables] == ["figure_9", "claims_rules", "claims"]


def test_plans_that_were_not_met_are_told(report_of):
    plan = {"scenario": "battistelli-2", "loop": "closed", "windows": [3, 4], "replicates": 2,
            "scan_periods_s": [2], "algorithms": ["sd-exact"], "every": 1}
    about = {**known_testing.manifest(), "sweep": {"plans": [plan]}}
    outings = [outing(replicate=1), outing(replicate=2), outing(k=4)]
    told = " ".join(report_of([], outings, about=about).lines)
    assert "1 of 2 entries in closed loop" in told and "K = 4, sd-exact: 1 of 2" in told
    met = report_of([], [*outings, skipped(outing(k=4, replicate=2))], about=about)
    assert "Planned" not in " ".join(met.lines)


def test_a_torn_last_line_is_told(tmp_path, capsys):
    run = write_known(tmp_path / "run", [open_row()], [outing()], tail='{"schema')
    assert tables.main(["battistelli2008", str(run)]) == 0
    assert "tracking.jsonl:2: the last line is torn" in capsys.readouterr().err


def refused(capsys: pytest.CaptureFixture[str], name: str, run: Path, expected: str) -> None:
    assert tables.main([name, str(run)]) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1
    assert expected in printed.err


@pytest.mark.parametrize(("change", "expected"), [
    ({"position_error_m": "60"}, "position_error_m is no number"),
    ({"cpu_ms": None}, "cpu_ms is no number"), ({"scans": True}, "scans is no number"),
    ({"scan_period_s": "2"}, "scan_period_s is not of type float"),
    ({"replicate": 1.5}, "replicate is not of type int"), ({"lost_ever": 1.5}, "is no share"),
    ({"status": "great"}, "unknown status: great"), ({"schema_version": 2}, "schema version"),
    ({"right_series": [0.9]}, "one entry per scan"), ({"right_series": 1}, "one entry per scan"),
    ({"oracle_series_m": [None] * 8}, "no number"), ({"scans": 0}, "without scans"),
])
def test_wrong_outings_are_refused(tmp_path, capsys, change, expected):
    run = write_known(tmp_path / "run", [], [outing("scf"), outing(**change)])
    refused(capsys, "battistelli2008", run, f"{expected}")


@pytest.mark.parametrize("field", ["algorithm", "ideal_series_m", "hypotheses_cpu_ms"])
def test_absent_fields_are_named(tmp_path, capsys, field):
    line = outing()
    del line[field]
    run = write_known(tmp_path / "run", [], [line])
    refused(capsys, "battistelli2008", run, f"tracking.jsonl:1: the line has no field '{field}'")


def test_a_scene_shorter_than_the_window_has_no_lagged_error(report_of):
    found = table_of(report_of([], [outing(position_error_lagged_m=None)]), "closed_positions")
    assert "—" in to_text(Report("", [], [found]))


@pytest.mark.parametrize("plans", [
    {"a": 1}, [1], [{"scenario": "battistelli-1"}],
    [{"scenario": "battistelli-1", "loop": "open", "windows": ["3"], "replicates": 1,
      "scan_periods_s": [5], "algorithms": ["scf"]}],
])
def test_wrong_plans_are_refused(tmp_path, capsys, plans):
    about = {**known_testing.manifest(), "sweep": {"plans": plans}}
    run = write_known(tmp_path / "run", [open_row()], [], about)
    refused(capsys, "battistelli2008", run, "plan")


def test_outings_that_are_there_twice_are_refused(tmp_path, capsys):
    run = write_known(tmp_path / "run", [], [outing(), outing()])
    refused(capsys, "battistelli2008", run, "two outings of sd-exact on battistelli-2")


def test_runs_of_others_are_refused(tmp_path, capsys):
    run = testing.write_run(tmp_path / "run", testing.hand_made())
    refused(capsys, "battistelli2008", run, "no rows and no outings of scenarios battistelli-*")
    refused(capsys, "battistelli2008", tmp_path / "absent", "no run directory")
    run = write_known(tmp_path / "known", [], [outing()])
    refused(capsys, "tracking", run, "of scenarios with tables of their own")


def test_tables_of_storms2003_leave_these_rows_out(tmp_path):
    run = testing.write_run(tmp_path / "run", testing.hand_made())
    before = testing.report_of(run)
    run = testing.write_run(tmp_path / "run", [*testing.hand_made(), open_row(driver="exact")])
    after = testing.report_of(run)
    assert [to_text(Report("", [], [t])) for t in after.tables] == [
        to_text(Report("", [], [t])) for t in before.tables]
    assert "Left out: 1 rows" in " ".join(after.lines)


def test_damaged_rows_are_refused(tmp_path):
    run = write_known(tmp_path / "run", [open_row(graph_nodes="many")], [outing()])
    with pytest.raises(RunError, match="graph_nodes is \"many\", not of type integer"):
        battistelli2008.report(run)
    (run / "manifest.json").write_text(json.dumps([]))
    with pytest.raises(RunError):
        battistelli2008.report(run)
