"""Tables over position targets, from hand-made runs."""

import math
import random
from pathlib import Path
from typing import Any

import pytest

import tables
from mda_results import lee1998, lee_tables, position_targets, testing
from mda_results.position_testing import (open_row, outing, per_target, skipped, study,
                                          write_position)
from mda_results.render import Report, to_text
from mda_results.rows import RunError
from mda_results.testing import table_of, values

FEW = ("oracle", "gnn", "mapada", "hnpda", "jpda")


@pytest.fixture
def report_of(tmp_path: Path):
    def report(outings: list[dict], *others: list[dict], **options: Any) -> Report:
        runs = [write_position(tmp_path / "run", outings, **options)]
        runs += [write_position(tmp_path / f"run_{n}", o) for n, o in enumerate(others, start=2)]
        return lee1998.report(runs)[0]

    return report


def squares(*position: float, **changes: Any) -> dict[str, Any]:
    """Sums of squared position errors of the tracks, and other fields."""
    return {"position_squares_km2": list(position), **changes}


def test_rms_errors_by_hand(report_of):
    kept = {"maintained_450m": [True, False], "maintained_750m": [True, True]}
    outings = [outing(replicate=1, **squares(0.08, 0.72, **kept)),
               outing(scene="parallel", replicate=1, **squares(0.24, 0.56))]
    found = values(table_of(report_of(outings), "table_3_position_normal"), 0.2, "mapada", "soft")
    assert found["filtered kept tracks"].value == pytest.approx(
        math.sqrt((0.08 + 0.24 + 0.56) / (3 * 8)))
    assert found["filtered all tracks"].value == pytest.approx(
        math.sqrt((0.08 + 0.72 + 0.24 + 0.56) / (4 * 8)))
    assert found["predicted all"] == pytest.approx(math.sqrt(0.32 / 8))
    assert found["paper rms"] == 0.13
    assert found["paper kept diff."] == found["filtered kept tracks"].value - 0.13
    velocity = values(table_of(report_of(outings), "table_3_velocity_normal"), 0.2, "mapada")
    assert velocity["filtered all tracks"].value == pytest.approx(math.sqrt(0.0032 / 8))


def test_rms_errors_are_pooled_by_scans(report_of):
    longer = outing(replicate=2, scans=4, **squares(0.36, 0.36, **per_target(
        2, position_error_series_km=[0.3] * 4, velocity_error_series_km_s=[0.1] * 4,
        track_series_km=[[0.0, 0.0]] * 4)))
    found = values(table_of(report_of([outing(replicate=1), longer]), "table_3_position_normal"),
                   0.2, "mapada")
    assert found["filtered all tracks"].value == pytest.approx(math.sqrt((0.16 + 0.72) / 24))


def test_maintenance_by_hand(report_of):
    lost = {"maintained_450m": [False, True], "maintained_750m": [True, True]}
    gone = {"maintained_450m": [False, False], "maintained_750m": [False, True],
            "dropped": [True, False]}
    outings = [outing("hnpda", replicate=1, **lost), outing("hnpda", replicate=2),
               outing("hnpda", "parallel", 1, **gone), outing("hnpda", "parallel", 2, swaps=1),
               skipped(outing("hnpda", "parallel", 3), "failed", "scan 9: no determinant")]
    report = report_of(outings)
    found = values(table_of(report, "table_3_kept_normal"), 0.2, "hnpda", "soft")
    assert found["0.45 km kept [%]"].value == 62.5 and found["0.75 km kept [%]"] == 87.5
    assert found["0.45 km paper"] == 84 and found["0.45 km diff."] == -21.5
    assert found["dropped [%]"] == 12.5 and (found["runs"], found["failed"]) == (4, 1)
    apart = values(table_of(report, "scenes_normal"), 0.2, "hnpda")
    assert apart["crossing: kept [%] 0.45"] == 75 and apart["parallel: kept [%] 0.45"] == 50
    assert apart["parallel, per 100 runs swaps"] == 50
    assert apart["crossing, per 100 runs swaps"] == 0
    fates = values(table_of(report, "fates"), "hnpda", "soft")
    assert (fates["outings"], fates["finished"], fates["failed"]) == (5, 4, 1)
    assert "no determinant" in fates["note of the first skipped or failed"]


