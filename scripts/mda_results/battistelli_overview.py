"""Open loop at a glance: gaps by window width, and gaps against CPU time."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd

from mda_results import cells, plotting
from mda_results.battistelli_open import mean_gap
from mda_results.known_targets import SCENARIOS, KnownRun, nominal
from mda_results.palette import style_of
from mda_results.plotting import draw_points
from mda_results.rows import RunError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SMALLEST_GAP = 1e-3  # nats: below, axes are linear
_ASIDE = 0.18  # by how much points of one K are moved apart
# They solve the flow of scf, to the same cost, with another algorithm.
_SAME_FLOW = ("scf-lp", "scf-networksimplex", "scf-capacityscaling", "scf-costscaling",
              "scf-assignment")


def figures(run: KnownRun) -> dict[str, Callable[[], "Figure"]]:
    """How to draw each figure, by file name; drawing raises RunError without rows."""
    return {"gap_by_k": lambda: _gap_by_k(run), "gap_against_cpu": lambda: _gap_against_cpu(run)}


def _by_scenario(run: KnownRun) -> dict[str, pd.DataFrame]:
    own = nominal(run.rows)
    own = own[cells.answered(own)].dropna(subset=["gap_nats"])
    if own.empty:
        raise RunError(f"{run.name} has no answered windows in open loop")
    return {s: own[own["scenario"] == s] for s in SCENARIOS if (own["scenario"] == s).any()}


def _grid(count: int) -> tuple["Figure", list["Axes"], "Axes"]:
    """A figure, an axis per scenario, and one for the legend."""
    columns = min(3, count + 1)
    rows = -(-(count + 1) // columns)
    figure = plotting.pyplot().figure(figsize=(4.6 * columns, 4.2 * rows), layout="constrained")
    flat = list(figure.subplots(rows, columns, squeeze=False, sharey=True).flat)
    for axis in flat[count:]:
        axis.axis("off")
    for axis in flat[:count:columns]:
        axis.set_ylabel("mean gap [nats]")
    return figure, flat[:count], flat[count]


def _gap_by_k(run: KnownRun) -> "Figure":
    present = _by_scenario(run)
    figure, axes, legend = _grid(len(present))
    for axis, (scenario, own) in zip(axes, present.items()):
        own = own[~own["algorithm"].isin(_SAME_FLOW)]
        offsets = np.linspace(-_ASIDE, _ASIDE, own["algorithm"].nunique())
        for offset, (algorithm, part) in zip(offsets, own.groupby("algorithm", sort=True)):
            points = [(k + offset, mean_gap(at)) for k, at in part.groupby("window_k", sort=True)]
            draw_points(axis, points, label=str(algorithm), elinewidth=0.7,
                        **style_of(str(algorithm)).line())
        axis.set(title=scenario, xlabel="scans in the window, K",
                 xticks=sorted(own["window_k"].unique()))
    _set_gap_axes(axes)
    plotting.add_legend(legend, axes, 2)
    figure.suptitle("Mean gap above the optimum; bars: 95 % over scenes")
    return figure


def _set_gap_axes(axes: list["Axes"]) -> None:
    """When all points are drawn: the axes share their limits."""
    for axis in axes:
        axis.set_yscale("symlog", linthresh=_SMALLEST_GAP, linscale=0.5)
    lowest = min(axis.dataLim.y0 for axis in axes)
    highest = max(axis.dataLim.y1 for axis in axes)
    axes[0].set_ylim(min(-0.2 * _SMALLEST_GAP, 2 * lowest), max(2 * highest, _SMALLEST_GAP))


def _gap_against_cpu(run: KnownRun) -> "Figure":
    """At the widest window that all scenarios have; a line joins what nothing beats in both."""
    present = _by_scenario(run)
    shared = set.intersection(*(set(own["window_k"]) for own in present.values()))
    if not shared:
        raise RunError(f"{run.name} has no K that all its scenarios have")
    k = max(shared)
    figure, axes, legend = _grid(len(present))
    for axis, (scenario, own) in zip(axes, present.items()):
        own = own[own["window_k"] == k]
        means = own.groupby("algorithm")[["cpu_ms", "gap_nats"]].mean()
        _front(axis, means)
        for algorithm, (ms, gap) in means.iterrows():
            axis.plot(ms, gap, markersize=7, linestyle="none", clip_on=False,
                      label=str(algorithm), **style_of(str(algorithm)).point())
        axis.set_xscale("log")
        axis.set(title=scenario, xlabel="mean CPU time of solving a window [ms]")
    _set_gap_axes(axes)
    plotting.add_legend(legend, axes, 2)
    figure.suptitle(f"Gap against CPU time, K = {k}")
    return figure


def _front(axis: "Axes", means: pd.DataFrame) -> None:
    """The points that no other one beats in both time and gap."""
    ordered = means.sort_values(["cpu_ms", "gap_nats"])
    best = np.minimum.accumulate(ordered["gap_nats"].to_numpy())
    front = ordered[np.r_[True, best[1:] < best[:-1]]]
    axis.step(front["cpu_ms"], front["gap_nats"], where="post", color="#777777", linewidth=1.3,
              linestyle=":", label="best trade-off")
