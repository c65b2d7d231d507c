"""What is timed: cells, each a benchmark of one of the programs, and a process that runs one."""

import json
import os
import select
import subprocess
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any

WINDOWS_PROGRAM = "windows_bench"
REPETITION_S = 0.0005  # long against the clock, shorter than what the scheduler hands out
REPETITIONS = 5  # in a turn; the least disturbed one counts
PATIENCE_S = 120.0  # with a program that does not answer
PASS_QUANTUM = 20  # of the experiment: 21 passes instead of 20 are 5 % more work


@dataclass(frozen=True)
class Cell:
    """A benchmark of a program. Cells of WINDOWS_PROGRAM are SET/ALGORITHM over frozen windows."""

    name: str
    program: str = WINDOWS_PROGRAM

    @property
    def on_windows(self) -> bool:
        return self.program == WINDOWS_PROGRAM


@dataclass(frozen=True)
class WindowSet:
    """Windows of a scenario, frozen as files by one revision for all."""

    scenario: str
    window_k: int
    replicates: tuple[int, ...]
    scans: tuple[int, ...]


WINDOW_SETS = {
    "light": WindowSet("A", 3, (1,), (10, 20, 30)),
    "wide": WindowSet("C", 7, (1,), (10, 20, 30)),
    "crowded": WindowSet("D", 3, (1,), (10,)),
    # For the experiment on noise: 20 passes of any of its solvers take about a millisecond.
    "light1": WindowSet("A", 3, (1,), (5,)),
    "medium1": WindowSet("B", 5, (1,), (5,)),
    "wide1": WindowSet("C", 7, (1,), (6,)),
}
_SOLVERS = ("lp", "lp-grp", "exact", "cbc", "greedy", "lagrangian-sd")
_KERNELS = {
    "assignment_bench": ("assignment/100", "assignment/400"),
    "flow_bench": ("gated_window/K:5/T:100/scf-assignment",
                   "gated_window/K:5/T:100/scf-networksimplex"),
    "harness_bench": ("referee_examine/0", "referee_certified_bound/0"),
    "marginal_bench": ("dense/jpda/16/21", "strip/lbp/20"),
    "scenarios_bench": ("filter_step", "predict_this_cpu", "grow/A/K:3/manual_time",
                        "extract/A/K:3/manual_time"),
    "single_scan_bench": ("solve/gnn/n:30/m:30",),
}
PROGRAMS = (WINDOWS_PROGRAM, *_KERNELS)
CELLS = tuple(
    [Cell(f"{windows}/{solver}") for windows in ("light", "wide", "crowded")
     for solver in _SOLVERS]
    + [Cell(name, program) for program, names in _KERNELS.items() for name in names])
EXPERIMENT_CELLS = tuple(
    Cell(f"{windows}/{solver}") for windows in ("light1", "medium1", "wide1")
    for solver in ("lp-grp", "exact", "greedy", "lagrangian-sd"))


class CellError(Exception):
    """A cell did not run; the message is one sentence."""


@dataclass(frozen=True)
class Turn:
    """Times of one iteration, that is of all passes, in seconds; what the benchmark counted."""

    cpu_s: float
    wall_s: float
    counters: dict[str, float]


class Player:
    """A process that runs a cell whenever it is its turn. A context manager."""

    def __init__(self, cell: Cell, programs: Path, windows: Path, passes: int = 1) -> None:
        self._cell = cell
        words = [*command(cell, programs, windows, passes), "--turns",
                 f"--benchmark_min_time={REPETITION_S:g}",
                 f"--benchmark_repetitions={REPETITIONS}"]
        try:
            self._process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                             stderr=subprocess.DEVNULL, text=True,
                                             env=environment())
        except OSError as error:
            raise CellError(f"{words[0]} cannot be run: {error.strerror}") from None

    def turn(self) -> Turn:
        """Raises CellError if the cell fails, or is not there."""
        try:
            self._process.stdin.write("\n")
            self._process.stdin.flush()
            if not select.select([self._process.stdout], [], [], PATIENCE_S)[0]:
                self._process.kill()
                raise CellError(f"{self._cell.name} did not answer within {PATIENCE_S:g} s")
            line = self._process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            raise CellError(f"{self._cell.program} does not run {self._cell.name}: exit code "
                            f"{self._process.wait()}")
        return self._turn_of(line)

    def _turn_of(self, line: str) -> Turn:
        try:
            found: dict[str, Any] = json.loads(line)
            if "error" in found:
                raise CellError(f"{self._cell.name} ended with an error: {found['error']}")
            # Kernels that time a part of their loop do so by the thread's CPU clock.
            clock = "wall_s" if "/manual_time" in found["name"] else "cpu_s"
            counters = {k: v for k, v in found["counters"].items()
                        if "/s" not in k and "per_second" not in k}
            return Turn(float(found[clock]), float(found["wall_s"]), counters)
        except (ValueError, KeyError):
            raise CellError(f"{self._cell.program} did not answer in JSON") from None

    def __enter__(self) -> "Player":
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self._process.stdout.close()
        try:
            self._process.stdin.close()
        except BrokenPipeError:
            pass
        self._process.wait()


def command(cell: Cell, programs: Path, windows: Path, passes: int) -> list[str]:
    """The process that runs a cell once."""
    words = [str(programs / cell.program), f"--benchmark_filter=^{cell.name}(/iterations:1)?$"]
    return words + ([f"--windows={windows}", f"--passes={passes}"] if cell.on_windows else [])


def environment() -> dict[str, str]:
    """Of every process that is timed: little, and one thread."""
    return {"PATH": os.environ.get("PATH", ""), "LC_ALL": "C", "OMP_NUM_THREADS": "1",
            "OPENBLAS_NUM_THREADS": "1"}