def test_standard_errors_take_both_tracks_of_a_run_together(report_of):
    draw = random.Random(3)
    together, alone = [], []
    for replicate in range(1, 201):
        both = draw.random() < 0.7
        together.append(outing("gnn", replicate=replicate, maintained_450m=[both, both]))
        alone.append(outing("gnn", replicate=replicate,
                            maintained_450m=[draw.random() < 0.7, draw.random() < 0.7]))
    for outings, independent in ((together, 200), (alone, 400)):
        found = values(table_of(report_of(outings), "table_3_kept_normal"), 0.2, "gnn")
        share = found["0.45 km kept [%]"].value / 100
        expected = 100 * math.sqrt(share * (1 - share) / independent)
        assert found["0.45 km s.e."] == pytest.approx(expected, rel=0.15)


def test_both_clutter_models_are_shown_and_one_is_called_fitted(report_of):
    report = report_of(study(2, FEW, (0.2,)))
    titles = {t.name: t.title for t in report.tables}
    assert "fitted" in titles["table_3_kept_normal"]
    assert "fitted" not in titles["table_3_kept_uniform"]
    assert [r[0] for r in table_of(report, "table_4_kept_450m").rows] == (
        ["paper"] * 2 + ["normal"] * 5 + ["uniform"] * 5)


def test_table_4_by_hand(report_of):
    kept = [True] * 7 + [False, True, True]
    errors = squares(*[0.08] * 7, 9.0, 0.32, 0.08)
    outings = [outing("mapada", "ten", r, maintained_450m=kept, **errors) for r in (1, 2)]
    outings.append(outing("mapada", "ten", 3, **squares(*[0.08] * 10)))
    report = report_of(outings)
    share = values(table_of(report, "table_4_kept_450m"), "normal", "mapada")
    assert share["target 8"] == pytest.approx(100 / 3) and share["target 9"] == 100
    assert share["all"] == pytest.approx(100 * 28 / 30)
    error = values(table_of(report, "table_4_position"), "normal", "mapada")
    assert error["target 8"] == pytest.approx(0.1)
    assert error["target 9"] == pytest.approx(math.sqrt((0.32 * 2 + 0.08) / 24))
    paper = values(table_of(report, "table_4_velocity"), "paper", "hnpda")
    assert paper["target 7"] == 0.31 and paper["target 8"] is None


def test_costs_by_hand(report_of):
    outings = [outing(replicate=1, conflict_rate=0.5, iterations_per_scan=10.0, cpu_ms=0.8),
               outing(replicate=2, conflict_rate=0, iterations_per_scan=30.0, cpu_ms=0.0),
               outing("gnn", "ten", conflict_rate=0.125)]
    table = table_of(report_of(outings), "costs")
    found = values(table, "normal", "mapada")
    assert found["scans with a conflict [%] 0.2"] == 25
    assert found["iterations per scan 0.2"] == 20 and found["CPU [ms/scan] 0.2"] == 0.05
    assert found["CPU [ms/scan] 0.4"] is None
    other = values(table, "normal", "gnn")
    assert other["scans with a conflict [%] ten"] == 12.5
    assert other["iterations per scan ten"] is None


