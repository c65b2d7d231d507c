"""A session on the disk: who was timed, on what machine, and every sample.

SESSION/session.json    identity, machine before and after, sides, cells, outcome
SESSION/samples.jsonl   one line per sample, as they were taken
SESSION/counts.jsonl    instructions per cell and side
SESSION/SIDE/...        runs of mda-bench by that side: windows (open loop), tracking (closed loop)
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from mda_nightly import session_checks
from mda_nightly.session_checks import (AGAIN, ANCHOR, BASELINE, CANDIDATE, COUNTS_FILE, FINISHED,
                                        FIRST, PLANTED, SAMPLES_FILE, SCHEMA_VERSION, SESSION_FILE,
                                        TWIN, SampleKey, machine_key)

__all__ = ["AGAIN", "ANCHOR", "BASELINE", "CANDIDATE", "COUNTS_FILE", "FINISHED", "FIRST",
           "PLANTED", "SAMPLES_FILE", "SCHEMA_VERSION", "SESSION_FILE", "TWIN", "Session", "load",
           "machine_key", "write_counts", "write_facts"]


@dataclass(frozen=True)
class Session:
    """A finished session; samples by (pass, cell, side, round)."""

    directory: Path
    facts: dict[str, Any]  # session.json
    samples: dict[SampleKey, dict[str, Any]]
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
            found[cell] = np.array([np.median(np.log(second[r]) - np.log(first[r]))
                                    for r in sorted(first)])
        return found

    def contaminated(self) -> float:
        """Share of samples in which neighbours took the processor away: wall times that exceed CPU
        times by more than 5 %, or somebody waiting for more than 2 % of the time."""
        marks = [s["stalled"] > 0.02 or np.median(s["wall_s"]) > 1.05 * np.median(s["cpu_s"])
                 for s in self.samples.values()]
        return float(np.mean(marks)) if marks else 0.0


def load(directory: Path, unfinished: bool = False) -> Session:
    """Raises RunError, one sentence, if the session is damaged, of another schema, or not finished;
    with `unfinished`, one that is still being taken will do."""
    facts = session_checks.load_facts(directory, unfinished)
    return Session(directory, facts,
                   session_checks.load_samples(directory / SAMPLES_FILE, facts),
                   session_checks.load_counts(directory / COUNTS_FILE, facts))


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
