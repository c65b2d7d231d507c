#!/usr/bin/python3
"""Writes one HTML page about one or several runs, which needs nothing but itself."""

import argparse
import sys
from pathlib import Path

from mda_nightly import page_history
from mda_results import page
from mda_results.output import print_or_tell, write_whole
from mda_results.rows import RunError


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 well, 2 bad usage or input (nothing written), 5 writing failed."""
    options = _parse(arguments)
    try:
        more = [page_history.section(options.history)] if options.history else []
        made = page.make(options.runs, more)
    except RunError as error:
        print(f"report.py: {error}", file=sys.stderr)
        return 2
    for warning in made.warnings:
        print(f"report.py: warning: {warning}", file=sys.stderr)
    try:
        options.out.parent.mkdir(parents=True, exist_ok=True)
        write_whole(options.out, made.html)
    except OSError as error:
        print(f"report.py: cannot write to {options.out}: {error.strerror}", file=sys.stderr)
        return 5
    return print_or_tell(f"{options.out}\n", "report.py")


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, epilog="The chart library comes from scripts/setup.sh --report.")
    parser.add_argument("runs", type=Path, metavar="RUN", nargs="+", help="directory of a run")
    parser.add_argument("--out", type=Path, metavar="FILE", required=True,
                        help="the page, such as report.html")
    parser.add_argument("--history", type=Path, metavar="FILE",
                        help="add the nights of this file (scripts/history.py makes it)")
    options = parser.parse_args(arguments)
    if options.out.is_dir():
        parser.error(f"--out {options.out} is a directory")
    return options


if __name__ == "__main__":
    sys.exit(main())
