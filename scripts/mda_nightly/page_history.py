"""The history as a section of the page: drawn here, so it needs no script."""

from datetime import datetime
from pathlib import Path

import numpy as np

from mda_nightly import history, history_report
from mda_nightly.changepoints import Step
from mda_nightly.history import Series
from mda_results import page_html

_WIDTH, _HEIGHT, _LEFT, _EDGE = 640, 150, 56, 14  # px


def section(database: Path) -> str:
    """HTML; raises RunError if the file is no history."""
    nights, series = history.load(database)
    found = history.changes(series)
    report = history_report.report(nights, series)
    tables = {table.name: table for table in report.tables}
    changed = [s for s in series if any(t is s for t, _ in found)]
    quiet = [s for s in series if s.kind in history.RATIOS and s not in changed
             and len(s.values) > 1]
    return page_html.section(
        "history", "History", "Every metric over the nights, as a ratio to the anchor.",
        page_html.notes(report.lines), page_html.table_card(tables["changes"]),
        *(_card(s, [step for t, step in found if t is s]) for s in changed),
        _folded([_card(s, []) for s in quiet]),
        page_html.table_card(tables["metrics"], folded=True),
        page_html.table_card(tables["nights"], folded=True))


def _folded(cards: list[str]) -> str:
    if not cards:
        return ""
    return (f'<details class="card"><summary>Metrics without a change ({len(cards)})</summary>'
            f"{''.join(cards)}</details>")


def _card(series: Series, steps: list[Step]) -> str:
    unit = "% over the anchor" if series.kind in history.RATIOS else ""
    title = f"{series.kind} of {series.subject}, {series.machine}"
    return (f'<div class="card"><header><h3>{page_html.text(title)}</h3></header>'
            f"{_chart(series, steps, title)}"
            f'<p class="note">{page_html.text(unit)} {page_html.text(_ends(series))}</p></div>')


def _ends(series: Series) -> str:
    first, last = series.nights[0], series.nights[-1]
    return (f"{first.started[:10]} ({first.candidate[:10]}) to {last.started[:10]} "
            f"({last.candidate[:10]}), {history_report.number(len(series.values), 'night')}")


def _chart(series: Series, steps: list[Step], title: str) -> str:
    """Nights as dots over time, levels as lines."""
    values = [history_report.shown_size(series, float(v)) for v in series.values]
    x, y = _places(series), _heights(values)
    dots = "".join(f'<circle cx="{a:.1f}" cy="{b:.1f}" r="2.5" fill="var(--accent)"><title>'
                   f"{page_html.text(_night(series, i, values[i]))}</title></circle>"
                   for i, (a, b) in enumerate(zip(x, y)))
    bounds = [0, *(step.first for step in steps), len(values)]
    levels = "".join(_level(x[a:b], y[a:b]) for a, b in zip(bounds, bounds[1:]))
    ticks = "".join(f'<text x="{_LEFT - 8}" y="{b + 4:.1f}" text-anchor="end" font-size="11" '
                    f'fill="var(--muted)">{value:+.3g}</text>'
                    for value, b in {(min(values), max(y)), (max(values), min(y))})
    return (f'<div class="scroll"><svg viewBox="0 0 {_WIDTH} {_HEIGHT}" width="{_WIDTH}" '
            f'height="{_HEIGHT}" role="img" aria-label="{page_html.text(title)}">'
            f"{levels}{dots}{ticks}</svg></div>")


def _night(series: Series, i: int, value: float) -> str:
    night = series.nights[i]
    return f"{night.started[:10]} {night.candidate[:10]}: {value:+.4g}"


def _places(series: Series) -> list[float]:
    times = [datetime.fromisoformat(n.started.replace("Z", "+00:00")).timestamp()
             for n in series.nights]
    span = (times[-1] - times[0]) or 1.0
    return [_LEFT + (_WIDTH - _LEFT - _EDGE) * (t - times[0]) / span for t in times]


def _heights(values: list[float]) -> list[float]:
    span = (max(values) - min(values)) or 1.0
    return [_EDGE + (_HEIGHT - 2 * _EDGE) * (max(values) - v) / span for v in values]


def _level(x: list[float], y: list[float]) -> str:
    height = float(np.median(y))
    return (f'<line x1="{x[0]:.1f}" x2="{x[-1]:.1f}" y1="{height:.1f}" y2="{height:.1f}" '
            'stroke="var(--warn)" stroke-width="2"/>')
