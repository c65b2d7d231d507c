"""The study of Battistelli et al. (2008): open loop, closed loop, figure 9 and the claims."""

from pathlib import Path

from mda_results import battistelli_claims, battistelli_closed, battistelli_open, plans
from mda_results.known_targets import RESOLUTIONS, SCENARIOS, KnownRun, load, nominal
from mda_results.render import Report, Table

_INVENTED = (
    "The paper's figures 3 to 9 are not at hand and its text prints no result value: trajectories "
    "are ours, so only its claims are judged, no number is compared."
)


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
        said += plans.unmet(run.name, run.manifest, loop, frame)
    return said
