"""Tables over three sensors, from hand-made runs."""

from pathlib import Path
from typing import Any

import pytest

import tables
from mda_results import bojilov1995, testing, three_sensors
from mda_results.render import Report, to_markdown, to_text
from mda_results.rows import RunError
from mda_results.sensor_testing import AXIS, Row, rows_of, sensor_row
from mda_results.testing import table_of, values
from mda_results.verdicts import FAILS, HOLDS, OPEN, PARTLY


@pytest.fixture
def report_of(tmp_path: Path):
    def report(rows: list[Row], about: Any = testing.MANIFEST) -> Report:
        return bojilov1995.report(testing.write_run(tmp_path / "run", rows, about))[0]

    return report


@pytest.fixture
def judged(report_of):
    def verdicts_of(rows: list[Row], said: str) -> list[str]:
        """Those of the claim whose text holds `said`, in order."""
        report = report_of(rows)
        numbers = [r[0] for r in table_of(report, "claims_rules").rows if said in r[1]]
        assert len(numbers) == 1
        return [r[3] for r in table_of(report, "claims").rows if r[0] == numbers[0]]

    return verdicts_of


def test_association_is_pooled_over_runs(report_of):
    rows = [sensor_row(replicate=1, right=10),
            sensor_row(replicate=2, right=4, true_tuples=8, answer_tuples=4, true_pairs=8,
                       answer_pairs=4, right_pairs=4),
            sensor_row(replicate=3, status="failed", true_tuples=20, exact_tuples=0)]
    report = report_of(rows)
    own = values(table_of(report, "figure_2_36_f0.1"), "1", "bojilov")
    exact = own["correct association [%] σ = 0.20"]
    assert exact.value == pytest.approx(100 * 14 / 28) and own["runs"] == 2
    assert exact.low == pytest.approx(50) and exact.high == pytest.approx(50)
    pairs = values(table_of(report, "pairs_36_f0.1"), "bojilov")
    assert pairs["pair precision [%] σ = 0.20"].value == pytest.approx(100 * 28 / 36)
    assert pairs["pair recall [%] σ = 0.20"].value == pytest.approx(100 * 28 / 48)
    assert values(table_of(report, "fates"), "bojilov", "failed")["rows"] == 1


def test_scenes_are_apart_and_sigmas_in_order(report_of):
    rows = [r for scene, f in (("36", 0.1), ("36", 0.3), ("64", 0.1), ("36-random", 0.1))
            for r in rows_of("exact", 9, (0.25, 0.1), scene=scene, false_alarms=f)]
    report = report_of(rows)
    found = [t for t in report.tables if t.name.startswith("figure_2")]
    assert [t.name for t in found] == ["figure_2_36_f0.1", "figure_2_36_f0.3",
                                       "figure_2_36_random_f0.1", "figure_2_64_f0.1"]
    for table in found:
        assert [c.header for c in table.columns[3:]] == ["σ = 0.10", "σ = 0.25"]
        assert [e.value for e in table.rows[0][3:]] == pytest.approx([45.0, 45.0])


def test_lines_stand_in_the_order_of_the_axis(report_of):
    names = ["greedy", "exact", "bojilov-calibrated", *reversed(AXIS), "bojilov-untreated"]
    table = table_of(report_of([r for a in names for r in rows_of(a)]), "figure_2_36_f0.1")
    assert [row[0] for row in table.rows] == ["x", "0.01", "0.1", "0.5", "1", "2.5", "5", "10",
                                              "20", None, None, None]
    assert [row[1] for row in table.rows][1:9] == list(AXIS)


def test_an_algorithm_without_a_sigma_leaves_its_place_empty(report_of):
    table = table_of(report_of(rows_of("exact", sigmas=(0.1, 0.2)) + rows_of("cbc")),
                     "figure_2_36_f0.1")
    own = values(table, None, "cbc")
    assert own["correct association [%] σ = 0.10"] is None and own["runs"] == 0
    assert own["correct association [%] σ = 0.20"].value == pytest.approx(60)


def test_gaps_are_shares_of_the_optimum(report_of):
    rows = [sensor_row("greedy", replicate=1, gap_nats=1.0, cost_nats=-9.0),
            sensor_row("greedy", replicate=2, gap_nats=0.0, reference_cost_nats=-30.0)]
    own = values(table_of(report_of(rows), "gap_36_f0.1"), "greedy")
    assert own["gap [% of the optimum] σ = 0.20"].value == pytest.approx(100 / 40)
    assert own["optimal [%] σ = 0.20"].value == pytest.approx(50)


def test_the_optimum_is_told_with_its_proof(report_of):
    rows = rows_of("exact")
    rows[0].update(certified_bound_nats=-10.5)
    rows[1].update(status="feasible")
    about = " ".join(report_of(rows).lines)
    assert "in 2 of 3 windows" in about and "in 2 of them" in about and "0.5 nats" in about


