"""Takes the samples of a session: sides in random order within a round, cells in random order."""

import json
import math
import random
import sys
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from mda_nightly import cells
from mda_nightly.cells import Cell, CellError


@dataclass(frozen=True)
class Side:
    """One of the programs that are compared."""

    name: str
    programs: Path  # directory
    passes_more: int = 0  # in every cells.PASS_QUANTUM: work planted by the experiment on noise


@dataclass(frozen=True)
class Task:
    """A cell, the sides that have it, and how many passes make a sample long enough."""

    cell: Cell
    sides: tuple[Side, ...]
    passes: int = 1


def prepare(wanted: Sequence[Cell], sides: Sequence[Side], windows: Path,
            quantum: int = 1) -> tuple[list[Task], dict[str, dict[str, str]]]:
    """Runs every cell once on every side; the first that can says how many passes make a sample, a
    multiple of `quantum`. Returns the tasks with the sides that can, and by cell and side why one
    could not. A cell that no side has is in neither."""
    tasks, broken = [], {}
    for cell in wanted:
        able, passes, why = [], 1, {}
        for side in sides:
            try:
                sample = cells.run(cell, side.programs, windows)
            except CellError as error:
                why[side.name] = str(error)
                continue
            if cell.on_windows and not able:
                needed = math.ceil(cells.SAMPLE_S / sample.cpu_s)
                passes = quantum * math.ceil(needed / quantum)
            able.append(side)
        if able:
            tasks.append(Task(cell, tuple(able), passes))
            if why:
                broken[cell.name] = why
    return tasks, broken


def take(tasks: Sequence[Task], number: int, rounds: int, draw: random.Random, windows: Path,
         out: Path, budget_s: float = math.inf) -> int:
    """Appends the samples of pass `number` to `out`, one process at a time; returns how many rounds
    there was time for. Raises CellError when a cell that ran before fails."""
    began = time.monotonic()
    with out.open("a", encoding="utf-8") as lines:
        for r in range(1, rounds + 1):
            for task in draw.sample(list(tasks), len(tasks)):
                for side in draw.sample(task.sides, len(task.sides)):
                    lines.write(_line(task, side, number, r, windows))
            lines.flush()
            _tell(number, r, rounds, time.monotonic() - began)
            if time.monotonic() - began > budget_s:
                return r
    return rounds


def _line(task: Task, side: Side, number: int, r: int, windows: Path) -> str:
    passes = task.passes + side.passes_more * task.passes // cells.PASS_QUANTUM
    sample = cells.run(task.cell, side.programs, windows, passes)
    line = {"cell": task.cell.name, "side": side.name, "pass": number, "round": r,
            "passes": passes, **asdict(sample), "contaminated": sample.contaminated}
    return json.dumps(line, allow_nan=False) + "\n"


def _tell(number: int, r: int, rounds: int, elapsed: float) -> None:
    if sys.stderr.isatty() or r in (1, rounds):
        what = "rounds" if number == 1 else "rounds again"
        print(f"{r} of {rounds} {what}, {elapsed:.0f} s", file=sys.stderr)
