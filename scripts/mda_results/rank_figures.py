"""Figures of the ranking, easy and hard windows side by side: gap against time, performance
profiles, time to the best known cost."""

import functools
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from mda_results import curves, measures, plotting, pool, rank_report, ranking
from mda_results.contest import Contest, contests
from mda_results.palette import style_of
from mda_results.render import Estimate
from mda_results.rows import RunError
from mda_results.standings import SHIFT_MS, Standing

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SMALLEST_GAP = 1e-2  # nats: below, axes are linear
_PANEL_INCHES = (5.6, 4.4)
_LEGEND_INCHES = 0.9
_PER_LEGEND_LINE = 6
_MARK_EVERY = 8  # points of a curve

Ranked = list[tuple[Contest, list[Standing]]]


def figures(loaded: pool.Pool) -> dict[str, Callable[[], "Figure"]]:
    """How to draw each figure, by file name; drawing raises RunError if nothing is ranked. The
    disqualified are left out."""
    ranked = functools.cache(lambda: _ranked(loaded))
    return {"gap_against_time": lambda: _gap_against_time(ranked()),
            "profiles": lambda: _profiles(ranked()),
            "time_to_gap": lambda: _time_to_gap(ranked())}


def _ranked(loaded: pool.Pool) -> Ranked:
    found: list[Contest] = []
    if len(loaded.rows):
        found = contests(rank_report.judged(loaded).rows, [])
    fit = [(c, [s for s in placed if s.place is not None])
           for c, placed in ranking.ranked(found, SHIFT_MS)]
    fit = [(c.of([s.algorithm for s in placed]), placed) for c, placed in fit if placed]
    if not fit:
        raise RunError(f"{', '.join(loaded.names)} has no selections to rank on common windows")
    return fit


def _panels(ranked: Ranked) -> tuple["Figure", list["Axes"], "Axes"]:
    """A figure with an axis per hardness, named, and one for the legend."""
    width, height = _PANEL_INCHES
    figure, axes, legend = plotting.with_legend_row(
        1, len(ranked), (width * len(ranked), height + _LEGEND_INCHES), _LEGEND_INCHES,
        sharex=True, sharey=True)
    for axis, (contest, _) in zip(axes[0], ranked):
        axis.set_title(f"{len(contest.windows):,} {contest.hardness} windows")
        axis.set_xscale("log")
        axis.xaxis.set_major_formatter(lambda x, _: f"{x:g}")
    return figure, list(axes[0]), legend


def _gap_against_time(ranked: Ranked) -> "Figure":
    figure, axes, legend = _panels(ranked)
    for axis, (_, found) in zip(axes, ranked):
        _draw_front(axis, found)
        for s in found:
            axis.errorbar(s.time.value, s.gap.value, xerr=_bar(s.time), yerr=_bar(s.gap),
                          linestyle="none", markersize=8, capsize=2, elinewidth=0.8,
                          label=s.algorithm, **style_of(s.algorithm).point())
        axis.set_yscale("symlog", linthresh=_SMALLEST_GAP, linscale=0.5)
        axis.set_xlabel("CPU time, shifted geometric mean [ms]")
    axes[0].set_ylim(bottom=-0.3 * _SMALLEST_GAP)
    axes[0].set_ylabel("mean gap to the best known cost [nats]")
    plotting.add_legend(legend, axes, _PER_LEGEND_LINE)
    figure.suptitle("Gap against time; bars: 95 % over scenes")
    return figure


def _bar(estimate: Estimate) -> list[list[float]] | None:
    if estimate.low is None or estimate.high is None:
        return None
    return [[max(0.0, estimate.value - estimate.low)], [max(0.0, estimate.high - estimate.value)]]


def _draw_front(axis: "Axes", found: list[Standing]) -> None:
    """A step through those that no other one beats in both."""
    points = sorted((s.time.value, s.gap.value) for s in found)
    time, gap = np.array(points).T
    front = [i for i in range(len(points)) if measures.dominator(gap, time, i) is None]
    axis.step(time[front], gap[front], where="post", color="#777777", linewidth=1.3,
              linestyle=":", label="best trade-off")


def _profiles(ranked: Ranked) -> "Figure":
    return _shares(ranked, curves.FINE_RATIOS, curves.profile, "Performance profiles (Dolan and "
                   "Moré)", "CPU time ÷ least CPU time of the window")


def _time_to_gap(ranked: Ranked) -> "Figure":
    return _shares(ranked, curves.FINE_TIMES_MS, lambda c: curves.time_to_gap(c, 0.0),
                   "Time to the best known cost", "CPU time [ms]")


def _shares(ranked: Ranked, at: tuple[float, ...], of: Callable[[Contest], np.ndarray], title: str,
            label: str) -> "Figure":
    """The shares that `of` gives at the points `at`, (points, algorithms)."""
    figure, axes, legend = _panels(ranked)
    moving = set()
    for axis, (contest, _) in zip(axes, ranked):
        shares = of(contest)
        _draw_shares(axis, contest, at, shares)
        moving |= set(np.flatnonzero((np.diff(shares, axis=0) != 0).any(axis=1)))
        axis.set_xlabel(label)
    if moving:  # nothing happens before and after
        axes[0].set_xlim(at[min(moving)], at[min(len(at) - 1, max(moving) + 2)])
    axes[0].set(ylabel="windows at the best known cost [%]", ylim=(0, 102))
    plotting.add_legend(legend, axes, _PER_LEGEND_LINE)
    figure.suptitle(title)
    return figure


def _draw_shares(axis: "Axes", contest: Contest, at: tuple[float, ...],
                 shares: np.ndarray) -> None:
    for i, algorithm in enumerate(contest.algorithms):
        axis.plot(at, 100 * shares[:, i], markevery=(i % _MARK_EVERY, _MARK_EVERY),
                  label=algorithm, **style_of(algorithm).line())
