"""What a pool knows of the windows beside their rows."""

import json
from pathlib import Path

import numpy as np
import pytest

from mda_results import pool
from mda_results.ranking_testing import MANIFEST, row
from mda_results.sensor_testing import sensor_row
from mda_results.testing import write_run

BIRTHS, SENSORS = "A", "static3-64-s0.20-f0.1"
SPECS = {BIRTHS: {"births_per_scan": 2.0, "three_sensors": None},
         SENSORS: {"births_per_scan": 0.0, "three_sensors": {"targets": 64}}}


def targets_of(run: Path) -> dict[tuple[str, int], float]:
    rows = pool.load([run]).rows
    return {(r.scenario, r.scan): r.targets for r in rows.itertuples()}


def test_targets_are_those_known_or_the_births_expected(tmp_path):
    lines = [row("exact", scan=1), row("exact", scan=3), sensor_row("exact", scene="64"),
             row("exact", scenario="battistelli-2"), row("exact", scenario="lee-crossing")]
    run = write_run(tmp_path / "run", lines, {**MANIFEST, "scenarios": SPECS})
    (run / "trajectories.json").write_text(json.dumps({"lee-crossing": {"targets": [[], []]}}))
    assert targets_of(run) == {(BIRTHS, 1): 2.0, (BIRTHS, 3): 6.0, (SENSORS, 1): 64.0,
                               ("battistelli-2", 1): 3.0, ("lee-crossing", 1): 2.0}


@pytest.mark.parametrize("specs", [{}, {SENSORS: {}}, {SENSORS: {"three_sensors": {}}}])
def test_a_manifest_that_tells_nothing_leaves_them_open(tmp_path, specs):
    run = write_run(tmp_path / "run", [sensor_row("exact", scene="64")],
                    {**MANIFEST, "scenarios": specs})
    assert np.isnan(list(targets_of(run).values())).all()
