"""Statistics of benchmarks, from plain arrays. Failures are infinite times."""

from collections.abc import Sequence

import numpy as np

Array = np.ndarray

_EXACT_UP_TO = 50


def shifted_geometric_mean(times: Array, shift: float) -> float:
    """exp(mean(log(t + shift))) - shift; times and shift in one unit, shift > 0. The shift keeps
    times far below it from deciding. NaN of nothing."""
    if len(times) == 0:
        return float("nan")
    return float(np.exp(np.log(np.asarray(times, dtype=float) + shift).mean()) - shift)


def performance_ratios(times: Array) -> Array:
    """Of times (problems, solvers): each over the best of its problem, infinite where the solver
    failed. Source: Dolan and More, Mathematical Programming 91 (2002), section 2."""
    best = times.min(axis=1, keepdims=True) if times.size else times
    with np.errstate(invalid="ignore"):
        return np.where(np.isfinite(times), times / best, np.inf)


def share_within(values: Array, limits: Sequence[float] | Array) -> Array:
    """(limits, solvers): the share of all problems, failures included, whose value (problems,
    solvers) is at most the limit. O(n log n)."""
    ordered = np.sort(values, axis=0)
    counts = [np.searchsorted(column, limits, side="right") for column in ordered.T]
    return np.array(counts).T / max(1, len(values))


def holm(p_values: Sequence[float]) -> list[float]:
    """The p-values adjusted for their number, in the same order; each at most 1. Source: Holm,
    Scandinavian Journal of Statistics 6 (1979), section 3."""
    adjusted = [0.0] * len(p_values)
    largest = 0.0
    for place, i in enumerate(sorted(range(len(p_values)), key=lambda i: p_values[i])):
        largest = max(largest, min(1.0, (len(p_values) - place) * p_values[i]))
        adjusted[i] = largest
    return adjusted


def signed_rank_p(differences: Array) -> float:
    """Two-sided p-value of Wilcoxon's signed-rank test, differences of 0 left out, equal sizes with
    their mean rank: exact up to 50 of them, O(n^3), else by the normal limit with continuity
    correction. 1 if all are 0."""
    from scipy.stats import rankdata, wilcoxon  # slow to import

    nonzero = differences[differences != 0]
    if len(nonzero) == 0:
        return 1.0
    if len(nonzero) > _EXACT_UP_TO:
        return float(wilcoxon(nonzero, method="approx", correction=True).pvalue)
    doubled = np.rint(2 * rankdata(np.abs(nonzero))).astype(int)
    total = int(doubled.sum())
    ways = np.zeros(total + 1)  # to give the positive differences this sum of doubled ranks
    ways[0] = 1.0
    for rank in doubled:
        ways[rank:] = ways[rank:] + ways[:-rank]
    positive = int(doubled[nonzero > 0].sum())
    tail = ways[: min(positive, total - positive) + 1].sum()
    return float(min(1.0, 2 * tail / 2.0 ** len(nonzero)))


def dominator(first: Array, second: Array, i: int) -> int | None:
    """A point that is no worse than point i in both coordinates and better in one (less is
    better), the one of least first and then second coordinate; None if i is on the front."""
    no_worse = (first <= first[i]) & (second <= second[i])
    better = no_worse & ((first < first[i]) | (second < second[i]))
    if not better.any():
        return None
    candidates = np.flatnonzero(better)
    return int(candidates[np.lexsort((second[candidates], first[candidates]))[0]])


def places(*keys: Array) -> Array:
    """Competition ranks (1, 2, 2, 4) along the last axis, least first: by the first key, ties by
    the next. Keys of one shape, (solvers,) or (samples, solvers)."""
    order = np.lexsort(keys[::-1], axis=-1)
    ordered = [np.take_along_axis(key, order, axis=-1) for key in keys]
    changes = np.any([key[..., 1:] != key[..., :-1] for key in ordered], axis=0)
    start = np.ones((*order.shape[:-1], 1), dtype=int)
    steps = np.where(changes, np.arange(2, order.shape[-1] + 1), 1)
    sorted_places = np.maximum.accumulate(np.concatenate([start, steps], axis=-1), axis=-1)
    result = np.empty_like(order)
    np.put_along_axis(result, order, sorted_places, axis=-1)
    return result


def slope(n: Array, x: Array, y: Array, xx: Array, xy: Array) -> Array:
    """Of the least-squares line through points with these sums; NaN without two values of x."""
    spread = n * xx - x * x
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(spread > 1e-9 * n * xx, (n * xy - x * y) / spread, np.nan)
