"""Runs over position targets, the scenarios of Lee & Jeong (1998): rows and outings.

Open-loop rows are those of rows.py; outings are the lines of tracking.jsonl (results/README.md).
Either may be absent. Several runs are read as one: they may differ in how marginals move a track.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from mda_results import outings as common
from mda_results import plans
from mda_results.rows import RunError, json_lines, load_manifest

PREFIX = "lee-"
DENSITIES = (0.2, 0.4, 0.6, 0.8)  # clutter per km^2
LAWS = {"normal": "normal around the targets (fitted)", "uniform": "uniform"}
PAIRS = ("crossing", "parallel")  # scenes of Table 3; that of Table 4 is "ten"
ORACLE = "oracle"
ALGORITHMS = (ORACLE, "gnn", "nn", "mapada", "mapada-literal", "mapada-weighted", "mapada-miss",
              "hnpda", "hnpda-raw", "jpda", "pda", "jpda-cheap", "lbp")
EITHER = "either"  # an update that changes nothing, see without_echoes()
SQUARES = {"position": "position_squares_km2", "velocity": "velocity_squares_km2_s2",
           "predicted_position": "predicted_position_squares_km2",
           "predicted_velocity": "predicted_velocity_squares_km2_s2"}
SCENE_KEY = ["scene", "law", "density", "replicate"]

_NAME = re.compile(r"lee-(crossing|parallel|ten)(-uniform)?(?:-c(0\.[1-9]))?")
_SCAN_PERIOD_S = 1.0
_NUMBERS = ("scans", "unanswered", "swaps", "coalescences", "conflict_rate", "iterations_per_scan",
            "wall_ms", "cpu_ms", "hypotheses_cpu_ms")
_MAY_BE_NULL = ("iterations_per_scan",)
_MARKS = {"kept_450m": "maintained_450m", "kept_750m": "maintained_750m", "dropped": "dropped"}
_SERIES = ("position_error_series_km", "velocity_error_series_km_s", "track_series_km")
_MEASURES = (*_NUMBERS, "targets", *_MARKS.values(), *SQUARES.values(), *_SERIES)
_COLUMNS = [*common.NAMES, "update", "scene", "law", "density", *_MEASURES]


@dataclass(frozen=True)
class PositionRun:
    """One or several loaded runs; what they do not have is a frame without lines. `outings` have
    the columns scene, law and density (per km^2) of their scenario, and lists as arrays."""

    name: str  # of the directories
    commits: list[str]
    lacking: list[str]  # sentences on what was planned and is not there
    trajectories: dict[str, Any]  # what trajectories.json holds; empty without that file
    rows: pd.DataFrame  # open loop, one per (window, algorithm); of the first run that has some
    outings: pd.DataFrame  # closed loop, one per (scene, algorithm, update)
    warnings: list[str]


def is_position(scenario: object) -> bool:
    """Whether a scenario is one of this study."""
    return isinstance(scenario, str) and scenario.startswith(PREFIX)


def load(directories: Sequence[Path]) -> PositionRun:
    """Raises RunError if a run is damaged or has nothing of the study, or if two of them hold the
    same outing. A torn last line is left out with a warning."""
    runs = [_load_one(directory) for directory in directories]
    outings = pd.concat([run.outings for run in runs], ignore_index=True)
    name = " and ".join(run.name for run in runs)
    common.check_once(outings, [*common.OUTING_KEY, "update", "replicate"], name)
    order = {a: n for n, a in enumerate(ALGORITHMS)}
    outings = outings.assign(order=outings["algorithm"].map(lambda a: order.get(a, len(order))))
    outings = outings.sort_values(["order", "algorithm", "update", "scenario", "replicate"],
                                  ignore_index=True).drop(columns="order")
    return PositionRun(
        name, sorted({c for run in runs for c in run.commits}),
        [sentence for run in runs for sentence in run.lacking],
        {s: t for run in reversed(runs) for s, t in run.trajectories.items()},
        next((run.rows for run in runs if len(run.rows)), runs[0].rows), outings,
        [w for run in runs for w in run.warnings])


def finished(outings: pd.DataFrame) -> pd.DataFrame:
    """Outings whose every answer stood."""
    return outings[outings["status"] == "finished"]


def tracks_of(outings: pd.DataFrame) -> pd.DataFrame:
    """One line per track of finished outings.

    Columns scene, law, density, replicate, algorithm, update, target; kept_450m, kept_750m and
    dropped (0 or 1); scans; per name of SQUARES the sum of squared errors over the scans; and for
    bootstrap.ratio() the scene as `group`, as its scenarios share their draws, and 1 as `one`.
    """
    key = [*SCENE_KEY, "algorithm", "update", "scans"]
    fields = {**_MARKS, **SQUARES, "target": "targets"}
    lines = finished(outings)[[*key, *fields.values()]].explode([*fields.values()])
    lines = lines.rename(columns={v: k for k, v in fields.items()}).reset_index(drop=True)
    numbers = {f: lines[f].astype(float) for f in (*_MARKS, *SQUARES, "scans")}
    return lines.assign(**numbers, target=lines["target"].astype(int), group=lines["scene"], one=1)


def without_echoes(outings: pd.DataFrame) -> pd.DataFrame:
    """The outings, those of an algorithm that moves alike under every update only once, with the
    update EITHER: choices do. Of a scenario the update with more replicates is taken."""
    parts = [outings.iloc[:0]]
    for _, own in outings.groupby("algorithm", sort=False):
        if own["update"].nunique() > 1 and _is_the_same(own):
            counts = own.groupby(["scenario", "update"])["replicate"].transform("nunique")
            own = own.assign(count=counts).sort_values(["count", "update"], ascending=False)
            own = own.drop_duplicates(["scenario", "replicate"]).drop(columns="count")
            own = own.assign(update=EITHER).sort_values(["scenario", "replicate"])
        parts.append(own)
    return pd.concat(parts, ignore_index=True)


def _is_the_same(own: pd.DataFrame) -> bool:
    """Whether the outings of one algorithm on a scene agree, and there are some on several
    updates."""
    done = finished(own)
    shared = [part for _, part in done.groupby(["scenario", "replicate"]) if len(part) > 1]
    first, others = SQUARES["position"], range(1, own["update"].nunique())
    return bool(shared) and all(
        np.array_equal(part[first].iloc[0], part[first].iloc[n])
        for part in shared for n in others if n < len(part))


def _load_one(directory: Path) -> PositionRun:
    if not directory.is_dir():
        raise RunError(f"there is no run directory {directory}")
    manifest = load_manifest(directory / "manifest.json")
    warnings: list[str] = []
    rows = common.open_rows(directory, PREFIX, warnings)
    path = directory / "tracking.jsonl"
    lines = list(_lines(path, warnings)) if common.has_lines(path) else []
    if rows.empty and not lines:
        raise RunError(f"{directory} has no rows and no outings of scenarios {PREFIX}*")
    nominal = [line for line in lines if line["scan_period_s"] == _SCAN_PERIOD_S]
    if len(nominal) < len(lines):
        warnings.append(f"{path}: {len(lines) - len(nominal)} outings at other scan periods than "
                        f"{_SCAN_PERIOD_S:g} s are left out")
    outings = pd.DataFrame(nominal).reindex(columns=_COLUMNS)
    words = ("scenario", "algorithm", "update", "status", "note", "scene", "law")
    outings = outings.astype({**dict.fromkeys(_NUMBERS, float), **dict.fromkeys(words, object)})
    common.check_once(outings, [*common.OUTING_KEY, "update", "replicate"], path)
    paths = directory / "trajectories.json"
    name = directory.resolve().name
    lacking = [sentence for loop, frame in (("closed", outings), ("open", rows))
               for sentence in plans.unmet(name, manifest, loop, frame)]
    return PositionRun(name, [str(manifest.get("commit", "unknown"))], lacking,
                       load_manifest(paths) if paths.is_file() else {}, rows, outings, warnings)


def _lines(path: Path, warnings: list[str]) -> Iterator[dict[str, Any]]:
    for number, record in enumerate(json_lines(path, warnings), start=1):
        if not is_position(record.get("scenario")):
            continue
        where = f"{path}:{number}"
        common.check_names(record, where)
        if record.get("update") not in ("soft", "hard"):
            raise RunError(f"{where}: update is neither soft nor hard")
        parts = _NAME.fullmatch(record["scenario"])
        if parts is None:
            raise RunError(f"{where}: the scenario {record['scenario']} is not one of the study")
        scene, uniform, density = parts.groups()
        record.update(scene=scene, law="uniform" if uniform else "normal",
                      density=float(density) if density else DENSITIES[0])
        if record["status"] == "finished" or (record["status"] == "failed" and "scans" in record):
            _check_measures(record, where)
            record.update({name: np.array(record[name], dtype=float) for name in _SERIES})
        yield record


def _check_measures(record: dict[str, Any], where: str) -> None:
    common.check_there(record, _MEASURES, where)
    common.check_numbers(record, _NUMBERS, _MAY_BE_NULL, where)
    common.check_shares(record, ("conflict_rate",), where)
    if type(record["scans"]) is not int or record["scans"] < 1:
        raise RunError(f"{where}: an outing without scans")
    targets = record["targets"]
    if not isinstance(targets, list) or not targets or {type(t) for t in targets} != {int}:
        raise RunError(f"{where}: targets is no list of numbers")
    for name in _MARKS.values():
        _check_list(record[name], len(targets), (bool,), f"{where}: {name}")
    for name in SQUARES.values():
        _check_list(record[name], len(targets), (int, float), f"{where}: {name}")
    for name in _SERIES:
        _check_list(record[name], len(targets), (list,), f"{where}: {name}")
        paired = name == "track_series_km"
        for series in record[name]:
            _check_list(series, record["scans"], (list,) if paired else (int, float),
                        f"{where}: {name}")
            for pair in series if paired else ():
                _check_list(pair, 2, (int, float), f"{where}: {name}")


def _check_list(value: object, length: int, kinds: tuple[type, ...], what: str) -> None:
    if not isinstance(value, list) or len(value) != length:
        raise RunError(f"{what} is no list of {length}")
    if any(type(entry) not in kinds for entry in value):
        raise RunError(f"{what} holds something of a wrong type")
