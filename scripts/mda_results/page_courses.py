"""What closed loops tell scan by scan: means over the scenes of every list that an outing holds
with a number a scan (results/README.md, known targets)."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from mda_results.rows import RunError, json_lines

_KEY = ("scenario", "scan_period_s", "window_k", "algorithm")
_DIGITS = 5  # significant ones that a chart needs


def courses(directories: Sequence[Path]) -> list[dict[str, Any]]:
    """By _KEY: the number of scenes that finished and, by the name of the list, a mean per scan."""
    found: dict[tuple[Any, ...], dict[str, list[list[float]]]] = {}
    for path in (directory / "tracking.jsonl" for directory in directories):
        for line in json_lines(path, []) if path.is_file() else ():
            if line.get("status") != "finished":
                continue
            lists = found.setdefault(tuple(line[k] for k in _KEY), {})
            for name, value in line.items():
                if "series" in name.split("_") and _is_per_scan(value):
                    lists.setdefault(name, []).append(value)
    return [{**dict(zip(_KEY, key)), "scenes": max(map(len, lists.values())),
             "series": {name: _mean(values, key, name) for name, values in sorted(lists.items())}}
            for key, lists in sorted(found.items()) if lists]


def _is_per_scan(value: Any) -> bool:
    """Some series are lists per track, which no chart of means is made of."""
    return isinstance(value, list) and all(type(x) in (int, float) for x in value)


def _mean(values: list[list[float]], key: tuple[Any, ...], name: str) -> list[float]:
    if len(set(map(len, values))) > 1:
        raise RunError(f"the outings of {key[3]} on {key[0]} have {name} of different lengths")
    return [float(f"{mean:.{_DIGITS}g}") for mean in np.mean(values, axis=0)]
