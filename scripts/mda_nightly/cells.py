"""What is timed: cells, each a benchmark of one of the programs, and one run of such a cell."""

import json
import os
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

WINDOWS_PROGRAM = "windows_bench"
SAMPLE_S = 0.02  # of work in one sample: long against the clock, short against the neighbours
PASS_QUANTUM = 20  # passes come in multiples of it, so that one in twenty more is 5 % more work

_TIMEOUT_S = 120.0
_UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
_OF_THE_LIBRARY = frozenset((
    "name family_index per_family_instance_index run_name run_type repetitions repetition_index "
    "threads iterations real_time cpu_time time_unit label error_occurred error_message "
    "items_per_second bytes_per_second").split())


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
    "light": WindowSet("A", 3, (1, 2, 3), (10, 20, 30)),
    "wide": WindowSet("C", 7, (1, 2, 3), (10, 20, 30)),
    "crowded": WindowSet("D", 3, (1,), (10, 15)),
    # For the experiment on noise: a pass of any solver takes about a millisecond at most.
    "light1": WindowSet("A", 3, (1,), (20,)),
    "wide1": WindowSet("C", 7, (1,), (20,)),
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
    [Cell(f"light1/{solver}") for solver in (*_SOLVERS, "pdhg")]
    + [Cell(f"wide1/{solver}") for solver in _SOLVERS if solver != "cbc"])


class CellError(Exception):
    """A cell did not run; the message is one sentence."""


@dataclass(frozen=True)
class Sample:
    """One run of a cell. Times are of one iteration, that is of all passes, in seconds."""

    cpu_s: float
    wall_s: float
    stalled: float  # share of the process's life in which somebody waited for a processor (PSI)
    counters: dict[str, float]  # of the benchmark: what was worked on, and how much work it was

    @property
    def contaminated(self) -> bool:
        """Whether neighbours took the processor away; its wall time is not the program's own."""
        return self.wall_s - self.cpu_s > 0.05 * self.cpu_s or self.stalled > 0.02


def run(cell: Cell, programs: Path, windows: Path, passes: int = 1,
        min_time_s: float = SAMPLE_S) -> Sample:
    """Runs a cell in a process of its own. Raises CellError if it fails, or is not there."""
    began, pressure = time.monotonic(), _pressure_us()
    text = _output(command(cell, programs, windows, passes, min_time_s), cell)
    elapsed = time.monotonic() - began
    stalled = (_pressure_us() - pressure) / 1e6 / elapsed
    try:
        found = [b for b in json.loads(text)["benchmarks"] if b.get("run_type") == "iteration"]
    except (ValueError, KeyError):
        raise CellError(f"{cell.program} did not print JSON for {cell.name}") from None
    if len(found) != 1:
        raise CellError(f"{cell.program} has {len(found)} benchmarks named {cell.name}, not one")
    if found[0].get("error_occurred"):
        raise CellError(f"{cell.name} ended with an error: {found[0].get('error_message')}")
    return _sample(found[0], stalled)


def command(cell: Cell, programs: Path, windows: Path, passes: int,
            min_time_s: float) -> list[str]:
    """The process that runs a cell."""
    words = [str(programs / cell.program), f"--benchmark_filter=^{cell.name}(/iterations:1)?$",
             "--benchmark_format=json", f"--benchmark_min_time={min_time_s:g}"]
    return words + ([f"--windows={windows}", f"--passes={passes}"] if cell.on_windows else [])


def environment() -> dict[str, str]:
    """Of every process that is timed: one thread, every function bound before the first call."""
    return {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "LD_BIND_NOW": "1",
            "LC_ALL": "C"}


def _output(words: list[str], cell: Cell) -> str:
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=_TIMEOUT_S,
                              env=environment(), check=False)
    except OSError as error:
        raise CellError(f"{words[0]} cannot be run: {error.strerror}") from None
    except subprocess.TimeoutExpired:
        raise CellError(f"{cell.name} took more than {_TIMEOUT_S:g} s") from None
    if done.returncode != 0:
        last = (done.stderr.strip().splitlines() or ["nothing on standard error"])[-1]
        raise CellError(f"{cell.name} ended with exit code {done.returncode}: {last}")
    return done.stdout


def _sample(found: dict[str, Any], stalled: float) -> Sample:
    unit = _UNITS[found["time_unit"]]
    wall = found["real_time"] * unit
    # Kernels that time a part of their loop do so by the thread's CPU clock.
    cpu = wall if str(found["name"]).endswith("/manual_time") else found["cpu_time"] * unit
    counters = {k: float(v) for k, v in found.items()
                if k not in _OF_THE_LIBRARY and isinstance(v, (int, float)) and "/s" not in k}
    return Sample(cpu, wall, stalled, counters)


def _pressure_us() -> float:
    """Microseconds in which somebody waited for a processor, since the system was started."""
    try:
        some = Path("/proc/pressure/cpu").read_text(encoding="ascii").splitlines()[0]
        return float(some.rsplit("total=", 1)[1])
    except (OSError, IndexError, ValueError):
        return 0.0
