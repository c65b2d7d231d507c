#!/usr/bin/python3
"""How often does the nightly cry falsely here, and does it find 5 % more work?"""

import argparse
import random
import shutil
import sys
from pathlib import Path

from mda_nightly import cells, comparison, experiment, frozen, judging, machine, sessions, timing
from mda_nightly.sessions import AGAIN, BASELINE, CANDIDATE, FIRST, TWIN
from mda_nightly.timing import Side
from mda_results.output import print_or_tell
from mda_results.render import to_markdown, to_text
from mda_results.rows import RunError

_ROOT = Path(__file__).resolve().parents[1]
_WORDS = """\
Each session times one program against two copies of itself, on 12 cells in randomly interleaved
rounds: the twin, for the gate, and the candidate, which must not be called slower or faster (A/A).
On one cell, drawn by the session's number, a third copy does 21 passes where the others do 20: it
must be called slower, and no other cell (A/B). Suspected cells are timed again before anybody is
told, as in every nightly. Sessions that are there are kept: run it again to go on.

  scripts/noise_experiment.py --out results/runs/noise
  scripts/noise_experiment.py --out results/runs/noise --sessions 0     the table of what is there

exit code: 0 well; 2 bad usage or input; 5 writing failed
"""


def main(arguments: list[str] | None = None) -> int:
    """Exit code: 0 well, 2 bad usage or input, 5 writing failed."""
    options = _parse(arguments)
    try:
        for number in range(1, options.sessions + 1):
            _session(options, number)
        report = experiment.report(options.out)
    except (RunError, cells.CellError) as error:
        print(f"noise_experiment.py: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"noise_experiment.py: cannot write to {options.out}: {error.strerror}",
              file=sys.stderr)
        return 5
    render = to_markdown if options.format == "markdown" else to_text
    return print_or_tell(render(report), "noise_experiment.py")


def _session(options: argparse.Namespace, number: int) -> None:
    """Takes the samples of one session, unless it is there."""
    directory = options.out / f"session-{number:03d}"
    if experiment.is_finished(directory):
        return
    shutil.rmtree(directory, ignore_errors=True)
    windows = frozen.freeze(_program("mda-bench"), options.out / "windows")
    draw = random.Random(number)
    planted = draw.choice(cells.EXPERIMENT_CELLS)
    sides = _sides(options.out / "programs")
    facts = {"schema_version": sessions.SCHEMA_VERSION, "id": f"noise-{number:03d}",
             "started": machine.now(), "machine": machine.state(_program("mda-bench")),
             "seed": number, "rounds": options.rounds, "planted": planted.name,
             "sides": {side.name: {"revision": "working tree", "commit": "",
                                   "programs": machine.hashes(side.programs, cells.PROGRAMS)}
                       for side in sides},
             "cells": {cell.name: {"program": cell.program} for cell in cells.EXPERIMENT_CELLS},
             "outcome": "running"}
    sessions.write_facts(directory, facts)
    print(f"session {number} of {options.sessions}", file=sys.stderr)
    facts["rounds"] = _measure(directory, sides, planted.name, draw, windows, options.rounds)
    sessions.write_facts(directory, {**facts, "ended": machine.now(), "outcome": "finished",
                                     "machine_at_end": machine.state(_program("mda-bench"))})


def _sides(directory: Path) -> list[Side]:
    """Four copies of the program: files of their own, in memory of their own."""
    sides = [Side(name, directory / name, int(name == experiment.PLANTED))
             for name in (BASELINE, TWIN, CANDIDATE, experiment.PLANTED)]
    for side in sides:
        side.programs.mkdir(parents=True, exist_ok=True)
        if not (side.programs / cells.WINDOWS_PROGRAM).is_file():
            shutil.copy2(_program(f"harness/{cells.WINDOWS_PROGRAM}"), side.programs)
    return sides


def _measure(directory: Path, sides: list[Side], planted: str, draw: random.Random, windows: Path,
             rounds: int) -> int:
    """Appends the samples; returns the rounds of the first pass."""
    out = directory / sessions.SAMPLES_FILE
    tasks, broken = timing.prepare(cells.EXPERIMENT_CELLS, sides[:1], windows,
                                   cells.PASS_QUANTUM)
    if broken:
        raise RunError(f"the experiment needs all its cells: {next(iter(broken.values()))}")
    tasks = [timing.Task(t.cell, tuple(sides[:4 if t.cell.name == planted else 3]), t.passes)
             for t in tasks]
    taken = timing.take(tasks, FIRST, rounds, draw, windows, out)
    if not comparison.copies_agree(sessions.load(directory, unfinished=True)):
        taken = timing.take(tasks, FIRST, rounds, draw, windows, out, before=rounds)
    for suspected in experiment.suspects(directory, planted):
        again = [timing.Task(t.cell, (sides[0], s), t.passes) for t in tasks for s in sides
                 if (t.cell.name, s.name) == suspected]
        timing.take(again, AGAIN, judging.AGAIN_FACTOR * rounds, draw, windows, out)
    return taken


def _program(name: str) -> Path:
    path = _ROOT / "build" / "release" / name
    if not path.is_file():
        raise RunError(f"there is no {path}: build it with scripts/build.sh")
    return path


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, epilog=_WORDS,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="of all sessions")
    parser.add_argument("--sessions", type=int, default=50, metavar="N",
                        help="numbered from 1 [50]")
    parser.add_argument("--rounds", type=int, default=timing.ROUNDS, metavar="R",
                        help=f"per session, at least {judging.LEAST_ROUNDS} [{timing.ROUNDS}]")
    parser.add_argument("--format", choices=["text", "markdown"], default="text")
    options = parser.parse_args(arguments)
    if options.sessions < 0 or options.rounds < judging.LEAST_ROUNDS:
        parser.error(f"--sessions must be 0 or more, --rounds {judging.LEAST_ROUNDS} or more")
    return options


if __name__ == "__main__":
    sys.exit(main())
