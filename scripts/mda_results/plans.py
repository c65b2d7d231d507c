"""What a sweep in parts was to do, from its manifest, and what of it is not there."""

from typing import Any

import pandas as pd

from mda_results.rows import RunError

_PLAN = {"scenario": str, "loop": str, "windows": list, "replicates": int, "scan_periods_s": list,
         "algorithms": list}
_FIRST = "first_replicate"  # of plans of a part of the replicates; from 1 on without it
_LISTS = {"windows": {int}, "scan_periods_s": {int, float}, "algorithms": {str}}


def unmet(run: str, manifest: dict[str, Any], loop: str, frame: pd.DataFrame) -> list[str]:
    """A sentence if rows or outings of `loop` (open, closed) are missing in `frame`, none if they
    are all there or the manifest has no plans. Raises RunError if its plans are damaged."""
    key = ["scenario", "scan_period_s", "window_k", "algorithm"]
    found = frame.groupby(key)["replicate"].unique().to_dict()
    planned = [((plan["scenario"], period, k, algorithm), plan.get(_FIRST, 1), plan["replicates"])
               for plan in _plans(run, manifest, loop) for period in plan["scan_periods_s"]
               for k in plan["windows"] for algorithm in plan["algorithms"]]
    counts = [(cell, sum(first <= r <= last for r in found.get(cell, ())), last - first + 1)
              for cell, first, last in planned]
    short = [(cell, have, count) for cell, have, count in counts if have < count]
    if not short:
        return []
    (scenario, period, k, algorithm), have, count = short[0]
    return [f"Planned but not there: replicates of {len(short)} of {len(planned)} entries in "
            f"{loop} loop (scenario, scan period, K, algorithm); the first is {scenario} at "
            f"{period:g} s, "
            f"K = {k}, {algorithm}: {have} of {count}."]


def _plans(run: str, manifest: dict[str, Any], loop: str) -> list[dict[str, Any]]:
    sweep = manifest.get("sweep")
    plans = sweep.get("plans", []) if isinstance(sweep, dict) else []
    if not isinstance(plans, list):
        raise RunError(f"the manifest of {run} has plans that are no list")
    for plan in plans:
        wrong = [f for f, kind in _PLAN.items()
                 if not isinstance(plan, dict) or type(plan.get(f)) is not kind]
        if not wrong and type(plan.get(_FIRST, 1)) is not int:
            wrong = [_FIRST]
        wrong = wrong or [f for f, kinds in _LISTS.items()
                          if not {type(value) for value in plan[f]} <= kinds]
        if wrong:
            raise RunError(f"the manifest of {run} has a plan whose '{wrong[0]}' is absent or "
                           "of the wrong type")
    return [plan for plan in plans if plan["loop"] == loop]
