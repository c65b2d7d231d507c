"""The tables of studies that a page can show of its runs: the papers' figures beside ours."""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from mda_results import (battistelli2008, bojilov1995, claims, lee1998, scan_periods, storms2003,
                         storms2003_times, tracking)
from mda_results.known_targets import is_known
from mda_results.position_targets import is_position
from mda_results.render import Report
from mda_results.rows import Run, RunError, json_lines, load_run
from mda_results.three_sensors import is_sensors


@dataclass(frozen=True)
class Study:
    name: str  # of its place in the page
    report: Report


def studies(directories: Sequence[Path]) -> tuple[list[Study], list[str]]:
    """Every study that the runs have the rows for, and a sentence on each of the others that
    concerns them. The runs have been loaded once, so what is refused here is absent, not
    damaged."""
    found: list[Study] = []
    lacking: list[str] = []
    for name, make in _possible(directories):
        try:
            found.append(Study(name, make()))
        except RunError as error:
            lacking.append(f"Left out: {error}.")
    return found, lacking


def _possible(directories: Sequence[Path]) -> Iterator[tuple[str, Callable[[], Report]]]:
    runs = [load_run(d) for d in directories if has_lines(d / "rows.jsonl")]
    yield from _of_storms([run for run in runs if _has(run, "ABCD")])
    lee = []
    for directory in directories:
        name, scenarios = _word(directory.resolve().name), _scenarios(directory)
        if any(map(is_known, scenarios)):
            yield f"battistelli2008-{name}", lambda d=directory: battistelli2008.report(d)[0]
        if any(map(is_sensors, scenarios)):
            yield f"bojilov1995-{name}", lambda d=directory: bojilov1995.report(d)[0]
        if any(map(is_position, scenarios)):
            lee.append(directory)
        if _has_births(directory / "tracking.jsonl"):
            yield f"tracking-{name}", lambda d=directory: tracking.report(d)
    if lee:
        yield "lee1998", lambda: lee1998.report(lee)[0]


def _of_storms(runs: list[Run]) -> Iterator[tuple[str, Callable[[], Report]]]:
    """The tables of runs over groups A to D."""
    for run in runs:
        name = _word(run.name)
        yield f"storms2003-{name}", lambda run=run: storms2003.report(run)
        yield f"times-{name}", lambda run=run: storms2003_times.report(run)
        if run.rows["scan_period_s"].nunique() > 1:
            yield f"periods-{name}", lambda run=run: scan_periods.report(run)
    if runs:
        yield "claims", lambda: claims.report(runs)


def _scenarios(directory: Path) -> set[object]:
    """Names of scenarios in rows and outings."""
    return {line.get("scenario") for name in ("rows", "tracking")
            if has_lines(directory / f"{name}.jsonl")
            for line in json_lines(directory / f"{name}.jsonl", [])}


def has_lines(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > 0


def _has_births(path: Path) -> bool:
    return has_lines(path) and any(
        not is_known(line.get("scenario")) and not is_position(line.get("scenario"))
        for line in json_lines(path, []))


def _has(run: Run, groups: str) -> bool:
    return bool(run.rows["scenario"].isin(list(groups)).any())


def _word(name: str) -> str:
    return re.sub(r"[^\w-]+", "-", name)
