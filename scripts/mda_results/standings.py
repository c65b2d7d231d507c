"""The ranking of a contest: correctness, share proven optimal, certified gap, time."""

from dataclasses import dataclass

import numpy as np

from mda_results import bootstrap, facts, measures
from mda_results.contest import Contest
from mda_results.render import Estimate

SHIFT_MS = 0.1  # near the median time of easy windows; the table of times has other shifts


@dataclass(frozen=True)
class Standing:
    """One algorithm in one contest; gaps in nats, times in milliseconds, shares from 0 to 1."""

    algorithm: str
    place: Estimate | None  # with the interval of its place; None when disqualified
    refuted: int
    proven: Estimate
    certified: float  # share of answers whose cost is the best certified bound
    answered: float
    best_known: float  # share of answers in time at the best known cost
    certified_gap: Estimate  # mean
    certified_gap_p95: float
    certified_gap_max: float
    gap: Estimate  # mean above the best known cost
    gap_max: float
    time: Estimate  # shifted geometric mean
    penalised: int  # windows that cost the penalty


def standings(contest: Contest, shift_ms: float = SHIFT_MS) -> list[Standing]:
    """In the order of the ranking, the disqualified last."""
    weights = contest.weights()
    proven, proven_drawn = _means(contest, contest.fate == facts.OPTIMAL, weights)
    certified, certified_drawn = _means(contest, contest.certified_gap, weights)
    gap, gap_drawn = _means(contest, contest.gap, weights)
    log_time, log_drawn = _means(contest, np.log(contest.time_ms + shift_ms), weights)
    decisive = gap if contest.hardness == facts.OPEN else certified
    decisive_drawn = gap_drawn if contest.hardness == facts.OPEN else certified_drawn
    place = _places(proven, decisive, log_time, contest.refuted)
    drawn = _places(proven_drawn, decisive_drawn, log_drawn, contest.refuted)
    order = np.lexsort((contest.algorithms, place, contest.refuted > 0))
    if weights is None:
        drawn = np.empty((0, len(order)))
    return [Standing(
        algorithm=contest.algorithms[a],
        place=bootstrap.interval(float(place[a]), drawn[:, a]) if not contest.refuted[a] else None,
        refuted=int(contest.refuted[a]),
        proven=bootstrap.interval(proven[a], proven_drawn[:, a]),
        certified=float((contest.answered[:, a] & (contest.certified_gap[:, a] == 0)).mean()),
        answered=float(contest.answered[:, a].mean()),
        best_known=float(contest.reached[:, a].mean()),
        certified_gap=bootstrap.interval(certified[a], certified_drawn[:, a]),
        certified_gap_p95=_p95(contest.certified_gap[:, a]),
        certified_gap_max=float(contest.certified_gap[:, a].max()),
        gap=bootstrap.interval(gap[a], gap_drawn[:, a]), gap_max=float(contest.gap[:, a].max()),
        time=bootstrap.interval(float(np.exp(log_time[a]) - shift_ms),
                                np.exp(log_drawn[:, a]) - shift_ms),
        penalised=int((~contest.in_time[:, a]).sum())) for a in order]


def _p95(values: np.ndarray) -> float:
    """The least value that 95 % of all do not exceed."""
    return float(np.quantile(values, 0.95, method="inverted_cdf"))


def _means(contest: Contest, values: np.ndarray,
           weights: np.ndarray | None) -> tuple[np.ndarray, np.ndarray]:
    """Per algorithm the mean over windows, and over those of every resample of scenes. Rounded to
    1e-12 of the largest, so that equal columns stay equal whatever the order of summation."""
    sums = contest.by_scene(values.astype(float))
    counts = np.bincount(contest.unit, minlength=len(sums)).astype(float)
    mean = _rounded(sums.sum(axis=0) / counts.sum())
    if weights is None:
        return mean, np.full((1, len(mean)), np.nan)
    with np.errstate(invalid="ignore"):
        return mean, _rounded((weights @ sums) / (weights @ counts)[:, None])


def _rounded(values: np.ndarray) -> np.ndarray:
    finite = np.abs(values[np.isfinite(values)])
    digits = 12 - int(np.ceil(np.log10(finite.max()))) if finite.any() else 12
    return np.round(values, digits)


def _places(proven: np.ndarray, gap: np.ndarray, log_time: np.ndarray,
            refuted: np.ndarray) -> np.ndarray:
    out = np.broadcast_to(refuted > 0, proven.shape)
    return measures.places(out.astype(float), -proven, np.nan_to_num(gap, nan=np.inf), log_time)
