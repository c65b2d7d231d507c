"""The outings of closed loops of any kind, from tracking.jsonl (results/README.md), as far as they
are ranked."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from mda_results.rows import SCHEMA_VERSION, RunError, json_lines

Line = dict[str, Any]


@dataclass(frozen=True)
class Measure:
    """A number of one outing; tables show its mean over scenes."""

    name: str
    header: str
    digits: str
    of: Callable[[Line], float]
    block: str = ""


@dataclass(frozen=True)
class Kind:
    """Outings of one kind, known by a field of theirs. The first measure ranks; less is better."""

    name: str
    title: str
    mark: str
    measures: tuple[Measure, ...]


def _field(name: str, header: str, digits: str, factor: float = 1.0, block: str = "") -> Measure:
    return Measure(name, header, digits, lambda line: factor * line[name], block)


def _share(name: str, header: str, of_true: bool = True) -> Measure:
    """Percent of a list of booleans."""
    return Measure(name, header, ".1f", lambda line: 100.0 * sum(
        bool(v) == of_true for v in line[name]) / len(line[name]), "percent of the tracks")


KINDS = (
    Kind("tracking_births", "Closed loop, scenarios with births", "gospa_km", (
        _field("gospa_km", "GOSPA [km]", ".3f"), _field("ospa_km", "OSPA [km]", ".3f"),
        _field("correct_association", "right plots", ".1f", 100.0, "percent"),
        _field("completeness", "complete", ".1f", 100.0, "percent"),
        _field("track_breaks", "breaks", ".2f", block="per scene"),
        _field("swaps", "swaps", ".2f", block="per scene"),
        _field("lost", "lost", ".2f", block="per scene"))),
    Kind("tracking_known", "Closed loop, known targets", "distance_error_m", (
        _field("distance_error_m", "distance to the ideal [m]", ".2f"),
        _field("position_error_m", "to the truth [m]", ".2f"),
        _field("right_share", "right decisions", ".1f", 100.0, "percent"),
        _field("lost_ever", "ever lost", ".2f", 100.0, "percent"),
        _field("lost_at_end", "lost at the end", ".2f", 100.0, "percent"))),
    Kind("tracking_positions", "Closed loop, tracks maintained", "maintained_450m", (
        _share("maintained_450m", "not kept", False), _share("dropped", "dropped"),
        Measure("position_squares_km2", "rms position error [km]", ".3f", lambda line: math.sqrt(
            sum(line["position_squares_km2"]) / line["scans"] / len(line["targets"]))),
        _field("swaps", "swaps", ".2f", block="per scene"),
        _field("coalescences", "coalescences", ".2f", block="per scene"))),
)
_KEY = {"scenario": str, "scan_period_s": (int, float), "seed": int, "replicate": int,
        "window_k": int, "algorithm": str, "status": str}
_WORK = ("scans", "unanswered", "cpu_ms")
OUTING = [*_KEY][:-1] + ["update"]  # names an outing
COLUMNS = [*_KEY, "update", "kind", *_WORK,
           *dict.fromkeys(m.name for kind in KINDS for m in kind.measures)]


def load(path: Path, warnings: list[str]) -> pd.DataFrame:
    """The lines of a tracking.jsonl: the key, `kind` (the name of one of KINDS; empty if no line of
    the scenario has a mark), the work, and the measures. Raises RunError if a line is damaged or
    there twice; a torn last line is left out with a warning."""
    records: list[Line] = []
    for number, line in enumerate(json_lines(path, warnings), start=1):
        where = f"{path}:{number}"
        for name, kind in _KEY.items():
            if not isinstance(line.get(name), kind):
                raise RunError(f"{where}: the line has no field '{name}' of the right type")
        if line.get("schema_version") != SCHEMA_VERSION:
            raise RunError(f"{where}: its schema version is not {SCHEMA_VERSION}")
        records.append({**{n: line[n] for n in _KEY}, "update": line.get("update", ""),
                        **_measured(line, where)})
    frame = pd.DataFrame(records).reindex(columns=COLUMNS)
    twice = frame.duplicated(OUTING)
    if twice.any():
        number = int(twice.to_numpy().argmax()) + 1
        raise RunError(f"{path}:{number}: this outing is there twice")
    kinds = frame.dropna(subset=["kind"]).drop_duplicates("scenario")
    known = dict(zip(kinds["scenario"], kinds["kind"]))
    return frame.assign(kind=frame["scenario"].map(lambda s: known.get(s, "")))


def _measured(line: Line, where: str) -> Line:
    """Nothing of a line that did not finish but its kind, work, and windows without an answer."""
    kind = next((k for k in KINDS if k.mark in line), None)
    if kind is None:
        return {}
    try:
        found: Line = {name: float(line[name]) for name in _WORK}
        if line["status"] == "finished":
            found.update({m.name: float(m.of(line)) for m in kind.measures})
    except KeyError as error:
        raise RunError(f"{where}: the line has no field {error}") from None
    except (TypeError, ValueError, ZeroDivisionError):
        raise RunError(f"{where}: the line has a measure that is no number") from None
    return {**found, "kind": kind.name}
