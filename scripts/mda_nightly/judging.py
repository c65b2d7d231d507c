"""What the samples of a session prove: verdicts per cell, and whether the session is any good."""

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from mda_results.render import Estimate

Array = np.ndarray

LEAST_CHANGE = 0.01  # of log time: below it, nobody wants to be woken
WORST_NULL = 0.02  # of log time: identical programs that differ by more make a session invalid
LEAST_ROUNDS = 8
RESAMPLES = 2000
SUSPICION = 0.2  # share of false ones among the suspects (Benjamini and Hochberg's q)
FALSE_SHARE = 0.05  # the same of the alarms
AGAIN_FACTOR = 2  # rounds of the rerun of suspects, which are few, over those of the first pass
LEVEL = 0.95
_GATE_LEVEL = 0.01  # how often a good session may fail for too many intervals beside 0

SLOWER, FASTER, SAME = "slower", "faster", "no credible change"
SUSPECTED, IDENTICAL, FAILS, REPAIRED = "suspected", "identical", "fails", "runs again"


@dataclass(frozen=True)
class Shift:
    """By how much the second of two programs takes longer: log ratio of times."""

    size: Estimate  # median with its interval
    p: float  # that it lies within the noise, either side; of the resamples

    @property
    def beside_zero(self) -> bool:
        return not self.size.low <= 0.0 <= self.size.high


def shift(log_ratios: Array, noise: float, name: str) -> Shift:
    """Of the log ratios of the rounds. The interval and p come from a bootstrap whose blocks are
    the rounds: within a round, turns suffer together; rounds do not, since their processes and
    order are drawn anew (measured on a loaded machine: rank correlation of neighbours within its
    error of what independence gives). The resamples depend on `name` and the number of rounds."""
    medians = np.median(log_ratios[_resamples(len(log_ratios), name)], axis=1)
    tail = (1 - LEVEL) / 2
    low, high = np.quantile(medians, [tail, 1 - tail])
    within = min((medians <= noise).sum(), (medians >= -noise).sum())
    p = min(1.0, 2.0 * (1 + int(within)) / (1 + RESAMPLES))
    return Shift(Estimate(float(np.median(log_ratios)), float(low), float(high)), p)


def _resamples(rounds: int, name: str) -> Array:
    """(RESAMPLES, rounds): the rounds of each resample."""
    random = np.random.default_rng([rounds, zlib.crc32(name.encode())])
    return random.integers(rounds, size=(RESAMPLES, rounds))


def credible(p_values: Sequence[float], q: float = FALSE_SHARE) -> list[bool]:
    """Which of the hypotheses fall, in their order. Source: Benjamini and Hochberg, Journal of the
    Royal Statistical Society B 57 (1995), section 3."""
    p = np.asarray(p_values, dtype=float)
    order = np.sort(p)
    passing = np.flatnonzero(order <= q * np.arange(1, len(p) + 1) / max(1, len(p)))
    threshold = order[passing[-1]] if len(passing) else -1.0
    return [bool(x <= threshold) for x in p]


@dataclass(frozen=True)
class Gate:
    """What a program against its own copy says about the session."""

    noise: float  # log ratio below which nothing is credible
    shifts: dict[str, Shift]
    faults: list[str]  # why the session is invalid

    @property
    def valid(self) -> bool:
        return not self.faults


def gate(twins: Mapping[str, Array]) -> Gate:
    """Of the log ratios of copy and program, by cell. A session is invalid when a cell's median is
    off by more than WORST_NULL, or when more intervals miss 0 than one in a hundred good sessions
    has (binomial)."""
    shifts = {name: shift(d, 0.0, f"{name} twin") for name, d in sorted(twins.items())}
    off = {name: s.size.value for name, s in shifts.items()}
    faults = []
    far = sorted((name for name, x in off.items() if abs(x) > WORST_NULL),
                 key=lambda name: -abs(off[name]))
    if far:
        more = f", and in {len(far) - 1} more cells by more than 2 %" if far[1:] else ""
        faults.append(f"{far[0]}: a copy of the same program differs by "
                      f"{100 * np.expm1(off[far[0]]):+.1f} %{more}")
    beside = sum(s.beside_zero for s in shifts.values())
    allowed = _most_beside_zero(len(shifts))
    if beside > allowed:
        faults.append(f"{beside} of {len(shifts)} cells tell a program from its own copy, more "
                      f"than {allowed}")
    noise = max([LEAST_CHANGE, *map(abs, off.values())])
    return Gate(noise, shifts, faults)


def _most_beside_zero(cells: int) -> int:
    """The least k that Binomial(cells, 1 - LEVEL) exceeds in at most _GATE_LEVEL of cases."""
    chance, below = LEVEL ** cells, 0.0
    for k in range(cells + 1):
        below += chance
        if below >= 1 - _GATE_LEVEL:
            return k
        chance *= (cells - k) / (k + 1) * (1 - LEVEL) / LEVEL
    return cells


@dataclass(frozen=True)
class Verdict:
    word: str  # SLOWER, FASTER, SAME, SUSPECTED or IDENTICAL
    shift: Shift
    again: Shift | None = None  # of the rerun


def verdicts(first: Mapping[str, Array], again: Mapping[str, Array], identical: Sequence[str],
             noise: float) -> dict[str, Verdict]:
    """Of the log ratios of candidate and baseline, by cell. The first pass raises suspicion, and may
    do so lightly; the alarm rests on the rerun of the suspects alone, whose rounds are fresh.
    `identical`: cells whose program is the same file; the clock has no say there."""
    shifts = {name: shift(d, noise, name) for name, d in sorted(first.items())}
    judged = [name for name in shifts if name not in identical]
    stands_out = credible([shifts[name].p for name in judged], SUSPICION)
    suspected = [name for name, out in zip(judged, stands_out) if out]
    reruns = {name: shift(again[name], noise, f"{name} again") for name in suspected
              if name in again}
    confirmed = dict(zip(reruns, credible([s.p for s in reruns.values()])))
    words = {name: SAME for name in judged} | {name: SUSPECTED for name in suspected} | {
        name: _word(shifts[name], reruns[name]) if confirmed[name] else SAME for name in reruns}
    return {name: Verdict(words.get(name, IDENTICAL), s, reruns.get(name))
            for name, s in shifts.items()}


def _word(first: Shift, again: Shift) -> str:
    if first.size.value * again.size.value <= 0:
        return SAME
    return SLOWER if again.size.value > 0 else FASTER


def suspects(found: Mapping[str, Verdict]) -> list[str]:
    """Cells to be timed again before anybody is told."""
    return [name for name, verdict in found.items() if verdict.word == SUSPECTED]
