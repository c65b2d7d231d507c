"""The study of Bojilov (1995): figure 2 as tables, with what the paper does not measure."""

from pathlib import Path

from mda_results import bojilov_claims, bojilov_tables
from mda_results.cells import answered
from mda_results.render import Report
from mda_results.rows import WINDOW_KEY
from mda_results.three_sensors import (EXACT, FALSE_ALARMS, SIGMAS, TARGETS, SensorRun, load)

_PICTURE = ("Figure 2 of the paper is a picture that is not at hand and its text prints no result: "
            "only its claims are judged, no number is compared. False alarms, and what a correct "
            "association is, are ours.")


def report(directory: Path) -> tuple[Report, list[str]]:
    """All tables that the run has rows for, and warnings; raises RunError when it is damaged."""
    run = load(directory)
    about = [f"Run {run.name}: {len(run.rows)} rows, commit "
             f"{run.manifest.get('commit', 'unknown')}.", _PICTURE, _optima(run), *_missing(run),
             *run.lacking]
    tables = [*bojilov_tables.tables(run.rows), *bojilov_claims.tables(run.rows)]
    return Report("Bojilov 1995", about, tables), run.warnings


def _optima(run: SensorRun) -> str:
    """How far the optimum that gaps refer to is proven."""
    windows = run.rows.drop_duplicates(WINDOW_KEY)
    own = run.rows[(run.rows["algorithm"] == EXACT) & answered(run.rows)]
    proven = int((own["status"] == "optimal").sum())
    bounded = (own["cost_nats"] - own["certified_bound_nats"]).dropna()
    told = f"Optimum: claimed with a proof by {EXACT} in {proven} of {len(windows)} windows"
    if bounded.empty:
        return f"{told}."
    met = int((bounded <= 1e-5 + 1e-9 * own.loc[bounded.index, "cost_nats"].abs()).sum())
    return (f"{told}; in {met} of them its bound, recomputed from multipliers, meets the cost, "
            f"in the others it is up to {bounded.max():.2g} nats below.")


def _missing(run: SensorRun) -> list[str]:
    have = set(zip(*(run.rows[f] for f in ("targets", "layout", "false_alarms", "sigma"))))
    absent = [f"{n} targets, F = {f:g}, σ = {s:g}" for n in TARGETS for f in FALSE_ALARMS
              for s in SIGMAS if (n, "grid", f, s) not in have]
    if not absent:
        return []
    more = f" and {len(absent) - 1} more" if len(absent) > 1 else ""
    return [f"Points of the study without rows: {absent[0]}{more}."]
