#!/usr/bin/python3
"""Prints tables from the rows of a run, published figures beside ours where there are any."""

import argparse
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from mda_results import (battistelli2008, bojilov1995, certified, claims, lee1998, scan_periods,
                         storms2003, storms2003_times, tracking)
from mda_results.output import print_or_tell
from mda_results.render import Report, to_markdown, to_text, write_csv
from mda_results.rows import Run, RunError, load_run, unfinished

_TABLES = {
    "battistelli2008": lambda directories: battistelli2008.report(_only(directories)),
    "bojilov1995": lambda directories: bojilov1995.report(_only(directories)),
    "certified": lambda directories: _open_loop(_only(directories), certified.report),
    "claims": lambda directories: _claims(directories),
    "lee1998": lambda directories: lee1998.report(directories),
    "scan-periods": lambda directories: _open_loop(_only(directories), scan_periods.report),
    "storms2003": lambda directories: _open_loop(_only(directories), storms2003.report),
    "storms2003-times": lambda directories: _open_loop(_only(directories),
                                                       storms2003_times.report),
    "tracking": lambda directories: (tracking.report(_only(directories)), []),
}
_WRITERS = {"text": (to_text, "txt"), "markdown": (to_markdown, "md")}


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 well, 2 bad usage or input (nothing on standard output), 5 writing failed."""
    options = _parse(arguments)
    try:
        report, warnings = _TABLES[options.tables](options.runs)
        notes = [note for run in options.runs for note in unfinished(run)]
    except RunError as error:
        print(f"tables.py: {error}", file=sys.stderr)
        return 2
    report = replace(report, lines=[*notes, *report.lines])
    for warning in [*notes, *warnings]:
        print(f"tables.py: warning: {warning}", file=sys.stderr)
    if options.out is None:
        return print_or_tell(_WRITERS[options.format][0](report), "tables.py")
    try:
        written = _write(report, options.tables, options.format, options.out)
    except RunError as error:
        print(f"tables.py: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"tables.py: cannot write to {options.out}: {error.strerror}", file=sys.stderr)
        return 5
    return print_or_tell("".join(f"{path}\n" for path in written), "tables.py")


def _only(directories: list[Path]) -> Path:
    if len(directories) > 1:
        raise RunError("these tables are made from one run; only claims and lee1998 take several")
    return directories[0]


def _claims(directories: list[Path]) -> tuple[Report, list[str]]:
    runs = [load_run(directory) for directory in directories]
    return claims.report(runs), [w for run in runs for w in run.warnings]


def _open_loop(directory: Path, report: Callable[[Run], Report]) -> tuple[Report, list[str]]:
    run = load_run(directory)
    return report(run), run.warnings


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tables", choices=sorted(_TABLES), help="which tables")
    parser.add_argument("runs", type=Path, metavar="RUN", nargs="+",
                        help="directory of a run; claims takes several, for their gates, lee1998 "
                             "for their updates")
    parser.add_argument("--format", choices=[*_WRITERS, "csv"], default="text")
    parser.add_argument("--out", type=Path, metavar="DIR",
                        help="write files there, figures too, instead of printing; needed for csv")
    options = parser.parse_args(arguments)
    if options.format == "csv" and options.out is None:
        parser.error("--format csv writes one file per table and needs --out DIR")
    if options.out is not None and options.out.exists() and not options.out.is_dir():
        parser.error(f"--out {options.out} is not a directory")
    return options


def _write(report: Report, name: str, form: str, directory: Path) -> list[Path]:
    directory.mkdir(parents=True, exist_ok=True)
    written = []
    for figure_name, draw in report.figures.items():
        figure = draw()
        for ending in ("svg", "png"):
            written.append(directory / f"{figure_name}.{ending}")
            figure.savefig(written[-1], dpi=120)
    if form == "csv":
        return written + [write_csv(table, directory) for table in report.tables]
    render, ending = _WRITERS[form]
    path = directory / f"{name}.{ending}"
    path.write_text(render(report), encoding="utf-8")
    return [*written, path]


if __name__ == "__main__":
    sys.exit(main())
