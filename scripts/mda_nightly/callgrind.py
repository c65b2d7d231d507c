"""Instructions of the timed loop of a cell, counted by valgrind: the same every time, on any load.

Never to be used to rank two algorithms: valgrind replaces parts of the C library, and instructions
differ in what they take. Of one cell before and after a change they tell what the clock cannot.
"""

import re
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mda_nightly import cells
from mda_nightly.cells import Cell, CellError
from mda_nightly.timing import Side, Task

# What Google Benchmark calls before the first and after the last iteration.
_START, _STOP = "benchmark::State::StartKeepRunning()", "benchmark::State::FinishKeepRunning()"
_TIMEOUT_S = 300.0


def count(cell: Cell, programs: Path, windows: Path) -> int:
    """Instructions of one iteration: one pass of windows, else the first call of the kernel."""
    with tempfile.TemporaryDirectory(prefix="mda-callgrind-") as place:
        out = Path(place) / "profile"
        words = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}",
                 f"--zero-before={_START}", f"--dump-before={_STOP}",
                 *cells.command(cell, programs, windows, 1), "--benchmark_min_time=0"]
        try:
            done = subprocess.run(words, capture_output=True, text=True, timeout=_TIMEOUT_S,
                                  env={**cells.environment(), "LD_BIND_NOW": "1"}, check=False)
        except OSError as error:
            raise CellError(f"valgrind cannot be run: {error.strerror}") from None
        except subprocess.TimeoutExpired:
            raise CellError(f"{cell.name} under valgrind took more than {_TIMEOUT_S:g} s") from None
        if done.returncode != 0:
            raise CellError(f"{cell.name} under valgrind ended with exit code {done.returncode}")
        return _total(out.with_name("profile.1"), cell)


def _total(profile: Path, cell: Cell) -> int:
    """Of the part that was dumped when the loop ended."""
    found = (re.search(r"^(?:summary|totals): (\d+)", profile.read_text(encoding="utf-8"), re.M)
             if profile.is_file() else None)
    if not found:
        raise CellError(f"valgrind did not see the loop of {cell.name}")
    return int(found[1])


def count_all(tasks: Sequence[Task], windows: Path, programs: Mapping[str, Mapping[str, str]],
              workers: int) -> dict[tuple[str, str], int]:
    """By (cell, side). `programs`: hashes by side and name; equal files are counted once. `workers`
    at a time, since neighbours do not change the count. Cells that valgrind does not bear are left
    out."""
    def key(cell: Cell, side: Side) -> tuple[Cell, str]:
        return cell, programs[side.name][cell.program]

    jobs = {key(task.cell, side): side for task in tasks for side in task.sides}

    def job(item: tuple[tuple[Cell, str], Side]) -> int | None:
        try:
            return count(item[0][0], item[1].programs, windows)
        except CellError:
            return None

    with ThreadPoolExecutor(workers) as pool:
        found = dict(zip(jobs, pool.map(job, jobs.items())))
    counts = {(task.cell.name, side.name): found[key(task.cell, side)]
              for task in tasks for side in task.sides}
    return {names: n for names, n in counts.items() if n is not None}
