#!/usr/bin/python3
"""Takes one session: answers, instructions and interleaved times of three revisions."""

import argparse
import random
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from mda_nightly import callgrind, cells, comparison, frozen, judging, machine, sessions, timing
from mda_nightly.cells import CellError
from mda_nightly.sessions import AGAIN, ANCHOR, BASELINE, CANDIDATE, FIRST, TWIN
from mda_nightly.timing import Side, Task
from mda_results.rows import RunError

_WORDS = """\
scripts/nightly.sh builds the programs and calls this; call it yourself to take another session of
programs that are built. DIR/COMMIT/ holds the programs of a commit.

exit code: 0 taken; 2 bad usage or input; 3 a program failed in the middle; 5 writing failed
"""


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 taken, 2 bad usage or input, 3 a program failed, 5 writing failed."""
    options = _parse(arguments)
    if options.check:
        return 0
    try:
        _take(options)
    except RunError as error:
        print(f"measure.py: {error}", file=sys.stderr)
        return 2
    except CellError as error:
        print(f"measure.py: {error}", file=sys.stderr)
        return 3
    except OSError as error:
        print(f"measure.py: cannot write to {options.out}: {error}", file=sys.stderr)
        return 5
    return 0


def _take(options: argparse.Namespace) -> None:
    sides = _sides(options)
    mda_bench = {side.name: side.programs / "mda-bench" for side in sides}
    windows = frozen.freeze(mda_bench[ANCHOR], options.programs / "windows" / options.anchor)
    options.out.mkdir(parents=True)
    facts: dict[str, Any] = {
        "schema_version": sessions.SCHEMA_VERSION, "id": options.out.resolve().name,
        "started": machine.now(), "machine": machine.state(mda_bench[CANDIDATE]),
        "seed": options.seed, "rounds": options.rounds, "windows_of": options.anchor,
        "sides": {side.name: _identity(side, options) for side in sides},
        "cells": {cell.name: {"program": cell.program} for cell in cells.CELLS},
        "outcome": "running"}
    sessions.write_facts(options.out, facts)
    for name in (BASELINE, CANDIDATE):
        (options.out / name).mkdir()
        _run_answers(mda_bench[name], options.out / name)
    print(f"trying {len(cells.CELLS)} cells", file=sys.stderr)
    tasks, facts["broken"] = timing.prepare(cells.CELLS, sides, windows)
    facts["counted"] = (_count(tasks, windows, facts, options.out / sessions.COUNTS_FILE)
                        if facts["machine"].get("valgrind") else 0)
    draw = random.Random(options.seed)
    samples = options.out / sessions.SAMPLES_FILE
    facts["rounds"] = timing.take(tasks, FIRST, options.rounds, draw, windows, samples,
                                  options.budget)
    if not comparison.copies_agree(sessions.load(options.out, unfinished=True)):
        print("the copies differ: as many rounds again", file=sys.stderr)
        facts["rounds"] = timing.take(tasks, FIRST, options.rounds, draw, windows, samples,
                                      options.budget, facts["rounds"])
    again = _suspected(tasks, options.out)
    facts["rounds_again"] = (timing.take(again, AGAIN, judging.AGAIN_FACTOR * options.rounds, draw,
                                         windows, samples) if again else 0)
    sessions.write_facts(options.out, {
        **facts, "ended": machine.now(), "machine_at_end": machine.state(mda_bench[CANDIDATE]),
        "outcome": "finished"})


def _sides(options: argparse.Namespace) -> list[Side]:
    """The baseline, a copy of it, the candidate and the anchor."""
    twin = options.programs / "twin"
    shutil.rmtree(twin, ignore_errors=True)
    found = {BASELINE: options.programs / options.baseline, TWIN: twin,
             CANDIDATE: options.programs / options.candidate,
             ANCHOR: options.programs / options.anchor}
    for name, programs in found.items():
        if name != TWIN and not (programs / "mda-bench").is_file():
            raise RunError(f"there is no {name}: {programs} has no mda-bench")
    shutil.copytree(found[BASELINE], twin)
    return [Side(name, programs) for name, programs in found.items()]


def _identity(side: Side, options: argparse.Namespace) -> Mapping[str, Any]:
    commit = getattr(options, BASELINE if side.name == TWIN else side.name)
    return {"revision": commit, "commit": commit,
            "programs": machine.hashes(side.programs, cells.PROGRAMS)}


def _run_answers(mda_bench: Path, side: Path) -> None:
    """Runs the sweep smoke in open and in closed loop; refuted claims and failed cells are found in
    the rows."""
    for name, more in ((comparison.OPEN, []), (comparison.CLOSED, ["--closed-loop"])):
        words = [str(mda_bench), "run", "smoke", "--out", str(side / name), *more]
        print(" ".join(words), file=sys.stderr)
        done = subprocess.run(words, stdout=subprocess.DEVNULL, check=False)
        if done.returncode not in (0, 1, 3):
            raise RunError(f"'{' '.join(words)}' ended with exit code {done.returncode}")


def _count(tasks: list[Task], windows: Path, facts: Mapping[str, Any], out: Path) -> int:
    """Writes counts.jsonl; returns how many there are."""
    print(f"counting instructions of {len(tasks)} cells", file=sys.stderr)
    counted = [Task(t.cell, tuple(s for s in t.sides if s.name != TWIN)) for t in tasks]
    programs = {name: side["programs"] for name, side in facts["sides"].items()}
    workers = max(1, facts["machine"]["cores"])
    counts = callgrind.count_all(counted, windows, programs, workers)
    sessions.write_counts(out, counts)
    return len(counts)


def _suspected(tasks: list[Task], directory: Path) -> list[Task]:
    """Baseline and candidate of the cells that are to be timed again."""
    found = comparison.suspects(sessions.load(directory, unfinished=True))
    return [Task(t.cell, tuple(s for s in t.sides if s.name in (BASELINE, CANDIDATE)), t.passes)
            for t in tasks if t.cell.name in found]


class _ListPrograms(argparse.Action):
    """As --help: prints and ends."""

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        print("\n".join(cells.PROGRAMS))
        parser.exit()


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, epilog=_WORDS,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list-programs", action=_ListPrograms, nargs=0,
                        help="print which programs a commit may have")
    parser.add_argument("out", type=Path, metavar="SESSION", help="new directory")
    parser.add_argument("--programs", type=Path, metavar="DIR", required=True)
    for name, what in ((BASELINE, "what is compared with"), (CANDIDATE, "what is judged"),
                       (ANCHOR, "what history refers to; it freezes the windows, too")):
        parser.add_argument(f"--{name}", metavar="COMMIT", required=True, help=what)
    parser.add_argument("--rounds", type=int, default=timing.ROUNDS, metavar="R",
                        help=f"at least {judging.LEAST_ROUNDS} [{timing.ROUNDS}]")
    parser.add_argument("--budget", type=float, default=400.0, metavar="SECONDS",
                        help="no more rounds than needed after so long [400]")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="of the order [1]")
    parser.add_argument("--check", action="store_true",
                        help="look at the arguments only: before the programs are built")
    options = parser.parse_args(arguments)
    if not options.budget > 0:
        parser.error("--budget must be more than 0")
    if options.rounds < judging.LEAST_ROUNDS:
        parser.error(f"--rounds must be {judging.LEAST_ROUNDS} or more")
    if options.out.exists():
        parser.error(f"{options.out} is there already")
    return options


if __name__ == "__main__":
    sys.exit(main())
