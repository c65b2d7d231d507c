"""A session on the disk: who was timed, on what machine, and every sample.

SESSION/session.json    identity, machine before and after, sides, cells, outcome
SESSION/samples.jsonl   one line per sample, as they were taken
SESSION/counts.jsonl    instructions per cell and side
SESSION/SIDE/...        runs of mda-bench by that side: windows (open loop), tracking (closed loop)
"""

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from mda_results.rows import RunError, json_lines, load_manifest

SCHEMA_VERSION = 1
SESSION_FILE, SAMPLES_FILE, COUNTS_FILE = "session.json", "samples.jsonl", "counts.jsonl"
BASELINE, TWIN, CANDIDATE, ANCHOR = "baseline", "twin", "candidate", "anchor"
FIRST, AGAIN = 1, 2  # passes: every cell, and the rerun of suspected ones

_SAMPLE_FIELDS = {"cell": str, "side": str, "pass": int, "round": int, "cpu_s": list,
                  "wall_s": list, "stalled": float, "counters": dict}


@dataclass(frozen=True)
class Session:
    """A finished session; samples by (pass, cell, side, round)."""

    directory: Path
    facts: dict[str, Any]  # session.json
    samples: dict[tuple[int, str, str, int], dict[str, Any]]
    counts: dict[tuple[str, str], int] = field(default_factory=dict)  # by (cell, side)

    @property
    def name(self) -> str:
        return str(self.facts["id"])

    @property
    def sides(self) -> dict[str, Any]:
        return self.facts["sides"]

    def cells(self, number: int = FIRST) -> list[str]:
        return sorted({cell for n, cell, _, _ in self.samples if n == number})

    def program(self, cell: str, side: str) -> str | None:
        """The hash of the program that ran a cell; None if the side does not have it."""
        return self.sides[side]["programs"].get(self.facts["cells"][cell]["program"])

    def counters(self, cell: str, side: str) -> dict[str, float]:
        """What the benchmark of a cell counted; empty if the side does not have it."""
        found = [s["counters"] for (_, c, d, _), s in self.samples.items() if (c, d) == (cell, side)]
        return found[0] if found else {}

    def series(self, number: int, cell: str, side: str, what: str) -> dict[int, np.ndarray]:
        """A field of the samples of a cell, turn by turn, by round."""
        return {r: np.array(s[what]) for (n, c, d, r), s in self.samples.items()
                if (n, c, d) == (number, cell, side)}

    def log_ratios(self, number: int, base: str, candidate: str,
                   what: str = "cpu_s") -> dict[str, np.ndarray]:
        """ln(candidate / base) of every cell that both have: of each round the median over its
        turns, in which the two took turns within milliseconds."""
        found = {}
        for cell in self.cells(number):
            first, second = (self.series(number, cell, s, what) for s in (base, candidate))
            if not first or not second:
                continue
            if set(first) != set(second):
                raise RunError(f"session {self.name} has rounds of {cell} that {base} and "
                               f"{candidate} do not share")
            found[cell] = np.array([np.median(np.log(second[r]) - np.log(first[r]))
                                    for r in sorted(first)])
        return found

    def contaminated(self) -> float:
        """Share of samples in which neighbours took the processor away: wall times that exceed CPU
        times by more than 5 %, or somebody waiting for more than 2 % of the time."""
        marks = [s["stalled"] > 0.02 or np.median(s["wall_s"]) > 1.05 * np.median(s["cpu_s"])
                 for s in self.samples.values()]
        return float(np.mean(marks)) if marks else 0.0


def machine_key(machine: Mapping[str, Any]) -> str:
    """What has to be equal for times to be compared at all."""
    return f"{machine.get('cpu', 'unknown')}, {machine.get('cores', '?')} cores"


def load(directory: Path, unfinished: bool = False) -> Session:
    """Raises RunError, one sentence, if the session is damaged, of another schema, or not finished;
    with `unfinished`, one that is still being taken will do."""
    facts = load_manifest(directory / SESSION_FILE)
    if facts.get("schema_version") != SCHEMA_VERSION:
        raise RunError(f"{directory / SESSION_FILE} has schema version "
                       f"{facts.get('schema_version')}; read is {SCHEMA_VERSION}")
    absent = [k for k in ("id", "started", "machine", "sides", "cells", "outcome")
              if k not in facts]
    if absent:
        raise RunError(f"{directory / SESSION_FILE} has no field '{absent[0]}'")
    if facts["outcome"] != "finished" and not unfinished:
        raise RunError(f"session {facts['id']} did not finish ({facts['outcome']}): it gives no "
                       "verdict")
    samples = {}
    for number, line in enumerate(_lines(directory / SAMPLES_FILE), start=1):
        _check(line, directory / SAMPLES_FILE, number)
        key = (line["pass"], line["cell"], line["side"], line["round"])
        if key in samples:
            raise RunError(f"{directory / SAMPLES_FILE}:{number}: this sample is there twice")
        samples[key] = line
    counts = {(line["cell"], line["side"]): int(line["instructions"])
              for line in _lines(directory / COUNTS_FILE, needed=False)}
    _check_whole(facts, samples)
    return Session(directory, facts, samples, counts)


def _lines(path: Path, needed: bool = True) -> Iterable[dict[str, Any]]:
    if not path.is_file():
        if needed:
            raise RunError(f"{path.parent} has no {path.name}")
        return
    torn: list[str] = []
    yield from json_lines(path, torn)
    if torn:
        raise RunError(f"{path} ends in the middle of a line: the session gives no verdict")


def _check(line: Mapping[str, Any], path: Path, number: int) -> None:
    for name, kind in _SAMPLE_FIELDS.items():
        value = line.get(name)
        fits = isinstance(value, kind) or (kind is float and type(value) is int)
        if not fits:
            raise RunError(f"{path}:{number}: {name} is {value!r}, not of type {kind.__name__}")
    times = line["cpu_s"] + line["wall_s"]
    if not times or not all(isinstance(t, (int, float)) and t > 0 for t in times):
        raise RunError(f"{path}:{number}: the times are not all positive numbers")


def _check_whole(facts: Mapping[str, Any], samples: Mapping[tuple[int, str, str, int], Any]) -> None:
    """Every side that has a cell has it in every round of the pass."""
    rounds: dict[tuple[int, str], dict[str, set[int]]] = {}
    for number, cell, side, r in samples:
        if cell not in facts["cells"] or side not in facts["sides"]:
            raise RunError(f"session {facts['id']} has samples of {cell} by {side}, which it does "
                           "not name")
        rounds.setdefault((number, cell), {}).setdefault(side, set()).add(r)
    for (_, cell), by_side in rounds.items():
        if len({frozenset(r) for r in by_side.values()}) > 1:
            raise RunError(f"session {facts['id']} has not all samples of {cell}: it gives no "
                           "verdict")


def write_facts(directory: Path, facts: Mapping[str, Any]) -> None:
    """Writes session.json as a whole or not at all."""
    directory.mkdir(parents=True, exist_ok=True)
    beside = directory / f"{SESSION_FILE}.new"
    beside.write_text(json.dumps(facts, indent=1, allow_nan=False) + "\n", encoding="utf-8")
    beside.replace(directory / SESSION_FILE)


def write_counts(path: Path, counts: Mapping[tuple[str, str], int]) -> None:
    """Writes counts.jsonl."""
    lines = [json.dumps({"cell": cell, "side": side, "instructions": n}) + "\n"
             for (cell, side), n in sorted(counts.items())]
    path.write_text("".join(lines), encoding="utf-8")
