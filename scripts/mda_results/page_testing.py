"""Synthetic scenes for the tests of the page: what a run would write into scenes.jsonl."""

import json
import math
import random
from pathlib import Path
from typing import Any

Track = list[int]  # first scan, then a plot number a scan, -1 for a miss

SCANS, TARGETS, CLUTTER, RANGE_KM, K = 12, 5, 4, 50.0, 3


def scene(seed: int = 1, **changes: Any) -> dict[str, Any]:
    """Targets that fly straight, seen nine times in ten; `truthful` answers right, `confused`
    exchanges the plots of the first two targets in every other scan."""
    draw = random.Random(seed)
    starts = [(draw.uniform(-40, 40), draw.uniform(-40, 40), draw.uniform(0, 2 * math.pi))
              for _ in range(TARGETS)]
    paths = [[[x + 1.6 * n * math.cos(a), y + 1.6 * n * math.sin(a)] for n in range(SCANS)]
             for x, y, a in starts]
    plots = [_plots(draw, [path[n] for path in paths]) for n in range(SCANS)]
    right = [_track(plots, target) for target in range(TARGETS)]
    wrong = [_exchanged(right[0], right[1]), _exchanged(right[1], right[0]), *right[2:]]
    line = {
        "schema_version": 1, "scenario": "A", "scan_period_s": 8.0, "seed": 1, "replicate": 1,
        "range_km": RANGE_KM, "plots": plots,
        "targets": [{"first_scan": 1, "positions_km": path} for path in paths],
        "answers": [
            _answer("exact", "open", [_windows(right, n) for n in range(1, SCANS + 1)]),
            _answer("greedy", "open", [_windows(wrong, n) for n in range(1, SCANS + 1)]),
            _answer("exact", "closed", [{"scan": SCANS, "tracks": right}])],
    }
    return {**line, **changes}


def write_scenes(run: Path, scenes: list[dict[str, Any]], tail: str = "") -> Path:
    (run / "scenes.jsonl").write_text("".join(json.dumps(s) + "\n" for s in scenes) + tail)
    return run


def _plots(draw: random.Random, positions: list[list[float]]) -> list[list[float]]:
    seen = [[x + draw.gauss(0, 0.1), y + draw.gauss(0, 0.1), target]
            for target, (x, y) in enumerate(positions) if draw.random() < 0.9]
    false = [[draw.uniform(-45, 45), draw.uniform(-45, 45), -1] for _ in range(CLUTTER)]
    return sorted(seen + false, key=lambda plot: math.hypot(plot[0], plot[1]))


def _track(plots: list[list[list[float]]], target: int) -> Track:
    return [1, *(next((i for i, plot in enumerate(scan) if plot[2] == target), -1)
                 for scan in plots)]


def _exchanged(own: Track, other: Track) -> Track:
    return [1, *(b if n % 2 else a for n, (a, b) in enumerate(zip(own[1:], other[1:])))]


def _windows(tracks: list[Track], scan: int) -> dict[str, Any]:
    first = max(1, scan - K + 1)
    return {"scan": scan, "tracks": [[first, *track[first:scan + 1]] for track in tracks]}


def _answer(algorithm: str, loop: str, scans: list[dict[str, Any]]) -> dict[str, Any]:
    return {"algorithm": algorithm, "window_k": K, "loop": loop, "scans": scans}
