#!/usr/bin/python3
"""Shows every metric over the nights, where its level changed, and the commits that came in."""

import argparse
import sqlite3
import sys
from pathlib import Path

from mda_nightly import history, history_report
from mda_results.output import print_or_tell
from mda_results.render import to_json, to_markdown, to_text
from mda_results.rows import RunError

_ROOT = Path(__file__).resolve().parents[1]
_WRITERS = {"text": to_text, "markdown": to_markdown, "json": to_json}
_WORDS = """\
The database is made from the sessions at every call; nothing else writes to it. Sessions that are
unfinished or damaged are left out and named. scripts/report.py --history puts it into the page.

  scripts/history.py
  scripts/history.py --sessions DIR --database nights.sqlite --format json

exit code: 0 well, whatever changed; 2 bad usage or input; 5 writing failed
"""


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 well, 2 bad usage or input, 5 writing failed."""
    parser = argparse.ArgumentParser(description=__doc__, epilog=_WORDS,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sessions", type=Path, metavar="DIR",
                        default=_ROOT / "results" / "runs" / "nightly",
                        help="of all sessions [results/runs/nightly]")
    parser.add_argument("--database", type=Path, metavar="FILE",
                        default=_ROOT / "results" / "history.sqlite",
                        help="made anew [results/history.sqlite]")
    parser.add_argument("--format", choices=sorted(_WRITERS), default="text")
    options = parser.parse_args(arguments)
    try:
        for sentence in history.rebuild(options.sessions, options.database):
            print(f"history.py: warning: {sentence}", file=sys.stderr)
        nights, series = history.load(options.database)
    except RunError as error:
        print(f"history.py: {error}", file=sys.stderr)
        return 2
    except (OSError, sqlite3.OperationalError) as error:
        print(f"history.py: cannot write to {options.database}: {error}", file=sys.stderr)
        return 5
    return print_or_tell(_WRITERS[options.format](history_report.report(nights, series)),
                         "history.py")


if __name__ == "__main__":
    sys.exit(main())
