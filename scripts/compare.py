#!/usr/bin/python3
"""Compares two sides of a nightly session: is the candidate slower, or are its answers worse?"""

import argparse
import json
import sys
from pathlib import Path

from mda_nightly import comparison
from mda_nightly.comparison import Comparison
from mda_results.output import print_or_tell
from mda_results.render import to_json, to_markdown, to_text
from mda_results.rows import RunError

_WORDS = """\
BASE and CANDIDATE are directories of one session of scripts/nightly.sh, such as SESSION/baseline
and SESSION/candidate. Times are compared within a session only, where they were taken in turns.
Two runs of `mda-bench run` can be given instead; of them, the answers alone are compared.

  scripts/compare.py SESSION/baseline SESSION/candidate
  scripts/compare.py SESSION/anchor SESSION/candidate --format markdown
  scripts/compare.py results/runs/before results/runs/after

exit code: 0 no credible regression; 1 a regression; 4 the session is invalid, a program and its
own copy differ; 2 bad usage or input: one sentence, and no verdict; 5 writing failed
"""


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 no credible regression, 1 regression, 2 no verdict, 4 invalid, 5 not written."""
    parser = argparse.ArgumentParser(description=__doc__, epilog=_WORDS,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("base", type=_directory, metavar="BASE")
    parser.add_argument("candidate", type=_directory, metavar="CANDIDATE")
    parser.add_argument("--format", choices=["text", "markdown", "json"], default="text")
    options = parser.parse_args(arguments)
    try:
        found = comparison.compare(options.base, options.candidate)
    except RunError as error:
        print(f"compare.py: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"compare.py: cannot read {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    return print_or_tell(_printed(found, options.format), "compare.py") or found.exit_code


def _directory(word: str) -> Path:
    if not word:
        raise argparse.ArgumentTypeError("an empty word is no directory")
    return Path(word)


def _printed(found: Comparison, form: str) -> str:
    report = comparison.report(found)
    if form == "json":
        whole = {**comparison.machine_readable(found), **json.loads(to_json(report))}
        return json.dumps(whole, ensure_ascii=False, indent=1) + "\n"
    return (to_markdown if form == "markdown" else to_text)(report)


if __name__ == "__main__":
    sys.exit(main())
