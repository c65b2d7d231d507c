#!/usr/bin/python3
"""Ranks the algorithms of recorded runs: which solver should I use, and how sure are you?"""

import argparse
import sys
from pathlib import Path

from mda_results import pool, rank_report
from mda_results.rank_report import Ranked, Selection
from mda_results.render import Report, csv_lines, to_json, to_markdown, to_text, write_csv
from mda_results.rows import RunError, unfinished
from mda_results.standings import SHIFT_MS

_WORDS = """\
How to read it
  Correctness comes first: one refuted claim disqualifies an algorithm ("out"), and is shown. Then
  the share of windows proven optimal; then the certified gap, the cost minus the best lower bound
  that anybody certified for the same problem; then CPU time, views included, as a shifted geometric
  mean in which a window without a result in time costs twice the time limit (PAR-2).

  Easy and hard windows are ranked apart. Easy: a certificate closes the gap, so the LP does the
  work. Hard: the best bound stays below the best known cost. All algorithms of a ranking are
  compared on the same windows; how many is stated. What failed, was declined or ran out of time is
  counted as such, never left out.

  Brackets hold 95 % of 2000 resamples of whole scenes (scenario, replicate): windows of one scene
  share their plots and are no independent draws. Places with overlapping intervals are not settled
  by this run. "p Holm" is Wilcoxon's test over scenes, adjusted for the number of pairs.

  A performance profile and the Pareto front depend on who takes part; --algorithms computes them
  anew. Relaxations and marginals have no gap and are ranked apart. Tracking measures come from
  closed loops and stand in a table of their own.

examples
  scripts/rank.py results/runs/smoke
  scripts/rank.py results/runs/storms2003 --scenarios D --windows 3
  scripts/rank.py RUN1 RUN2 --algorithms exact,cbc,lp-grp --format markdown
  scripts/rank.py RUN --tables ranking,pareto,pairs
  scripts/rank.py RUN --format json > ranking.json     # every table, unrounded
  scripts/rank.py RUN --format csv --out DIR           # one file per table, and the curves' data

exit code: 0 well, whatever the ranking says; 2 bad usage or input: one sentence, nothing printed;
5 writing failed
"""
_ENDINGS = {"text": "txt", "markdown": "md", "json": "json"}


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 well, 2 bad usage or input (nothing on standard output), 5 writing failed."""
    options = _parse(arguments)
    try:
        runs = pool.load(options.runs)
        ranked = rank_report.rank(runs, Selection(options.scenarios, options.windows,
                                                  options.algorithms), options.shift)
        if options.tables is not None:
            ranked = _only(ranked, options.tables)
    except RunError as error:
        print(f"rank.py: {error}", file=sys.stderr)
        return 2
    stopped = [told for directory in options.runs for told in unfinished(directory)]
    for warning in [*stopped, *runs.warnings]:
        print(f"rank.py: warning: {warning}", file=sys.stderr)
    try:
        if options.out is None:
            sys.stdout.reconfigure(encoding="utf-8")
            print(_printed(ranked, options.format), end="")
        else:
            print("\n".join(map(str, _write(ranked, options.format, options.out))))
    except OSError as error:
        print(f"rank.py: cannot write: {error.strerror}", file=sys.stderr)
        return 5
    return 0


def _only(ranked: Ranked, names: tuple[str, ...]) -> Ranked:
    tables = {t.name: t for t in _whole(ranked).tables}
    unknown = [name for name in names if name not in tables]
    if unknown:
        raise RunError(f"there is no table {unknown[0]}; there are {', '.join(tables)}")
    report = ranked.report
    return Ranked(Report(report.name, report.lines, [tables[name] for name in names]), [])


def _names(text: str) -> tuple[str, ...]:
    names = tuple(dict.fromkeys(name for name in text.split(",") if name))
    if not names:
        raise argparse.ArgumentTypeError("names, separated by commas, are missing")
    return names


def _numbers(text: str) -> tuple[int, ...]:
    try:
        return tuple(int(name) for name in _names(text))
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a list of whole numbers") from None


def _milliseconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"'{text}' is not a time above 0")
    return value


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, epilog=_WORDS, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=Path, metavar="RUN", nargs="+", help="directory of a run")
    parser.add_argument("--scenarios", type=_names, metavar="NAME,...", help="only these")
    parser.add_argument("--windows", type=_numbers, metavar="K,...", help="only these K")
    parser.add_argument("--algorithms", type=_names, metavar="NAME,...",
                        help="only these; bounds and best costs still come from all rows")
    parser.add_argument("--tables", type=_names, metavar="NAME,...",
                        help="only these tables, such as ranking,pareto; all are computed")
    parser.add_argument("--shift", type=_milliseconds, metavar="MS", default=SHIFT_MS,
                        help=f"of the geometric mean of times [{SHIFT_MS:g}]")
    parser.add_argument("--format", choices=[*_ENDINGS, "csv"], default="text",
                        help="csv without --out prints the table of the ranking alone [text]")
    parser.add_argument("--out", type=Path, metavar="DIR", help="write files there, not to the "
                        "screen")
    options = parser.parse_args(arguments)
    if options.out is not None and options.out.exists() and not options.out.is_dir():
        parser.error(f"--out {options.out} is not a directory")
    return options


def _printed(ranked: Ranked, form: str) -> str:
    if form == "csv":
        named = {t.name: t for t in ranked.report.tables}
        return csv_lines(named.get("ranking", ranked.report.tables[0]))
    if form == "json":
        return to_json(_whole(ranked))
    return (to_markdown if form == "markdown" else to_text)(ranked.report)


def _whole(ranked: Ranked) -> Report:
    report = ranked.report
    return Report(report.name, report.lines, [*report.tables, *ranked.data])


def _write(ranked: Ranked, form: str, directory: Path) -> list[Path]:
    directory.mkdir(parents=True, exist_ok=True)
    if form == "csv":
        return [write_csv(table, directory) for table in _whole(ranked).tables]
    path = directory / f"ranking.{_ENDINGS[form]}"
    path.write_text(_printed(ranked, form), encoding="utf-8")
    return [path]


if __name__ == "__main__":
    sys.exit(main())
