"""The conclusions of Storms & Spieksma (2003), sections 5 and 6, each with a verdict from the rows.

A verdict follows from the rule that is printed beside it."""

from collections.abc import Sequence

import numpy as np
import pandas as pd

from mda_results import bootstrap, cells
from mda_results.render import Cell, Column, Estimate, Report, Table
from mda_results.rows import Run
from mda_results.verdicts import FAILS, HOLDS, OPEN, Claim
from mda_results.verdicts import text as _text
from mda_results.verdicts import verdict as _verdict

_WIDE = ["A", "B", "C"]
_WIDTH_DIFFERENCES = {"A": 16.505, "B": 19.54, "C": 24.166}  # nats, section 5


def report(runs: Sequence[Run]) -> Report:
    """Every conclusion, from the first run; V_T from every run, as their gates may differ."""
    rows = _of_the_grid(cells.rows_of_paper(runs[0]))
    measured, paper = cells.measured(rows), cells.published()
    claims = [
        _integrality(measured, paper, _WIDE, "94 % of the LPs of groups A to C are integral"),
        _integrality(measured, paper, ["D"], "56 % of the LPs of group D are integral"),
        _rounding(measured), _near_optimal(rows), _clutter(measured), _packed(measured),
        *_no_gain(measured), *_widths(measured),
        *(_truth(run) for run in runs if _has_wide(run)),
        *_speed(runs), *_limited_time(rows), _variables(rows),
    ]
    columns = [Column("the paper"), Column("ours"), Column("verdict"), Column("rule")]
    table_rows: list[list[Cell]] = [[c.said, c.ours, c.verdict, c.rule] for c in claims]
    about = [f"Runs: {', '.join(run.name for run in runs)}. Brackets: 95 % bootstrap interval over "
             "scenarios."]
    table = Table("claims", "Conclusions of sections 5 and 6", columns, table_rows)
    return Report("Storms & Spieksma 2003, claim by claim", about, [table])


def _of_the_grid(rows: pd.DataFrame) -> pd.DataFrame:
    """Without the windows of group D that the paper does not have: it has K = 3 only."""
    return rows[(rows["group"] != "D") | (rows["window_k"] == 3)]


def _percent(frame: pd.DataFrame, part: str, whole: str) -> Estimate | None:
    return bootstrap.ratio(frame, part, whole, lambda x: 100 * x)


def _integral(frame: pd.DataFrame) -> Estimate | None:
    return _percent(frame.assign(integral=frame["windows"] - frame["fractional"]), "integral",
                    "windows")


def _integrality(ours: pd.DataFrame, paper: pd.DataFrame, groups: list[str], said: str) -> Claim:
    ks = paper.loc[paper["group"].isin(groups), "window_k"].unique()
    mine = _integral(ours[ours["group"].isin(groups) & ours["window_k"].isin(ks)])
    theirs = _integral(paper[paper["group"].isin(groups)])
    assert theirs is not None and theirs.low is not None and theirs.high is not None
    low, high = theirs.low, theirs.high
    verdict = _verdict(mine, lambda a, b: a <= high and b >= low, lambda a, b: a > high or b < low)
    return Claim(said, f"{_text(mine)} %", verdict,
                 f"our interval meets that of the published scenarios, {_text(theirs)} %")


def _rounding(ours: pd.DataFrame) -> Claim:
    own = ours[ours["group"].isin(_WIDE)]
    mine = _percent(own, "rounded_optimal", "gap_known")
    return Claim("rounding finds the optimum of most fractional windows, groups A to C",
                 f"{_text(mine)} % of {int(own['gap_known'].sum())}",
                 _verdict(mine, lambda a, _: a > 50, lambda _, b: b < 50), "more than 50 %")


def _near_optimal(rows: pd.DataFrame) -> Claim:
    said = "rounding stays within 1 % of O"
    own = rows[(rows["algorithm"] == cells.ROUNDING) & (rows["integral"] == 0)]
    o = (own["retired_nats"] + own["reference_cost_nats"]).abs()
    share = (100 * cells.without_noise(own["gap_nats"]) / o).dropna()
    if share.empty:
        return Claim(said, "no fractional windows", OPEN, "")
    within = 100 * float((share <= 1).mean())
    return Claim(said, f"{within:.1f} % of {len(share)} fractional windows do; largest "
                 f"{share.max():.2f} %", HOLDS if share.max() <= 1 else FAILS,
                 "all gaps at most 1 % of |O| after the scan")


