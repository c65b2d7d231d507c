"""Recorded scenes for the scenario viewer: scenes.jsonl, or the true paths of trajectories.json
(results/README.md)."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from mda_results.rows import SCHEMA_VERSION, RunError, json_lines, load_manifest

Scene = dict[str, Any]

_LOOPS = ("open", "closed")
_KEY = ("scenario", "scan_period_s", "seed", "replicate")
_OF_THE_WORLD = ("range_km", "plots", "targets")
_OF_AN_ANSWER = ("window_k", "algorithm", "loop")


def scenes_of(directory: Path, warnings: list[str]) -> list[Scene]:
    """The scenes of a run; none if it records none. Raises RunError if they are damaged."""
    scenes: list[Scene] = []
    path, paths = directory / "scenes.jsonl", directory / "trajectories.json"
    if path.is_file():
        scenes += _merged((_checked(scene, f"{path}:{number}"), f"{path}:{number}")
                          for number, scene in enumerate(json_lines(path, warnings), start=1))
    if paths.is_file():
        scenes += [_of_paths(name, known, paths) for name, known in load_manifest(paths).items()]
    return scenes


def _merged(lines: Iterable[tuple[Scene, str]]) -> list[Scene]:
    """One scene of all lines about it, which come cell by cell: each K has a line of its own. By
    name, and the answers by K and algorithm, as lines come in the order in which cells finish."""
    scenes: dict[tuple[Any, ...], Scene] = {}
    for scene, where in lines:
        known = scenes.setdefault(tuple(scene[name] for name in _KEY), {**scene, "answers": []})
        if any(scene[name] != known[name] for name in _OF_THE_WORLD):
            raise RunError(f"{where}: another line has other plots or targets for this scene of "
                           f"{scene['scenario']}")
        known["answers"] += scene["answers"]
    for scene in scenes.values():
        scene["answers"].sort(key=lambda answer: [answer[name] for name in _OF_AN_ANSWER])
    return [scenes[key] for key in sorted(scenes)]


def _of_paths(scenario: str, known: Any, path: Path) -> Scene:
    """A scene without plots."""
    try:
        targets = [[[float(x), float(y)] for x, y in target] for target in known["targets"]]
        period = float(known["scan_period_s"])
        scans = max(map(len, targets))
    except (TypeError, KeyError, ValueError):
        raise RunError(f"{path} has paths of {scenario} that are no lists of pairs") from None
    return {"scenario": scenario, "scan_period_s": period, "seed": 1, "replicate": 1,
            "range_km": None, "plots": [[] for _ in range(scans)], "answers": [],
            "targets": [{"first_scan": 1, "positions_km": t} for t in targets]}


def _checked(scene: Scene, where: str) -> Scene:
    """The scene with what the viewer needs and nothing else."""
    if scene.get("schema_version") != SCHEMA_VERSION:
        raise RunError(f"{where}: its schema version is not {SCHEMA_VERSION}")
    try:
        plots = [[[float(x), float(y), int(s)] for x, y, s in scan] for scan in scene["plots"]]
        targets = [{"first_scan": int(t["first_scan"]),
                    "positions_km": [[float(x), float(y)] for x, y in t["positions_km"]]}
                   for t in scene["targets"]]
        answers = [_answer(answer, plots) for answer in scene["answers"]]
        reach = scene["range_km"]
        return {"scenario": str(scene["scenario"]), "scan_period_s": float(scene["scan_period_s"]),
                "seed": int(scene["seed"]), "replicate": int(scene["replicate"]), "plots": plots, "targets": targets,
                "range_km": None if reach is None else float(reach), "answers": answers}
    except KeyError as error:
        raise RunError(f"{where}: the scene has no field {error}") from None
    except (TypeError, ValueError) as error:
        raise RunError(f"{where}: {error}") from None


def _answer(answer: dict[str, Any], plots: list[list[list[float]]]) -> dict[str, Any]:
    if answer["loop"] not in _LOOPS:
        raise ValueError(f"unknown loop: {json.dumps(answer['loop'])}")
    for entry in answer["scans"]:
        for first, *numbers in entry["tracks"]:
            for scan, plot in enumerate(numbers, start=first):
                if not 1 <= scan <= len(plots) or not -1 <= plot < len(plots[scan - 1]):
                    raise ValueError(f"a track of {answer['algorithm']} takes plot {plot} of scan "
                                     f"{scan}, which is not there")
    return {key: answer[key] for key in ("algorithm", "window_k", "loop", "scans")}
