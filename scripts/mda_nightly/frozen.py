"""Frozen windows: files that one revision writes and every revision solves."""

import subprocess
from pathlib import Path

from mda_nightly.cells import WINDOW_SETS
from mda_results.rows import RunError


def freeze(mda_bench: Path, directory: Path) -> Path:
    """Makes `directory` hold the windows of WINDOW_SETS and no others; returns it. What is there is
    not written again. Raises RunError when the program fails."""
    for name, windows in WINDOW_SETS.items():
        (directory / name).mkdir(parents=True, exist_ok=True)
        wanted = {directory / name / f"{replicate:02d}-{scan:02d}.json": (replicate, scan)
                  for replicate in windows.replicates for scan in windows.scans}
        for stray in set((directory / name).iterdir()) - set(wanted):
            stray.unlink()
        for path, (replicate, scan) in wanted.items():
            if not path.is_file():
                _run([str(mda_bench), "export", windows.scenario, "--scan", str(scan),
                      "--window", str(windows.window_k), "--replicate", str(replicate),
                      "--format", "json", "--out", str(path)])
    return directory


def _run(words: list[str]) -> None:
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False)
    except OSError as error:
        raise RunError(f"{words[0]} cannot be run: {error.strerror}") from None
    if done.returncode != 0:
        raise RunError(f"{' '.join(words)} ended with exit code {done.returncode}: "
                       f"{done.stderr.strip()}")
