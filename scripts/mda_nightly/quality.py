"""Did the answers get worse? Two runs of the same windows, row by row; no clock is asked.

Answers are facts, not samples, so a change needs no interval. It has a direction when all windows
that changed changed to the same side, or when a sign test says so; else it is called mixed.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd

from mda_nightly import schema
from mda_nightly.schema import COUNT, NAME
from mda_results.render import Cell, Column, Table
from mda_results.rows import (SCHEMA_VERSION, WINDOW_KEY, RunError, json_lines, load_manifest,
                              load_run, window_name)

WORSE, BETTER, MIXED, EQUAL = "worse", "better", "mixed", "equal"
_ROWS, _OUTINGS, _MANIFEST = "rows.jsonl", "tracking.jsonl", "manifest.json"
_LEVEL = 0.05  # of the sign test
_OUTING_KEY = ["scenario", "scan_period_s", "window_k", "replicate"]


@dataclass(frozen=True)
class Measure:
    """A number of every row; what more of it means."""

    name: str
    of: Callable[[pd.DataFrame], pd.Series]
    more_is: str
    tolerance: Callable[[pd.Series], pd.Series | float] = lambda values: 1e-9


def _answered(rows: pd.DataFrame) -> pd.Series:
    return rows["status"].isin(["optimal", "feasible"]).astype(float)


def _cost_tolerance(values: pd.Series) -> pd.Series:
    return 1e-5 + 1e-9 * values.abs()


_OPEN = (
    Measure("failed or refuted", lambda r: (r["status"] == "failed").astype(float), WORSE),
    Measure("answered", _answered, BETTER),
    Measure("proven optimal", lambda r: (r["status"] == "optimal").astype(float), BETTER),
    Measure("gap [nats]", lambda r: r["gap_nats"], WORSE, _cost_tolerance),
    Measure("certified bound [nats]", lambda r: r["certified_bound_nats"], BETTER, _cost_tolerance),
    Measure("integral", lambda r: r["integral"].astype(float), BETTER),
)
_CLOSED = (
    Measure("finished", lambda r: (r["status"] == "finished").astype(float), BETTER),
    Measure("unanswered", lambda r: r["unanswered"], WORSE),
    Measure("GOSPA [km]", lambda r: r["gospa_km"], WORSE),
    Measure("correct association", lambda r: r["correct_association"], BETTER),
    Measure("breaks", lambda r: r["track_breaks"], WORSE),
    Measure("swaps", lambda r: r["swaps"], WORSE),
    Measure("lost", lambda r: r["lost"], WORSE),
)
_VERSION = schema.one_of(SCHEMA_VERSION)
_MANIFEST_FIELDS = {"schema_version": _VERSION, "outcome": schema.one_of("finished"),
                    "summary": schema.OBJECT}
_OUTING = {"schema_version": _VERSION, "scenario": NAME, "scan_period_s": schema.POSITIVE,
           "window_k": COUNT, "replicate": COUNT, "algorithm": NAME,
           "status": schema.one_of("finished", "failed", "skipped")}
_SCORES = dict.fromkeys(("unanswered", "gospa_km", "correct_association", "track_breaks", "swaps",
                         "lost"), schema.or_null(schema.NUMBER))  # of outings that finished


@dataclass(frozen=True)
class Difference:
    """Of one measure of one algorithm."""

    algorithm: str
    measure: str
    rows: int  # compared
    base: float  # means
    candidate: float
    worse: int
    better: int
    only: str = ""  # the one side that has the algorithm, if there is nothing to compare it with

    @property
    def word(self) -> str:
        return f"only in the {self.only}" if self.only else direction(self.worse, self.better)


def direction(worse: int, better: int) -> str:
    """EQUAL, WORSE, BETTER or MIXED, of the numbers of rows that changed to each side."""
    if worse == better == 0:
        return EQUAL
    less, more = sorted((worse, better))
    if less > 0 and sign_test(less, more) > _LEVEL:
        return MIXED
    return WORSE if worse > better else BETTER


def sign_test(less: int, more: int) -> float:
    """Two-sided p-value of so uneven a split of fair coins, or a more uneven one."""
    from scipy.stats import binomtest  # slow to import

    return float(binomtest(less, less + more).pvalue)


def open_loop(base: Path, candidate: Path) -> list[Difference]:
    """Of two finished runs with the same windows; raises RunError if they are not that. Algorithms
    that only one of them has are named."""
    first, second = (_rows(directory) for directory in (base, candidate))
    return _differences(first, second, [*WINDOW_KEY, "algorithm"], _OPEN, _same_problems)


def closed_loop(base: Path, candidate: Path) -> list[Difference]:
    """The same of two closed-loop runs, scene by scene."""
    first, second = (_outings(directory) for directory in (base, candidate))
    return _differences(first, second, [*_OUTING_KEY, "algorithm"], _CLOSED, lambda pairs: None)


def _check_whole(directory: Path) -> None:
    """The run finished, and has as many lines as its manifest says."""
    path = directory / _MANIFEST
    manifest = load_manifest(path)
    schema.check(manifest, _MANIFEST_FIELDS, path)
    schema.check(manifest["summary"], {"rows": COUNT}, path, "summary.")
    lines = 0
    for name in (_ROWS, _OUTINGS):
        if (directory / name).is_file():
            with (directory / name).open("rb") as text:
                lines += sum(1 for _ in text)
    if lines != manifest["summary"]["rows"]:
        raise RunError(f"{directory} holds {lines} rows, and its {_MANIFEST} "
                       f"{manifest['summary']['rows']}: no verdict")


def _rows(directory: Path) -> pd.DataFrame:
    _check_whole(directory)
    run = load_run(directory)
    for warning in run.warnings:
        raise RunError(f"{warning}: no verdict")
    return run.rows


def _outings(directory: Path) -> pd.DataFrame:
    _check_whole(directory)
    path, torn = directory / _OUTINGS, []
    if not path.is_file():
        raise RunError(f"{directory} has no {_OUTINGS}")
    lines: dict[tuple[object, ...], dict[str, object]] = {}
    for number, line in enumerate(json_lines(path, torn), start=1):
        where = f"{path}:{number}"
        schema.check(line, _OUTING, where)
        schema.check(line, _SCORES if line["status"] == "finished" else {}, where)
        key = tuple(line[name] for name in (*_OUTING_KEY, "algorithm"))
        if key in lines:
            raise RunError(f"{where}: this scene of {line['algorithm']} is there twice")
        lines[key] = line
    for warning in torn:
        raise RunError(f"{warning}: no verdict")
    return pd.DataFrame(list(lines.values()), columns=[*_OUTING, *_SCORES])


def _differences(first: pd.DataFrame, second: pd.DataFrame, key: list[str],
                 measures: tuple[Measure, ...],
                 check: Callable[[pd.DataFrame], None]) -> list[Difference]:
    sides = {"baseline": first, "candidate": second}
    names = {side: set(frame["algorithm"].astype(str)) for side, frame in sides.items()}
    lonely = set.symmetric_difference(*names.values())
    first, second = (f.astype({"algorithm": str, "scenario": str}) for f in (first, second))
    first, second = (f[~f["algorithm"].isin(lonely)] for f in (first, second))
    pairs = first.merge(second, on=key, how="outer", suffixes=("", " of candidate"),
                        indicator="side")
    _same_keys(pairs)
    check(pairs)
    found = [Difference(name, "all", 0, np.nan, np.nan, 0, 0, side)
             for side in names for name in sorted(names[side] & lonely)]
    for algorithm, own in pairs.groupby("algorithm", sort=True):
        halves = own[first.columns], own[[c if c in key else f"{c} of candidate"
                                          for c in first.columns]]
        halves[1].columns = first.columns
        found += [_difference(str(algorithm), m, *halves) for m in measures]
    return found


def _same_keys(pairs: pd.DataFrame) -> None:
    if not len(pairs):
        raise RunError("the two runs have no algorithm in common: no verdict")
    lonely = pairs[pairs["side"] != "both"]
    if len(lonely):
        row = lonely.iloc[0]
        whose = "baseline" if row["side"] == "left_only" else "candidate"
        raise RunError(f"the runs hold different instances: only the {whose} has {row['algorithm']} "
                       f"on scenario {row['scenario']}, replicate {row['replicate']}, K = "
                       f"{row['window_k']}: no verdict")


def _same_problems(pairs: pd.DataFrame) -> None:
    differ = pairs["fingerprint"].astype(str) != pairs["fingerprint of candidate"].astype(str)
    if differ.any():
        raise RunError("the runs hold different problems for "
                       f"{window_name(pairs[differ].iloc[0])}: no verdict")


def _difference(algorithm: str, measure: Measure, first: pd.DataFrame,
                second: pd.DataFrame) -> Difference:
    base, candidate = (pd.to_numeric(measure.of(f)).astype(float) for f in (first, second))
    known = base.notna() & candidate.notna()
    base, candidate = base[known], candidate[known]
    change = candidate - base
    more = int((change > measure.tolerance(base)).sum())
    less = int((change < -measure.tolerance(base)).sum())
    worse, better = (more, less) if measure.more_is == WORSE else (less, more)
    mean = [float(x.mean()) if len(x) else np.nan for x in (base, candidate)]
    return Difference(algorithm, measure.name, len(base), mean[0], mean[1], worse, better)


def table(name: str, title: str, found: list[Difference]) -> Table:
    """What changed; what did not is counted."""
    changed = [d for d in found if d.word != EQUAL]
    compared = [d for d in found if not d.only]
    rows: list[list[Cell]] = [[d.algorithm, d.measure, d.rows, d.base, d.candidate, d.worse,
                               d.better, d.word] for d in changed]
    notes = [f"{len(found) - len(changed)} of {len(compared)} measures are equal in every row. "
             "Worse or better: all rows that changed agree, or a sign test does (5 %)."]
    return Table(name, title, [
        Column("algorithm", once=True), Column("measure"), Column("n"),
        Column("baseline", "mean", ".6g"), Column("candidate", "mean", ".6g"),
        Column("worse", "rows"), Column("better", "rows"), Column("verdict")], rows, notes)


def commit_of(directory: Path) -> str:
    """Of a run's manifest, for people."""
    manifest = load_manifest(directory / _MANIFEST)
    return f"{str(manifest.get('commit', 'unknown'))[:12]}{'+' * bool(manifest.get('dirty'))}"
