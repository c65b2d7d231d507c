"""The claims of Bojilov (1995), each judged per scene by a rule that is printed."""

from collections.abc import Callable, Iterator

import pandas as pd

from mda_results.bojilov_tables import gap_percent, title_of
from mda_results.render import Cell, Column, Estimate, Table
from mda_results.three_sensors import (CALIBRATED, EXACT, LOSSES, PREFERRED, SCENE, UNTREATED,
                                       advantage, counted, target_exact)
from mda_results.verdicts import Claim, above, at_least, at_most, over, text, together

_TREATED = LOSSES[1.0]
_IMPROVES = 2.0  # points
_TIE = 0.5  # points
_NEAR_EXACT = 5.0  # points
_NEAR_OPTIMAL = 1.0  # percent of the optimal cost

_Judge = Callable[[pd.DataFrame], Iterator[Claim]]


def tables(rows: pd.DataFrame) -> list[Table]:
    """The claims with their rules, and what comes of each per scene."""
    scenes = list(rows[rows["layout"] == "grid"].groupby(SCENE, sort=True))
    rules: list[list[Cell]] = []
    verdicts: list[list[Cell]] = []
    for number, judge in enumerate(_JUDGES, start=1):
        claims = [(title_of(scene), c) for scene, own in scenes for c in judge(own)]
        if not claims:
            claims = [("all", c) for c in judge(rows.iloc[:0])]
        rules.append([str(number), claims[0][1].said, claims[0][1].rule])
        verdicts += [[str(number), scene, c.ours, c.verdict] for scene, c in claims]
    notes = ["Points: of correct association, paired by run. Brackets: 95 % bootstrap interval "
             "over runs. A rule met at some σ only: holds partly. The limits are ours."]
    return [Table("claims_rules", "Claims of the paper, and when they count as true",
                  [Column("no."), Column("the paper"), Column("rule")], rules),
            Table("claims", "Verdicts", [Column("no.", once=True), Column("scene", once=True),
                                         Column("ours"), Column("verdict")], verdicts, notes)]


def _points(own: pd.DataFrame, algorithm: str, other: str,
            judge: Callable[[Estimate | None], str]) -> tuple[str, str]:
    """The advantage of one algorithm over another at each sigma, and the verdict of all."""
    return over(own, "sigma", lambda part: advantage(part, algorithm, other), judge, "σ=", "+.1f")


def _treatment(own: pd.DataFrame) -> Iterator[Claim]:
    told, verdict = _points(own, _TREATED, UNTREATED, lambda e: at_least(e, _IMPROVES))
    yield Claim("treating the cost matrix improves the results considerably (4, 5)",
                f"{_TREATED} - {UNTREATED}: {told}", verdict,
                f"{_TREATED} (Q loses 1 %) is right in at least {_IMPROVES:g} points more of the "
                "targets than without treatment, at every σ")


def _depends(own: pd.DataFrame) -> Iterator[Claim]:
    loosest, tightest = LOSSES[min(LOSSES)], LOSSES[max(LOSSES)]
    told = []
    verdicts = []
    for end in (loosest, tightest):
        found, verdict = _points(own, _TREATED, end, lambda e: above(e, 0.0))
        told.append(f"{_TREATED} - {end}: {found}")
        verdicts.append(verdict)
    yield Claim("the improvement depends on Q (5)", "; ".join(told), together(verdicts),
                "Q of 1 % is better than both ends of the axis, at every σ")


def _preferable(own: pd.DataFrame) -> Iterator[Claim]:
    """Whether no other threshold is better than the better one of the two."""
    told = []
    verdicts = []
    for sigma, part in own.groupby("sigma"):
        values = {loss: target_exact(part[part["algorithm"] == a]) for loss, a in LOSSES.items()}
        known = {loss: e.value for loss, e in values.items() if e is not None}
        ours = [loss for loss in PREFERRED if loss in known]
        others = [loss for loss in known if loss not in PREFERRED]
        if not ours or not others:
            continue
        own_best, best = (max(group, key=known.__getitem__) for group in (ours, others))
        ahead = advantage(part, LOSSES[own_best], LOSSES[best])
        told.append(f"σ={sigma:g} {own_best:g} % - {best:g} % {text(ahead, '+.1f')}")
        verdicts.append(at_least(ahead, -_TIE))
    yield Claim("thresholds that lose 1 % and 2.5 % are preferable (5)",
                "; ".join(told) or "no data", together(verdicts),
                f"the better one of the two is at most {_TIE:g} points behind the best of the "
                "other thresholds, at every σ")


def _high_performance(own: pd.DataFrame) -> Iterator[Claim]:
    for algorithm in (_TREATED, CALIBRATED):
        told, verdict = _points(own, algorithm, EXACT, lambda e: at_least(e, -_NEAR_EXACT))
        yield Claim("high performance in terms of correct association (6), here against the exact "
                    "optimum of the likelihood ratio", f"{algorithm} - {EXACT}: {told}", verdict,
                    f"at most {_NEAR_EXACT:g} points behind {EXACT}, at every σ")


def _minimises(own: pd.DataFrame) -> Iterator[Claim]:
    for algorithm in (_TREATED, CALIBRATED):
        part = counted(own[own["algorithm"] == algorithm])
        told, verdict = over(part, "sigma", gap_percent, lambda e: at_most(e, _NEAR_OPTIMAL),
                             "σ=", ".1f")
        yield Claim("the partitioning found minimises the negative log likelihood (1)",
                    f"gap of {algorithm} in % of the optimum: {told}", verdict,
                    f"at most {_NEAR_OPTIMAL:g} % of the optimal cost, at every σ")


_JUDGES: tuple[_Judge, ...] = (_treatment, _depends, _preferable, _high_performance, _minimises)
