"""The history for people: nights, changes, and where every metric stands."""

import numpy as np

from mda_nightly import changepoints, history
from mda_nightly.changepoints import Step
from mda_nightly.history import Night, Series
from mda_results.render import Cell, Column, Report, Table

_SHOWN_NIGHTS = 30


def report(nights: list[Night], series: list[Series]) -> Report:
    """All tables."""
    found = history.changes(series)
    machines = len({n.machine for n in nights})
    about = [f"{number(len(nights), 'night')}, {sum(n.valid for n in nights)} with valid times, on "
             f"{number(machines, 'machine')}.",
             "Times and instructions are ratios to the anchor, which ran in the same session on the "
             "same machine; seconds of different nights are never compared."]
    return Report("History", about, [_changes(found), _metrics(series, found), _nights(nights)])


def number(count: int, what: str) -> str:
    """With its noun."""
    return f"{count} {what}{'s' * (count != 1)}"


def shown_size(series: Series, size: float) -> float:
    """In percent of ratios, in the metric's own unit otherwise."""
    return 100 * float(np.expm1(size)) if series.kind in history.RATIOS else size


def _changes(found: list[tuple[Series, Step]]) -> Table:
    rows: list[list[Cell]] = [
        [s.machine, s.kind, s.subject, s.nights[step.first].started[:10],
         shown_size(s, step.size), history.commit_range(s, step), step.p]
        for s, step in sorted(found, key=lambda pair: pair[0].nights[pair[1].first].started)]
    notes = [f"Series of at least {changepoints.LEAST_NIGHTS} nights; a level is at least "
             f"{changepoints.LEAST_LEVEL} nights long. Change: percent of CPU time and instructions, "
             "nats of gaps, share of integral windows. A history without a change shows one in at "
             f"most {100 * changepoints.LEVEL:g} % of cases. What came in: git log RANGE."]
    return Table("changes", "Changes of level", [
        Column("machine", once=True), Column("metric"), Column("of"), Column("since"),
        Column("change", digits="+.3g"), Column("commits"), Column("p", digits=".1g")], rows, notes)


def _metrics(series: list[Series], found: list[tuple[Series, Step]]) -> Table:
    rows: list[list[Cell]] = []
    for s in series:
        own = [step.first for t, step in found if t is s]
        level = s.values[max(own, default=0):]
        rows.append([s.machine, s.kind, s.subject, len(s.values), shown_size(s, float(s.values[-1])),
                     shown_size(s, float(np.median(level))), len(level)])
    return Table("metrics", "Where every metric stands", [
        Column("machine", once=True), Column("metric", once=True), Column("of"), Column("nights"),
        Column("last", digits="+.3g"), Column("level", digits="+.3g"), Column("for nights")], rows,
        ["CPU time and instructions: percent more than the anchor."])


def _nights(nights: list[Night]) -> Table:
    rows: list[list[Cell]] = [[n.started, n.machine, n.candidate[:12], n.anchor[:12],
                               "yes" if n.valid else "no", n.verdict]
                              for n in nights[-_SHOWN_NIGHTS:]]
    notes = [f"The last {_SHOWN_NIGHTS}."] if len(nights) > _SHOWN_NIGHTS else []
    return Table("nights", "Nights", [
        Column("started"), Column("machine", once=True), Column("candidate"),
        Column("anchor", once=True), Column("times valid"), Column("verdict")], rows, notes)
