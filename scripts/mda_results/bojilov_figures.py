"""Figure 2 of Bojilov (1995) from a run, and gaps to the optimum over the spread of the reports."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from mda_results import plotting
from mda_results.bojilov_tables import gap_percent
from mda_results.palette import style_of
from mda_results.render import Estimate
from mda_results.rows import RunError
from mda_results.three_sensors import (CALIBRATED, DETECTION_PROBABILITY, EXACT, FALSE_ALARMS,
                                       LOSSES, SIGMAS, UNTREATED, SensorRun, counted, target_exact)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# From left to right: the axis of the paper, where Q falls, and beyond it what the paper has not.
_AXIS = {"x": UNTREATED, **{f"{loss:g}": name for loss, name in LOSSES.items()}}
_BEYOND = {"worst ties": "bojilov-worst-ties", "calibrated": CALIBRATED, "greedy": "greedy",
           "exact": EXACT}
_BREAK = 0.7  # between the two, in places of the axis
# Of the five sigmas: dark is dense, and every step has another lightness.
_LOOKS = dict(zip(SIGMAS, (("#E69F00", "o"), ("#56B4E9", "s"), ("#009E73", "^"), ("#0072B2", "D"),
                           ("#000000", "v"))))
_ASIDE = 0.0035  # by how much sigma is moved apart from algorithm to algorithm
_SMALLEST_GAP = 0.01  # percent: below, axes are linear
_FAMILY = ("bojilov", "bojilov-worst-ties", UNTREATED, CALIBRATED)  # of its entries, in the gaps

Draw = Callable[[], "Figure"]


def figures(run: SensorRun) -> dict[str, Draw]:
    """How to draw each figure, by file name; drawing raises RunError if the run lacks its part."""
    drawn: dict[str, Draw] = {f"figure_2_f{level:g}": lambda f=level: _figure_2(run, f)
                              for level in FALSE_ALARMS}
    drawn["gap_by_sigma"] = lambda: _gap_by_sigma(run)
    return drawn


def _figure_2(run: SensorRun, level: float) -> "Figure":
    """Correct association over the loss axis, a curve per sigma, an axis per number of targets."""
    own = counted(run.rows[run.rows["false_alarms"] == level])
    own = own[own["algorithm"].isin(_AXIS.values())]
    if own.empty:
        raise RunError(f"{run.name} has no answers of bojilov with {level:g} false alarms per "
                       "target")
    panels = list(own.groupby(["targets", "layout"], sort=True))
    figure, axes, legend = plotting.with_legend_row(
        1, len(panels), (max(9.0, 7.2 * len(panels)), 6.2), 0.5, sharey=True)
    for axis, ((targets, layout), part) in zip(axes[0], panels):
        whole = run.rows[(run.rows["false_alarms"] == level) & (run.rows["targets"] == targets)
                         & (run.rows["layout"] == layout)]
        _draw_scene(axis, whole)
        place = "" if layout == "grid" else ", anywhere"
        axis.set_title(f"{targets} targets{place}; {_told_runs(part)} runs per point")
    axes[0][0].set(ylabel="correct association [%]", ylim=(0, 100))
    plotting.add_legend(legend, axes[0], len(SIGMAS))
    figure.suptitle(f"Figure 2: $P_D$ = {DETECTION_PROBABILITY:g}, {level:g} false alarms per "
                    "sensor and target; bands and bars: 95 % over runs")
    return figure


def _told_runs(part: pd.DataFrame) -> str:
    counts = part.groupby(["algorithm", "sigma"])["replicate"].nunique()
    return f"{counts.min():,}" if counts.min() == counts.max() else (
        f"{counts.min():,} to {counts.max():,}")


def _draw_scene(axis: "Axes", rows: pd.DataFrame) -> None:
    beyond = {label: name for label, name in _BEYOND.items() if (rows["algorithm"] == name).any()}
    first = len(_AXIS) - 1 + 1 + _BREAK
    for sigma, own in rows.groupby("sigma", sort=True):
        parts = dict(list(own.groupby("algorithm")))
        color, marker = _LOOKS[float(sigma)]
        look: dict[str, Any] = {"color": color, "marker": marker, "markersize": 5}
        _band(axis, _places(0.0, _AXIS, parts), label=f"σ = {sigma:g}", **look)
        plotting.draw_points(axis, _places(first, beyond, parts), linestyle="none", **look)
    places = [*np.arange(len(_AXIS)), *(first + np.arange(len(beyond)))]
    axis.set_xticks(places, [*_AXIS, *beyond])
    for tick in axis.get_xticklabels()[len(_AXIS):]:
        tick.set(rotation=25, ha="right")
    if beyond:
        axis.axvline(first - (1 + _BREAK) / 2, color="#777777", linewidth=0.8, linestyle=":")
    axis.set_xlabel("true pairs that Q loses [%]  (x: no treatment)", loc="left")


def _places(first: float, names: dict[str, str],
            parts: dict[Any, pd.DataFrame]) -> list[tuple[float, Estimate | None]]:
    """Correct association of the named algorithms, one place each from `first` on."""
    return [(first + n, target_exact(parts[name]) if name in parts else None)
            for n, name in enumerate(names.values())]


def _band(axis: "Axes", points: list[tuple[float, Estimate | None]], label: str,
          **look: Any) -> None:
    """A curve through estimates with the band of their intervals. The point without treatment
    stands apart from the curve: it is no value of Q."""
    plotting.draw_points(axis, points[:1], linestyle="none", **look)
    known = [(x, e) for x, e in points[1:] if e is not None]
    if not known:
        return
    places, found = [x for x, _ in known], [e for _, e in known]
    axis.fill_between(places, [e.value if e.low is None else e.low for e in found],
                      [e.value if e.high is None else e.high for e in found],
                      color=look["color"], alpha=0.2, linewidth=0)
    axis.plot(places, [e.value for e in found], linewidth=1.6, label=label, **look)


def _gap_by_sigma(run: SensorRun) -> "Figure":
    """Gap in percent of the optimum, a curve per algorithm, an axis per scene of a grid."""
    own = run.rows[run.rows["layout"] == "grid"]
    shown = own["algorithm"].isin(_FAMILY) | ~own["algorithm"].str.startswith("bojilov")
    own = own[shown & (own["algorithm"] != EXACT)]
    own = own[own["gap_nats"].notna()]
    if own.empty:
        raise RunError(f"{run.name} has no answers with a gap on a grid of targets")
    sizes, levels = (sorted(own[field].unique()) for field in ("targets", "false_alarms"))
    figure, axes, legend = plotting.with_legend_row(
        len(sizes), len(levels), (4.2 * len(levels), 3.6 * len(sizes) + 1.0), 0.9,
        sharex=True, sharey=True)
    for line, targets in zip(axes, sizes):
        for axis, level in zip(line, levels):
            part = own[(own["targets"] == targets) & (own["false_alarms"] == level)]
            _draw_gaps(axis, part)
            axis.set_title(f"{targets} targets, {level:g} false alarms per target", fontsize=9)
        line[0].set_ylabel("gap [% of the optimum]")
    for axis in axes[-1]:
        axis.set_xlabel("σ [mean distances of the targets]")
    axes[0][0].set_yscale("symlog", linthresh=_SMALLEST_GAP, linscale=0.4)
    plotting.add_legend(legend, axes.flat, 5)
    figure.suptitle("Cost above the optimum; bars: 95 % over runs")
    return figure


def _draw_gaps(axis: "Axes", rows: pd.DataFrame) -> None:
    parts = list(rows.groupby("algorithm", sort=True))
    for offset, (algorithm, own) in zip(_ASIDE * (np.arange(len(parts)) - len(parts) / 2), parts):
        points = [(float(s) + offset, gap_percent(at)) for s, at in own.groupby("sigma", sort=True)]
        plotting.draw_points(axis, points, label=str(algorithm), elinewidth=0.7,
                             **style_of(str(algorithm)).line())
