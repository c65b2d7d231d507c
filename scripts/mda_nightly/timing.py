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


def prepare(wanted: Sequence[Cell], sides: Sequence[Side], windows: Path, needed: Sequence[str],
            quantum: int = 1) -> tuple[list[Task], dict[str, dict[str, str]]]:
    """Runs every cell once on every side, and asks the first side how many passes it takes (a
    multiple of `quantum`). Returns the tasks of cells that run on all sides named in `needed`, and
    by cell and side why one did not run. A cell that runs nowhere is in neither."""
    tasks, broken = [], {}
    for cell in wanted:
        able, passes = [], 1
        for side in sides:
            try:
                sample = cells.run(cell, side.programs, windows, 1)
            except CellError as error:
                broken.setdefault(cell.name, {})[side.name] = str(error)
                continue
            if cell.on_windows and not able:
                whole = math.ceil(cells.SAMPLE_S / max(sample.cpu_s, 1e-7))
                passes = quantum * math.ceil(whole / quantum)
            able.append(side)
        if set(needed) <= {side.name for side in able}:
            tasks.append(Task(cell, tuple(able), passes))
        elif not able:
            del broken[cell.name]
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
