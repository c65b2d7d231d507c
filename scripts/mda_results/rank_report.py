"""Everything that scripts/rank.py tells, from a pool of runs."""

from collections.abc import Iterable
from dataclasses import dataclass, replace

import pandas as pd

from mda_results import (apart, curves, facts, hardness, pairwise, ranked_tracking, ranking,
                         scaling)
from mda_results.contest import Contest, compared, contests
from mda_results.pool import Pool
from mda_results.render import Report, Table
from mda_results.rows import RunError
from mda_results.standings import SHIFT_MS, Standing


@dataclass(frozen=True)
class Selection:
    """What to look at; None: all."""

    scenarios: tuple[str, ...] | None = None
    windows: tuple[int, ...] | None = None  # K
    algorithms: tuple[str, ...] | None = None


@dataclass(frozen=True)
class Ranked:
    """The report for people, and tables too long for them: data of figures."""

    report: Report
    data: list[Table]


def judged(pool: Pool, selection: Selection = Selection()) -> Pool:
    """The pool with its rows judged (facts.judged) and only what is selected. Bounds, best costs,
    hardness and refutations are facts about problems: they rest on all rows, whatever is selected.
    Raises RunError for a name that no row has, or if nothing is left."""
    rows = facts.judged(pool.rows) if len(pool.rows) else pool.rows
    frames = {"rows": rows, "outings": pool.outings}
    every = list(frames.values())
    for field, wanted in (("scenario", selection.scenarios), ("window_k", selection.windows),
                          ("algorithm", selection.algorithms)):
        if wanted is None:
            continue
        present = sorted(set().union(*(set(f[field].tolist()) for f in every)))
        for value in wanted:
            if value not in present:
                raise RunError(f"the runs have nothing of {_WORDS[field]} {value}; they have "
                               + ", ".join(map(str, present)))
        frames = {n: f[f[field].isin(wanted)] for n, f in frames.items()}
    if all(f.empty for f in frames.values()):
        raise RunError("the runs have nothing of this selection: no row has all of it")
    return replace(pool, **{n: f.reset_index(drop=True) for n, f in frames.items()})


_WORDS = {"scenario": "scenario", "window_k": "K =", "algorithm": "algorithm"}


def rank(pool: Pool, selection: Selection = Selection(), shift_ms: float = SHIFT_MS) -> Ranked:
    """The ranking of a pool; raises RunError as judged()."""
    chosen = judged(pool, selection)
    tables: list[Table] = []
    data: list[Table] = []
    about = [*pool.about, *_selected(selection)]
    if not chosen.rows.empty:
        told: list[str] = []
        found = contests(chosen.rows, told)
        about += [compared(c) for c in found] + told
        about += [f"{c.hardness}: no intervals, as no scenario has two scenes." for c in found
                  if c.weights() is None]
        if not found:
            about.append("No selections to rank on common windows with columns.")
        open_loop, data = _open_loop(chosen.rows, found, shift_ms)
        tables += open_loop
    about += ranked_tracking.unknown(chosen.outings)
    tables += ranked_tracking.tables(chosen.outings)
    return Ranked(Report("Ranking of the algorithms", about, tables), data)


def _open_loop(rows: pd.DataFrame, found: list[Contest],
               shift_ms: float) -> tuple[list[Table], list[Table]]:
    tables = [ranking.correctness(rows)]
    placed = ranking.ranked(found, shift_ms)
    data: list[Table] = []
    if found:
        tables += [ranking.order(placed, shift_ms), ranking.gaps(placed),
                   ranking.times(placed, shift_ms)]
        more, data = _compared(placed, shift_ms)
        tables += more
    if (rows["answer"] != "selection").any():
        tables.append(apart.table(rows, shift_ms))
    return [*tables, ranking.fates(rows)], data


def _compared(placed: list[tuple[Contest, list[Standing]]],
              shift_ms: float) -> tuple[list[Table], list[Table]]:
    """Without the disqualified, in the order of the ranking."""
    fit = [(c, [s for s in found if s.place is not None]) for c, found in placed]
    fit = [(c.of([s.algorithm for s in found]), found) for c, found in fit if found]
    own = [c for c, _ in fit]
    duels = [(c, pairwise.duels(c, shift_ms)) for c in own]
    tables = [pairwise.matrix(c, fought, measure) for c, fought in duels if fought
              for measure in ("cost", "time")]
    tables += [curves.pareto(fit), curves.profiles(own, curves.RATIOS, "profiles"),
               curves.ecdf(own, (0.0, 1.0), curves.TIMES_MS, "time_to_gap"), scaling.table(own),
               *hardness.tables(own, shift_ms)]
    data = [pairwise.pairs(duels), curves.profiles(own, curves.FINE_RATIOS, "profiles_fine"),
            curves.ecdf(own, curves.TARGETS_NATS, curves.FINE_TIMES_MS, "time_to_gap_fine")]
    return tables, data


def _selected(selection: Selection) -> Iterable[str]:
    parts = [f"{word} {', '.join(map(str, values))}" for word, values in (
        ("scenarios", selection.scenarios), ("K =", selection.windows),
        ("algorithms", selection.algorithms)) if values is not None]
    if parts:
        yield (f"Selected: {'; '.join(parts)}. Bounds, best known costs and refutations rest on "
               "all rows of the runs; everything else is computed anew.")