def test_open_loop_by_hand(report_of):
    rows = [open_row(gap_nats=0.0, cpu_ms=1.0), open_row(scan=8, gap_nats=1.0, cpu_ms=3.0),
            open_row(scan=12, status="failed", gap_nats=None),
            open_row("jpda", status="feasible", gap_nats=None, certified_bound_nats=None)]
    table = table_of(report_of([], rows=rows), "open_loop")
    found = values(table, "lee-crossing", "gnn")
    assert found["mean gap [nats]"].value == 0.5 and found["worst"] == 1.0
    assert found["optimal [%]"] == 50 and found["CPU [ms] solve"] == 2.0
    assert (found["n"], found["skip"], found["fail"]) == (2, 0, 1)
    marginals = values(table, "lee-crossing", "jpda")
    assert marginals["n"] == 1 and marginals["mean gap [nats]"] is None
    assert marginals["certified [%]"] == 0


def test_order_does_not_matter(report_of):
    outings = study(2, FEW, (0.2, 0.8))
    text = to_text(report_of(outings))
    random.Random(1).shuffle(outings)
    assert to_text(report_of(outings)) == text


def test_two_updates_are_shown_beside_each_other_and_choices_once(report_of):
    soft = [outing(a, replicate=r) for a in ("gnn", "jpda") for r in (1, 2)]
    hard = [{**line, "update": "hard"} for line in soft if line["replicate"] == 1]
    hard[1]["position_squares_km2"] = [0.5, 0.5]
    report = report_of(soft, hard)
    found = [r[:4] for r in table_of(report, "table_3_kept_normal").rows]
    assert found == [[0.2, "gnn", "either", 2], [0.2, "jpda", "hard", 1], [0.2, "jpda", "soft", 2]]
    position = table_of(report, "table_3_position_normal")
    assert values(position, 0.2, "jpda", "hard")["filtered all tracks"].value == 0.25


def test_the_same_outing_in_two_runs_is_refused(report_of):
    with pytest.raises(RunError, match="run and run_2 has two outings of mapada on lee-crossing"):
        report_of([outing()], [outing()])


def test_shares_are_shares_and_text_fits(report_of):
    report = report_of(study(2, FEW, (0.2, 0.6)))
    checked = 0
    for table in report.tables:
        shares = [j for j, c in enumerate(table.columns) if "[%]" in c.full_header]
        for cell in (row[j] for row in table.rows for j in shares):
            value = getattr(cell, "value", cell)
            assert value is None or 0 <= value <= 100
            checked += 1
    assert checked > 100
    plain = [t for t in report.tables if not t.name.startswith("claims")]
    assert max(map(len, to_text(Report("", [], plain)).splitlines())) <= 140


def test_what_is_missing_is_named(report_of):
    told = " ".join(report_of([outing("gnn"), outing("mapada")]).lines)
    assert "Not in closed loop: oracle, nn, mapada-literal, mapada-weighted" in told
    assert "hnpda, hnpda-raw, jpda, pda, jpda-cheap, lbp." in told
    assert "crossing at C = 0.4, normal" in told and "ten at C = 0.2, uniform" in told
    assert "crossing at C = 0.2, normal" not in told and "Not in these runs: open loop" in told
    only_open = report_of([], rows=[open_row()])
    assert [t.name for t in only_open.tables] == ["open_loop", "claims_rules", "claims"]


def test_all_skipped_leaves_no_tables_but_their_fates(report_of):
    report = report_of([skipped(outing("mapada-weighted"))])
    assert [t.name for t in report.tables] == ["claims_rules", "claims", "fates"]


def test_plans_that_were_not_met_are_told(report_of):
    plan = {"scenario": "lee-crossing", "loop": "closed", "windows": [1], "replicates": 2,
            "scan_periods_s": [1.0], "algorithms": ["mapada", "gnn"], "every": 1}
    about = {"schema_version": 1, "sweep": {"plans": [plan]}}
    outings = [outing("gnn", replicate=1), outing("gnn", replicate=2), outing()]
    told = " ".join(report_of(outings, about=about).lines)
    assert "1 of 2 entries in closed loop" in told and "mapada: 1 of 2" in told
    assert "Planned" not in " ".join(report_of([*outings, outing(replicate=2)], about=about).lines)


