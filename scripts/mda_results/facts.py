"""What all rows of a problem say together: the best bound and cost, how hard it is, and what became
of every row. Rows with one fingerprint are of one problem."""

import numpy as np
import pandas as pd

from mda_results.pool import KEY

# What became of a row. Each is one of these; a hole in the grid is NOT_ASKED.
FATES = ("optimal", "feasible", "timed out", "no answer", "failed", "refuted", "declined",
         "not asked")
OPTIMAL, FEASIBLE, TIMED_OUT, NO_ANSWER, FAILED, REFUTED, DECLINED, NOT_ASKED = range(len(FATES))

# How hard a window is, for whatever solver: no certificate by multipliers exceeds the LP optimum.
EASY, HARD, OPEN, EMPTY = "easy", "hard", "open", "empty"
HARDNESSES = (EASY, HARD, OPEN)
HARDNESS_MEANING = {
    EASY: "a certificate closes the gap: best bound = best known cost, the LP optimum is integral "
          "in value",
    HARD: "no certificate closes it: best bound below the best known cost by more than "
          "1e-5 nats + 1e-9 |cost|",
    OPEN: "no row has a certified bound, or none a verified cost",
}


def tolerance(cost: pd.Series) -> pd.Series:
    """How far costs may differ before the difference is news, nats; that of the referee."""
    return 1e-5 + 1e-9 * cost.abs()


def judged(rows: pd.DataFrame) -> pd.DataFrame:
    """The rows of a pool with
      window     number of the window, in the order of KEY
      bound      best certified bound of the problem, nats
      best       cheapest verified cost of the problem, nats: of columns where there is one
      idle       cost of doing nothing; infinite where that is not allowed or nothing tells
      hardness   EASY, HARD, OPEN or EMPTY (no columns)
      lp_gap     best - bound
      lp_fractional  least number of fractional columns of an LP optimum over columns
      fate       number of one of FATES
      why        what refutes the row; empty for the others
    """
    problem = pd.factorize(rows["fingerprint"])[0]
    status, answer, stop = rows["status"], rows["answer"], rows["stop"]
    standing = status.isin(["optimal", "feasible"])
    cost = rows["cost_nats"]
    choice = standing & (answer == "selection") & (rows["off_column_paths"].fillna(0) == 0)
    bound = _least(-rows["certified_bound_nats"], problem) * -1.0
    impossible = choice & (cost < bound - tolerance(cost))
    best = _least(cost.where(choice & ~impossible), problem)
    best = np.fmin(best, _least(rows["reference_cost_nats"], problem))
    best = best.fillna(_least(cost.where(standing & (answer == "selection")), problem))
    beyond = best + tolerance(best)
    false_optimum = (status == "optimal") & (answer != "marginals") & (cost > beyond)
    false_bound = rows["bound_nats"] > beyond
    by_referee = (status == "failed") & (stop != "error")
    fate = np.select(
        [by_referee | impossible | false_optimum | false_bound, status == "skipped",
         status == "failed", status == "optimal", stop == "deadline", status == "no_answer"],
        [REFUTED, DECLINED, FAILED, OPTIMAL, TIMED_OUT, NO_ANSWER], FEASIBLE)
    why = _reasons(rows, best, bound, by_referee, false_optimum, false_bound, impossible)
    lp = rows["fractional"].where(rows["graph_nodes"].isna() & standing)
    result = rows.assign(window=rows.groupby(KEY, sort=True).ngroup(), bound=bound, best=best,
                         idle=_idle(rows, problem), lp_gap=best - bound, fate=fate, why=why,
                         lp_fractional=_least(lp, problem))
    closed = result["lp_gap"] <= tolerance(best)
    return result.assign(hardness=np.select(
        [rows["columns"] == 0, result["lp_gap"].isna(), closed], [EMPTY, OPEN, EASY], HARD))


def _least(values: pd.Series, problem: np.ndarray) -> pd.Series:
    return values.groupby(problem).transform("min")


def _idle(rows: pd.DataFrame, problem: np.ndarray) -> pd.Series:
    """gap_share is gap / (idle - reference cost), which gives idle away. Where every share is 0 but
    known, only windows of at-most-once rows are sure; there idle is 0."""
    share = rows["gap_share"]
    given = rows["reference_cost_nats"] + rows["gap_nats"] / share.where(share > 1e-6)
    known = _least(given, problem)
    allowed = share.notna().groupby(problem).transform("any")
    known = known.mask(known.abs() < 1e-3).fillna(0.0)
    return known.where(allowed, np.inf)


def _reasons(rows: pd.DataFrame, best: pd.Series, bound: pd.Series, by_referee: pd.Series,
             false_optimum: pd.Series, false_bound: pd.Series,
             impossible: pd.Series) -> np.ndarray:
    why = np.full(len(rows), "", dtype=object)
    cost, claimed = rows["cost_nats"], rows["bound_nats"]
    for i in np.flatnonzero(impossible):
        why[i] = f"costs {cost.iat[i]:.6f}, below the certified {bound.iat[i]:.6f}"
    for i in np.flatnonzero(false_bound):
        why[i] = f"claimed the bound {claimed.iat[i]:.6f}, but {best.iat[i]:.6f} is known"
    for i in np.flatnonzero(false_optimum):
        why[i] = f"claimed optimal at {cost.iat[i]:.6f}, but {best.iat[i]:.6f} is known"
    for i in np.flatnonzero(by_referee):
        why[i] = rows["note"].iat[i] or "refuted by the referee"
    return why


def answered(fate: np.ndarray, cost: np.ndarray) -> np.ndarray:
    """Which cells hold an answer that stands, late ones included."""
    return np.isin(fate, (OPTIMAL, FEASIBLE, TIMED_OUT)) & ~np.isnan(cost)
