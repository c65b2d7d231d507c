"""Intervals of ratios of sums, by resampling scenarios."""

import functools
import zlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pandas as pd

from mda_results.render import Estimate

RESAMPLES = 2000
LEVEL = 0.95
_SEED = 1


def ratio(
    frame: pd.DataFrame,
    part: str,
    whole: str,
    of: Callable[[float], float] | None = None,
) -> Estimate | None:
    """sum of `part` / sum of `whole` over `frame`, with 95 % percentile interval and its error.

    The unit that is resampled is the scenario, (group, replicate), within its group: the windows of
    a scenario share their plots, so they are no independent draws. The resamples are the same for
    every frame with the same scenarios, whatever the order of its rows. `of` is an increasing
    function applied to the ratios, such as exp to logarithms. None when the whole is 0; no interval
    when no group has two scenarios.
    """
    transform = of if of is not None else (lambda x: x)
    units = frame.groupby(["group", "replicate"], sort=True, observed=True)[[part, whole]].sum()
    sums = units.sum()
    if len(units) == 0 or sums[whole] == 0:
        return None
    value = float(transform(sums[part] / sums[whole]))
    drawn = np.zeros((RESAMPLES, 2))
    for group, members in units.groupby(level="group", observed=True):
        drawn += _weights(str(group), len(members)) @ members.to_numpy(dtype=float)
    usable = drawn[drawn[:, 1] > 0]
    if units.groupby(level="group", observed=True).size().max() < 2:
        return Estimate(value)
    ratios = transform(usable[:, 0] / usable[:, 1])
    tail = (1 - LEVEL) / 2
    low, high = np.quantile(ratios, [tail, 1 - tail])
    return Estimate(value, float(low), float(high), float(ratios.std()))


@dataclass(frozen=True)
class Band:
    """A mean at each of several points, with its interval; all of one length."""

    mean: np.ndarray
    low: np.ndarray
    high: np.ndarray


def band(group: str, values: np.ndarray) -> Band:
    """The mean over the lines of `values` (scenarios of `group`, points), point by point, with its
    95 % percentile interval; of width 0 when there is one line."""
    return ratio_band(group, values, np.ones(len(values)), lambda x: x)


def ratio_band(group: str, values: np.ndarray, counts: np.ndarray,
               of: Callable[[np.ndarray], np.ndarray]) -> Band:
    """As band(), of `of` of the sum over the lines of `values` over the sum of `counts`, one per
    line and not all 0; lines are resampled with their counts."""
    mean = of(values.sum(axis=0) / counts.sum())
    if len(values) < 2:
        return Band(mean, mean, mean)
    weights = _weights(group, len(values))
    wholes = weights @ counts
    drawn = of((weights @ values)[wholes > 0] / wholes[wholes > 0, None])
    tail = (1 - LEVEL) / 2
    low, high = np.quantile(drawn, [tail, 1 - tail], axis=0)
    return Band(mean, low, high)


def weights(groups: np.ndarray) -> np.ndarray | None:
    """How often each unit is in each resample, (RESAMPLES, units), for statistics that ratio() is
    too narrow for. `groups` names the group of every unit, those of one group in a row; units are
    drawn within their group. None when no group has two."""
    names, first, counts = np.unique(groups, return_index=True, return_counts=True)
    if len(counts) == 0 or counts.max() < 2:
        return None
    return np.hstack([_weights(str(names[i]), int(counts[i])) for i in np.argsort(first)])


def interval(value: float, drawn: np.ndarray) -> Estimate:
    """`value` with the 95 % percentile interval of its resamples; those without a value, NaN, are
    left out. No interval when none is finite."""
    usable = drawn[np.isfinite(drawn)]
    if not np.isfinite(value) or len(usable) == 0:
        return Estimate(value)
    tail = (1 - LEVEL) / 2
    low, high = np.quantile(usable, [tail, 1 - tail])
    return Estimate(value, float(low), float(high))


@functools.lru_cache(maxsize=64)
def _weights(group: str, count: int) -> np.ndarray:
    """How often each of `count` scenarios is in each resample."""
    random = np.random.default_rng([_SEED, zlib.crc32(group.encode())])
    return random.multinomial(count, np.full(count, 1 / count), size=RESAMPLES)
