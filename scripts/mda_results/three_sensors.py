"""Runs over three sensors at one instant, the scenarios of Bojilov (1995).

One window per run and point: the rows of rows.py with the counts of right associations
(results/README.md)."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from mda_results import bootstrap, cells, outings, plans
from mda_results.render import Estimate
from mda_results.rows import ASSOCIATION_COUNTS, WINDOW_KEY, RunError, load_manifest

PREFIX = "static3-"
SIGMAS = (0.10, 0.15, 0.20, 0.25, 0.30)  # in mean distances of the targets
FALSE_ALARMS = (0.0, 0.1, 0.3)  # per sensor and target
TARGETS = (36, 64)
LAYOUTS = ("grid", "random")
SCENE = ["targets", "layout", "false_alarms"]  # what a figure of the study holds fixed
EXACT, UNTREATED, CALIBRATED = "exact", "bojilov-untreated", "bojilov-calibrated"
# By the share of true pairs that the threshold Q loses, in percent.
LOSSES = {0.01: "bojilov-loss-0.0001", 0.1: "bojilov-loss-0.001", 0.5: "bojilov-loss-0.005",
          1.0: "bojilov", 2.5: "bojilov-loss-0.025", 5.0: "bojilov-loss-0.05",
          10.0: "bojilov-loss-0.1", 20.0: "bojilov-loss-0.2"}
DETECTION_PROBABILITY = 0.7
PREFERRED = (1.0, 2.5)  # percent: what the paper calls preferable

_NAME = re.compile(r"static3-(36|64)(-random)?-s(0\.\d\d)-f(0\.\d)")


@dataclass(frozen=True)
class SensorRun:
    """A loaded run. `rows` have the columns SCENE and sigma of their scenario, and what
    outings.open_rows() adds; the algorithms stand in the order of the study."""

    name: str  # of its directory
    manifest: dict[str, Any]
    rows: pd.DataFrame  # one per (window, algorithm)
    lacking: list[str]  # sentences on what was planned and is not there
    warnings: list[str]


def is_sensors(scenario: object) -> bool:
    """Whether a scenario is one of this study."""
    return isinstance(scenario, str) and scenario.startswith(PREFIX)


def load(directory: Path) -> SensorRun:
    """Raises RunError if the run is damaged or has nothing of the study. A torn last line is left
    out with a warning."""
    if not directory.is_dir():
        raise RunError(f"there is no run directory {directory}")
    manifest = load_manifest(directory / "manifest.json")
    warnings: list[str] = []
    rows = outings.open_rows(directory, PREFIX, warnings)
    if rows.empty:
        raise RunError(f"{directory} has no rows of scenarios {PREFIX}*")
    _check_counts(rows, directory)
    name = directory.resolve().name
    lacking = plans.unmet(name, manifest, "open", rows)
    points = {s: _point(s, manifest, directory) for s in rows["scenario"].unique()}
    told = pd.DataFrame([points[s] for s in rows["scenario"]], columns=[*SCENE, "sigma"],
                        index=rows.index)
    rows = rows.join(told).assign(order=rows["algorithm"].map(_order))
    rows = rows.sort_values([*SCENE, "sigma", "order", "algorithm", "replicate"],
                            ignore_index=True).drop(columns="order")
    return SensorRun(name, manifest, rows, lacking, warnings)


def counted(rows: pd.DataFrame) -> pd.DataFrame:
    """The rows whose answer stands and can be compared with the truth."""
    return rows[cells.answered(rows)].dropna(subset=list(ASSOCIATION_COUNTS))


def target_exact(rows: pd.DataFrame) -> Estimate | None:
    """Percent of the targets seen twice or more whose very set of reports is a tuple of the
    answer; interval over runs."""
    return _percent(counted(rows), "exact_tuples", "true_tuples")


def pair_precision(rows: pd.DataFrame) -> Estimate | None:
    """Percent of the answer's pairs of reports that are one target."""
    return _percent(counted(rows), "right_pairs", "answer_pairs")


def pair_recall(rows: pd.DataFrame) -> Estimate | None:
    """Percent of the pairs of reports of one target that are in the answer."""
    return _percent(counted(rows), "right_pairs", "true_pairs")


def advantage(rows: pd.DataFrame, algorithm: str, other: str) -> Estimate | None:
    """target_exact() of `algorithm` less that of `other`, in points, on the windows of both."""
    own, against = (counted(rows[rows["algorithm"] == a]) for a in (algorithm, other))
    pairs = own.merge(against[[*WINDOW_KEY, "exact_tuples"]], on=WINDOW_KEY,
                      suffixes=("", "_other"))
    more = pairs["exact_tuples"] - pairs["exact_tuples_other"]
    return _percent(pairs.assign(more=more), "more", "true_tuples")


def _percent(rows: pd.DataFrame, part: str, whole: str) -> Estimate | None:
    return bootstrap.ratio(rows, part, whole, lambda share: 100 * share)


def _order(algorithm: str) -> tuple[int, float]:
    """The axis of figure 2 from its point without treatment on, then Bojilov's others, the rest."""
    losses = {a: loss for loss, a in LOSSES.items()}
    if algorithm in losses:
        return (1, losses[algorithm])
    if algorithm == UNTREATED:
        return (0, 0.0)
    return (2, 0.0) if algorithm.startswith("bojilov") else (3, 0.0)


def _point(scenario: str, manifest: dict[str, Any],
           directory: Path) -> tuple[int, str, float, float]:
    """SCENE and sigma as the scenario's name says; raises RunError if a sweep file has changed
    them."""
    parts = _NAME.fullmatch(scenario)
    if parts is None:
        raise RunError(f"{directory}: the scenario {scenario} is not one of the study")
    targets, random, sigma, false_alarms = parts.groups()
    point = int(targets), "random" if random else "grid", float(false_alarms), float(sigma)
    world = manifest.get("scenarios", {}).get(scenario, {})
    told = {**world, **(world.get("three_sensors") or {})}
    named = dict(zip(("targets", "layout", "false_alarms_per_target", "sigma_per_spacing",
                      "detection_probability"), (*point, DETECTION_PROBABILITY)))
    for field, value in named.items():
        if told.get(field, value) != value:
            raise RunError(f"{directory}: {scenario} was run with {field} = {told[field]}, not "
                           f"{value}: it is no point of the study; scripts/rank.py takes it")
    return point


def _check_counts(rows: pd.DataFrame, directory: Path) -> None:
    """That parts are not more than their wholes; raises RunError."""
    known = rows.dropna(subset=list(ASSOCIATION_COUNTS))
    for part, whole in (("exact_tuples", "true_tuples"), ("exact_tuples", "answer_tuples"),
                        ("right_pairs", "true_pairs"), ("right_pairs", "answer_pairs")):
        bad = known[(known[part] < 0) | (known[part] > known[whole])]
        if len(bad):
            line = bad.iloc[0]
            raise RunError(f"{directory}: {line['algorithm']} on {line['scenario']}, replicate "
                           f"{line['replicate']}, has {line[part]:g} {part} of {line[whole]:g} "
                           f"{whole}")
