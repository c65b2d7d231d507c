"""Synthetic runs over three sensors, for the tests."""

from collections.abc import Sequence
from typing import Any

from mda_results import testing, three_sensors

Row = dict[str, Any]

RUNS = (1, 2, 3)
AXIS = tuple(three_sensors.LOSSES.values())


def sensor_row(algorithm: str = "bojilov", sigma: float = 0.2, replicate: int = 1, right: int = 12,
               scene: str = "36", false_alarms: float = 0.1, **changes: Any) -> Row:
    """A window of 20 targets seen twice, of which `right` tuples of 16 are exact."""
    counts = {"true_tuples": 20, "answer_tuples": 16, "exact_tuples": right, "true_pairs": 40,
              "answer_pairs": 32, "right_pairs": 24}
    line = testing.row(algorithm, scenario=f"static3-{scene}-s{sigma:.2f}-f{false_alarms:.1f}",
                       replicate=replicate, scan_period_s=1.0, dimensions=3, **counts)
    if line["status"] not in ("optimal", "feasible") and "true_tuples" not in changes:
        line.update(dict.fromkeys(counts))
    line.update(changes)
    return line


def rows_of(algorithm: str, right: int = 12, sigmas: Sequence[float] = (0.2,),
            **changes: Any) -> list[Row]:
    """One row for each of RUNS at each sigma."""
    return [sensor_row(algorithm, s, r, right, **changes) for s in sigmas for r in RUNS]
