"""What a pool knows of the windows beside their rows."""

import json
from pathlib import Path

import numpy as np
import pytest

from mda_results import known_testing, pool
from mda_results.ranking_testing import MANIFEST, row
from mda_results.sensor_testing import sensor_row
from mda_results.rows import RunError
from mda_results.testing import write_run

BIRTHS, SENSORS = "A", "static3-64-s0.20-f0.1"
SPECS = {BIRTHS: {"births_per_scan": 2.0, "three_sensors": None},
         "easy-50": {"births_per_scan": 1.0, "initial_targets": 50},
         SENSORS: {"births_per_scan": 0.0, "three_sensors": {"targets": 64}}}


def targets_of(run: Path) -> dict[tuple[str, int], float]:
    rows = pool.load([run]).rows
    return {(r.scenario, r.scan): r.targets for r in rows.itertuples()}


def test_targets_are_those_known_or_the_births_expected(tmp_path):
    lines = [row("exact", scan=1), row("exact", scan=3), sensor_row("exact", scene="64"),
             row("exact", scenario="easy-50", scan=2),
             row("exact", scenario="battistelli-2"), row("exact", scenario="lee-crossing")]
    run = write_run(tmp_path / "run", lines, {**MANIFEST, "scenarios": SPECS})
    (run / "trajectories.json").write_text(json.dumps({"lee-crossing": {"targets": [[], []]}}))
    assert targets_of(run) == {(BIRTHS, 1): 2.0, (BIRTHS, 3): 6.0, ("easy-50", 2): 52.0,
                               (SENSORS, 1): 64.0, ("battistelli-2", 1): 3.0,
                               ("lee-crossing", 1): 2.0}


@pytest.mark.parametrize("specs", [{}, {SENSORS: {}}, {SENSORS: {"three_sensors": {}}}])
def test_a_manifest_that_tells_nothing_leaves_them_open(tmp_path, specs):
    run = write_run(tmp_path / "run", [sensor_row("exact", scene="64")],
                    {**MANIFEST, "scenarios": specs})
    assert np.isnan(list(targets_of(run).values())).all()


def runs_of_models(tmp_path: Path, *specs: dict[str, object]) -> list[Path]:
    return [write_run(tmp_path / f"run{n}", [row("exact", replicate=n)],
                      {**MANIFEST, "scenarios": {"A": spec}}) for n, spec in enumerate(specs, 1)]


def test_one_scenario_under_two_models_is_one_sentence(tmp_path):
    runs = runs_of_models(tmp_path, {"gate": 9.21, "rows": "packing"},
                          {"gate": 16.0, "rows": "packing"})
    with pytest.raises(RunError, match=r"different models of scenario A \(gate\)"):
        pool.load(runs)


def test_scan_periods_make_no_other_model(tmp_path):
    runs = runs_of_models(tmp_path, {"gate": 9.21, "scan_period_s": 8.0},
                          {"gate": 9.21, "scan_period_s": 4.0})
    assert len(pool.load(runs).rows) == 2


def test_runs_without_rows_leave_the_types_of_the_others(tmp_path):
    runs = runs_of_models(tmp_path, {}, {})
    (runs[0] / "rows.jsonl").write_text("")
    (runs[0] / "tracking.jsonl").write_text(json.dumps(known_testing.outing()) + "\n")
    whole = pool.load(runs).rows
    assert whole["seed"].dtype == pool.load(runs[1:]).rows["seed"].dtype
