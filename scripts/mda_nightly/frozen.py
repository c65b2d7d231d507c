"""Frozen windows: files that one revision writes and every revision solves."""

import subprocess
from pathlib import Path

from mda_nightly.cells import WINDOW_SETS
from mda_results.rows import RunError


def freeze(mda_bench: Path, directory: Path) -> Path:
    """Writes the windows of WINDOW_SETS below `directory`, as far as they are not there yet; returns
    it. Raises RunError when the program fails."""
    for name, windows in WINDOW_SETS.items():
        (directory / name).mkdir(parents=True, exist_ok=True)
        for replicate in windows.replicates:
            for scan in windows.scans:
                path = directory / name / f"{replicate:02d}-{scan:02d}.json"
                if path.is_file():
                    continue
                words = [str(mda_bench), "export", windows.scenario, "--scan", str(scan),
                         "--window", str(windows.window_k), "--replicate", str(replicate),
                         "--format", "json", "--out", str(path)]
                _run(words)
    return directory


def _run(words: list[str]) -> None:
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False)
    except OSError as error:
        raise RunError(f"{words[0]} cannot be run: {error.strerror}") from None
    if done.returncode != 0:
        raise RunError(f"{' '.join(words)} ended with exit code {done.returncode}: "
                       f"{done.stderr.strip()}")
