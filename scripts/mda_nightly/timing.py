"""Takes the samples of a session.

A round of a cell starts one process per side, lets each warm up, and then gives them turns of some
milliseconds in random order: whatever the machine does to one, it does to the others. Rounds start
new processes, since where a process lies in memory is luck that lasts as long as it does.
"""

import json
import math
import random
import sys
import time
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from mda_nightly import cells, judging
from mda_nightly.cells import Cell, CellError, Player

ROUNDS = 13  # 4 n + 1 is a good number: the median is a round, and n rounds may be spoilt
TURNS = 8  # of each side in a round


@dataclass(frozen=True)
class Side:
    """One of the programs that are compared."""

    name: str
    programs: Path  # directory
    passes_more: int = 0  # in every cells.PASS_QUANTUM: work planted by the experiment on noise


@dataclass(frozen=True)
class Task:
    """A cell, the sides that have it, and how many passes make a turn long enough."""

    cell: Cell
    sides: tuple[Side, ...]
    passes: int = 1


def prepare(wanted: Sequence[Cell], sides: Sequence[Side], windows: Path,
            quantum: int = 1) -> tuple[list[Task], dict[str, dict[str, str]]]:
    """Runs every cell on every side; the first that can says how many passes make a turn, a
    multiple of `quantum`. Returns the tasks with the sides that can, and by cell and side why one
    could not."""
    tasks, broken = [], {}
    for cell in wanted:
        able, passes, why = [], 1, {}
        for side in sides:
            try:
                pass_s = _pass_s(cell, side, windows)
            except CellError as error:
                why[side.name] = str(error)
                continue
            if cell.on_windows and not able:
                passes = quantum * math.ceil(cells.REPETITION_S / pass_s / quantum)
            able.append(side)
        if able:
            tasks.append(Task(cell, tuple(able), passes))
        if why:
            broken[cell.name] = why
    return tasks, broken


def _pass_s(cell: Cell, side: Side, windows: Path) -> float:
    with Player(cell, side.programs, windows) as player:
        return min(player.turn().cpu_s for _ in range(3))


def take(tasks: Sequence[Task], number: int, rounds: int, draw: random.Random, windows: Path,
         out: Path, budget_s: float = math.inf, before: int = 0) -> int:
    """Appends the samples of pass `number` to `out`, one turn at a time, after `before` rounds that
    are there; returns how many there are then, which the budget may cut to judging.LEAST_ROUNDS.
    Raises CellError when a cell that ran before fails."""
    began = time.monotonic()
    with out.open("a", encoding="utf-8") as lines:
        for r in range(before + 1, before + rounds + 1):
            for task in draw.sample(list(tasks), len(tasks)):
                for sample in _round(task, draw, windows):
                    line = {"cell": task.cell.name, "pass": number, "round": r, **sample}
                    lines.write(json.dumps(line, allow_nan=False) + "\n")
            lines.flush()
            _tell(number, r - before, rounds, time.monotonic() - began)
            if r >= judging.LEAST_ROUNDS and time.monotonic() - began > budget_s:
                return r
    return before + rounds


def _round(task: Task, draw: random.Random, windows: Path) -> list[dict[str, object]]:
    """A sample per side: CPU and wall seconds of an iteration, turn by turn."""
    passes = {s.name: task.passes + s.passes_more * task.passes // cells.PASS_QUANTUM
              for s in task.sides}
    with ExitStack() as stack:
        players = {s.name: stack.enter_context(Player(task.cell, s.programs, windows,
                                                      passes[s.name])) for s in task.sides}
        warm = {name: player.turn() for name, player in players.items()}
        began, pressure = time.monotonic(), _pressure_s()
        turns = []
        for _ in range(TURNS):
            order = draw.sample(sorted(players), len(players))
            taken = {name: players[name].turn() for name in order}
            turns.append(taken)
        stalled = (_pressure_s() - pressure) / (time.monotonic() - began)
    return [{"side": name, "passes": passes[name], "stalled": stalled,
             "cpu_s": [t[name].cpu_s for t in turns], "wall_s": [t[name].wall_s for t in turns],
             "counters": warm[name].counters} for name in players]


def _pressure_s() -> float:
    """Seconds in which somebody waited for a processor, since the system was started (PSI)."""
    try:
        some = Path("/proc/pressure/cpu").read_text(encoding="ascii").splitlines()[0]
        return float(some.rsplit("total=", 1)[1]) / 1e6
    except (OSError, IndexError, ValueError):
        return 0.0


def _tell(number: int, r: int, rounds: int, elapsed: float) -> None:
    if sys.stderr.isatty() or r in (1, rounds):
        what = "rounds" if number == 1 else "rounds again"
        print(f"{r} of {rounds} {what}, {elapsed:.0f} s", file=sys.stderr)
