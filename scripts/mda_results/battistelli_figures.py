"""Figures 3 to 9 of Battistelli et al. (2008), from a run of ours."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from mda_results import bootstrap, plotting
from mda_results.battistelli_closed import WINDOW_K, compared, mean, of_figure_9
from mda_results.battistelli_tracking_claims import MANOEUVRES_S
from mda_results.known_targets import KnownRun, nominal_period_s
from mda_results.outings import true_paths_km
from mda_results.palette import FACTOR_COLORS, FACTOR_MARKERS, REFERENCES, style_of
from mda_results.rows import RunError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FIRST = ("battistelli-1", "battistelli-1-dense", "battistelli-1-wide")
_SECOND = ("battistelli-2", "battistelli-2-radial")
_MEETINGS_S = (160.0, 270.0)
_SMOOTHED_S = 18.0  # of L in scenario 2: one run has three plots a scan
_FAR = 5.0  # times the ideal's largest error
_ALGORITHM_ORDER = ("sd-exact", "mcf", "scf", "scf-tie", "gnn-by-scan", "viterbi-sequential")

Draw = Callable[[], "Figure"]


def figures(run: KnownRun) -> dict[str, Draw]:
    """How to draw each figure, by file name; drawing raises RunError if the run lacks its part."""
    drawn: dict[str, Draw] = {}
    for number, scenarios in ((3, _FIRST), (6, _SECOND)):
        drawn[f"figure_{number}"] = lambda s=scenarios: _trajectories(run, s)
    for first, scenarios in ((4, _FIRST), (7, _SECOND)):
        drawn[f"figure_{first}"] = lambda s=scenarios: _errors(run, s)
        drawn[f"figure_{first + 1}"] = lambda s=scenarios: _right(run, s)
    for algorithm in ("scf-tie", "mcf"):
        drawn[f"figure_9_{algorithm}"] = lambda a=algorithm: _resolutions(run, a)
    return dict(sorted(drawn.items()))


def _trajectories(run: KnownRun, scenarios: tuple[str, ...]) -> "Figure":
    """True paths; a circle where each begins, the radar at the origin."""
    paths = {s: true_paths_km(run.trajectories, s, run.name) for s in scenarios}
    present = {s: p for s, p in paths.items() if p is not None}
    if not present:
        raise RunError(f"{run.name} has no trajectories of {' or '.join(scenarios)} in a "
                       "trajectories.json")
    figure, axes, legend = plotting.with_legend_row(
        1, len(present), (4.2 * len(present) + 0.6, 6.4), 0.4)
    for axis, (scenario, targets) in zip(axes[0], present.items()):
        for n, path in enumerate(targets):
            color = _target_color(n, len(targets))
            axis.plot(path[:, 0], path[:, 1], color=color, linewidth=1.3)
            axis.plot(*path[0], "o", color=color, markersize=4,
                      label="first scan" if n == 0 else None)
            axis.annotate("", path[-1], path[-2],
                          arrowprops={"arrowstyle": "-|>", "color": color, "shrinkB": 0})
        axis.plot(0, 0, "k^", markersize=8, label="radar")
        axis.set(title=f"{scenario}: {len(targets)} targets", xlabel="x [km]", ylabel="y [km]")
        axis.set_aspect("equal", adjustable="datalim")
    plotting.add_legend(legend, axes[0], 2)
    return figure


def _target_color(n: int, count: int) -> str:
    """Of three targets one each; of two platoons one a platoon."""
    colors = ("#0072B2", "#D55E00", "#009E73")
    return colors[n % 3] if count <= 3 else colors[2 * n // count]


def _closed(run: KnownRun, scenarios: tuple[str, ...]) -> dict[str, pd.DataFrame]:
    own = compared(run.outings)
    present = {s: own[own["scenario"] == s] for s in scenarios if (own["scenario"] == s).any()}
    if not present:
        raise RunError(f"{run.name} has no finished outings of {' or '.join(scenarios)}")
    return present


def _errors(run: KnownRun, scenarios: tuple[str, ...]) -> "Figure":
    """d(t) of every algorithm, the ideal and the oracle; bands over runs."""
    present = _closed(run, scenarios)
    figure, axes, legend = _stacked(len(present))
    for axis, (scenario, own) in zip(axes, present.items()):
        one = own[own["algorithm"] == own["algorithm"].iloc[0]]
        for name, style in REFERENCES.items():
            _band(axis, one, f"{name}_series_m", scenario, name,
                  {"color": style.color, "linestyle": style.dash, "linewidth": 1.8})
        for algorithm, part in _ordered(own):
            _band(axis, part, "position_error_series_m", scenario, _label(algorithm, part),
                  _thin(algorithm))
        axis.set(title=scenario, ylabel="mean d(t) [m]")
        _set_error_axis(axis, float(np.concatenate(list(one["ideal_series_m"])).max()))
        _mark_times(axis, scenario)
    axes[-1].set_xlabel("time [s]")
    plotting.add_legend(legend, axes, 4)
    figure.suptitle(f"Mean position error, K = {WINDOW_K}; {_runs(present)}")
    return figure


def _set_error_axis(axis: "Axes", ideal_peak: float) -> None:
    """Logarithmic where tracks that are lost for good would flatten everything else."""
    if axis.dataLim.y1 > _FAR * ideal_peak:
        axis.set_yscale("log")
    else:
        axis.set_ylim(bottom=0)


def _right(run: KnownRun, scenarios: tuple[str, ...]) -> "Figure":
    """L(t) in percent; bands over runs."""
    present = _closed(run, scenarios)
    figure, axes, legend = _stacked(len(present))
    smoothing = _SMOOTHED_S if scenarios == _SECOND else 0.0
    told = f", mean over {smoothing:g} s" if smoothing else ""
    for axis, (scenario, own) in zip(axes, present.items()):
        for algorithm, part in _ordered(own):
            _band(axis, part, "right_series", scenario, _label(algorithm, part),
                  _thin(algorithm), 100.0, smoothing)
        axis.set(title=scenario, ylabel=f"L(t) [%]{told}")
        axis.set_ylim(top=100.5)
        _mark_times(axis, scenario)
    axes[-1].set_xlabel("time [s]")
    plotting.add_legend(legend, axes, 4)
    figure.suptitle(f"Right plots, K = {WINDOW_K}; {_runs(present)}")
    return figure


def _runs(present: dict[str, pd.DataFrame]) -> str:
    counts = {len(set(own["replicate"])) for own in present.values()}
    if counts == {1}:
        return "one run"
    return f"bands: 95 % over {' or '.join(map(str, sorted(counts)))} runs"


def _stacked(count: int) -> tuple["Figure", list["Axes"], "Axes"]:
    figure, axes, legend = plotting.with_legend_row(count, 1, (9.0, 3.2 * count + 1.0), 0.8,
                                                    sharex=True)
    return figure, list(axes[:, 0]), legend


def _ordered(own: pd.DataFrame) -> list[tuple[str, pd.DataFrame]]:
    """Per algorithm; those of the paper are drawn last, on top."""
    found = {str(a): part for a, part in own.groupby("algorithm")}
    first = [a for a in found if a not in _ALGORITHM_ORDER]
    return [(a, found[a]) for a in [*first, *reversed(_ALGORITHM_ORDER)] if a in found]


def _label(algorithm: str, part: pd.DataFrame) -> str:
    k = int(part["window_k"].iloc[0])
    return algorithm if k == WINDOW_K else f"{algorithm} (K = {k})"


def _thin(algorithm: str) -> dict[str, Any]:
    style = style_of(algorithm)
    return {"color": style.color, "linestyle": style.dash, "linewidth": 1.4}


def _band(axis: "Axes", part: pd.DataFrame, series: str, scenario: str, label: str,
          look: dict[str, Any], scale: float = 1.0, smoothed_s: float = 0.0) -> None:
    """A line over time, the mean over runs, in its 95 % band."""
    period = nominal_period_s(scenario)
    length = int(part["scans"].min())
    values = scale * np.array([s[:length] for s in part.sort_values("replicate")[series]])
    width = min(max(1, round(smoothed_s / period)), length)
    kernel = np.ones(width) / width
    values = np.array([np.convolve(line, kernel, "valid") for line in values])
    times = period * (1 + (width - 1) / 2 + np.arange(values.shape[1]))
    band = bootstrap.band(scenario, values)
    axis.fill_between(times, band.low, band.high, color=look["color"], alpha=0.15, linewidth=0)
    axis.plot(times, band.mean, label=label, **look)


def _mark_times(axis: "Axes", scenario: str) -> None:
    if not scenario.startswith("battistelli-2"):
        return
    axis.axvspan(*MANOEUVRES_S, color="#F0E442", alpha=0.25, linewidth=0, label="manoeuvres")
    for n, time in enumerate(_MEETINGS_S):
        axis.axvline(time, color="#777777", linewidth=0.8, linestyle="-.",
                     label="targets meet" if n == 0 else None)


def _resolutions(run: KnownRun, algorithm: str) -> "Figure":
    """(a) distance error, (b) lost tracks against the scan period, a curve per resolution."""
    own = of_figure_9(run.outings)
    own = own[own["algorithm"] == algorithm]
    if own.empty:
        raise RunError(f"{run.name} has no finished outings of {algorithm} for figure 9")
    panels = (("distance_error_m", 1.0, "(a) distance error DE [m]"),
              ("lost_ever", 100.0, "(b) tracks lost ever [%]"),
              ("lost_at_end", 100.0, "(b') tracks lost at the end [%]"))
    figure, axes, legend = plotting.with_legend_row(1, 3, (13.0, 4.2), 0.4)
    for axis, (field, scale, label) in zip(axes[0], panels):
        for n, (factor, part) in enumerate(own.groupby("resolution", sort=True)):
            points = [(float(t), mean(at, field, scale))
                      for t, at in part.groupby("scan_period_s", sort=True)]
            plotting.draw_points(axis, points, label=f"{factor:g} x (50 m, 1°)", linestyle="-",
                        color=FACTOR_COLORS[n % 4], marker=FACTOR_MARKERS[n % 4])
        axis.set(title=label, xlabel="scan period [s]")
        axis.set_ylim(bottom=0)
        axis.set_xlim(left=0)
    plotting.add_legend(legend, axes[0], 4)
    figure.suptitle(f"Figure 9 with {algorithm}, K = {WINDOW_K}; bars: 95 % over runs")
    return figure
