"""The study of Lee & Jeong (1998): Tables 3 and 4 rebuilt, what they hide, and the claims."""

from collections.abc import Sequence
from pathlib import Path

import pandas as pd

from mda_results import lee_claims, lee_open, lee_tables
from mda_results.position_targets import (ALGORITHMS, DENSITIES, EITHER, LAWS, PAIRS, PositionRun,
                                          load, without_echoes)
from mda_results.render import Cell, Column, Report, Table

_FITTED = ("Fitted, after looking at the paper's Table 3: the spread of the clutter around the "
           "targets (0.5 km), the filter's acceleration and the threshold of 0.45 km. Uniform "
           "clutter is not fitted. Figures 6 to 9 of the paper are not at hand.")


def report(directories: Sequence[Path]) -> tuple[Report, list[str]]:
    """All tables that the runs have lines for, and warnings; raises RunError on damage."""
    run = load(directories)
    outings = without_echoes(run.outings)
    tables = lee_tables.tables(outings)
    if len(run.rows):
        tables += lee_open.tables(run.rows)
    tables += lee_claims.tables(outings)
    if len(outings):
        tables.append(_fates(outings))
    about = [f"Runs {run.name}: {len(run.outings)} outings in closed loop, {len(run.rows)} rows in "
             f"open loop; commit {', '.join(run.commits)}.", *_updates(outings), _FITTED,
             *_missing(run)]
    return Report("Lee & Jeong 1998", about, tables), run.warnings


def _updates(outings: pd.DataFrame) -> list[str]:
    found = sorted(set(outings["update"]) - {EITHER})
    told = f"How marginals move a track: {', '.join(found)}." if found else ""
    if EITHER in set(outings["update"]):
        told += f" '{EITHER}': the same track under each update on all runs that both have."
    return [told.strip()] if told else []


def _missing(run: PositionRun) -> list[str]:
    """A sentence for each kind of what the runs do not have."""
    said = []
    found = set(run.outings["algorithm"])
    absent = [a for a in ALGORITHMS if a not in found]
    if absent:
        said.append(f"Not in closed loop: {', '.join(absent)}.")
    wanted = [(s, d, law) for law in LAWS for s in PAIRS for d in DENSITIES]
    wanted += [("ten", DENSITIES[0], law) for law in LAWS]
    have = set(zip(run.outings["scene"], run.outings["density"], run.outings["law"]))
    lacking = [f"{s} at C = {d:g}, {law}" for s, d, law in wanted if (s, d, law) not in have]
    if lacking:
        said.append(f"Scenes without outings: {'; '.join(lacking)}.")
    if run.rows.empty:
        said.append("Not in these runs: open loop.")
    return said + run.lacking


def _fates(outings: pd.DataFrame) -> Table:
    columns = [Column("algorithm"), Column("update"), Column("outings"), Column("finished"),
               Column("skipped"), Column("failed"), Column("scans without an answer"),
               Column("note of the first skipped or failed")]
    rows: list[list[Cell]] = []
    for key, own in lee_tables.entries(outings):
        counts = own["status"].value_counts()
        bad = own[own["status"] != "finished"]
        rows.append([*key, len(own),
                     *(int(counts.get(s, 0)) for s in ("finished", "skipped", "failed")),
                     int(own["unanswered"].sum()),
                     str(bad["note"].iloc[0])[:60] if len(bad) else None])
    return Table("fates", "What became of every outing", columns, rows,
                 ["Only finished outings enter the tables above."])