def test_an_old_manifest_and_other_scenarios_do_not_matter(tmp_path, capsys):
    run = write_position(tmp_path / "run", [outing(), {"scenario": "A"}], about={})
    assert tables.main(["lee1998", str(run)]) == 0
    assert "commit unknown" in capsys.readouterr().out


def test_a_torn_last_line_is_told(tmp_path, capsys):
    run = write_position(tmp_path / "run", [outing()], tail='{"schema')
    assert tables.main(["lee1998", str(run)]) == 0
    assert "tracking.jsonl:2: the last line is torn" in capsys.readouterr().err


def test_other_scan_periods_are_left_out_and_told(tmp_path, capsys):
    run = write_position(tmp_path / "run", [outing(), outing(scan_period_s=2.0)])
    assert tables.main(["lee1998", str(run)]) == 0
    assert "1 outings at other scan periods" in capsys.readouterr().err


@pytest.mark.parametrize(("change", "expected"), [
    ({"scan_period_s": "1"}, "scan_period_s is not of type float"), ({"update": "mild"}, "update"),
    ({"scenario": "lee-seven"}, "lee-seven is not one of the study"),
    ({"scans": 0}, "without scans"),
    ({"status": "great"}, "unknown status: great"), ({"schema_version": 2}, "schema version"),
    ({"cpu_ms": None}, "cpu_ms is no number"), ({"conflict_rate": 1.5}, "is no share"),
    ({"targets": "12"}, "no list of numbers"), ({"targets": [1]}, "is no list of 1"),
    ({"dropped": [0, 1]}, "dropped holds something of a wrong type"),
    ({"position_squares_km2": [0.1, None]}, "position_squares_km2 holds something"),
    ({"position_error_series_km": [[0.1], [0.1]]}, "position_error_series_km is no list of 8"),
    ({"track_series_km": [[[0.1]] * 8] * 2}, "track_series_km is no list of 2"),
    ({"track_series_km": [[0.1] * 8] * 2}, "track_series_km holds something of a wrong type"),
])
def test_wrong_outings_are_refused(tmp_path, capsys, change, expected):
    run = write_position(tmp_path / "run", [outing("gnn"), outing(**change)])
    refused(capsys, "lee1998", run, expected)


@pytest.mark.parametrize("field", ["algorithm", "swaps", "track_series_km"])
def test_absent_fields_are_named(tmp_path, capsys, field):
    line = outing()
    del line[field]
    run = write_position(tmp_path / "run", [line])
    refused(capsys, "lee1998", run, f"tracking.jsonl:1: the line has no field '{field}'")


def refused(capsys: pytest.CaptureFixture[str], name: str, run: Path, expected: str) -> None:
    assert tables.main([name, str(run)]) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1
    assert expected in printed.err


def test_runs_of_others_are_refused(tmp_path, capsys):
    run = testing.write_run(tmp_path / "run", testing.hand_made())
    refused(capsys, "lee1998", run, "no rows and no outings of scenarios lee-*")
    refused(capsys, "lee1998", tmp_path / "absent", "no run directory")
    run = write_position(tmp_path / "position", [outing()])
    refused(capsys, "tracking", run, "tables of their own: tables.py lee1998")


def test_published_averages_are_those_of_the_lines():
    """The paper prints them: all agree but that of MAPADA's maintenance, 80 for 77.5."""
    table = lee_tables.published_table(3)
    assert list(table.index) == list(position_targets.DENSITIES)
    printed = {"position_rms_km_hnpda": 0.76, "position_rms_km_mapada": 0.19,
               "velocity_rms_km_s_hnpda": 0.94, "velocity_rms_km_s_mapada": 0.04,
               "maintenance_pct_hnpda": 55, "maintenance_pct_mapada": 77.5}
    for column, mean in printed.items():
        assert table[column].mean() == pytest.approx(mean, abs=0.01)
    assert list(lee_tables.published_table(4).index) == list(range(1, 11))