def _clutter(ours: pd.DataFrame) -> Claim:
    a, c = (_integral(ours[ours["group"] == g]) for g in ("A", "C"))
    verdict = OPEN
    if a is not None and a.low is not None:
        low = a.low
        verdict = _verdict(c, lambda x, _: x >= low, lambda _, y: y < low)
    return Claim("more false alarms make windows no harder",
                 f"integral: A {_text(a)} %, C {_text(c)} %", verdict,
                 "C's interval does not reach below A's")


def _packed(ours: pd.DataFrame) -> Claim:
    wide, packed = _integral(ours[ours["group"].isin(_WIDE)]), _integral(ours[ours["group"] == "D"])
    verdict = OPEN
    if wide is not None and wide.low is not None:
        low = wide.low
        verdict = _verdict(packed, lambda _, b: b < low, lambda a, _: a > low)
    return Claim("targets from a small area make windows harder",
                 f"integral: A to C {_text(wide)} %, D {_text(packed)} %", verdict,
                 "D's interval lies below that of A to C")


def _optimum_by_k(ours: pd.DataFrame, group: str) -> pd.DataFrame:
    return ours[ours["group"] == group].pivot(index="replicate", columns="window_k",
                                              values="optimum")


def _no_gain(ours: pd.DataFrame) -> list[Claim]:
    claims = []
    for group in _WIDE:
        said = f"no gain in O beyond K = 5, group {group}"
        table = _optimum_by_k(ours, group)
        if not {5, 7} <= set(table.columns):
            claims.append(Claim(said, "no windows of K = 5 and 7", OPEN, ""))
            continue
        gain = (table[5] - table[7]).rename("gain").reset_index().assign(group=group, one=1)
        mine = bootstrap.ratio(gain, "gain", "one")
        limit = 0.001 * float(table[7].abs().mean())
        same = 100 * float((gain["gain"].abs() <= cells.GAP_TOLERANCE).mean())
        claims.append(Claim(
            said, f"O(5) - O(7) = {_text(mine, '.2f')} nats, equal in {same:.0f} % of scenarios",
            _verdict(mine, lambda _, b: b < limit, lambda a, _: a > limit),
            f"mean gain below 0.1 % of |O|, {limit:.2f} nats"))
    return claims


def _widths(ours: pd.DataFrame) -> list[Claim]:
    claims = []
    for group, published in _WIDTH_DIFFERENCES.items():
        said = f"O of two widths differs by {published} nats at most, group {group}: marginal"
        table = _optimum_by_k(ours[ours["window_k"].between(3, 7)], group)
        if table.shape[1] < 2:
            claims.append(Claim(said, "fewer than two widths", OPEN, ""))
            continue
        spread = table.max(axis=1) - table.min(axis=1)
        share = 100 * float((spread / table.abs().max(axis=1)).max())
        claims.append(Claim(
            said, f"at most {spread.max():.1f} nats, {share:.1f} % of |O|; mean "
            f"{spread.mean():.1f} over {len(spread)} scenarios",
            HOLDS if share <= 5 else FAILS, "at most 5 % of |O| in every scenario"))
    return claims


def _truth(run: Run) -> Claim:
    ours = cells.measured(cells.rows_of_paper(run))
    scenarios = run.manifest.get("scenarios", {})
    gates = {f"{s['gate']:g}" for name, s in scenarios.items() if name in _WIDE and "gate" in s}
    own = ours[ours["group"].isin(_WIDE)].dropna(subset=["truth", "optimum"])
    own = own[own["window_k"] == own["window_k"].max()]
    above = own["optimum"] > own["truth"]
    mine = _percent(own.assign(above=above.astype(int), one=1), "above", "one")
    if len(own) and not above.any():  # resampling zeros says nothing: the rule of three does
        mine = Estimate(0.0, 0.0, min(100.0, 300.0 / len(own)))
    excess = (own["optimum"] - own["truth"])[above].sort_values(ascending=False).head(3)
    largest = ", ".join(f"{e:.1f}" for e in excess) or "none"
    k = "" if own.empty else f" at K = {own['window_k'].max()}"
    return Claim(
        "O above V_T in 3 of 30 scenarios (33.8, 54.7, 38.2 nats); "
        f"gate {', '.join(gates) or 'unknown'}",
        f"{int(above.sum())} of {len(own)}{k}: {_text(mine, '.0f')} %; largest {largest}",
        _verdict(mine, lambda a, b: a <= 10 <= b, lambda a, b: a > 10 or b < 10),
        "our interval holds 10 %")


