"""Where a series of nights changes its level."""

import functools
from dataclasses import dataclass

import numpy as np

Array = np.ndarray

LEAST_NIGHTS = 8  # of a series; with fewer, only the nightly comparison speaks
LEAST_LEVEL = 3  # nights at a level: fewer are an accident
LEVEL = 0.01  # how often the series without a change of one history may cry, all together

_PERMUTATIONS = 19_999
_SEED = 1


@dataclass(frozen=True)
class Step:
    """Between nights first - 1 and first."""

    first: int  # index of the first night of the new level
    size: float  # new median less old one
    p: float


def steps(values: Array, level: float = LEVEL) -> list[Step]:
    """Steps of a series, in order: whether there is one is tested; if so, the series is split where
    two medians fit best, and both parts are looked at in turn (binary segmentation), each at its
    share of the level. The statistic is the largest standardised rank sum of all splits (Pettitt,
    Applied Statistics 28 (1979), standardised so that splits near the ends count alike); its
    p-value comes from permutations of the nights, so the level holds whatever the noise looks like
    as long as the order of nights means nothing. Ranks and medians: a wild night changes little."""
    values = np.asarray(values, dtype=float)
    if len(values) < LEAST_NIGHTS:
        return []
    found = sorted(_splits(values, 0, level))
    bounds = [0, *(first for first, _ in found), len(values)]
    medians = [float(np.median(values[a:b])) for a, b in zip(bounds, bounds[1:])]
    return [Step(first, medians[i + 1] - medians[i], p) for i, (first, p) in enumerate(found)]


def _splits(values: Array, offset: int, level: float) -> list[tuple[int, float]]:
    if len(values) < LEAST_NIGHTS:
        return []
    ranks = _ranks(values)
    p = _p_value(float(_scores(ranks[None, :]).max()), tuple(np.sort(ranks)))
    if p > level:
        return []
    first = _best_split(values)
    share = first / len(values)
    return [(offset + first, p), *_splits(values[:first], offset, share * level),
            *_splits(values[first:], offset + first, (1 - share) * level)]


def _best_split(values: Array) -> int:
    """The split of least sum of distances to the medians of both parts."""
    def cost(part: Array) -> float:
        return float(np.abs(part - np.median(part)).sum())

    return min(range(LEAST_LEVEL, len(values) - LEAST_LEVEL + 1),
               key=lambda first: cost(values[:first]) + cost(values[first:]))


def _ranks(values: Array) -> Array:
    """From 1, less their mean; equal values share the mean of their ranks."""
    from scipy.stats import rankdata  # slow to import

    ranks = rankdata(values)
    return ranks - ranks.mean()


def _scores(ranks: Array) -> Array:
    """(series, splits): |rank sum before the split| over its standard deviation under permutation;
    0 for a constant series. Splits leave LEAST_LEVEL nights on either side."""
    n = ranks.shape[1]
    before = np.arange(LEAST_LEVEL, n - LEAST_LEVEL + 1)
    sums = np.abs(np.cumsum(ranks, axis=1)[:, before - 1])
    variance = (ranks**2).sum(axis=1, keepdims=True) / (n - 1)
    deviation = np.sqrt(variance * before * (n - before) / n)
    return np.divide(sums, deviation, out=np.zeros_like(sums), where=deviation > 0)


def _p_value(score: float, ranks: tuple[float, ...]) -> float:
    null = _null_scores(ranks)
    return float((1 + len(null) - np.searchsorted(null, score - 1e-9)) / (1 + len(null)))


@functools.lru_cache(maxsize=256)
def _null_scores(ranks: tuple[float, ...]) -> Array:
    """The largest scores of random orders of these ranks, ascending."""
    random = np.random.default_rng([_SEED, len(ranks)])
    largest = []
    for _ in range(-(-_PERMUTATIONS // 1000)):  # in parts, for memory
        orders = random.permuted(np.tile(np.array(ranks), (1000, 1)), axis=1)
        largest.append(_scores(orders).max(axis=1))
    return np.sort(np.concatenate(largest)[:_PERMUTATIONS])