@pytest.mark.parametrize(("right", "verdict"), [(13, HOLDS), (12, FAILS), (11, FAILS)])
def test_treatment(judged, right, verdict):
    rows = rows_of("bojilov", right) + rows_of("bojilov-untreated", 12)
    assert judged(rows, "treating") == [verdict]
    assert judged(rows + rows_of("exact", 12), "treating") == [verdict]


def test_treatment_at_some_sigma_holds_partly(judged):
    rows = rows_of("bojilov", 14) + rows_of("bojilov-untreated", 12)
    rows += rows_of("bojilov", 12, (0.1,)) + rows_of("bojilov-untreated", 12, (0.1,))
    assert judged(rows, "treating") == [PARTLY]


@pytest.mark.parametrize(("best", "verdict"), [("bojilov", HOLDS), ("bojilov-loss-0.025", HOLDS),
                                               ("bojilov-loss-0.005", FAILS)])
def test_preferable_thresholds(judged, best, verdict):
    rows = [r for a in AXIS for r in rows_of(a, 14 if a == best else 12)]
    assert judged(rows, "preferable") == [verdict]


@pytest.mark.parametrize(("first", "last", "verdict"), [(10, 10, HOLDS), (10, 12, PARTLY),
                                                        (12, 12, FAILS)])
def test_the_improvement_depends_on_the_threshold(judged, first, last, verdict):
    rows = rows_of(AXIS[0], first) + rows_of(AXIS[-1], last) + rows_of("bojilov", 12)
    assert judged(rows, "depends on Q") == [verdict]


@pytest.mark.parametrize(("right", "verdict"), [(12, HOLDS), (10, FAILS)])
def test_performance_against_the_optimum(judged, right, verdict):
    rows = rows_of("exact", 12) + rows_of("bojilov", right) + rows_of("bojilov-calibrated", 12)
    assert judged(rows, "high performance") == [verdict, HOLDS]


@pytest.mark.parametrize(("gap", "verdict"), [(0.05, HOLDS), (0.5, FAILS)])
def test_minimising(judged, gap, verdict):
    rows = rows_of("bojilov", gap_nats=gap, cost_nats=-10 + gap)
    assert judged(rows, "minimises") == [verdict, OPEN]


def test_claims_without_their_rows_cannot_be_decided(report_of):
    claims = table_of(report_of(rows_of("greedy")), "claims")
    assert {row[3] for row in claims.rows} == {OPEN}
    claims = table_of(report_of(rows_of("bojilov", scene="36-random")), "claims")
    assert {row[1] for row in claims.rows} == {"all"} and {row[3] for row in claims.rows} == {OPEN}


def test_what_a_part_of_the_replicates_lacks_is_told(report_of):
    plan = {"scenario": "static3-36-s0.20-f0.1", "loop": "open", "windows": [3],
            "scan_periods_s": [1.0], "algorithms": ["bojilov"]}
    parts = [{**plan, "first_replicate": 1, "replicates": 1},
             {**plan, "first_replicate": 2, "replicates": 3}]
    about = {**testing.MANIFEST, "sweep": {"plans": parts}}
    rows = rows_of("bojilov")
    assert "Planned" not in " ".join(report_of(rows, about).lines)
    lines = " ".join(report_of([rows[0], rows[2]], about).lines)
    assert "1 of 2 entries" in lines and "1 of 2." in lines


def test_a_damaged_run_is_one_sentence(report_of):
    with pytest.raises(RunError, match="no rows of scenarios static3-"):
        report_of([testing.row()])
    with pytest.raises(RunError, match="21 exact_tuples of 20 true_tuples"):
        report_of(rows_of("bojilov", 21))
    with pytest.raises(RunError, match="not one of the study"):
        report_of(rows_of("bojilov", scene="49"))
    with pytest.raises(RunError, match="no run directory"):
        three_sensors.load(Path("absent"))


@pytest.mark.parametrize("changed", [
    {"three_sensors": {"targets": 100}}, {"three_sensors": {"sigma_per_spacing": 0.3}},
    {"three_sensors": {"layout": "random"}}, {"three_sensors": {"false_alarms_per_target": 0.0}},
    {"detection_probability": 0.95}])
def test_points_that_a_sweep_file_has_changed_are_refused(report_of, changed):
    about = {**testing.MANIFEST, "scenarios": {"static3-36-s0.20-f0.1": changed}}
    with pytest.raises(RunError, match="it is no point of the study"):
        report_of(rows_of("bojilov"), about)


def test_every_format(report_of, tmp_path, capsys):
    report = report_of([r for a in (*AXIS, "exact") for r in rows_of(a, sigmas=(0.1, 0.2))])
    assert "claims" not in to_text(report).splitlines()[0]
    assert "| loss [%] | algorithm | runs |" in to_markdown(report)
    out = tmp_path / "out"
    run = str(tmp_path / "run")
    assert tables.main(["bojilov1995", run, "--format", "csv", "--out", str(out)]) == 0
    capsys.readouterr()
    assert (out / "figure_2_36_f0.1.csv").read_text().startswith("loss [%],algorithm,runs,")
    assert tables.main(["bojilov1995", run, run]) == 2
