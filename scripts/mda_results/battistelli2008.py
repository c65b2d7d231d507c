"""The study of Battistelli et al. (2008): open loop, closed loop, figure 9 and the claims."""

from pathlib import Path
from typing import Any

import pandas as pd

from mda_results import battistelli_claims, battistelli_closed, battistelli_open
from mda_results.known_targets import RESOLUTIONS, SCENARIOS, KnownRun, load, nominal
from mda_results.render import Report, Table
from mda_results.rows import RunError

_INVENTED = (
    "The paper's figures 3 to 9 are not at hand and its text prints no result value: trajectories "
    "are ours, so only its claims are judged, no number is compared."
)
_PLAN = {"scenario": str, "loop": str, "windows": list, "replicates": int, "scan_periods_s": list,
         "algorithms": list}
_LISTS = {"windows": {int}, "scan_periods_s": {int, float}, "algorithms": {str}}


def report(directory: Path) -> tuple[Report, list[str]]:
    """All tables that the run has rows for, and warnings; raises RunError when it is damaged."""
    run = load(directory)
    tables: list[Table] = []
    if len(nominal(run.rows)):
        tables += battistelli_open.tables(run.rows)
    if len(nominal(run.outings)):
        tables += battistelli_closed.tables(run.outings)
    if len(battistelli_closed.of_figure_9(run.outings)):
        tables.append(battistelli_closed.resolution_table(run.outings))
    tables += battistelli_claims.tables(run)
    about = [f"Run {run.name}: {len(run.rows)} rows in open loop, {len(run.outings)} outings in "
             f"closed loop, commit {run.manifest.get('commit', 'unknown')}.", _INVENTED,
             *missing(run)]
    return Report("Battistelli et al. 2008", about, tables), run.warnings


def missing(run: KnownRun) -> list[str]:
    """A sentence for each part that the run does not have, whole or in part."""
    parts = [("part (a), open loop", SCENARIOS, nominal(run.rows)),
             ("part (b), closed loop", SCENARIOS, nominal(run.outings)),
             ("part (c), figure 9", tuple(RESOLUTIONS), run.outings)]
    said = []
    for name, scenarios, frame in parts:
        found = set(frame["scenario"])
        absent = [s for s in scenarios if s not in found]
        if len(absent) == len(scenarios):
            said.append(f"Not in this run: {name}.")
        elif absent:
            said.append(f"Not in this run: {', '.join(absent)} of {name}.")
    for loop, frame in (("open", run.rows), ("closed", run.outings)):
        said += _unmet(_plans(run, loop), loop, frame)
    return said


def _plans(run: KnownRun, loop: str) -> list[dict[str, Any]]:
    """The plans of the sweep for one loop, from the manifest; raises RunError if damaged."""
    sweep = run.manifest.get("sweep")
    plans = sweep.get("plans", []) if isinstance(sweep, dict) else []
    if not isinstance(plans, list):
        raise RunError(f"the manifest of {run.name} has plans that are no list")
    for plan in plans:
        wrong = [f for f, kind in _PLAN.items()
                 if not isinstance(plan, dict) or type(plan.get(f)) is not kind]
        wrong = wrong or [f for f, kinds in _LISTS.items()
                          if not {type(value) for value in plan[f]} <= kinds]
        if wrong:
            raise RunError(f"the manifest of {run.name} has a plan whose '{wrong[0]}' is absent or "
                           "of the wrong type")
    return [plan for plan in plans if plan["loop"] == loop]


def _unmet(plans: list[dict[str, Any]], loop: str, frame: pd.DataFrame) -> list[str]:
    key = ["scenario", "scan_period_s", "window_k", "algorithm"]
    found = frame.groupby(key)["replicate"].nunique().to_dict()
    planned = [((plan["scenario"], period, k, algorithm), plan["replicates"])
               for plan in plans for period in plan["scan_periods_s"] for k in plan["windows"]
               for algorithm in plan["algorithms"]]
    short = [(cell, found.get(cell, 0), count) for cell, count in planned
             if found.get(cell, 0) < count]
    if not short:
        return []
    (scenario, period, k, algorithm), have, count = short[0]
    return [f"Planned but not there: replicates of {len(short)} of {len(planned)} entries in "
            f"{loop} loop (scenario, scan period, K, algorithm); the first is {scenario} at "
            f"{period:g} s, "
            f"K = {k}, {algorithm}: {have} of {count}."]