def _has_wide(run: Run) -> bool:
    return bool(run.rows["scenario"].isin(_WIDE).any())


def _paired_times(rows: pd.DataFrame, slow: str, quick: str) -> pd.DataFrame:
    usable = rows[cells.answered(rows) & (rows["stop"] == "finished")]
    key = cells.window_key()
    first, second = (usable[usable["algorithm"] == a] for a in (slow, quick))
    return first[[*key, "cpu_ms"]].merge(second[[*key, "cpu_ms", "integral"]], on=key,
                                         suffixes=("_slow", "_quick"))


def _speed(runs: Sequence[Run]) -> list[Claim]:
    """From the first run that has both algorithms."""
    claims = []
    every = [_of_the_grid(cells.rows_of_paper(run)) for run in runs]
    for slow, quick, solver in (("cbc", "lp-grp", "Clp and CBC"),
                                ("lpsolve-bb", "lpsolve-lp-grp", "lp_solve")):
        said = ("LP and rounding 1.2 times faster in 50 %, 1.5 times in 20 % of D's fractional "
                f"windows; {solver}")
        both = [rows for rows in every if {slow, quick} <= set(rows["algorithm"])]
        rows = both[0] if both else every[0]
        pairs = _paired_times(rows[rows["group"] == "D"], slow, quick)
        ratio = (pairs["cpu_ms_slow"] / pairs["cpu_ms_quick"])[pairs["integral"] == 0]
        if ratio.empty:
            claims.append(Claim(said, f"no rows of {slow} and {quick}", OPEN, ""))
            continue
        some, more = 100 * float((ratio >= 1.2).mean()), 100 * float((ratio >= 1.5).mean())
        claims.append(Claim(
            said, f"{some:.0f} % and {more:.0f} % of {len(ratio)}; ratio: mean {ratio.mean():.2f}, "
            f"median {ratio.median():.2f}",
            HOLDS if some >= 50 and more >= 20 else FAILS, "both shares reached, CPU time"))
    return claims


def _limited_time(rows: pd.DataFrame) -> list[Claim]:
    claims = []
    for group, k, published in (("A", 3, "0.07 s, branch and bound 0.09 s"),
                                ("C", 7, "1.7 s, branch and bound 2.26 s"),
                                ("D", 3, "4.5 s, branch and bound 5.7 s")):
        own = rows[(rows["group"] == group) & (rows["window_k"] == k)]
        said = f"time of LP and rounding is limited, {group} K = {k}: {published}"
        times = {a: own.loc[own["algorithm"] == a, "cpu_ms"].dropna() for a in ("lp-grp", "cbc")}
        if times["lp-grp"].empty:
            claims.append(Claim(said, "no rows", OPEN, ""))
            continue
        told = "; ".join(
            f"{a} {np.quantile(t, 0.5):.2f}, {np.quantile(t, 0.99):.2f}, {t.max():.2f} ms"
            for a, t in times.items() if not t.empty)
        claims.append(Claim(said, f"median, p99, max: {told}",
                            HOLDS if times["lp-grp"].max() < 8000 else FAILS,
                            "largest CPU time of lp-grp below the scan period, 8 s"))
    return claims


def _variables(rows: pd.DataFrame) -> Claim:
    said = "gating cuts 22e9 variables to about 1400 at K = 7"
    own = rows[(rows["algorithm"] == cells.ROUNDING) & (rows["window_k"] == 7)
               & rows["group"].isin(_WIDE)]
    if own.empty:
        return Claim(said, "no windows of K = 7", OPEN, "")
    largest = int(own["columns"].max())
    return Claim(said, f"up to {own['ungated_columns'].max():.1e} cut to {largest} at most, "
                 f"{own['columns'].mean():.0f} on average",
                 HOLDS if 700 <= largest <= 2800 else FAILS,
                 "largest number of columns within a factor of 2 of 1400")
