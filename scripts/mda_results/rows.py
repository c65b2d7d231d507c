"""Loads a run: manifest.json and the open-loop rows of rows.jsonl (results/README.md)."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

SCHEMA_VERSION = 1
STATUSES = ("optimal", "feasible", "no_answer", "failed", "skipped")

# Of rows of three sensors only.
ASSOCIATION_COUNTS = ("true_tuples", "answer_tuples", "exact_tuples", "true_pairs", "answer_pairs",
                      "right_pairs")

# The fields that the tables use, with their types. Other fields of a row are not looked at.
_FIELDS = {
    "schema_version": "integer",
    "scenario": "string",
    "driver": "string",
    "fingerprint": "string",
    "algorithm": "string",
    "answer": "string",
    "status": "string",
    "stop": "string",
    "note": "string",
    "seed": "integer",
    "window_k": "integer",
    "replicate": "integer",
    "scan": "integer",
    "scan_period_s": "number",
    "rows": "integer",
    "columns": "integer",
    "ungated_columns": "number",
    "components": "integer",
    "largest_component_columns": "integer",
    "graph_nodes": "integer",
    "graph_arcs": "integer",
    "off_column_paths": "integer",
    "fractional": "integer",
    "paper_fractional": "integer",
    "wall_ms": "number",
    "cpu_ms": "number",
    "views_ms": "number",
    "lp_ms": "number",
    "round_ms": "number",
    "cost_nats": "number",
    "bound_nats": "number",
    "certified_bound_nats": "number",
    "reference_cost_nats": "number",
    "retired_nats": "number",
    "truth_cost_nats": "number",
    "gap_nats": "number",
    "gap_share": "number",
    "row_violation": "number",
    "integral": "boolean",
    **dict.fromkeys(ASSOCIATION_COUNTS, "integer"),
}
_MAY_BE_ABSENT = ("ungated_columns", "graph_nodes", "graph_arcs", *ASSOCIATION_COUNTS)
_NEVER_NULL = (
    "schema_version scenario driver fingerprint algorithm answer status stop seed window_k "
    "replicate scan scan_period_s"
).split()
_LEFT_OUT = " and was left out"

_TYPES = {"string": {str}, "integer": {int}, "number": {int, float}, "boolean": {bool}}

COLUMNS = tuple(_FIELDS)  # of the frame of a run
WINDOW_KEY = ["scenario", "scan_period_s", "replicate", "window_k", "scan"]


class RunError(Exception):
    """A run that cannot be used; the message is one sentence for people."""


@dataclass(frozen=True)
class Run:
    """A loaded run."""

    name: str  # of its directory
    manifest: dict[str, Any]
    rows: pd.DataFrame  # one per (window, algorithm), sorted by that key; null as NaN
    warnings: list[str]


def load_run(directory: Path) -> Run:
    """The run in `directory`.

    A last line that cannot be read is what an interrupted write leaves behind: it is left out with
    a warning. Everything else that is not as results/README.md says raises RunError.
    """
    if not directory.is_dir():
        raise RunError(f"there is no run directory {directory}")
    manifest = load_manifest(directory / "manifest.json")
    path = directory / "rows.jsonl"
    if not path.is_file():
        raise RunError(f"{directory} has no rows.jsonl")
    warnings: list[str] = []
    rows = _frame(list(_parse(path, warnings)), path)
    _check_versions(rows, manifest, path)
    unknown = set(rows["status"]) - set(STATUSES)
    if unknown:
        raise RunError(f"{path} has rows of unknown status: {_listed(unknown)}")
    rows = rows.sort_values([*WINDOW_KEY, "algorithm"], ignore_index=True)
    _check_keys(rows, path)
    return Run(directory.resolve().name, manifest, rows, warnings)


def load_manifest(path: Path) -> dict[str, Any]:
    """The manifest of a run, or another object in a file of its own; raises RunError."""
    if not path.is_file():
        raise RunError(f"{path.parent} has no {path.name}")
    try:
        manifest = json.loads(path.read_bytes())
    except (ValueError, RecursionError) as error:
        raise RunError(f"{path} is not JSON: {error}") from None
    if not isinstance(manifest, dict):
        raise RunError(f"{path} does not hold an object")
    return manifest


def unfinished(directory: Path) -> list[str]:
    """A sentence about a run that its manifest does not call finished; none about others."""
    manifest = load_manifest(directory / "manifest.json")
    outcome = manifest.get("outcome", "finished")
    if outcome == "finished":
        return []
    told = {"running": "it is still running, or was killed"}.get(outcome, str(outcome))
    summary = manifest.get("summary")
    cells = summary if isinstance(summary, dict) else {}
    done, asked = cells.get("cells_finished"), cells.get("cells")
    of = f", {done} of {asked} cells" if asked and outcome != "running" else ""
    return [f"The run {directory.resolve().name} did not finish ({told}{of}): what follows is of "
            "the part that is there."]


def check_torn(directory: Path, torn: list[str]) -> None:
    """Raises RunError if lines were left out as torn, `torn` says which, of a run that its manifest
    calls finished: only one that was stopped may end like that."""
    if torn and not unfinished(directory):
        raise RunError(torn[0].replace(_LEFT_OUT, ", though the run finished: the file is damaged, "
                                       "or not all of it was copied"))


def json_lines(path: Path, warnings: list[str]) -> Iterator[dict[str, Any]]:
    """The objects of a file of lines; a torn last line is left out with a warning."""
    decode = json.JSONDecoder(parse_constant=_refuse_constant).decode
    broken: tuple[int, str] | None = None
    with path.open("rb") as lines:
        for number, line in enumerate(lines, start=1):
            if broken:
                raise RunError(f"{path}:{broken[0]}: the line is not JSON: {broken[1]}")
            try:
                row = decode(line.decode())
            except (ValueError, RecursionError) as error:
                broken = (number, str(error))
                continue
            if not isinstance(row, dict):
                raise RunError(f"{path}:{number}: the line does not hold an object")
            yield row
    if broken:
        warnings.append(f"{path}:{broken[0]}: the last line is torn{_LEFT_OUT}")


def _parse(path: Path, warnings: list[str]) -> Iterator[tuple[Any, ...]]:
    """The _FIELDS of every line, in order."""
    pick = itemgetter(*_FIELDS)
    for number, row in enumerate(json_lines(path, warnings), start=1):
        for name in _MAY_BE_ABSENT:
            row.setdefault(name, None)
        try:
            yield pick(row)
        except KeyError as error:
            raise RunError(f"{path}:{number}: the row has no field {error}") from None


def _refuse_constant(word: str) -> None:
    raise ValueError(f"{word} is not allowed in a row")


def _frame(rows: list[tuple[Any, ...]], path: Path) -> pd.DataFrame:
    if not rows:
        raise RunError(f"{path} holds no rows")
    columns = {}
    for (name, kind), values in zip(_FIELDS.items(), zip(*rows)):
        allowed = _TYPES[kind] | (set() if name in _NEVER_NULL else {type(None)})
        if not set(map(type, values)) <= allowed:
            line = next(i for i, v in enumerate(values, start=1) if type(v) not in allowed)
            value = json.dumps(values[line - 1])
            raise RunError(f"{path}:{line}: {name} is {value}, not of type {kind}")
        if kind == "string":
            columns[name] = pd.Categorical(values)
        else:
            columns[name] = _numbers(values, kind == "integer" and name in _NEVER_NULL)
            if columns[name] is None:
                raise RunError(f"{path}: {name} is too large in some line")
    return pd.DataFrame(columns)


def _numbers(values: tuple[Any, ...], whole: bool) -> np.ndarray | None:
    """Null as NaN; None if one of them is beyond the numbers of the machine."""
    try:
        found = np.array(values, dtype=None if whole else float)
    except OverflowError:
        return None
    return None if found.dtype == object or np.isinf(found).any() else found


def _check_versions(rows: pd.DataFrame, manifest: dict[str, Any], path: Path) -> None:
    versions = set(rows["schema_version"]) | {manifest.get("schema_version", SCHEMA_VERSION)}
    if len(versions) > 1:
        raise RunError(f"{path} and its manifest mix schema versions: {_listed(versions)}")
    if versions != {SCHEMA_VERSION}:
        raise RunError(f"{path} has schema version {_listed(versions)}; read is {SCHEMA_VERSION}")


def _check_keys(rows: pd.DataFrame, path: Path) -> None:
    for name in ("seed", "driver"):
        if rows[name].nunique() > 1:
            raise RunError(f"{path} mixes rows of several {name}s: {_listed(set(rows[name]))}")
    twice = rows.duplicated([*WINDOW_KEY, "algorithm"])
    if twice.any():
        row = rows[twice].iloc[0]
        raise RunError(f"{path} has two rows of {row['algorithm']} for {window_name(row)}")
    same_window = (rows[WINDOW_KEY] == rows[WINDOW_KEY].shift()).all(axis=1)
    differs = same_window & (rows["fingerprint"] != rows["fingerprint"].shift())
    if differs.any():
        row = rows[differs].iloc[0]
        raise RunError(f"{path} has two different problems for {window_name(row)}")


def window_name(row: pd.Series) -> str:
    """The window of a row, for people."""
    return (
        f"scenario {row['scenario']} at {row['scan_period_s']:g} s, replicate {row['replicate']}, "
        f"K = {row['window_k']}, scan {row['scan']}"
    )


def _listed(values: set[Any]) -> str:
    return ", ".join(sorted(map(str, values)))
