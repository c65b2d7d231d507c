"""Verdicts on claims of a paper, and how what they rest on is told."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import pandas as pd

from mda_results.render import Estimate

HOLDS, PARTLY, FAILS, OPEN = "holds", "holds partly", "does not hold", "cannot be decided"


@dataclass(frozen=True)
class Claim:
    said: str
    ours: str
    verdict: str
    rule: str


def text(estimate: Estimate | None, digits: str = ".1f") -> str:
    if estimate is None:
        return "no data"
    if estimate.low is None or estimate.high is None:
        return f"{estimate.value:{digits}}"
    return f"{estimate.value:{digits}} [{estimate.low:{digits}}, {estimate.high:{digits}}]"


def verdict(estimate: Estimate | None, holds: Callable[[float, float], bool],
            fails: Callable[[float, float], bool]) -> str:
    """From the interval; without one nothing can be decided."""
    if estimate is None or estimate.low is None or estimate.high is None:
        return OPEN
    if holds(estimate.low, estimate.high):
        return HOLDS
    return FAILS if fails(estimate.low, estimate.high) else OPEN


def at_most(estimate: Estimate | None, limit: float) -> str:
    """HOLDS when the whole interval is at most `limit`, FAILS when it is all above."""
    return verdict(estimate, lambda _, high: high <= limit, lambda low, _: low > limit)


def at_least(estimate: Estimate | None, limit: float) -> str:
    """HOLDS when the whole interval is at least `limit`, FAILS when it is all below."""
    return verdict(estimate, lambda low, _: low >= limit, lambda _, high: high < limit)


def above(estimate: Estimate | None, limit: float) -> str:
    """HOLDS when the whole interval is above `limit`, FAILS when none of it is."""
    return verdict(estimate, lambda low, _: low > limit, lambda _, high: high <= limit)


def within(estimate: Estimate | None, limit: float) -> str:
    """HOLDS when the whole interval is at most `limit` from 0, FAILS when it is all further."""
    return verdict(estimate, lambda low, high: -limit <= low and high <= limit,
                   lambda low, high: low > limit or high < -limit)


def over(frame: pd.DataFrame, field: str, of: Callable[[pd.DataFrame], Estimate | None],
         judge: Callable[[Estimate | None], str], label: str, digits: str) -> tuple[str, str]:
    """What is found at each value of `field`, told after `label`, and the verdict of all together.
    Values without anything are left out."""
    every = [(value, of(part)) for value, part in frame.groupby(field)]
    found = [(value, estimate) for value, estimate in every if estimate is not None]
    told = "; ".join(f"{label}{value:g} {text(e, digits)}" for value, e in found) or "no data"
    return told, together(judge(e) for _, e in found)


def together(parts: Iterable[str]) -> str:
    """One verdict of several: theirs if they agree, PARTLY if some hold."""
    found = set(parts)
    if not found:
        return OPEN
    if len(found) == 1:
        return found.pop()
    if found & {HOLDS, PARTLY}:
        return PARTLY
    return FAILS
