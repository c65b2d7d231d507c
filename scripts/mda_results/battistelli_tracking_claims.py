"""What Battistelli et al. (2008) claim of tracking, judged from closed loops."""

from collections.abc import Callable, Iterator

import numpy as np
import pandas as pd

from mda_results import bootstrap
from mda_results.battistelli_closed import REFERENCE, WINDOW_K, mean, paired
from mda_results.render import Estimate
from mda_results.verdicts import (FAILS, HOLDS, PARTLY, Claim, at_least, at_most, text, together,
                                  within)

MANOEUVRES_S = (200.0, 250.0)  # of scenario 2
FLOWS = ("scf", "scf-tie")  # as printed; with ties by the cumulative cost
_NEGLIGIBLE_PERCENT = 10.0
_NEGLIGIBLE_POINTS = 2.0
_MULTI = "mcf"


def _of(outings: pd.DataFrame, algorithm: str) -> pd.DataFrame:
    return outings[outings["algorithm"] == algorithm]


def _excess(own: pd.DataFrame, field: str) -> Estimate | None:
    """By how many percent d exceeds `field`."""
    frame = own.assign(excess=own["position_error_m"] - own[field])
    return bootstrap.ratio(frame, "excess", field, lambda x: 100 * x)


def _near_ideal(outings: pd.DataFrame, _: str) -> Iterator[Claim]:
    for algorithm in FLOWS:
        own = _of(outings, algorithm)
        ideal, oracle = _excess(own, "ideal_error_m"), _excess(own, "oracle_error_m")
        verdict = at_most(ideal, _NEGLIGIBLE_PERCENT)
        if verdict == FAILS and at_most(oracle, _NEGLIGIBLE_PERCENT) == HOLDS:
            verdict = PARTLY
        yield Claim("negligible performance deterioration with respect to the ideal case (IV)",
                    f"{algorithm}: d above ideal {text(ideal)} %, above oracle {text(oracle)} %; "
                    f"L {text(mean(own, 'right_share', 100.0))} %",
                    verdict, f"d at most {_NEGLIGIBLE_PERCENT:g} % above the ideal; partly if only "
                    "above the oracle (real plots)")


def _alike(own: pd.DataFrame, other: pd.DataFrame) -> tuple[str, str]:
    """How close d and L of two algorithms are on the same runs, and the verdict."""
    pairs = paired(own, other, ["position_error_m", "right_share"])
    distance = bootstrap.ratio(pairs, "position_error_m_difference", "position_error_m_reference",
                               lambda x: 100 * x)
    right = mean(pairs, "right_share_difference", 100.0)
    verdict = together([within(distance, _NEGLIGIBLE_PERCENT), within(right, _NEGLIGIBLE_POINTS)])
    return f"d {text(distance, '+.1f')} %, L {text(right, '+.2f')} points", verdict


def _alike_rule(other: str) -> str:
    return (f"d within {_NEGLIGIBLE_PERCENT:g} % and L within {_NEGLIGIBLE_POINTS:g} points of "
            f"{other} on the same runs; partly if one of them")


def _close_to_exact(outings: pd.DataFrame, _: str) -> Iterator[Claim]:
    for algorithm in FLOWS:
        told, verdict = _alike(_of(outings, algorithm), _of(outings, REFERENCE))
        yield Claim("the approximation has negligible impact on performance (IV), here against "
                    "exact S-D assignment", f"{algorithm}: {told}", verdict,
                    _alike_rule(REFERENCE))


def _close_to_multi(outings: pd.DataFrame, _: str) -> Iterator[Claim]:
    for algorithm in FLOWS:
        told, verdict = _alike(_of(outings, algorithm), _of(outings, _MULTI))
        yield Claim("SCF is very close to MCF (IV)", f"{algorithm}: {told}", verdict,
                    _alike_rule(_MULTI))


def during(own: pd.DataFrame, series: str, inside: bool) -> pd.Series:
    """Per outing the mean of a series over the scans in the manoeuvres, or over the others."""
    def one(line: pd.Series) -> float:
        values = line[series]
        times = line["scan_period_s"] * np.arange(1, len(values) + 1)
        chosen = (times >= MANOEUVRES_S[0]) & (times <= MANOEUVRES_S[1])
        part = values[chosen if inside else ~chosen]
        return float(part.mean()) if len(part) else np.nan
    return own.apply(one, axis=1) if len(own) else pd.Series(dtype=float)


def _manoeuvres_only(outings: pd.DataFrame, scenario: str) -> Iterator[Claim]:
    if not scenario.startswith("battistelli-2"):
        return
    for algorithm in FLOWS:
        own = _of(outings, algorithm)
        excess = []
        for inside in (True, False):
            d, ideal = (during(own, s, inside)
                        for s in ("position_error_series_m", "ideal_series_m"))
            frame = own.assign(excess=d - ideal, ideal=ideal)
            excess.append(bootstrap.ratio(frame, "excess", "ideal", lambda x: 100 * x))
        yield Claim("comparable with the ideal but for 200-250 s (IV, scenario 2)",
                    f"{algorithm}: d above ideal {text(excess[0])} % within, {text(excess[1])} % "
                    "outside", at_most(excess[1], _NEGLIGIBLE_PERCENT),
                    f"d at most {_NEGLIGIBLE_PERCENT:g} % above the ideal outside 200-250 s")


def _not_association(outings: pd.DataFrame, scenario: str) -> Iterator[Claim]:
    if not scenario.startswith("battistelli-2"):
        return
    for algorithm in FLOWS:
        own = _of(outings, algorithm)
        d, ideal, oracle = (during(own, s, True) for s in
                            ("position_error_series_m", "ideal_series_m", "oracle_series_m"))
        frame = own.assign(excess=d - ideal, explained=oracle - ideal)
        share = None
        if len(frame) and frame["excess"].sum() > 0:
            share = bootstrap.ratio(frame, "explained", "excess", lambda x: 100 * x)
        yield Claim("that degradation is due to manoeuvres and P_d < 1 rather than to association "
                    "errors (IV, scenario 2)",
                    f"{algorithm}: the oracle has {text(share)} % of it", at_least(share, 50.0),
                    "exact association on the real plots has half of the excess over the ideal, or "
                    "more, in 200-250 s")


def _better_than_single(outings: pd.DataFrame, _: str) -> Iterator[Claim]:
    for algorithm in (REFERENCE, "scf-tie"):
        own = _of(outings, algorithm)
        wide, single = own[own["window_k"] == WINDOW_K], own[own["window_k"] == 1]
        pairs = paired(wide, single, ["position_error_m"])
        change = bootstrap.ratio(pairs, "position_error_m_difference", "position_error_m_reference",
                                 lambda x: 100 * x)
        verdict = at_most(change, 0.0)
        yield Claim("multiscan association significantly enhances tracking (abstract, I)",
                    f"{algorithm}: d at K={WINDOW_K} against K=1 {text(change, '+.1f')} %", verdict,
                    "d is smaller with several scans than with one, on the same runs")


JUDGES: tuple[Callable[[pd.DataFrame, str], Iterator[Claim]], ...] = (
    _near_ideal, _close_to_exact, _close_to_multi, _manoeuvres_only, _not_association,
    _better_than_single)
ALL_K = (_better_than_single,)  # the only one judged from outings of every K
